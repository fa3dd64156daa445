//! The table of costs in the README: a choice from the page of costs.

use std::fmt::Write;
use std::fs;

use super::table::{BUSY, FLASH, RAM};
use super::{Boards, Row};
use crate::command::Result;
use crate::project::root;

const FILE: &str = "README.md";

/// Between these lines, which a reader does not see, the table stands.
const MARKS: [&str; 2] = ["<!-- written by `cargo xtask bench` -->\n", "<!-- to here -->\n"];

/// One chart of each kind, and what it is.
const CHARTS: [(&str, &str); 3] = [
    ("chain100 sfc", "a sequence of 100 steps (`sfc`)"),
    ("par8 sfc", "eight parallel branches (`sfc`)"),
    ("cell grafcet", "a cell: emergency stop, modes, two stations (`grafcet`)"),
];

/// Who writes by hand, by the place among the authors: in Rust and in C.
const BY_HAND: [usize; 2] = [1, 2];

/// Writes it anew, as measured on the first target.
pub(super) fn write(boards: &Boards) -> Result {
    let rows = boards.first().map_or(&[][..], |(_, rows)| rows);
    let file = root().join(FILE);
    let readme = fs::read_to_string(&file).map_err(|error| format!("{FILE}: {error}"))?;
    fs::write(&file, replaced(&readme, &table(rows)?)?).map_err(|error| format!("{FILE}: {error}"))
}

/// The text with another table between the marks.
fn replaced(text: &str, table: &str) -> Result<String> {
    let parts = || {
        let (before, rest) = text.split_once(MARKS[0])?;
        let (_, after) = rest.split_once(MARKS[1])?;
        Some(format!("{before}{}\n{table}\n{}{after}", MARKS[0], MARKS[1]))
    };
    parts().ok_or_else(|| format!("{FILE} does not hold the lines {MARKS:?}"))
}

fn table(rows: &[Row]) -> Result<String> {
    let mut table = String::from(
        "| chart | flash, bytes | by hand | instructions of a busy cycle | by hand | RAM, bytes | by hand |\n",
    );
    table += "| --- | --: | --: | --: | --: | --: | --: |\n";
    for (name, what) in CHARTS {
        let row = rows.iter().find(|row| row.name == name);
        let row = row.ok_or_else(|| format!("the table of {FILE} wants {name}, which is not measured"))?;
        _ = write!(table, "| {what} |");
        for figure in [&FLASH, &BUSY, &RAM] {
            let best = BY_HAND.iter().filter_map(|author| figure.get(row, *author)).min();
            for value in [figure.get(row, 0), best] {
                _ = write!(table, " {} |", figure.show(value));
            }
        }
        table.push('\n');
    }
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::super::{AUTHORS, Cost, Recorded, Row, Size, TARGETS};
    use super::{CHARTS, MARKS, replaced, table};

    fn rows() -> Vec<Row> {
        let mut costs = [None; AUTHORS.len()];
        let cost = |busy, flash| Some(Cost { hash: 0, busy, idle: 0, size: Some(Size { flash, ram: 1 }) });
        costs[..4].copy_from_slice(&[cost(67_041, 64), cost(80_000, 90), cost(90_000, 80), cost(1, 1)]);
        CHARTS.iter().map(|(name, _)| Row { name: (*name).to_owned(), costs }).collect()
    }

    #[test]
    fn a_row_for_each_chart() {
        let table = table(&rows()).expect("a table");
        assert_eq!(table.lines().count(), 2 + CHARTS.len());
        let first = "| a sequence of 100 steps (`sfc`) | 64 | 80 | 16.4 | 19.5 | 1 | 1 |";
        assert_eq!(table.lines().nth(2), Some(first), "the best by hand, each figure for itself, and nobody else");
        assert!(super::table(&rows()[1..]).is_err(), "a chart is missing");
    }

    #[test]
    fn only_what_is_between_the_marks_changes() {
        let text = |table: &str| format!("before\n{}{table}{}after\n", MARKS[0], MARKS[1]);
        assert_eq!(replaced(&text("old"), "new\n"), Ok(text("\nnew\n\n")));
        assert!(replaced("no marks", "new\n").is_err());
    }

    #[test]
    fn the_readme_shows_what_is_recorded() {
        let recorded = Recorded::read().expect("the recorded figures");
        let cost = |name: &str, author| recorded.find(TARGETS[0], name, author).expect("figures");
        let row = |(name, _): &(&str, &str)| Row {
            name: (*name).to_owned(),
            costs: AUTHORS.map(|author| cost(name, author)),
        };
        let table = table(&CHARTS.iter().map(row).collect::<Vec<_>>()).expect("a table");
        let readme = std::fs::read_to_string(super::root().join(super::FILE)).expect("the README");
        assert_eq!(replaced(&readme, &table).as_ref(), Ok(&readme));
    }
}
