//! The command line.

use std::path::PathBuf;

use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args as Arguments, Parser, Subcommand, ValueEnum};

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::BrightGreen.on_default().bold())
    .usage(AnsiColor::BrightGreen.on_default().bold())
    .literal(AnsiColor::BrightCyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

/// What people do with charts of `grafcet!` outside a build
#[derive(Parser, Debug)]
#[command(name = "cargo grafcet", bin_name = "cargo grafcet", version, styles = STYLES)]
#[command(after_help = "Exit codes: 0 all is well; 1 something is wrong with a chart; 2 it could not be done.")]
pub(crate) struct Args {
    /// Colours: only on terminals (auto), always or never
    #[arg(long, global = true, value_enum, default_value_t, value_name = "WHEN")]
    pub(crate) color: Color,
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Subcommand, Debug)]
pub(crate) enum Command {
    Check(Check),
    Draw(Draw),
    Diff(Diff),
    #[command(subcommand)]
    Export(Export),
    Import(Import),
    Simulate(Simulate),
    Replay(Replay),
    Coverage(Coverage),
    Tests(Tests),
    Prove(Prove),
    #[cfg(feature = "watch")]
    Watch(crate::watch::args::Watch),
}

/// Where the result goes.
#[derive(Arguments, Debug)]
pub(crate) struct Target {
    /// Write the one chart to this file
    #[arg(long, short, value_name = "FILE", conflicts_with = "out")]
    pub(crate) output: Option<PathBuf>,
    /// Write each chart to a file of its name in this folder, which is made where it is not there
    #[arg(long, value_name = "FOLDER")]
    pub(crate) out: Option<PathBuf>,
}

/// Which charts are meant.
#[derive(Arguments, Debug)]
pub(crate) struct Charts {
    /// Files of Rust with calls of `grafcet!`, or with a chart alone; none: the whole crate, with all its modules, examples and tests
    #[arg(value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// Only charts of this name; more than once for several
    #[arg(long, value_name = "NAME")]
    pub(crate) chart: Vec<String>,
    /// The crate of this name in the workspace; more than once for several
    #[arg(long, short, value_name = "NAME", conflicts_with = "files")]
    pub(crate) package: Vec<String>,
    /// All crates of the workspace
    #[arg(long, conflicts_with_all = ["files", "package"])]
    pub(crate) workspace: bool,
    /// The `Cargo.toml` of the crate, instead of the one in this folder or above it
    #[arg(long, value_name = "PATH", conflicts_with = "files")]
    pub(crate) manifest_path: Option<PathBuf>,
}

/// Say what the compiler says about charts: rules and properties
///
/// It finds every `grafcet!` of a crate and shows its mistakes, warnings and properties that do not hold at their places in the file, as the
/// build does, and it builds nothing. What `rustc` alone can know, as the types of your functions, only the build tells.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet check                          the crate in this folder
  cargo grafcet check src/press.rs --chart Press
  cargo grafcet check --watch                  beside the editor
  cargo grafcet check --format sarif > charts.sarif    for code scanning in CI

Exit code 1 says that a chart has errors, with --deny-warnings also that it has warnings.")]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// For people, one JSON object a message, or SARIF 2.1.0
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    pub(crate) format: Format,
    /// The same as --format json
    #[arg(long, conflicts_with_all = ["format", "sarif"])]
    pub(crate) json: bool,
    /// The same as --format sarif
    #[arg(long, conflicts_with = "format")]
    pub(crate) sarif: bool,
    /// Exit code 1 for warnings, too
    #[arg(long)]
    pub(crate) deny_warnings: bool,
    /// Check again whenever one of the files has changed, until Ctrl-C
    #[arg(long, conflicts_with_all = ["format", "json", "sarif"])]
    pub(crate) watch: bool,
    /// Let a solver decide the properties that the checker leaves open, as the feature `prove` of the crate `grafcet` does
    #[arg(long)]
    pub(crate) prove: bool,
}

/// Draw charts: SVG, text for a terminal, Mermaid
///
/// The notation is that of IEC 60848. One chart goes to the output of the program or to a file, several to files in a folder.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet draw --chart Motor              in the terminal
  cargo grafcet draw --chart Motor -o motor.svg
  cargo grafcet draw --out drawings             all charts of the crate as drawings/NAME.svg")]
