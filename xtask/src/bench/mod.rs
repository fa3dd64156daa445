//! What generated charts cost on a controller and on the host, beside the same charts written by hand in Rust and in C and
//! with other crates, and how long they take to build.
//!
//! Three figures, exact and the same in every run: flash, the bytes of code and constants that the linker keeps for the
//! cycle function and all it needs, over an image with nothing in it; instructions per cycle, counted by the emulator and
//! on the host by callgrind, `busy` on random inputs and `idle` with all inputs false; RAM, the size of the chart.

mod beside;
mod builds;
mod figures;
mod goals;
mod host;
#[path = "../../../benches/build/machines.rs"]
mod machines;
mod measure;
mod page;
mod readme;
mod speed;
mod table;
mod through;

pub(crate) use self::beside::run as beside;
use self::figures::Recorded;
pub(crate) use self::speed::check;
use self::table::{BUSY, FIGURES, IDLE};
pub(crate) use self::through::run as through;
use crate::command::Result;
use crate::toolchain::{BareMetal, missing};

/// Cortex-M3 and Cortex-M0; the code of both runs on the emulated Cortex-M3, whose instructions include those of the
/// other.
const TARGETS: [&str; 2] = ["thumbv7m-none-eabi", "thumbv6m-none-eabi"];

/// Who wrote the charts, by their features in `benches`. The first is compared with the others.
const AUTHORS: [&str; 7] = ["generated", "hand", "c", "smlang", "statig", "flags", "tables"];

/// Of [`AUTHORS`], the last that competes: what comes after is only there to be compared with.
const RIVALS: usize = 4;

/// The place among them of C with tables, which is shown for orientation.
const TABLES: usize = 6;

/// The compiler of all figures, whatever else is installed: those of two compilers cannot be compared.
const COMPILER: &str = "1.96.0";

/// The chart that takes the compiler so long that CI does without, and the feature that it stands behind.
const LONG: (&str, &str) = ("chain5000 ", "long");

/// Cycles per count, as the program in `benches` runs them.
const CYCLES: u32 = 4096;

/// A tick of the emulated timer is five instructions, and a count may be off by a tick at its start and its end.
const RESOLUTION: u32 = 10;

/// What one chart costs as one author wrote it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cost {
    /// Of the outputs on random inputs.
    hash: u32,
    /// Instructions of [`CYCLES`] cycles on random inputs.
    busy: u32,
    /// Instructions of [`CYCLES`] cycles with all inputs false.
    idle: u32,
    /// On the host it is not measured.
    size: Option<Size>,
}

/// How much of a controller's memory a chart takes, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Size {
    flash: u32,
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
    let (charts, builds) = (charts(), builds());
    match [charts, builds].into_iter().filter_map(Result::err).collect::<Vec<_>>()[..] {
        [] => Ok(()),
        ref errors => Err(errors.join("\n")),
    }
}

/// The same of what charts cost on controllers and the host.
///
/// # Errors
/// As [`run`].
pub(crate) fn charts() -> Result {
    record(&measure_all()?)
}

/// Measures the generated charts anew and takes what is recorded of all others, which a change of the generator leaves as they are.
///
/// # Errors
/// As [`run`].
pub(crate) fn generated() -> Result {
    let (host, recorded) = (measure_host()?, Recorded::read()?);
    let measure = |target| {
        let compiler = pinned_compiler(target)?;
        let mut rows = measure::all(&compiler, target, &AUTHORS[..1])?;
        if !recorded.is_by(target, &compiler.version()?) {
            return Err(format!(
                "{target}: recorded with another compiler; `cargo xtask bench charts` measures all of it"
            ));
        }
        for row in &mut rows {
            for (author, cost) in AUTHORS.iter().zip(&mut row.costs).skip(1) {
                *cost = recorded.find(target, &row.name, author)?;
            }
        }
        check_equal(target, &rows, &host)?;
        Ok((target, rows))
    };
    let boards = TARGETS.into_iter().map(measure).collect::<Result<_>>()?;
    record(&Measured { boards, host })
}

fn record(measured: &Measured) -> Result {
    let compilers = TARGETS.into_iter().map(|target| pinned_compiler(target)?.version()).collect::<Result<Vec<_>>>()?;
    figures::record(&measured.boards, &compilers)?;
    page::write(measured, &compilers)?;
    readme::write(&measured.boards)?;
    judge(&goals::of_costs(&measured.boards))
}

