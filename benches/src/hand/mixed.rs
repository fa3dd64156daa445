//! A filling station: two sections of two parallel branches each, times, stored outputs. The main sequence and the left
//! branches are one enum, the right ones have their own, which has a meaning beside the left ones.
//!
//! A step's time is `now` less the reading at which it was entered. Steps go on as soon as their times are over, but for `Print`: where
//! nothing is printed for 49.7 days, the printer runs for another second.

pub use crate::signals::mixed::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    Idle,
    Load,
    Clamp,
    Weigh,
    Reject,
    Unclamp,
    Deliver,
    /// Before the first cycle.
    Init,
    // The first parallel section.
    Heat,
    Hold,
    Heated,
    // The second one.
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
    since: u32,
    right_since: u32,
    step: Step,
    right: Right,
    busy: bool,
    valve: bool,
    alarm: bool,
}

impl State {
    fn new(step: Step) -> Self {
        Self { since: 0, right_since: 0, step, right: Right::Open, busy: false, valve: false, alarm: false }
    }

    fn is_parallel(&self) -> bool {
        matches!(self.step, Step::Heat | Step::Hold | Step::Heated | Step::Cap | Step::Press | Step::Capped)
    }

    /// One evolution; whether anything has moved.
    #[inline(always)]
    fn next(&mut self, i: &ChartInputs, now: u32) -> bool {
        let time = now.wrapping_sub(self.since);
        let right = self.right;
        let moved = self.is_parallel() && self.next_right(i, now);
        self.step = match self.step {
            Step::Init => Step::Idle,
            Step::Idle if i.start => {
                self.busy = true;
                Step::Load
            }
            Step::Load if i.part => {
                self.alarm = false;
                Step::Clamp
            }
            Step::Clamp if i.clamped => {
                self.right = Right::Open;
                self.right_since = now;
                self.valve = true;
                Step::Heat
            }
            Step::Heat if i.hot => Step::Hold,
            Step::Hold if time >= 5_000 => Step::Heated,
            Step::Heated if right == Right::Dosed => Step::Weigh,
            Step::Weigh if i.weighed => {
                if i.good {
                    self.right = Right::Print;
                    self.right_since = now;
                    Step::Cap
                } else {
                    self.alarm = true;
                    Step::Reject
                }
            }
            Step::Reject if i.gone || time >= 10_000 => {
                self.busy = false;
                Step::Idle
            }
            Step::Cap if i.capped => Step::Press,
            Step::Press if time >= 3_000 => Step::Capped,
            Step::Capped if right == Right::Labelled => Step::Unclamp,
            Step::Unclamp if !i.clamped => Step::Deliver,
            Step::Deliver if i.gone => {
                self.busy = false;
                Step::Idle
            }
            _ => return moved,
        };
        self.since = now;
        true
    }

    #[inline(always)]
    fn next_right(&mut self, i: &ChartInputs, now: u32) -> bool {
        let time = now.wrapping_sub(self.right_since);
        self.right = match self.right {
            Right::Open if time >= 1_000 => Right::Dose,
            Right::Dose if i.filled => Right::Settle,
            Right::Settle if time >= 2_000 => {
                self.valve = false;
                Right::Dosed
            }
            Right::Print if i.printed => Right::Label,
            Right::Label if !i.stuck => Right::Labelled,
            _ => return false,
        };
        self.right_since = now;
        true
    }

    #[inline(always)]
    fn act(&self, i: &ChartInputs, now: u32) -> ChartOutputs {
        let mut q = ChartOutputs { busy: self.busy, valve: self.valve, alarm: self.alarm, ..ChartOutputs::default() };
        match self.step {
            Step::Idle => q.ready = true,
            Step::Load | Step::Deliver => q.belt = true,
            Step::Reject => q.eject = true,
            Step::Heat => q.heater = true,
            Step::Hold => q.heater = !i.hot,
            Step::Cap => q.capper = true,
            Step::Press => q.press = true,
            Step::Clamp | Step::Weigh | Step::Unclamp | Step::Init | Step::Heated | Step::Capped => {}
        }
        if self.is_parallel() {
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
        q
    }
}

super::timed_dialects!(Idle);
