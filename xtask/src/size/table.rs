//! The figures as a table, and where generated charts exceed hand-written ones.

use std::fmt::Write;

use super::{AUTHORS, CYCLES, Cost, RESOLUTION, Row};

/// A column of the table.
struct Figure {
    name: &'static str,
    of: fn(&Cost) -> u32,
    /// What is shown is this share of the figure.
    per: u32,
    /// More than this is more.
    resolution: u32,
}

const FIGURES: [Figure; 4] = [
    Figure { name: "flash", of: |cost| cost.flash, per: 1, resolution: 0 },
    Figure { name: "busy", of: |cost| cost.busy, per: CYCLES, resolution: RESOLUTION },
    Figure { name: "idle", of: |cost| cost.idle, per: CYCLES, resolution: RESOLUTION },
    Figure { name: "RAM", of: |cost| cost.ram, per: 1, resolution: 0 },
];

impl Figure {
    fn exceeds(&self, row: &Row, author: usize) -> bool {
        (self.of)(&row.costs[0]) > (self.of)(&row.costs[author]) + self.resolution
    }

    fn ratio(&self, row: &Row, author: usize) -> f64 {
        f64::from((self.of)(&row.costs[0])) / f64::from((self.of)(&row.costs[author]))
    }

    fn show(&self, cost: &Cost) -> String {
        match self.per {
            1 => (self.of)(cost).to_string(),
            per => format!("{:.1}", f64::from((self.of)(cost)) / f64::from(per)),
        }
    }
}

/// One line per chart; for each figure those of all authors and the ratios of the first to the others, with a `!`
/// where it is more.
pub(super) fn of(target: &str, rows: &[Row]) -> String {
    let mut table = format!("\n{target}: flash and RAM in bytes, instructions per busy and idle cycle\n{:18}", "");
    for figure in &FIGURES {
        _ = write!(table, " |{:>32}", figure.name);
    }
    _ = write!(table, "\n{:18}", "");
    for _ in &FIGURES {
        _ = write!(table, " |{:>6}{:>6}{:>6}{:>7}{:>7}", "gen", "hand", "C", "/hand ", "/C ");
    }
    table.push('\n');
    for row in rows {
        _ = write!(table, "{:18}", row.name);
        for figure in &FIGURES {
            table.push_str(" |");
            for cost in &row.costs {
                _ = write!(table, "{:>6}", figure.show(cost));
            }
            for author in 1..AUTHORS.len() {
                let mark = if figure.exceeds(row, author) { '!' } else { ' ' };
                _ = write!(table, "{:>6.2}{mark}", figure.ratio(row, author));
            }
        }
        table.push('\n');
    }
    table
}

/// Every place where a generated chart costs more: the chart, the figure, the author.
pub(super) fn excess(rows: &[Row]) -> Vec<String> {
    let mut found = Vec::new();
    for row in rows {
        for figure in &FIGURES {
            for (author, name) in AUTHORS.iter().enumerate().skip(1) {
                if figure.exceeds(row, author) {
                    let ratio = figure.ratio(row, author);
                    found.push(format!("{}, {}: {ratio:.2} of `{name}`", row.name, figure.name));
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::{Cost, Row};
    use super::{excess, of};

    fn rows() -> [Row; 1] {
        let cost = |flash, busy, ram| Cost { hash: 0, flash, busy, idle: 4096, ram };
        // One tick more is within the resolution of the timer, one byte is not.
        [Row { name: "motor sfc".to_owned(), costs: [cost(64, 4101, 1), cost(63, 4096, 1), cost(70, 2048, 2)] }]
    }

    #[test]
    fn more_is_found() {
        assert_eq!(excess(&rows()), ["motor sfc, flash: 1.02 of `hand`", "motor sfc, busy: 2.00 of `c`"]);
    }

    #[test]
    fn more_is_marked() {
        let table = of("thumb", &rows());
        let line = table.lines().last().unwrap_or_default();
        let expected = "motor sfc          |    64    63    70  1.02!  0.91  |   1.0   1.0   0.5  1.00   2.00! \
                        |   1.0   1.0   1.0  1.00   1.00  |     1     1     2  1.00   0.50 ";
        assert_eq!(line, expected);
    }
}
