//! A pedestrian crossing whose controller sleeps until the chart's next deadline or until somebody presses the button,
//! beside one that scans every millisecond. `cargo run --example tickless -- --help` tells what else it can do.

#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;
#[path = "charts/tickless.rs"]
pub mod tickless;

use std::io::{self, Write};
use std::ops::Range;
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};

use shared::{Example, Timeline};
use tickless::{Controllers, Crossing, CrossingInputs, CrossingOutputs};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "tickless",
    about: "A pedestrian crossing: an SFC with time, whose controller sleeps until\nsomething can change.",
    charts: &[&Crossing::CHART],
    show,
    play: tickless::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

/// While somebody presses the button, in ms.
const BUTTON: [Range<u32>; 3] = [20_000..20_300, 32_500..32_700, 90_000..90_250];
/// How long it is watched, in ms.
const END: u32 = 120_000;

fn show(out: &mut dyn Write) -> io::Result<()> {
    let legend = "The controller sleeps in between.";
    let mut timeline = Timeline::<Crossing>::new(out, colour, legend, "cars, walkers, time, slept before", &[])?;
    let mut both = Controllers::new();
    let (mut asleep_since, mut before) = (0, CrossingInputs::default());
    while both.now <= END {
        let now = both.now;
        let inputs = CrossingInputs { button: BUTTON.iter().any(|pressed| pressed.contains(&now)) };
        if both.tick(inputs) {
            let slept = now - asleep_since;
            let remark = if inputs == before { remark(slept) } else { "the button" };
            timeline.show(&both.sleeper, &inputs, &both.outputs, picture(both.outputs, now, slept), remark)?;
            (asleep_since, before) = (now, inputs);
        }
    }
    let saved = both.now - both.scans;
    writeln!(out, "\n{} scans instead of {}: {saved} saved.", both.scans, both.now)?;
    writeln!(out, "The outputs differed from those of a controller that scans all the time in {} ms.", both.differences)
}

/// `● ▲   20.300 s   0.299 s`
fn picture(outputs: CrossingOutputs, now: u32, slept: u32) -> String {
    let cars = match outputs {
        CrossingOutputs { red: true, .. } => AnsiColor::Red,
        CrossingOutputs { yellow: true, .. } => AnsiColor::Yellow,
        _ => AnsiColor::Green,
    };
    let walkers = if outputs.walk { AnsiColor::Green } else { AnsiColor::Red };
    let (cars, walkers) = (cars.on_default(), walkers.on_default());
    let seconds = |ms: u32| f64::from(ms) / 1000.0;
    let (time, slept) = (seconds(now), seconds(slept));
    format!("{cars}●{cars:#} {walkers}▲{walkers:#} {time:8.3} s {slept:7.3} s")
}

/// Why the chart has been scanned after so many ms without an input that has changed.
fn remark(slept: u32) -> &'static str {
    match slept {
        0 => "power-up",
        1 => "after a change",
        _ => "the time has come",
    }
}

fn colour(output: &str) -> Style {
    match output {
        "green" | "walk" => AnsiColor::Green.on_default().bold(),
        "red" => AnsiColor::Red.on_default().bold(),
        _ => AnsiColor::Yellow.on_default().bold(),
    }
}
