//! The table of costs in the README: a choice from the page of costs.

use std::fmt::Write;
use std::fs;

use super::table::{BUSY, FLASH, RAM, author};
use super::{Boards, RIVALS, Row};
use crate::command::Result;
use crate::project::root;

const FILE: &str = "README.md";

/// Between these lines, which a reader does not see, the table stands.
const MARKS: [&str; 2] = ["<!-- written by `cargo xtask bench` -->\n", "<!-- to here -->\n"];

/// One chart of each kind; where the dialects do not cost about the same, both.
const CHARTS: [&str; 7] =
    ["line24v sfc", "washer sfc", "chain100 sfc", "par8 sfc", "par8 grafcet", "mixed sfc", "cell grafcet"];

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
    let mut table = String::from("| chart |");
    for place in 0..=RIVALS {
        _ = write!(table, " {} |", author(place));
    }
    table += "\n| --- |";
    table += &" --: |".repeat(RIVALS + 1);
    table.push('\n');
    for chart in CHARTS {
        let row = rows.iter().find(|row| row.name == chart);
        let row = row.ok_or_else(|| format!("the table of {FILE} wants {chart}, which is not measured"))?;
        let cells: Vec<String> = (0..=RIVALS).map(|author| cell(row, author)).collect();
        _ = writeln!(table, "| {chart} | {} |", cells.join(" | "));
    }
    Ok(table)
}

/// Flash, instructions and RAM.
fn cell(row: &Row, author: usize) -> String {
    match row.costs[author] {
        None => "–".to_owned(),
        Some(_) => [&FLASH, &BUSY, &RAM].map(|figure| figure.show(figure.get(row, author))).join(" · "),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{AUTHORS, Cost, Recorded, Row, Size, TARGETS};
    use super::{CHARTS, MARKS, replaced, table};

    fn rows() -> Vec<Row> {
        let mut costs = [None; AUTHORS.len()];
        costs[0] = Some(Cost { hash: 0, busy: 67_041, idle: 0, size: Some(Size { flash: 64, ram: 1 }) });
        CHARTS.iter().map(|name| Row { name: (*name).to_owned(), costs }).collect()
    }

    #[test]
    fn a_row_for_each_chart() {
        let table = table(&rows()).expect("a table");
        assert_eq!(table.lines().count(), 2 + CHARTS.len());
        assert_eq!(table.lines().nth(2), Some("| line24v sfc | 64 · 16.4 · 1 | – | – | – | – |"));
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
        let row = |name: &&str| Row { name: (*name).to_owned(), costs: AUTHORS.map(|author| cost(name, author)) };
        let table = table(&CHARTS.iter().map(row).collect::<Vec<_>>()).expect("a table");
        let readme = std::fs::read_to_string(super::root().join(super::FILE)).expect("the README");
        assert_eq!(replaced(&readme, &table).as_ref(), Ok(&readme));
    }
}
