//! A drawing of SFC in PLCopen XML: from elements and lines to steps and transitions.

use std::collections::{BTreeMap, BTreeSet};

use roxmltree::Node;

use super::Wrong;
use super::codesys;
use super::drawn;
use super::source::{Block, Piece, Pou, Step, Transition, What};
use super::xml::{
    attribute, body_of, by_number, child, child_any, children, head, is, kind, line_of, missing, note, numbers,
    one_line, reference, words,
};

/// A drawing, by the numbers to which its lines lead.
pub(super) struct Chart<'d> {
    content: Node<'d, 'd>,
    by_id: BTreeMap<&'d str, Node<'d, 'd>>,
    /// What the lines from there lead to.
    out: BTreeMap<&'d str, Vec<Node<'d, 'd>>>,
    named: BTreeMap<String, Piece>,
}

impl<'d> Chart<'d> {
    pub(super) fn new(content: Node<'d, 'd>, named: BTreeMap<String, Piece>) -> Result<Self, Wrong> {
        let mut chart = Self { content, by_id: BTreeMap::new(), out: BTreeMap::new(), named };
        for element in content.children().filter(Node::is_element) {
            for id in numbers(element) {
                if chart.by_id.insert(id, element).is_some() {
                    let message = format!("two elements have the number {id}");
                    return Err(Wrong { at: head(element), message });
                }
            }
            for from in Self::sources(element) {
                chart.out.entry(from).or_default().push(element);
            }
        }
        Ok(chart)
    }

