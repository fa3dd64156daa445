//! Random associations of steps with actions.

use super::Gen;
use super::expr::{ALL, Reads};
use super::names::{Action, Role, Ty, Value};

/// What a line acts on.
enum Target {
    Value(Value),
    Call(Action),
    Block,
}

const TIMED: [&str; 5] = ["L", "D", "SD", "DS", "SL"];

impl Gen {
    /// The lines in a step's body.
    pub(super) fn associations(&mut self) -> Vec<String> {
        let count = *self.rng.pick(&[0, 1, 1, 2, 2, 3, 4]);
        let mut lines: Vec<String> = Vec::new();
        for _ in 0..count {
            if let Some(line) = self.association().filter(|line| !lines.contains(line)) {
                lines.push(line);
            }
        }
        lines
    }

    fn association(&mut self) -> Option<String> {
        match self.target() {
            Target::Call(action) => Some(self.call_line(&action)),
            Target::Block => self.block_line(),
            Target::Value(value) => match value.role {
                Role::Controlled => Some(self.controlled(&value.name)),
                Role::Combinational => Some(self.combinational(&value.name)),
                Role::SetReset => self.may_write(&value.name, 2).then(|| self.set_reset(&value.name)),
                Role::Assigned => Some(self.assigned(&value)),
                Role::Written => self.may_write(&value.name, 1).then(|| self.written(&value)),
                Role::Input | Role::Param => None,
            },
        }
    }

    fn target(&mut self) -> Target {
        let acted = |value: &&Value| !matches!(value.role, Role::Input | Role::Param);
        let values: Vec<Value> = self.names.values.iter().filter(acted).cloned().collect();
        let actions = self.names.actions.clone();
        match self.rng.below(10) {
            0..=2 if !actions.is_empty() => Target::Call(self.rng.pick(&actions).clone()),
            3 => Target::Block,
            _ => Target::Value(self.rng.pick(&values).clone()),
        }
    }

