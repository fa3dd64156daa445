//! An SVG picture, taken apart: what is seen of it, and nothing that the layout knows.
//!
//! Upright and level lines of one width are one line where they go on in each other. Two lines that meet at an end are connected;
//! where both go on they cross, and are connected only by a dot. Two level lines side by side are a double line: what ends
//! at it from above or below is connected with it, what crosses it passes through a gap.

use std::collections::BTreeMap;

use crate::net::{Bar, Box, End, Piece, Seen};
use crate::parts::{Line, Parts, Rect, Text};

/// From the middle of a double line to each of its lines.
const APART: i32 = 2;
/// From the middle of a line that crosses a double line to the end of the latter, at most.
const GAP: i32 = 6;

/// Lines that go on in each other are one.
fn merged(mut lines: Vec<Line>) -> Vec<Line> {
    lines.sort_unstable();
    let mut long: Vec<Line> = Vec::new();
    for line in lines {
        match long.last_mut() {
            Some(last) if last.at == line.at && line.from <= last.to => last.to = last.to.max(line.to),
            _ => long.push(line),
        }
    }
    long
}

struct Reader {
    /// The level lines with their gaps.
    drawn: Vec<Line>,
    parts: Parts,
    /// The boxes of steps, and of what stands beside them.
    steps: Vec<Rect>,
    actions: Vec<Rect>,
    doubles: Vec<Line>,
    seen: Seen,
}

/// Takes a picture apart.
pub(crate) fn seen(mut parts: Parts) -> Seen {
    let drawn = merged(parts.level.clone());
    let inner: Vec<Rect> = parts.rects.iter().copied().filter(|r| within(r, &parts.rects)).collect();
    let sheets: Vec<Rect> = parts.rects.iter().copied().filter(|rect| rect.faint).collect();
    let boxes: Vec<Rect> = parts.rects.iter().copied().filter(|rect| !rect.faint && !inner.contains(rect)).collect();
    parts.level = merged(parts.level);
    parts.upright = merged(parts.upright);
    let actions = beside(&parts, &boxes);
    let steps = boxes.into_iter().filter(|rect| !actions.contains(rect)).collect();
    let mut reader = Reader { drawn, parts, steps, actions, doubles: Vec::new(), seen: Seen::default() };
    reader.boxes(&inner, &sheets);
    reader.legend(&sheets);
    reader.clear();
    reader.doubles();
    reader.bars();
    reader.pieces();
    reader.seen
}

/// The inner one of a double frame.
fn within(rect: &Rect, all: &[Rect]) -> bool {
    all.iter().any(|o| (o.x + 3, o.y + 3, o.w - 6, o.h - 6) == (rect.x, rect.y, rect.w, rect.h))
}

/// The boxes of actions: a level line leads to one from the box of a step, and others stand below it.
fn beside(parts: &Parts, boxes: &[Rect]) -> Vec<Rect> {
    let joined = |rect: &Rect| {
        let ends = |line: &Line| line.to == rect.x && rect.y < line.at && line.at < rect.y + rect.h;
        let starts = |line: &Line| {
            boxes.iter().any(|other| other.x + other.w == line.from && other.y < line.at && line.at < other.y + other.h)
        };
        parts.level.iter().any(|line| ends(line) && starts(line))
    };
    let mut actions: Vec<Rect> = boxes.iter().copied().filter(joined).collect();
    let mut next = 0;
    while let Some(upper) = actions.get(next).copied() {
        next += 1;
        let below = |rect: &&Rect| {
            let y = upper.y + upper.h;
            let linked = parts.upright.iter().any(|line| line.at == rect.x && line.from <= y && line.to >= rect.y);
            rect.x == upper.x && rect.y >= y && (rect.y == y || linked && rect.y - y <= 48)
        };
        actions.extend(boxes.iter().filter(below).filter(|rect| !actions.contains(rect)).collect::<Vec<_>>());
    }
    actions
}

