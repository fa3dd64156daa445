//! Builds the charts of every author for a board and measures them.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use super::{AUTHORS, Cost, LONG, Row, Size};
use crate::command::{Result, capture_within, run, tool};
use crate::image::Linker;
use crate::toolchain::BareMetal;
use crate::{firmware, project};

/// The root that keeps nothing.
const NOTHING: &str = "nothing_root";

/// The root that can panic.
const PANIC: &str = "panic_root";

/// The root that keeps the description of a chart, and a text of it.
const DESCRIPTION: (&str, &[u8]) = ("description_root", b"Unclamp");

/// An image ends within seconds; one that has not by then hangs.
const LIMIT: Duration = Duration::from_secs(120);

/// What the image prints about one chart.
#[derive(Debug, PartialEq, Eq)]
struct Count {
    chart: String,
    dialect: String,
    hash: u32,
    busy: u32,
    idle: u32,
    ram: u32,
}

/// The charts as these authors wrote them, for one target; the first has all of them.
pub(super) fn all(toolchain: &BareMetal, target: &str, authors: &[&'static str]) -> Result<Vec<Row>> {
    println!("bench: {target}, {}", toolchain.describe());
    rows(authors, |author| costs(toolchain, target, &Build { author, features: &features(author), charts: None }))
}

/// The generated charts alone, without those that take the compiler long.
pub(super) fn generated(toolchain: &BareMetal, target: &str) -> Result<Vec<Row>> {
    println!("bench: {target}, {}", toolchain.describe());
    rows(&AUTHORS[..1], |author| costs(toolchain, target, &Build { author, features: author, charts: None }))
}

/// The features of the benches with all charts of one author.
pub(super) fn features(author: &str) -> String {
    if author == AUTHORS[0] { format!("{author},{}", LONG.1) } else { author.to_owned() }
}

/// The charts of these authors side by side; the first has all of them.
pub(super) fn rows(authors: &[&'static str], costs: impl Fn(&str) -> Result<Vec<(String, Cost)>>) -> Result<Vec<Row>> {
    let mut rows: Vec<Row> = Vec::new();
    for author in authors {
        let place = AUTHORS.iter().position(|name| name == author).ok_or_else(|| format!("who is {author}?"))?;
        for (name, cost) in costs(author)? {
            if place == 0 {
                let mut costs = [None; AUTHORS.len()];
                costs[0] = Some(cost);
                rows.push(Row { name, costs });
                continue;
            }
            let mut known = false;
            for row in rows.iter_mut().filter(|row| row.written() == name) {
                row.costs[place] = Some(cost);
                known = true;
            }
            if !known {
                return Err(format!("only `{author}` has the chart {name}"));
            }
        }
    }
    Ok(rows)
}

/// What is built of the benches.
pub(super) struct Build<'a> {
    pub(super) author: &'a str,
    pub(super) features: &'a str,
    /// These charts alone, their names with blanks between them.
    pub(super) charts: Option<&'a str>,
}

/// Every chart of one build.
pub(super) fn costs(toolchain: &BareMetal, target: &str, what: &Build<'_>) -> Result<Vec<(String, Cost)>> {
    let author = what.author;
    let folder = project::target(firmware::FOLDER).join(target).join("release");
    build(toolchain, target, what, &["--bin", "count"])?;
    let counts = count(&folder.join("count"))?;
    build(toolchain, target, what, &["--lib", "--crate-type", "staticlib"])?;
    let library = folder.join("libgrafcet_benches.a");
    let linker =
        if ["c", "tables"].contains(&author) { Linker::with_c(library, target)? } else { Linker::new(library)? };
    check_finders(&linker, what)?;
    let nothing = linker.link(NOTHING)?.flash()?;
    let cost = |count: Count| {
        let Count { chart, dialect, hash, busy, idle, ram } = count;
        let image = linker.link(&format!("{chart}_{dialect}"))?;
        if let Some(symbol) = image.panics()? {
            return Err(format!("{author}: {chart} {dialect} can panic, it reaches `{symbol}`"));
        }
        if image.holds(DESCRIPTION.1)? {
            return Err(format!("{author}: {chart} {dialect} links the description though it does not use it"));
        }
        let size = Some(Size { flash: image.flash()?.saturating_sub(nothing), ram });
        Ok((format!("{chart} {dialect}"), Cost { hash, busy, idle, size }))
    };
    counts.into_iter().map(cost).collect()
}

/// What is looked for in the images is found in those that hold it.
fn check_finders(linker: &Linker, what: &Build<'_>) -> Result {
    if linker.link(PANIC)?.panics()?.is_none() {
        return Err(format!("no panic is found in {PANIC}: the names to look for have changed"));
    }
    let described = what.author == AUTHORS[0] && what.charts.is_none();
    if described && !linker.link(DESCRIPTION.0)?.holds(DESCRIPTION.1)? {
        return Err(format!("no description is found in {}", DESCRIPTION.0));
    }
    Ok(())
}

fn build(toolchain: &BareMetal, target: &str, what: &Build<'_>, artefact: &[&str]) -> Result {
    let mut command = toolchain.cargo("rustc", target);
    command.args(["--quiet", "--locked", "--release", "--manifest-path", "benches/Cargo.toml", "--features"]);
    command.arg(what.features).envs(what.charts.map(|charts| ("GRAFCET_CHARTS", charts)));
    run(command.args(artefact).arg("--target-dir").arg(project::target(firmware::FOLDER)))
}

/// Runs the image that counts.
fn count(image: &Path) -> Result<Vec<Count>> {
    let qemu: PathBuf = tool("qemu-system-arm", "qemu-system-arm")?;
    let mut command = Command::new(qemu);
    // Without counters of time, every instruction takes the same time.
    command.args(["-cpu", "cortex-m3", "-machine", "lm3s6965evb", "-nographic", "-icount", "shift=0"]);
    command.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(image);
    let lines = capture_within(&mut command, LIMIT)?;
    let counts: Vec<Count> = lines.lines().map(parse).collect::<Result<_>>()?;
    match counts.len() {
        0 => Err(format!("{} counted nothing", image.display())),
        _ => Ok(counts),
    }
}

/// `motor sfc 811c9dc5 53248 49152 1`
fn parse(line: &str) -> Result<Count> {
    let count = || {
        let [chart, dialect, hash, busy, idle, ram] = line.split(' ').collect::<Vec<_>>()[..] else { return None };
        Some(Count {
            chart: chart.to_owned(),
            dialect: dialect.to_owned(),
            hash: u32::from_str_radix(hash, 16).ok()?,
            busy: busy.parse().ok()?,
            idle: idle.parse().ok()?,
            ram: ram.parse().ok()?,
        })
    };
    count().ok_or_else(|| format!("not a count: {line}"))
}

#[cfg(test)]
mod tests {
    use super::{Count, parse};

    #[test]
    fn a_line_of_the_image() {
        let count = Count {
            chart: "motor".to_owned(),
            dialect: "sfc".to_owned(),
            hash: 0x811c_9dc5,
            busy: 53248,
            idle: 49152,
            ram: 1,
        };
        assert_eq!(parse("motor sfc 811c9dc5 53248 49152 1"), Ok(count));
        assert_eq!(parse("panicked at 3"), Err("not a count: panicked at 3".to_owned()));
    }
}