pub(crate) struct Draw {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// What kind of drawing; else by the end of the file's name, SVG in a folder, and text
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(crate) format: Option<Picture>,
    #[command(flatten)]
    pub(crate) target: Target,
    /// Mark these steps as active
    #[arg(long, value_name = "STEP,…", value_delimiter = ',')]
    pub(crate) active: Vec<String>,
    /// The widest text: what stands side by side stands one below the other where there is no room
    #[arg(long, value_name = "COLUMNS")]
    pub(crate) width: Option<u16>,
}

/// Say what has changed from one version of a chart to another
///
/// Steps, transitions, conditions, actions, what is declared and claimed, and the order where it counts: which transition has priority. What has another name and is
/// otherwise the same is renamed. Blanks and comments do not count. Charts of two files belong together by their names; where there is one in each, these do.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet diff old/motor.rs src/motor.rs
  git show HEAD~1:src/motor.rs > old.rs; cargo grafcet diff old.rs src/motor.rs --draw

Exit code 1 says that something has changed.")]
pub(crate) struct Diff {
    /// A file with the old version
    pub(crate) old: PathBuf,
    /// A file with the new version
    pub(crate) new: PathBuf,
    /// Only the charts of this name
    #[arg(long, value_name = "NAME")]
    pub(crate) chart: Option<String>,
    /// Draw the new version; a dot marks the steps with which something has changed
    #[arg(long, conflicts_with = "json")]
    pub(crate) draw: bool,
    /// One JSON object a change
    #[arg(long)]
    pub(crate) json: bool,
}

/// Write charts in other notations
#[derive(Subcommand, Debug)]
pub(crate) enum Export {
    St(StructuredText),
    Sfc(Sfc),
    Plcopen(Plcopen),
    Pnml(Pnml),
}

/// PNML: a chart as a Petri net, for tools that look at these
///
/// A place for each step and a transition for each transition; conditions become names. Forcing orders and enclosing steps are none of a net.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export pnml --chart Cell -o cell.pnml

Exit code 1 says that a chart has errors or is no net.")]
pub(crate) struct Pnml {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) target: Target,
}

/// SFC of IEC 61131-3 in its textual form: a program with steps, transitions and actions
///
/// For `sfc` charts, whose meaning is that of the standard: one evolution a scan, then the actions. What has no translation is an error at its place, and nothing is written.
/// Rust functions and code actions become declared functions and function blocks that you have to write; they are listed.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export sfc --chart Motor
  cargo grafcet export sfc --chart Motor -o motor.st
  cargo grafcet export sfc --out sfc            all charts of the crate as sfc/NAME.st

Exit code 1 says that a chart has errors or no translation.")]
pub(crate) struct Sfc {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) target: Target,
}

/// PLCopen XML (TC6 2.01): the chart as a drawing of SFC, for CODESYS, Beremiz and others
///
/// For `sfc` charts, as `export sfc`. Steps and transitions stand where `draw` puts them; what leads back is a jump.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export plcopen --chart Motor -o motor.xml
  cargo grafcet export plcopen --chart Motor -o motor.xml --scan-step       for Beremiz
  cargo grafcet export plcopen --out plcopen    all charts of the crate as plcopen/NAME.xml

Exit code 1 says that a chart has errors or no translation.")]
pub(crate) struct Plcopen {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) target: Target,
    /// Let a step of its own, beside the chart, do what is done in each scan: Beremiz needs that, CODESYS has one initial step
    #[arg(long)]
    pub(crate) scan_step: bool,
}

/// Structured text (IEC 61131-3): a function block
///
/// The header of the program says in which points it differs from the chart. What has no translation is an error at its place, and nothing is written. Rust
/// functions and code actions become declared functions and function blocks that you have to write; they are listed.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export st --chart Motor
  cargo grafcet export st --chart Motor --form flip-flops -o motor.st
  cargo grafcet export st --out st              all charts of the crate as st/NAME.st

Exit code 1 says that a chart has errors or no translation.")]
pub(crate) struct StructuredText {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) target: Target,
    /// One CASE for the active step, which acts and then evolves; or a flip-flop for each step, which evolves and then acts
    #[arg(long, value_enum, default_value_t, value_name = "FORM")]
    pub(crate) form: StForm,
    /// The number of the first step of a CASE
    #[arg(long, default_value_t = 10, value_name = "NUMBER")]
    pub(crate) first: u32,
    /// How far the number of the next step is from it
    #[arg(long, default_value_t = 10, value_name = "NUMBER", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) by: u32,
    /// The variable with the number of the active step
    #[arg(long, default_value = "StepNo", value_name = "NAME")]
    pub(crate) step: String,
    /// The input that puts the chart back into its initial situation
    #[arg(long, default_value = "Init", value_name = "NAME")]
    pub(crate) init: String,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum StForm {
    #[default]
    Case,
    FlipFlops,
}

