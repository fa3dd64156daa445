//! Sequences that go on by time, by edges and by inputs that contradict each other: many searches end with their first evolution,
//! and some have two branches beside each other, each with times of its own.

use std::fmt::Write as _;

use super::{Random, Rng};

/// A chart of a dialect.
#[must_use]
pub(super) fn chart(seed: u64, grafcet: bool, cycles: usize) -> Random {
    let mut sequence =
        Sequence { rng: Rng::new(seed), steps: String::new(), arrows: String::new(), count: 0, only_time: 0 };
    sequence.only_time = *sequence.rng.pick(&[0, 50, 100]);
    let dialect = if grafcet { "grafcet" } else { "sfc" };
    let rules = "unreachable_step dead_transition stuck_join deadlock never_true always_true conflicting_values \
                 set_without_reset reset_without_set unused_input undriven_output overlapping_branches";
    let allowed = rules.split(' ').filter(|rule| !grafcet || *rule != "overlapping_branches");
    let allowed: Vec<_> = allowed.map(|rule| format!("grafcet::{rule}")).collect();
    sequence.ring();
    let text = format!(
        "{dialect} C {{\n#![allow({})]\ninput a, b, c, d: bool;\noutput q0, q1, q2, s: bool;\noutput n: u8;\n{}{}}}\n",
        allowed.join(", "),
        sequence.steps,
        sequence.arrows
    );
    let timeline = timeline(&mut sequence.rng, cycles);
    Random { chart: text, timeline, features: std::iter::once("sequence by time").collect() }
}

struct Sequence {
    rng: Rng,
    steps: String,
    arrows: String,
    count: usize,
    /// Of a hundred conditions, how many ask but for the time of their own step.
    only_time: usize,
}

impl Sequence {
    fn ring(&mut self) {
        let first = self.step(true);
        let mut last = first;
        for _ in 0..self.rng.between(1, 5) {
            last = match self.rng.below(8) {
                0 => self.branches(last),
                1 => self.selection(last),
                2 => self.again(last),
                _ => self.next(last, true),
            };
        }
        self.arrow(&format!("S{last}"), &format!("S{first}"), last);
    }

    /// A step; `alone` where no other one is active beside it.
    fn step(&mut self, alone: bool) -> usize {
        let (step, initial) = (self.count, if self.count == 0 { "initial " } else { "" });
        self.count += 1;
        let mut actions = String::new();
        // Each writes another place.
        for q in 0..self.rng.below(3) {
            let time = self.rng.between(1, 4);
            let action = match (q, self.rng.below(8)) {
                (0, 4) if alone => "S s;".to_owned(),
                (0, 5) if alone => "R s;".to_owned(),
                (1, 6) if alone => "P1 n = (n + 1) % 100;".to_owned(),
                (1, 7) if alone => "P0 n = (n + 7) % 100;".to_owned(),
                (_, 0) => format!("N q{q};"),
                (_, 1) => format!("N q{q} if a;"),
                (_, 2) => format!("D {time}ms q{q};"),
                _ => format!("L {time}ms q{q};"),
            };
            _ = writeln!(actions, "{action}");
        }
        _ = writeln!(self.steps, "{initial}step S{step} {{\n{actions}}}");
        step
    }

    fn next(&mut self, from: usize, alone: bool) -> usize {
        let to = self.step(alone);
        self.arrow(&format!("S{from}"), &format!("S{to}"), from);
        to
    }

    /// Two ways that exclude each other and meet again.
    fn selection(&mut self, from: usize) -> usize {
        let (left, right) = (self.step(true), self.step(true));
        let (one, other) = (self.condition(from), self.condition(from));
        _ = writeln!(self.arrows, "S{from} -[d && ({one})]-> S{left};\nS{from} -[!d && ({other})]-> S{right};");
        let join = self.next(left, true);
        self.arrow(&format!("S{right}"), &format!("S{join}"), right);
        join
    }

    /// A step that is left and entered at once.
    fn again(&mut self, from: usize) -> usize {
        let to = self.step(true);
        let (one, other) = (self.condition(from), self.condition(from));
        _ = writeln!(self.arrows, "S{from} -[c && ({one})]-> S{from};\nS{from} -[!c && ({other})]-> S{to};");
        to
    }

    fn branches(&mut self, from: usize) -> usize {
        let starts: Vec<usize> = (0..2).map(|_| self.step(false)).collect();
        self.arrow(&format!("S{from}"), &format!("(S{}, S{})", starts[0], starts[1]), from);
        let ends: Vec<usize> = starts.into_iter().map(|start| self.next(start, false)).collect();
        let join = self.step(true);
        self.arrow(&format!("(S{}, S{})", ends[0], ends[1]), &format!("S{join}"), ends[0]);
        join
    }

    fn arrow(&mut self, from: &str, to: &str, timed: usize) {
        let condition = self.condition(timed);
        _ = writeln!(self.arrows, "{from} -[{condition}]-> {to};");
    }

    /// What the transition out of a step waits for.
    fn condition(&mut self, step: usize) -> String {
        let time = *self.rng.pick(&["0", "1", "2", "3", "5", "20", "70000"]);
        let input = *self.rng.pick(&["a", "!a", "b", "!b", "a && !b", "a || b"]);
        if self.rng.chance(self.only_time) {
            return format!("{time}ms/S{step}");
        }
        match self.rng.below(9) {
            0 | 1 => format!("{time}ms/S{step}"),
            2 => format!("S{step}.T >= {time}ms"),
            3 => format!("{input} && {time}ms/S{step}"),
            4 => format!("{input} || {time}ms/S{step}"),
            5 => "rising(a)".to_owned(),
            6 => "falling(b) && c".to_owned(),
            _ => input.to_owned(),
        }
    }
}

/// The clock is irregular, wraps, and sometimes leaps.
fn timeline(rng: &mut Rng, cycles: usize) -> String {
    let mut text = String::new();
    let (mut on, mut now) = ([false; 4], *rng.pick(&[0, 1000, u32::MAX - 20, 0x8000_0000_u32]));
    for _ in 0..cycles {
        for _ in 0..*rng.pick(&[0, 0, 1, 1, 2]) {
            let index = rng.below(4);
            on[index] = !on[index];
        }
        let pause = *rng.pick(&[0, 1, 1, 1, 2, 2, 3, 5]);
        let leap = *rng.pick(&[20, 70_000, 0x4000_0000, u32::MAX - 1, u32::MAX]);
        now = now.wrapping_add(if rng.chance(96) { pause } else { leap });
        for (name, on) in ["a ", "b ", "c ", "d "].iter().zip(on) {
            text.push_str(if on { name } else { "" });
        }
        _ = writeln!(text, "@{now} | |");
    }
    text
}
