//! The ring of 64 steps.

pub use crate::signals::seq64::{ChartInputs, ChartOutputs};
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
    S16,
    S17,
    S18,
    S19,
    S20,
    S21,
    S22,
    S23,
    S24,
    S25,
    S26,
    S27,
    S28,
    S29,
    S30,
    S31,
    S32,
    S33,
    S34,
    S35,
    S36,
    S37,
    S38,
    S39,
    S40,
    S41,
    S42,
    S43,
    S44,
    S45,
    S46,
    S47,
    S48,
    S49,
    S50,
    S51,
    S52,
    S53,
    S54,
    S55,
    S56,
    S57,
    S58,
    S59,
    S60,
    S61,
    S62,
    S63,
}

fn next(step: Step, i: &ChartInputs) -> Step {
    match step {
        S0 if i.x7 => S1,
        S1 if !i.x4 => S2,
        S2 if i.x5 => S3,
        S3 if !i.x1 => S4,
        S4 if i.x0 => S5,
        S5 if i.x15 => S6,
        S6 if !i.x2 => S7,
        S7 if i.x0 => S8,
        S8 if !i.x11 => S9,
        S9 if i.x6 => S10,
        S10 if !i.x13 => S11,
        S11 if i.x14 => S12,
        S12 if i.x12 => S13,
        S13 if i.x6 => S14,
        S14 if i.x0 => S15,
        S15 if !i.x10 => S16,
        S16 if i.x15 => S17,
        S17 if i.x7 => S18,
        S18 if i.x14 => S19,
        S19 if i.x4 => S20,
        S20 if !i.x1 => S21,
        S21 if i.x5 => S22,
        S22 if !i.x8 => S23,
        S23 if !i.x10 => S24,
        S24 if i.x11 => S25,
        S25 if i.x9 => S26,
        S26 if i.x8 => S27,
        S27 if i.x13 => S28,
        S28 if !i.x4 => S29,
        S29 if !i.x12 => S30,
        S30 if i.x8 => S31,
        S31 if i.x7 => S32,
        S32 if i.x1 => S33,
        S33 if i.x3 => S34,
        S34 if !i.x13 => S35,
        S35 if i.x3 => S36,
        S36 if !i.x6 => S37,
        S37 if i.x10 => S38,
        S38 if i.x12 => S39,
        S39 if i.x9 => S40,
        S40 if i.x7 => S41,
        S41 if i.x10 => S42,
        S42 if !i.x15 => S43,
        S43 if !i.x1 => S44,
        S44 if !i.x5 => S45,
        S45 if !i.x9 => S46,
        S46 if i.x12 => S47,
        S47 if !i.x11 => S48,
        S48 if !i.x14 => S49,
        S49 if !i.x0 => S50,
        S50 if i.x11 => S51,
        S51 if i.x15 => S52,
        S52 if !i.x2 => S53,
        S53 if i.x8 => S54,
        S54 if !i.x3 => S55,
        S55 if i.x9 => S56,
        S56 if i.x4 => S57,
        S57 if i.x2 => S58,
        S58 if !i.x6 => S59,
        S59 if i.x5 => S60,
        S60 if !i.x3 => S61,
        S61 if !i.x2 => S62,
        S62 if i.x14 => S63,
        S63 if !i.x13 => S0,
        stay => stay,
    }
}

fn act(step: Step) -> ChartOutputs {
    let mut q = ChartOutputs::default();
    match step {
        S14 | S26 | S50 => q.q0 = true,
        S4 => {
            q.q0 = true;
            q.q6 = true;
        }
        S31 => {
            q.q0 = true;
            q.q8 = true;
        }
        S28 => {
            q.q0 = true;
            q.q12 = true;
        }
        S2 | S20 => q.q1 = true,
        S17 | S39 => {
            q.q1 = true;
            q.q5 = true;
        }
        S36 => {
            q.q1 = true;
            q.q11 = true;
        }
        S49 | S52 => {
            q.q1 = true;
            q.q12 = true;
        }
        S33 => {
            q.q1 = true;
            q.q14 = true;
        }
        S37 | S42 | S44 | S51 => q.q2 = true,
        S23 => {
            q.q2 = true;
            q.q9 = true;
        }
        S40 | S61 => q.q3 = true,
        S11 => {
            q.q3 = true;
            q.q4 = true;
        }
        S59 => {
            q.q3 = true;
            q.q11 = true;
        }
        S9 => {
            q.q3 = true;
            q.q15 = true;
        }
        S47 | S53 => q.q4 = true,
        S0 => {
            q.q4 = true;
            q.q9 = true;
        }
        S35 => {
            q.q4 = true;
            q.q13 = true;
        }
        S25 | S30 | S56 => q.q5 = true,
        S6 | S13 | S15 | S38 => q.q6 = true,
        S10 | S60 | S62 => q.q7 = true,
        S54 => {
            q.q7 = true;
            q.q9 = true;
        }
        S63 => {
            q.q7 = true;
            q.q15 = true;
        }
        S1 | S45 | S55 => q.q8 = true,
        S22 => {
            q.q8 = true;
            q.q14 = true;
        }
        S5 => q.q9 = true,
        S41 => {
            q.q9 = true;
            q.q10 = true;
        }
        S3 | S7 => {
            q.q9 = true;
            q.q15 = true;
        }
        S21 | S32 | S43 | S46 => q.q10 = true,
        S12 | S16 | S34 => q.q11 = true,
        S29 => {
            q.q11 = true;
            q.q15 = true;
        }
        S8 => {
            q.q12 = true;
            q.q15 = true;
        }
        S18 | S27 | S58 => q.q13 = true,
        S48 => {
            q.q13 = true;
            q.q14 = true;
        }
        S19 | S24 | S57 => q.q14 = true,
    }
    q
}

super::dialects!(S0, 64);