/// The same of how long building takes.
///
/// # Errors
/// As [`run`].
pub(crate) fn builds() -> Result {
    let times = builds::measure()?;
    figures::record_builds(&times)?;
    page::write_builds(&times)?;
    judge(&goals::of_builds(&times))
}

fn judge(goals: &[goals::Goal]) -> Result {
    print!("{}", goals::table(goals));
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
    println!("{}", goals::table(&goals::of_costs(&measured.boards)));
    Ok(())
}

/// Counts the instructions of all charts on the host and shows them.
///
/// # Errors
/// Callgrind is missing, a build fails, or the authors' charts behave differently.
pub(crate) fn on_host() -> Result {
    let measured = Measured { boards: Vec::new(), host: measure_host()? };
    for figure in [BUSY, IDLE] {
        println!("{}\n\n{}", figure.name, table::of(&figure, &measured));
    }
    Ok(())
}

/// All charts by all authors on each of these targets.
type Boards = Vec<(&'static str, Vec<Row>)>;

/// All charts by all authors, wherever they run.
struct Measured {
    boards: Boards,
    host: Vec<Row>,
}

/// The way by [`COMPILER`].
fn pinned_compiler(target: &str) -> Result<BareMetal> {
    BareMetal::of_version(target, COMPILER)?.ok_or_else(|| missing(COMPILER))
}

fn measure_all() -> Result<Measured> {
    // It comes first: it is quick, and has its tool missing before the boards have taken their minutes.
    let host = measure_host()?;
    let measure = |target| {
        let rows = measure::all(&pinned_compiler(target)?, target, &AUTHORS)?;
        check_equal(target, &rows, &host)?;
        Ok((target, rows))
    };
    let boards = TARGETS.into_iter().map(measure).collect::<Result<_>>()?;
    Ok(Measured { boards, host })
}

fn measure_host() -> Result<Vec<Row>> {
    let rows = host::all(&AUTHORS)?;
    check_equal("host", &rows, &rows)?;
    Ok(rows)
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

/// Whether building takes more of statig's time than recorded, or the macro more for some charts beside a ring.
///
/// # Errors
/// A build fails, or one of these takes more.
pub(crate) fn pinned_builds() -> Result {
    let recorded = Recorded::read()?;
    // What another program on the machine adds, a build that is tried once more does not have.
    recorded
        .compare_builds(builds::ratios(1)?)
        .or_else(|_| recorded.compare_builds(builds::ratios(builds::ROUNDS)?))?;
    speed::pinned()
}

fn compare(targets: &[&str]) -> Result {
    let recorded = Recorded::read()?;
    for target in targets {
        // Any compiler will do to see what has become much more.
        let toolchain = BareMetal::of_version(target, COMPILER)?.map_or_else(|| BareMetal::find(target), Ok)?;
        let rows = measure::generated(&toolchain, target)?;
        recorded.compare(target, &toolchain.version()?, &rows)?;
    }
    Ok(())
}

/// The same work, by all authors and as `first` has done it elsewhere, or the comparison means nothing.
fn check_equal(place: &str, rows: &[Row], first: &[Row]) -> Result {
    let differs = |row: &&Row| {
        let first = first.iter().find(|first| first.name == row.name);
        let expected = first.and_then(|first| first.costs[0]).map(|cost| cost.hash);
        row.costs.iter().flatten().any(|cost| Some(cost.hash) != expected)
    };
    let different: Vec<&str> = rows.iter().filter(differs).map(|row| row.name.as_str()).collect();
    match different[..] {
        [] => Ok(()),
        _ => Err(format!("{place}: the outputs of the authors' charts differ: {}", different.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::{AUTHORS, Cost, Row, check_equal};

    #[test]
    fn outputs_differ_between_authors_or_places() {
        let row = |hashes: [u32; 2]| {
            let mut costs = [None; AUTHORS.len()];
            for (place, hash) in hashes.into_iter().enumerate() {
                costs[place] = Some(Cost { hash, busy: 0, idle: 0, size: None });
            }
            [Row { name: "motor sfc".to_owned(), costs }]
        };
        assert_eq!(check_equal("host", &row([7, 7]), &row([7, 8])), Ok(()));
        for (rows, first) in [(row([7, 8]), row([7, 8])), (row([7, 7]), row([8, 8]))] {
            let error = "host: the outputs of the authors' charts differ: motor sfc";
            assert_eq!(check_equal("host", &rows, &first), Err(error.to_owned()));
        }
        assert!(check_equal("host", &row([7, 7]), &[]).is_err(), "a chart is missing elsewhere");
    }
}
