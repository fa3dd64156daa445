//! A selection of eight branches.

pub use crate::signals::selection::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    Idle,
    A1,
    A2,
    A3,
    A4,
    A5,
    A6,
    A7,
    A8,
}

fn next(step: Step, i: &ChartInputs) -> Step {
    match step {
        Step::Idle if i.start => match i.recipe {
            1 => Step::A1,
            2 => Step::A2,
            3 => Step::A3,
            4 => Step::A4,
            5 => Step::A5,
            6 => Step::A6,
            7 => Step::A7,
            8 => Step::A8,
            _ => Step::Idle,
        },
        Step::Idle => Step::Idle,
        _ if i.done => Step::Idle,
        stay => stay,
    }
}

fn act(step: Step) -> ChartOutputs {
    let mut q = ChartOutputs::default();
    match step {
        Step::Idle => q.ready = true,
        Step::A1 => q.v1 = true,
        Step::A2 => q.v2 = true,
        Step::A3 => q.v3 = true,
        Step::A4 => q.v4 = true,
        Step::A5 => q.v5 = true,
        Step::A6 => q.v6 = true,
        Step::A7 => q.v7 = true,
        Step::A8 => q.v8 = true,
    }
    q.pump = step != Step::Idle;
    q
}

super::dialects!(Idle, 9);
