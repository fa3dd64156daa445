//! What stands on paper for each item of a net: the words of the description in boxes, cut to their measure.

use grafcet_core::description::{Action, Any, Description, Dialect};

use crate::compared::{Change, Difference, Part, signed};
use crate::figure::{Box, Figure, Step};
use crate::graph::{Item, Kind};
use crate::shape::{Frame, Thing};
use crate::sheets::{Node, name};
use crate::sorted::{List, Map};
use crate::wrap::wrap;

/// Names and words are cut at so many squares.
pub(crate) const NAME: i32 = 34;
/// And names of steps that lead to another at so many.
const FROM: i32 = 20;
/// And in so many lines.
pub(crate) const LINES: usize = 5;

/// A chart, and which of its steps are active.
pub(crate) struct Wording<'a> {
    pub(crate) chart: &'a Description<'a>,
    pub(crate) active: Vec<bool>,
    pub(crate) density: Density,
    /// What differs from another version of it.
    pub(crate) differences: &'a [Difference],
    /// What has more rows than this is folded.
    pub(crate) tall: i32,
}

/// How closely a net is drawn.
#[derive(Clone, Copy)]
pub(crate) struct Density {
    /// Texts are broken at so many squares, words at none.
    text: i32,
    /// Between a text and its box.
    pad: i32,
    /// At most so many lines of a text are shown.
    lines: usize,
}

impl Density {
    pub(crate) const ROOMY: Self = Self { text: NAME, pad: 1, lines: 5 };
    pub(crate) const DENSE: Self = Self { text: 8, pad: 0, lines: 8 };
}

/// From where references lead to a step.
pub(crate) type References = Map<Node, Vec<Origin>>;

/// From where a reference leads.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Origin {
    Node(Node),
    /// A transition without steps before it, by its number in the description.
    Source(usize),
}