impl Reader {
    fn boxes(&mut self, inner: &[Rect], sheets: &[Rect]) {
        for rect in &self.steps {
            let name: Vec<&Text> = self.parts.texts.iter().filter(|text| rect.holds((text.x, text.y))).collect();
            let sheet = sheets.iter().find(|sheet| sheet.holds((rect.x, rect.y))).and_then(|sheet| {
                self.parts.texts.iter().filter(|text| sheet.holds((text.x, text.y))).min_by_key(|text| text.y)
            });
            let initial = inner.iter().any(|inner| within(inner, &[*rect]));
            let [name] = name[..] else {
                self.seen.faults.push(format!("{} texts in the box {rect:?}", name.len()));
                continue;
            };
            self.seen.boxes.push(Box {
                name: name.says.clone(),
                initial,
                sheet: sheet.map(|text| text.says.clone()).unwrap_or_default(),
                at: (rect.x + rect.w / 2, rect.y),
            });
        }
    }

    /// Takes away the lines of boxes and actions.
    fn clear(&mut self) {
        let (steps, actions) = (&self.steps, &self.actions);
        let inside = |a: (i32, i32), b: (i32, i32)| {
            steps
                .iter()
                .chain(actions)
                .any(|rect| rect.touches(a) && rect.touches(b) && rect.holds(((a.0 + b.0) / 2, (a.1 + b.1) / 2)))
        };
        let at_action = |at: (i32, i32)| actions.iter().any(|rect| rect.touches(at));
        self.parts.level.retain(|l| !inside((l.from, l.at), (l.to, l.at)) && !at_action((l.to, l.at)));
        self.parts.upright.retain(|l| !inside((l.at, l.from), (l.at, l.to)) && !at_action((l.at, l.to)));
    }

    /// Two level lines close together, with gaps where something crosses them.
    fn doubles(&mut self) {
        let lines = self.parts.level.clone();
        let pair = |line: &Line| lines.contains(&Line { at: line.at + 2 * APART, ..*line });
        let mut pieces: Vec<Line> =
            lines.iter().filter(|line| pair(line)).map(|line| Line { at: line.at + APART, ..*line }).collect();
        self.parts
            .level
            .retain(|line| !pieces.iter().any(|piece| (piece.at - line.at).abs() == APART && piece.from == line.from));
        pieces.sort_unstable();
        for piece in pieces {
            // Everything between the two pieces is near to something that passes through.
            let gap = |last: &Line| {
                let through = |line: &&Line| line.from < piece.at - APART && line.to > piece.at + APART;
                let between = |line: &&Line| last.to < line.at && line.at < piece.from;
                let passing = self.parts.upright.iter().filter(through).filter(between).map(|line| line.at);
                let mut ends: Vec<i32> =
                    [last.to, piece.from].into_iter().chain(passing.flat_map(|x| [x, x])).collect();
                ends.sort_unstable();
                last.at == piece.at && ends.len() > 2 && ends.chunks(2).all(|pair| pair[1] - pair[0] <= 2 * GAP)
            };
            match self.doubles.last_mut() {
                Some(last) if gap(last) => last.to = piece.to,
                _ => self.doubles.push(piece),
            }
        }
        self.seen.doubles = self.doubles.len();
        self.uncut();
    }

    /// What crosses a double line where that has no gap looks as if it ended there.
    fn uncut(&mut self) {
        let drawn = &self.drawn;
        for line in &self.parts.upright {
            let crossed = |double: &&Line| {
                let inside = double.from <= line.at && line.at <= double.to;
                let through = line.from < double.at + APART && double.at - APART < line.to;
                let cut = drawn.iter().filter(|d| (d.at - double.at).abs() == APART);
                inside && through && cut.clone().any(|d| d.from <= line.at && line.at <= d.to)
            };
            let faults = self.doubles.iter().filter(crossed);
            self.seen.faults.extend(faults.map(|double| format!("{line:?} crosses {double:?} without a gap")));
        }
    }

