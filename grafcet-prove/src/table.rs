//! A way as a table: what each cycle is given, and what it shows.

use std::fmt::Write as _;

use grafcet_compiler::model::{Model, Name};
use grafcet_sim::interp::Value;

use crate::replay::Shown;

/// So many rows, and no more; of a longer way the middle is left out.
const SHOWN: usize = 24;

/// One line a cycle, below a line of heads. There is no column of times where nothing asks for one.
#[must_use]
pub fn table(model: &Model, way: &[Shown]) -> String {
    let inputs: Vec<Name> = model.inputs.ids().map(Name::Input).collect();
    let params: Vec<Name> = model.params.ids().map(Name::Param).collect();
    let outputs: Vec<Name> = model.outputs.ids().map(Name::Output).collect();
    let vars: Vec<Name> = model.vars.ids().map(Name::Var).collect();
    let timed = way.iter().any(|shown| shown.now != 0);
    let mut rows = vec![["cycle", "time", "inputs", "cleared", "active", "outputs", "variables"].map(str::to_owned)];
    for (index, shown) in way.iter().enumerate() {
        let given = [values(model, &inputs, &shown.inputs), values(model, &params, &shown.params)].concat();
        rows.push([
            (index + 1).to_string(),
            shown.now.to_string(),
            given.join(", "),
            cleared(&shown.cleared),
            shown.active.join(", "),
            values(model, &outputs, &shown.outputs).join(", "),
            values(model, &vars, &shown.vars).join(", "),
        ]);
    }
    let is_shown = |column: usize| match column {
        1 => timed,
        5 => !outputs.is_empty(),
        6 => rows[1..].iter().any(|row| !row[6].is_empty()),
        _ => true,
    };
    let columns: Vec<usize> = (0..rows[0].len()).filter(|column| is_shown(*column)).collect();
    let widths: Vec<usize> =
        columns.iter().map(|column| rows.iter().map(|row| row[*column].chars().count()).max().unwrap_or(0)).collect();
    if rows.len() > SHOWN {
        rows.splice(SHOWN / 2..=rows.len() - SHOWN / 2, [rows[0].clone().map(|_| "…".to_owned())]);
    }
    let mut text = String::new();
    for row in &rows {
        let mut line = String::new();
        for (column, width) in columns.iter().zip(&widths) {
            _ = write!(line, "{:<width$} | ", row[*column]);
        }
        _ = writeln!(text, "{}", line.trim_end_matches([' ', '|']));
    }
    text
}

/// So many transitions in a row, and no more: a search for stability can clear a great many.
const CLEARED: usize = 12;

fn cleared(all: &[String]) -> String {
    match all.get(..CLEARED) {
        Some(first) if all.len() > CLEARED => format!("{}, … ({} in all)", first.join(", "), all.len()),
        _ => all.join(", "),
    }
}

/// What is on, numbers that are not zero, and which variant an enum has.
fn values(model: &Model, names: &[Name], values: &[Value]) -> Vec<String> {
    let mut all = Vec::new();
    for (name, value) in names.iter().zip(values) {
        let text = model.value_name(*name);
        match (value, model.variants_of(*name)) {
            (Value::Bool(true), _) => all.push(text.to_string()),
            (Value::Int(place), Some(variants)) => all.push(format!("{text} = {}", variants.text(*place, *place))),
            (Value::Bool(false) | Value::Int(0), _) => {}
            (Value::Ticks(ticks), _) => all.push(format!("{text} = {ticks}")),
            _ => all.push(format!("{text} = {value}")),
        }
    }
    all
}
