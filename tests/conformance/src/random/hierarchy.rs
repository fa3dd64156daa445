//! Machines of several partial grafcets one above another, whose levels can be decided from the top downwards: branches
//! exclude each other, each partial grafcet has one above it, and stored actions read nothing that changes with them.

use std::fmt::Write as _;

use super::{Random, Rng};

/// A chart in `grafcet`.
#[must_use]
pub(super) fn chart(seed: u64, cycles: usize) -> Random {
    let mut machine =
        Machine { rng: Rng::new(seed), steps: Vec::new(), partials: 0, enclosed: Vec::new(), edges: false };
    machine.edges = machine.rng.chance(60);
    let rules = "several_initial_steps unreachable_step dead_transition stuck_join deadlock never_true always_true \
                 conflicting_values set_without_reset reset_without_set unused_input undriven_output";
    let allowed: Vec<_> = rules.split(' ').map(|rule| format!("grafcet::{rule}")).collect();
    let mut text = format!("grafcet C {{\n#![allow({})]\ninput a, b, c, d: bool;\n", allowed.join(", "));
    let trees: String = (0..machine.rng.between(1, 2)).map(|_| machine.tree()).collect();
    let trees = machine.look_elsewhere(trees);
    text.push_str("output q0, q1, q2: bool;\n");
    for partial in 0..machine.partials {
        _ = writeln!(text, "output s{partial}: bool;\noutput n{partial}, m{partial}: u8;");
    }
    _ = writeln!(text, "{trees}}}");
    let timeline = timeline(&mut machine.rng, cycles);
    Random { chart: text, timeline, features: std::iter::once("machine of partial grafcets").collect() }
}

struct Machine {
    rng: Rng,
    /// The steps drawn so far, with their partial grafcets.
    steps: Vec<(usize, usize)>,
    partials: usize,
    /// The partial grafcets within a step.
    enclosed: Vec<usize>,
    /// Without edges a search may have no end, as far as the compiler knows.
    edges: bool,
}

/// A partial grafcet in the making.
struct Body {
    partial: usize,
    text: String,
    arrows: Vec<(Vec<usize>, Vec<usize>, Option<String>)>,
    /// How deep there may be enclosures.
    depth: usize,
    /// What its steps force.
    slaves: Vec<(usize, Vec<usize>)>,
}

impl Machine {
    /// A partial grafcet with those it forces.
    fn tree(&mut self) -> String {
        let mut text = String::new();
        let mut slaves = Vec::new();
        for _ in 0..self.rng.below(3) {
            let depth = usize::from(self.rng.chance(25));
            let (partial, steps, slave) = self.partial(depth, false, Vec::new());
            text.push_str(&slave);
            slaves.push((partial, steps));
        }
        let depth = if slaves.is_empty() { 2 } else { 1 };
        text.push_str(&self.partial(depth, false, slaves).2);
        text
    }

    /// A partial grafcet, its own steps, and its text.
    fn partial(
        &mut self,
        depth: usize,
        enclosed: bool,
        slaves: Vec<(usize, Vec<usize>)>,
    ) -> (usize, Vec<usize>, String) {
        let partial = self.partials;
        self.partials += 1;
        if enclosed {
            self.enclosed.push(partial);
        }
        let from = self.steps.len();
        let mut body = Body { partial, text: String::new(), arrows: Vec::new(), depth, slaves };
        let first = self.step(&mut body, if enclosed { "initial linked " } else { "initial " }, true);
        let mut last = first;
        for _ in 0..self.rng.between(1, 3) {
            last = match self.rng.below(4) {
                0 | 1 => self.next(&mut body, last, true),
                2 => self.selection(&mut body, last),
                _ => self.parallel(&mut body, last),
            };
        }
        body.arrows.push((vec![last], vec![first], None));
        let mut text = format!("partial G{partial} {{\n{}", body.text);
        for (from, to, guard) in &body.arrows {
            let condition = guard.clone().unwrap_or_else(|| self.condition(partial, from[0]));
            _ = writeln!(text, "{} -[{condition}]-> {};", list(from), list(to));
        }
        if self.rng.chance(25) {
            // Some step is left for it.
            let own = self.steps[from..].iter().filter(|(of, _)| *of == partial).count();
            let except = if own > 2 && self.rng.chance(30) { format!(" except S{last}") } else { String::new() };
            let condition = *self.rng.pick(&["a && b && c", "rising(d)", "rising(a) && b", "falling(c)"]);
            _ = writeln!(text, "any{except} -[{condition}]-> S{};", self.rng.pick(&[first, first, last]));
        }
        text.push_str("}\n");
        let own = self.steps.iter().enumerate().skip(from).filter(|(_, (of, _))| *of == partial);
        (partial, own.map(|(index, _)| index).collect(), text)
    }

    /// A step; `alone` where no other one of its partial grafcet is active beside it.
    fn step(&mut self, body: &mut Body, words: &str, alone: bool) -> usize {
        let name = self.steps.len();
        self.steps.push((body.partial, name));
        let mut lines = String::new();
        if body.depth > 0 && self.rng.chance(35) {
            lines.push_str(&self.partial(body.depth - 1, true, Vec::new()).2);
        }
        let enclosing = if lines.is_empty() { "" } else { "enclosing " };
        let forces = alone && self.rng.chance(40);
        for (slave, steps) in &body.slaves {
            if forces && self.rng.chance(85) {
                let order = match self.rng.below(5) {
                    0 => String::new(),
                    1 => "*".to_owned(),
                    2 => "INIT".to_owned(),
                    _ => format!("S{}", self.rng.pick(steps)),
                };
                _ = writeln!(lines, "force G{slave} {{{order}}};");
            }
        }
        for _ in 0..self.rng.below(3) {
            let line = self.action(body.partial, alone);
            if !lines.contains(line[..line.len() - 1].split(' ').nth(1).unwrap_or("?")) {
                _ = writeln!(lines, "{line}");
            }
        }
        _ = writeln!(body.text, "{words}{enclosing}step S{name} {{\n{lines}}}");
        name
    }

