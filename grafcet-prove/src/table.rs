//! A way as a table: what each cycle is given, and what it shows.

use std::fmt::Write as _;

use grafcet_compiler::model::{Id, InputId, Model, Name, Wire};
use grafcet_sim::interp::Value;

use crate::replay::Shown;

/// So many rows, and no more; of a longer way the middle is left out.
const SHOWN: usize = 24;

/// One line a cycle, below a line of heads. There is no column of times where nothing asks for one. Below them stands what the program around
/// the chart has to say on this way.
#[must_use]
pub fn table(model: &Model, way: &[Shown]) -> String {
    let own: Vec<InputId> = model.inputs.ids().filter(|id| !model.plants.is_watched(*id)).collect();
    let inputs: Vec<Name> = own.iter().copied().map(Name::Input).collect();
    let params: Vec<Name> = model.params.ids().map(Name::Param).collect();
    let outputs: Vec<Name> = model.outputs.ids().map(Name::Output).collect();
    let vars: Vec<Name> = model.vars.ids().map(Name::Var).collect();
    let timed = way.iter().any(|shown| shown.now != 0);
    let heads = ["cycle", "time", "inputs", "cleared", "active", "outputs", "variables"];
    let mut rows = vec![heads.map(str::to_owned).to_vec()];
    rows[0].extend(model.plants.list.iter().map(|plant| plant.model.name.to_string()));
    for (index, shown) in way.iter().enumerate() {
        let on = [
            values(model, &inputs, &given(&own, shown)),
            values(model, &params, &shown.params),
            chosen(model, shown),
            told(shown),
        ]
        .concat();
        rows.push(vec![
            (index + 1).to_string(),
            shown.now.to_string(),
            on.join(", "),
            cleared(&shown.cleared),
            shown.active.join(", "),
            values(model, &outputs, &shown.outputs).join(", "),
            values(model, &vars, &shown.vars).join(", "),
        ]);
        if let Some(row) = rows.last_mut() {
            row.extend(shown.plants.iter().map(|plant| plant.active.join(", ")));
        }
    }
    let is_shown = |column: usize| match column {
        1 => timed,
        5 => !outputs.is_empty(),
        6 => rows[1..].iter().any(|row| !row[6].is_empty()),
        _ => true,
    };
    let columns_in_all = rows[0].len();
    let columns: Vec<usize> = (0..rows[0].len()).filter(|column| is_shown(*column)).collect();
    let widths: Vec<usize> =
        columns.iter().map(|column| rows.iter().map(|row| row[*column].chars().count()).max().unwrap_or(0)).collect();
    if rows.len() > SHOWN {
        rows.splice(SHOWN / 2..=rows.len() - SHOWN / 2, [vec!["…".to_owned(); columns_in_all]]);
    }
    let mut text = String::new();
    for row in &rows {
        let mut line = String::new();
        for (column, width) in columns.iter().zip(&widths) {
            _ = write!(line, "{:<width$} | ", row[*column]);
        }
        _ = writeln!(text, "{}", line.trim_end_matches([' ', '|']));
    }
    let mut asked: Vec<String> = Vec::new();
    for (of, _) in way.iter().flat_map(|shown| &shown.told) {
        let quoted = format!("`{of}`");
        if !asked.contains(&quoted) {
            asked.push(quoted);
        }
    }
    if !asked.is_empty() {
        _ = writeln!(text, "if the program ever comes to these values of {}", asked.join(", "));
    }
    text
}

/// The inputs that are the chart's own.
fn given(own: &[InputId], shown: &Shown) -> Vec<Value> {
    own.iter().filter_map(|id| shown.inputs.get(id.index()).copied()).collect()
}

/// The choices and faults of plants that are on: `Lift::jammed`.
fn chosen(model: &Model, shown: &Shown) -> Vec<String> {
    let mut all = Vec::new();
    for (plant, given) in model.plants.list.iter().zip(&shown.plants) {
        for ((input, wire), value) in plant.model.inputs.values().zip(&plant.wires).zip(&given.inputs) {
            if *wire == Wire::Free && *value == Value::Bool(true) {
                all.push(format!("{}::{}", plant.model.name, input.name));
            }
        }
    }
    all
}

/// What the program said: its numbers, zero too, and what is on.
fn told(shown: &Shown) -> Vec<String> {
    let mut all = Vec::new();
    for (text, value) in &shown.told {
        match value {
            Value::Bool(true) => all.push(text.clone()),
            Value::Bool(false) => {}
            _ => all.push(format!("{text} = {value}")),
        }
    }
    all
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
