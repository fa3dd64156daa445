//! The 24 V production line of the source document on GRAFCET, on a model of a conveyor: a feeder pushes a piece onto the
//! belt, the belt carries it below a nozzle to its end, and there it is taken off.
//! `cargo run --example line24v -- --help` tells what else it can do.

#[path = "charts/line24v.rs"]
pub mod line24v;
#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;

use std::io::{self, Write};
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};

use line24v::{Line24V, Line24VInputs, Line24VOutputs};
use shared::{Example, Timeline};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "line24v",
    about: "A production line of four steps: a GRAFCET with continuous, conditional and\nstored actions.",
    charts: &[&Line24V::CHART],
    show,
    play: line24v::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

const CYCLES: usize = 28;

/// A belt of so many cells, on which a piece moves by one in a cycle.
struct Conveyor {
    /// The cell of the front of the piece that is on its way.
    piece: Option<usize>,
    /// The lengths of the pieces still in the feeder, the next one last.
    feeder: Vec<usize>,
    /// The length of the piece on its way.
    length: usize,
    /// For how many cycles the piece has been lying at the end of the standing belt.
    waiting: usize,
}

impl Conveyor {
    const CELLS: usize = 12;
    /// Where the sensors look at the front of a piece.
    const B1: usize = 1;
    const B2: usize = 4;
    const B3: usize = 10;
    /// Where B5 sees any part of a piece: below the nozzle.
    const B5: usize = 6;
    /// How long it takes to take a piece off.
    const TAKING: usize = 2;

    fn new() -> Self {
        Self { piece: None, feeder: vec![3, 1, 3], length: 0, waiting: 0 }
    }

    fn sensors(&self) -> Line24VInputs {
        let front = |cell| self.piece == Some(cell);
        Line24VInputs {
            b1: front(Self::B1),
            b2: front(Self::B2),
            b3: front(Self::B3) && self.waiting < Self::TAKING,
            b4: self.waiting == Self::TAKING,
            b5: self.covers(Self::B5),
        }
    }

    fn run(&mut self, outputs: Line24VOutputs) {
        if self.waiting == Self::TAKING {
            self.piece = None;
            self.waiting = 0;
        }
        match self.piece {
            Some(Self::B3) if !outputs.q2 => self.waiting += 1,
            // The belt carries a piece, and the feeder pushes one that is not on it yet.
            Some(front) if outputs.q2 || outputs.q1 && front < Self::B1 => self.piece = Some(front + 1),
            None if outputs.q1 => {
                self.piece = self.feeder.pop().map(|length| {
                    self.length = length;
                    0
                });
            }
            _ => {}
        }
    }

    fn covers(&self, cell: usize) -> bool {
        self.waiting < Self::TAKING && self.piece.is_some_and(|front| front >= cell && front < cell + self.length)
    }

    fn picture(&self, spraying: bool) -> String {
        let cells = (0..Self::CELLS).map(|cell| match (self.covers(cell), cell) {
            (true, Self::B5) if spraying => '▓',
            (true, _) => '█',
            (false, _) => '─',
        });
        cells.collect()
    }

    /// The sensors' numbers above their cells.
    fn scale() -> String {
        let cells = (0..Self::CELLS).map(|cell| match cell {
            Self::B1 => '1',
            Self::B2 => '2',
            Self::B5 => '5',
            Self::B3 => '3',
            _ => ' ',
        });
        cells.collect()
    }
}

fn show(out: &mut dyn Write) -> io::Result<()> {
    let legend = "q1 feeds, q2 moves the belt, q3 sprays; b4: it was taken off.";
    let mut timeline = Timeline::<Line24V>::new(out, colour, legend, &Conveyor::scale(), &[])?;
    let mut line = Line24V::new();
    let mut conveyor = Conveyor::new();
    let mut before = line.situation();
    for _ in 0..CYCLES {
        let inputs = conveyor.sensors();
        let outputs = line.cycle(&inputs);
        let remark = if line.situation() == before { "" } else { remark(inputs) };
        timeline.show(&line, &inputs, &outputs, conveyor.picture(outputs.q3), remark)?;
        conveyor.run(outputs);
        before = line.situation();
    }
    Ok(())
}

fn colour(output: &str) -> Style {
    match output {
        "q1" => AnsiColor::Yellow.on_default().bold(),
        "q2" => AnsiColor::Green.on_default().bold(),
        _ => AnsiColor::Magenta.on_default().bold(),
    }
}

/// What the sensor tells that has just moved the line on.
fn remark(inputs: Line24VInputs) -> &'static str {
    match inputs {
        Line24VInputs { b1: true, .. } => "the piece is on the belt",
        Line24VInputs { b2: true, .. } => "near the nozzle",
        Line24VInputs { b3: true, .. } => "at the end",
        Line24VInputs { b4: true, .. } => "taken off",
        _ => "",
    }
}
