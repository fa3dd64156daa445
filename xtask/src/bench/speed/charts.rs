//! The charts that are measured.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use super::large;
use crate::command::Result;

/// One chart.
pub(super) struct Chart {
    pub(super) name: String,
    /// The tokens of the macro call.
    pub(super) text: String,
    /// Milliseconds it may take.
    pub(super) limit: Option<u64>,
    /// The rules that are meant to speak, `-` for none.
    pub(super) says: &'static str,
}

pub(super) const DIALECTS: [&str; 2] = ["sfc", "grafcet"];

/// Inputs and outputs are shared by the steps, as those of a machine are.
pub(super) const INPUTS: usize = 24;
pub(super) const OUTPUTS: usize = 16;

/// All charts, those of the project's table first.
pub(super) fn all(root: &Path) -> Result<Vec<Chart>> {
    let mut charts = Vec::new();
    for dialect in DIALECTS {
        charts.push(chart(&format!("sequence of 1000 steps, {dialect}"), Some(1000), sequence(dialect, 1000)));
        charts.push(chart(&format!("nested, 1000 steps, {dialect}"), Some(1000), nested(dialect, 100)));
        charts.push(chart(&format!("1000 steps with any, {dialect}"), Some(1000), stoppable(dialect, 1000)));
        charts.push(chart(&format!("sequence of 10000 steps, {dialect}"), Some(15_000), sequence(dialect, 10_000)));
    }
    charts.push(chart("8 partial grafcets of 8 steps", Some(500), partials(false)));
    for dialect in DIALECTS {
        let name = format!("20 parallel branches of 5 steps, {dialect}");
        charts.push(chart(&name, Some(500), branches(dialect, Inputs::Own)));
    }
    for dialect in DIALECTS {
        let shared = format!("20 branches that share inputs, {dialect}");
        charts.push(chart(&shared, None, branches(dialect, Inputs::Shared)));
        let busy = format!("20 branches, times, edges, variables, {dialect}");
        charts.push(chart(&busy, None, branches(dialect, Inputs::Busy)));
        let deep = format!("parallel branches nested 7 deep, {dialect}");
        charts.push(chart(&deep, None, deep_nesting(dialect)));
        let grid = format!("loops and selections, 300 steps, {dialect}");
        charts.push(chart(&grid, None, loops(dialect, 100)));
    }
    charts.push(chart("8 partial grafcets that read each other", None, partials(true)));
    charts.push(chart("30 macro-steps", None, macros()));
    charts.extend(large::all());
    for good in ["machining_cell", "packaging_line"] {
        let file = root.join(format!("tests/good/{good}.rs"));
        let rust = fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let text = rust.split_once("grafcet! {").and_then(|(_, rest)| rest.rsplit_once('}')).map(|(text, _)| text);
        let text = text.ok_or_else(|| format!("{} holds no chart", file.display()))?;
        charts.push(chart(&good.replace('_', " "), Some(300), text.to_owned()));
    }
    Ok(charts)
}

pub(super) fn chart(name: &str, limit: Option<u64>, text: String) -> Chart {
    Chart { name: name.to_owned(), text, limit, says: "-" }
}

/// A chart with inputs and outputs, all of which its body has to use.
pub(super) fn in_frame(dialect: &str, inputs: usize, more: &str, body: &str) -> String {
    let list = |letter: &str, count| {
        let names: Vec<String> = (0..count).map(|number| format!("{letter}{number}")).collect();
        names.join(", ")
    };
    format!(
        "pub {dialect} Chart {{ input {}: bool; output {}: bool; {more} {body} }}",
        list("i", inputs),
        list("q", OUTPUTS)
    )
}

const COUNTING: &str = " P1 count = count.wrapping_add(1);";

/// What is in a step: an output, here and there a counter.
fn step(dialect: &str, attributes: &str, name: &str, number: usize) -> String {
    let n = if dialect == "sfc" { "N " } else { "" };
    let count = if number % 10 == 3 { COUNTING } else { "" };
    format!("{attributes}step {name} {{ {n}q{};{count} }}\n", number % OUTPUTS)
}