    /// The numbers to which the lines at the pins of an element lead.
    fn sources(element: Node<'d, 'd>) -> Vec<&'d str> {
        let pins = children(element, "connectionPointIn");
        pins.flat_map(|pin| children(pin, "connection")).filter_map(reference).collect()
    }

    pub(super) fn read(&self, pou: &mut Pou) -> Result<(), Wrong> {
        // As people read: from top to bottom.
        let mut elements: Vec<Node<'d, 'd>> = self.content.children().filter(Node::is_element).collect();
        elements.sort_by_key(|element| place(*element));
        for element in &elements {
            match &*kind(*element) {
                "step" => {
                    let step = codesys::step(
                        *element,
                        Step {
                            name: attribute(*element, "name")?,
                            at: head(*element),
                            initial: element.attribute("initialStep") == Some("true"),
                            note: note(*element),
                            within: None,
                            blocks: Vec::new(),
                        },
                        &mut pou.lost,
                    );
                    pou.steps.push(step);
                }
                "macroStep" => {
                    let name = element.attribute("name").unwrap_or_default();
                    pou.lost.push((head(*element), format!("the macro-step `{name}`: draw its steps in its place")));
                }
                "comment" => {
                    pou.notes.extend(words(*element).lines().map(one_line));
                }
                _ => {}
            }
        }
        for element in elements {
            match &*kind(element) {
                "transition" => {
                    let transition = self.transition(element)?;
                    let loose = match (transition.from.is_empty(), transition.to.is_empty()) {
                        (true, _) => "no step leads to it",
                        (_, true) => "it leads to no step",
                        _ => "",
                    };
                    if loose.is_empty() {
                        pou.transitions.push(transition);
                    } else {
                        pou.lost.push((head(element), format!("a transition, as {loose}")));
                    }
                }
                "actionBlock" | "actionBlocks" => self.blocks(element, pou)?,
                _ => {}
            }
        }
        Ok(())
    }

    fn transition(&self, element: Node<'d, 'd>) -> Result<Transition, Wrong> {
        let (mut from, mut to) = (Vec::new(), Vec::new());
        self.above(element, &mut BTreeSet::new(), &mut from)?;
        self.below(element, &mut BTreeSet::new(), &mut to)?;
        Ok(Transition {
            name: None,
            at: head(element),
            note: note(element),
            priority: self.priority(element),
            from,
            to,
            condition: self.condition(element),
        })
    }

    /// Its own one, or that of the branch at whose beginning it stands.
    fn priority(&self, element: Node<'d, 'd>) -> Option<u64> {
        let of_branch = || {
            Self::sources(element).into_iter().find_map(|id| {
                let is_branch = |pin: &Node<'_, '_>| pin.attribute("connectionPointOutId") == Some(id);
                children(*self.by_id.get(id)?, "ConnectionPointOut").find(is_branch)?.attribute("priority")
            })
        };
        element.attribute("priority").or_else(of_branch).and_then(|text| text.trim().parse().ok())
    }

    fn condition(&self, element: Node<'d, 'd>) -> Piece {
        let nothing = Piece { text: "TRUE".to_owned(), at: head(element), language: None };
        let Some(condition) = child(element, "condition") else { return nothing };
        let mut text = if let Some(inline) = child(condition, "inline").or_else(|| child(condition, "TextualPredicate"))
        {
            body_of(inline)
        } else if let Some(name) = child(condition, "reference").and_then(|node| node.attribute("name")) {
            let known = self.named.get(&name.to_lowercase()).cloned();
            known.unwrap_or_else(|| Piece { text: name.to_owned(), at: head(condition), language: None })
        } else {
            self.connected(condition)
        };
        if condition.attribute("negated") == Some("true") && text.language.is_none() {
            text.text = format!("NOT ({})", text.text.trim_end_matches(';'));
        }
        text
    }

    /// A condition that is drawn: in the same drawing, or in a network of the transition, which has numbers of its own.
    fn connected(&self, condition: Node<'d, 'd>) -> Piece {
        let predicate = child(condition, "GraphicalPredicate").unwrap_or(condition);
        let network = child(predicate, "GraphicalExpression");
        let own = network.map(|network| by_number(network.children().filter(Node::is_element)));
        let all = own.as_ref().unwrap_or(&self.by_id);
        let pins = children(predicate, "connectionPointIn").flat_map(|pin| children(pin, "connection"));
        let from: Vec<Node<'d, 'd>> = pins.filter_map(|line| all.get(reference(line)?).copied()).collect();
        let by_id = |id: &str| all.get(id).copied();
        let each: Option<Vec<String>> = from.iter().map(|one| drawn::condition(*one, &by_id)).collect();
        match each.filter(|each| !each.is_empty()) {
            Some(each) => Piece { text: each.join(" OR "), at: head(condition), language: None },
            None => {
                let lines: Vec<String> = upstream(all, from).into_iter().map(line_of).collect();
                Piece { text: lines.join("\n"), at: head(condition), language: Some("FBD or LD".to_owned()) }
            }
        }
    }

    /// The steps that a transition leaves.
    fn above(&self, element: Node<'d, 'd>, seen: &mut BTreeSet<&'d str>, steps: &mut Vec<String>) -> Result<(), Wrong> {
        // A line that leads back to itself is gone along once.
        for id in Self::sources(element).into_iter().filter(|id| seen.insert(id)).collect::<Vec<_>>() {
            let Some(source) = self.by_id.get(id).copied() else {
                let message = format!("it is connected with number {id}, which is not there");
                return Err(Wrong { at: head(element), message });
            };
            match &*kind(source) {
                "step" => steps.push(attribute(source, "name")?),
                "selectionDivergence" | "simultaneousConvergence" | "selectionConvergence" => {
                    self.above(source, seen, steps)?;
                }
                "continuation" => {
                    for connector in self.others(source, "connector") {
                        self.above(connector, seen, steps)?;
                    }
                }
                name => {
                    return Err(Wrong {
                        at: head(element),
                        message: format!("a transition leaves steps, and this leads to a `{name}`"),
                    });
                }
            }
        }
        Ok(())
    }

    /// A line ends at a connector and goes on at the continuations of its name.
    fn others(&self, element: Node<'d, 'd>, other: &str) -> Vec<Node<'d, 'd>> {
        let label = |node: Node<'d, 'd>| node.attribute("label").or_else(|| node.attribute("name"));
        let is_it = |node: &Node<'d, 'd>| kind(*node) == other && label(*node) == label(element);
        self.content.children().filter(|node| node.is_element() && is_it(node)).collect()
    }

    /// The steps that a transition enters.
    fn below(&self, element: Node<'d, 'd>, seen: &mut BTreeSet<usize>, steps: &mut Vec<String>) -> Result<(), Wrong> {
        let mut all: Vec<Node<'d, 'd>> =
            numbers(element).into_iter().flat_map(|id| self.out.get(id).into_iter().flatten().copied()).collect();
        all.sort_by_key(|node| place(*node).1);
        for target in all {
            // Whatever has a number, or a place in the file, is gone along once.
            if !seen.insert(target.range().start) {
                continue;
            }
            match &*kind(target) {
                "step" => steps.push(attribute(target, "name")?),
                "jumpStep" => steps.push(attribute(target, "targetName")?),
                "selectionConvergence" | "simultaneousDivergence" => self.below(target, seen, steps)?,
                "connector" => {
                    for continuation in self.others(target, "continuation") {
                        self.below(continuation, seen, steps)?;
                    }
                }
                "comment" | "actionBlock" | "actionBlocks" => {}
                name => {
                    return Err(Wrong {
                        at: head(target),
                        message: format!("a transition leads to steps, and this one to a `{name}`"),
                    });
                }
            }
        }
        Ok(())
    }

    fn blocks(&self, element: Node<'d, 'd>, pou: &mut Pou) -> Result<(), Wrong> {
        for id in Self::sources(element) {
            let step = self.by_id.get(id).and_then(|step| step.attribute("name"));
            let Some(step) = pou.steps.iter_mut().find(|other| Some(&*other.name) == step) else {
                return Err(Wrong { at: head(element), message: "these actions belong to no step".to_owned() });
            };
            for action in children(element, "action").chain(children(element, "ActionBlock")) {
                step.blocks.push(block(action)?);
            }
        }
        Ok(())
    }
}

