//! Draws charts of [`grafcet`](https://docs.rs/grafcet) in the notation of IEC 60848: as SVG, as plain text, or as the text
//! of a Mermaid diagram.
//!
//! A [`Description`] is laid out as a [`Drawing`], a list of lines, frames and texts on squared paper; the writers only say
//! how those look. The same description gives the same drawing on every machine. Through the crate `grafcet`, with its
//! feature `std`, this crate is `grafcet::draw`.

mod compared;
mod figure;
mod fold;
mod graph;
mod legend;
mod mermaid;
mod net;
mod order;
#[cfg(feature = "pages")]
pub mod pages;
mod place;
mod route;
mod search;
mod sequence;
mod shape;
mod sheets;
mod sorted;
mod svg;
mod text;
mod wording;
mod wrap;

use grafcet_core::ActiveSteps;
use grafcet_core::description::Description;

pub use compared::{Change, Difference, Part};
pub use mermaid::mermaid;
pub use shape::{Drawing, Frame, Heading, Shape, Site, Thing};
use sorted::List;
use wording::{Density, Wording};

/// A chart of more steps than this is not drawn step by step.
const MOST_STEPS: usize = 150;
/// Nor is one of more transitions.
const MOST_TRANSITIONS: usize = 600;

/// Drawings are filled up to about so many characters from left to right before the next one starts below.
const WIDTH: i32 = 110;

/// What is said of a net takes so many characters from left to right, or more where the net does.
const NARROW: i32 = 40;

/// Lays a chart out, with the steps marked that are active in `situation` (`&()` marks none).
///
/// Partial grafcets stand side by side, expansions of macro-steps and enclosures beside them, in the end what named
/// conditions stand for. Of a chart that [`is_large`] there is an overview: one box for each of these, with what it holds.
#[must_use]
pub fn layout(chart: &Description<'_>, situation: &(impl ActiveSteps + ?Sized)) -> Drawing {
    within(chart, situation, WIDTH)
}

/// Lays a chart out in so many characters from left to right, or more where a net does.
fn within(chart: &Description<'_>, situation: &(impl ActiveSteps + ?Sized), width: i32) -> Drawing {
    if is_large(chart) {
        return overview(&sheets::sheets(chart), legend::legend(chart), width);
    }
    shape::pack(blocks(chart, situation, width, fold::TALL, &[]), width, (2, 1))
}

/// What stands beside each other: the sheets, in so many characters from left to right, and what names stand for. Nets of more rows than `tall` are folded.
fn blocks(
    chart: &Description<'_>,
    situation: &(impl ActiveSteps + ?Sized),
    width: i32,
    tall: i32,
    differences: &[Difference],
) -> Vec<Drawing> {
    let sheets = sheets::sheets(chart);
    let active = (0..chart.steps.len()).map(|step| situation.is_active_at(step)).list();
    let wording = Wording { chart, active, density: Density::ROOMY, differences, tall };
    let drawn = sheets
        .iter()
        .map(|sheet| framed(&sheet.title, &sheet.doc, shape::pack(net::draw(&wording, sheet), width - 4, (3, 1))));
    drawn.chain(legend::legend(chart)).list()
}

/// Whether a chart is too large to be drawn step by step: it has more than 150 steps or 600 transitions.
#[must_use]
pub fn is_large(chart: &Description<'_>) -> bool {
    chart.steps.len() > MOST_STEPS || chart.transitions.len() > MOST_TRANSITIONS
}

/// A chart as SVG, with the steps marked that are active in `situation` (`&()` marks none).
///
/// The picture stands for itself: dark on white, its size in pixels. Text is text.
#[must_use]
pub fn svg(chart: &Description<'_>, situation: &(impl ActiveSteps + ?Sized)) -> String {
    svg::write(chart.name, &layout(chart, situation), svg::Style::Paper)
}

/// A chart as SVG for a web page: in the page's own colour, as wide as there is room, on one line.
#[must_use]
pub fn svg_inline(chart: &Description<'_>) -> String {
    svg::write(chart.name, &layout(chart, &()), svg::Style::Page)
}

/// A chart as SVG for a page that moves marks over it: as [`svg_inline`], and below the lines a rectangle for each step,
/// macro-step and transition that is not seen as long as nobody gives it a look. `data-steps` lists the steps by number, of a macro-step
/// all of its expansion; `data-transition` is the number of a transition.
#[must_use]
pub fn svg_live(chart: &Description<'_>) -> String {
    let drawing = layout(chart, &());
    svg::live(chart, &drawing)
}

