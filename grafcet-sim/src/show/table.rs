//! A trace as a table.

use std::fmt::Write as _;

use super::{Axis, raised};
use crate::cycle::Cycle;
use crate::names::Names;
use crate::trace::Trace;

/// A trace as a table in characters: one line for each cycle in which something changed, below each other what it did.
#[must_use]
pub fn table(trace: &Trace) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    for warning in &trace.warnings {
        _ = writeln!(out, "! {warning}");
    }
    let axis = Axis::of(trace);
    let time = if axis.is_time { "time" } else { "" };
    let headings = ["cycle", time, "inputs", "steps", "outputs", "what happened"];
    let mut rows: Vec<Row> = vec![Row::Cells(headings.map(str::to_owned))];
    let mut same = 0;
    for (index, cycle) in trace.cycles.iter().enumerate() {
        same += usize::try_from(cycle.skipped).unwrap_or(usize::MAX);
        let before = index.checked_sub(1).map(|before| &trace.cycles[before]);
        if before.is_some_and(|before| shows_nothing_new(before, cycle)) {
            same += 1;
            continue;
        }
        rows.extend(folded(&mut same));
        if let Some(gap) = &cycle.gap {
            let cycles = gap.cycles.map(|count| format!("{count} cycles, ")).unwrap_or_default();
            rows.push(Row::Line(format!("~~~ gap: {cycles}{}", gap.reason)));
        }
        let mut happened = happened(&trace.names, cycle).into_iter();
        let head = [
            index.to_string(),
            if axis.is_time { axis.label(trace, axis.starts[index]) } else { String::new() },
            raised(&trace.names.inputs, &cycle.inputs),
            steps(trace, cycle),
            [raised(&trace.names.outputs, &cycle.outputs), raised(&trace.names.variables, &cycle.variables)]
                .into_iter()
                .filter(|text| text != "-")
                .collect::<Vec<_>>()
                .join(" · "),
            happened.next().unwrap_or_default(),
        ];
        rows.push(Row::Cells(head));
        rows.extend(happened.map(|line| Row::Cells(["", "", "", "", "", &line].map(str::to_owned))));
    }
    rows.extend(folded(&mut same));
    write(&rows, &mut out);
    out
}

enum Row {
    Cells([String; 6]),
    Line(String),
}

fn folded(same: &mut usize) -> Option<Row> {
    match std::mem::take(same) {
        0 => None,
        1 => Some(Row::Line("… one cycle more".to_owned())),
        count => Some(Row::Line(format!("… {count} cycles more"))),
    }
}

fn shows_nothing_new(before: &Cycle, cycle: &Cycle) -> bool {
    cycle.gap.is_none()
        && cycle.evolutions.is_empty()
        && cycle.is_stable
        && (&before.inputs, &before.steps, &before.outputs, &before.variables)
            == (&cycle.inputs, &cycle.steps, &cycle.outputs, &cycle.variables)
        && cycle.calls == before.calls
}

fn steps(trace: &Trace, cycle: &Cycle) -> String {
    let names: Vec<&str> = cycle.steps.iter().map(|step| trace.names.steps[*step].name.as_str()).collect();
    names.join(" ")
}

/// What a cycle did, one line each: its evolutions with the transitions that cleared, what is forced, what was called.
#[must_use]
pub fn happened(names: &Names, cycle: &Cycle) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for evolution in &cycle.evolutions {
        let cleared: Vec<&str> = evolution.cleared.iter().map(|id| names.transitions[*id].name.as_str()).collect();
        lines.push(if cleared.is_empty() { "forced".to_owned() } else { cleared.join(", ") });
    }
    if !cycle.is_stable {
        lines.push("not stable".to_owned());
    }
    let forced = cycle.forced.iter();
    lines.extend(
        forced.map(|one| format!("{} forces {} {}", names.steps[one.by].name, names.partials[one.partial], one.order)),
    );
    lines.extend(cycle.calls.iter().map(|call| {
        let args: Vec<String> = call.args.iter().map(ToString::to_string).collect();
        format!("{:?} {}({})", call.phase, call.action, args.join(", ")).to_lowercase()
    }));
    lines
}

fn write(rows: &[Row], out: &mut String) {
    let mut widths = [0; 6];
    for row in rows {
        if let Row::Cells(cells) = row {
            widths.iter_mut().zip(cells).for_each(|(width, cell)| *width = (*width).max(cell.chars().count()));
        }
    }
    for row in rows {
        match row {
            Row::Cells(cells) => {
                let used = cells.iter().zip(widths).filter(|(_, width)| *width > 0);
                let padded: Vec<String> = used.map(|(cell, width)| format!("{cell:<width$}")).collect();
                _ = writeln!(out, "{}", padded.join("  ").trim_end());
            }
            Row::Line(line) => _ = writeln!(out, "{line}"),
        }
    }
}
