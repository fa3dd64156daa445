//! The ring of 16 steps.

pub use crate::signals::seq16::{ChartInputs, ChartOutputs};
use Step::*;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    S0,
    S1,
    S2,
    S3,
    S4,
    S5,
    S6,
    S7,
    S8,
    S9,
    S10,
    S11,
    S12,
    S13,
    S14,
    S15,
}

fn next(step: Step, i: &ChartInputs) -> Step {
    match step {
        S0 if i.x3 => S1,
        S1 if i.x0 => S2,
        S2 if i.x11 => S3,
        S3 if i.x10 => S4,
        S4 if i.x13 => S5,
        S5 if i.x6 => S6,
        S6 if i.x12 => S7,
        S7 if i.x8 => S8,
        S8 if !i.x15 => S9,
        S9 if !i.x4 => S10,
        S10 if i.x14 => S11,
        S11 if i.x1 => S12,
        S12 if i.x2 => S13,
        S13 if i.x7 => S14,
        S14 if i.x9 => S15,
        S15 if i.x5 => S0,
        stay => stay,
    }
}

fn act(step: Step) -> ChartOutputs {
    let mut q = ChartOutputs::default();
    match step {
        S5 => q.q0 = true,
        S8 => q.q1 = true,
        S9 => q.q2 = true,
        S6 => {
            q.q3 = true;
            q.q6 = true;
        }
        S3 => q.q4 = true,
        S11 => q.q5 = true,
        S13 => q.q6 = true,
        S0 => q.q7 = true,
        S2 => {
            q.q7 = true;
            q.q9 = true;
        }
        S15 => {
            q.q7 = true;
            q.q11 = true;
        }
        S12 => q.q8 = true,
        S1 => q.q10 = true,
        S10 => q.q12 = true,
        S4 => q.q13 = true,
        S7 => q.q14 = true,
        S14 => q.q15 = true,
    }
    q
}

super::dialects!(S0, 16);
