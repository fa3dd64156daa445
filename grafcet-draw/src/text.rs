//! The drawing list in characters.

use crate::shape::{Drawing, Frame, Heading, Shape};
use crate::wrap::width;

/// To which sides the lines in a square go.
const UP: u16 = 1;
const DOWN: u16 = 2;
const LEFT: u16 = 4;
const RIGHT: u16 = 8;
/// Its horizontal or its vertical line is double.
const DOUBLE_ROW: u16 = 16;
const DOUBLE_COLUMN: u16 = 32;
/// The bar of a transition.
const BAR: u16 = 64;

/// An upright line that goes through.
const THROUGH: u16 = 128;
/// A double line, no frame.
const PARALLEL: u16 = 256;

/// What stands in a square.
#[derive(Clone, Copy)]
enum Square {
    Lines(u16),
    Char(char),
    /// The second half of a wide character.
    Covered,
}

/// The drawing, each line without blanks at its end.
pub(crate) fn write(drawing: &Drawing) -> String {
    let (width, height) = (usize::try_from(drawing.width).unwrap_or(0), usize::try_from(drawing.height).unwrap_or(0));
    let mut paper = Paper { squares: vec![vec![Square::Lines(0); width]; height] };
    drawing.shapes.iter().for_each(|shape| paper.add(shape));
    let mut text = String::new();
    for row in paper.squares {
        let line: String = row.into_iter().filter_map(character).collect();
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

struct Paper {
    squares: Vec<Vec<Square>>,
}

impl Paper {
    fn add(&mut self, shape: &Shape) {
        match shape {
            Shape::Line { from, to, double } => self.line(*from, *to, *double),
            Shape::Bar { at } => {
                (at.0 - 1..=at.0 + 1).for_each(|x| self.mark((x, at.1), BAR));
                self.mark(*at, UP | DOWN);
            }
            Shape::Frame { at, size, kind } => self.frame(*at, *size, *kind),
            Shape::Arrow { at, to } => {
                let head = match to {
                    Heading::Up => '▲',
                    Heading::Down => '▼',
                    Heading::Left => '◄',
                };
                self.put(*at, head);
            }
            Shape::Changed { .. } => {}
            Shape::Dot { at } => self.put(*at, '•'),
            Shape::Mark { at } => self.put(*at, '●'),
            Shape::Text { at, text, .. } => {
                let mut x = at.0;
                for c in text.chars() {
                    self.put((x, at.1), c);
                    if width(c.encode_utf8(&mut [0; 4])) == 2 {
                        x += 1;
                        self.set((x, at.1), Square::Covered);
                    }
                    x += 1;
                }
            }
        }
    }

    fn square(&mut self, (x, y): (i32, i32)) -> Option<&mut Square> {
        let (x, y) = (usize::try_from(x).ok()?, usize::try_from(y).ok()?);
        self.squares.get_mut(y)?.get_mut(x)
    }

    fn set(&mut self, at: (i32, i32), new: Square) {
        if let Some(square) = self.square(at) {
            *square = new;
        }
    }

    fn put(&mut self, at: (i32, i32), c: char) {
        self.set(at, Square::Char(if c.is_control() { ' ' } else { c }));
    }

    fn mark(&mut self, at: (i32, i32), lines: u16) {
        if let Some(Square::Lines(there)) = self.square(at) {
            *there |= lines;
        }
    }

    fn line(&mut self, from: (i32, i32), to: (i32, i32), double: bool) {
        let (back, ahead, double) =
            if from.1 == to.1 { (LEFT, RIGHT, if double { DOUBLE_ROW | PARALLEL } else { 0 }) } else { (UP, DOWN, 0) };
        for x in from.0..=to.0 {
            for y in from.1..=to.1 {
                let mut lines = double;
                if (x, y) != from {
                    lines |= back;
                }
                if (x, y) != to {
                    lines |= ahead;
                }
                if from.0 == to.0 && (x, y) != from && (x, y) != to {
                    lines |= THROUGH;
                }
                self.mark((x, y), lines);
            }
        }
    }

    fn frame(&mut self, (x, y): (i32, i32), (w, h): (i32, i32), kind: Frame) {
        let (right, below) = (x + w - 1, y + h - 1);
        self.line((x, y), (right, y), false);
        self.line((x, below), (right, below), false);
        self.line((x, y), (x, below), false);
        self.line((right, y), (right, below), false);
        let (rows, columns) = match kind {
            Frame::Step { initial: true, .. } | Frame::Force => (DOUBLE_ROW, DOUBLE_COLUMN),
            Frame::Macro { .. } => (DOUBLE_ROW, 0),
            _ => (0, 0),
        };
        for x in x..=right {
            self.mark((x, y), rows);
            self.mark((x, below), rows);
        }
        for y in y..=below {
            self.mark((x, y), columns);
            self.mark((right, y), columns);
        }
        if let Frame::Step { enclosing: true, .. } = kind {
            self.put((x, y), '╱');
            self.put((right, y), '╲');
            self.put((x, below), '╲');
            self.put((right, below), '╱');
        }
    }
}

fn character(square: Square) -> Option<char> {
    let lines = match square {
        Square::Char(c) => return Some(c),
        Square::Covered => return None,
        Square::Lines(lines) => lines,
    };
    if lines & BAR != 0 {
        return Some(if lines & (UP | DOWN) == 0 { '━' } else { '┿' });
    }
    if lines & (PARALLEL | THROUGH) == PARALLEL | THROUGH {
        return Some('│');
    }
    // What a square with lines to these sides looks like: plain, with a double row, a double column, or both.
    let row = match lines & (UP | DOWN | LEFT | RIGHT) {
        0 => "    ",
        l if l & !(UP | DOWN) == 0 => "││║║",
        l if l & !(LEFT | RIGHT) == 0 => "─═─═",
        l if l == DOWN | RIGHT => "┌╒╓╔",
        l if l == DOWN | LEFT => "┐╕╖╗",
        l if l == UP | RIGHT => "└╘╙╚",
        l if l == UP | LEFT => "┘╛╜╝",
        l if l == UP | DOWN | RIGHT => "├╞╟╠",
        l if l == UP | DOWN | LEFT => "┤╡╢╣",
        l if l == DOWN | LEFT | RIGHT => "┬╤╥╦",
        l if l == UP | LEFT | RIGHT => "┴╧╨╩",
        _ => "┼╪╫╬",
    };
    row.chars().nth(usize::from((lines / DOUBLE_ROW) & 3))
}
