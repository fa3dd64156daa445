//! The ring of 4 steps.

pub use crate::signals::seq4::{ChartInputs, ChartOutputs};
use Step::*;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    S0,
    S1,
    S2,
    S3,
}

fn next(step: Step, i: &ChartInputs) -> Step {
    match step {
        S0 if i.x2 => S1,
        S1 if i.x0 => S2,
        S2 if i.x3 => S3,
        S3 if !i.x1 => S0,
        stay => stay,
    }
}

fn act(step: Step) -> ChartOutputs {
    let mut q = ChartOutputs::default();
    match step {
        S2 => q.q0 = true,
        S0 => q.q1 = true,
        S1 => q.q2 = true,
        S3 => q.q3 = true,
    }
    q
}

super::dialects!(S0, 4);