    fn bars(&mut self) {
        for (x, y) in self.parts.bars.clone() {
            // Beside it, and below that without a line between.
            let column = |from: i32| {
                let mut lines = Vec::new();
                let mut row = y;
                while let Some(text) = self.parts.texts.iter().find(|text| text.x == from && text.y == row) {
                    lines.push(text.says.clone());
                    row += 16;
                }
                lines.concat().replace(' ', "")
            };
            let name = self.parts.texts.iter().find(|text| text.y == y && text.x < x && text.x + text.width + 28 == x);
            let name = name.map(|text| text.says.clone()).unwrap_or_default();
            self.seen.bars.push(Bar { name, text: column(x + 28), at: (x, y) });
        }
    }

    /// The lines in pieces, cut at bars.
    fn pieces(&mut self) {
        let mut upright = Vec::new();
        for line in &self.parts.upright {
            let mut from = line.from;
            let mut bars: Vec<i32> = self.parts.bars.iter().filter(|bar| bar.0 == line.at).map(|bar| bar.1).collect();
            bars.retain(|y| line.from < *y && *y < line.to);
            bars.sort_unstable();
            for bar in bars {
                upright.push(Line { from, to: bar, ..*line });
                from = bar;
            }
            upright.push(Line { from, ..*line });
        }
        self.parts.upright = upright;
        let contacts = self.contacts();
        let count = self.parts.level.len() + self.parts.upright.len();
        let mut done = vec![false; count];
        for line in 0..count {
            if done[line] {
                continue;
            }
            let mine = reach(&contacts, line, i32::MIN);
            for line in &mine {
                done[*line] = true;
            }
            let piece = self.piece(&mine, &contacts);
            self.seen.pieces.push(piece);
        }
    }

    /// The lines that each is connected with, and in which row: the level ones first, then the upright ones.
    fn contacts(&mut self) -> BTreeMap<usize, Vec<(usize, i32)>> {
        let (level, upright) = (&self.parts.level, &self.parts.upright);
        let mut contacts: BTreeMap<usize, Vec<(usize, i32)>> = BTreeMap::new();
        for (a, across) in level.iter().enumerate() {
            let first = upright.partition_point(|down| down.at < across.from);
            let near = upright[first..].iter().take_while(|down| down.at <= across.to);
            for (b, down) in near.enumerate().map(|(b, down)| (b + first, down)) {
                let meet =
                    across.from <= down.at && down.at <= across.to && down.from <= across.at && across.at <= down.to;
                let cross =
                    across.from < down.at && down.at < across.to && down.from < across.at && across.at < down.to;
                let dot = self.parts.dots.contains(&(down.at, across.at));
                if meet && (!cross || dot) {
                    contacts.entry(a).or_default().push((b + level.len(), across.at));
                    contacts.entry(b + level.len()).or_default().push((a, across.at));
                }
            }
        }
        contacts
    }

    fn piece(&mut self, mine: &[usize], contacts: &BTreeMap<usize, Vec<(usize, i32)>>) -> Piece {
        let mut piece = Piece::default();
        let level = self.parts.level.len();
        for line in mine {
            let ends = self.ends(*line);
            piece.ends.extend(ends);
            if *line < level {
                continue;
            }
            let down = self.parts.upright[*line - level];
            let up = |arrow: &((i32, i32), char)| {
                arrow.1 == '^' && arrow.0.0 == down.at && down.from <= arrow.0.1 && arrow.0.1 <= down.to
            };
            piece.arrow |= self.parts.arrows.iter().any(up);
            // A number stands close on the right.
            let close =
                |text: &&Text| down.from < text.y && text.y < down.to && text.x - down.at > 0 && text.x - down.at <= 12;
            let numbers =
                self.parts.texts.iter().filter(close).filter_map(|text| Some((text.y, text.says.parse().ok()?)));
            let ranks: Vec<(i32, usize)> = numbers.collect();
            for (y, number) in ranks {
                let after = reach(contacts, *line, y);
                let ends = after.iter().flat_map(|line| self.ends(*line));
                let ends = ends.filter(|end| !matches!(end, End::Bottom(_))).collect();
                piece.ranks.push((number, ends));
            }
        }
        piece.ends.sort();
        piece.ends.dedup();
        piece
    }

