//! What each thing looks like: its size, and its shapes once it has a place.

use std::collections::BTreeMap;

use grafcet_core::description::{Action, Description, Dialect};

use crate::graph::{Item, Kind};
use crate::shape::{Drawing, Frame, Heading, Shape};
use crate::sheets::{Node, name};
use crate::wrap::{width, wrap};

/// Names and words are cut at so many squares.
pub(crate) const NAME: i32 = 34;
/// And names of steps that lead to another at so many.
const FROM: i32 = 20;
/// And in so many lines.
pub(crate) const LINES: usize = 5;

/// The room a thing takes around its middle, in squares.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Extent {
    pub(crate) left: i32,
    pub(crate) right: i32,
    /// From its first row to its last.
    pub(crate) height: i32,
}

/// A chart, and which of its steps are active.
pub(crate) struct Scene<'a> {
    pub(crate) chart: &'a Description<'a>,
    pub(crate) active: Vec<bool>,
    pub(crate) density: Density,
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
pub(crate) type References = BTreeMap<Node, Vec<Origin>>;

/// From where a reference leads.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Origin {
    Node(Node),
    /// A transition without steps before it, by its number in the description.
    Source(usize),
}

/// A thing that can be placed.
pub(crate) enum Figure {
    Step(Step),
    Jump(String),
    Transition { name: String, lines: Vec<String> },
    Line,
}

pub(crate) struct Step {
    name: String,
    frame: Frame,
    active: bool,
    linked: bool,
    /// The steps whose references lead here.
    from: Vec<String>,
    boxes: Vec<Box>,
    /// Between the step and its actions.
    pad: i32,
}

/// An action or forcing order.
struct Box {
    /// Above the box: an assignation condition or an event.
    condition: String,
    /// A qualifier with its time, or the arrow of a stored action.
    qualifier: String,
    lines: Vec<String>,
    kind: Frame,
    /// Between the texts and the lines around them.
    pad: i32,
}

impl Box {
    /// The qualifier's cell with the line behind it.
    fn cell(&self) -> i32 {
        if self.qualifier.is_empty() { 0 } else { width(&self.qualifier) + 1 + 2 * self.pad }
    }

    /// From edge to edge.
    fn width(&self) -> i32 {
        let text = self.lines.iter().map(|line| width(line)).max().unwrap_or(0);
        self.cell() + text + 2 + 2 * self.pad
    }
}

