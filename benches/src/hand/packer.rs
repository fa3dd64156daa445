//! The packaging machine. Its four partial grafcets are two enums: a stop leaves no mode, and production is within one of
//! the modes, so all of that is one sequence; the outfeed beside it is the other. The stop is asked once a cycle.
//!
//! A step's time is `now` less the reading at which it was entered. Tape goes on as soon as its time is over; where `out`
//! stays on for 49.7 days, the belt runs half a second more.

pub use crate::signals::packer::{ChartInputs, ChartOutputs};

/// IEC 60848: evolutions until nothing moves; times and sensors that are on or off end every search.
pub mod grafcet {
    pub use super::{ChartInputs, ChartOutputs};

    #[derive(Clone, Copy, PartialEq, Eq)]
    enum Step {
        Stopped,
        Manual,
        // Automatic.
        Wait,
        Erect,
        Collect,
        Push,
        Close,
        Tape,
        Eject,
    }

    /// Has a meaning in automatic mode.
    #[derive(Clone, Copy, PartialEq, Eq)]
    enum Outfeed {
        Free,
        Move,
        Jammed,
    }

    pub struct Chart {
        taping_since: u32,
        moving_since: u32,
        step: Step,
        outfeed: Outfeed,
        bottles: u8,
        /// The inputs of the cycle before; on before the first, in which there is no edge.
        ack: bool,
        auto: bool,
        cartons: u16,
    }

    impl Chart {
        pub fn new() -> Self {
            Self {
                taping_since: 0,
                moving_since: 0,
                step: Step::Manual,
                outfeed: Outfeed::Free,
                bottles: 0,
                ack: true,
                auto: true,
                cartons: 0,
            }
        }

        pub fn is_stable(&self) -> bool {
            true
        }

        pub fn cycle(&mut self, i: &ChartInputs, now: u32) -> ChartOutputs {
            let (acked, switched) = (i.ack && !self.ack, i.auto && !self.auto);
            self.ack = i.ack;
            self.auto = i.auto;
            match self.step {
                _ if i.estop => self.step = Step::Stopped,
                Step::Stopped if acked => self.step = Step::Manual,
                Step::Stopped => {}
                Step::Manual if !switched => {}
                Step::Manual => {
                    self.step = Step::Wait;
                    self.outfeed = Outfeed::Free;
                    self.bottles = 0;
                    self.run(i, now);
                }
                _ => self.run(i, now),
            }
            self.act(i)
        }

        /// Automatic mode.
        #[inline(never)]
        fn run(&mut self, i: &ChartInputs, now: u32) {
            loop {
                let free = self.outfeed == Outfeed::Free;
                let conveyed = self.convey(i, now);
                self.step = match self.step {
                    Step::Wait if !i.auto => {
                        self.step = Step::Manual;
                        return;
                    }
                    Step::Wait if i.carton => Step::Erect,
                    Step::Erect if i.erected => Step::Collect,
                    Step::Collect if i.bottle => {
                        self.bottles = self.bottles.wrapping_add(1);
                        Step::Push
                    }
                    Step::Push if !i.bottle => {
                        if self.bottles < 3 {
                            Step::Collect
                        } else {
                            self.bottles = 0;
                            Step::Close
                        }
                    }
                    Step::Close if i.closed => {
                        self.taping_since = now;
                        Step::Tape
                    }
                    Step::Tape if now.wrapping_sub(self.taping_since) >= 1_000 => {
                        self.cartons = self.cartons.wrapping_add(1);
                        Step::Eject
                    }
                    Step::Eject if !i.carton && free => Step::Wait,
                    stay if conveyed => stay,
                    _ => return,
                };
            }
        }

        #[inline(always)]
        fn convey(&mut self, i: &ChartInputs, now: u32) -> bool {
            self.outfeed = match self.outfeed {
                Outfeed::Free if i.out => {
                    self.moving_since = now;
                    Outfeed::Move
                }
                Outfeed::Move if i.jam => Outfeed::Jammed,
                Outfeed::Move if !i.out && now.wrapping_sub(self.moving_since) >= 500 => Outfeed::Free,
                Outfeed::Jammed if !i.jam => {
                    self.moving_since = now;
                    Outfeed::Move
                }
                _ => return false,
            };
            true
        }

        fn act(&self, i: &ChartInputs) -> ChartOutputs {
            let mut q = ChartOutputs { cartons: self.cartons, ..ChartOutputs::default() };
            match self.step {
                Step::Stopped => {
                    q.alarm = true;
                    return q;
                }
                Step::Manual => {
                    q.manual = true;
                    q.belt = i.jog;
                    return q;
                }
                Step::Wait => q.lamp = true,
                Step::Erect => q.erect = true,
                Step::Collect => q.gate = true,
                Step::Push => q.push = true,
                Step::Close => q.close = true,
                Step::Tape => {
                    q.tape = true;
                    q.close = true;
                }
                Step::Eject => q.eject = true,
            }
            q.belt = self.outfeed == Outfeed::Move;
            q.jammed = self.outfeed == Outfeed::Jammed;
            q
        }
    }

    pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
}
