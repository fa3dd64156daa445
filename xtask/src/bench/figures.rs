//! The recorded figures, with which CI compares.

use std::fmt::Write;
use std::fs;

use super::table::FIGURES;
use super::{AUTHORS, Boards, Cost, Row, Size};
use crate::command::Result;
use crate::project::root;

const FILE: &str = "benches/figures.txt";

const HEADER: &str = "\
# Written by `cargo xtask bench`: for each target the compiler, then for each chart, dialect and author the bytes of flash, the
# instructions of 4096 busy and of 4096 idle cycles, the bytes of RAM, the hash of the outputs.
";

/// In another folder crates have other hashes, and the linker puts functions elsewhere: one of so many parts.
const OTHER_FOLDER: u32 = 100;

/// With another compiler than the recorded one, figures may be larger by one of so many parts.
const OTHER_COMPILER: u32 = 10;

/// What a run before has measured.
pub(super) struct Recorded {
    text: String,
}

impl Recorded {
    pub(super) fn read() -> Result<Self> {
        let text = fs::read_to_string(root().join(FILE)).map_err(|error| format!("{FILE}: {error}"))?;
        Ok(Self { text })
    }

    /// Says where generated charts cost more than is recorded.
    pub(super) fn compare(&self, target: &str, compiler: &str, rows: &[Row]) -> Result {
        let recorded = self.text.lines().find_map(|line| line.strip_prefix(target)?.strip_prefix(" compiler "));
        let recorded = recorded.ok_or_else(|| format!("{FILE} has no compiler for {target}"))?;
        let same = recorded == compiler;
        if !same {
            println!("bench: recorded with {recorded}; with {compiler} a figure may be larger by a tenth");
        }
        let mut problems = Vec::new();
        for row in rows {
            let Some(cost) = &row.costs[0] else { continue };
            match self.find(target, &row.name, AUTHORS[0])? {
                None => problems.push(format!("{} is not recorded", row.name)),
                Some(recorded) if recorded.hash != cost.hash => {
                    problems.push(format!("{} has other outputs than recorded", row.name));
                }
                Some(recorded) => problems.extend(excess(&row.name, cost, &recorded, same)),
            }
        }
        let prefix = format!("{target} ");
        let known = self.text.lines().filter(|line| line.starts_with(&prefix) && line.contains(" generated ")).count();
        if known != rows.len() {
            problems.push(format!("{known} charts are recorded, {} are measured", rows.len()));
        }
        match problems.len() {
            0 => {
                println!("bench: {target}: {known} charts cost what is recorded, or less");
                Ok(())
            }
            _ => {
                Err(format!("{target}: {}\n`cargo xtask bench` records what is meant to be so", problems.join("\n  ")))
            }
        }
    }

    /// The recorded cost of a chart as an author wrote it.
    pub(super) fn find(&self, target: &str, name: &str, author: &str) -> Result<Option<Cost>> {
        let prefix = format!("{target} {name} {author} ");
        self.text.lines().find_map(|line| line.strip_prefix(&prefix)).map(parse).transpose()
    }
}

fn excess<'a>(name: &'a str, cost: &'a Cost, recorded: &'a Cost, same: bool) -> impl Iterator<Item = String> + 'a {
    FIGURES.into_iter().filter_map(move |figure| {
        let (now, before) = ((figure.of)(cost)?, (figure.of)(recorded)?);
        let tolerance = if same { figure.resolution.max(before / OTHER_FOLDER) } else { before / OTHER_COMPILER };
        (now > before + tolerance).then(|| format!("{name}, {}: {now}, recorded {before}", figure.name))
    })
}

/// `64 67041 57351 1 14701dc5`
fn parse(figures: &str) -> Result<Cost> {
    let cost = || {
        let [flash, busy, idle, ram, hash] = figures.split(' ').collect::<Vec<_>>()[..] else { return None };
        Some(Cost {
            hash: u32::from_str_radix(hash, 16).ok()?,
            busy: busy.parse().ok()?,
            idle: idle.parse().ok()?,
            size: Some(Size { flash: flash.parse().ok()?, ram: ram.parse().ok()? }),
        })
    };
    cost().ok_or_else(|| format!("{FILE}: not a cost: {figures}"))
}

/// Writes all figures of the boards. The host's are not compared: its compiler is any that the user has.
pub(super) fn record(boards: &Boards, compilers: &[String]) -> Result {
    let file = root().join(FILE);
    fs::write(&file, text(boards, compilers)).map_err(|error| format!("{}: {error}", file.display()))
}

fn text(boards: &Boards, compilers: &[String]) -> String {
    let mut text = HEADER.to_owned();
    for ((target, rows), compiler) in boards.iter().zip(compilers) {
        _ = writeln!(text, "{target} compiler {compiler}");
        for row in rows {
            for (author, cost) in AUTHORS.iter().zip(&row.costs) {
                if let Some(Cost { hash, busy, idle, size: Some(Size { flash, ram }) }) = cost {
                    _ = writeln!(text, "{target} {} {author} {flash} {busy} {idle} {ram} {hash:08x}", row.name);
                }
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::{AUTHORS, Cost, Row, Size};
    use super::{Recorded, text};

    fn row(flash: u32, busy: u32) -> Row {
        let mut costs = [None; AUTHORS.len()];
        costs[0] = Some(Cost { hash: 7, busy, idle: 4096, size: Some(Size { flash, ram: 1 }) });
        Row { name: "motor sfc".to_owned(), costs }
    }

    fn recorded() -> Recorded {
        Recorded { text: text(&vec![("thumb", vec![row(64, 50_000)])], &["rustc 1.96".to_owned()]) }
    }

    fn compare(compiler: &str, row: Row) -> Result<(), String> {
        recorded().compare("thumb", compiler, &[row])
    }

    #[test]
    fn what_is_recorded_or_less_passes() {
        assert_eq!(compare("rustc 1.96", row(64, 50_500)), Ok(()));
        assert_eq!(compare("rustc 1.96", row(60, 40_000)), Ok(()));
    }

    #[test]
    fn more_fails() {
        let error = compare("rustc 1.96", row(65, 50_501)).expect_err("both are more");
        let expected =
            "thumb: motor sfc, flash: 65, recorded 64\n  motor sfc, instructions, busy: 50501, recorded 50000\n";
        assert!(error.starts_with(expected), "{error}");
    }

    #[test]
    fn another_compiler_has_a_tenth() {
        assert_eq!(compare("rustc 1.97", row(70, 55_000)), Ok(()));
        assert!(compare("rustc 1.97", row(71, 55_000)).is_err());
    }

    #[test]
    fn other_outputs_and_other_charts_fail() {
        let mut other = row(64, 50_000);
        other.costs[0].as_mut().expect("a cost").hash = 8;
        assert!(compare("rustc 1.96", other).is_err());
        let unknown = Row { name: "motor grafcet".to_owned(), ..row(1, 1) };
        assert!(compare("rustc 1.96", unknown).is_err());
        assert!(recorded().compare("thumb", "rustc 1.96", &[]).is_err());
    }
}
