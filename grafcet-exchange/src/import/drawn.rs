//! Networks of FBD and LD that are nothing but a condition: contacts, AND, OR, XOR and NOT.

use roxmltree::Node;

/// No person draws a condition that is longer.
const LONGEST: usize = 2_000;
const DEEPEST: usize = 50;

fn is(node: &Node<'_, '_>, name: &str) -> bool {
    node.is_element() && node.tag_name().name() == name
}

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
    let text = match node.tag_name().name() {
        "leftPowerRail" => return Some("TRUE".to_owned()),
        "inVariable" => negated(node, format!("({})", named("expression")?)),
        "outVariable" => negated(node, into(node, by_id, depth)?),
        "coil" if node.attribute("storage").is_none_or(|storage| storage == "none") => {
            negated(node, into(node, by_id, depth)?)
        }
        "contact" => {
            let own = negated(node, named("variable")?.to_owned());
            match &*into(node, by_id, depth)? {
                "TRUE" => own,
                before => format!("({before} AND {own})"),
            }
        }
        "block" if node.attribute("instanceName").is_none_or(str::is_empty) => block(node, by_id, depth)?,
        _ => return None,
    };
    (text.len() < LONGEST).then_some(text)
}

fn negated(node: Node<'_, '_>, text: String) -> String {
    if node.attribute("negated") == Some("true") { format!("NOT {text}") } else { text }
}

/// What comes into an element: one line or another.
fn into<'d>(node: Node<'d, 'd>, by_id: &dyn Fn(&str) -> Option<Node<'d, 'd>>, depth: usize) -> Option<String> {
    let pins = node.children().filter(|child| is(child, "connectionPointIn"));
    let lines = pins.flat_map(|pin| pin.children().filter(|child| is(child, "connection")));
    let all: Vec<String> =
        lines.map(|line| out(by_id(line.attribute("refLocalId")?)?, by_id, depth + 1)).collect::<Option<_>>()?;
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
        .filter(|child| is(child, "variable"))
        .map(|pin| into(pin, by_id, depth).map(|text| negated(pin, text)))
        .collect::<Option<_>>()?;
    let text = match (&*kind, &all[..]) {
        ("NOT", [one]) => format!("NOT {one}"),
        ("AND" | "OR" | "XOR", [_, _, ..]) => format!("({})", all.join(&format!(" {kind} "))),
        _ => return None,
    };
    let outputs = node.children().find(|child| is(child, "outputVariables"));
    let pin = outputs.and_then(|outputs| outputs.children().find(|child| is(child, "variable")));
    Some(pin.map_or(text.clone(), |pin| negated(pin, text)))
}
