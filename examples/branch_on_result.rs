//! A sorter that measures pieces and branches on the result, on a model of its chute.
//! `cargo run --example branch_on_result -- --help` tells what else it can do.

#[path = "charts/branch_on_result.rs"]
pub mod branch_on_result;
#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;

use std::io::{self, Write};
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};

use branch_on_result::{Sorter, SorterInputs, SorterOutputs, SorterStep};
use shared::{Example, Timeline};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "branch_on_result",
    about: "A sorter: an SFC in which a step computes a result and branches on it directly.",
    charts: &[&Sorter::CHART],
    show,
    play: branch_on_result::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

const CYCLES: usize = 27;

/// A chute with a gauge and a box on either side.
struct Chute {
    /// The lengths of the pieces to come in 1/10 mm, the next one last.
    feeder: Vec<u16>,
    /// The piece below the gauge.
    piece: Option<u16>,
    /// For how many cycles it has been on its way to or from there.
    moving: usize,
    /// How often the gauge has been read.
    readings: usize,
    kept: usize,
    rejected: usize,
}

impl Chute {
    /// How many cycles it takes to bring a piece, and to push it away.
    const WAY: usize = 2;
    /// Every so many readings the gauge is shaken and shows 0.1 mm too much.
    const SHAKEN: usize = 3;

    fn new() -> Self {
        Self { feeder: vec![504, 498, 489, 503, 501], piece: None, moving: 0, readings: 0, kept: 0, rejected: 0 }
    }

    fn sensors(&mut self) -> SorterInputs {
        self.readings += 1;
        let shaken = u16::from(self.readings % Self::SHAKEN == 0);
        SorterInputs { piece: self.piece.is_some(), length: self.piece.map_or(0, |length| length + shaken) }
    }

    fn run(&mut self, outputs: SorterOutputs) {
        let moves = if self.piece.is_some() { outputs.keep || outputs.reject } else { outputs.feed };
        self.moving = if moves { self.moving + 1 } else { 0 };
        if self.moving < Self::WAY {
            return;
        }
        self.moving = 0;
        if self.piece.take().is_none() {
            self.piece = self.feeder.pop();
        } else if outputs.keep {
            self.kept += 1;
        } else {
            self.rejected += 1;
        }
    }

    /// `□□ ▬ □`: what has been rejected, the piece below the gauge, and what has been kept.
    fn picture(&self) -> String {
        let boxes = |count| "■".repeat(count);
        let (red, green) = (AnsiColor::Red.on_default(), AnsiColor::Green.on_default());
        let piece = if self.piece.is_some() { '▬' } else { ' ' };
        format!("{red}{:>5}{red:#} │{piece}│ {green}{:5}{green:#}", boxes(self.rejected), boxes(self.kept))
    }
}

fn show(out: &mut dyn Write) -> io::Result<()> {
    let legend = "A piece is kept if it measures 50 mm, give or take 0.3 mm.";
    let mut timeline = Timeline::<Sorter>::new(out, colour, legend, "rejected, gauge, kept", &[])?;
    let mut sorter = Sorter::new();
    let mut chute = Chute::new();
    for _ in 0..CYCLES {
        let step = sorter.situation();
        let inputs = chute.sensors();
        let outputs = sorter.cycle(&inputs);
        let remark = if sorter.situation() == step { "" } else { remark(sorter.situation()) };
        timeline.show(&sorter, &inputs, &outputs, chute.picture(), remark)?;
        chute.run(outputs);
    }
    Ok(())
}

fn colour(output: &str) -> Style {
    match output {
        "keep" => AnsiColor::Green.on_default().bold(),
        "reject" => AnsiColor::Red.on_default().bold(),
        _ => AnsiColor::Yellow.on_default().bold(),
    }
}

fn remark(entered: SorterStep) -> &'static str {
    match entered {
        SorterStep::Feed => "",
        SorterStep::Measure => "computes z",
        SorterStep::Keep => "z is true",
        SorterStep::Reject => "z is false",
    }
}
