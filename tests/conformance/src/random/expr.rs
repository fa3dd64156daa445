//! Random conditions and values.

use super::Gen;
use super::names::{Named, Role, Ty};

/// What an expression may read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reads {
    /// `rising` and `falling`.
    pub(super) edges: bool,
    /// `t1/e/t2`
    pub(super) delays: bool,
    /// Combinational variables with a smaller number: no circle (A22).
    pub(super) combinational: usize,
}

impl Reads {
    /// Whether all that the other may read may be read here.
    fn covers(self, other: Self) -> bool {
        self.edges >= other.edges && self.delays >= other.delays && self.combinational >= other.combinational
    }
}

/// All of them.
pub(super) const ALL: Reads = Reads { edges: true, delays: true, combinational: usize::MAX };

impl Gen {
    /// A boolean expression that can stand beside `&&` and `||`.
    pub(super) fn condition(&mut self, depth: usize, reads: Reads) -> String {
        if depth > 0 && self.rng.chance(45) {
            let operator = *self.rng.pick(&["&&", "&&", "||", "||", "^", "!="]);
            let (left, right) = (self.condition(depth - 1, reads), self.condition(depth - 1, reads));
            return match operator {
                "&&" | "||" => self.whole(format!("{left} {operator} {right}")),
                _ => self.whole(format!("({left}) {operator} ({right})")),
            };
        }
        let leaf = self.leaf(depth, reads);
        self.fragment('e', leaf)
    }

    fn leaf(&mut self, depth: usize, reads: Reads) -> String {
        match self.rng.below(26) {
            8..=10 => format!("!{}", self.boolean(reads)),
            11..=13 => self.comparison(reads),
            14 | 15 => format!("{}.X", self.step_path()),
            16 => self.time_of_step(),
            17..=19 => self.elapsed(),
            20 | 21 if reads.edges => self.edge(reads),
            22 if reads.delays => self.delay(reads),
            24 => self.blink(),
            25 if self.names.modes => self.mode(),
            23 => {
                let negated = self.condition(depth.saturating_sub(1), reads);
                format!("!{}", self.whole(negated))
            }
            _ => self.boolean(reads),
        }
    }

    /// `blink(3ms/2ms, Step)`
    fn blink(&mut self) -> String {
        self.note("blink");
        let on = self.short();
        let parts = if self.rng.chance(50) { format!("{on}/{}", self.short()) } else { on };
        if self.of_one && self.rng.chance(60) {
            self.note("blink of its own step");
            return format!("blink({parts})");
        }
        format!("blink({parts}, {})", self.step_name())
    }

    /// `mode == Mode::Auto`
    fn mode(&mut self) -> String {
        self.note("enum read");
        let conditions = [
            "(mode == Mode::Off)",
            "(mode == Mode::Auto)",
            "(Mode::Manual != mode)",
            "matches!(mode, Mode::Auto)",
            "!matches!(mode, Mode::Off | Mode::Manual)",
        ];
        (*self.rng.pick(&conditions)).to_owned()
    }

    /// Gives conditions names; one may read those before it.
    pub(super) fn name_conditions(&mut self) -> Vec<String> {
        let levels = Reads { edges: false, ..ALL };
        let mut lines = Vec::new();
        for index in 0..*self.rng.pick(&[0, 0, 1, 2, 3]) {
            let reads = *self.rng.pick(&[ALL, levels, Reads { combinational: 0, ..levels }]);
            let mut of = self.condition(2, reads);
            self.note("named condition");
            if reads.edges && self.rng.chance(60) {
                self.note("named condition with an edge");
                let edge = self.edge(reads);
                of = self.whole(format!("{of} || {edge}"));
            }
            if reads.delays && self.rng.chance(20) {
                self.note("named condition with a delay");
                let delay = self.delay(reads);
                of = self.whole(format!("{of} && {delay}"));
            }
            lines.push(format!("let w{index} = {of};"));
            self.names.named.push(Named { name: format!("w{index}"), reads });
        }
        lines
    }

    /// The name of a readable boolean, or of a condition.
    pub(super) fn boolean(&mut self, reads: Reads) -> String {
        let conditions = self.names.named.iter().filter(|named| reads.covers(named.reads));
        let conditions: Vec<String> = conditions.map(|named| named.name.clone()).collect();
        if let Some(name) = self.rng.maybe(&conditions).filter(|_| self.rng.chance(20)) {
            self.note("named condition read");
            return name.clone();
        }
        let grafcet = self.grafcet;
        let readable = |role: Role, name: &str| match role {
            Role::Combinational => name[1..].parse().is_ok_and(|index: usize| index < reads.combinational),
            Role::Controlled | Role::Assigned => !grafcet,
            _ => true,
        };
        let bools = self.names.values.iter().filter(|v| v.ty == Ty::Bool);
        let names: Vec<String> = bools.filter(|v| readable(v.role, &v.name)).map(|v| v.name.clone()).collect();
        // Inputs move a chart on; the others are seen often enough at a third.
        let inputs = self.names.of(Role::Input, Ty::Bool);
        let name = if self.rng.chance(65) { self.rng.pick(&inputs) } else { self.rng.pick(&names) }.clone();
        if name.starts_with('x') && grafcet {
            self.note("combinational variable read");
        }
        name
    }

    fn numbers(&self, ty: Ty) -> Vec<String> {
        let readable = |role| role != Role::Assigned || !self.grafcet;
        let numbers = self.names.values.iter().filter(|v| v.ty == ty && readable(v.role));
        numbers.map(|v| v.name.clone()).collect()
    }

