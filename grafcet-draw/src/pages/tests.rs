//! Cuts of drawings made by hand.

use super::cuts::split;
use super::piece::{Axis, Piece};
use super::{Paper, Side};
use crate::shape::{Drawing, Frame, Shape, Site, Thing};

/// A step of five squares around `x`, with its frame from row `y` on.
fn step(id: usize, (x, y): (i32, i32), to: &mut Drawing) {
    let kind = Frame::Step { initial: false, enclosing: false, active: false };
    to.shapes.push(Shape::Frame { at: (x - 2, y), size: (5, 3), kind });
    to.sites.push(Site { of: Thing::Step(id), at: (x - 2, y), size: (5, 3) });
    to.centred((x, y + 1), "S");
}

/// So many steps below each other, from one to the next nine rows: the frame in the rows 0 to 2, the bar in row 5, and a line all the way.
fn sequence(steps: usize) -> Drawing {
    let mut drawing = Drawing::default();
    for (id, y) in (0..steps).zip((0..).step_by(9)) {
        step(id, (10, y), &mut drawing);
        if id + 1 < steps {
            drawing.line((10, y + 2), (10, y + 9), false);
            drawing.shapes.push(Shape::Bar { at: (10, y + 5) });
            drawing.text((14, y + 5), "ready");
            drawing.text((14, y + 6), "&& go");
        }
    }
    drawing
}

fn pieces(drawing: Drawing, room: (i32, i32)) -> Vec<Piece> {
    let (mut number, mut pieces) = (0, Vec::new());
    split(drawing.into(), room, &mut number, &mut pieces);
    pieces
}

#[test]
fn what_fits_stays_whole() {
    // From the frame's left edge, 8, to the end of the text, 18: 11 squares; three steps with two ways between them: 21 rows.
    let whole = pieces(sequence(3), (11, 21));
    assert_eq!(whole.len(), 1);
    assert_eq!((whole[0].drawing.width, whole[0].drawing.height), (11, 21));
    assert!(whole[0].ends.is_empty());
    assert_eq!(pieces(sequence(3), (11, 20)).len(), 2);
}

#[test]
fn a_sequence_goes_on_from_a_transition_to_a_step_on_the_next_piece() {
    let pieces = pieces(sequence(3), (30, 20));
    let [first, second] = &pieces[..] else { panic!("{pieces:?}") };
    // In front of the frame of the third step, row 18, three rows would be too many after 17; two steps and the text of the second transition are
    // 16 rows, and three for the connector: it is cut after row 16.
    assert_eq!(first.drawing.height, 20);
    assert_eq!((first.drawing.sites.len(), second.drawing.sites.len()), (2, 1));
    let ([below], [above]) = (&first.ends[..], &second.ends[..]) else { panic!("{pieces:?}") };
    assert_eq!((below.number, below.side, above.number, above.side), (1, Side::Bottom, 1, Side::Top));
    // The bar and its text are still above: two texts of each transition and one of each step.
    assert_eq!(texts(&first.drawing), 6);
    assert_eq!(texts(&second.drawing), 1);
    // A line of one piece ends in front of the connector, that of the other one begins after it.
    let line = |piece: &Piece, at: (i32, i32)| {
        piece
            .drawing
            .shapes
            .iter()
            .any(|shape| matches!(shape, Shape::Line { from, to, .. } if *from == at || *to == at))
    };
    assert!(line(first, (below.at.0, below.at.1 - 1)) && line(second, (above.at.0, above.at.1 + 1)));
}

#[test]
fn a_page_is_rather_left_empty_than_cut_after_a_step() {
    // With three rows for the connector there is room for 13: for the second step, whose frame ends in row 11, but not for its transition.
    let pieces = pieces(sequence(3), (30, 16));
    assert_eq!((pieces[0].drawing.sites.len(), texts(&pieces[0].drawing)), (1, 3));
}

fn texts(drawing: &Drawing) -> usize {
    drawing.shapes.iter().filter(|shape| matches!(shape, Shape::Text { .. })).count()
}

#[test]
fn no_cut_goes_through_a_text_of_two_lines() {
    // Row 6 is the second line of the text: a cut in front of it is not made, whatever it costs.
    let held = super::held::held(&sequence(2).into(), Axis::Rows);
    assert!(held.iter().any(|(first, last)| *first < 6 && 6 <= *last), "{held:?}");
    assert!(!held.iter().any(|(first, last)| *first < 7 && 7 <= *last), "{held:?}");
}

#[test]
fn no_cut_goes_between_a_bar_and_its_text_or_a_step_and_its_mark() {
    let mut drawing = sequence(2);
    drawing.text((6, 1), "*");
    let held = super::held::held(&drawing.into(), Axis::Columns);
    let is_free = |at: i32| held.iter().all(|(first, last)| at <= *first || *last < at);
    // From the mark, column 6, over frame and bar to the end of the text, column 19.
    assert!((6..=19).skip(1).all(|at| !is_free(at)), "{held:?}");
    assert!(is_free(20), "{held:?}");
}

#[test]
fn what_is_wide_is_cut_between_its_branches() {
    // Two steps side by side, and a double line that joins them.
    let mut drawing = Drawing::default();
    step(0, (2, 3), &mut drawing);
    step(1, (30, 3), &mut drawing);
    drawing.line((1, 1), (31, 1), true);
    let pieces = pieces(drawing, (24, 10));
    let [left, right] = &pieces[..] else { panic!("{pieces:?}") };
    assert_eq!((left.ends[0].side, right.ends[0].side), (Side::Right, Side::Left));
    assert!(left.drawing.width <= 24 && right.drawing.width <= 24);
    let doubles = |piece: &Piece| {
        piece.drawing.shapes.iter().filter(|one| matches!(one, Shape::Line { double: true, .. })).count()
    };
    assert_eq!((doubles(left), doubles(right)), (1, 1));
}

#[test]
fn a_step_that_is_larger_than_a_page_stays_one() {
    let mut drawing = Drawing::default();
    step(0, (2, 0), &mut drawing);
    assert_eq!(pieces(drawing, (3, 2)).len(), 1);
}

#[test]
fn the_frame_around_a_net_has_no_connectors() {
    let mut drawing = Drawing::default();
    drawing.shapes.push(Shape::Frame { at: (0, 0), size: (12, 30), kind: Frame::Sheet });
    step(0, (5, 4), &mut drawing);
    step(1, (5, 20), &mut drawing);
    let pieces = pieces(drawing, (12, 20));
    let [first, second] = &pieces[..] else { panic!("{pieces:?}") };
    assert!(first.ends.is_empty() && second.ends.is_empty());
    // Top and two sides above, two sides and the bottom below.
    assert_eq!((first.borders.len(), second.borders.len()), (3, 3));
    assert_eq!((first.drawing.sites.len(), second.drawing.sites.len()), (1, 1));
}

#[test]
fn pieces_stand_side_by_side_and_then_on_the_next_page() {
    let mut paper = Paper::default();
    let drawing = Drawing { width: 10, height: 8, ..Drawing::default() };
    let mut place = || paper.place(&drawing, (25, 18));
    // Two squares between them from left to right, one row from top to bottom.
    assert_eq!(
        [place(), place(), place(), place(), place()],
        [Some((0, 0)), Some((12, 0)), Some((0, 9)), Some((12, 9)), None]
    );
}
