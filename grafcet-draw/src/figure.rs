//! What each thing looks like: its size, and its shapes once it has a place.

use grafcet_core::description::{Action, Description, Dialect};

use crate::graph::{Item, Kind};
use crate::shape::{Drawing, Frame, Shape};
use crate::sheets::{Node, name};
use crate::wrap::{width, wrap};

/// Texts are broken at so many squares.
const TEXT: i32 = 34;
/// At most so many lines of a text are shown.
const LINES: usize = 5;

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
    boxes: Vec<Box>,
}

/// An action or forcing order.
struct Box {
    /// Above the box: an assignation condition or an event.
    condition: String,
    /// A qualifier with its time, or the arrow of a stored action.
    qualifier: String,
    lines: Vec<String>,
    kind: Frame,
}

impl Box {
    /// The qualifier's cell with the line behind it.
    fn cell(&self) -> i32 {
        if self.qualifier.is_empty() { 0 } else { width(&self.qualifier) + 3 }
    }

    /// From edge to edge.
    fn width(&self) -> i32 {
        let text = self.lines.iter().map(|line| width(line)).max().unwrap_or(0);
        self.cell() + text + 4
    }
}

impl Scene<'_> {
    /// What an item of a net looks like.
    pub(crate) fn figure(&self, item: &Item) -> Figure {
        match item.kind {
            Kind::Node(node) => Figure::Step(self.step(node)),
            Kind::Jump(node) => Figure::Jump(name(self.chart, node).to_owned()),
            Kind::Transition(id) => self.transition(id),
            Kind::Pass | Kind::Rise => Figure::Line,
        }
    }

    fn step(&self, node: Node) -> Step {
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
            let lines = wrap(force, TEXT, LINES);
            boxes.push(Box { condition: String::new(), qualifier: String::new(), lines, kind: Frame::Force });
        }
        Step { name, frame, active, linked: step.is_some_and(|step| step.linked), boxes }
    }

    /// Whether a net begins here.
    pub(crate) fn is_initial(&self, node: Node) -> bool {
        let initial = |id: usize| self.chart.steps.get(id).is_some_and(|step| step.initial);
        match node {
            Node::Step(id) => initial(id),
            Node::Macro(id) => self.chart.macros.get(id).is_some_and(|m| initial(m.entry)),
        }
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
        let mut text = action.text.to_owned();
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
        let lines = wrap(&text, TEXT, LINES);
        let condition = wrap(action.condition, TEXT, 1).concat();
        Box { condition, qualifier, lines, kind: Frame::Action }
    }

    fn transition(&self, id: usize) -> Figure {
        let Some(transition) = self.chart.transitions.get(id) else { return Figure::Line };
        let mut lines = wrap(transition.condition, TEXT, LINES);
        for clearing in transition.clearing {
            lines.extend(wrap(&format!("⇒ {clearing}"), TEXT, LINES));
        }
        Figure::Transition { name: short(transition.name), lines }
    }
}

/// A name on one line.
fn short(name: &str) -> String {
    wrap(name, TEXT, 1).concat()
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
                to.shapes.push(Shape::Arrow { at: (x, y), up: false });
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

    /// Room for the condition above the first action.
    fn top(&self) -> i32 {
        i32::from(self.boxes.first().is_some_and(|first| !first.condition.is_empty()))
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
        Extent {
            left: half + if self.linked { 2 } else { 0 },
            right: half + boxes.map_or(0, |width| width + 2),
            height: bottom.max(self.top() + 2),
        }
    }

    fn draw(&self, x: i32, y: i32, to: &mut Drawing) {
        let (left, top) = (x - self.width() / 2, y + self.top());
        to.shapes.push(Shape::Frame { at: (left, top), size: (self.width(), 3), kind: self.frame });
        to.centred((x, top + 1), &self.name);
        if self.active {
            to.shapes.push(Shape::Mark { at: (left + 1, top + 1) });
        }
        if self.linked {
            to.text((left - 2, top + 1), "*");
        }
        let start = left + self.width() + 1;
        if !self.boxes.is_empty() {
            to.line((start - 2, top + 1), (start, top + 1), false);
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
            to.line((x + 2, y - 1), (x + 2, y), false);
            to.text((x + 4, y - 1), &self.condition);
        }
        if !self.qualifier.is_empty() {
            to.text((x + 2, y + 1), &self.qualifier);
            to.line((x + self.cell(), y), (x + self.cell(), y + size.1 - 1), false);
        }
        for (row, line) in (y + 1..).zip(&self.lines) {
            to.text((x + self.cell() + 2, row), line);
        }
    }
}
