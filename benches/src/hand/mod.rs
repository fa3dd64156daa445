//! The charts as an engineer writes them in Rust by hand: an enum of the steps, a `match` that goes on, a `match` that
//! acts; for IEC 60848 a loop around the first, with the bound that the dialect asks for.

pub mod cell;
pub mod crossing;
pub mod laundry;
pub mod line24v;
pub mod mixed;
pub mod motor;
pub mod packer;
pub mod picker;
pub mod plating;
pub mod reactor;
pub mod selection;
pub mod seq16;
pub mod seq4;
pub mod seq64;
pub mod washer;

/// The two charts whose steps have continuous actions only, from their functions `next` and `act`.
macro_rules! dialects {
    ($first:ident, $steps:literal) => {
        /// IEC 61131-3: one evolution per cycle, none in the first.
        pub mod sfc {
            pub use super::{ChartInputs, ChartOutputs};
            use super::{Step, act, next};

            pub struct Chart {
                /// None before the first cycle.
                step: Option<Step>,
            }

            impl Chart {
                pub fn new() -> Self {
                    Self { step: None }
                }

                pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
                    let step = match self.step {
                        None => Step::$first,
                        Some(step) => next(step, inputs),
                    };
                    self.step = Some(step);
                    act(step)
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
                stable: bool,
            }

            impl Chart {
                pub fn new() -> Self {
                    Self { step: Step::$first, stable: true }
                }

                pub fn is_stable(&self) -> bool {
                    self.stable
                }

                pub fn cycle(&mut self, inputs: &ChartInputs) -> ChartOutputs {
                    let mut left = 2 * $steps + 2;
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
                    };
                    act(self.step)
                }
            }

            pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }
    };
}
use dialects;

/// The two charts of a `State` with its functions `new`, `next`, which says whether anything has moved, and `act`. Times end
/// every search.
macro_rules! timed_dialects {
    ($first:ident) => {
        /// IEC 61131-3: one evolution per cycle; that of the first activates the initial step.
        pub mod sfc {
            pub use super::{ChartInputs, ChartOutputs};
            use super::{State, Step};

            pub struct Chart(State);

            impl Chart {
                pub fn new() -> Self {
                    Self(State::new(Step::Init))
                }

                pub fn cycle(&mut self, inputs: &ChartInputs, now: u32) -> ChartOutputs {
                    self.0.next(inputs, now);
                    self.0.act(inputs, now)
                }
            }

            pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }

        /// IEC 60848: evolutions until nothing moves.
        pub mod grafcet {
            pub use super::{ChartInputs, ChartOutputs};
            use super::{State, Step};

            pub struct Chart(State);

            impl Chart {
                pub fn new() -> Self {
                    Self(State::new(Step::$first))
                }

                pub fn is_stable(&self) -> bool {
                    true
                }

                pub fn cycle(&mut self, inputs: &ChartInputs, now: u32) -> ChartOutputs {
                    while self.0.next(inputs, now) {}
                    self.0.act(inputs, now)
                }
            }

            pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
        }
    };
}
use timed_dialects;

include!(concat!(env!("OUT_DIR"), "/hand.rs"));
