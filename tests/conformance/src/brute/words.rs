//! Conditions and actions of a small random chart.

use super::draw::Arrow;
use super::hierarchy::{Body, Step};
use super::make::Maker;

/// What can be named.
pub(super) struct Words {
    inputs: Vec<String>,
    /// `level: u8`
    number: bool,
    vars: Vec<Var>,
    steps: Vec<String>,
    edges: bool,
}

/// How a boolean is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    /// S and R; in `sfc` N too.
    Stored,
    /// P1, P0 and events with values.
    Assigned,
    /// `grafcet`: N.
    Combinational,
}

struct Var {
    name: String,
    mode: Mode,
    output: bool,
    initial: bool,
}

impl Words {
    pub(super) fn new(maker: &mut Maker, bodies: &[Body]) -> Self {
        let rng = &mut maker.rng;
        let inputs = (0..*rng.pick(&[2, 2, 3, 3, 3, 4, 5])).map(|index| "abcdef"[index..=index].to_owned()).collect();
        let mut vars = Vec::new();
        for index in 0..*rng.pick(&[0, 0, 0, 1, 1, 2]) {
            let mode = match rng.below(5) {
                0 | 1 => Mode::Stored,
                2 if maker.grafcet => Mode::Combinational,
                _ => Mode::Assigned,
            };
            let output = mode == Mode::Stored && rng.chance(30);
            let initial = mode != Mode::Combinational && rng.chance(15) && (mode == Mode::Assigned || maker.grafcet);
            vars.push(Var { name: format!("v{index}"), mode, output, initial });
        }
        let mut steps = Vec::new();
        for body in bodies {
            collect(body, &mut steps);
        }
        Self { inputs, number: rng.chance(20), vars, steps, edges: rng.chance(40) }
    }

    pub(super) fn declarations(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.inputs.iter().map(|input| format!("input {input}: bool;")).collect();
        if self.number {
            lines.push("input level: u8;".to_owned());
        }
        for var in &self.vars {
            let (word, initial) = (if var.output { "output" } else { "var" }, if var.initial { " = true" } else { "" });
            lines.push(format!("{word} {}: bool{initial};", var.name));
        }
        lines
    }

    pub(super) fn condition(&self, maker: &mut Maker, arrow: &Arrow) -> String {
        match maker.rng.below(20) {
            0 | 1 => "true".to_owned(),
            // An event for a source transition.
            2..=19 if arrow.from.is_empty() => {
                format!("rising({}) && {}", maker.rng.pick(&self.inputs), self.expr(maker, 1, self.vars.len()))
            }
            _ => {
                let depth = *maker.rng.pick(&[0, 0, 0, 1, 1, 2]);
                self.expr(maker, depth, self.vars.len())
            }
        }
    }

    /// An expression that may read the first so many variables.
    fn expr(&self, maker: &mut Maker, depth: usize, vars: usize) -> String {
        if depth > 0 {
            let (left, right) = (self.expr(maker, depth - 1, vars), self.expr(maker, depth - 1, vars));
            return match maker.rng.below(8) {
                0..=3 => format!("({left} && {right})"),
                4..=6 => format!("({left} || {right})"),
                _ => format!("({left} ^ {right})"),
            };
        }
        if maker.timed && maker.rng.chance(25) {
            return self.time(maker);
        }
        let not = if maker.rng.chance(30) { "!" } else { "" };
        match maker.rng.below(20) {
            0 => format!("{not}{}.X", maker.rng.pick(&self.steps)),
            3 | 4 if vars > 0 => format!("{not}{}", self.vars[maker.rng.below(vars)].name),
            6..=8 if self.number => {
                let operator = *maker.rng.pick(&["<", "<=", ">", ">=", "==", "!="]);
                format!("(level {operator} {})", maker.rng.pick(&[0, 3, 4, 200, 255]))
            }
            9..=12 if self.edges => {
                let word = *maker.rng.pick(&["rising", "rising", "falling"]);
                let of = match maker.rng.below(6) {
                    0 => format!("{}.X", maker.rng.pick(&self.steps)),
                    1 => format!("{} && {not}{}", maker.rng.pick(&self.inputs), maker.rng.pick(&self.inputs)),
                    2 if vars > 0 => self.vars[maker.rng.below(vars)].name.clone(),
                    _ => maker.rng.pick(&self.inputs).clone(),
                };
                format!("{word}({of})")
            }
            _ => format!("{not}{}", maker.rng.pick(&self.inputs)),
        }
    }

    fn time(&self, maker: &mut Maker) -> String {
        let step = maker.rng.pick(&self.steps).clone();
        let time = *maker.rng.pick(&["1s", "5s", "1m"]);
        let input = maker.rng.pick(&self.inputs).clone();
        match maker.rng.below(6) {
            0..=2 => format!("({time}/{step})"),
            3 => format!("({step}.T < {time})"),
            4 => format!("({step}.T >= {time})"),
            _ => format!("({time}/{input}/1s)"),
        }
    }

    pub(super) fn actions(&self, maker: &mut Maker, step: &Step) -> Vec<String> {
        let mut lines = Vec::new();
        for (index, var) in self.vars.iter().enumerate() {
            if !maker.rng.chance(40) || step.name.is_empty() {
                continue;
            }
            let name = &var.name;
            // No circle: a combinational variable reads only those before it.
            let depth = usize::from(maker.rng.chance(30));
            let value = self.expr(maker, depth, index);
            let edgeless =
                if value.contains("rising") || value.contains("falling") { "a".to_owned() } else { value.clone() };
            lines.push(match (var.mode, maker.rng.below(6)) {
                (Mode::Stored, 0..=2) => format!("S {name};"),
                (Mode::Stored, 3) if !maker.grafcet => format!("N {name} if {edgeless};"),
                (Mode::Stored, _) => format!("R {name};"),
                (Mode::Combinational, 0..=2) => format!("{name};"),
                (Mode::Combinational, _) => format!("{name} if {edgeless};"),
                (Mode::Assigned, 0 | 1) => format!("P1 {name} = {value};"),
                (Mode::Assigned, 2) => format!("P1 {name} = true;"),
                (Mode::Assigned, 3) => format!("P0 {name} = {value};"),
                (Mode::Assigned, 4) => format!("P1 {name} = false;"),
                (Mode::Assigned, _) if maker.grafcet => {
                    format!("on rising({}) {name} = {value};", maker.rng.pick(&self.inputs))
                }
                (Mode::Assigned, _) => format!("N {name} = {value};"),
            });
        }
        lines
    }
}

/// The names of all steps, macro-steps too.
fn collect(body: &Body, names: &mut Vec<String>) {
    for step in &body.steps {
        names.push(step.name.clone());
        step.inner.iter().for_each(|inner| collect(inner, names));
    }
}