/// What leads on: one input or two, here and there a time.
fn condition(name: &str, number: usize) -> String {
    let (one, two) = (number % INPUTS, (number * 7 + 3) % INPUTS);
    match number % 8 {
        3 => format!("i{one} && {name}.T >= 2s"),
        5 => format!("i{one} && !i{two}"),
        7 => format!("rising(i{one})"),
        _ => format!("i{one}"),
    }
}

fn arrow(from: &str, condition: &str) -> String {
    format!("{from} -[{condition}]-> ")
}

const COUNT: &str = "var count: u16 = 0; output counted: u16; ";

fn with_count(dialect: &str, last: &str) -> String {
    match dialect {
        "sfc" => format!("step {last} {{ counted = count; }}\n"),
        _ => format!("step {last} {{ P1 counted = count; }}\n"),
    }
}

/// A sequence that can be stopped from everywhere.
fn stoppable(dialect: &str, steps: usize) -> String {
    let stop = "step Stopped; any -[i5 && i6]-> Stopped -[!i5 && i7]-> S0;\n";
    in_frame(dialect, INPUTS, COUNT, &format!("{stop}{}", steps_in_turn(dialect, steps)))
}

fn sequence(dialect: &str, steps: usize) -> String {
    in_frame(dialect, INPUTS, COUNT, &steps_in_turn(dialect, steps))
}

fn steps_in_turn(dialect: &str, steps: usize) -> String {
    let mut body = String::new();
    for number in 0..steps {
        let attributes = if number == 0 { "initial " } else { "" };
        body += &step(dialect, attributes, &format!("S{number}"), number);
    }
    body += &with_count(dialect, "Last");
    for number in 0..steps {
        let (from, to) = (format!("S{number}"), format!("S{}", number + 1));
        let to = if number + 1 == steps { "Last".to_owned() } else { to };
        _ = writeln!(body, "{from} -[{}]-> {to};", condition(&from, number));
    }
    body += "Last -[i0]-> S0;";
    body
}

/// A sequence of blocks of ten steps: two parallel branches, one of them with a selection.
fn nested(dialect: &str, blocks: usize) -> String {
    let mut body = String::new();
    for block in 0..blocks {
        let number = |step: usize| block * 10 + step;
        let name = |step: usize| format!("S{}", number(step));
        for part in 0..10 {
            let attributes = if number(part) == 0 { "initial " } else { "" };
            body += &step(dialect, attributes, &name(part), number(part));
        }
        let on = |step: usize| condition(&name(step), number(step));
        let (one, two) = (block % INPUTS, (block + 5) % INPUTS);
        let names: Vec<String> = (0..10).map(name).collect();
        let times = |step: usize| arrow(&names[step], &on(step));
        let (start, left, right) = (times(0), &names[1], &names[2]);
        _ = writeln!(
            body,
            "{start}({left}, {right}); {left} -[i{one} && i{two}]-> {}; {left} -[!i{one}]-> {};",
            names[3], names[4]
        );
        _ = writeln!(body, "{}{after}; {}{after}; {}{};", times(3), times(4), times(5), names[6], after = names[5]);
        _ = writeln!(body, "{}{}; {}{};", times(2), names[7], times(7), names[8]);
        _ = writeln!(body, "({}, {}) -[true]-> {};", names[6], names[8], names[9]);
        let next = if block + 1 == blocks { "Last".to_owned() } else { format!("S{}", number(10)) };
        _ = writeln!(body, "{}{next};", times(9));
    }
    body += &with_count(dialect, "Last");
    body += "Last -[i0]-> S0;";
    in_frame(dialect, INPUTS, COUNT, &body)
}

