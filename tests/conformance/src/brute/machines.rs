//! Random charts with random plants, once in the words of plants (`either`, `1s..3s/Step`) and once with these written out by hand, which brute
//! force takes.

use std::fmt::Write as _;

use super::make;
use crate::random::Rng;

/// No time in these charts is compared with a longer one, in ticks.
pub(crate) const LONGEST: u32 = 4;

/// The same twice.
pub(crate) struct Machines {
    /// As it is written for the prover.
    pub(crate) asked: String,
    /// As brute force takes it.
    pub(crate) plain: String,
}

struct Maker {
    rng: Rng,
    /// What the chart shows.
    outputs: Vec<String>,
    /// What the chart is given by nobody but its surroundings.
    inputs: Vec<String>,
    /// What the properties may name of plants.
    named: Vec<String>,
    asked: String,
    plain: String,
}

/// The chart of a number with its plants; none where it has nothing that a plant could drive.
#[must_use]
pub(crate) fn machines(number: u64, grafcet: bool) -> Option<Machines> {
    let mut rng = Rng::new(number ^ 0x9_1a_47);
    let chart = make::counting(number, grafcet, false);
    let is_property = |line: &&str| !["never ", "always ", "home "].iter().any(|word| line.starts_with(word));
    let mut lines: Vec<String> = Vec::new();
    for line in chart.lines().filter(is_property) {
        lines.push(line.to_owned());
        if line.ends_with(" {") && line.contains("step ") && !line.contains("macro") {
            let shows = ["d;", "e;"].into_iter().filter(|_| rng.chance(40));
            lines.extend(shows.map(str::to_owned));
        }
    }
    lines.splice(2..2, ["clock 1s;", "output d: bool;", "output e: bool;"].map(str::to_owned));
    let inputs: Vec<String> = lines
        .iter()
        .filter_map(|line| Some(line.strip_prefix("input ")?.strip_suffix(": bool;")?.to_owned()))
        .collect();
    let steps: Vec<String> = lines.iter().filter_map(|line| step(line)).collect();
    if inputs.is_empty() || lines.iter().any(|line| line.contains(": u8;")) {
        return None;
    }
    let count = if inputs.len() > 2 { rng.between(1, 2) } else { 1 };
    let (driven, free) = inputs.split_at(count);
    let outputs = vec!["d".to_owned(), "e".to_owned()];
    let mut maker =
        Maker { rng, outputs, inputs: free.to_vec(), named: Vec::new(), asked: String::new(), plain: String::new() };
    for (index, input) in driven.iter().enumerate() {
        maker.plant(index, input);
    }
    let end = lines.len() - 1;
    let claims = maker.claims(&steps);
    lines.splice(end..end, claims);
    let chart = lines.join("\n") + "\n";
    Some(Machines { asked: chart.clone() + &maker.asked, plain: chart + &maker.plain })
}

fn step(line: &str) -> Option<String> {
    let is_step = line.contains("step ") && !line.contains("macro");
    is_step.then(|| line.strip_suffix(" {")?.rsplit(' ').next().map(str::to_owned))?
}

impl Maker {
    fn both(&mut self, line: &str) {
        self.asked += line;
        self.asked.push('\n');
        self.plain += line;
        self.plain.push('\n');
    }

    /// A plant that drives an input.
    fn plant(&mut self, index: usize, input: &str) {
        let name = format!("P{index}");
        self.both(&format!("plant {name} {{"));
        let mut reads = self.outputs.clone();
        reads.extend(self.inputs.clone());
        reads.retain(|_| self.rng.chance(60));
        if reads.is_empty() {
            reads.push("d".to_owned());
        }
        for read in &reads {
            self.both(&format!("input {read}: bool;"));
        }
        self.both(&format!("output {input}: bool;"));
        let has_fault = self.rng.chance(50);
        let word = *self.rng.pick(&["fault", "choice"]);
        if has_fault {
            self.both(&format!("{word} odd;"));
            reads.push("odd".to_owned());
            self.named.push(format!("{name}::odd"));
        }
        let steps: Vec<String> = (0..self.rng.between(2, 4)).map(|step| format!("Q{step}")).collect();
        for (number, step) in steps.iter().enumerate() {
            let initial = if number == 0 { "initial " } else { "" };
            let acts = match self.rng.below(4) {
                0 => String::new(),
                1 if has_fault => format!(" {{ N {input} if !odd; }}"),
                _ => format!(" {{ {input}; }}"),
            };
            self.both(&match acts.as_str() {
                "" => format!("{initial}step {step};"),
                acts => format!("{initial}step {step}{acts}"),
            });
            self.named.push(format!("{name}::{step}.X"));
        }
        // Not more than three choices: each doubles what brute force goes through.
        let mut choices = 3 - usize::from(has_fault);
        for number in 0..steps.len() {
            let next = &steps[(number + 1) % steps.len()];
            self.arrow((&steps[number], next), &steps, &reads, &mut choices);
            if self.rng.chance(35) {
                let other = self.rng.pick(&steps).clone();
                self.arrow((&steps[number], &other), &steps, &reads, &mut choices);
            }
        }
        self.both("}");
    }

