//! What each thing looks like: its size, and its shapes once it has a place.

use crate::compared::Change;
use crate::shape::{Drawing, Frame, Heading, Shape, Site, Thing};
use crate::wrap::width;

/// The room a thing takes around its middle, in squares.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Extent {
    pub(crate) left: i32,
    pub(crate) right: i32,
    /// From its first row to its last.
    pub(crate) height: i32,
}

/// A thing that can be placed.
pub(crate) enum Figure {
    Step(Step),
    Jump(String),
    /// What an `any` leaves.
    Any(Vec<String>),
    Transition {
        id: usize,
        name: String,
        lines: Vec<String>,
        change: Option<Change>,
    },
    Line,
}

pub(crate) struct Step {
    /// Itself, or the macro-step.
    pub(crate) of: Thing,
    pub(crate) name: String,
    pub(crate) frame: Frame,
    pub(crate) active: bool,
    pub(crate) linked: bool,
    /// The steps whose references lead here.
    pub(crate) from: Vec<String>,
    pub(crate) boxes: Vec<Box>,
    /// Between the step and its actions.
    pub(crate) pad: i32,
    pub(crate) change: Option<Change>,
}

/// An action or forcing order.
pub(crate) struct Box {
    /// Above the box: an assignation condition or an event.
    pub(crate) condition: String,
    /// A qualifier with its time, or the arrow of a stored action.
    pub(crate) qualifier: String,
    pub(crate) lines: Vec<String>,
    pub(crate) kind: Frame,
    /// Between the texts and the lines around them.
    pub(crate) pad: i32,
    pub(crate) change: Option<Change>,
}

impl Box {
    /// The qualifier's cell with the line after it.
    fn cell(&self) -> i32 {
        if self.qualifier.is_empty() { 0 } else { width(&self.qualifier) + 1 + 2 * self.pad }
    }

    /// From edge to edge.
    fn width(&self) -> i32 {
        let text = self.lines.iter().map(|line| width(line)).max().unwrap_or(0);
        self.cell() + text + 2 + 2 * self.pad
    }
}

impl Figure {
    pub(crate) fn extent(&self) -> Extent {
        match self {
            Figure::Step(step) => step.extent(),
            Figure::Jump(name) => {
                let text = width(name) + 2;
                Extent { left: text / 2 + 1, right: text - text / 2 + 1, height: 1 }
            }
            Figure::Any(lines) => {
                let text = lines.iter().map(|line| width(line)).max().unwrap_or(0);
                Extent { left: text / 2 + 1, right: text - text / 2 + 1, height: rows(lines) }
            }
            Figure::Transition { name, lines, .. } => {
                let left = if name.is_empty() { 2 } else { width(name) + 4 };
                let right = lines.iter().map(|line| width(line) + 4).max().unwrap_or(2);
                Extent { left, right, height: rows(lines).max(1) - 1 }
            }
            Figure::Line => Extent { left: 1, right: 1, height: 0 },
        }
    }

    /// How far below the top of its layer it stands, whose steps have their frames at `rise`: frames stand at one height, whatever
    /// is above them, and a line from what an `any` leaves begins where one from a step does.
    pub(crate) fn lowered(&self, rise: i32) -> i32 {
        match self {
            Figure::Step(step) => rise - step.top(),
            Figure::Any(lines) => (rise + 2 - rows(lines)).max(0),
            _ => 0,
        }
    }

    /// The row where a line from above ends and the one where a line down begins.
    pub(crate) fn ports(&self) -> (i32, i32) {
        match self {
            Figure::Step(step) => (step.top(), step.top() + 2),
            Figure::Any(lines) => (0, rows(lines)),
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
            Figure::Any(lines) => (y..).zip(lines).for_each(|(row, line)| to.centred((x, row), line)),
            Figure::Transition { id, name, lines, change } => {
                if let Some(change) = *change {
                    let Extent { left, right, height } = self.extent();
                    to.shapes.push(Shape::Changed { at: (x - left, y), size: (left + right, height + 1), change });
                }
                to.sites.push(Site { of: Thing::Transition(*id), at: (x - 2, y), size: (5, 1) });
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

/// How many lines a text has.
fn rows(lines: &[String]) -> i32 {
    i32::try_from(lines.len()).unwrap_or(0)
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
        to.sites.push(Site { of: self.of, at: (left, top), size: (self.width(), 3) });
        if let Some(change) = self.change {
            to.shapes.push(Shape::Changed { at: (left, top), size: (self.width(), 3), change });
        }
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
        if let Some(change) = self.change {
            // Between those above and below.
            to.shapes.push(Shape::Changed { at: (x + 1, y + 1), size: (size.0 - 2, size.1 - 2), change });
        }
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
