//! A controller and the plants that stand after it in the same call: what is proved with them runs here as a closed loop, with faults.
//! `cargo run --example pick_and_place -- --help` tells what else it can do.

#[path = "charts/pick_and_place.rs"]
pub mod pick_and_place;
#[path = "charts/script.rs"]
pub mod script;
pub(crate) mod shared;

use std::fmt::Debug;
use std::io::{self, Write};
use std::ops::Range;
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};

use grafcet::Ticks;
use pick_and_place::{
    Arm, ArmInputs, ArmOutputs, Belt, BeltInputs, BeltOutputs, Jaw, JawInputs, JawOutputs, Line, LineInputs,
    LineOutputs, PickAndPlace, PickAndPlaceInputs, PickAndPlaceOutputs, PickAndPlaceStep, Tower, TowerInputs,
    TowerOutputs,
};
use shared::{Example, Timeline};

/// The example, of which the command line chooses what is shown.
pub(crate) const EXAMPLE: Example = Example {
    name: "pick_and_place",
    about: "An arm between a belt and a box: the machine is written after its controller,\nfor proofs and for this closed loop.",
    charts: &[&PickAndPlace::CHART],
    show,
    play: pick_and_place::play,
};

fn main() -> ExitCode {
    EXAMPLE.main()
}

/// What a fault or a choice does to the inputs of the plants.
type Sets = fn(&mut Free);

/// Faults, by name, and when they are on.
const FAULTS: [(&str, Range<usize>, Sets); 3] = [
    ("the lift is jammed", 22..28, |free| free.tower.jammed = true),
    ("there is nothing between the jaws", 35..37, |free| free.jaw.empty = true),
    ("the lift is jammed half way", 51..57, |free| free.tower.jammed = true),
];
const CYCLES: usize = 67;

/// What nobody drives: choices and faults of all plants. As it is made, all takes as long as it may.
#[derive(Default, Clone, Copy)]
pub(crate) struct Free {
    /// When a part is wanted.
    pub(crate) line: LineInputs,
    /// How fast one comes.
    pub(crate) belt: BeltInputs,
    /// How fast the lift is, and whether it is jammed.
    pub(crate) tower: TowerInputs,
    /// How fast the arm is.
    pub(crate) arm: ArmInputs,
    /// Whether there is something to grip.
    pub(crate) jaw: JawInputs,
}

/// What the plants show.
#[derive(Default, Clone, Copy)]
struct Shown {
    line: LineOutputs,
    belt: BeltOutputs,
    tower: TowerOutputs,
    arm: ArmOutputs,
    jaw: JawOutputs,
}

/// The controller and its machine, cycle by cycle, a tick of half a second apart.
pub(crate) struct Loop {
    pub(crate) cell: PickAndPlace,
    pub(crate) line: Line,
    pub(crate) belt: Belt,
    pub(crate) tower: Tower,
    pub(crate) arm: Arm,
    pub(crate) jaw: Jaw,
    shown: Shown,
    now: Ticks,
}

impl Loop {
    /// As the proof begins: the machine stands there when the controller is switched on.
    pub(crate) fn new() -> Self {
        let (line, belt, tower, arm, jaw) = (Line::new(), Belt::new(), Tower::new(), Arm::new(), Jaw::new());
        let cell = PickAndPlace::new();
        let mut all = Self { cell, line, belt, tower, arm, jaw, shown: Shown::default(), now: Ticks::ZERO };
        all.machine(PickAndPlaceOutputs::default(), Free::default());
        all
    }

    /// A cycle of the controller on what the machine showed before, then one of the machine.
    pub(crate) fn cycle(&mut self, free: Free) -> (PickAndPlaceInputs, PickAndPlaceOutputs) {
        let Shown { line, belt, tower, arm, jaw } = self.shown;
        let inputs = PickAndPlaceInputs {
            start: line.start,
            arrived: belt.arrived,
            up: tower.up,
            down: tower.down,
            back: arm.back,
            out: arm.out,
            gripped: jaw.gripped,
        };
        let outputs = self.cell.cycle(&inputs, self.now);
        self.machine(outputs, free);
        self.now = self.now.after(Ticks::new(1));
        (inputs, outputs)
    }

    fn machine(&mut self, told: PickAndPlaceOutputs, free: Free) {
        let PickAndPlaceOutputs { belt, dip, push, grip, done, alarm } = told;
        self.shown = Shown {
            line: self.line.cycle(&LineInputs { done, alarm, ..free.line }),
            belt: self.belt.cycle(&BeltInputs { belt, dip, ..free.belt }, self.now),
            tower: self.tower.cycle(&TowerInputs { dip, ..free.tower }, self.now),
            arm: self.arm.cycle(&ArmInputs { push, ..free.arm }, self.now),
            jaw: self.jaw.cycle(&JawInputs { grip, ..free.jaw }),
        };
    }

    /// In which steps the plants are.
    fn picture(&self) -> String {
        let style = AnsiColor::Yellow.on_default();
        let [belt, tower] = [name(self.belt.situation()), name(self.tower.situation())];
        let [arm, jaw] = [name(self.arm.situation()), name(self.jaw.situation())];
        format!("{style}{belt:6} {tower:6} {arm:6} {jaw:4}{style:#}")
    }
}

fn name(step: impl Debug) -> String {
    format!("{step:?}")
}

fn show(out: &mut dyn Write) -> io::Result<()> {
    let legend = "Half a second a cycle, with what its plants do.";
    let mut timeline = Timeline::<PickAndPlace>::new(out, colour, legend, "belt   lift   arm    jaw", &[])?;
    let mut all = Loop::new();
    let mut above = None;
    for cycle in 0..CYCLES {
        let mut free = Free::default();
        free.line.part_wanted = true;
        // All as fast as it may be; else all would be as slow.
        (free.belt.early_moving, free.tower.early_going, free.tower.early_coming) = (true, true, true);
        (free.arm.early_going, free.arm.early_coming) = (true, true);
        let mut remark = "";
        for (text, _, sets) in FAULTS.iter().filter(|(_, when, _)| when.contains(&cycle)) {
            sets(&mut free);
            remark = text;
        }
        let (inputs, outputs) = all.cycle(free);
        let step = all.cell.situation();
        let entered = above.replace(step) != Some(step);
        if let Some((_, text)) = REMARKS.iter().find(|(of, _)| entered && *of == step) {
            remark = text;
        } else if FAULTS.iter().all(|(_, when, _)| when.start != cycle) {
            remark = "";
        }
        timeline.show(&all.cell, &inputs, &outputs, all.picture(), remark)?;
    }
    Ok(())
}

fn colour(output: &str) -> Style {
    match output {
        "alarm" => AnsiColor::Red.on_default().bold(),
        "done" => AnsiColor::Green.on_default().bold(),
        _ => AnsiColor::Yellow.on_default().bold(),
    }
}

/// What to say when a step is entered.
const REMARKS: [(PickAndPlaceStep, &str); 3] = [
    (PickAndPlaceStep::Lost, "no part, and the alarm says so"),
    (PickAndPlaceStep::Jam, "the part is kept"),
    (PickAndPlaceStep::Done, "placed"),
];
