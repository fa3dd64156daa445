//! A drawing of SFC in PLCopen XML: from elements and lines to steps and transitions.

use std::collections::{BTreeMap, BTreeSet};

use roxmltree::Node;

use super::Wrong;
use super::codesys;
use super::drawn;
use super::source::{Block, Piece, Pou, Step, Transition, What};
use super::xml::{attribute, body_of, child, child_any, children, head, is, line_of, missing, note, one_line, words};

/// A drawing, by the numbers of its elements.
pub(super) struct Chart<'d> {
    content: Node<'d, 'd>,
    by_id: BTreeMap<String, Node<'d, 'd>>,
    /// By the number of an element, what its connections lead to.
    out: BTreeMap<String, Vec<Node<'d, 'd>>>,
    named: BTreeMap<String, Piece>,
}

impl<'d> Chart<'d> {
    pub(super) fn new(content: Node<'d, 'd>, named: BTreeMap<String, Piece>) -> Result<Self, Wrong> {
        let mut chart = Self { content, by_id: BTreeMap::new(), out: BTreeMap::new(), named };
        for element in content.children().filter(Node::is_element) {
            let Some(id) = element.attribute("localId") else { continue };
            if chart.by_id.insert(id.to_owned(), element).is_some() {
                let message = format!("two elements have the number {id}");
                return Err(Wrong { at: head(element), message });
            }
            for from in Self::sources(element) {
                chart.out.entry(from).or_default().push(element);
            }
        }
        Ok(chart)
    }

    /// The numbers of what is connected with the pins of an element.
    fn sources(element: Node<'d, 'd>) -> Vec<String> {
        let pins = children(element, "connectionPointIn");
        let connections = pins.flat_map(|pin| children(pin, "connection"));
        connections.filter_map(|node| node.attribute("refLocalId").map(str::to_owned)).collect()
    }

    pub(super) fn read(&self, pou: &mut Pou) -> Result<(), Wrong> {
        // As people read: from top to bottom.
        let mut elements: Vec<Node<'d, 'd>> = self.content.children().filter(Node::is_element).collect();
        elements.sort_by_key(|element| place(*element));
        for element in &elements {
            match element.tag_name().name() {
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
            match element.tag_name().name() {
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
                "actionBlock" => self.blocks(element, pou)?,
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
            priority: element.attribute("priority").and_then(|text| text.parse().ok()),
            from,
            to,
            condition: self.condition(element),
        })
    }

    fn condition(&self, element: Node<'d, 'd>) -> Piece {
        let nothing = Piece { text: "TRUE".to_owned(), at: head(element), language: None };
        let Some(condition) = child(element, "condition") else { return nothing };
        let mut text = if let Some(inline) = child(condition, "inline") {
            body_of(inline)
        } else if let Some(name) = child(condition, "reference").and_then(|node| node.attribute("name")) {
            let known = self.named.get(&name.to_lowercase()).cloned();
            known.unwrap_or_else(|| Piece { text: name.to_owned(), at: head(condition), language: None })
        } else {
            let pins = children(condition, "connectionPointIn").flat_map(|pin| children(pin, "connection"));
            let from: Vec<Node<'d, 'd>> =
                pins.filter_map(|node| self.by_id.get(node.attribute("refLocalId")?).copied()).collect();
            let by_id = |id: &str| self.by_id.get(id).copied();
            let each: Option<Vec<String>> = from.iter().map(|one| drawn::condition(*one, &by_id)).collect();
            match each.filter(|each| !each.is_empty()) {
                Some(each) => Piece { text: each.join(" OR "), at: head(condition), language: None },
                None => {
                    let lines: Vec<String> = self.upstream(from).into_iter().map(line_of).collect();
                    Piece { text: lines.join("\n"), at: head(condition), language: Some("FBD or LD".to_owned()) }
                }
            }
        };
        if condition.attribute("negated") == Some("true") && text.language.is_none() {
            text.text = format!("NOT ({})", text.text.trim_end_matches(';'));
        }
        text
    }

    /// Elements with all that they are connected with.
    fn upstream(&self, mut all: Vec<Node<'d, 'd>>) -> Vec<Node<'d, 'd>> {
        let mut index = 0;
        while let Some(node) = all.get(index).copied() {
            let connections = node.descendants().filter(|inner| is(inner, "connection"));
            let sources = connections.filter_map(|inner| self.by_id.get(inner.attribute("refLocalId")?).copied());
            for source in sources.collect::<Vec<_>>() {
                if !all.contains(&source) {
                    all.push(source);
                }
            }
            index += 1;
        }
        all
    }

    /// The steps that a transition leaves.
    fn above(&self, element: Node<'d, 'd>, seen: &mut BTreeSet<String>, steps: &mut Vec<String>) -> Result<(), Wrong> {
        // A line that leads back to itself is gone along once.
        for id in Self::sources(element).into_iter().filter(|id| seen.insert(id.clone())).collect::<Vec<_>>() {
            let Some(source) = self.by_id.get(&id).copied() else {
                let message = format!("it is connected with number {id}, which is not there");
                return Err(Wrong { at: head(element), message });
            };
            match source.tag_name().name() {
                "step" => steps.push(attribute(source, "name")?),
                "selectionDivergence" | "simultaneousConvergence" | "selectionConvergence" => {
                    self.above(source, seen, steps)?;
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

    /// The steps that a transition enters.
    fn below(&self, element: Node<'d, 'd>, seen: &mut BTreeSet<String>, steps: &mut Vec<String>) -> Result<(), Wrong> {
        let id = element.attribute("localId").unwrap_or_default();
        let mut all: Vec<Node<'d, 'd>> = self.out.get(id).cloned().unwrap_or_default();
        all.sort_by_key(|node| place(*node).1);
        for target in all {
            if !target.attribute("localId").is_some_and(|id| seen.insert(id.to_owned())) {
                continue;
            }
            match target.tag_name().name() {
                "step" => steps.push(attribute(target, "name")?),
                "jumpStep" => steps.push(attribute(target, "targetName")?),
                "selectionConvergence" | "simultaneousDivergence" => self.below(target, seen, steps)?,
                "comment" | "actionBlock" => {}
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
            let step = self.by_id.get(&id).and_then(|step| step.attribute("name"));
            let Some(step) = pou.steps.iter_mut().find(|other| Some(&*other.name) == step) else {
                return Err(Wrong { at: head(element), message: "these actions belong to no step".to_owned() });
            };
            for action in children(element, "action") {
                let reference = child(action, "reference").and_then(|node| node.attribute("name"));
                let what = match (reference, child(action, "inline")) {
                    (Some(name), _) => What::Named(name.to_owned()),
                    (None, Some(inline)) => What::Inline(body_of(inline)),
                    (None, None) => return missing(action, "reference and no inline"),
                };
                step.blocks.push(Block {
                    at: head(action),
                    qualifier: action.attribute("qualifier").unwrap_or("N").to_owned(),
                    time: action.attribute("duration").filter(|text| !text.is_empty()).map(str::to_owned),
                    what,
                });
            }
        }
        Ok(())
    }
}

/// Down and to the right.
fn place(element: Node<'_, '_>) -> (i64, i64) {
    let number = |name: &str| {
        let position = child_any(element, "position");
        position.and_then(|node| node.attribute(name)).and_then(|text| text.parse::<f64>().ok()).unwrap_or_default()
    };
    #[allow(clippy::cast_possible_truncation, reason = "what is outside of a paper stands at its edge")]
    (number("y") as i64, number("x") as i64)
}
