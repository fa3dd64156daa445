//! What is decided by reduction against brute force, on random charts that are well nested.

use std::fmt::Write as _;

use grafcet_conformance::brute::make::allowed;
use grafcet_conformance::brute::run::{Outcome, chart};
use grafcet_conformance::random::Rng;

const INPUTS: [&str; 4] = ["a", "b", "c", "d"];

/// A chart that is being drawn.
struct Drawing {
    rng: Rng,
    /// Each condition can be waited for, and is about another input than the one before.
    calm: bool,
    /// Some steps have to be left in time, or not too soon.
    timed: bool,
    number: usize,
    steps: usize,
    text: String,
}

impl Drawing {
    fn step(&mut self) -> String {
        self.steps += 1;
        _ = writeln!(self.text, "step S{};", self.steps);
        format!("S{}", self.steps)
    }

    fn arrow(&mut self, from: &str, condition: &str, to: &str) {
        let chance = if self.timed && !from.starts_with('(') { self.rng.below(4) } else { 3 };
        let condition = match chance {
            0 => format!("({condition}) && 5s/{from}"),
            1 => format!("({condition}) && {from}.T < 5s"),
            2 => format!("({condition}) || !(5s/{from})"),
            _ => condition.to_owned(),
        };
        _ = writeln!(self.text, "{from} -[{condition}]-> {to};");
    }

    /// A condition of a transition that leaves its steps alone.
    fn condition(&mut self, inputs: &[&str]) -> String {
        if self.calm {
            return self.next(inputs).to_owned();
        }
        let (one, other) = (*self.rng.pick(inputs), *self.rng.pick(inputs));
        match self.rng.below(8) {
            0 => "true".to_owned(),
            1 => format!("rising({one})"),
            2 => format!("falling({one} && {other})"),
            3 => format!("!{one}"),
            4 => format!("{one} && !{other}"),
            _ => one.to_owned(),
        }
    }

    fn next<'i>(&mut self, inputs: &[&'i str]) -> &'i str {
        self.number += 1;
        inputs[self.number % inputs.len()]
    }

    /// A piece of a chart: its first and its last step.
    fn block(&mut self, depth: usize, inputs: &[&str]) -> (String, String) {
        let kind = if depth == 0 { 0 } else { self.rng.between(1, 4) };
        match kind {
            0 => {
                let step = self.step();
                (step.clone(), step)
            }
            1 => {
                let (a, b) = (self.block(depth - 1, inputs), self.block(depth - 1, inputs));
                let condition = self.condition(inputs);
                self.arrow(&a.1, &condition, &b.0);
                (a.0, b.1)
            }
            2 => self.parallel(depth, inputs),
            3 => {
                let (first, last) = (self.step(), self.step());
                let (one, other) = (self.next(inputs), self.next(inputs));
                let both = [format!("{one} && {other}"), format!("{one} && !{other}")];
                for condition in if self.calm { both } else { [one.to_owned(), format!("!{one}")] } {
                    let branch = self.block(depth - 1, inputs);
                    self.arrow(&first, &condition, &branch.0);
                    let condition = self.condition(inputs);
                    self.arrow(&branch.1, &condition, &last);
                }
                (first, last)
            }
            _ => {
                let (first, last) = self.block(depth - 1, inputs);
                let (input, end) = (self.next(inputs), self.step());
                self.arrow(&last, input, &first);
                let rest = self.condition(inputs);
                self.arrow(&last, &format!("!{input} && {rest}"), &end);
                (first, end)
            }
        }
    }

    fn parallel(&mut self, depth: usize, inputs: &[&str]) -> (String, String) {
        let (first, last) = (self.step(), self.step());
        let own = inputs.len() > 3 && (self.calm || self.rng.chance(60));
        let (left, right) = if own { inputs.split_at(inputs.len() / 2) } else { (inputs, inputs) };
        let (a, b) = (self.block(depth - 1, left), self.block(depth - 1, right));
        let (fork, join) = (self.condition(inputs), self.condition(inputs));
        self.arrow(&first, &fork, &format!("({}, {})", a.0, b.0));
        self.arrow(&format!("({}, {})", a.1, b.1), &join, &last);
        (first, last)
    }
}

fn drawn(seed: u64, dialect: &str, timed: bool) -> String {
    let mut drawing =
        Drawing { rng: Rng::new(seed), calm: seed % 2 == 0, timed, number: 0, steps: 0, text: String::new() };
    let depth = drawing.rng.between(1, 3);
    let (first, last) = drawing.block(depth, &INPUTS);
    let (start, end) = (drawing.condition(&INPUTS), drawing.condition(&INPUTS));
    drawing.arrow("Start", &start, &first);
    drawing.arrow(&last, &end, "Start");
    let Drawing { text, .. } = drawing;
    format!("{dialect} Chart {{\n{}\ninput {}: bool;\ninitial step Start;\n{text}}}\n", allowed(), INPUTS.join(", "))
}

/// No difference; and so many ways back are proved, and of so many charts the structure tells all.
fn agree(dialect: &str, timed: bool, ways: usize, told: usize) {
    let (mut differences, mut nested) = (String::new(), [0; 2]);
    for seed in 0..150 {
        let text = drawn(seed, dialect, timed);
        let Outcome::Compared(comparison) = chart(&text, 1500).expect("a chart that the interpreter understands")
        else {
            continue;
        };
        nested.iter_mut().zip(comparison.nested).for_each(|(all, own)| *all += own);
        for difference in comparison.differences {
            _ = writeln!(differences, "chart {seed}: {}: {}\n{text}", difference.kind, difference.text);
        }
    }
    assert!(differences.is_empty(), "{differences}");
    assert!(nested[0] >= ways && nested[1] >= told, "{nested:?}");
}

#[test]
fn sfc() {
    agree("sfc", false, 100, 20);
}

#[test]
fn grafcet() {
    // Inputs that lead on at once leave little to be said.
    agree("grafcet", false, 20, 4);
}

#[test]
fn timed_sfc() {
    agree("sfc", true, 40, 1);
}

#[test]
fn timed_grafcet() {
    agree("grafcet", true, 20, 1);
}
