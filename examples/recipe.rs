//! A dyeing machine with two recipes, on a model of its bath; the second batch is begun with the wrong one.
//! `cargo run --example recipe -- --help` tells what else it can do.

#[path = "charts/recipe.rs"]
pub mod recipe;
#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;

use std::io::{self, Write};
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};
use grafcet::Phase;

use recipe::{COTTON, Dyer, DyerActions, DyerInputs, DyerStep, WOOL};
use shared::{Example, Timeline};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "recipe",
    about: "A dyeing machine: an SFC whose steps call actions with the values of a recipe,\nexchanged while it runs.",
    charts: &[&Dyer::CHART],
    show,
    play: recipe::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

/// When the operator starts a batch.
const START: [usize; 2] = [1, 20];
/// When they see that the second one is wool.
const WOOL_SEEN: usize = 25;
const CYCLES: usize = 37;
/// A cycle is a second, and the clock of the chart counts milliseconds.
const CYCLE_MS: u32 = 1000;

/// The bath of the machine, and what the actions have told its heating and its drum.
#[derive(Default)]
struct Machine {
    /// How full it is.
    level: u8,
    /// In °C.
    temperature: i16,
    setpoint: Option<i16>,
    rpm: u16,
}

impl Machine {
    const FULL: u8 = 3;
    /// In °C.
    const COLD: i16 = 20;
    /// By so many °C the bath warms up in a cycle.
    const WARMS: i16 = 8;
    /// By so many °C it cools down.
    const COOLS: i16 = 2;

    fn run(&mut self, inlet: bool, outlet: bool) {
        if inlet {
            self.level += 1;
            self.temperature = Self::COLD;
        }
        if outlet {
            self.level = self.level.saturating_sub(1);
        }
        self.temperature = match self.setpoint {
            Some(setpoint) if self.temperature < setpoint => (self.temperature + Self::WARMS).min(setpoint),
            Some(setpoint) => (self.temperature - Self::COOLS).max(setpoint),
            None => (self.temperature - Self::COOLS).max(Self::COLD),
        };
    }

    fn sensors(&self, start: bool) -> DyerInputs {
        DyerInputs { start, full: self.level == Self::FULL, empty: self.level == 0, temperature: self.temperature }
    }

    /// `██████ to 40 °C  45/min`, with a block for each part of the filling.
    fn picture(&self) -> String {
        let style = AnsiColor::Blue.on_default();
        let bath: String = (0..self.level).map(|_| "██").collect();
        let setpoint = self.setpoint.map_or(String::new(), |setpoint| format!("to {setpoint} °C"));
        format!("{style}{bath:6}{style:#} {setpoint:8} {:2}/min", self.rpm)
    }
}

impl DyerActions for Machine {
    fn heat(&mut self, phase: Phase, setpoint: i16) {
        self.setpoint = (phase != Phase::Final).then_some(setpoint);
    }

    fn drum(&mut self, phase: Phase, rpm: u16) {
        self.rpm = if phase == Phase::Final { 0 } else { rpm };
    }
}

fn show(out: &mut dyn Write) -> io::Result<()> {
    let legend = "Cotton is washed at 40 °C and dyed at 60 °C, wool at 30 °C and 50 °C.";
    let mut timeline = Timeline::<Dyer>::new(out, colour, legend, "bath and drum, 1 s a cycle", &[])?;
    let mut dyer = Dyer::with_params(COTTON);
    let mut machine = Machine { temperature: Machine::COLD, ..Machine::default() };
    let mut now = 0;
    for cycle in 0..CYCLES {
        let step = dyer.situation();
        if cycle == WOOL_SEEN {
            dyer.set_params(WOOL);
        }
        let inputs = machine.sensors(START.contains(&cycle));
        let outputs = dyer.cycle(&inputs, now, &mut machine);
        let remark = match dyer.situation() {
            _ if cycle == WOOL_SEEN => "wool: the other recipe",
            entered if entered != step => remark(entered),
            _ => "",
        };
        timeline.show(&dyer, &inputs, &outputs, machine.picture(), remark)?;
        machine.run(outputs.inlet, outputs.outlet);
        now += CYCLE_MS;
    }
    Ok(())
}

fn colour(output: &str) -> Style {
    match output {
        "ready" => AnsiColor::Green.on_default().bold(),
        _ => AnsiColor::Blue.on_default().bold(),
    }
}

fn remark(entered: DyerStep) -> &'static str {
    match entered {
        DyerStep::Idle => "done",
        DyerStep::Fill => "starts",
        DyerStep::Wash => "washes",
        DyerStep::Dye => "dyes: the same actions",
        DyerStep::Drain => "the drum goes on",
    }
}