    fn arrow(&mut self, (from, to): (&str, &str), steps: &[String], reads: &[String], choices: &mut usize) {
        let condition = self.of(reads);
        let other = self.rng.pick(steps).clone();
        match self.rng.below(5) {
            0 if *choices > 0 && other != to => {
                *choices -= 1;
                let pick = format!("pick{choices}");
                _ = writeln!(self.asked, "either {from} -[{condition}]-> ({to} or {other});");
                _ = writeln!(
                    self.plain,
                    "choice {pick};\n{from} -[!{pick} && ({condition})]-> {to};\n{from} -[{pick} && ({condition})]-> {other};"
                );
            }
            1 | 2 if *choices > 0 => {
                *choices -= 1;
                let soon = format!("soon{choices}");
                let (low, high) = *self.rng.pick(&[(1, 2), (1, 3), (2, 3), (1, 1)]);
                _ = writeln!(self.asked, "{from} -[{low}s..{high}s/{from} && ({condition})]-> {to};");
                _ = writeln!(
                    self.plain,
                    "choice {soon};\n{from} -[({soon} && {from}.T >= {low}s || {from}.T >= {high}s) && ({condition})]-> {to};"
                );
            }
            3 => {
                let time = self.rng.between(1, 3);
                self.both(&format!("{from} -[{time}s/{from} && ({condition})]-> {to};"));
            }
            _ => self.both(&format!("{from} -[{condition}]-> {to};")),
        }
    }

    fn of(&mut self, reads: &[String]) -> String {
        let mut one = || {
            let not = if self.rng.chance(40) { "!" } else { "" };
            format!("{not}{}", self.rng.pick(reads))
        };
        let (one, other) = (one(), one());
        match self.rng.below(5) {
            0 => format!("{one} && {other}"),
            1 => format!("{one} || {other}"),
            2 => "true".to_owned(),
            _ => one,
        }
    }

    /// Properties of the chart and its plants, and what is assumed of them.
    fn claims(&mut self, steps: &[String]) -> Vec<String> {
        let mut lines = Vec::new();
        for _ in 0..5 {
            let (one, other, third) = (self.claimed(steps), self.claimed(steps), self.claimed(steps));
            lines.push(match self.rng.below(8) {
                0 | 1 => format!("never {one} && {other};"),
                2 => format!("always {one} => {other} || {third};"),
                3 => format!("never {one} && {other} && {third};"),
                4 => format!("({one}) leads_to ({other});"),
                5 => format!("({one}) before ({other});"),
                _ => format!("({one}) leads_to ({other} || {third}) within {}s;", self.rng.between(1, 3)),
            });
        }
        if self.rng.chance(60) {
            lines.push(format!("assume cycle within {}s;", self.rng.between(1, 2)));
        }
        if let Some(named) = self.rng.maybe(&self.named).filter(|name| name.contains("odd")) {
            lines.push(format!("assume never {named};"));
        }
        if let Some(input) = self.inputs.first().cloned().filter(|_| self.rng.chance(30)) {
            lines.push(format!("assume often {input};"));
            lines.push(format!("assume often !{input};"));
        }
        if self.rng.chance(40) {
            let (one, answer) = (self.claimed(steps), self.outside());
            lines.push(match self.rng.below(4) {
                0 => format!("assume ({one}) before ({answer});"),
                1 => format!("assume ({one}) leads_to ({answer});"),
                _ => format!("assume ({one}) leads_to ({answer}) within {}s;", self.rng.between(1, 3)),
            });
        }
        lines
    }

    /// What is no doing of the chart.
    fn outside(&mut self) -> String {
        let not = if self.rng.chance(30) { "!" } else { "" };
        let all: Vec<&String> = self.inputs.iter().chain(&self.named).collect();
        format!("{not}{}", self.rng.pick(&all))
    }

    fn claimed(&mut self, steps: &[String]) -> String {
        let not = if self.rng.chance(30) { "!" } else { "" };
        match self.rng.below(8) {
            0..=2 => format!("{not}{}", self.rng.pick(&self.named)),
            3 | 4 => format!("{not}{}.X", self.rng.pick(steps)),
            5 => format!("n == {}", self.rng.below(4)),
            _ => format!("{not}{}", self.rng.pick(&self.outputs)),
        }
    }
}
