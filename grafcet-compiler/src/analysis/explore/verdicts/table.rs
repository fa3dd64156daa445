//! A way as a table, for whoever has to follow it cycle by cycle.

use super::path::{Path, PathCycle};
use crate::list::{List, PushAll};
use crate::model::{Model, TransitionId};

/// A line of the table.
type Row = [String; 4];

impl Path {
    /// The cycles one by one: what they are given, what clears, which steps are active at their end.
    #[must_use]
    pub fn table(&self, model: &Model) -> String {
        const SHOWN: usize = 24;
        let head = ["cycle", "inputs", "cleared", "active"].map(str::to_owned);
        let mut rows: Vec<Row> = vec![head];
        if self.skips_first {
            rows.push(row(model, 1, &PathCycle { given: Vec::new(), cleared: Vec::new(), active: self.start.clone() }));
        }
        let first = rows.len();
        let cycles = self.cycles.iter().enumerate();
        rows.push_all(cycles.map(|(index, cycle)| row(model, first + index, cycle)));
        if rows.len() > SHOWN {
            rows.splice(SHOWN / 2..=rows.len() - SHOWN / 2, [["…"; 4].map(str::to_owned)]);
        }
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths = [width(0), width(1), width(2)];
        let mut text = String::new();
        for row in &rows {
            for (cell, width) in row.iter().zip(widths) {
                text.push_str(cell);
                text.extend(std::iter::repeat_n(' ', width - cell.chars().count()));
                text.push_str(" | ");
            }
            text.push_str(&row[3]);
            text.push('\n');
        }
        text.pop();
        text
    }
}

fn row(model: &Model, number: usize, cycle: &PathCycle) -> Row {
    let given: Vec<String> = cycle.given.iter().map(|given| given.text(model)).list();
    let cleared: Vec<String> = cycle.cleared.iter().map(|id| arc(model, *id)).list();
    let or = |text: String, otherwise: &str| if text.is_empty() { otherwise.to_owned() } else { text };
    [number.to_string(), or(given.join(", "), "any"), or(cleared.join(", "), "-"), model.steps_text(&cycle.active)]
}

fn arc(model: &Model, id: TransitionId) -> String {
    model.transition_text(&model.transitions[id]).replace('`', "")
}
