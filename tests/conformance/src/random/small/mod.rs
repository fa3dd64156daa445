//! Small charts, each about one thing, so that nothing else covers a mistake: with one clock nothing else wakes the sleeper,
//! with one target nothing else changes.

mod actions;
mod clocks;
mod counts;
mod fragments;
mod values;
mod words;

use std::fmt::Write as _;

use super::clock::Clock;
use super::{Random, Rng};

/// What such a chart is about.
pub(super) struct Kind {
    pub(super) name: &'static str,
    draw: fn(&mut Sketch),
    pace: Pace,
}

/// How the clock of its timeline goes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pace {
    /// A tick or a few, and now and then long enough for all its times.
    Short,
    /// About the times that two bytes do not hold.
    Long,
}

/// A new kind is a row.
pub(super) const KINDS: [Kind; 14] = [
    Kind { name: "small: a time compared", draw: clocks::compared, pace: Pace::Short },
    Kind { name: "small: a self-loop beside branches", draw: clocks::beside, pace: Pace::Short },
    Kind { name: "small: long times in two branches", draw: clocks::long, pace: Pace::Long },
    Kind { name: "small: a delay", draw: clocks::delay, pace: Pace::Short },
    Kind { name: "small: a timed action", draw: clocks::action, pace: Pace::Short },
    Kind { name: "small: blinking", draw: clocks::blinking, pace: Pace::Short },
    Kind { name: "small: fragments of macros", draw: fragments::operands, pace: Pace::Short },
    Kind { name: "small: places that conditions test", draw: actions::places, pace: Pace::Short },
    Kind { name: "small: named conditions", draw: words::named, pace: Pace::Short },
    Kind { name: "small: from any step", draw: words::any, pace: Pace::Short },
    Kind { name: "small: an enum", draw: words::modes, pace: Pace::Short },
    Kind { name: "small: edges in actions", draw: actions::edges, pace: Pace::Short },
    Kind { name: "small: calls that steps share", draw: actions::calls, pace: Pace::Short },
    Kind { name: "small: values assigned", draw: values::assigned, pace: Pace::Short },
];

const RULES: &str = "several_initial_steps unreachable_step dead_transition stuck_join deadlock never_true always_true \
    conflicting_values set_without_reset reset_without_set unused_input undriven_output unused_variable unused_action \
    unused_param shadowed_branch overlapping_branches timed_contention unsafe_step unused_let";

/// A chart that is being drawn: inputs `a`, `b`, `c`, a param `t` and outputs `q0` to `q2` are there.
struct Sketch {
    rng: Rng,
    grafcet: bool,
    declarations: String,
    steps: String,
    arrows: String,
}

/// A chart of a dialect.
pub(super) fn chart(seed: u64, turn: u64, grafcet: bool, cycles: usize) -> Random {
    let mut rng = Rng::new(seed);
    let kind = &KINDS[usize::try_from(turn % KINDS.len() as u64).unwrap_or_default()];
    let empty = String::new;
    let init = *rng.pick(&[0, 2, 5]);
    let mut sketch = Sketch { rng, grafcet, declarations: empty(), steps: empty(), arrows: empty() };
    (kind.draw)(&mut sketch);
    let allowed: Vec<String> = RULES.split_whitespace().map(|rule| format!("grafcet::{rule}")).collect();
    let dialect = if grafcet { "grafcet" } else { "sfc" };
    // What the timeline sets is in them.
    let range = ["", " in 0ms..=40ms", " in 0s..41ms"][usize::try_from(seed % 3).unwrap_or_default()];
    let text = format!(
        "{dialect} C {{\n#![allow({})]\ninput a, b, c: bool;\nparam t: time{range} = {init}ms;\noutput q0, q1, q2: bool;\n{}{}{}}}\n",
        allowed.join(", "),
        sketch.declarations,
        sketch.steps,
        sketch.arrows,
    );
    let modes = sketch.declarations.contains("mode: Mode");
    let timeline = timeline(&mut sketch.rng, kind.pace, modes, cycles);
    Random { chart: text, timeline, features: std::iter::once(kind.name).collect() }
}

impl Sketch {
    /// A line of declarations.
    fn declare(&mut self, line: &str) {
        _ = writeln!(self.declarations, "{line}");
    }

    /// A step with the lines of its body.
    fn step(&mut self, name: &str, lines: &[String]) {
        let initial = if self.steps.is_empty() { "initial " } else { "" };
        let lines: String = lines.iter().map(|line| format!("{line}\n")).collect();
        _ = writeln!(self.steps, "{initial}step {name} {{\n{lines}}}");
    }

    fn arrow(&mut self, from: &str, condition: &str, to: &str) {
        _ = writeln!(self.arrows, "{from} -[{condition}]-> {to};");
    }

    /// One of them, to be formatted.
    fn word(&mut self, of: &[&'static str]) -> &'static str {
        of[self.rng.below(of.len())]
    }

    /// A time, mostly a literal.
    fn time(&mut self) -> &'static str {
        self.word(&["1ms", "2ms", "3ms", "5ms", "8ms", "12ms", "t"])
    }
}

/// Calm enough for times to pass while nothing else happens.
fn timeline(rng: &mut Rng, pace: Pace, modes: bool, cycles: usize) -> String {
    let mut text = String::new();
    let mut mode = 0;
    let (mut on, mut clock) = ([false; 3], Clock::new(rng));
    for _ in 0..cycles {
        match rng.below(100) {
            0 => text.push_str("init\n"),
            1 => _ = writeln!(text, "params t={}", rng.pick(&[0, 1, 2, 5, 9, 40])),
            _ => {}
        }
        let changes = *rng.pick(&[0, 0, 1, 1, 2]);
        for _ in 0..if clock.is_night() { 0 } else { changes } {
            let index = rng.below(3);
            on[index] = !on[index];
        }
        let short = *rng.pick(&[0, 1, 1, 1, 2, 2, 3, 4, 5, 7, 9, 13, 30]);
        let long = *rng.pick(&[1, 2, 535, 1000, 4464, 34_464, 65_400, 65_534, 65_535, 65_536, 65_537, 70_000, 131_072]);
        let pause = if pace == Pace::Long && rng.chance(40) { long } else { short };
        let now = clock.next(rng, pause);
        for (name, on) in ["a ", "b ", "c "].iter().zip(on) {
            text.push_str(if on { name } else { "" });
        }
        if modes {
            mode = if rng.chance(30) { rng.below(3) } else { mode };
            _ = write!(text, "mode={mode} ");
        }
        _ = writeln!(text, "@{now} | |");
    }
    text
}