/// Make Rust of charts of PLC tools: PLCopen XML and the textual form of SFC
///
/// Each SFC of the file becomes a chart, as a person would have written it: chains of transitions, names as Rust has them, comments kept. Conditions and actions in structured text
/// are translated; what is not is a stub with its text, and said at its place. What was renamed stands at the top of the file.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet import plc.xml
  cargo grafcet import motor.st -o src/motor.rs

Exit code 1 says that something is to be looked at or to be written, or that the compiler refuses a chart.")]
pub(crate) struct Import {
    /// PLCopen XML (TC6), or `PROGRAM … END_PROGRAM` with steps and transitions
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// Write to this file
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// One JSON object: the source, and of each chart what was renamed and what is to be looked at
    #[arg(long, conflicts_with = "output")]
    pub(crate) json: bool,
}

/// Play with a chart in the terminal
///
/// The chart is drawn with its active steps. Each input has a key, which stands in front of its name: it turns a truth around, takes the next of a list of
/// variants, or asks for a number. Enter makes one cycle, Space lets the chart run, Backspace takes a cycle back, `+` and `-` change the time from one cycle
/// to the next, Ctrl-S saves the session as a script, Esc ends it. Functions and constants of the program around the chart are inputs under their own text;
/// blocks of Rust that cannot be looked into write nothing.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet simulate --chart Motor
  cargo grafcet simulate --chart Motor --save motor.script
  cargo grafcet simulate --chart Motor --script motor.script    without a terminal

Exit code 1 says that the chart has errors, or that a cycle of the script cannot be run.")]
pub(crate) struct Simulate {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// Run the cycles of this file without a terminal: one line a cycle with the inputs that are true
    #[arg(long, value_name = "FILE")]
    pub(crate) script: Option<PathBuf>,
    /// Where Ctrl-S saves the session, also where the file is there already; else in NAME.script, which must be new
    #[arg(long, value_name = "FILE", conflicts_with = "script")]
    pub(crate) save: Option<PathBuf>,
    /// The time from one cycle to the next at the beginning, in ticks of the chart's clock; else a tenth of a second
    #[arg(long, value_name = "TICKS", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) step: Option<u32>,
    /// With --script: one JSON object a cycle
    #[arg(long, requires = "script")]
    pub(crate) json: bool,
    /// With --script: what a terminal of this size shows after each cycle
    #[arg(long, requires = "script", conflicts_with = "json", value_name = "COLUMNSxROWS", value_parser = size)]
    pub(crate) frames: Option<(u16, u16)>,
}

/// `80x24`
fn size(text: &str) -> Result<(u16, u16), String> {
    let numbers = text.split_once('x').and_then(|(columns, rows)| Some((columns.parse().ok()?, rows.parse().ok()?)));
    let fits = numbers.filter(|(columns, rows)| (40..=1000).contains(columns) && (12..=1000).contains(rows));
    fits.ok_or_else(|| "columns and rows as in 80x24, from 40x12 on".to_owned())
}

/// Run a record of the flight recorder again, from the chart's source
///
/// It shows cycle by cycle what the chart did and what it waited for. What is missing or differs from the recorded states is a warning.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet replay cell.record src/cell.rs --chart Cell
  cargo grafcet replay cell.record --chart Cell --html cell.html

Exit code 1 says that there are warnings, or that the record cannot be run.")]
pub(crate) struct Replay {
    /// The memory of a recorder, or what it has sent over a wire
    pub(crate) record: PathBuf,
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// Write a page with the chart and the chronogram to step through
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    /// Write a waveform (VCD)
    #[arg(long, value_name = "FILE")]
    pub(crate) vcd: Option<PathBuf>,
    /// Write a chronogram (SVG)
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Also a record of another version of the chart, with the same inputs and parameters
    #[arg(long)]
    pub(crate) even_if_changed: bool,
}

/// Say what scripts and records have covered of a chart
///
/// Steps, transitions, and of each condition the parts that have decided as true and as false (masking MC/DC). A script has one line a cycle with the inputs
/// that are true.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet coverage --chart Motor --script motor.script
  cargo grafcet coverage --chart Motor --script a.script --script b.script --lcov motor.info

