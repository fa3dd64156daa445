//! What generated charts cost on a controller, beside the same charts written by hand in Rust and in C and with other
//! crates, and how long they take to build.
//!
//! Three figures, exact and the same in every run: flash, the bytes of code and constants that the linker keeps for the
//! cycle function and all it needs, over an image with nothing in it; instructions per cycle, counted by the emulator,
//! `busy` on random inputs and `idle` with all inputs false; RAM, the size of the chart.

mod builds;
mod figures;
mod goals;
#[path = "../../../benches/build/machines.rs"]
mod machines;
mod measure;
mod page;
mod readme;
mod speed;
mod table;

use self::figures::Recorded;
pub(crate) use self::speed::check;
use self::table::FIGURES;
use crate::command::Result;
use crate::toolchain::BareMetal;

/// Cortex-M3 and Cortex-M0; the code of both runs on the emulated Cortex-M3, whose instructions include those of the
/// other.
const TARGETS: [&str; 2] = ["thumbv7m-none-eabi", "thumbv6m-none-eabi"];

/// Who wrote the charts, by their features in `benches`. The first is compared with the others.
const AUTHORS: [&str; 6] = ["generated", "hand", "c", "smlang", "statig", "flags"];

/// Of [`AUTHORS`], the last that competes: what comes behind is only there to be compared with.
const RIVALS: usize = 4;

/// Cycles per count, as the image in `benches` runs them.
const CYCLES: u32 = 4096;

/// A tick of the emulated timer is five instructions, and a count may be off by a tick at its start and its end.
const RESOLUTION: u32 = 10;

/// What one chart costs as one author wrote it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cost {
    /// Of the outputs on random inputs.
    hash: u32,
    /// Bytes.
    flash: u32,
    /// Instructions of [`CYCLES`] cycles on random inputs.
    busy: u32,
    /// Instructions of [`CYCLES`] cycles with all inputs false.
    idle: u32,
    /// Bytes.
    ram: u32,
}

/// One chart in one dialect, by all authors who wrote it.
#[derive(Debug, PartialEq, Eq)]
struct Row {
    /// As in `seq16 grafcet`.
    name: String,
    costs: [Option<Cost>; AUTHORS.len()],
}

impl Row {
    /// The chart as other authors wrote it: `optimize size;` and `encoding flags;` are for generated charts alone.
    fn written(&self) -> String {
        self.name.replace("_size ", " ").replace("_flags ", " ")
    }
}

/// Measures everything, records the figures and writes the page of costs and the README's table.
///
/// # Errors
/// A tool is missing, a build fails, the authors' charts behave differently, or the generated charts miss a goal.
pub(crate) fn run() -> Result {
    let measured = measure_all()?;
    let compilers = TARGETS.into_iter().map(|target| BareMetal::find(target)?.version()).collect::<Result<Vec<_>>>()?;
    figures::record(&measured, &compilers)?;
    let times = builds::measure()?;
    let goals: Vec<_> = goals::of_costs(&measured).into_iter().chain(goals::of_builds(&times)).collect();
    page::write(&measured, &times, &goals, &compilers)?;
    readme::write(&measured)?;
    print!("{}", goals::table(&goals));
    let missed: Vec<String> = goals.iter().filter(|goal| !goal.is_met()).map(ToString::to_string).collect();
    match missed.len() {
        0 => Ok(()),
        count => Err(format!("{count} goals are missed:\n  {}", missed.join("\n  "))),
    }
}

/// Measures the costs of all charts and shows them.
///
/// # Errors
/// As [`run`], but for the goals: they are shown.
pub(crate) fn cost() -> Result {
    let measured = measure_all()?;
    for figure in FIGURES {
        println!("{}\n\n{}", figure.name, table::of(figure, &measured));
    }
    println!("{}", goals::table(&goals::of_costs(&measured)));
    Ok(())
}

/// All charts by all authors on all targets.
type Measured = Vec<(&'static str, Vec<Row>)>;

fn measure_all() -> Result<Measured> {
    let measure = |target| {
        let rows = measure::all(target, &AUTHORS)?;
        check_equal(target, &rows)?;
        Ok((target, rows))
    };
    TARGETS.into_iter().map(measure).collect()
}

/// Compares the generated charts with the recorded figures.
///
/// # Errors
/// A tool is missing, a build fails, a chart behaves or costs other than recorded.
pub(crate) fn pinned() -> Result {
    compare(&TARGETS)
}

/// The same on the first target alone, which is quick: the other one would take CI more than a minute.
///
/// # Errors
/// As [`pinned`].
pub(crate) fn pinned_on_one() -> Result {
    compare(&TARGETS[..1])
}

fn compare(targets: &[&str]) -> Result {
    let recorded = Recorded::read()?;
    for target in targets {
        let rows = measure::all(target, &AUTHORS[..1])?;
        recorded.compare(target, &BareMetal::find(target)?.version()?, &rows)?;
    }
    Ok(())
}

/// The same work, or the comparison means nothing.
fn check_equal(target: &str, rows: &[Row]) -> Result {
    let differs = |row: &&Row| {
        let mut hashes = row.costs.iter().flatten().map(|cost| cost.hash);
        let first = hashes.next();
        hashes.any(|hash| Some(hash) != first)
    };
    let different: Vec<&str> = rows.iter().filter(differs).map(|row| row.name.as_str()).collect();
    match different[..] {
        [] => Ok(()),
        _ => Err(format!("{target}: the outputs of the authors' charts differ: {}", different.join(", "))),
    }
}
