//! Conditions and actions of a small random chart.

use super::draw::Arrow;
use super::hierarchy::{Body, Step};
use super::make::Maker;

/// What can be named.
pub(super) struct Words {
    inputs: Vec<String>,
    /// `level: u8`
    number: bool,
    /// `high: u8` beside it: both are small, so that no arithmetic leaves its type.
    numbers: bool,
    /// Conditions with a name.
    named: Vec<(String, String)>,
    vars: Vec<Var>,
    /// Outputs that only properties read.
    shown: Vec<(String, Shown)>,
    steps: Vec<String>,
    initial: Vec<String>,
    edges: bool,
}

/// How an output is given its value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shown {
    /// N.
    Continuous,
    /// S and R; in `sfc` N and P beside.
    Stored,
    /// `q = …`
    Assigned,
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
        let numbers = rng.chance(10);
        let counts = if numbers { &[1, 2, 2, 2, 2, 2, 2] } else { &[2, 2, 3, 3, 3, 4, 5] };
        let inputs = (0..*rng.pick(counts)).map(|index| "abcdef"[index..=index].to_owned()).collect();
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
        let (mut steps, mut initial) = (Vec::new(), Vec::new());
        for body in bodies {
            collect(body, &mut steps);
            let starts = body.steps.iter().filter(|step| step.words.contains("initial"));
            initial.extend(starts.map(|step| step.name.clone()));
        }
        let (number, edges) = (numbers || rng.chance(20), rng.chance(40));
        let ways = [Shown::Continuous, Shown::Continuous, Shown::Stored, Shown::Assigned];
        let shown = (0..*rng.pick(&[0, 0, 1, 1, 2])).map(|index| (format!("q{index}"), *rng.pick(&ways))).collect();
        let mut words = Self { inputs, number, numbers, named: Vec::new(), vars, shown, steps, initial, edges };
        for index in 0..*maker.rng.pick(&[0, 0, 0, 1, 2]) {
            let depth = maker.rng.between(1, 2);
            let of = words.expr(maker, depth, words.vars.len());
            words.named.push((format!("w{index}"), of));
        }
        words
    }

    pub(super) fn declarations(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.inputs.iter().map(|input| format!("input {input}: bool;")).collect();
        if self.number {
            lines.push("input level: u8;".to_owned());
        }
        if self.numbers {
            lines.push("input high: u8;".to_owned());
            lines.push("assume never level > 4 || high > 4;".to_owned());
        }
        for var in &self.vars {
            let (word, initial) = (if var.output { "output" } else { "var" }, if var.initial { " = true" } else { "" });
            lines.push(format!("{word} {}: bool{initial};", var.name));
        }
        lines.extend(self.shown.iter().map(|(name, _)| format!("output {name}: bool;")));
        lines.extend(self.named.iter().map(|(name, of)| format!("let {name} = {of};")));
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
            // Those of a condition with a name may be edges and variables: they stand where all may be read.
            5 if vars == self.vars.len() && !self.named.is_empty() => {
                format!("{not}{}", maker.rng.pick(&self.named).0)
            }
            6..=8 if self.numbers => related(maker),
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
        lines.append(&mut self.shows(maker));
        lines
    }

    /// Actions on the outputs that nothing reads.
    fn shows(&self, maker: &mut Maker) -> Vec<String> {
        let mut lines = Vec::new();
        for (name, way) in &self.shown {
            if !maker.rng.chance(45) {
                continue;
            }
            let depth = usize::from(maker.rng.chance(40));
            // In a `grafcet` the value of an assignation is a level.
            let value = self.expr(maker, depth, if maker.grafcet { 0 } else { self.vars.len() });
            let level = if value.contains("rising") || value.contains("falling") { "!a".to_owned() } else { value };
            let time = *maker.rng.pick(&["1s", "1m"]);
            let late = if maker.grafcet || *way == Shown::Continuous { 2 } else { 5 };
            lines.push(match (way, maker.rng.below(6)) {
                (Shown::Continuous, 0..=2) | (Shown::Stored, 2..=4)
                    if maker.timed && (!maker.grafcet || *way == Shown::Continuous) =>
                {
                    let qualifier = ["L", "D", "SD", "DS", "SL"][maker.rng.below(late)];
                    format!("{qualifier} {time} {name};")
                }
                (Shown::Continuous, 0..=2) => format!("N {name};"),
                (Shown::Continuous, _) => format!("N {name} if {level};"),
                (Shown::Stored, 0..=1) => format!("S {name};"),
                (Shown::Stored, 2) if !maker.grafcet => format!("N {name};"),
                (Shown::Stored, 3) if !maker.grafcet => format!("P {name};"),
                (Shown::Stored, _) => format!("R {name};"),
                (Shown::Assigned, _) => format!("{name} = {level};"),
            });
        }
        lines
    }

    /// Assumptions and properties.
    pub(super) fn claims(&self, maker: &mut Maker) -> Vec<String> {
        let mut lines = Vec::new();
        if maker.rng.chance(35) {
            for _ in 0..maker.rng.between(1, 2) {
                let count = maker.rng.between(1, 3);
                let parts: Vec<String> = (0..count).map(|_| self.excluded(maker)).collect();
                lines.push(format!("assume never {};", parts.join(*maker.rng.pick(&[" && ", " && ", " || "]))));
            }
        }
        for _ in 0..*maker.rng.pick(&[0, 1, 1, 2, 2]) {
            let depth = maker.rng.between(1, 2);
            let claim = self.claimed(maker, depth);
            lines.push(match maker.rng.below(4) {
                0 => format!("always {claim};"),
                1 => format!("always {} => {claim};", self.claimed(maker, 0)),
                _ => format!("never {claim};"),
            });
        }
        let steps: Vec<&String> = self.steps.iter().filter(|name| name.starts_with('S')).collect();
        if maker.rng.chance(45) {
            let (one, other) = ((*maker.rng.pick(&steps)).clone(), (*maker.rng.pick(&steps)).clone());
            let initial = self.initial.iter().all(|name| name.starts_with('S')) && !self.initial.is_empty();
            lines.push(match maker.rng.below(5) {
                0..=1 if initial => format!("home ({});", self.initial.join(", ")),
                2 if one != other => format!("home ({one}, {other});"),
                _ => format!("home {one};"),
            });
        }
        lines
    }

    /// A condition over inputs.
    fn excluded(&self, maker: &mut Maker) -> String {
        let not = if maker.rng.chance(40) { "!" } else { "" };
        if self.numbers && maker.rng.chance(30) {
            return format!("{not}{}", related(maker));
        }
        if self.number && maker.rng.chance(25) {
            return format!("{not}(level {} {})", maker.rng.pick(&["<", ">=", "=="]), maker.rng.pick(&[0, 3, 4, 200]));
        }
        format!("{not}{}", maker.rng.pick(&self.inputs))
    }

    /// A condition over inputs, outputs, variables and steps.
    fn claimed(&self, maker: &mut Maker, depth: usize) -> String {
        if depth > 0 {
            let (left, right) = (self.claimed(maker, depth - 1), self.claimed(maker, depth - 1));
            return format!("({left} {} {right})", maker.rng.pick(&["&&", "&&", "||", "=="]));
        }
        let not = if maker.rng.chance(35) { "!" } else { "" };
        let values = self.vars.iter().map(|var| &var.name);
        let values: Vec<&String> = values.chain(self.shown.iter().map(|(name, _)| name)).collect();
        match maker.rng.below(10) {
            0 | 1 => self.excluded(maker),
            2..=5 if !values.is_empty() => format!("{not}{}", maker.rng.pick(&values)),
            _ => format!("{not}{}.X", maker.rng.pick(&self.steps)),
        }
    }
}

/// Two numbers compared with each other or with constants, with arithmetic and without it.
fn related(maker: &mut Maker) -> String {
    let sides =
        ["level", "level", "high", "high", "(level * 2)", "(level + 1)", "(level + high)", "(high % 3)", "(high / 2)"];
    let left = *maker.rng.pick(&sides);
    let right = if maker.rng.chance(50) { *maker.rng.pick(&["0", "1", "2", "3"]) } else { *maker.rng.pick(&sides) };
    let operator = *maker.rng.pick(&["<", "<=", ">", ">=", "==", "!="]);
    format!("({left} {operator} {right})")
}

/// The names of all steps, macro-steps too.
fn collect(body: &Body, names: &mut Vec<String>) {
    for step in &body.steps {
        names.push(step.name.clone());
        step.inner.iter().for_each(|inner| collect(inner, names));
    }
}
