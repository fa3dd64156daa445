//! A washing machine: loops back for water and for another rinse.

pub use crate::signals::washer::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    Idle,
    Fill,
    Heat,
    Wash,
    Drain,
    Spin,
    Done,
}

fn next(step: Step, i: &ChartInputs) -> Step {
    match step {
        Step::Idle if i.start => Step::Fill,
        Step::Fill if i.full => Step::Heat,
        Step::Heat if i.hot => Step::Wash,
        Step::Wash if i.washed => Step::Drain,
        Step::Wash if !i.full => Step::Fill,
        Step::Drain if i.empty => {
            if i.again {
                Step::Fill
            } else {
                Step::Spin
            }
        }
        Step::Spin if i.spun => Step::Done,
        Step::Done if !i.start => Step::Idle,
        stay => stay,
    }
}

fn act(step: Step, locked: bool, i: &ChartInputs) -> ChartOutputs {
    let mut q = ChartOutputs { locked, ..ChartOutputs::default() };
    match step {
        Step::Idle => q.ready = true,
        Step::Fill => q.valve = true,
        Step::Heat => q.heater = true,
        Step::Wash => {
            q.drum = true;
            q.heater = !i.hot;
        }
        Step::Drain => q.pump = true,
        Step::Spin => {
            q.pump = true;
            q.spin = true;
        }
        Step::Done => {}
    }
    q
}

/// IEC 61131-3: one evolution per cycle, none in the first.
pub mod sfc {
    pub use super::{ChartInputs, ChartOutputs};
    use super::{Step, act, next};

    pub struct Chart {
        /// None before the first cycle.
        step: Option<Step>,
        locked: bool,
    }

    impl Chart {
        pub fn new() -> Self {
            Self { step: None, locked: false }
        }

        pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
            let step = match self.step {
                None => Step::Idle,
                Some(step) => next(step, inputs),
            };
            self.step = Some(step);
            match step {
                Step::Fill => self.locked = true,
                Step::Done => self.locked = false,
                _ => {}
            }
            act(step, self.locked, inputs)
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
        locked: bool,
        stable: bool,
    }

    impl Chart {
        pub fn new() -> Self {
            Self { step: Step::Idle, locked: false, stable: true }
        }

        pub fn is_stable(&self) -> bool {
            self.stable
        }

        pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
            let mut left = 16;
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
                    Step::Fill => self.locked = true,
                    Step::Done => self.locked = false,
                    _ => {}
                }
            };
            act(self.step, self.locked, inputs)
        }
    }

    pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
}
