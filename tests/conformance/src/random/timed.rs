//! Sequences that go on by time, by edges and by inputs that contradict each other: many searches end with their first evolution,
//! and some have branches beside each other, each with times of its own. Others go on by inputs that often hold together: many of
//! their searches have no end.

use std::fmt::Write as _;

use super::clock::Clock;
use super::{Random, Rng};

/// A chart of a dialect.
#[must_use]
pub(super) fn chart(seed: u64, grafcet: bool, cycles: usize) -> Random {
    let mut rng = Rng::new(seed);
    let (only_time, turns) = *rng.pick(&[(0, 0), (50, 0), (100, 0), (0, 80), (0, 100)]);
    let mut sequence = Sequence { rng, steps: String::new(), arrows: String::new(), count: 0, only_time, turns };
    let dialect = if grafcet { "grafcet" } else { "sfc" };
    let rules = "unreachable_step dead_transition stuck_join deadlock never_true always_true conflicting_values \
                 set_without_reset reset_without_set unused_input undriven_output timed_contention overlapping_branches";
    let allowed = rules.split(' ').filter(|rule| !grafcet || *rule != "overlapping_branches");
    let allowed: Vec<_> = allowed.map(|rule| format!("grafcet::{rule}")).collect();
    sequence.ring();
    let bound = (grafcet && turns > 0).then(|| *sequence.rng.pick(&["", "", "1", "2", "3", "5", "8"]));
    let bound = bound.filter(|bound| !bound.is_empty()).map(|bound| format!("max_evolutions {bound};\n"));
    let text = format!(
        "{dialect} C {{\n#![allow({})]\n{}input a, b, c, d: bool;\noutput q0, q1, q2, s: bool;\noutput n: u8;\n{}{}}}\n",
        allowed.join(", "),
        bound.unwrap_or_default(),
        sequence.steps,
        sequence.arrows
    );
    let timeline = timeline(&mut sequence.rng, cycles);
    let feature = if turns > 0 { "sequence by inputs that hold together" } else { "sequence by time" };
    Random { chart: text, timeline, features: std::iter::once(feature).collect() }
}

struct Sequence {
    rng: Rng,
    steps: String,
    arrows: String,
    count: usize,
    /// Of a hundred conditions, how many ask but for the time of their own step.
    only_time: usize,
    /// And how many of the others ask for inputs that often hold.
    turns: usize,
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
            let condition = *self.rng.pick(&["", "", "", " if a", " if !b || c"]);
            let action = match (q, self.rng.below(8)) {
                (0, 4) if alone => format!("S s{condition};"),
                (0, 5) if alone => format!("R s{condition};"),
                (1, 6) if alone => "P1 n = (n + 1) % 100;".to_owned(),
                (1, 7) if alone => "P0 n = (n + 7) % 100;".to_owned(),
                (_, 0) => format!("N q{q};"),
                (_, 1) => format!("N q{q} if a;"),
                (_, 2) => format!("D {time}ms q{q}{condition};"),
                _ => format!("L {time}ms q{q}{condition};"),
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
        let count = *self.rng.pick(&[2, 2, 2, 3, 4]);
        let starts: Vec<usize> = (0..count).map(|_| self.step(false)).collect();
        self.arrow(&format!("S{from}"), &list(&starts), from);
        let mut ends: Vec<usize> = Vec::new();
        for start in starts {
            let end = match ends.last() {
                Some(beside) if self.rng.chance(40) => self.looks_beside(start, *beside),
                _ => self.next(start, false),
            };
            ends.push(end);
        }
        let join = self.step(true);
        self.arrow(&list(&ends), &format!("S{join}"), ends[0]);
        join
    }

    /// A step that is left at once where the branch beside has gone on, and one that is left by time.
    fn looks_beside(&mut self, from: usize, beside: usize) -> usize {
        let (to, end) = (self.step(false), self.step(false));
        let times = [(); 2].map(|()| self.rng.between(1, 5));
        _ = writeln!(self.arrows, "S{from} -[S{beside}.X && b || {}ms/S{from}]-> S{to};", times[0]);
        _ = writeln!(self.arrows, "S{to} -[{}ms/S{to}]-> S{end};", times[1]);
        end
    }

    fn arrow(&mut self, from: &str, to: &str, timed: usize) {
        let condition = self.condition(timed);
        _ = writeln!(self.arrows, "{from} -[{condition}]-> {to};");
    }

    /// What the transition out of a step waits for.
    fn condition(&mut self, step: usize) -> String {
        // The longest times that are readings of the clock, and longer ones, which are counted.
        let long = *self.rng.pick(&["2147483647", "2147483648", "2147483649", "4000000000"]);
        let time = *self.rng.pick(&["0", "1", "2", "3", "5", "20", "70000", long]);
        let input = *self.rng.pick(&["a", "!a", "b", "!b", "a && !b", "a || b"]);
        if self.rng.chance(self.only_time) {
            return format!("{time}ms/S{step}");
        }
        if self.rng.chance(self.turns) {
            return (*self.rng.pick(&["a", "b", "c", "a || b", "!d", "0ms/S0 || c", "!S0.X"])).to_owned();
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

fn list(steps: &[usize]) -> String {
    let steps: Vec<_> = steps.iter().map(|step| format!("S{step}")).collect();
    format!("({})", steps.join(", "))
}

/// The clock is irregular, wraps, and sometimes leaps.
fn timeline(rng: &mut Rng, cycles: usize) -> String {
    let mut text = String::new();
    let (mut on, mut clock) = ([false; 4], Clock::new(rng));
    for _ in 0..cycles {
        let changes = *rng.pick(&[0, 0, 1, 1, 2]);
        for _ in 0..if clock.is_night() { 0 } else { changes } {
            let index = rng.below(4);
            on[index] = !on[index];
        }
        let pause = *rng.pick(&[0, 1, 1, 1, 2, 2, 3, 5]);
        let now = clock.next(rng, pause);
        for (name, on) in ["a ", "b ", "c ", "d "].iter().zip(on) {
            text.push_str(if on { name } else { "" });
        }
        _ = writeln!(text, "@{now} | |");
    }
    text
}
