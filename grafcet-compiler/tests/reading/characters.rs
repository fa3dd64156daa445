//! A drawing in characters as the lines, boxes and texts that it shows.

use crate::parts::{Line, Parts, Rect, Text};

const UP: u8 = 1;
const DOWN: u8 = 2;
const LEFT: u8 = 4;
const RIGHT: u8 = 8;

/// To which sides the lines of a character go; and whether the level one is double.
fn arms(c: char) -> Option<(u8, bool)> {
    Some(match c {
        '│' | '║' | '▲' | '┿' => (UP | DOWN, false),
        '─' | '◄' | '━' => (LEFT | RIGHT, false),
        '═' => (LEFT | RIGHT, true),
        '┌' => (DOWN | RIGHT, false),
        '┐' => (DOWN | LEFT, false),
        '└' => (UP | RIGHT, false),
        '┘' => (UP | LEFT, false),
        '├' | '╟' => (UP | DOWN | RIGHT, false),
        '┤' | '╢' => (UP | DOWN | LEFT, false),
        '┬' => (DOWN | LEFT | RIGHT, false),
        '┴' => (UP | LEFT | RIGHT, false),
        '┼' | '•' => (UP | DOWN | LEFT | RIGHT, false),
        '╤' => (DOWN | LEFT | RIGHT, true),
        '╧' => (UP | LEFT | RIGHT, true),
        '╪' => (UP | DOWN | LEFT | RIGHT, true),
        '▼' => (UP, false),
        // The other corners and sides of frames.
        '╔' | '╒' | '╗' | '╕' | '╚' | '╘' | '╝' | '╛' | '╠' | '╣' | '╦' | '╩' | '╬' | '╓' | '╖' | '╙' | '╜' | '╞'
        | '╡' | '╥' | '╨' | '╫' | '╱' | '╲' => (0, false),
        _ => return None,
    })
}

struct Grid(Vec<Vec<char>>);

impl Grid {
    fn at(&self, row: usize, column: usize) -> char {
        self.0.get(row).and_then(|row| row.get(column)).copied().unwrap_or(' ')
    }

    /// The last column of the box of a step whose upper left corner is here.
    fn step(&self, row: usize, column: usize) -> Option<usize> {
        let corner = |row: usize, column: usize, of: &str| of.contains(self.at(row, column));
        if !corner(row, column, "┌╔╒╱") || !corner(row + 1, column, "│║") || !corner(row + 2, column, "└╚╘╲")
        {
            return None;
        }
        let right = (column + 1..=self.0[row].len()).find(|right| !"─═┴╧".contains(self.at(row, *right)))?;
        let bottom = (column + 1..right).all(|column| "─═┬╤".contains(self.at(row + 2, column)));
        let name = (column + 1..right).all(|column| arms(self.at(row + 1, column)).is_none());
        let named = (column + 1..right).any(|column| self.at(row + 1, column).is_alphanumeric());
        let closed = corner(row, right, "┐╗╕╲") && corner(row + 1, right, "│║├╟") && corner(row + 2, right, "┘╝╛╱");
        (bottom && name && named && closed).then_some(right)
    }

    /// Takes away everything that is connected with this square.
    fn erase(&mut self, row: usize, column: usize) {
        let mut next = vec![(row, column)];
        while let Some((row, column)) = next.pop() {
            let c = self.at(row, column);
            if arms(c).is_none() {
                continue;
            }
            self.0[row][column] = ' ';
            // In the frames of actions lines are of any kind.
            next.extend([(row + 1, column), (row, column + 1)]);
            next.extend(row.checked_sub(1).map(|row| (row, column)));
            next.extend(column.checked_sub(1).map(|column| (row, column)));
        }
    }
}

/// The middle of a square.
fn middle(at: usize, size: i32) -> i32 {
    i32::try_from(at).expect("a small drawing") * size + size / 2
}

