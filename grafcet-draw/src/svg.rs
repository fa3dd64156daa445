//! The drawing list as SVG.

use std::fmt::Write as _;

use grafcet_core::description::Description;

use crate::shape::{Drawing, Frame, Heading, Shape, Thing};
use crate::sorted::{List, sort};
use crate::wrap::width;

/// A square in pixels.
pub(crate) const SQUARE: (i32, i32) = (8, 16);
/// From the middle of a double line to each of its lines, in pixels.
const APART: i32 = 2;
/// From the middle of what crosses a double line to the ends of the latter, in pixels.
const GAP: i32 = 5;
/// Around the drawing.
pub(crate) const MARGIN: i32 = 4;

/// Where a picture is shown.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Style {
    /// By itself: dark on white.
    Paper,
    /// In a page, whose colour it takes and whose width it keeps to.
    Page,
}

/// One line, without a blank one in it, so that Markdown passes it on.
pub(crate) fn write(name: &str, drawing: &Drawing, style: Style) -> String {
    write_upon(name, drawing, style, "")
}

/// For a page that moves marks.
pub(crate) fn live(chart: &Description<'_>, drawing: &Drawing) -> String {
    let mut marks = String::new();
    for site in &drawing.sites {
        let (x, y) = middle(site.at);
        let (w, h) = ((site.size.0 - 1) * SQUARE.0, (site.size.1 - 1) * SQUARE.1);
        // Writing to a string cannot fail.
        let _ = match site.of {
            Thing::Transition(id) => {
                let (x, y, w) = (x - 2, y - 6, w + 4);
                write!(marks, "<rect data-transition=\"{id}\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"12\"/>")
            }
            of => {
                let steps = steps(chart, of);
                write!(marks, "<rect data-steps=\"{steps}\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"/>")
            }
        };
    }
    write_upon(chart.name, drawing, Style::Page, &format!("<g fill=\"none\">{marks}</g>"))
}

/// A step alone, or all of an expansion.
fn steps(chart: &Description<'_>, of: Thing) -> String {
    let within = |step: &grafcet_core::description::Step<'_>| {
        let mut at = step.expansion;
        while let Some(id) = at {
            if of == Thing::Macro(id) {
                return true;
            }
            at = chart.macros.get(id).and_then(|outer| outer.outer);
        }
        false
    };
    let all = chart.steps.iter().enumerate().filter(|(id, step)| of == Thing::Step(*id) || within(step));
    let all: Vec<String> = all.map(|(id, _)| id.to_string()).collect();
    all.join(" ")
}

pub(crate) fn write_upon(name: &str, drawing: &Drawing, style: Style, below: &str) -> String {
    let (wide, high) = (drawing.width * SQUARE.0 + 2 * MARGIN, drawing.height * SQUARE.1 + 2 * MARGIN);
    let size = match style {
        Style::Paper => format!("width=\"{wide}\" height=\"{high}\" style=\"color:#1f2328;background:#fff\""),
        // Not smaller than can be read: what is wider yet is scrolled.
        Style::Page => format!("style=\"width:{wide}px;max-width:max(100%,{}px);height:auto\"", wide * 3 / 5),
    };
    let mut layers = Layers { doubles: doubles(drawing), ..Layers::default() };
    layers.gaps = gaps(drawing, &layers.doubles);
    drawing.shapes.iter().for_each(|shape| layers.add(shape));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0} {0} {wide} {high}\" {size} role=\"img\" \
         aria-label=\"Chart {1}\">{below}{7}<g fill=\"none\" stroke=\"currentColor\"><path d=\"{2}\"/>{3}\
         <path d=\"{4}\" stroke-width=\"3\"/></g><g fill=\"currentColor\" font-family=\"monospace\" font-size=\"13\" \
         dominant-baseline=\"central\">{5}{6}</g></svg>",
        // Half a pixel more: lines run through the middles of pixels, and one that is drawn twice, as between two actions, is no wider.
        format_args!("-{MARGIN}.5"),
        escape(name),
        layers.lines,
        layers.frames,
        layers.bars,
        layers.marks,
        layers.texts,
        layers.changed,
    )
}

/// Shapes of one look each.
#[derive(Default)]
struct Layers {
    lines: String,
    frames: String,
    bars: String,
    marks: String,
    /// After all others.
    changed: String,
    texts: String,
    /// The row of each double line, and its ends.
    doubles: Vec<(i32, i32, i32)>,
    /// Where double lines are crossed, by row and place.
    gaps: Vec<(i32, i32)>,
}

fn doubles(drawing: &Drawing) -> Vec<(i32, i32, i32)> {
    let doubles = drawing.shapes.iter().filter_map(|shape| match shape {
        Shape::Line { from, to, double: true } => Some((from.1, from.0, to.0)),
        _ => None,
    });
    doubles.list()
}

/// Where something crosses a double line that has nothing to do with it.
fn gaps(drawing: &Drawing, doubles: &[(i32, i32, i32)]) -> Vec<(i32, i32)> {
    let mut gaps = Vec::new();
    for shape in &drawing.shapes {
        let Shape::Line { from: (x, top), to: (to, bottom), .. } = shape else { continue };
        let crossed = |(row, left, right): &&(i32, i32, i32)| top < row && row < bottom && left <= x && x <= right;
        gaps.extend(doubles.iter().filter(crossed).filter(|_| x == to).map(|(row, ..)| (*row, *x)));
    }
    sort(&mut gaps);
    gaps.dedup();
    gaps
}