    fn comparison(&mut self, reads: Reads) -> String {
        let ty = *self.rng.pick(&[Ty::I16, Ty::U8]);
        let names = self.numbers(ty);
        let Some(name) = self.rng.maybe(&names).cloned() else { return self.boolean(reads) };
        let operator = *self.rng.pick(&["==", "!=", "<", "<=", ">", ">="]);
        self.note("comparison of numbers");
        let other = self.int(ty, 0);
        self.whole(format!("{name} {operator} {other}"))
    }

    fn time_of_step(&mut self) -> String {
        let operator = *self.rng.pick(&[">=", ">=", ">", "<", "<=", "==", "!="]);
        self.note("Step.T");
        let (step, time) = (self.step_path(), self.time());
        if self.rng.chance(20) {
            self.whole(format!("{time} {operator} {step}.T"))
        } else {
            self.whole(format!("{step}.T {operator} {time}"))
        }
    }

    fn elapsed(&mut self) -> String {
        self.note("t/Step");
        let time = if self.rng.chance(5) { self.ticks(0) } else { self.time() };
        let step = self.step_name();
        let name = step.rsplit("::").next().unwrap_or(&step);
        if self.real.contains(name) && self.rng.chance(25) {
            self.note("late");
            self.late.entry(name.to_owned()).or_insert(time);
            return format!("{step}.late");
        }
        self.whole(format!("{time}/{step}"))
    }

    /// `rising(e)`
    pub(super) fn edge(&mut self, reads: Reads) -> String {
        let word = *self.rng.pick(&["rising", "rising", "falling"]);
        let of = match self.rng.below(10) {
            0..=5 => self.boolean(reads),
            6 | 7 => {
                self.note("edge of a step");
                format!("{}.X", self.step_path())
            }
            _ => {
                self.note("edge of a mixture");
                let edges = reads.edges && self.rng.chance(10);
                self.condition(1, Reads { edges, ..reads })
            }
        };
        self.note("edge");
        format!("{word}({of})")
    }

    fn delay(&mut self, reads: Reads) -> String {
        self.note("t1/e/t2");
        let (on, off) = (self.time(), self.time());
        let of = match self.rng.below(10) {
            0..=4 => self.boolean(reads),
            5 | 6 => return format!("({on}/{}/{off})", self.step_name()),
            _ => {
                let delays = reads.delays && self.rng.chance(10);
                let of = self.condition(1, Reads { delays, ..reads });
                self.whole(of)
            }
        };
        if self.rng.chance(30) { self.whole(format!("{on}/{of}")) } else { self.whole(format!("{on}/{of}/{off}")) }
    }

    /// A time: a literal, a param or a variable.
    pub(super) fn time(&mut self) -> String {
        let mut names = self.names.of(Role::Param, Ty::Time);
        names.extend(self.names.of(Role::Written, Ty::Time));
        match self.rng.maybe(&names).cloned() {
            Some(name) if self.rng.chance(35) => {
                self.note(if name == "p" { "time from a param" } else { "time from a variable" });
                name
            }
            _ => self.short(),
        }
    }

    /// A value of a type; numbers between -49 and 49, so that no arithmetic leaves its type.
    pub(super) fn value(&mut self, ty: Ty, reads: Reads) -> String {
        match ty {
            Ty::Bool if self.rng.chance(30) => (*self.rng.pick(&["true", "false"])).to_owned(),
            Ty::Bool => self.condition(1, reads),
            Ty::I16 | Ty::U8 => self.int(ty, 2),
            Ty::Time => match self.rng.below(4) {
                0 => {
                    self.note("Step.T in an action");
                    format!("{}.T", self.step_path())
                }
                1 => format!("{} + {}", self.time(), self.short()),
                _ => self.time(),
            },
        }
    }

    fn int(&mut self, ty: Ty, depth: usize) -> String {
        let names = self.numbers(ty);
        let name = match self.rng.maybe(&names) {
            Some(name) if self.rng.chance(75) => name.clone(),
            _ => {
                let literal = self.rng.below(9).to_string();
                self.fragment('l', literal)
            }
        };
        if depth == 0 {
            return name;
        }
        let other = self.int(ty, depth - 1);
        match self.rng.below(7) {
            0 | 1 => {
                let sum = self.whole(format!("{name} + {other}"));
                self.whole(format!("{sum} % 50"))
            }
            2 => {
                let product = self.whole(format!("{name} * 3"));
                self.whole(format!("{product} % 50"))
            }
            3 if ty == Ty::I16 => {
                let difference = self.whole(format!("{name} - {other}"));
                self.whole(format!("{difference} % 50"))
            }
            4 => self.whole(format!("{name} & 7")),
            5 => self.whole(format!("{other} / 3")),
            _ => self.fragment('e', name),
        }
    }

    /// A step or macro-step, by its name alone.
    pub(super) fn step_name(&mut self) -> String {
        let (_, name) = self.rng.pick(&self.steps).clone();
        if name.starts_with('M') {
            self.note("variable of a macro-step");
        }
        name
    }

    /// The same, sometimes with its partial grafcet in front.
    fn step_path(&mut self) -> String {
        let (partial, name) = self.rng.pick(&self.steps).clone();
        match partial {
            Some(partial) if !name.starts_with('M') && self.rng.chance(50) => format!("{partial}::{name}"),
            _ => name,
        }
    }
}
