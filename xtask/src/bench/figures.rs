//! The recorded figures, with which CI compares.

use std::fmt::Write;
use std::fs;

use super::builds::{Times, WATCHED};
use super::table::{FIGURES, Figure};
use super::{AUTHORS, Boards, Cost, LONG, Row, Size};
use crate::command::Result;
use crate::project::root;

const FILE: &str = "benches/figures.txt";

/// In front of what building takes.
const BUILD: &str = "host build ";

const HEADER: &str = "\
# Written by `cargo xtask bench`: for each target the compiler, then for each chart, dialect and author the bytes of flash, the
# instructions of 4096 busy and of 4096 idle cycles, the bytes of RAM, the hash of the outputs. At the end, how many times statig's
# processor time building takes.
";

/// In another folder crates have other hashes, and the linker puts functions elsewhere: one of so many parts.
const OTHER_FOLDER: u32 = 100;

/// With another compiler than the recorded one, figures may be larger by one of so many parts.
const OTHER_COMPILER: u32 = 10;

/// A build is measured once, beside whatever else the machine does: the ratio moves by so many parts (3.26 on quiet cores, 3.7 on busy
/// ones).
const OTHER_RUN: f64 = 3.0;

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
                Some(recorded) => {
                    show_change(&row.name, cost, &recorded);
                    problems.extend(excess(&row.name, cost, &recorded, same));
                }
            }
        }
        let prefix = format!("{target} ");
        let recorded = self.text.lines().filter_map(|line| line.strip_prefix(&prefix));
        let known = recorded.filter(|line| line.contains(" generated ") && !line.starts_with(LONG.0)).count();
        let measured = rows.iter().filter(|row| !row.name.starts_with(LONG.0)).count();
        if known != measured {
            problems.push(format!("{known} charts are recorded, {measured} are measured"));
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

    /// Says where building takes more of statig's time than is recorded.
    pub(super) fn compare_builds(&self, ratios: [f64; 2]) -> Result {
        for (name, now) in WATCHED.into_iter().zip(ratios) {
            let prefix = format!("{BUILD}{name} ");
            let recorded = self.text.lines().find_map(|line| line.strip_prefix(&prefix)?.parse::<f64>().ok());
            let Some(recorded) = recorded else {
                println!(
                    "bench: build {name}: {now:.2} times statig's processor time; `cargo xtask bench builds` records it"
                );
                continue;
            };
            println!("bench: build {name}: {now:.2} times statig's processor time, recorded {recorded:.2}");
            if now > recorded + recorded / OTHER_RUN {
                return Err(format!(
                    "building ({name}) takes {now:.2} times statig's processor time, recorded is {recorded:.2}"
                ));
            }
        }
        Ok(())
    }

    /// Whether this compiler has made what is recorded for a target.
    pub(super) fn is_by(&self, target: &str, compiler: &str) -> bool {
        self.text.lines().any(|line| line == format!("{target} compiler {compiler}"))
    }

    /// The recorded cost of a chart as an author wrote it.
    pub(super) fn find(&self, target: &str, name: &str, author: &str) -> Result<Option<Cost>> {
        let prefix = format!("{target} {name} {author} ");
        self.text.lines().find_map(|line| line.strip_prefix(&prefix)).map(parse).transpose()
    }
}

/// Shows what has changed: what is less than recorded is no problem, but worth recording.
fn show_change(name: &str, cost: &Cost, recorded: &Cost) {
    let shown = |figure: &Figure| {
        let (now, before) = ((figure.of)(cost), (figure.of)(recorded));
        let moved = now.zip(before).is_some_and(|(now, before)| now.abs_diff(before) > figure.resolution);
        moved.then(|| format!("{} {} → {}", figure.name, figure.show(before), figure.show(now)))
    };
    let changes: Vec<String> = FIGURES.iter().copied().filter_map(shown).collect();
    if !changes.is_empty() {
        println!("bench:   {name}: {}", changes.join("; "));
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

/// Writes all figures of the boards. The host's are not compared.
pub(super) fn record(boards: &Boards, compilers: &[String]) -> Result {
    let old = Recorded::read()?.text;
    write(text(boards, compilers), old.lines().filter(|line| line.starts_with(BUILD)))
}

/// Writes what building takes.
pub(super) fn record_builds(times: &Times) -> Result {
    let old = Recorded::read()?.text;
    let ratios = WATCHED.iter().zip(times.ratios());
    let lines: Vec<String> = ratios.map(|(name, ratio)| format!("{BUILD}{name} {ratio:.2}")).collect();
    let kept: Vec<&str> = old.lines().filter(|line| !line.starts_with(BUILD)).collect();
    write(kept.join("\n") + "\n", lines.iter().map(String::as_str))
}

fn write<'a>(mut text: String, builds: impl Iterator<Item = &'a str>) -> Result {
    for line in builds {
        _ = writeln!(text, "{line}");
    }
    fs::write(root().join(FILE), text).map_err(|error| format!("{FILE}: {error}"))
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
    fn building_may_take_a_little_more() {
        let recorded = Recorded { text: "host build clean 2.70\nhost build small 1.20\n".to_owned() };
        assert_eq!(recorded.compare_builds([3.5, 1.5]), Ok(()));
        assert!(recorded.compare_builds([3.7, 1.2]).is_err() && recorded.compare_builds([2.7, 1.7]).is_err());
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
