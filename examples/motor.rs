//! The motor of the source document on sequential function charts, on a model of the plant: it warms up while it runs,
//! trips, and cools down. `cargo run --example motor -- --help` tells what else it can do.

#[path = "charts/motor.rs"]
pub mod motor;
#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;

use std::io::{self, Write};
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};

use motor::{Motor, MotorInputs, MotorOutputs, MotorStep};
use shared::{Example, Timeline};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "motor",
    about: "A motor with an on and an off button, guarded against over-temperature: an SFC\nof two steps.",
    charts: &[&Motor::CHART],
    show,
    play: motor::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

/// When the operator presses a button.
const ON: [usize; 4] = [2, 8, 23, 28];
const OFF: [usize; 2] = [5, 33];
const CYCLES: usize = 36;

/// A cycle is a second; temperatures are in tenths of a degree Celsius.
struct Plant {
    temperature: i32,
    over_temp: bool,
}

impl Plant {
    const COLD: i32 = 200;
    /// Where a motor that nobody stops would end.
    const HOT: i32 = 1100;
    /// The guard trips at the upper limit and lets go below the lower one.
    const TRIP: i32 = 800;
    const RELEASE: i32 = 600;

    fn new() -> Self {
        Self { temperature: Self::COLD, over_temp: false }
    }

    fn run(&mut self, relay: bool) {
        let goal = if relay { Self::HOT } else { Self::COLD };
        self.temperature += (goal - self.temperature) / 12;
        self.over_temp = self.temperature >= if self.over_temp { Self::RELEASE } else { Self::TRIP };
    }

    /// `65 °C ██████▌` with one block for 10 °C.
    fn picture(&self) -> String {
        const BLOCK: i32 = 100;
        let blocks: String = (0..self.temperature / BLOCK).map(|_| '█').collect();
        let half = if self.temperature % BLOCK >= BLOCK / 2 { "▌" } else { "" };
        let colour = if self.over_temp { AnsiColor::Red } else { AnsiColor::Yellow };
        let style = colour.on_default();
        let bar = blocks + half;
        format!("{:3} °C {style}{bar:9}{style:#}", self.temperature / 10)
    }
}

fn show(out: &mut dyn Write) -> io::Result<()> {
    let legend = "Over-temperature is from 80 °C until it has cooled down to 60 °C.";
    let mut timeline = Timeline::<Motor>::new(out, colour, legend, "plant, 1 s a cycle", &[])?;
    let mut motor = Motor::new();
    let mut plant = Plant::new();
    let mut before = MotorInputs::default();
    for cycle in 0..CYCLES {
        let inputs = MotorInputs { on: ON.contains(&cycle), off: OFF.contains(&cycle), over_temp: plant.over_temp };
        let step = motor.situation();
        let outputs: MotorOutputs = motor.cycle(&inputs);
        let remark = remark(step, motor.situation(), before, inputs);
        timeline.show(&motor, &inputs, &outputs, plant.picture(), remark)?;
        plant.run(outputs.relay);
        before = inputs;
    }
    Ok(())
}

fn colour(output: &str) -> Style {
    match output {
        "green" => AnsiColor::Green.on_default().bold(),
        "red" => AnsiColor::Red.on_default().bold(),
        _ => AnsiColor::Yellow.on_default().bold(),
    }
}

fn remark(from: MotorStep, to: MotorStep, before: MotorInputs, now: MotorInputs) -> &'static str {
    match (from, to) {
        (MotorStep::Off, MotorStep::On) => "starts",
        (MotorStep::On, MotorStep::Off) if now.over_temp => "trips",
        (MotorStep::On, MotorStep::Off) => "stops",
        (MotorStep::Off, MotorStep::Off) if now.on && now.over_temp => "too hot to start",
        _ if before.over_temp && !now.over_temp => "cooled down",
        _ => "",
    }
}
