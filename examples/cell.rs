//! A machining cell with an emergency stop, on a model of its conveyor, clamp and stations.
//! `cargo run --example cell -- --help` tells what else it can do.

#[path = "charts/cell.rs"]
pub mod cell;
#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;

use std::io::{self, Write};
use std::ops::Range;
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};

use cell::{Cell, CellInputs, CellOutputs, CellStep};
use shared::{Example, Timeline};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "cell",
    about: "A machining cell: a GRAFCET with forcing, an enclosing step, a macro-step and\nparallel stations.",
    charts: &[&Cell::CHART],
    show,
    play: cell::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

/// When the operator turns the switch to automatic mode, and back.
const AUTO: [Range<usize>; 2] = [1..25, 27..30];
/// While the emergency stop is pressed.
const ESTOP: Range<usize> = 18..22;
/// When the operator acknowledges it, too early at first.
const ACK: [usize; 2] = [20, 23];
const CYCLES: usize = 35;

/// Where a part is, and how far the stations are.
#[derive(Default)]
struct Plant {
    /// The cell of the conveyor on which a part stands.
    part: Option<usize>,
    clamped: bool,
    /// For how many cycles.
    drilled: usize,
    /// For how many cycles.
    stamped: usize,
}

impl Plant {
    /// The conveyor has so many cells.
    const CELLS: usize = 4;
    /// Where the clamp and the stations are.
    const STATION: usize = 2;
    /// In how many cycles a hole is drilled.
    const DRILLED: usize = 4;
    /// In how many cycles a part is stamped.
    const STAMPED: usize = 2;

    fn sensors(&self, cycle: usize) -> CellInputs {
        CellInputs {
            estop: ESTOP.contains(&cycle),
            ack: ACK.contains(&cycle),
            auto: AUTO.iter().any(|on| on.contains(&cycle)),
            part: self.part == Some(Self::STATION),
            clamped: self.clamped,
            drilled: self.drilled == Self::DRILLED,
            stamped: self.stamped == Self::STAMPED,
        }
    }

    fn run(&mut self, outputs: CellOutputs) {
        if outputs.conveyor {
            self.part = match self.part {
                Some(cell) => Some(cell + 1).filter(|cell| *cell < Self::CELLS),
                None => Some(0),
            };
            (self.drilled, self.stamped) = (0, 0);
        }
        self.clamped = outputs.clamp;
        self.drilled = (self.drilled + usize::from(outputs.drill)).min(Self::DRILLED);
        self.stamped = (self.stamped + usize::from(outputs.stamp)).min(Self::STAMPED);
    }

    /// `──[█]─ ▰▰▱▱ ▰▱`: the conveyor with the clamp, the hole and the stamp.
    fn picture(&self, outputs: CellOutputs) -> String {
        let part = |cell| if self.part == Some(cell) { '█' } else { '─' };
        let mut belt: String = (0..Self::STATION).map(part).collect();
        let (left, right) = if self.clamped { ('[', ']') } else { (' ', ' ') };
        belt.extend([left, part(Self::STATION), right]);
        belt.extend((Self::STATION + 1..Self::CELLS).map(part));
        let bar = |done, of| "▰".repeat(done) + &"▱".repeat(of - done);
        let style = |on| if on { AnsiColor::Magenta.on_default().bold() } else { Style::new() };
        let (drill, stamp) = (style(outputs.drill), style(outputs.stamp));
        let (hole, mark) = (bar(self.drilled, Self::DRILLED), bar(self.stamped, Self::STAMPED));
        format!("{belt}  {drill}{hole}{drill:#} {stamp}{mark}{stamp:#}")
    }
}

fn show(out: &mut dyn Write) -> io::Result<()> {
    let legend = "Emergency stop above automatic mode above production.";
    let widest = [CellStep::Ready, CellStep::Auto, CellStep::Drilled, CellStep::Stamped];
    let mut timeline = Timeline::<Cell>::new(out, colour, legend, "hole and stamp", &widest)?;
    let mut cell = Cell::new();
    let mut plant = Plant::default();
    for cycle in 0..CYCLES {
        let before = cell.situation();
        let inputs = plant.sensors(cycle);
        let outputs = cell.cycle(&inputs);
        let entered = |step| cell.is_active(step) && !before.is_active(step);
        let remark = REMARKS.iter().find(|(step, _)| entered(*step)).map_or("", |(_, remark)| remark);
        timeline.show(&cell, &inputs, &outputs, plant.picture(outputs), remark)?;
        plant.run(outputs);
    }
    Ok(())
}

fn colour(output: &str) -> Style {
    match output {
        "alarm" => AnsiColor::Red.on_default().bold(),
        "conveyor" => AnsiColor::Yellow.on_default().bold(),
        "parts" => AnsiColor::Green.on_default().bold(),
        _ => AnsiColor::Magenta.on_default().bold(),
    }
}

/// What to say when a step is entered; where several are, the first of these.
const REMARKS: [(CellStep, &str); 9] = [
    (CellStep::Stopped, "everything stops, the part is held"),
    (CellStep::Manual, "manual mode, nothing is held"),
    (CellStep::Auto, "automatic mode, and its production"),
    (CellStep::Close, "the macro-step: clamps"),
    (CellStep::Stamped, "waits for the other station"),
    (CellStep::Drill, "both stations at once"),
    (CellStep::Release, "done"),
    (CellStep::Deliver, "away with it"),
    (CellStep::Feed, "the next part"),
];
