//! XML of PLCopen, TC6 and IEC 61131-10: drawings of SFC.
//!
//! The two have the same words for the same things. Those of IEC 61131-10 begin with a capital, what an object is stands in its `xsi:type`, and
//! lines lead to pins, not to objects.

use std::collections::BTreeMap;

use roxmltree::{Document, Node};

use super::Wrong;
use super::drawing::Chart;
use super::drawn;
use super::source::{Action, Piece, Pou, Section, Span, Variable, same};

/// Every program, function block and function of a file.
pub(super) fn pous(text: &str) -> Result<Vec<Pou>, Wrong> {
    let document = Document::parse(text).map_err(|error| {
        let at = error.pos();
        let line = text.split_inclusive('\n').take(at.row.saturating_sub(1) as usize).map(str::len).sum::<usize>();
        let rest = text.get(line..).unwrap_or_default();
        let column: usize = rest.chars().take(at.col.saturating_sub(1) as usize).map(char::len_utf8).sum();
        let start = (line + column).min(text.len());
        Wrong { at: start..start, message: format!("this is no XML: {error}") }
    })?;
    let root = document.root_element();
    // Tools that keep a file for each program have that as its root.
    let is_program = |node: &Node<'_, '_>| {
        node.is_element() && ["Program", "FunctionBlock", "Function"].contains(&node.tag_name().name())
    };
    if !is(&root, "project") && !is_program(&root) {
        let message = "this is no PLCopen XML: its root is no `project`".to_owned();
        return Err(Wrong { at: root.range().start..root.range().start, message });
    }
    root.descendants().filter(|node| is(node, "pou") || is_program(node)).map(pou).collect()
}

pub(super) fn is(node: &Node<'_, '_>, name: &str) -> bool {
    node.is_element() && same_word(node.tag_name().name(), name)
}

/// Whether both are one word, but for a capital at its beginning.
fn same_word(one: &str, other: &str) -> bool {
    let (mut one, mut other) = (one.chars(), other.chars());
    let first = |word: &mut std::str::Chars<'_>| word.next().map(|letter| letter.to_ascii_lowercase());
    first(&mut one) == first(&mut other) && one.as_str() == other.as_str()
}

/// What an object is, in the words of TC6.
pub(super) fn kind(node: Node<'_, '_>) -> String {
    let name = node.attribute((INSTANCE, "type")).map_or(node.tag_name().name(), after_colon);
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_ascii_lowercase().to_string() + letters.as_str())
}

const INSTANCE: &str = "http://www.w3.org/2001/XMLSchema-instance";

/// A name without the short word for its namespace.
fn after_colon(name: &str) -> &str {
    name.rsplit_once(':').map_or(name, |(_, name)| name)
}

/// The number to which a line leads.
pub(super) fn reference<'d>(connection: Node<'d, '_>) -> Option<&'d str> {
    connection.attribute("refLocalId").or_else(|| connection.attribute("refConnectionPointOutId"))
}

/// The numbers by which lines know an object: its own, or those of the pins that they leave. The pin of a step's actions comes last.
pub(super) fn numbers<'d>(object: Node<'d, 'd>) -> Vec<&'d str> {
    if let Some(id) = object.attribute("localId") {
        return vec![id];
    }
    let pins = |node: Node<'d, 'd>| {
        let out = children(node, "ConnectionPointOut").chain(children(node, "ConnectionPointOutAction"));
        out.filter_map(|pin| pin.attribute("connectionPointOutId"))
    };
    let inner = ["OutputVariables", "InOutVariables"].into_iter().flat_map(|list| children(object, list));
    let inner = inner.flat_map(|list| list.children().filter(Node::is_element)).flat_map(pins);
    pins(object).chain(inner).collect()
}

/// What is connected by which number.
pub(super) fn by_number<'d>(objects: impl Iterator<Item = Node<'d, 'd>>) -> BTreeMap<&'d str, Node<'d, 'd>> {
    objects.flat_map(|object| numbers(object).into_iter().map(move |number| (number, object))).collect()
}

pub(super) fn child<'d>(node: Node<'d, 'd>, name: &str) -> Option<Node<'d, 'd>> {
    node.children().find(|child| is(child, name))
}

pub(super) fn children<'d>(node: Node<'d, 'd>, name: &'static str) -> impl Iterator<Item = Node<'d, 'd>> {
    node.children().filter(move |child| is(child, name))
}

/// The words in an element, whatever formats them.
pub(super) fn words(node: Node<'_, '_>) -> String {
    let texts = node.descendants().filter(Node::is_text).filter_map(|node| node.text());
    texts.collect::<String>().trim().to_owned()
}