    /// Places are mostly the partial grafcet's own: where two actions could write one in the same evolution, the compiler
    /// refuses the chart.
    fn action(&mut self, partial: usize, alone: bool) -> String {
        let own = if self.rng.chance(95) { partial } else { self.rng.below(self.partials) };
        let condition = *self.rng.pick(&["", "", " if a", " if !b && c"]);
        match self.rng.below(if alone { 9 } else { 2 }) {
            0 | 1 => format!("N q{}{condition};", self.rng.below(3)),
            2 | 3 => format!("S s{own}{condition};"),
            4 | 5 => format!("R s{own}{condition};"),
            6 => format!("P0 m{own} = (m{own} + 7) % 100;"),
            _ => format!("P1 n{own} = (n{own} + 1) % 100;"),
        }
    }

    fn next(&mut self, body: &mut Body, from: usize, alone: bool) -> usize {
        let to = self.step(body, "", alone);
        body.arrows.push((vec![from], vec![to], None));
        to
    }

    fn selection(&mut self, body: &mut Body, from: usize) -> usize {
        let (left, right) = (self.step(body, "", true), self.step(body, "", true));
        body.arrows.push((vec![from], vec![left], Some("a && b".to_owned())));
        body.arrows.push((vec![from], vec![right], Some("!a && c".to_owned())));
        let join = self.next(body, left, true);
        body.arrows.push((vec![right], vec![join], None));
        join
    }

    fn parallel(&mut self, body: &mut Body, from: usize) -> usize {
        let starts: Vec<usize> = (0..2).map(|_| self.step(body, "", false)).collect();
        body.arrows.push((vec![from], starts.clone(), None));
        let ends: Vec<usize> =
            starts.into_iter().map(|s| if self.rng.chance(60) { self.next(body, s, false) } else { s }).collect();
        if self.rng.chance(40) {
            return self.joins(body, ends);
        }
        let join = self.step(body, "", true);
        body.arrows.push((ends, vec![join], None));
        join
    }

    /// Branches that end in one of two ways, each of which waits for a step elsewhere.
    fn joins(&mut self, body: &mut Body, ends: Vec<usize>) -> usize {
        let (left, right) = (self.step(body, "", true), self.step(body, "", true));
        let look = look(body.partial);
        body.arrows.push((ends.clone(), vec![left], Some(format!("a && {look}"))));
        body.arrows.push((ends, vec![right], Some(format!("!a && {look}"))));
        let next = self.next(body, left, true);
        body.arrows.push((vec![right], vec![next], None));
        next
    }

    /// Puts a step of another partial grafcet into each place of the text that waits for one, or where there is none an input. What is
    /// enclosed is asked for often: it can have been left in the same evolution.
    fn look_elsewhere(&mut self, mut text: String) -> String {
        for partial in 0..self.partials {
            let elsewhere: Vec<_> = self.steps.iter().filter(|(of, _)| *of != partial).copied().collect();
            let enclosed: Vec<_> = elsewhere.iter().filter(|(of, _)| self.enclosed.contains(of)).copied().collect();
            let place = look(partial);
            while text.contains(&place) {
                let all = if enclosed.is_empty() || self.rng.chance(30) { &elsewhere } else { &enclosed };
                let step = if all.is_empty() { None } else { Some(*self.rng.pick(all)) };
                let found = step.map_or_else(|| "b".to_owned(), |(of, step)| format!("G{of}::S{step}.X"));
                text = text.replacen(&place, &found, 1);
            }
        }
        text
    }

    fn condition(&mut self, partial: usize, from: usize) -> String {
        let (of, other) = *self.rng.pick(&self.steps);
        let other = if of == partial { format!("S{other}.X") } else { format!("G{of}::S{other}.X") };
        let kinds = if self.edges { 14 } else { 6 };
        match self.rng.below(kinds) {
            0 if self.edges => "true".to_owned(),
            1 => format!("{other} && a"),
            2 => format!("2ms/S{from}"),
            6 | 7 => "rising(a)".to_owned(),
            8 | 9 => "falling(b)".to_owned(),
            10 => "rising(c) && !d".to_owned(),
            11 => format!("!{other} && b"),
            _ => (*self.rng.pick(&["a", "b", "c", "!d", "a && !b", "c || d"])).to_owned(),
        }
    }
}

/// What a condition of this partial grafcet has in place of a step of another one, which may not be drawn yet.
fn look(partial: usize) -> String {
    format!("<elsewhere than G{partial}>")
}

fn list(steps: &[usize]) -> String {
    let names: Vec<String> = steps.iter().map(|step| format!("S{step}")).collect();
    if names.len() == 1 { names.concat() } else { format!("({})", names.join(", ")) }
}

fn timeline(rng: &mut Rng, cycles: usize) -> String {
    let mut text = String::new();
    let (mut on, mut now) = ([false; 4], 0_u32);
    for _ in 0..cycles {
        for _ in 0..*rng.pick(&[0, 1, 1, 2, 3]) {
            let index = rng.below(4);
            on[index] = !on[index];
        }
        now = now.wrapping_add(u32::try_from(rng.below(4)).unwrap_or_default());
        for (name, on) in ["a ", "b ", "c ", "d "].iter().zip(on) {
            text.push_str(if on { name } else { "" });
        }
        _ = writeln!(text, "@{now} | |");
    }
    text
}
