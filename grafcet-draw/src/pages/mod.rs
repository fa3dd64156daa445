//! A chart on pages of paper.
//!
//! What is larger than a page is cut straight across where that breaks the fewest lines, and never through a step, an action or a text. A line that is
//! broken ends in a connector, and goes on at one of the same number; each says on which page the other is.
//!
//! - `piece`: what is cut, and the cut
//! - `held`: where no cut goes
//! - `cuts`: which cut is the best
//! - `picture`: what a page looks like

mod cuts;
mod held;
mod picture;
mod piece;
#[cfg(test)]
mod tests;

use grafcet_core::ActiveSteps;
use grafcet_core::description::Description;

use crate::shape::{Drawing, Heading, Shape, Thing};
use crate::wrap::width;
use piece::{End, Piece};

/// Between pieces on a page.
const GAP: (i32, i32) = (2, 1);

/// What stands on one page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Page {
    /// Its lines, frames and texts.
    pub drawing: Drawing,
    /// Where lines go on elsewhere.
    pub connectors: Vec<Connector>,
    /// References by name to steps that stand on other pages.
    pub references: Vec<Reference>,
}

/// Where a line ends that goes on at the connector of the same number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Connector {
    /// From 1. Two connectors of a chart have it.
    pub number: usize,
    /// Its square.
    pub at: (i32, i32),
    /// On which side of its piece of the chart it is.
    pub side: Side,
    /// The page of the other one, from 1.
    pub page: usize,
}

/// A side of a piece.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// A line comes from above.
    Top,
    /// A line goes on below.
    Bottom,
    /// A line goes on to the left.
    Left,
    /// A line goes on to the right.
    Right,
}

/// The arrow above a step's name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Reference {
    /// The square of the arrow.
    pub at: (i32, i32),
    /// The page where the step stands, from 1.
    pub page: usize,
}

/// Lays a chart out on pages with room for so many characters and lines, with the steps marked that are active in `situation` (`&()` marks none).
///
/// Every chart is drawn step by step, however large. A page on which something is larger than that, as a long text of a single transition, is wider or
/// taller than asked for.
#[must_use]
pub fn pages(chart: &Description<'_>, situation: &(impl ActiveSteps + ?Sized), room: (i32, i32)) -> Vec<Page> {
    let mut pieces = Vec::new();
    let mut number = 0;
    for block in crate::blocks(chart, situation, room.0, i32::MAX, &[]) {
        cuts::split(Piece::from(block), room, &mut number, &mut pieces);
    }
    let mut papers: Vec<Paper> = Vec::new();
    for piece in pieces {
        let placed = papers.last_mut().and_then(|paper| paper.place(&piece.drawing, room));
        if let (Some(at), Some(paper)) = (placed, papers.last_mut()) {
            paper.put(piece, at);
        } else {
            let mut paper = Paper::default();
            paper.take(&piece.drawing, (0, 0));
            paper.put(piece, (0, 0));
            papers.push(paper);
        }
    }
    connected(chart, &papers)
}

/// A page that is being filled.
#[derive(Default)]
struct Paper {
    all: Piece,
    /// What is taken, with the gap: from left to right, and down to where.
    taken: Vec<(i32, i32, i32)>,
}

impl Paper {
    /// As far up and then as far left as there is room.
    fn place(&mut self, drawing: &Drawing, room: (i32, i32)) -> Option<(i32, i32)> {
        let starts = self.taken.iter().map(|place| place.1).chain([0]).filter(|x| x + drawing.width <= room.0);
        let below = |x: i32| {
            let above = self.taken.iter().filter(|(left, right, _)| *left < x + drawing.width + GAP.0 && x < *right);
            above.map(|place| place.2).max().unwrap_or(0)
        };
        let (y, x) = starts.map(|x| (below(x), x)).min().filter(|(y, _)| y + drawing.height <= room.1)?;
        self.take(drawing, (x, y));
        Some((x, y))
    }

    fn take(&mut self, drawing: &Drawing, (x, y): (i32, i32)) {
        self.taken.push((x, x + drawing.width + GAP.0, y + drawing.height + GAP.1));
    }

    fn put(&mut self, piece: Piece, at: (i32, i32)) {
        self.all.paste(piece, at);
    }
}

/// Each connector learns the page of the other one, and each reference that of its step.
fn connected(chart: &Description<'_>, papers: &[Paper]) -> Vec<Page> {
    let ends: Vec<(usize, usize)> =
        (1..).zip(papers).flat_map(|(page, paper)| paper.all.ends.iter().map(move |end| (end.number, page))).collect();
    let connector = |here: usize, end: &End| {
        let mut both = ends.iter().filter(|(number, _)| *number == end.number).map(|(_, page)| *page);
        // The other one is on another page, or both are on this one.
        let page = both.find(|page| *page != here).unwrap_or(here);
        Connector { number: end.number, at: end.at, side: end.side, page }
    };
    let step = |name: &str| {
        let named = |of: Thing| match of {
            Thing::Step(id) => chart.steps.get(id).is_some_and(|step| step.name == name),
            Thing::Macro(id) => chart.macros.get(id).is_some_and(|step| step.name == name),
            Thing::Transition(_) => false,
        };
        let mut found = (1..)
            .zip(papers)
            .flat_map(|(page, paper)| paper.all.drawing.sites.iter().filter(|site| named(site.of)).map(move |_| page));
        // Of two steps of one name nobody can say which is meant.
        found.next().filter(|_| found.next().is_none())
    };
    let page = |(here, paper): (usize, &Paper)| {
        let texts = arrows(&paper.all.drawing);
        let references = texts.filter_map(|(at, name)| Some(Reference { at, page: step(name)? }));
        Page {
            references: references.filter(|reference| reference.page != here).collect(),
            connectors: paper.all.ends.iter().map(|end| connector(here, end)).collect(),
            drawing: paper.all.finished(),
        }
    };
    (1..).zip(papers).map(page).collect()
}

/// The arrows to steps elsewhere, and the names below them.
fn arrows(drawing: &Drawing) -> impl Iterator<Item = ((i32, i32), &str)> {
    drawing.shapes.iter().filter_map(|shape| {
        let Shape::Arrow { at: (x, y), to: Heading::Down } = shape else { return None };
        let below = drawing.shapes.iter().find_map(|shape| match shape {
            Shape::Text { at, text, .. } if at.1 == y + 1 && at.0 <= *x && *x <= at.0 + width(text) => Some(&**text),
            _ => None,
        });
        below.map(|name| ((*x, *y), name))
    })
}