/// The middle of a square.
pub(crate) fn middle(at: (i32, i32)) -> (i32, i32) {
    (at.0 * SQUARE.0 + SQUARE.0 / 2, at.1 * SQUARE.1 + SQUARE.1 / 2)
}

impl Layers {
    /// Writing to a string cannot fail.
    fn add(&mut self, shape: &Shape) {
        match shape {
            Shape::Line { from, to, double } => {
                let ((x1, y1), (x2, y2)) = (middle(*from), middle(*to));
                // What ends at a double line does not reach between its two lines.
                let [above, below] =
                    [*from, *to].map(|at| if from.0 == to.0 && self.is_double(at) { APART } else { 0 });
                if *double {
                    self.double(from.1, (from.0, to.0));
                } else {
                    self.line((x1, y1 + above), (x2, y2 - below));
                }
            }
            Shape::Bar { at } => {
                let (x, y) = middle(*at);
                let _ = write!(self.bars, "M{} {y}h28", x - 14);
                let _ = write!(self.lines, "M{x} {}v16", y - 8);
            }
            Shape::Frame { at, size, kind } => self.frame(middle(*at), *size, *kind),
            Shape::Arrow { at, to } => {
                let (x, y) = middle(*at);
                let (x, y, head) = match to {
                    Heading::Up => (x, y - 5, "l4 9h-8z"),
                    Heading::Down => (x, y + 5, "l4 -9h-8z"),
                    Heading::Left => (x - 7, y, "l9 4v-8z"),
                };
                let _ = write!(self.marks, "<path d=\"M{x} {y}{head}\"/>");
            }
            Shape::Dot { at } => self.circle(*at, "2.5"),
            Shape::Mark { at } => self.circle(*at, "3.5"),
            Shape::Changed { at, size, change } => {
                let (x, y, w, h) = (at.0 * SQUARE.0, at.1 * SQUARE.1, size.0 * SQUARE.0, size.1 * SQUARE.1);
                let look = change.look();
                let _ = write!(
                    self.changed,
                    "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" rx=\"3\" fill-opacity=\".15\" stroke-width=\"2\" {look}/>"
                );
            }
            Shape::Text { at, text, half } => {
                let (x, y) = (at.0 * SQUARE.0 + if *half { SQUARE.0 / 2 } else { 0 }, middle(*at).1);
                // The squares a text takes it also fills, whatever font the reader has.
                let fill = width(text) * SQUARE.0;
                let _ = write!(self.texts, "<text x=\"{x}\" y=\"{y}\" textLength=\"{fill}\">{}</text>", escape(text));
            }
        }
    }

    fn circle(&mut self, at: (i32, i32), radius: &str) {
        let (x, y) = middle(at);
        let _ = write!(self.marks, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>");
    }

    fn is_double(&self, (x, y): (i32, i32)) -> bool {
        self.doubles.iter().any(|(row, left, right)| y == *row && (*left..=*right).contains(&x))
    }

    fn line(&mut self, (x1, y1): (i32, i32), (x2, y2): (i32, i32)) {
        let _ = if y1 == y2 { write!(self.lines, "M{x1} {y1}H{x2}") } else { write!(self.lines, "M{x1} {y1}V{y2}") };
    }

    /// A double line with its gaps.
    fn double(&mut self, row: i32, (left, right): (i32, i32)) {
        let crossed = self.gaps.iter().filter(|(y, x)| *y == row && left <= *x && *x <= right).map(|(_, x)| *x);
        let mut starts = vec![middle((left, row)).0];
        let mut ends = Vec::new();
        for x in crossed {
            ends.push(middle((x, row)).0 - GAP);
            starts.push(middle((x, row)).0 + GAP);
        }
        ends.push(middle((right, row)).0);
        for (start, end) in starts.into_iter().zip(ends) {
            let y = middle((0, row)).1;
            if start < end {
                self.line((start, y - APART), (end, y - APART));
                self.line((start, y + APART), (end, y + APART));
            }
        }
    }

    fn frame(&mut self, (x, y): (i32, i32), size: (i32, i32), kind: Frame) {
        let (w, h) = ((size.0 - 1) * SQUARE.0, (size.1 - 1) * SQUARE.1);
        let (active, inner) = match kind {
            Frame::Step { initial, active, .. } | Frame::Macro { initial, active } => (active, initial),
            Frame::Force => (false, true),
            Frame::Action | Frame::Sheet => (false, false),
        };
        let look = match (kind, active) {
            (Frame::Sheet, _) => " stroke-opacity=\".35\" rx=\"4\"",
            (_, true) => " stroke-width=\"2\" fill=\"currentColor\" fill-opacity=\".15\"",
            _ => "",
        };
        let _ = write!(self.frames, "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"{look}/>");
        if inner {
            let _ =
                write!(self.frames, "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", x + 3, y + 3, w - 6, h - 6);
        }
        let (right, below) = (x + w, y + h);
        match kind {
            Frame::Macro { .. } => {
                let _ = write!(self.lines, "M{x} {}h{w}M{x} {}h{w}", y + 5, below - 5);
            }
            Frame::Step { enclosing: true, .. } => {
                let _ = write!(
                    self.lines,
                    "M{x} {}l7 -7M{} {y}l7 7M{right} {}l-7 7M{} {below}l-7 -7",
                    y + 7,
                    right - 7,
                    below - 7,
                    x + 7
                );
            }
            _ => {}
        }
    }
}

fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}
