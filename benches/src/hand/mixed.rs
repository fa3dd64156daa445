//! A filling station: two sections of two parallel branches each, times, stored outputs.

pub use crate::signals::mixed::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Main {
    Idle,
    Load,
    Clamp,
    /// The first parallel section.
    Fill,
    Weigh,
    Reject,
    /// The second parallel section.
    Close,
    Unclamp,
    Deliver,
    /// Before the first cycle.
    Init,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Left {
    Heat,
    Hold,
    Heated,
    Cap,
    Press,
    Capped,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Right {
    Open,
    Dose,
    Settle,
    Dosed,
    Print,
    Label,
    Labelled,
}

struct State {
    main: Main,
    /// Have a meaning in the parallel sections.
    left: Left,
    right: Right,
    /// When the left branch, or outside of the sections the main one, was entered with a time to wait for.
    left_since: u32,
    right_since: u32,
    busy: bool,
    valve: bool,
    alarm: bool,
}

impl State {
    fn new(main: Main) -> Self {
        let (left, right) = (Left::Heat, Right::Open);
        Self { main, left, right, left_since: 0, right_since: 0, busy: false, valve: false, alarm: false }
    }

    /// One evolution; whether anything has moved.
    fn next(&mut self, i: &ChartInputs, now: u32) -> bool {
        self.main = match self.main {
            Main::Init => Main::Idle,
            Main::Idle if i.start => {
                self.busy = true;
                Main::Load
            }
            Main::Load if i.part => {
                self.alarm = false;
                Main::Clamp
            }
            Main::Clamp if i.clamped => {
                self.left = Left::Heat;
                self.right = Right::Open;
                self.right_since = now;
                self.valve = true;
                Main::Fill
            }
            Main::Fill if self.left == Left::Heated && self.right == Right::Dosed => Main::Weigh,
            Main::Weigh if i.weighed => {
                if i.good {
                    self.left = Left::Cap;
                    self.right = Right::Print;
                    self.right_since = now;
                    Main::Close
                } else {
                    self.left_since = now;
                    self.alarm = true;
                    Main::Reject
                }
            }
            Main::Reject if i.gone || now.wrapping_sub(self.left_since) >= 10_000 => {
                self.busy = false;
                Main::Idle
            }
            Main::Close if self.left == Left::Capped && self.right == Right::Labelled => Main::Unclamp,
            Main::Unclamp if !i.clamped => Main::Deliver,
            Main::Deliver if i.gone => {
                self.busy = false;
                Main::Idle
            }
            Main::Fill | Main::Close => return self.next_left(i, now) | self.next_right(i, now),
            _ => return false,
        };
        true
    }

    fn next_left(&mut self, i: &ChartInputs, now: u32) -> bool {
        self.left = match self.left {
            Left::Heat if i.hot => {
                self.left_since = now;
                Left::Hold
            }
            Left::Hold if now.wrapping_sub(self.left_since) >= 5_000 => Left::Heated,
            Left::Cap if i.capped => {
                self.left_since = now;
                Left::Press
            }
            Left::Press if now.wrapping_sub(self.left_since) >= 3_000 => Left::Capped,
            _ => return false,
        };
        true
    }

    fn next_right(&mut self, i: &ChartInputs, now: u32) -> bool {
        self.right = match self.right {
            Right::Open if now.wrapping_sub(self.right_since) >= 1_000 => {
                self.right_since = now;
                Right::Dose
            }
            Right::Dose if i.filled => {
                self.right_since = now;
                Right::Settle
            }
            Right::Settle if now.wrapping_sub(self.right_since) >= 2_000 => {
                self.valve = false;
                Right::Dosed
            }
            Right::Print if i.printed => Right::Label,
            Right::Label if !i.stuck => Right::Labelled,
            _ => return false,
        };
        true
    }

    fn act(&self, i: &ChartInputs, now: u32) -> ChartOutputs {
        let mut q = ChartOutputs { busy: self.busy, valve: self.valve, alarm: self.alarm, ..ChartOutputs::default() };
        match self.main {
            Main::Idle => q.ready = true,
            Main::Load | Main::Deliver => q.belt = true,
            Main::Reject => q.eject = true,
            Main::Fill | Main::Close => {
                match self.left {
                    Left::Heat => q.heater = true,
                    Left::Hold => q.heater = !i.hot,
                    Left::Cap => q.capper = true,
                    Left::Press => q.press = true,
                    Left::Heated | Left::Capped => {}
                }
                match self.right {
                    Right::Dose => {
                        q.pump = true;
                        q.stirrer = now.wrapping_sub(self.right_since) >= 500;
                    }
                    Right::Settle => q.stirrer = true,
                    Right::Print => q.printer = now.wrapping_sub(self.right_since) < 1_000,
                    Right::Label => q.labeler = true,
                    Right::Open | Right::Dosed | Right::Labelled => {}
                }
            }
            _ => {}
        }
        q
    }
}

/// IEC 61131-3: one evolution per cycle, none in the first.
pub mod sfc {
    pub use super::{ChartInputs, ChartOutputs};
    use super::{Main, State};

    pub struct Chart(State);

    impl Chart {
        pub fn new() -> Self {
            Self(State::new(Main::Init))
        }

        pub fn cycle(&mut self, inputs: &ChartInputs, now: u32) -> ChartOutputs {
            self.0.next(inputs, now);
            self.0.act(inputs, now)
        }
    }

    pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
}

/// IEC 60848: evolutions until nothing moves; the times end every search.
pub mod grafcet {
    pub use super::{ChartInputs, ChartOutputs};
    use super::{Main, State};

    pub struct Chart(State);

    impl Chart {
        pub fn new() -> Self {
            Self(State::new(Main::Idle))
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