/// Loops around selections, one after the other.
fn loops(dialect: &str, blocks: usize) -> String {
    let mut body = String::new();
    for block in 0..blocks {
        for part in 0..3 {
            let attributes = if block + part == 0 { "initial " } else { "" };
            body += &step(dialect, attributes, &format!("S{block}_{part}"), block * 3 + part);
        }
        let (one, two) = (block % INPUTS, (block * 5 + 1) % INPUTS);
        let three = (two + 1) % INPUTS;
        let next = if block + 1 == blocks { "Last".to_owned() } else { format!("S{}_0", block + 1) };
        _ = writeln!(body, "S{block}_0 -[i{one}]-> S{block}_1; S{block}_0 -[!i{one} && i{two}]-> S{block}_2;");
        _ = writeln!(body, "S{block}_1 -[rising(i{three})]-> S{block}_0; S{block}_1 -[!i{one} && !i{three}]-> {next};");
        _ = writeln!(body, "S{block}_2 -[S{block}_2.T >= 1s && !i{two}]-> {next};");
    }
    body += &with_count(dialect, "Last");
    body += "Last -[i0]-> S0_0;";
    in_frame(dialect, INPUTS, COUNT, &body)
}

/// What the conditions of parallel branches read.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Inputs {
    /// Each branch its own.
    Own,
    /// The same few.
    Shared,
    /// The same few, times, edges, and variables that other branches set and reset.
    Busy,
}

/// Twenty parallel branches of five steps.
fn branches(dialect: &str, inputs: Inputs) -> String {
    let count = if inputs == Inputs::Own { 100 } else { 12 };
    let mut body = String::from("initial step Start; step End;\n");
    let (mut first, mut last) = (Vec::new(), Vec::new());
    let n = if dialect == "sfc" { "N " } else { "" };
    for branch in 0..20 {
        for number in 0..5 {
            let latch = match (inputs, number) {
                (Inputs::Busy, 1) => format!(" P1 v{} = true;", branch % 6),
                (Inputs::Busy, 3) => format!(" P1 w{} = v{};", branch % 6, (branch + 1) % 6),
                (Inputs::Busy, 4) => format!(" P1 v{} = false;", (branch + 2) % 6),
                _ => String::new(),
            };
            let allow = if latch.is_empty() { "" } else { "#[allow(grafcet::write_race)] " };
            let q = (branch * 5 + number) % OUTPUTS;
            _ = writeln!(body, "{allow}step S{branch}_{number} {{ {n}q{q};{latch} }}");
            if number < 4 {
                let input = (branch * 5 + number) % count;
                let condition = match (inputs, number) {
                    (Inputs::Busy, 0) => format!("i{input} && S{branch}_0.T >= {}s", branch % 3 + 1),
                    (Inputs::Busy, 1) => format!("rising(i{input}) || v{}", (branch + 3) % 6),
                    (Inputs::Busy, 2) => format!("falling(i{input}) && i{}", (input + 1) % count),
                    (Inputs::Busy, 3) => format!("w{} || i{input}", (branch + 1) % 6),
                    (Inputs::Shared, 1) => format!("i{input} && !i{}", (input + 3) % count),
                    (Inputs::Shared, 2) => format!("i{input} || i{}", (input + 5) % count),
                    _ => format!("i{input}"),
                };
                _ = writeln!(body, "S{branch}_{number} -[{condition}]-> S{branch}_{};", number + 1);
            }
        }
        first.push(format!("S{branch}_0"));
        last.push(format!("S{branch}_4"));
    }
    _ = writeln!(body, "Start -[i{}]-> ({}); ({}) -[true]-> End;", count - 1, first.join(", "), last.join(", "));
    // The inputs that no branch reads: those of the last steps.
    let mut rest: Vec<String> =
        (0..count - 1).filter(|input| input % 5 == 4).map(|input| format!("i{input}")).collect();
    rest.push(format!("!i{}", count - 1));
    _ = writeln!(body, "End -[{}]-> Start;", rest.join(" || "));
    let variables =
        if inputs == Inputs::Busy { "var v0, v1, v2, v3, v4, v5, w0, w1, w2, w3, w4, w5: bool;" } else { "" };
    in_frame(dialect, count, variables, &body)
}

