//! The motor.

pub use crate::signals::motor::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    Off,
    On,
}

fn next(step: Step, i: &ChartInputs) -> Step {
    match step {
        Step::Off if i.on && !i.over_temp => Step::On,
        Step::On if i.off || i.over_temp => Step::Off,
        stay => stay,
    }
}

fn act(step: Step) -> ChartOutputs {
    let on = step == Step::On;
    ChartOutputs { relay: on, green: on, red: !on }
}

super::dialects!(Off, 2);