impl Scene<'_> {
    /// What an item of a net looks like; `references` lead to its steps from elsewhere.
    pub(crate) fn figure(&self, item: &Item, references: &References) -> Figure {
        match item.kind {
            Kind::Node(node) => Figure::Step(self.step(node, references.get(&node).map_or(&[], |from| from))),
            Kind::Jump(node) => Figure::Jump(name(self.chart, node).to_owned()),
            Kind::Transition(id) => self.transition(id),
            Kind::Pass | Kind::Rise => Figure::Line,
        }
    }

    fn step(&self, node: Node, from: &[Origin]) -> Step {
        let name = short(name(self.chart, node));
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
        for action in step.map_or(&[][..], |step| step.actions) {
            boxes.push(self.action(action));
        }
        for force in step.map_or(&[][..], |step| step.forces) {
            boxes.push(self.boxed(String::new(), String::new(), force, Frame::Force));
        }
        let mut names: Vec<&str> = Vec::new();
        for name in from.iter().map(|origin| self.origin(*origin)) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let from = if names.is_empty() { Vec::new() } else { wrap(&names.join(", "), FROM, LINES) };
        Step { name, frame, active, linked: step.is_some_and(|step| step.linked), from, boxes, pad: self.density.pad }
    }

    /// Source transitions without a name are written as in the source.
    fn origin(&self, origin: Origin) -> &str {
        match origin {
            Origin::Node(node) => name(self.chart, node),
            Origin::Source(id) => self
                .chart
                .transitions
                .get(id)
                .map(|transition| transition.name)
                .filter(|name| !name.is_empty())
                .unwrap_or("()"),
        }
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

    /// Whether the branches behind a step have an order: in an SFC it is the order of the source (IEC 61131-3).
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
    fn action(&self, action: &Action<'_>) -> Box {
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
        self.boxed(short(action.condition), qualifier, &text, Frame::Action)
    }

    fn boxed(&self, condition: String, qualifier: String, text: &str, kind: Frame) -> Box {
        let lines = self.lines(text);
        Box { condition, qualifier, lines, kind, pad: self.density.pad }
    }

    fn lines(&self, text: &str) -> Vec<String> {
        wrap(text, self.density.text, self.density.lines)
    }

    fn transition(&self, id: usize) -> Figure {
        let Some(transition) = self.chart.transitions.get(id) else { return Figure::Line };
        let mut lines = self.lines(transition.condition);
        for clearing in transition.clearing {
            lines.extend(self.lines(&format!("⇒ {}", assigned(clearing))));
        }
        Figure::Transition { name: short(transition.name), lines }
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

/// A name on one line.
fn short(name: &str) -> String {
    wrap(name, NAME, 1).concat()
}

impl Figure {
    pub(crate) fn extent(&self) -> Extent {
        match self {
            Figure::Step(step) => step.extent(),
            Figure::Jump(name) => {
                let text = width(name) + 2;
                Extent { left: text / 2 + 1, right: text - text / 2 + 1, height: 1 }
            }
            Figure::Transition { name, lines } => {
                let left = if name.is_empty() { 2 } else { width(name) + 4 };
                let right = lines.iter().map(|line| width(line) + 4).max().unwrap_or(2);
                Extent { left, right, height: i32::try_from(lines.len()).unwrap_or(1).max(1) - 1 }
            }
            Figure::Line => Extent { left: 1, right: 1, height: 0 },
        }
    }

    pub(crate) fn is_step(&self) -> bool {
        matches!(self, Figure::Step(_))
    }

    /// The row where a line from above ends and the one where a line down begins.
    pub(crate) fn ports(&self) -> (i32, i32) {
        match self {
            Figure::Step(step) => (step.top(), step.top() + 2),
            Figure::Jump(_) | Figure::Transition { .. } | Figure::Line => (0, 0),
        }
    }

    /// Draws itself around `x` below `y`; lines end at the row `last` of the layer.
    pub(crate) fn draw(&self, x: i32, y: i32, last: i32, to: &mut Drawing) {
        match self {
            Figure::Step(step) => step.draw(x, y, to),
            Figure::Jump(name) => {
                to.shapes.push(Shape::Arrow { at: (x, y), to: Heading::Down });
                to.centred((x, y + 1), name);
            }
            Figure::Transition { name, lines } => {
                to.shapes.push(Shape::Bar { at: (x, y) });
                to.text((x - 3 - width(name), y), name);
                for (row, line) in (y..).zip(lines) {
                    to.text((x + 4, row), line);
                }
            }
            Figure::Line => to.line((x, y), (x, last), false),
        }
    }
}

impl Step {
    /// From edge to edge: odd, so that lines meet the middle.
    fn width(&self) -> i32 {
        (width(&self.name) + 4).max(5) | 1
    }

    /// Room for references, and for the condition above the first action.
    fn top(&self) -> i32 {
        self.references() + i32::from(self.boxes.first().is_some_and(|first| !first.condition.is_empty()))
    }

    fn references(&self) -> i32 {
        i32::try_from(self.from.len()).unwrap_or(0)
    }

    /// The first and last row of each box below the top of the figure.
    fn rows(&self) -> Vec<(i32, i32)> {
        let mut rows: Vec<(i32, i32)> = Vec::new();
        for each in &self.boxes {
            let height = i32::try_from(each.lines.len()).unwrap_or(1).max(1) + 1;
            let top = match rows.last() {
                None => self.top(),
                Some((_, bottom)) if each.condition.is_empty() => *bottom,
                Some((_, bottom)) => bottom + 2,
            };
            rows.push((top, top + height));
        }
        rows
    }

    fn extent(&self) -> Extent {
        let half = self.width() / 2;
        let boxes = self.boxes.iter().map(|each| each.width().max(width(&each.condition) + 5)).max();
        let bottom = self.rows().last().map_or(0, |(_, bottom)| *bottom);
        let from = self.from.iter().map(|line| width(line) + 4).max().unwrap_or(0);
        Extent {
            left: half + if self.linked { 2 } else { 0 },
            right: from.max(half + boxes.map_or(0, |width| width + 2 * self.pad)),
            height: bottom.max(self.top() + 2),
        }
    }

    fn draw(&self, x: i32, y: i32, to: &mut Drawing) {
        let (left, top) = (x - self.width() / 2, y + self.top());
        to.shapes.push(Shape::Frame { at: (left, top), size: (self.width(), 3), kind: self.frame });
        to.centred((x, top + 1), &self.name);
        if !self.from.is_empty() {
            to.line((x, y), (x + 2, y), false);
            to.shapes.push(Shape::Arrow { at: (x + 1, y), to: Heading::Left });
        }
        for (row, line) in (y..).zip(&self.from) {
            to.text((x + 4, row), line);
        }
        if self.active {
            to.shapes.push(Shape::Mark { at: (left + 1, top + 1) });
        }
        if self.linked {
            to.text((left - 2, top + 1), "*");
        }
        let start = left + self.width() + self.pad;
        if !self.boxes.is_empty() {
            to.line((start - 1 - self.pad, top + 1), (start, top + 1), false);
        }
        // Boxes in one column are equally wide where they touch.
        let wide = self.boxes.iter().map(Box::width).max().unwrap_or(0);
        let mut last = None;
        for (each, (first, bottom)) in self.boxes.iter().zip(self.rows()) {
            if let Some(last) = last.filter(|last| *last < first) {
                to.line((start, y + last), (start, y + first), false);
            }
            each.draw((start, y + first), (wide, bottom - first + 1), to);
            last = Some(bottom);
        }
    }
}

impl Box {
    fn draw(&self, (x, y): (i32, i32), size: (i32, i32), to: &mut Drawing) {
        to.shapes.push(Shape::Frame { at: (x, y), size, kind: self.kind });
        if !self.condition.is_empty() {
            let line = x + 1 + self.pad;
            to.line((line, y - 1), (line, y), false);
            to.text((line + 2, y - 1), &self.condition);
        }
        if !self.qualifier.is_empty() {
            to.text((x + 1 + self.pad, y + 1), &self.qualifier);
            to.line((x + self.cell(), y), (x + self.cell(), y + size.1 - 1), false);
        }
        for (row, line) in (y + 1..).zip(&self.lines) {
            to.text((x + self.cell() + 1 + self.pad, row), line);
        }
    }
}