pub(super) fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The beginning of an element, up to the end of its first tag's name.
pub(super) fn head(node: Node<'_, '_>) -> Span {
    let range = node.range();
    let text = node.document().input_text().get(range.clone()).unwrap_or_default();
    let end = text.find(|letter: char| letter.is_whitespace() || ['/', '>'].contains(&letter)).unwrap_or(text.len());
    range.start..range.start + end
}

pub(super) fn note(node: Node<'_, '_>) -> String {
    child_any(node, "documentation").map(|node| one_line(&words(node))).unwrap_or_default()
}

pub(super) fn child_any<'d, 'i>(node: Node<'d, 'i>, name: &str) -> Option<Node<'d, 'i>> {
    node.children().find(|child| is(child, name))
}

pub(super) fn missing<T>(node: Node<'_, '_>, what: &str) -> Result<T, Wrong> {
    Err(Wrong { at: head(node), message: format!("`{}` has no {what}", node.tag_name().name()) })
}

pub(super) fn attribute(node: Node<'_, '_>, name: &str) -> Result<String, Wrong> {
    node.attribute(name).map_or_else(|| missing(node, name), |text| Ok(text.trim().to_owned()))
}

fn pou<'d>(node: Node<'d, 'd>) -> Result<Pou, Wrong> {
    let mut pou = Pou { name: attribute(node, "name")?, at: head(node), ..Pou::default() };
    let interface = child(node, "interface").unwrap_or(node);
    let returns = child(interface, "returnType").or_else(|| child(interface, "ResultType"));
    pou.returns = returns.map(type_of);
    for list in [child(interface, "Parameters"), Some(interface)].into_iter().flatten() {
        variables(list, &mut pou)?;
    }
    let documentation = child(interface, "documentation").map(words);
    pou.notes.extend(documentation.iter().flat_map(|text| text.lines()).map(str::to_owned));
    let project = node.ancestors().find(|node| is(node, "project"));
    let comment =
        project.and_then(|project| child(project, "contentHeader")).and_then(|header| child(header, "Comment"));
    let body = child(node, "body").and_then(|body| body.first_element_child());
    let body = body.or_else(|| child(node, "MainBody").and_then(|body| child(body, "BodyContent")));
    let Some(content) = body else { return Ok(pou) };
    if language(content) != "SFC" {
        pou.body = words(content);
        return Ok(pou);
    }
    pou.notes.extend(comment.iter().flat_map(|node| words(*node).lines().map(str::to_owned).collect::<Vec<_>>()));
    let inside = |list: &str| child(node, list).unwrap_or(node);
    for action in children(inside("actions"), "action") {
        let body = child(action, "body").map_or_else(|| missing(action, "body"), |body| Ok(body_of(body)))?;
        pou.actions.push(Action { name: attribute(action, "name")?, note: note(action), body });
    }
    let mut named = BTreeMap::new();
    for condition in children(inside("transitions"), "transition") {
        let name = attribute(condition, "name")?;
        let body = child(condition, "body").or_else(|| child(condition, "Condition"));
        let body = body.map_or_else(|| missing(condition, "body"), Ok)?;
        named.insert(name.to_lowercase(), named_condition(body, &name));
    }
    Chart::new(content, named)?.read(&mut pou)?;
    Ok(pou)
}

fn variables<'d>(interface: Node<'d, 'd>, pou: &mut Pou) -> Result<(), Wrong> {
    for list in interface.children().filter(Node::is_element) {
        let section = match list.tag_name().name() {
            "inputVars" | "InputVars" => Section::Input,
            "outputVars" | "OutputVars" => Section::Output,
            "inOutVars" | "InoutVars" => Section::InOut,
            "externalVars" | "globalVars" | "ExternalVars" | "GlobalVars" => Section::External,
            "localVars" | "tempVars" | "Vars" | "TempVars" => Section::Local,
            _ => continue,
        };
        for variable in children(list, "variable") {
            let value = child(variable, "initialValue");
            let init = value.map(|node| {
                let simple = child(node, "simpleValue").and_then(|node| node.attribute("value"));
                let text = simple.map_or_else(|| words(node), str::to_owned);
                Piece { text, at: head(node), language: None }
            });
            let ty = child(variable, "type").map_or_else(|| missing(variable, "type"), |ty| Ok(type_of(ty)))?;
            pou.variables.push(Variable {
                name: attribute(variable, "name")?,
                at: head(variable),
                section,
                constant: list.attribute("constant") == Some("true"),
                ty,
                init,
                address: address(variable),
                note: note(variable),
            });
        }
    }
    Ok(())
}

/// `%IX0.0`, which IEC 61131-10 writes in its parts.
fn address(variable: Node<'_, '_>) -> Option<String> {
    let part = |name: &str| child_any(variable, "Address").and_then(|node| node.attribute(name)).unwrap_or_default();
    let parts = [part("location"), part("size"), part("address")].concat();
    let whole = variable.attribute("address").filter(|text| !text.is_empty()).map(str::to_owned);
    whole.or_else(|| (!parts.is_empty()).then(|| format!("%{parts}")))
}