/// A chart in characters, for a terminal, with the steps marked that are active in `situation` (`&()` marks none).
#[must_use]
pub fn text(chart: &Description<'_>, situation: &(impl ActiveSteps + ?Sized)) -> String {
    text::write(&layout(chart, situation))
}

/// As [`text()`], for a terminal of so many columns: what stands side by side elsewhere stands one below the other. A single
/// net is as wide as it is.
#[must_use]
pub fn text_within(chart: &Description<'_>, situation: &(impl ActiveSteps + ?Sized), columns: u16) -> String {
    text::write(&within(chart, situation, columns.into()))
}

/// A chart with the marks of what differs from another version of it, and a legend of the marks; `notes` stand below the legend. Parts that are gone
/// have to be in `chart` for that. It is drawn step by step, however large.
#[cfg(feature = "compared")]
#[must_use]
pub fn layout_compared(
    chart: &Description<'_>,
    differences: &[Difference],
    notes: &[String],
    columns: Option<u16>,
) -> Drawing {
    let width = columns.map_or(WIDTH, i32::from);
    let mut drawings = vec![compared::key(differences, notes, width)];
    drawings.extend(blocks(chart, &(), width, fold::TALL, differences));
    shape::pack(drawings, width, (2, 1))
}

/// The same as SVG.
#[cfg(feature = "compared")]
#[must_use]
pub fn svg_compared(chart: &Description<'_>, differences: &[Difference], notes: &[String]) -> String {
    svg::write(chart.name, &layout_compared(chart, differences, notes, None), svg::Style::Paper)
}

/// The same for a terminal, of so many columns where that is said.
#[cfg(feature = "compared")]
#[must_use]
pub fn text_compared(
    chart: &Description<'_>,
    differences: &[Difference],
    notes: &[String],
    columns: Option<u16>,
) -> String {
    text::write(&layout_compared(chart, differences, notes, columns))
}

/// A sheet with a name has a frame around it, with what it is for below the name.
fn framed(title: &str, doc: &str, inside: Drawing) -> Drawing {
    if title.is_empty() {
        return inside;
    }
    let mut sheet = Drawing::default();
    let about = wrap::wrap(doc, inside.width.max(NARROW), wording::LINES);
    let about = about.iter().filter(|line| !line.is_empty()).list();
    let texts = about.iter().map(|line| wrap::width(line)).max().unwrap_or(0).max(wrap::width(title));
    let width = inside.width.max(texts) + 4;
    let top = 3 + i32::try_from(about.len()).unwrap_or(0);
    let size = (width, inside.height + top + 2);
    sheet.shapes.push(Shape::Frame { at: (0, 0), size, kind: Frame::Sheet });
    sheet.text((2, 1), title);
    for (row, line) in (2..).zip(about) {
        sheet.text((2, row), line);
    }
    sheet.paste(inside, (2, top));
    (sheet.width, sheet.height) = size;
    sheet
}

/// One box for each sheet, so many that the overview stays one.
fn overview(sheets: &[sheets::Sheet], legend: Option<Drawing>, width: i32) -> Drawing {
    const MOST: usize = 60;
    let mut boxes: Vec<Drawing> = Vec::new();
    // One more takes no more room than the words that there is one more.
    let shown = if sheets.len() == MOST + 1 { sheets.len() } else { MOST };
    for sheet in sheets.iter().take(shown) {
        let title = if sheet.title.is_empty() { "chart" } else { &sheet.title };
        let mut inside = Drawing::default();
        let count = format!("{} steps, {} transitions", sheet.nodes.len(), sheet.links.len());
        (inside.width, inside.height) = (wrap::width(&count), 1);
        inside.text((0, 0), &count);
        boxes.push(framed(&wrap::wrap(title, NARROW, 1).concat(), &sheet.doc, inside));
    }
    if sheets.len() > shown {
        let mut more = Drawing::default();
        let text = format!("and {} more", sheets.len() - shown);
        (more.width, more.height) = (wrap::width(&text), 1);
        more.text((0, 0), &text);
        boxes.push(more);
    }
    boxes.extend(legend);
    shape::pack(boxes, width, (2, 1))
}
