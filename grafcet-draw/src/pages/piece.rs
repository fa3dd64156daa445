//! A piece of a chart, and how it is cut in two.

use super::Side;
use crate::shape::{Drawing, Frame, Heading, Shape};
use crate::wrap::width;

/// Across which a cut goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Axis {
    /// What is above from what is below.
    Rows,
    /// What is left from what is right.
    Columns,
}

impl Axis {
    pub(super) fn of(self, (x, y): (i32, i32)) -> i32 {
        match self {
            Self::Rows => y,
            Self::Columns => x,
        }
    }

    fn with(self, (x, y): (i32, i32), place: i32) -> (i32, i32) {
        match self {
            Self::Rows => (x, place),
            Self::Columns => (place, y),
        }
    }

    pub(super) fn size(self, drawing: &Drawing) -> i32 {
        self.of((drawing.width, drawing.height))
    }

    /// How much room the end of a line, its connector and the page's number take beyond a cut.
    pub(super) fn edge(self) -> i32 {
        match self {
            Self::Rows => 3,
            Self::Columns => 6,
        }
    }

    /// The connectors on both sides of a cut.
    fn sides(self) -> (Side, Side) {
        match self {
            Self::Rows => (Side::Bottom, Side::Top),
            Self::Columns => (Side::Right, Side::Left),
        }
    }
}

/// The connector of a line that is broken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct End {
    pub(super) number: usize,
    pub(super) at: (i32, i32),
    pub(super) side: Side,
}

impl End {
    /// With the page's number beside it: the squares from corner to corner.
    pub(super) fn corners(&self) -> ((i32, i32), (i32, i32)) {
        let (x, y) = self.at;
        match self.side {
            Side::Top | Side::Bottom => ((x - 1, y - 1), (x + 1, y + 1)),
            Side::Left => ((x - 4, y), (x + 1, y)),
            Side::Right => ((x - 1, y), (x + 4, y)),
        }
    }
}

/// From one end to the other.
type Border = ((i32, i32), (i32, i32));

#[derive(Clone, Default, Debug)]
pub(super) struct Piece {
    pub(super) drawing: Drawing,
    /// What is left of frames around nets, which are cut without more ado.
    pub(super) borders: Vec<Border>,
    pub(super) ends: Vec<End>,
}

impl From<Drawing> for Piece {
    fn from(drawing: Drawing) -> Self {
        Self { drawing, ..Self::default() }
    }
}

impl Piece {
    /// The ends of each line that a cut in front of the row or column `at` breaks.
    pub(super) fn broken(&self, axis: Axis, at: i32) -> impl Iterator<Item = Border> {
        self.drawing.shapes.iter().filter_map(move |shape| match shape {
            Shape::Line { from, to, .. } if axis.of(*from) < at && at <= axis.of(*to) => Some((*from, *to)),
            _ => None,
        })
    }

    /// Cuts in front of the row or column `at`; connectors go on counting from `number`.
    pub(super) fn cut(self, axis: Axis, at: i32, number: &mut usize) -> (Self, Self) {
        let edge = if self.broken(axis, at).next().is_some() { axis.edge() } else { 0 };
        let (mut first, mut second) = (Self::default(), Self::default());
        // What is after the cut stands so much further back.
        let back = axis.with((0, 0), edge - at);
        let mut rest = Drawing::default();
        for shape in self.drawing.shapes {
            match shape {
                Shape::Line { from, to, double } if axis.of(from) < at && at <= axis.of(to) => {
                    *number += 1;
                    first.drawing.line(from, axis.with(to, at), double);
                    rest.line(axis.with(from, at - 1), to, double);
                    let (before, after) = axis.sides();
                    first.ends.push(End { number: *number, at: axis.with(from, at + 1), side: before });
                    second.ends.push(End { number: *number, at: axis.with(from, edge - 2), side: after });
                }
                Shape::Frame { at: corner, size, kind: Frame::Sheet }
                    if axis.of(corner) < at && at < axis.of(corner) + axis.of(size) =>
                {
                    for one in borders(corner, size) {
                        border(one, axis, at, edge, &mut first, &mut second);
                    }
                }
                shape if axis.of(start(&shape)) < at => first.drawing.shapes.push(shape),
                shape => rest.shapes.push(shape),
            }
        }
        for site in self.drawing.sites {
            if axis.of(site.at) < at { first.drawing.sites.push(site) } else { rest.sites.push(site) }
        }
        for one in self.borders {
            border(one, axis, at, edge, &mut first, &mut second);
        }
        for end in self.ends {
            if axis.of(end.at) < at {
                first.ends.push(end);
            } else {
                second.ends.push(End { at: axis.with(end.at, axis.of(end.at) + edge - at), ..end });
            }
        }
        second.drawing.paste(rest, back);
        (first, second)
    }