fn block<'d>(action: Node<'d, 'd>) -> Result<Block, Wrong> {
    let named = child(action, "ReferenceName").or_else(|| child(action, "ComplexOperand")).map(words);
    let reference = child(action, "reference").and_then(|node| node.attribute("name")).map(str::to_owned);
    let what = match (reference.or(named), child(action, "inline")) {
        (Some(name), _) => What::Named(name),
        (None, Some(inline)) => What::Inline(body_of(inline)),
        (None, None) => return missing(action, "reference and no inline"),
    };
    let qualifier = child(action, "ActionQualifier").unwrap_or(action);
    Ok(Block {
        at: head(action),
        qualifier: qualifier.attribute("qualifier").unwrap_or("N").to_owned(),
        time: qualifier.attribute("duration").filter(|text| !text.is_empty()).map(str::to_owned),
        what,
    })
}

/// Elements with all that they are connected with.
fn upstream<'d>(by_id: &BTreeMap<&'d str, Node<'d, 'd>>, mut all: Vec<Node<'d, 'd>>) -> Vec<Node<'d, 'd>> {
    let mut index = 0;
    while let Some(node) = all.get(index).copied() {
        let connections = node.descendants().filter(|inner| is(inner, "connection"));
        for source in connections.filter_map(|inner| by_id.get(reference(inner)?).copied()) {
            if !all.contains(&source) {
                all.push(source);
            }
        }
        index += 1;
    }
    all
}

/// Down and to the right.
fn place(element: Node<'_, '_>) -> (i64, i64) {
    let number = |name: &str| {
        let position = child_any(element, "position").or_else(|| child_any(element, "RelPosition"));
        position.and_then(|node| node.attribute(name)).and_then(|text| text.parse::<f64>().ok()).unwrap_or_default()
    };
    #[allow(clippy::cast_possible_truncation, reason = "what is outside of a paper stands at its edge")]
    (number("y") as i64, number("x") as i64)
}
