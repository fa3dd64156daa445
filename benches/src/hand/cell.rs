//! A machining cell: an emergency stop above two modes, production within one of them.

pub use crate::signals::cell::{ChartInputs, ChartOutputs};

/// IEC 60848: evolutions until nothing moves. A part is clamped or not, so every search ends.
pub mod grafcet {
    pub use super::{ChartInputs, ChartOutputs};

    #[derive(Clone, Copy, PartialEq, Eq)]
    enum Safety {
        Ready,
        Stopped,
        Restart,
    }

    #[derive(Clone, Copy, PartialEq, Eq)]
    enum Mode {
        /// After an emergency stop.
        Off,
        Manual,
        Auto,
    }

    #[derive(Clone, Copy, PartialEq, Eq)]
    enum Production {
        Feed,
        Close,
        Closed,
        /// Drilling and stamping.
        Work,
        Release,
        Deliver,
    }

    pub struct Chart {
        safety: Safety,
        mode: Mode,
        /// Has a meaning in automatic mode.
        production: Production,
        /// Have a meaning while the part is worked at.
        drilled: bool,
        stamped: bool,
        clamp: bool,
        parts: u16,
        /// The inputs of the cycle before; on before the first, in which there is no edge.
        ack: bool,
        auto: bool,
    }

    impl Chart {
        pub fn new() -> Self {
            Self {
                safety: Safety::Ready,
                mode: Mode::Manual,
                production: Production::Feed,
                drilled: false,
                stamped: false,
                clamp: false,
                parts: 0,
                ack: true,
                auto: true,
            }
        }

        pub fn is_stable(&self) -> bool {
            true
        }

        pub fn cycle(&mut self, i: &ChartInputs) -> ChartOutputs {
            let (mut acked, mut switched) = (i.ack && !self.ack, i.auto && !self.auto);
            self.ack = i.ack;
            self.auto = i.auto;
            while self.next(i, acked, switched) {
                // An edge is one for the first evolution.
                acked = false;
                switched = false;
            }
            let production = |step| self.mode == Mode::Auto && self.production == step;
            let work = production(Production::Work);
            ChartOutputs {
                conveyor: production(Production::Feed) || production(Production::Deliver),
                clamp: self.clamp,
                drill: work && !self.drilled,
                stamp: work && !self.stamped,
                alarm: self.safety == Safety::Stopped,
                parts: self.parts,
            }
        }

        /// One evolution; whether anything has moved.
        fn next(&mut self, i: &ChartInputs, acked: bool, switched: bool) -> bool {
            match self.safety {
                Safety::Ready if i.estop => {
                    self.safety = Safety::Stopped;
                    self.mode = Mode::Off;
                    return true;
                }
                Safety::Ready => {}
                Safety::Stopped => {
                    if i.estop || !acked {
                        return false;
                    }
                    self.safety = Safety::Restart;
                    self.mode = Mode::Manual;
                    self.clamp = false;
                    return true;
                }
                Safety::Restart => {
                    self.safety = Safety::Ready;
                    return true;
                }
            }
            match self.mode {
                Mode::Off => false,
                Mode::Manual => {
                    if switched {
                        self.mode = Mode::Auto;
                        self.production = Production::Feed;
                    }
                    switched
                }
                Mode::Auto => self.produce(i),
            }
        }

        fn produce(&mut self, i: &ChartInputs) -> bool {
            self.production = match self.production {
                Production::Feed if i.part => {
                    self.clamp = true;
                    Production::Close
                }
                Production::Feed if !i.auto => {
                    self.mode = Mode::Manual;
                    self.clamp = false;
                    return true;
                }
                Production::Close if i.clamped => Production::Closed,
                Production::Closed => {
                    self.drilled = false;
                    self.stamped = false;
                    Production::Work
                }
                Production::Work if self.drilled && self.stamped => {
                    self.clamp = false;
                    self.parts = self.parts.wrapping_add(1);
                    Production::Release
                }
                Production::Work => {
                    let (drilled, stamped) = (self.drilled | i.drilled, self.stamped | i.stamped);
                    let moved = drilled != self.drilled || stamped != self.stamped;
                    self.drilled = drilled;
                    self.stamped = stamped;
                    return moved;
                }
                Production::Release if !i.clamped => Production::Deliver,
                Production::Deliver if !i.part => Production::Feed,
                _ => return false,
            };
            true
        }
    }

    pub const CYCLE: crate::Cycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
}
