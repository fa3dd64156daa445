//! Where no cut goes: what belongs together.

use super::piece::{Axis, Piece};
use crate::shape::{Drawing, Frame, Heading, Shape, Thing};
use crate::wrap::width;

/// From one row or column to another, between which nothing is cut.
type Span = (i32, i32);

/// What a cut across an axis would take apart.
pub(super) fn held(piece: &Piece, axis: Axis) -> Vec<Span> {
    let mut spans = match axis {
        Axis::Rows => rows(&piece.drawing),
        Axis::Columns => columns(&piece.drawing),
    };
    spans.extend(piece.ends.iter().map(|end| {
        let (from, to) = end.corners();
        (axis.of(from), axis.of(to))
    }));
    spans
}

fn rows(drawing: &Drawing) -> Vec<Span> {
    let mut spans = Vec::new();
    let boxes: Vec<_> = drawing.shapes.iter().filter_map(action).collect();
    for shape in &drawing.shapes {
        match shape {
            // A frame around a net, with its title.
            Shape::Frame { at: (_, y), size: (_, h), kind: Frame::Sheet } => {
                spans.extend([(*y, y + 3), (y + h - 2, y + h - 1)]);
            }
            Shape::Frame { at: (_, y), size: (_, h), .. } => spans.push((*y, y + h - 1)),
            Shape::Arrow { at: (_, y), to: Heading::Down } => spans.push((*y, y + 1)),
            // The names of the steps that lead here, above their step.
            Shape::Arrow { at: (x, y), to: Heading::Left } => {
                let step = |site: &&crate::Site| site.at.1 > *y && site.at.0 < *x && *x <= site.at.0 + site.size.0;
                let below = drawing.sites.iter().filter(step).map(|site| site.at.1).min();
                spans.extend(below.map(|below| (*y, below)));
            }
            // From an action to its condition, or to the action below.
            Shape::Line { from, to, .. } if from.0 == to.0 => {
                let touches = |&((left, top), (right, bottom)): &((i32, i32), (i32, i32))| {
                    left <= from.0 && from.0 < right && (to.1 == top || from.1 == bottom)
                };
                if boxes.iter().any(touches) {
                    spans.push((from.1, to.1));
                }
            }
            _ => {}
        }
    }
    // Lines of one text stand below each other.
    let mut texts: Vec<(i32, i32)> = drawing.shapes.iter().filter_map(text).collect();
    texts.sort_unstable();
    spans.extend(
        texts.windows(2).filter(|two| two[0].0 == two[1].0 && two[0].1 + 1 == two[1].1).map(|two| (two[0].1, two[1].1)),
    );
    spans
}

fn columns(drawing: &Drawing) -> Vec<Span> {
    let mut spans = Vec::new();
    for shape in &drawing.shapes {
        match shape {
            Shape::Frame { at: (x, _), size: (w, _), kind: Frame::Sheet } => {
                spans.extend([(*x, x + 1), (x + w - 2, x + w - 1)]);
            }
            Shape::Frame { at: (x, _), size: (w, _), .. } => spans.push((*x, x + w - 1)),
            // With the line that it belongs to beside it; the mark of a step that is active with its enclosure stands in front of its frame.
            Shape::Text { at: (x, _), text, .. } => {
                spans.push((x - 1, x + width(text) + i32::from(text == "*")));
            }
            // From the name to the condition.
            Shape::Bar { at: (x, _) } => spans.push((x - 3, x + 4)),
            Shape::Arrow { at: (x, _), to: Heading::Left } => spans.push((x - 1, x + 3)),
            // From a step to its actions.
            Shape::Line { from, to, .. } if from.1 == to.1 => {
                let is_step = |site: &&crate::Site| !matches!(site.of, Thing::Transition(_));
                let begins = |site: &crate::Site| (site.at.0 + site.size.0 - 1, site.at.1 + 1) == *from;
                if drawing.sites.iter().filter(is_step).any(begins) {
                    spans.push((from.0, to.0));
                }
            }
            _ => {}
        }
    }
    spans
}

/// The corners of an action or a forcing order.
fn action(shape: &Shape) -> Option<((i32, i32), (i32, i32))> {
    match shape {
        Shape::Frame { at: (x, y), size: (w, h), kind: Frame::Action | Frame::Force } => {
            Some(((*x, *y), (x + w - 1, y + h - 1)))
        }
        _ => None,
    }
}

fn text(shape: &Shape) -> Option<(i32, i32)> {
    match shape {
        Shape::Text { at, .. } => Some(*at),
        _ => None,
    }
}