impl Wording<'_> {
    /// What an item of a net looks like; `references` lead to its steps from elsewhere.
    pub(crate) fn figure(&self, item: &Item, references: &References) -> Figure {
        match item.kind {
            Kind::Node(node) => Figure::Step(self.step(node, references.get(node).map_or(&[], |from| from))),
            Kind::Jump(node) => Figure::Jump(name(self.chart, node).to_owned()),
            Kind::Transition(id) => self.transition(id),
            Kind::Any(id) => Figure::Any(self.lines(&self.any(id).map(any_text).unwrap_or_default())),
            Kind::Pass | Kind::Rise => Figure::Line,
        }
    }

    fn step(&self, node: Node, from: &[Origin]) -> Step {
        let change = match node {
            Node::Step(id) => self.changes(Part::Step(id)),
            Node::Macro(_) => Vec::new(),
        };
        let name = signed(vec![short(name(self.chart, node))], &change).concat();
        let active = self.is_active(node);
        let step = match node {
            Node::Step(id) => self.chart.steps.get(id),
            Node::Macro(_) => None,
        };
        let initial = self.is_initial(node);
        let enclosing = matches!(node, Node::Step(id) if self.chart.partials.iter().any(|p| p.enclosed_by == Some(id)));
        let frame = match node {
            Node::Step(_) => Frame::Step { initial, enclosing, active },
            Node::Macro(_) => Frame::Macro { initial, active },
        };
        let mut boxes = Vec::new();
        let changed = |number: usize| match node {
            Node::Step(id) => self.changes(Part::Action(id, number)),
            Node::Macro(_) => Vec::new(),
        };
        let (actions, forces) = step.map_or((&[][..], &[][..]), |step| (step.actions, step.forces));
        for (number, action) in actions.iter().enumerate() {
            boxes.push(self.action(action, &changed(number)));
        }
        if let Some(within) = step.map(|step| step.within).filter(|within| !within.is_empty()) {
            boxes.push(self.boxed(String::new(), "within".to_owned(), within, Frame::Action, &[]));
        }
        for (number, force) in (actions.len()..).zip(forces) {
            boxes.push(self.boxed(String::new(), String::new(), force, Frame::Force, &changed(number)));
        }
        let mut names: Vec<&str> = Vec::new();
        for name in from.iter().map(|origin| self.origin(*origin)) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let from = if names.is_empty() { Vec::new() } else { wrap(&names.join(", "), FROM, LINES) };
        let of = match node {
            Node::Step(id) => Thing::Step(id),
            Node::Macro(id) => Thing::Macro(id),
        };
        Step {
            of,
            name,
            frame,
            active,
            linked: step.is_some_and(|step| step.linked),
            from,
            boxes,
            pad: self.density.pad,
            change: change.first().copied(),
        }
    }

    /// Where a reference leads from. Source transitions and `any` without a name are written as in the source.
    fn origin(&self, origin: Origin) -> &str {
        match origin {
            Origin::Node(node) => name(self.chart, node),
            Origin::Source(id) => {
                let name = self.chart.transitions.get(id).map_or("", |transition| transition.name);
                match self.any(id) {
                    _ if !name.is_empty() => name,
                    Some(_) => "any",
                    None => "()",
                }
            }
        }
    }

    /// What a transition leaves that is written as `any`.
    pub(crate) fn any(&self, transition: usize) -> Option<&Any<'_>> {
        self.chart.transitions.get(transition)?.any.as_ref()
    }

    /// Whether a net begins here.
    pub(crate) fn is_initial(&self, node: Node) -> bool {
        let initial = |id: usize| self.chart.steps.get(id).is_some_and(|step| step.initial);
        match node {
            Node::Step(id) => initial(id),
            Node::Macro(id) => self.chart.macros.get(id).is_some_and(|m| initial(m.entry)),
        }
    }

    /// What begins a net comes first: initial steps, then those that are entered with what is around them.
    pub(crate) fn begins(&self, node: Node) -> u8 {
        let entered = match node {
            Node::Step(id) => self.chart.steps.get(id).is_some_and(|step| {
                let entry = step.expansion.and_then(|id| self.chart.macros.get(id)).is_some_and(|m| m.entry == id);
                step.linked || entry
            }),
            Node::Macro(_) => false,
        };
        if self.is_initial(node) { 0 } else { 2 - u8::from(entered) }
    }

    /// Whether the branches after a step have an order: in an SFC it is the order of the source (IEC 61131-3).
    pub(crate) fn ranks(&self) -> bool {
        self.chart.dialect == Dialect::Sfc
    }

    fn is_active(&self, node: Node) -> bool {
        match node {
            Node::Step(id) => self.active.get(id).copied().unwrap_or(false),
            Node::Macro(id) => {
                let steps = self.chart.steps.iter().zip(&self.active);
                let within = |expansion: Option<usize>| {
                    // As often as there are macro-steps: a description made by hand may go in circles.
                    let mut outer = expansion;
                    (0..self.chart.macros.len()).any(|_| {
                        let found = outer == Some(id);
                        outer = outer.and_then(|id| self.chart.macros.get(id)).and_then(|m| m.outer);
                        found
                    })
                };
                steps.into_iter().any(|(step, active)| *active && within(step.expansion))
            }
        }
    }

    /// In an SFC the qualifier stands before the action; in a GRAFCET a continuous action has none, and a stored one an
    /// arrow: up on activation, down on deactivation, aside on an event (IEC 60848, 4.8).
    fn action(&self, action: &Action<'_>, change: &[Change]) -> Box {
        let grafcet = self.chart.dialect == Dialect::Grafcet;
        let mut text = assigned(action.text);
        let qualifier = match action.qualifier {
            "N" if grafcet => "",
            "S" if grafcet => {
                text.push_str(" := 1");
                "↑"
            }
            "R" if grafcet => {
                text.push_str(" := 0");
                "↑"
            }
            "P1" if grafcet => "↑",
            "P0" if grafcet => "↓",
            "on" => "→",
            other => other,
        };
        let qualifier =
            if action.time.is_empty() { qualifier.to_owned() } else { format!("{qualifier} {}", action.time) };
        self.boxed(short(action.condition), qualifier, &text, Frame::Action, change)
    }

    fn boxed(&self, condition: String, qualifier: String, text: &str, kind: Frame, change: &[Change]) -> Box {
        let lines = signed(self.lines(text), change);
        let change = change.first().copied();
        Box { condition, qualifier, lines, kind, pad: self.density.pad, change }
    }

    fn lines(&self, text: &str) -> Vec<String> {
        wrap(text, self.density.text, self.density.lines)
    }

    fn transition(&self, id: usize) -> Figure {
        let Some(transition) = self.chart.transitions.get(id) else { return Figure::Line };
        let changes = self.changes(Part::Transition(id));
        let mut lines = signed(self.lines(transition.condition), &changes);
        for one in self.differences(Part::Transition(id)).filter(|one| !one.was.is_empty()) {
            lines.extend(signed(self.lines(&one.was), &[Change::Gone]));
        }
        for (number, clearing) in transition.clearing.iter().enumerate() {
            let changes = self.changes(Part::Clearing(id, number));
            lines.extend(signed(self.lines(&format!("⇒ {}", assigned(clearing))), &changes));
        }
        Figure::Transition { id, name: short(transition.name), lines, change: changes.first().copied() }
    }

    fn differences(&self, part: Part) -> impl Iterator<Item = &Difference> {
        self.differences.iter().filter(move |one| one.part == part)
    }

    fn changes(&self, part: Part) -> Vec<Change> {
        self.differences(part).map(|one| one.change).list()
    }

    /// Whether a transition is drawn that the chart no longer has.
    pub(crate) fn is_gone(&self, transition: usize) -> bool {
        self.differences(Part::Transition(transition)).any(|one| one.change == Change::Gone)
    }
}

/// An assignment as both standards write it: `grip := 0`, `count := count + 1`. Blocks of Rust stay what they are.
pub(crate) fn assigned(text: &str) -> String {
    let place = |place: &str| !place.contains(|c: char| !c.is_alphanumeric() && !"_.(), ".contains(c));
    match text.split_once(" = ") {
        Some((to, value)) if place(to) => {
            let value = match value {
                "true" => "1",
                "false" => "0",
                other => other,
            };
            format!("{to} := {value}")
        }
        _ => text.to_owned(),
    }
}

/// `any`, `any except A`, `any except (A, B)`: as it is written.
pub(crate) fn any_text(any: &Any<'_>) -> String {
    match any.except {
        [] => "any".to_owned(),
        [one] => format!("any except {one}"),
        several => format!("any except ({})", several.join(", ")),
    }
}

/// A name on one line.
fn short(name: &str) -> String {
    wrap(name, NAME, 1).concat()
}