    /// As large as what stands on it, from the corner on.
    pub(super) fn trimmed(self) -> Self {
        let corners = || {
            let shapes = self.drawing.shapes.iter().map(corners);
            shapes.chain(self.borders.iter().copied()).chain(self.ends.iter().map(End::corners))
        };
        let least = |of: fn((i32, i32)) -> i32| corners().map(|(from, _)| of(from)).min().unwrap_or(0);
        let most = |of: fn((i32, i32)) -> i32| corners().map(|(_, to)| of(to)).max().unwrap_or(0);
        let (left, top) = (least(|at| at.0), least(|at| at.1));
        let size = (most(|at| at.0) + 1 - left, most(|at| at.1) + 1 - top);
        let mut piece = Self::default();
        piece.paste(self, (-left, -top));
        (piece.drawing.width, piece.drawing.height) = size;
        piece
    }

    pub(super) fn paste(&mut self, other: Self, (dx, dy): (i32, i32)) {
        let moved = |(x, y): (i32, i32)| (x + dx, y + dy);
        self.drawing.paste(other.drawing, (dx, dy));
        self.borders.extend(other.borders.into_iter().map(|(from, to)| (moved(from), moved(to))));
        self.ends.extend(other.ends.into_iter().map(|end| End { at: moved(end.at), ..end }));
    }

    /// With its borders as lines.
    pub(super) fn finished(&self) -> Drawing {
        let mut drawing = self.drawing.clone();
        self.borders.iter().for_each(|(from, to)| drawing.line(*from, *to, false));
        drawing
    }
}

fn start(shape: &Shape) -> (i32, i32) {
    corners(shape).0
}

/// The squares that a shape takes, from corner to corner.
fn corners(shape: &Shape) -> Border {
    match shape {
        Shape::Line { from, to, .. } => (*from, *to),
        Shape::Bar { at: (x, y) } => ((x - 2, *y), (x + 2, *y)),
        Shape::Frame { at: (x, y), size: (w, h), .. } | Shape::Changed { at: (x, y), size: (w, h), .. } => {
            ((*x, *y), (x + w - 1, y + h - 1))
        }
        Shape::Arrow { at: (x, y), to: Heading::Left } => ((x - 1, *y), (*x, *y)),
        Shape::Arrow { at, .. } | Shape::Dot { at } | Shape::Mark { at } => (*at, *at),
        Shape::Text { at: (x, y), text, half } => ((*x, *y), (x + width(text) - 1 + i32::from(*half), *y)),
    }
}

/// The four sides of a frame.
fn borders((x, y): (i32, i32), (w, h): (i32, i32)) -> [Border; 4] {
    let (right, below) = (x + w - 1, y + h - 1);
    [((x, y), (right, y)), ((x, below), (right, below)), ((x, y), (x, below)), ((right, y), (right, below))]
}

/// A border goes to one side of a cut, or to both, up to the end of the piece.
fn border((from, to): Border, axis: Axis, at: i32, edge: i32, first: &mut Piece, second: &mut Piece) {
    let moved = |point: (i32, i32)| axis.with(point, axis.of(point) + edge - at);
    if axis.of(to) < at {
        first.borders.push((from, to));
    } else if axis.of(from) >= at {
        second.borders.push((moved(from), moved(to)));
    } else {
        first.borders.push((from, axis.with(to, at - 1 + edge)));
        second.borders.push((axis.with(from, 0), moved(to)));
    }
}