    /// `N`, or one of the others of the dialect, with its time.
    fn qualifier(&mut self, of: &[&'static str]) -> String {
        let word = *self.rng.pick(of);
        self.note(word);
        if TIMED.contains(&word) { format!("{word} {} ", self.time()) } else { format!("{word} ") }
    }

    /// Conditions of continuous actions have no edges (IEC 60848).
    fn assignation(&self) -> Reads {
        if self.grafcet { Reads { edges: false, ..ALL } } else { ALL }
    }

    /// `q;`, `N q if c;`
    fn continuous(&mut self, target: &str, reads: Reads) -> String {
        let word = if self.rng.chance(50) { "N " } else { "" };
        self.note("N");
        if self.rng.chance(45) {
            self.note("N … if");
            let condition = self.condition(1, reads);
            return format!("{word}{target} if {condition};");
        }
        format!("{word}{target};")
    }

    fn controlled(&mut self, name: &str) -> String {
        let reads = self.assignation();
        match self.rng.below(10) {
            0..=3 => self.continuous(name, reads),
            _ if self.grafcet => format!("{}{name};", self.qualifier(&["L", "D"])),
            _ => format!("{}{name};", self.qualifier(&["S", "S", "R", "R", "R", "L", "D", "P", "SD", "DS", "SL"])),
        }
    }

    fn combinational(&mut self, name: &str) -> String {
        self.note("combinational variable");
        let index = name[1..].parse().unwrap_or_default();
        let reads = Reads { edges: false, delays: true, combinational: index };
        if self.rng.chance(20) {
            return format!("{}{name};", self.qualifier(&["L", "D"]));
        }
        self.continuous(name, reads)
    }

    fn set_reset(&mut self, name: &str) -> String {
        format!("{}{name};", self.qualifier(&["S", "R"]))
    }

    fn assigned(&mut self, value: &Value) -> String {
        self.note("assigned output");
        let reads = self.assignation();
        let assignment = format!("{} = {}", value.name, self.value(value.ty, reads));
        let word = if self.rng.chance(50) { "N " } else { "" };
        if self.rng.chance(12) {
            self.note("assigned output with a condition");
            let condition = self.condition(1, reads);
            return format!("{word}{assignment} if {condition};");
        }
        format!("{word}{assignment};")
    }

    fn written(&mut self, value: &Value) -> String {
        let is_var = self.names.lines.iter().any(|line| line.starts_with(&format!("var {}:", value.name)));
        let qualifier = match (self.grafcet, is_var, value.ty == Ty::Bool) {
            (true, ..) => self.event_qualifier(),
            (false, true, false) => {
                self.qualifier(&["P1", "P1", "P1", "P0", "P0", "N", "N", "P", "L", "D", "S", "SD", "DS", "SL"])
            }
            (false, true, true) => self.qualifier(&["P1", "P1", "P0", "N", "P", "L", "D"]),
            (false, false, false) => self.qualifier(&["P1", "P1", "P1", "P0", "P", "L", "D", "S", "SD"]),
            (false, false, true) => self.qualifier(&["P1", "P1", "P0", "P"]),
        };
        self.note("stored assignment");
        format!("{qualifier}{};", self.assignment(value))
    }

    fn assignment(&mut self, value: &Value) -> String {
        format!("{} = {}", value.name, self.value(value.ty, ALL))
    }

    /// `P1`, `P0` or `on e`
    fn event_qualifier(&mut self) -> String {
        match self.rng.below(5) {
            0 | 1 => {
                self.note("P1");
                "P1 ".to_owned()
            }
            2 => {
                self.note("P0");
                "P0 ".to_owned()
            }
            _ => {
                self.note("on");
                let edge = self.edge(ALL);
                if self.rng.chance(25) { format!("on {edge} && {} ", self.boolean(ALL)) } else { format!("on {edge} ") }
            }
        }
    }

    fn call_line(&mut self, action: &Action) -> String {
        let call = self.call(action);
        self.note("call");
        match (self.grafcet, self.rng.below(10)) {
            (_, 0..=3) => {
                let reads = self.assignation();
                self.continuous(&call, reads)
            }
            (true, _) => format!("{}{call};", self.event_qualifier()),
            (false, 4 | 5) => format!("{}{call};", self.qualifier(&["P1", "P0"])),
            (false, _) => {
                format!("{}{call};", self.qualifier(&["S", "S", "R", "R", "R", "L", "D", "P", "SD", "DS", "SL"]))
            }
        }
    }

    fn call(&mut self, action: &Action) -> String {
        let args: Vec<String> = action.params.iter().map(|ty| self.value(*ty, ALL)).collect();
        format!("{}({})", action.name, args.join(", "))
    }

    fn block_line(&mut self) -> Option<String> {
        let block = self.block()?;
        self.note("block");
        let qualifier = if self.grafcet {
            self.event_qualifier()
        } else {
            self.qualifier(&["P1", "P1", "P0", "P0", "N", "P", "L", "D", "S", "SD", "DS", "SL"])
        };
        Some(format!("{qualifier}{block}"))
    }

    /// A block that the interpreter understands.
    fn block(&mut self) -> Option<String> {
        let written = |value: &&Value| value.role == Role::Written;
        let values: Vec<Value> = self.names.values.iter().filter(written).cloned().collect();
        let first = self.rng.maybe(&values)?.clone();
        let second = self.rng.pick(&values).clone();
        if !self.may_write(&first.name, 1) || first.name != second.name && !self.may_write(&second.name, 1) {
            return None;
        }
        let one = self.statement(&first);
        let two = self.statement(&second);
        let block = match self.rng.below(4) {
            0 => format!("{{ {one} }}"),
            1 => format!("{{ {one} {two} }}"),
            2 => format!("{{ if {} {{ {one} }} else {{ {two} }} }}", self.condition(1, ALL)),
            _ => format!("{{ {one} if {} {{ {two} }} }}", self.condition(1, ALL)),
        };
        Some(self.fragment('b', block))
    }

    fn statement(&mut self, value: &Value) -> String {
        if matches!(value.ty, Ty::I16 | Ty::U8) && self.rng.chance(40) {
            let name = &value.name;
            return format!("{name} += {}; {name} %= 50;", self.rng.below(9));
        }
        format!("{};", self.assignment(value))
    }

    /// What stands after `=>` of a transition.
    pub(super) fn clearing(&mut self) -> Option<String> {
        let written = |value: &&Value| value.role == Role::Written;
        let values: Vec<Value> = self.names.values.iter().filter(written).cloned().collect();
        let actions = self.names.actions.clone();
        let mut effects = Vec::new();
        for _ in 0..self.rng.between(1, 2) {
            match self.rng.below(4) {
                0 if !actions.is_empty() => {
                    let action = self.rng.pick(&actions).clone();
                    effects.push(self.call(&action));
                }
                1 => effects.extend(self.block()),
                _ => {
                    if let Some(value) = self.rng.maybe(&values).cloned().filter(|v| self.may_write(&v.name, 1)) {
                        effects.push(self.assignment(&value));
                    }
                }
            }
        }
        (!effects.is_empty()).then(|| effects.join(", "))
    }
}
