//! The arguments of `cargo grafcet watch`.

use std::path::PathBuf;

use clap::Args;

use super::place::Wanted;
use crate::args::Charts;

/// Show a running controller in the browser: live, from the frames of its flight recorder
///
/// It follows the charts from their source, keeps what happened last, and serves a page on this machine alone. Which chart a controller runs is known by
/// the fingerprint in its frames. What is lost or damaged on the way is a gap, and nothing is guessed.
#[derive(Args, Debug)]
#[command(after_help = "\
Sources:
  -                       the input of the program: a probe's RTT tool, socat, ssh
  tcp:HOST:PORT           a connection, made again where it is lost
  serial:PORT[:BAUD]      a serial port, as serial:/dev/ttyUSB0 or serial:COM3:9600; else 115200 baud
  FILE                    what was written so far, and what is added
  CHART=…                 any of them, of which it is known what chart runs there

Examples:
  cargo grafcet watch tcp:192.168.1.7:4000
  cargo grafcet watch --file src/cell.rs serial:/dev/ttyUSB0 serial:/dev/ttyUSB1
  probe-rs run --chip STM32G071 press.elf | cargo grafcet watch Press=-
  cargo grafcet watch --steer serial:/dev/ttyUSB0

It runs until Ctrl-C ends it. Exit code 2 says that it could not begin.

Ctrl-C ends it.")]
pub(crate) struct Watch {
    /// Where frames come from; several are shown side by side
    #[arg(value_name = "SOURCE", required = true)]
    pub(crate) sources: Vec<Wanted>,
    /// Only the charts of this file; more than once for several
    #[arg(long, value_name = "FILE")]
    pub(crate) file: Vec<PathBuf>,
    /// Only charts of this name; more than once for several
    #[arg(long, value_name = "NAME")]
    pub(crate) chart: Vec<String>,
    /// The crate of this name in the workspace; more than once for several
    #[arg(long, short, value_name = "NAME", conflicts_with = "file")]
    pub(crate) package: Vec<String>,
    /// All crates of the workspace
    #[arg(long, conflicts_with_all = ["file", "package"])]
    pub(crate) workspace: bool,
    /// The `Cargo.toml` of the crate, instead of the one in this folder or above it
    #[arg(long, value_name = "PATH", conflicts_with = "file")]
    pub(crate) manifest_path: Option<PathBuf>,
    /// So many moments in which something changed are kept of each source, in 32 MiB at most
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(crate) keep: u32,
    /// The port of the page; else one that is free
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) port: u16,
    /// Let the page steer: modes, forcing, Init, where the program on the controller takes commands. For commissioning, with somebody beside the machine
    #[arg(long)]
    pub(crate) steer: bool,
}

impl Watch {
    /// The charts that are looked through.
    pub(crate) fn charts(&self) -> Charts {
        Charts {
            files: self.file.clone(),
            chart: self.chart.clone(),
            package: self.package.clone(),
            workspace: self.workspace,
            manifest_path: self.manifest_path.clone(),
        }
    }
}