Exit code 1 says that something is not covered.")]
pub(crate) struct Coverage {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// Cycles as lines; more than once for several
    #[arg(long, value_name = "FILE", required_unless_present = "record")]
    pub(crate) script: Vec<PathBuf>,
    /// A record of the flight recorder; more than once for several
    #[arg(long, value_name = "FILE")]
    pub(crate) record: Vec<PathBuf>,
    /// What need not be covered: the beginning of a line of the output; more than once for several
    #[arg(long, value_name = "WORDS")]
    pub(crate) except: Vec<String>,
    /// Write an LCOV file about the chart's source
    #[arg(long, value_name = "FILE")]
    pub(crate) lcov: Option<PathBuf>,
    /// One JSON object instead of lines
    #[arg(long)]
    pub(crate) json: bool,
}

/// Write a test suite out of a chart: as few cycles as show all of it
///
/// Sequences of cycles in which every transition clears, and in which each, its steps being active, does not clear once. What is expected of each cycle is what the chart does:
/// somebody has to confirm that it is what is meant. The sequences are found by trying: in each cycle the values that conditions can tell apart.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet tests --chart Motor                      as scripts, to the output
  cargo grafcet tests --chart Motor --out scripts --pairs
  cargo grafcet tests --chart Motor --rust src/motor_tests.rs --path super
  cargo grafcet tests --chart Motor --protocol motor.md  a page to tick off at the machine

Exit code 1 says that something cannot be shown; it is listed with the reason.")]
pub(crate) struct Tests {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// Each pair of transitions one behind the other, too
    #[arg(long)]
    pub(crate) pairs: bool,
    /// Write the scripts to NAME-1.script and so on in this folder
    #[arg(long, value_name = "FOLDER")]
    pub(crate) out: Option<PathBuf>,
    /// Write a Rust file with a test for each sequence
    #[arg(long, value_name = "FILE")]
    pub(crate) rust: Option<PathBuf>,
    /// Where the Rust file finds the chart's types
    #[arg(long, value_name = "PATH", default_value = "super", requires = "rust")]
    pub(crate) path: String,
    /// Write a page (Markdown) to tick off at the machine
    #[arg(long, value_name = "FILE")]
    pub(crate) protocol: Option<PathBuf>,
    /// The time from one cycle to the next where the chart waits for none, in ticks of its clock; else a tenth of a second
    #[arg(long, value_name = "TICKS", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) step: Option<u32>,
    /// So many cycles are tried on the way to each goal
    #[arg(long, value_name = "CYCLES", default_value_t = 20_000)]
    pub(crate) effort: usize,
    /// One JSON object
    #[arg(long)]
    pub(crate) json: bool,
}

/// Prove or refute what charts claim
///
/// Each property is proved for all inputs and all times, or broken by a way of cycles, which is shown.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet prove --chart Crossing
  cargo grafcet prove --chart Crossing --why     what holds in every situation, from which each proof follows
  cargo grafcet prove --chart Crossing --aiger crossing.aig

Exit code 1 says that a property is broken, undecided, or not modelled.")]
pub(crate) struct Prove {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// The longest time for each property
    #[arg(long, default_value_t = 10, value_name = "SECONDS")]
    pub(crate) seconds: u64,
    /// What holds in every situation, from which each proof follows
    #[arg(long)]
    pub(crate) why: bool,
    /// Write the circuit of the one chart as AIGER, as text where the name ends with .aag
    #[arg(long, value_name = "FILE")]
    pub(crate) aiger: Option<PathBuf>,
    /// Write the circuit of the one chart as BTOR2
    #[arg(long, value_name = "FILE")]
    pub(crate) btor2: Option<PathBuf>,
    /// One JSON object a property
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum Format {
    #[default]
    Human,
    Json,
    Sarif,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Picture {
    Svg,
    Text,
    Mermaid,
}

/// As `anstream` names it.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum Color {
    #[default]
    Auto,
    Always,
    Never,
}

impl Color {
    /// For everything that is written from here on.
    pub(crate) fn write_global(self) {
        let choice = match self {
            Self::Auto => anstream::ColorChoice::Auto,
            Self::Always => anstream::ColorChoice::Always,
            Self::Never => anstream::ColorChoice::Never,
        };
        choice.write_global();
    }
}