fn deep_nesting(dialect: &str) -> String {
    let mut nest = Nest { dialect, steps: String::new(), arcs: String::new(), count: 0 };
    let (first, last) = nest.block(6);
    let Nest { steps, arcs, .. } = nest;
    let any: Vec<String> = (1..INPUTS).map(|input| format!("i{input}")).collect();
    let body = format!(
        "initial step Start; step End; {steps} {arcs}
         Start -[i0]-> {first}; {last} -[i1]-> End; End -[!i0 || {}]-> Start;",
        any.join(" || ")
    );
    in_frame(dialect, INPUTS, "", &body.replace(COUNTING, ""))
}

struct Nest<'a> {
    dialect: &'a str,
    steps: String,
    arcs: String,
    count: usize,
}

impl Nest<'_> {
    fn step(&mut self) -> String {
        let name = format!("S{}", self.count);
        self.steps += &step(self.dialect, "", &name, self.count);
        self.count += 1;
        name
    }

    /// A step, two blocks beside each other, a step.
    fn block(&mut self, depth: usize) -> (String, String) {
        let first = self.step();
        let number = self.count;
        if depth == 0 {
            return (first.clone(), first);
        }
        let (left, right) = (self.block(depth - 1), self.block(depth - 1));
        let last = self.step();
        let condition = condition(&first, number);
        _ = writeln!(
            self.arcs,
            "{first} -[{condition}]-> ({}, {}); ({}, {}) -[true]-> {last};",
            left.0, right.0, left.1, right.1
        );
        (first, last)
    }
}

/// Eight partial grafcets in a ring of eight steps each.
fn partials(reading: bool) -> String {
    let mut body = String::new();
    for part in 0..8 {
        _ = writeln!(body, "partial G{part} {{");
        for number in 0..8 {
            let attributes = if number == 0 { "initial " } else { "" };
            body += &step("grafcet", attributes, &format!("S{part}_{number}"), part * 8 + number);
        }
        for number in 0..8 {
            let (input, next) = ((part * 8 + number) % INPUTS, (number + 1) % 8);
            let other = (part + 1) % 8;
            let condition = match (reading, number % 4) {
                (true, 1) => {
                    format!("i{input} && G{other}::S{other}_{number}.X || i{input} && i{}", (input + 5) % INPUTS)
                }
                (true, 3) => format!("!G{other}::S{other}_{number}.X || i{input}"),
                _ => format!("i{input}"),
            };
            _ = writeln!(body, "S{part}_{number} -[{condition}]-> S{part}_{next};");
        }
        body += "}\n";
    }
    in_frame("grafcet", INPUTS, "", &body.replace(COUNTING, ""))
}

/// Thirty macro-steps of two parallel branches, one after the other.
fn macros() -> String {
    let mut body = String::from("initial step Start;\n");
    for number in 0..30 {
        let name = |step: usize| format!("S{number}_{step}");
        _ = writeln!(body, "macro step M{number} {{");
        for part in 0..6 {
            let attributes = ["entry ", "", "", "", "", "exit "][part];
            body += &step("grafcet", attributes, &name(part), number * 6 + part);
        }
        let on = |step: usize| condition(&name(step), number * 6 + step);
        let times = |step: usize| arrow(&name(step), &on(step));
        _ = writeln!(body, "{}({}, {}); {}{};", times(0), name(1), name(2), times(1), name(3));
        _ = writeln!(body, "{}{}; ({}, {}) -[true]-> {}; }}", times(2), name(4), name(3), name(4), name(5));
        let from = if number == 0 { "Start".to_owned() } else { format!("M{}", number - 1) };
        _ = writeln!(body, "{from} -[i{}]-> M{number};", number % INPUTS);
    }
    body += &with_count("grafcet", "Last");
    body += "M29 -[i1]-> Last -[i2]-> Start;";
    in_frame("grafcet", INPUTS, COUNT, &body)
}
