//! The best cut of a piece that is larger than its page.

use super::held::held;
use super::piece::{Axis, Piece};
use crate::shape::Shape;

/// What it costs to break a line.
const BROKEN: i32 = 12;
/// And to break it after a step: one goes on from a transition to a step on another page.
const AFTER_STEP: i32 = 8;
/// What it costs to leave a page empty.
const EMPTY: i32 = 24;
/// No more than so many cuts, one in another: each makes what is left smaller, but connectors may make it wider.
const DEEPEST: usize = 64;

/// Cuts a piece into some that fit a page with so much room from left to right and from top to bottom, in reading order.
pub(super) fn split(piece: Piece, room: (i32, i32), number: &mut usize, to: &mut Vec<Piece>) {
    divided(piece, room, number, to, DEEPEST);
}

fn divided(piece: Piece, room: (i32, i32), number: &mut usize, to: &mut Vec<Piece>, deepest: usize) {
    let piece = piece.trimmed();
    match cut(&piece, room).filter(|_| deepest > 0) {
        None => to.push(piece),
        Some((axis, at)) => {
            let (first, second) = piece.cut(axis, at, number);
            divided(first, room, number, to, deepest - 1);
            divided(second, room, number, to, deepest - 1);
        }
    }
}

/// None where a piece fits, or where it cannot be cut.
fn cut(piece: &Piece, room: (i32, i32)) -> Option<(Axis, i32)> {
    let (tall, wide) = (piece.drawing.height > room.1, piece.drawing.width > room.0);
    let (rows, columns) = (|most| best(piece, Axis::Rows, most), |most| best(piece, Axis::Columns, most));
    match (tall, wide) {
        (false, false) => None,
        (true, false) => rows(Some(room.1)).or_else(|| columns(None)).or_else(|| rows(None)),
        (true, true) => {
            rows(Some(room.1)).or_else(|| columns(Some(room.0))).or_else(|| rows(None)).or_else(|| columns(None))
        }
        // What stands in the way of a cut from top to bottom is divided first.
        (false, true) => columns(Some(room.0)).or_else(|| rows(None)).or_else(|| columns(None)),
    }
}

/// The cheapest cut with at most so much in front of it; without a limit as near to the middle as can be.
fn best(piece: &Piece, axis: Axis, most: Option<i32>) -> Option<(Axis, i32)> {
    let (all, held) = (axis.size(&piece.drawing), held(piece, axis));
    let free = |at: &i32| held.iter().all(|(first, last)| at <= first || last < at);
    let cost = |at: i32| {
        let broken = i32::try_from(piece.broken(axis, at).count()).unwrap_or(i32::MAX / EMPTY);
        let edge = if broken > 0 { axis.edge() } else { 0 };
        // Both sides are smaller than the whole.
        let smaller = edge < at && at < all - edge;
        let full = at + edge;
        let empty = match most {
            Some(most) if full <= most => (most - full) * EMPTY / most,
            Some(_) => return None,
            None => (2 * at - all).abs() * EMPTY / all,
        };
        let lines = BROKEN.saturating_mul(broken) + AFTER_STEP * after_steps(piece, axis, at);
        smaller.then_some((empty.saturating_add(lines), at))
    };
    (1..all).filter(free).filter_map(cost).min().map(|(_, at)| (axis, at))
}

/// How many lines are broken that come down from a step and have not met their transition yet.
fn after_steps(piece: &Piece, axis: Axis, at: i32) -> i32 {
    if axis == Axis::Columns {
        return 0;
    }
    let bars = |x: i32, rows: std::ops::Range<i32>| {
        piece.drawing.shapes.iter().any(|shape| matches!(shape, Shape::Bar { at } if at.0 == x && rows.contains(&at.1)))
    };
    let before = piece.broken(axis, at).filter(|(from, to)| !bars(from.0, from.1..at) && bars(from.0, at..to.1 + 1));
    i32::try_from(before.count()).unwrap_or(0)
}
