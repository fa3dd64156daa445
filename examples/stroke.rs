//! A press on a model of its ram: it makes a stroke by itself, is paused, goes on step by step and by hand.
//! `cargo run --example stroke -- --help` tells what else it can do.

#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;
#[path = "charts/stroke.rs"]
pub mod stroke;

use std::io::{self, Write};
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};

use shared::{Example, Timeline};
use stroke::{Press, PressInputs, PressOutputs};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "stroke",
    about: "A press with operating modes: automatic, semi-automatic, manual and paused.",
    charts: &[&Press::CHART],
    show,
    play: stroke::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

/// A cycle is half a second.
const MILLIS: u32 = 500;

/// What the operator does, from which cycle on, and what is to be said of it.
const OPERATOR: [(usize, PressInputs, &str); 12] = [
    (1, PressInputs { start: true, ..IDLE }, "a stroke by itself"),
    (2, IDLE, ""),
    (4, PressInputs { paused: true, ..IDLE }, "paused"),
    (6, IDLE, "and on"),
    (18, PressInputs { semi_automatic: true, start: true, ..IDLE }, "step by step"),
    (19, PressInputs { semi_automatic: true, start: true, push: true, ..IDLE }, "pushed"),
    (20, PressInputs { semi_automatic: true, ..IDLE }, ""),
    (22, PressInputs { manual: true, ..IDLE }, "by hand"),
    (23, PressInputs { manual: true, push: true, ..IDLE }, "pushed: before it is down"),
    (24, PressInputs { manual: true, ..IDLE }, ""),
    (25, PressInputs { manual: true, push: true, ..IDLE }, "pushed: no time to hold"),
    (26, IDLE, "automatic again"),
];
const IDLE: PressInputs = PressInputs {
    start: false,
    top: false,
    bottom: false,
    semi_automatic: false,
    manual: false,
    paused: false,
    push: false,
};
const CYCLES: usize = 30;

/// The ram, in steps below its upper end.
struct Ram(usize);

impl Ram {
    const BOTTOM: usize = 5;

    fn run(&mut self, outputs: PressOutputs) {
        self.0 = match (outputs.lower, outputs.lift) {
            (true, _) => (self.0 + 1).min(Self::BOTTOM),
            (_, true) => self.0.saturating_sub(1),
            _ => self.0,
        };
    }

    /// `├──█──┤`, its lower end at the right.
    fn picture(&self) -> String {
        let style = AnsiColor::Yellow.on_default();
        let (above, below) = ("─".repeat(self.0), "─".repeat(Self::BOTTOM - self.0));
        format!("├{above}{style}█{style:#}{below}┤")
    }
}

fn show(out: &mut dyn Write) -> io::Result<()> {
    let legend = "The ram goes down to the right.";
    let mut timeline = Timeline::<Press>::new(out, colour, legend, "ram, ½ s a cycle", &[])?;
    let (mut press, mut ram, mut now) = (Press::new(), Ram(0), 0);
    for cycle in 0..CYCLES {
        let given = OPERATOR.iter().rfind(|(from, ..)| *from <= cycle);
        let (operator, remark) =
            given.map_or((IDLE, ""), |(from, inputs, remark)| (*inputs, if *from == cycle { *remark } else { "" }));
        let inputs = PressInputs { top: ram.0 == 0, bottom: ram.0 == Ram::BOTTOM, ..operator };
        let outputs = press.cycle(&inputs, now);
        timeline.show(&press, &inputs, &outputs, ram.picture(), remark)?;
        ram.run(outputs);
        now += MILLIS;
    }
    Ok(())
}

fn colour(output: &str) -> Style {
    match output {
        "lamp" => AnsiColor::Green.on_default().bold(),
        _ => AnsiColor::Yellow.on_default().bold(),
    }
}
