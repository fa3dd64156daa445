//! The production line.

pub use crate::signals::line24v::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    S1,
    S2,
    S3,
    S4,
}

fn next(step: Step, i: &ChartInputs) -> Step {
    match step {
        Step::S1 if i.b1 => Step::S2,
        Step::S2 if i.b2 => Step::S3,
        Step::S3 if i.b3 => Step::S4,
        Step::S4 if i.b4 => Step::S1,
        stay => stay,
    }
}

fn act(step: Step, q2: bool, i: &ChartInputs) -> ChartOutputs {
    ChartOutputs { q1: step == Step::S1, q2, q3: step == Step::S3 && i.b5 }
}

/// IEC 61131-3: one evolution per cycle, none in the first.
pub mod sfc {
    pub use super::{ChartInputs, ChartOutputs};
    use super::{Step, act, next};

    pub struct Chart {
        /// None before the first cycle.
        step: Option<Step>,
        q2: bool,
    }

    impl Chart {
        pub fn new() -> Self {
            Self { step: None, q2: false }
        }

        pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
            let step = match self.step {
                None => Step::S1,
                Some(step) => next(step, inputs),
            };
            self.step = Some(step);
            match step {
                Step::S2 => self.q2 = true,
                Step::S4 => self.q2 = false,
                _ => {}
            }
            act(step, self.q2, inputs)
        }
    }

    pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
}

/// IEC 60848: evolutions until the step stays, at most twice the number of steps plus two.
pub mod grafcet {
    pub use super::{ChartInputs, ChartOutputs};
    use super::{Step, act, next};

    pub struct Chart {
        step: Step,
        q2: bool,
        stable: bool,
    }

    impl Chart {
        pub fn new() -> Self {
            Self { step: Step::S1, q2: false, stable: true }
        }

        pub fn is_stable(&self) -> bool {
            self.stable
        }

        pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
            let mut left = 10;
            self.stable = loop {
                let step = next(self.step, inputs);
                if step == self.step {
                    break true;
                }
                if left == 0 {
                    break false;
                }
                left -= 1;
                self.step = step;
                match step {
                    Step::S2 => self.q2 = true,
                    Step::S4 => self.q2 = false,
                    _ => {}
                }
            };
            act(self.step, self.q2, inputs)
        }
    }

    pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
}
