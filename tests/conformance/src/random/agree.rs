//! Charts that mean the same in both dialects: the last paragraph of the page of decisions.
//!
//! Steps have two colours and every transition leads from one to the other, under the input `k` or under `!k`: no two
//! evolutions happen on one set of inputs, nothing is re-entered (A4). The first cycle has `k` false, so that nothing clears in
//! it (A27). Conditions read inputs and the time of their own step alone.

use std::fmt::Write as _;

use super::{Random, Rng};

/// A chart of one dialect; the same seed gives the same steps, transitions and actions in the other.
#[must_use]
pub fn chart(seed: u64, grafcet: bool, cycles: usize) -> Random {
    let mut drawing = Drawing { rng: Rng::new(seed), steps: Vec::new(), arrows: Vec::new() };
    drawing.draw();
    let mut text = format!("{} C {{\n", if grafcet { "grafcet" } else { "sfc" });
    let allowed = "grafcet::set_without_reset, grafcet::reset_without_set, grafcet::overlapping_branches";
    _ = writeln!(text, "#![allow({allowed})]\ninput k, a, b, c: bool;\noutput q0, q1, q2, s: bool;");
    _ = writeln!(text, "output z: i16;\noutput w: bool;\nvar n: i16 = 0;");
    for step in &drawing.steps {
        let initial = if step.name == 0 { "initial " } else { "" };
        _ = writeln!(text, "{initial}step S{} {{\n{}}}", step.name, step.lines);
    }
    text.extend(drawing.arrows);
    text.push_str("}\n");
    let timeline = timeline(&mut Rng::new(!seed), cycles);
    Random { chart: text, timeline, features: std::iter::once("chart of both dialects").collect() }
}

struct Drawing {
    rng: Rng,
    steps: Vec<Step>,
    arrows: Vec<String>,
}

struct Step {
    name: usize,
    lines: String,
}

impl Drawing {
    fn draw(&mut self) {
        let first = self.step(true);
        let (mut last, mut even) = (first, true);
        for _ in 0..self.rng.between(1, 4) {
            (last, even) = match self.rng.below(4) {
                0 | 1 => (self.next(last, even, true), !even),
                2 => (self.selection(last, even), even),
                _ => (self.parallel(last, even), even),
            };
        }
        if even {
            (last, even) = (self.next(last, even, true), !even);
        }
        self.arrow(&[last], &[first], even, "true");
    }

    /// A step; `alone` where no other is active beside it, so that it may write what others of its kind write.
    fn step(&mut self, alone: bool) -> usize {
        let name = self.steps.len();
        let mut lines = String::new();
        for _ in 0..self.rng.below(4) {
            let condition = *self.rng.pick(&["", " if a", " if a && !b", " if b || c"]);
            let value = *self.rng.pick(&["1", "2", "3", "(4 * 5) % 7"]);
            let line = match self.rng.below(if alone { 7 } else { 3 }) {
                0..=2 => format!("N q{}{condition};\n", self.rng.below(3)),
                3 => "S s;\n".to_owned(),
                4 => "R s;\n".to_owned(),
                5 => format!("P1 z = {value};\n"),
                _ => "P0 w = a && !c;\n".to_owned(),
            };
            // S and R of one step have no order in `grafcet`; two lines for one place race.
            let place = |line: &str| line.split(' ').nth(1).map(str::to_owned);
            if !lines.lines().any(|other| place(other) == place(line.trim_end())) {
                lines.push_str(&line);
            }
        }
        if name == 0 && self.rng.chance(50) {
            lines.push_str("P1 n = (n + 1) % 40;\n");
        }
        self.steps.push(Step { name, lines });
        name
    }

    fn next(&mut self, from: usize, even: bool, alone: bool) -> usize {
        let to = self.step(alone);
        let condition = self.condition(from);
        self.arrow(&[from], &[to], even, &condition);
        to
    }

    fn selection(&mut self, from: usize, even: bool) -> usize {
        let (left, right) = (self.step(true), self.step(true));
        self.arrow(&[from], &[left], even, "a");
        self.arrow(&[from], &[right], even, "!a && b");
        let join = self.next(left, !even, true);
        let condition = self.condition(right);
        self.arrow(&[right], &[join], !even, &condition);
        join
    }

    fn parallel(&mut self, from: usize, even: bool) -> usize {
        let starts: Vec<usize> = (0..self.rng.between(2, 3)).map(|_| self.step(false)).collect();
        self.arrow(&[from], &starts, even, "(b || c)");
        let mut ends = Vec::new();
        for start in starts {
            let mut end = start;
            if self.rng.chance(50) {
                let middle = self.next(end, !even, false);
                end = self.next(middle, even, false);
            }
            ends.push(end);
        }
        let join = self.step(true);
        self.arrow(&ends, &[join], !even, "c");
        join
    }

    fn condition(&mut self, from: usize) -> String {
        match self.rng.below(7) {
            0 => "true".to_owned(),
            1 => "(a || b)".to_owned(),
            2 => "!c".to_owned(),
            3 => "(a ^ c)".to_owned(),
            4 => "rising(b)".to_owned(),
            5 => "falling(a && c)".to_owned(),
            _ => format!("(3ms/S{from})"),
        }
    }

    fn arrow(&mut self, from: &[usize], to: &[usize], even: bool, condition: &str) {
        let list = |steps: &[usize]| {
            let names: Vec<String> = steps.iter().map(|step| format!("S{step}")).collect();
            if names.len() == 1 { names.concat() } else { format!("({})", names.join(", ")) }
        };
        let colour = if even { "k" } else { "!k" };
        self.arrows.push(format!("{} -[{colour} && {condition}]-> {};\n", list(from), list(to)));
    }
}

fn timeline(rng: &mut Rng, cycles: usize) -> String {
    let mut text = "@0 | |\n".to_owned();
    let (mut k, mut now) = (false, 0_u32);
    for _ in 0..cycles {
        k ^= rng.chance(60);
        now = now.wrapping_add(u32::try_from(rng.below(4)).unwrap_or_default());
        text.push_str(if k { "k " } else { "" });
        for input in ["a ", "b ", "c "] {
            text.push_str(if rng.chance(60) { input } else { "" });
        }
        _ = writeln!(text, "@{now} | |");
    }
    text
}