    /// What a line ends at.
    fn ends(&mut self, line: usize) -> Vec<End> {
        let mut ends = Vec::new();
        let level = self.parts.level.len();
        if line < level {
            let across = self.parts.level[line];
            for (at, heading) in &self.parts.arrows {
                if *heading == '<' && at.1 == across.at && across.from <= at.0 && at.0 <= across.to {
                    let mut names = String::new();
                    let mut row = at.1;
                    while let Some(text) = self.parts.texts.iter().find(|t| t.x == across.to + 12 && t.y == row) {
                        names.push_str(&text.says.replace(' ', ""));
                        row += 16;
                    }
                    ends.push(End::From(names));
                }
            }
            return ends;
        }
        let down = self.parts.upright[line - level];
        ends.extend(self.any(down).map(End::Any));
        for (id, rect) in self.steps.iter().enumerate() {
            let beside = rect.x <= down.at && down.at <= rect.x + rect.w;
            if beside && down.to == rect.y {
                ends.push(End::Top(id));
            }
            if beside && down.from == rect.y + rect.h {
                ends.push(End::Bottom(id));
            }
        }
        for (id, bar) in self.seen.bars.iter().enumerate() {
            if bar.at == (down.at, down.to) {
                ends.push(End::Over(id));
            }
            if bar.at == (down.at, down.from) {
                ends.push(End::Under(id));
            }
        }
        for (id, double) in self.doubles.iter().enumerate() {
            let over = double.from <= down.at && down.at <= double.to;
            if over && down.to == double.at - APART {
                ends.push(End::OnDouble(id));
            } else if over && down.from == double.at + APART {
                ends.push(End::BelowDouble(id));
            }
        }
        for (at, heading) in &self.parts.arrows {
            if *heading == 'v' && at.0 == down.at && down.from <= at.1 && at.1 - down.to <= 8 && down.to <= at.1 {
                let below = |text: &&Text| {
                    text.y - at.1 > 0 && text.y - at.1 <= 16 && text.x <= at.0 && at.0 <= text.x + text.width
                };
                let name = self.parts.texts.iter().find(below).map(|text| text.says.clone());
                ends.push(End::To(name.unwrap_or_default()));
            }
        }
        ends
    }
}

impl Reader {
    /// The words above the upper end of a line that begins there: it is longer than the stem of a bar.
    fn any(&self, down: Line) -> Option<String> {
        let over = |y: i32| {
            let at = |text: &&Text| text.y == y && text.x < down.at && down.at < text.x + text.width;
            self.parts.texts.iter().find(at).map(|text| text.says.as_str())
        };
        // A line of characters begins with the square in which it is.
        let last =
            [16, 8].into_iter().map(|gap| down.from - gap).find(|y| down.to - down.from > 8 && over(*y).is_some())?;
        let mut lines: Vec<&str> = (0..).map_while(|row| over(last - 16 * row)).collect();
        lines.reverse();
        lines.concat().starts_with("any").then(|| lines.concat().replace(' ', ""))
    }

    /// What is written in frames around nothing that is drawn, from top to bottom.
    fn legend(&mut self, sheets: &[Rect]) {
        let empty = |sheet: &&Rect| !self.steps.iter().any(|step| sheet.holds((step.x, step.y)));
        for sheet in sheets.iter().filter(empty) {
            let inside = self.parts.texts.iter().filter(|text| sheet.holds((text.x, text.y)));
            let mut texts: Vec<&Text> = inside.collect();
            texts.sort_by_key(|text| text.y);
            self.seen.legend.extend(texts.iter().map(|text| text.says.replace(' ', "")));
        }
    }
}

/// All lines connected with one, at it itself only below a row.
fn reach(contacts: &BTreeMap<usize, Vec<(usize, i32)>>, line: usize, below: i32) -> Vec<usize> {
    let mut found = vec![line];
    let mut next = 0;
    while let Some(line) = found.get(next).copied() {
        for (other, row) in contacts.get(&line).into_iter().flatten() {
            if (next > 0 || *row > below) && !found.contains(other) {
                found.push(*other);
            }
        }
        next += 1;
    }
    found
}
