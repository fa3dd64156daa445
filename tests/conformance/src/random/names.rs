//! What a random chart declares.

use super::Gen;
use super::expr::Reads;

/// The types of values; numbers stay so small that no arithmetic leaves its type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Ty {
    Bool,
    I16,
    U8,
    Time,
}

impl Ty {
    pub(super) fn rust(self) -> &'static str {
        match self {
            Self::Bool => "bool",
            Self::I16 => "i16",
            Self::U8 => "u8",
            Self::Time => "time",
        }
    }
}

/// What may be done with a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Role {
    Input,
    Param,
    /// `sfc`: a boolean with an action control. `grafcet`: a continuous output.
    Controlled,
    /// A boolean for S and R alone, which may start as true.
    SetReset,
    /// `y = e` while a step is active.
    Assigned,
    /// Written by P1, P0, events and blocks.
    Written,
    /// `grafcet`: a boolean variable asserted by continuous actions.
    Combinational,
}

#[derive(Clone, Debug)]
pub(super) struct Value {
    pub(super) name: String,
    pub(super) ty: Ty,
    pub(super) role: Role,
}

#[derive(Clone, Debug)]
pub(super) struct Action {
    pub(super) name: String,
    pub(super) params: Vec<Ty>,
}

/// A named condition.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub(super) name: String,
    /// What it may read: it stands where as much may be read.
    pub(super) reads: Reads,
}

/// All declarations.
#[derive(Default)]
pub(super) struct Names {
    pub(super) values: Vec<Value>,
    /// Conditions with a name, in the order in which they are declared.
    pub(super) named: Vec<Named>,
    /// There is `mode`, an input of an enum.
    pub(super) modes: bool,
    pub(super) actions: Vec<Action>,
    /// Their lines in the chart.
    pub(super) lines: Vec<String>,
    /// The clock unit in microseconds.
    pub(super) clock: u32,
}

impl Names {
    pub(super) fn of(&self, role: Role, ty: Ty) -> Vec<String> {
        let found = self.values.iter().filter(|value| value.role == role && value.ty == ty);
        found.map(|value| value.name.clone()).collect()
    }

    fn add(&mut self, word: &str, name: &str, ty: Ty, role: Role, init: Option<String>) {
        let init = init.map(|init| format!(" = {init}")).unwrap_or_default();
        // What the timeline sets is in it, and what a chart has for itself.
        let range = match (name, init.len() % 2) {
            ("p", 0) => " in 0s..1h",
            ("k", 0) => " in 0..=9",
            ("k", _) => " in -3..10",
            _ => "",
        };
        self.lines.push(format!("{word} {name}: {}{range}{init};", ty.rust()));
        self.values.push(Value { name: name.to_owned(), ty, role });
    }
}

impl Gen {
    /// Declares everything; what is not used in the end is dropped by nobody, unused names are no mistake here.
    pub(super) fn declare(&mut self) {
        self.names.clock = *self.rng.pick(&[1000, 1000, 1000, 10_000, 250]);
        if self.names.clock != 1000 {
            self.note("clock");
            let clock = self.ticks(1);
            self.names.lines.push(format!("clock {clock};"));
        }
        for name in ["a", "b", "c", "d", "e"].iter().take(self.rng.between(2, 5)) {
            self.names.add("input", name, Ty::Bool, Role::Input, None);
        }
        if self.rng.chance(40) {
            self.names.add("input", "u", Ty::U8, Role::Input, None);
        }
        if self.rng.chance(30) {
            self.names.add("input", "v", Ty::I16, Role::Input, None);
        }
        self.names.modes = self.rng.chance(25);
        if self.names.modes {
            self.note("enum");
            self.names.lines.push("input mode: Mode in {Off, Auto, Manual};".to_owned());
        }
        self.params();
        self.outputs();
        self.vars();
        self.actions();
    }

    fn params(&mut self) {
        if self.rng.chance(40) {
            let init = self.short();
            self.names.add("param", "p", Ty::Time, Role::Param, Some(init));
            self.note("param of type time");
        }
        if self.rng.chance(30) {
            self.names.add("param", "k", Ty::I16, Role::Param, Some("3".to_owned()));
            self.note("param");
        }
        if self.rng.chance(10) {
            self.names.add("param", "f", Ty::Bool, Role::Param, Some("true".to_owned()));
        }
    }

    fn outputs(&mut self) {
        for index in 0..self.rng.between(1, 3) {
            self.names.add("output", &format!("q{index}"), Ty::Bool, Role::Controlled, None);
        }
        if self.rng.chance(50) {
            let init = self.rng.chance(40).then(|| "true".to_owned());
            self.names.add("output", "s", Ty::Bool, Role::SetReset, init);
        }
        if self.rng.chance(40) {
            let init = self.rng.chance(50).then(|| "7".to_owned());
            let ty = *self.rng.pick(&[Ty::I16, Ty::U8]);
            self.names.add("output", "y", ty, Role::Assigned, init);
        }
        if self.rng.chance(50) {
            let init = self.rng.chance(30).then(|| "9".to_owned());
            self.names.add("output", "z", Ty::I16, Role::Written, init);
        }
        if self.rng.chance(30) {
            let init = self.rng.chance(30).then(|| "true".to_owned());
            self.names.add("output", "w", Ty::Bool, Role::Written, init);
        }
    }

    fn vars(&mut self) {
        if self.rng.chance(60) {
            self.names.add("var", "n", Ty::I16, Role::Written, Some("0".to_owned()));
        }
        if self.rng.chance(40) {
            self.names.add("var", "m", Ty::U8, Role::Written, Some("2".to_owned()));
        }
        if self.rng.chance(25) {
            let init = self.short();
            self.names.add("var", "tv", Ty::Time, Role::Written, Some(init));
        }
        if self.rng.chance(25) {
            let init = self.rng.chance(40).then(|| "true".to_owned());
            self.names.add("var", "sv", Ty::Bool, Role::SetReset, init);
        }
        for index in 0..self.rng.below(3) {
            let role = if self.grafcet { Role::Combinational } else { Role::Controlled };
            self.names.add("var", &format!("x{index}"), Ty::Bool, role, None);
        }
    }

    fn actions(&mut self) {
        for index in 0..self.rng.below(4) {
            let count = self.rng.below(3);
            let params: Vec<Ty> =
                (0..count).map(|_| *self.rng.pick(&[Ty::I16, Ty::I16, Ty::Bool, Ty::U8, Ty::Time])).collect();
            let list: Vec<String> = params.iter().enumerate().map(|(i, ty)| format!("r{i}: {}", ty.rust())).collect();
            self.names.lines.push(format!("action act{index}({});", list.join(", ")));
            self.names.actions.push(Action { name: format!("act{index}"), params });
        }
    }

    /// So many ticks as a literal.
    pub(super) fn ticks(&self, ticks: u32) -> String {
        match self.names.clock {
            1000 => format!("{ticks}ms"),
            10_000 => format!("{ticks}0ms"),
            micros => format!("{}us", ticks * micros),
        }
    }

    /// A short time as a literal.
    pub(super) fn short(&mut self) -> String {
        let ticks = *self.rng.pick(&[1, 2, 3, 4, 5, 6, 8, 12, 20]);
        let literal = self.ticks(ticks);
        self.fragment('l', literal)
    }
}
