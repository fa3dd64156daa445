//! The figures as tables.

use std::fmt::Write;

use super::{AUTHORS, CYCLES, Cost, Measured, RESOLUTION, RIVALS, Row, TABLES};

/// A figure of a chart's cost.
#[derive(Debug)]
pub(super) struct Figure {
    pub(super) name: &'static str,
    /// None where it is not measured.
    pub(super) of: fn(&Cost) -> Option<u32>,
    /// What is shown is this share of the figure.
    per: u32,
    /// More than this is more.
    pub(super) resolution: u32,
}

pub(super) const FLASH: Figure = Figure { name: "flash", of: |cost| Some(cost.size?.flash), per: 1, resolution: 0 };
pub(super) const BUSY: Figure =
    Figure { name: "instructions, busy", of: |cost| Some(cost.busy), per: CYCLES, resolution: RESOLUTION };
pub(super) const IDLE: Figure =
    Figure { name: "instructions, idle", of: |cost| Some(cost.idle), per: CYCLES, resolution: RESOLUTION };
pub(super) const RAM: Figure = Figure { name: "RAM", of: |cost| Some(cost.size?.ram), per: 1, resolution: 0 };

/// In the order in which they are shown.
pub(super) const FIGURES: [&Figure; 4] = [&FLASH, &BUSY, &IDLE, &RAM];

impl Figure {
    /// What a chart costs as this author wrote it.
    pub(super) fn get(&self, row: &Row, author: usize) -> Option<u32> {
        row.costs[author].as_ref().and_then(self.of)
    }

    /// The least that a rival needs.
    pub(super) fn best(&self, row: &Row) -> Option<u32> {
        (1..=RIVALS).filter_map(|author| self.get(row, author)).min()
    }

    /// The figure as it is shown.
    pub(super) fn show(&self, value: Option<u32>) -> String {
        match (value, self.per) {
            (None, _) => "–".to_owned(),
            (Some(value), 1) => value.to_string(),
            (Some(value), _) => format!("{:.1}", self.shown(value)),
        }
    }

    /// One of it.
    pub(super) fn unit(&self) -> &'static str {
        if self.per == 1 { "a byte" } else { "an instruction" }
    }

    /// The figure as it is shown, as a number.
    pub(super) fn shown(&self, value: u32) -> f64 {
        f64::from(value) / f64::from(self.per)
    }

    /// The cells of one chart on one target: by all authors, the ratio of the first to the best of the others, with a mark
    /// where it is more, and what tables take.
    fn cells(&self, row: &Row) -> String {
        let mut cells = String::new();
        for author in 0..=RIVALS {
            _ = write!(cells, " {} |", self.show(self.get(row, author)));
        }
        match (self.get(row, 0), self.best(row)) {
            (Some(ours), Some(best)) => {
                let mark = if ours > best + self.resolution { "**" } else { "" };
                _ = write!(cells, " {mark}{:.2}{mark} |", f64::from(ours) / f64::from(best));
            }
            _ => cells.push_str(" – |"),
        }
        _ = write!(cells, " {} |", self.show(self.get(row, TABLES)));
        cells
    }
}

/// One figure of all charts wherever it is measured, in Markdown.
pub(super) fn of(figure: &Figure, measured: &Measured) -> String {
    let names = ["grafcet", "by hand", "C", "smlang", "statig", "ratio", "*tables*"];
    let places = places(figure, measured);
    let mut table = String::from("| |");
    let mut rule = String::from("| --- |");
    for (place, _) in &places {
        for name in names {
            _ = write!(table, " {place} {name} |");
            rule.push_str(" --: |");
        }
    }
    _ = writeln!(table, "\n{rule}");
    let Some((_, first)) = places.first() else { return table };
    for row in *first {
        _ = write!(table, "| {} |", row.name);
        for (_, rows) in &places {
            match rows.iter().find(|other| other.name == row.name) {
                Some(row) => table.push_str(&figure.cells(row)),
                None => table.push_str(&" – |".repeat(names.len())),
            }
        }
        table.push('\n');
    }
    table
}

/// The processors on which a figure is measured, with the charts there.
fn places<'a>(figure: &Figure, measured: &'a Measured) -> Vec<(&'a str, &'a [Row])> {
    let boards = measured.boards.iter().map(|(target, rows)| (cpu(target), &rows[..]));
    let places = boards.chain([("host", &measured.host[..])]);
    places.filter(|(_, rows)| rows.iter().any(|row| figure.get(row, 0).is_some())).collect()
}

/// The processor of a target, and what is no target.
pub(super) fn cpu(target: &str) -> &str {
    match target.split_once('-') {
        Some(("thumbv6m", _)) => "M0",
        Some(("thumbv7m", _)) => "M3",
        _ => target,
    }
}

/// The author's name in the tables.
pub(super) fn author(place: usize) -> &'static str {
    ["grafcet", "hand-written Rust", "hand-written C", "smlang", "statig", "one bit per step", "tables in C"]
        .get(place)
        .copied()
        .unwrap_or(AUTHORS[0])
}

#[cfg(test)]
mod tests {
    use super::super::{AUTHORS, Cost, Measured, Row, Size};
    use super::{BUSY, FLASH, IDLE, RAM, of};

    fn row() -> Row {
        let cost = |flash, busy, ram| Some(Cost { hash: 0, busy, idle: 4096, size: Some(Size { flash, ram }) });
        let mut costs = [None; AUTHORS.len()];
        // One tick more is within the resolution of the timer, one byte is not.
        costs[0] = cost(64, 4101, 1);
        costs[1] = cost(63, 4096, 1);
        costs[2] = cost(70, 8192, 2);
        // Who does not compete.
        costs[5] = cost(1, 1, 1);
        costs[6] = cost(9, 1, 1);
        Row { name: "motor sfc".to_owned(), costs }
    }

    #[test]
    fn the_best_rival_counts() {
        assert_eq!(FLASH.cells(&row()), " 64 | 63 | 70 | – | – | **1.02** | 9 |");
        assert_eq!(BUSY.cells(&row()), " 1.0 | 1.0 | 2.0 | – | – | 1.00 | 0.0 |");
    }

    #[test]
    fn places_stand_side_by_side() {
        let mut host = row();
        host.costs.iter_mut().flatten().for_each(|cost| cost.size = None);
        let boards = vec![("thumbv7m-none-eabi", vec![row()]), ("thumbv6m-none-eabi", vec![row()])];
        let measured = Measured { boards, host: vec![host] };
        let last = |figure| of(figure, &measured).lines().last().map(str::to_owned);
        let cells = " 1 | 1 | 2 | – | – | 1.00 | 1 |";
        assert_eq!(last(&RAM), Some(format!("| motor sfc |{cells}{cells}")), "the host has none");
        let cells = " 1.0 | 1.0 | 1.0 | – | – | 1.00 | 1.0 |";
        assert_eq!(last(&IDLE), Some(format!("| motor sfc |{cells}{cells}{cells}")));
        assert!(of(&IDLE, &measured).contains(" M0 ratio | M0 *tables* | host grafcet |"));
    }
}
