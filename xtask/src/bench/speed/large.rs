//! Charts of a thousand steps that are no sequence: each shape has shown work that grows with more than its size.

use std::fmt::Write;

use super::charts::{Chart, DIALECTS, INPUTS, OUTPUTS, chart, in_frame};

/// What each of them may take.
const LIMIT: Option<u64> = Some(1000);

pub(super) fn all() -> Vec<Chart> {
    let mut charts = Vec::new();
    for dialect in DIALECTS {
        for (branches, steps) in [(3, 333), (10, 100), (50, 20)] {
            let name = format!("{branches} parallel branches of {steps} steps, {dialect}");
            charts.push(chart(&name, LIMIT, wide(dialect, branches, steps)));
        }
        charts.push(chart(&format!("selection of 500 ways, {dialect}"), LIMIT, ways(dialect, 500)));
    }
    for (partials, steps) in [(100, 10), (20, 50)] {
        let name = format!("{partials} partial grafcets of {steps} steps");
        charts.push(chart(&name, LIMIT, together(partials, steps, false)));
    }
    charts.push(chart("10 partial grafcets of 100 steps that ask for steps", LIMIT, together(10, 100, true)));
    charts.push(chart("100 macro-steps of ten steps", LIMIT, macros(100)));
    charts
}

fn step(dialect: &str, name: &str, number: usize) -> String {
    let n = if dialect == "sfc" { "N " } else { "" };
    format!("step {name} {{ {n}q{}; }}\n", number % OUTPUTS)
}

/// Parallel branches, a third of whose steps wait for a time.
fn wide(dialect: &str, branches: usize, steps: usize) -> String {
    let mut body = String::from("initial step Start; step End;\n");
    for branch in 0..branches {
        for number in 0..steps {
            body += &step(dialect, &format!("S{branch}_{number}"), branch * steps + number);
            if number + 1 < steps {
                let condition = match number % 3 {
                    1 => format!("{}s/S{branch}_{number}", 1 + number % 4),
                    _ => format!("i{}", (branch * 7 + number) % INPUTS),
                };
                _ = writeln!(body, "S{branch}_{number} -[{condition}]-> S{branch}_{};", number + 1);
            }
        }
    }
    let of = |number: usize| (0..branches).map(|branch| format!("S{branch}_{number}")).collect::<Vec<_>>().join(", ");
    let others: Vec<String> = (1..INPUTS).map(|input| format!("i{input}")).collect();
    _ = writeln!(body, "Start -[i0]-> ({}); ({}) -[true]-> End;", of(0), of(steps - 1));
    _ = writeln!(body, "End -[!i0 || {}]-> Start;", others.join(" || "));
    in_frame(dialect, INPUTS, "", &body)
}

/// One step that leads to many, by a number.
fn ways(dialect: &str, count: usize) -> String {
    let mut body = String::from("initial step Start;\n");
    for way in 0..count {
        body += &step(dialect, &format!("S{way}"), way);
        _ = writeln!(body, "step E{way}; Start -[number == {way} && i0]-> S{way};");
        _ = writeln!(body, "S{way} -[i{}]-> E{way} -[!i0]-> Start;", 1 + way % (INPUTS - 1));
    }
    in_frame(dialect, INPUTS, "input number: u16;", &body)
}

/// Rings beside each other that share their inputs; in each, one transition asks for a step of the next one.
fn together(partials: usize, steps: usize, asking: bool) -> String {
    let mut body = String::new();
    for partial in 0..partials {
        _ = writeln!(body, "partial G{partial} {{");
        for number in 0..steps {
            body += if number == 0 { "initial " } else { "" };
            body += &step("grafcet", &format!("S{partial}_{number}"), partial * steps + number);
        }
        for number in 0..steps {
            let other = (partial + 1) % partials;
            let asked = if asking && number == 2 { format!(" && !G{other}::S{other}_3.X") } else { String::new() };
            let (input, next) = ((partial * steps + number) % INPUTS, (number + 1) % steps);
            _ = writeln!(body, "S{partial}_{number} -[i{input}{asked}]-> S{partial}_{next};");
        }
        body += "}\n";
    }
    in_frame("grafcet", INPUTS, "", &body)
}

/// Macro-steps one after the other, each with two parallel branches.
fn macros(count: usize) -> String {
    let mut body = String::from("initial step Start;\n");
    for number in 0..count {
        _ = writeln!(body, "macro step M{number} {{ entry step A{number}; exit step Z{number};");
        for part in 0..8 {
            body += &step("grafcet", &format!("B{number}_{part}"), number * 8 + part);
            if part % 4 != 3 {
                let input = (number + part) % INPUTS;
                _ = writeln!(body, "B{number}_{part} -[i{input}]-> B{number}_{};", part + 1);
            }
        }
        let input = number % INPUTS;
        _ = writeln!(body, "A{number} -[i{input}]-> (B{number}_0, B{number}_4);");
        _ = writeln!(body, "(B{number}_3, B{number}_7) -[true]-> Z{number}; }}");
        let from = if number == 0 { "Start".to_owned() } else { format!("M{}", number - 1) };
        _ = writeln!(body, "{from} -[i{input}]-> M{number};");
    }
    _ = writeln!(body, "M{} -[i1]-> Start;", count - 1);
    in_frame("grafcet", INPUTS, "", &body)
}
