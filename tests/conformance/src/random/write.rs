//! The text of a random chart: one declaration, association or transition a line, so that a line can be left out.

use std::fmt::Write as _;

use super::Gen;
use super::expr::ALL;
use super::structure::{Arrow, Inner, Part, Step};

/// Random charts are not sensible ones.
const ALLOWED: [&str; 20] = [
    "several_initial_steps",
    "unreachable_step",
    "dead_transition",
    "unsafe_step",
    "stuck_join",
    "deadlock",
    "never_true",
    "always_true",
    "shadowed_branch",
    "overlapping_branches",
    "level_source_transition",
    "conflicting_values",
    "set_without_reset",
    "reset_without_set",
    "timed_contention",
    "unused_input",
    "undriven_output",
    "unused_variable",
    "unused_action",
    "unused_let",
];

impl Gen {
    pub(super) fn write(&mut self, parts: &[Part]) -> String {
        for part in parts {
            self.collect(part, part.name.as_deref());
        }
        let mut lines = vec![format!("{} C {{", if self.grafcet { "grafcet" } else { "sfc" })];
        let allowed = ALLOWED.map(|rule| format!("grafcet::{rule}")).join(", ");
        lines.push(format!("#![allow({allowed}, grafcet::unused_param)]"));
        for line in self.names.lines.clone() {
            lines.push(self.declaration(line));
        }
        lines.append(&mut self.name_conditions());
        let long = parts.iter().any(|part| part.steps.len() >= 20);
        if self.rng.chance(if long { 50 } else { 10 }) {
            self.note("optimize size");
            lines.push("optimize size;".to_owned());
        }
        if self.rng.chance(14) {
            self.note("encoding flags");
            lines.push("encoding flags;".to_owned());
        }
        if self.grafcet && self.rng.chance(15) {
            self.note("max_evolutions");
            lines.push(format!("max_evolutions {};", self.rng.between(1, 8)));
        }
        for part in parts {
            self.part(part, &mut lines);
        }
        lines.push("}".to_owned());
        let mut text = String::new();
        for line in lines {
            let name = line.strip_suffix(" {").and_then(|line| line.rsplit_once("step ")).map(|(_, name)| name);
            match name.and_then(|name| self.late.get(name)) {
                Some(time) => _ = writeln!(text, "{} within {time} {{", line.trim_end_matches(" {")),
                None => _ = writeln!(text, "{line}"),
            }
        }
        text
    }

    /// A declaration, its type now and then a fragment.
    fn declaration(&mut self, line: String) -> String {
        let Some((before, ty)) = line.split_once(": ") else { return line };
        let end = ty.find([' ', ';']).unwrap_or(ty.len());
        if !self.fragments || !["bool", "i16", "u8"].contains(&&ty[..end]) {
            return line;
        }
        format!("{before}: {}{}", self.fragment('t', ty[..end].to_owned()), &ty[end..])
    }

    fn collect(&mut self, part: &Part, partial: Option<&str>) {
        for step in &part.steps {
            self.steps.push((partial.map(str::to_owned), step.name.clone()));
            if !matches!(step.inner, Inner::Macro(_)) {
                self.real.insert(step.name.clone());
            }
            match &step.inner {
                Inner::Nothing => {}
                Inner::Macro(body) => self.collect(body, partial),
                Inner::Enclosed(parts) => parts.iter().for_each(|part| self.collect(part, part.name.as_deref())),
            }
        }
    }

    fn part(&mut self, part: &Part, lines: &mut Vec<String>) {
        if let Some(name) = &part.name {
            lines.push(format!("partial {name} {{"));
        }
        self.contents(part, lines);
        if self.rng.chance(15) {
            lines.push(self.any(part));
        }
        if part.name.is_some() {
            lines.push("}".to_owned());
        }
    }

    fn contents(&mut self, part: &Part, lines: &mut Vec<String>) {
        part.steps.iter().for_each(|step| self.step(step, lines));
        part.arrows.iter().for_each(|arrow| lines.push(self.arrow(arrow)));
    }

    /// A transition from every step of a partial grafcet, or from all but one.
    fn any(&mut self, part: &Part) -> String {
        self.note("any");
        let names: Vec<String> = part.steps.iter().map(|step| step.name.clone()).collect();
        let except = if self.rng.chance(30) { format!(" except {}", self.rng.pick(&names)) } else { String::new() };
        let to = self.rng.pick(&names).clone();
        let edge = self.edge(ALL);
        let condition = if self.rng.chance(30) { self.condition(1, ALL) } else { edge };
        if part.arrows.iter().any(|arrow| arrow.to.len() > 1) {
            self.note("any beside parallel branches");
        }
        if part.steps.len() < 3 { String::new() } else { format!("any{except} -[{condition}]-> {to};") }
    }

    fn step(&mut self, step: &Step, lines: &mut Vec<String>) {
        lines.push(format!("{}step {} {{", step.words, step.name));
        match &step.inner {
            Inner::Macro(body) => self.contents(body, lines),
            Inner::Nothing => {}
            Inner::Enclosed(parts) => parts.iter().for_each(|part| self.part(part, lines)),
        }
        if !matches!(step.inner, Inner::Macro(_)) {
            lines.extend(step.forces.iter().cloned());
            self.of_one = true;
            lines.append(&mut self.associations());
            self.of_one = false;
        }
        lines.push("}".to_owned());
    }

    fn arrow(&mut self, arrow: &Arrow) -> String {
        self.of_one = arrow.from.len() == 1;
        let condition = match (&arrow.guard, arrow.from.is_empty()) {
            (_, true) => self.edge(ALL),
            (Some(guard), _) if arrow.whole || self.rng.chance(60) => guard.clone(),
            (Some(guard), _) => format!("{guard} && {}", self.condition(1, ALL)),
            (None, _) if self.rng.chance(if self.grafcet { 4 } else { 12 }) => "true".to_owned(),
            (None, _) => self.condition(2, ALL),
        };
        let name = if self.rng.chance(5) { format!("t{}: ", self.rng.below(10_000)) } else { String::new() };
        let mut clearing = String::new();
        if self.grafcet && !arrow.whole && self.rng.chance(15) {
            if let Some(effects) = self.clearing() {
                self.note("action on clearing");
                clearing = format!(" => {effects}");
            }
        }
        self.of_one = false;
        format!("{} -[{name}{condition}{clearing}]-> {};", list(&arrow.from), list(&arrow.to))
    }
}

fn list(steps: &[String]) -> String {
    match steps {
        [step] => step.clone(),
        steps => format!("({})", steps.join(", ")),
    }
}
