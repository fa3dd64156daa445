//! XML of PLCopen: drawings of SFC.

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
    if !root.has_tag_name("project") && root.tag_name().name() != "project" {
        let message = "this is no PLCopen XML: its root is no `project`".to_owned();
        return Err(Wrong { at: root.range().start..root.range().start, message });
    }
    root.descendants().filter(|node| is(node, "pou")).map(pou).collect()
}

pub(super) fn is(node: &Node<'_, '_>, name: &str) -> bool {
    node.is_element() && node.tag_name().name() == name
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
    range.start..(range.start + 1 + node.tag_name().name().len()).min(range.end)
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
    if let Some(interface) = child(node, "interface") {
        pou.returns = child(interface, "returnType").map(type_of);
        variables(interface, &mut pou)?;
        pou.notes.extend(child(interface, "documentation").map(|node| words(node)));
    }
    let project = node.ancestors().find(|node| is(node, "project"));
    let comment =
        project.and_then(|project| child(project, "contentHeader")).and_then(|header| child(header, "Comment"));
    let Some(content) = child(node, "body").and_then(|body| body.first_element_child()) else { return Ok(pou) };
    if !is(&content, "SFC") {
        pou.body = words(content);
        return Ok(pou);
    }
    pou.notes.extend(comment.iter().flat_map(|node| words(*node).lines().map(str::to_owned).collect::<Vec<_>>()));
    for action in child(node, "actions").into_iter().flat_map(|actions| children(actions, "action")) {
        let body = child(action, "body").map_or_else(|| missing(action, "body"), |body| Ok(body_of(body)))?;
        pou.actions.push(Action { name: attribute(action, "name")?, note: note(action), body });
    }
    let conditions = child(node, "transitions").into_iter().flat_map(|all| children(all, "transition"));
    let mut named = BTreeMap::new();
    for condition in conditions {
        let name = attribute(condition, "name")?;
        let body = child(condition, "body").map_or_else(|| missing(condition, "body"), Ok)?;
        named.insert(name.to_lowercase(), named_condition(body, &name));
    }
    Chart::new(content, named)?.read(&mut pou)?;
    Ok(pou)
}

fn variables<'d>(interface: Node<'d, 'd>, pou: &mut Pou) -> Result<(), Wrong> {
    for list in interface.children().filter(Node::is_element) {
        let section = match list.tag_name().name() {
            "inputVars" => Section::Input,
            "outputVars" => Section::Output,
            "inOutVars" => Section::InOut,
            "externalVars" | "globalVars" => Section::External,
            "localVars" | "tempVars" => Section::Local,
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
                address: variable.attribute("address").filter(|text| !text.is_empty()).map(str::to_owned),
                note: note(variable),
            });
        }
    }
    Ok(())
}

/// `BOOL` of `<type><BOOL/></type>`, the name of a derived one.
fn type_of(node: Node<'_, '_>) -> String {
    let Some(inner) = node.first_element_child() else { return String::new() };
    match inner.tag_name().name() {
        "derived" => inner.attribute("name").unwrap_or_default().to_owned(),
        name => name.to_owned(),
    }
}

/// Structured text, or what else stands there, in one line for each element.
pub(super) fn body_of(node: Node<'_, '_>) -> Piece {
    let Some(content) = node.first_element_child() else { return Piece { at: head(node), ..Piece::default() } };
    let name = content.tag_name().name();
    if name == "ST" || name == "IL" {
        let language = (name == "IL").then(|| name.to_owned());
        return Piece { text: words(content), at: head(content), language };
    }
    let lines = content.children().filter(Node::is_element).map(line_of);
    Piece { text: lines.collect::<Vec<_>>().join("\n"), at: head(content), language: Some(name.to_owned()) }
}

/// The body of a transition that has a name; in a network what is written to that name.
fn named_condition<'d>(body: Node<'d, 'd>, name: &str) -> Piece {
    let by_id = |id: &str| body.descendants().find(|node| node.attribute("localId") == Some(id));
    let is_end = |node: &Node<'_, '_>| {
        let written =
            ["variable", "expression"].iter().find_map(|child| child_any(*node, child)).map(|child| words(child));
        (is(node, "coil") || is(node, "outVariable")) && written.is_some_and(|written| same(&written, name))
    };
    let end = body.descendants().find(is_end);
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
    let mut line = node.tag_name().name().to_owned();
    for name in ["localId", "typeName", "instanceName"] {
        line.extend(node.attribute(name).map(|value| format!(" {value}")));
    }
    let flags = ["negated", "storage", "edge"].map(|name| (name, node.attribute(name).unwrap_or("none")));
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
                node.attribute("refLocalId")?,
                node.attribute("formalParameter").map(|name| format!(".{name}")).unwrap_or_default()
            ))
        })
        .collect();
    if !from.is_empty() {
        line.extend([", from ", &from.join(" and ")]);
    }
    line
}
