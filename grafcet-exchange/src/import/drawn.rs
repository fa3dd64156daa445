//! Networks of FBD and LD that are nothing but a condition: contacts, AND, OR, XOR and NOT.

use roxmltree::Node;

use super::xml::{is, kind, reference};

/// No person draws a condition that is longer.
const LONGEST: usize = 2_000;
const DEEPEST: usize = 50;

/// What comes out of an element, as structured text; none where it is more than a condition. `by_id` finds elements by their numbers.
pub(super) fn condition<'d>(node: Node<'d, 'd>, by_id: &dyn Fn(&str) -> Option<Node<'d, 'd>>) -> Option<String> {
    out(node, by_id, 0)
}

fn out<'d>(node: Node<'d, 'd>, by_id: &dyn Fn(&str) -> Option<Node<'d, 'd>>, depth: usize) -> Option<String> {
    if depth > DEEPEST || node.attribute("edge").is_some_and(|edge| edge != "none") {
        return None;
    }
    let named =
        |name: &str| node.children().find(|child| is(child, name)).and_then(|child| child.text()).map(str::trim);
    let attribute = |name: &str| node.attribute(name).map(str::trim);
    let is_plain = |name: &str| node.attribute(name).is_none_or(|storage| storage == "none");
    let text = match &*kind(node) {
        "leftPowerRail" => return Some("TRUE".to_owned()),
        "inVariable" => negated(node, format!("({})", named("expression")?)),
        "dataSource" => format!("({})", attribute("identifier")?),
        "outVariable" | "dataSink" => negated(node, into(node, by_id, depth)?),
        "coil" if is_plain("storage") && is_plain("latch") => negated(node, into(node, by_id, depth)?),
        "contact" => {
            let own = negated(node, named("variable").or_else(|| attribute("operand"))?.to_owned());
            in_series(&into(node, by_id, depth)?, own)
        }
        "compareContact" => {
            let part = |name: &str| attribute(name);
            let own = format!("({} {} {})", part("operand1")?, part("compareOperator")?, part("operand2")?);
            in_series(&into(node, by_id, depth)?, own)
        }
        "block" if node.attribute("instanceName").is_none_or(str::is_empty) => block(node, by_id, depth)?,
        _ => return None,
    };
    (text.len() < LONGEST).then_some(text)
}

/// A contact lets through what comes into it.
fn in_series(before: &str, own: String) -> String {
    if before == "TRUE" { own } else { format!("({before} AND {own})") }
}

fn negated(node: Node<'_, '_>, text: String) -> String {
    if node.attribute("negated") == Some("true") { format!("NOT {text}") } else { text }
}

/// What comes into an element: one line or another.
fn into<'d>(node: Node<'d, 'd>, by_id: &dyn Fn(&str) -> Option<Node<'d, 'd>>, depth: usize) -> Option<String> {
    let pins = node.children().filter(|child| is(child, "connectionPointIn"));
    let lines = pins.flat_map(|pin| pin.children().filter(|child| is(child, "connection")));
    let all: Vec<String> = lines.map(|line| out(by_id(reference(line)?)?, by_id, depth + 1)).collect::<Option<_>>()?;
    match &all[..] {
        [] => None,
        [one] => Some(one.clone()),
        _ => Some(format!("({})", all.join(" OR "))),
    }
}

fn block<'d>(node: Node<'d, 'd>, by_id: &dyn Fn(&str) -> Option<Node<'d, 'd>>, depth: usize) -> Option<String> {
    let kind = node.attribute("typeName")?.to_uppercase();
    let inputs = node.children().find(|child| is(child, "inputVariables"))?;
    let all: Vec<String> = inputs
        .children()
        .filter(|child| is(child, "variable") || is(child, "InputVariable"))
        .map(|pin| into(pin, by_id, depth).map(|text| negated(pin, text)))
        .collect::<Option<_>>()?;
    let text = match (&*kind, &all[..]) {
        ("NOT", [one]) => format!("NOT {one}"),
        ("AND" | "OR" | "XOR", [_, _, ..]) => format!("({})", all.join(&format!(" {kind} "))),
        (kind, [one, other]) => format!("({one} {} {other})", compared(kind)?),
        _ => return None,
    };
    let outputs = node.children().find(|child| is(child, "outputVariables"));
    let is_pin = |child: &Node<'_, '_>| is(child, "variable") || is(child, "OutputVariable");
    let pin = outputs.and_then(|outputs| outputs.children().find(is_pin));
    Some(pin.map_or(text.clone(), |pin| negated(pin, text)))
}

/// The sign of a comparison.
fn compared(kind: &str) -> Option<&'static str> {
    Some(match kind {
        "GT" => ">",
        "GE" => ">=",
        "EQ" => "=",
        "LE" => "<=",
        "LT" => "<",
        "NE" => "<>",
        _ => return None,
    })
}