/// `BOOL` of `<type><BOOL/></type>` and of `<Type><TypeName>BOOL</TypeName></Type>`, the name of a derived one.
fn type_of(node: Node<'_, '_>) -> String {
    let Some(inner) = node.first_element_child() else { return String::new() };
    match inner.tag_name().name() {
        "derived" => inner.attribute("name").unwrap_or_default().to_owned(),
        "TypeName" => words(inner),
        "InstantlyDefinedType" => language(inner),
        name => name.to_owned(),
    }
}

/// `ST`, `FBD`, …
fn language(content: Node<'_, '_>) -> String {
    content.attribute((INSTANCE, "type")).map_or(content.tag_name().name(), after_colon).to_owned()
}

/// What a body or a predicate holds, in whatever language.
fn content_of<'d>(node: Node<'d, 'd>) -> Option<Node<'d, 'd>> {
    let inner = child(node, "BodyContent").or_else(|| child(node, "PredicateContent"));
    inner.or_else(|| node.first_element_child())
}

/// Structured text, or what else stands there, in one line for each element.
pub(super) fn body_of<'d>(node: Node<'d, 'd>) -> Piece {
    let Some(content) = content_of(node) else { return Piece { at: head(node), ..Piece::default() } };
    let name = language(content);
    if name == "ST" || name == "IL" {
        let language = (name == "IL").then_some(name);
        return Piece { text: words(content), at: head(content), language };
    }
    let lines = objects_of(content).map(line_of);
    Piece { text: lines.collect::<Vec<_>>().join("\n"), at: head(content), language: Some(name) }
}

/// What is drawn in a network, or in all of them.
fn objects_of<'d>(content: Node<'d, 'd>) -> impl Iterator<Item = Node<'d, 'd>> {
    let networks = content.children().filter(|node| is(node, "Network") || is(node, "Rung"));
    networks.chain([content]).flat_map(|network| network.children()).filter(Node::is_element)
}

/// The body of a transition that has a name; in a network what is written to that name.
fn named_condition<'d>(body: Node<'d, 'd>, name: &str) -> Piece {
    let objects = || content_of(body).into_iter().flat_map(objects_of);
    let by_number = by_number(objects());
    let by_id = |id: &str| by_number.get(id).copied();
    let is_end = |node: &Node<'_, '_>| {
        let written =
            ["variable", "expression"].iter().find_map(|child| child_any(*node, child)).map(|child| words(child));
        let written = written.as_deref().or_else(|| node.attribute("operand")).or_else(|| node.attribute("identifier"));
        ["coil", "outVariable", "dataSink"].contains(&&*kind(*node))
            && written.is_some_and(|written| same(written, name))
    };
    let end = objects().find(is_end);
    match end.and_then(|end| drawn::condition(end, &by_id)) {
        Some(text) => Piece { text, at: head(body), language: None },
        None => {
            let mut text = body_of(body);
            // In structured text it is assigned to the name.
            if text.language.is_none() {
                text.text = text.text.split_once(":=").map_or(text.text.clone(), |(_, value)| value.to_owned());
            }
            text
        }
    }
}

/// `contact 14: ORANGE_LIGHT, from 13`
pub(super) fn line_of(node: Node<'_, '_>) -> String {
    let mut line = kind(node);
    for name in
        ["localId", "typeName", "instanceName", "operand", "identifier", "operand1", "compareOperator", "operand2"]
    {
        line.extend(node.attribute(name).map(|value| format!(" {value}")));
    }
    let flags = ["negated", "storage", "latch", "edge"].map(|name| (name, node.attribute(name).unwrap_or("none")));
    for (name, value) in flags.into_iter().filter(|(_, value)| !["none", "false"].contains(value)) {
        line.extend([" ", name, "=", value]);
    }
    let named = node.descendants().filter(|node| is(node, "variable") || is(node, "expression") || is(node, "content"));
    let named: Vec<String> = named
        .filter_map(|node| node.text().or_else(|| node.children().find_map(|inner| inner.text())))
        .map(one_line)
        .filter(|text| !text.is_empty())
        .collect();
    if !named.is_empty() {
        line.extend([": ", &named.join(", ")]);
    }
    let from: Vec<String> = node
        .descendants()
        .filter(|node| is(node, "connection"))
        .filter_map(|node| {
            Some(format!(
                "{}{}",
                reference(node)?,
                node.attribute("formalParameter").map(|name| format!(".{name}")).unwrap_or_default()
            ))
        })
        .collect();
    if !from.is_empty() {
        line.extend([", from ", &from.join(" and ")]);
    }
    line
}