/// Takes a drawing in characters apart, in the measures of an SVG picture.
pub(crate) fn parts(text: &str) -> Parts {
    let mut grid = Grid(text.lines().map(|line| line.chars().collect()).collect());
    let mut parts = Parts::default();
    texts(&grid, &mut parts);
    let squares: Vec<(usize, usize)> =
        grid.0.iter().enumerate().flat_map(|(row, line)| (0..line.len()).map(move |column| (row, column))).collect();
    for (row, column) in &squares {
        if let Some(right) = grid.step(*row, *column) {
            step(&mut grid, &mut parts, (*row, *column), right);
        }
    }
    for (row, column) in squares {
        square(&grid, &mut parts, row, column);
    }
    parts
}

/// Words with single blanks between them.
fn texts(grid: &Grid, parts: &mut Parts) {
    for (row, line) in grid.0.iter().enumerate() {
        let mut column = 0;
        while column < line.len() {
            let is_text = |column: usize| column < line.len() && line[column] != ' ' && arms(line[column]).is_none();
            let start = column;
            while is_text(column) || column > start && grid.at(row, column) == ' ' && is_text(column + 1) {
                column += 1;
            }
            if column == start {
                column += 1;
                continue;
            }
            let says: String = line[start..column].iter().collect();
            let (x, width) = (middle(start, 8) - 4, middle(column - start, 8) - 4);
            parts.texts.push(Text { x, y: middle(row, 16), width, says });
        }
    }
}

/// A box, with the ends of the lines at it.
fn step(grid: &mut Grid, parts: &mut Parts, (row, left): (usize, usize), right: usize) {
    let (x, y) = (middle(left, 8), middle(row, 16));
    let rect = Rect { x, y, w: middle(right, 8) - x, h: 32, faint: false };
    parts.rects.push(rect);
    if grid.at(row + 1, left) == '║' {
        parts.rects.push(Rect { x: x + 3, y: y + 3, w: rect.w - 6, h: 26, faint: false });
    }
    for column in left..=right {
        let at = middle(column, 8);
        if "┴╧".contains(grid.at(row, column)) {
            parts.upright.push(Line { at, from: y - 8, to: y });
        }
        if "┬╤".contains(grid.at(row + 2, column)) {
            parts.upright.push(Line { at, from: y + 32, to: y + 40 });
        }
    }
    let beside = "├╟".contains(grid.at(row + 1, right));
    for row in row..row + 3 {
        (left..=right).for_each(|column| grid.0[row][column] = ' ');
    }
    if beside {
        grid.erase(row + 1, right + 1);
    }
}

fn square(grid: &Grid, parts: &mut Parts, row: usize, column: usize) {
    let c = grid.at(row, column);
    let Some((lines, double)) = arms(c) else { return };
    let (x, y) = (middle(column, 8), middle(row, 16));
    match c {
        '━' => return,
        '┿' => parts.bars.push((x, y)),
        '•' => parts.dots.push((x, y)),
        '▲' => parts.arrows.push(((x, y - 5), '^')),
        '▼' => parts.arrows.push(((x, y + 5), 'v')),
        '◄' => parts.arrows.push(((x - 4, y), '<')),
        _ => {}
    }
    let apart = if double { 2 } else { 0 };
    if lines & UP != 0 {
        parts.upright.push(Line { at: x, from: y - 8, to: y - apart });
    }
    if lines & DOWN != 0 {
        parts.upright.push(Line { at: x, from: y + apart, to: y + 8 });
    }
    // A line ends in the middle of its last square, wherever that has no arm; `◄─` is one with a stem of one square.
    let stem = c == '─' && grid.at(row, column.wrapping_sub(1)) == '◄';
    let double_end = |column: usize| double && !"═╤╧╪".contains(grid.at(row, column));
    let gap = |column: usize| double && grid.at(row, column) == '│';
    let from =
        if lines & LEFT == 0 || double_end(column.wrapping_sub(1)) && !gap(column.wrapping_sub(1)) { x } else { x - 4 };
    let to = if lines & RIGHT == 0 || stem || double_end(column + 1) && !gap(column + 1) { x } else { x + 4 };
    if lines & (LEFT | RIGHT) != 0 {
        for y in if double { vec![y - 2, y + 2] } else { vec![y] } {
            parts.level.push(Line { at: y, from, to });
        }
    }
}
