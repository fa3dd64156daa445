//! The textual form: `INITIAL_STEP … END_STEP`, `TRANSITION FROM … TO …`, `ACTION …`.

use std::fmt::Write as _;

use super::{Block, Chart, Step, Transition};
use crate::st::syntax::{comment, declare, statements};

pub(super) fn write(chart: &Chart) -> String {
    let mut text = String::new();
    for line in &chart.header {
        text.push_str(&comment(line));
        text.push('\n');
    }
    for stub in &chart.functions {
        text.push('\n');
        stub.write(&mut text);
    }
    // Writing into a text cannot fail.
    _ = program(&mut text, chart);
    classic(&text)
}

/// With comments as they were before the third edition of the standard: compilers of the second one know no others.
pub(crate) fn classic(text: &str) -> String {
    let one = |line: &str| match line.split_once("//") {
        Some((before, said)) => {
            // Some compilers take a comment within a comment for one with an end of its own.
            let said = said.trim().replace("*)", "* )").replace("(*", "( *");
            format!("{before}(* {said} *)\n")
        }
        None => format!("{line}\n"),
    };
    text.lines().map(one).collect::<Vec<_>>().concat()
}

fn program(text: &mut String, chart: &Chart) -> std::fmt::Result {
    writeln!(text, "\nPROGRAM {}", chart.name)?;
    let sections = [("VAR_INPUT", &chart.inputs), ("VAR_OUTPUT", &chart.outputs), ("VAR", &chart.variables)];
    for (keyword, variables) in sections {
        declare(text, keyword, variables);
    }
    for (index, step) in chart.steps.iter().enumerate() {
        write_step(text, step)?;
        for transition in chart.transitions.iter().filter(|transition| transition.from.first() == Some(&index)) {
            write_transition(text, chart, transition)?;
        }
    }
    for action in &chart.actions {
        writeln!(text, "\nACTION {}:", action.name)?;
        statements(text, 1, &action.body);
        writeln!(text, "END_ACTION")?;
    }
    writeln!(text, "END_PROGRAM")
}

fn write_step(text: &mut String, step: &Step) -> std::fmt::Result {
    let keyword = if step.initial { "INITIAL_STEP" } else { "STEP" };
    let note = if step.note.is_empty() { String::new() } else { format!(" {}", comment(&step.note)) };
    writeln!(text, "\n{keyword} {}:{note}", step.name)?;
    for Block { qualifier, time, action } in &step.blocks {
        match time {
            Some(time) => writeln!(text, "  {action}({qualifier}, {time});")?,
            None => writeln!(text, "  {action}({qualifier});")?,
        }
    }
    writeln!(text, "END_STEP")
}

fn write_transition(text: &mut String, chart: &Chart, transition: &Transition) -> std::fmt::Result {
    let steps = |numbers: &[usize]| {
        let names: Vec<&str> = numbers.iter().map(|number| &*chart.steps[*number].name).collect();
        if let [name] = names[..] { name.to_owned() } else { format!("({})", names.join(", ")) }
    };
    let priority = transition.priority.map(|priority| format!(" (PRIORITY := {priority})")).unwrap_or_default();
    writeln!(text, "\nTRANSITION{priority} FROM {} TO {}", steps(&transition.from), steps(&transition.to))?;
    writeln!(text, "  := {};\nEND_TRANSITION", transition.condition)
}
