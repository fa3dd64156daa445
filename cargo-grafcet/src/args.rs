//! The command line: what all commands share. What one of them takes stands beside what it does.

use std::path::PathBuf;

use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args as Arguments, Parser, Subcommand, ValueEnum};

use crate::check::Check;
use crate::coverage::Coverage;
use crate::diff::Diff;
use crate::draw::Draw;
use crate::export::Export;
use crate::import::Import;
use crate::prove::Prove;
use crate::replay::Replay;
use crate::simulate::Simulate;
use crate::suite::Tests;

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
