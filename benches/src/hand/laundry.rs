//! The washing machine of 25 steps.
//!
//! A step's time is `now` less the reading at which it was entered. In a step that waits for a sensor the counter wraps
//! after 49.7 days: filling, heating and spreading would then wait for their longest time once more, which is harmless here.

pub use crate::signals::laundry::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy)]
enum Step {
    Idle,
    Lock,
    Fill,
    NoWater,
    Heat,
    WashLeft,
    WashRest1,
    WashRight,
    WashRest2,
    Drain,
    DrainMore,
    RinseFill,
    RinseLeft,
    RinseRest,
    RinseRight,
    RinseDrain,
    RinseMore,
    Spread,
    Ramp,
    SpinSlow,
    SpinFast,
    Coast,
    Loosen,
    Unlock,
    Done,
    /// Before the first cycle.
    Init,
}

struct State {
    since: u32,
    step: Step,
    locked: bool,
    turns: u8,
    rinses: u8,
}

impl State {
    fn new(step: Step) -> Self {
        Self { since: 0, step, locked: false, turns: 0, rinses: 0 }
    }

    /// One evolution; whether anything has moved.
    #[inline(always)]
    fn next(&mut self, i: &ChartInputs, now: u32) -> bool {
        let time = now.wrapping_sub(self.since);
        self.step = match self.step {
            Step::Init => Step::Idle,
            Step::Idle if i.start && i.door => {
                self.locked = true;
                Step::Lock
            }
            Step::Lock if time >= 500 => Step::Fill,
            Step::Fill if i.full => Step::Heat,
            Step::Fill if time >= 10_000 => Step::NoWater,
            Step::NoWater if !i.start => {
                self.locked = false;
                Step::Unlock
            }
            Step::Heat if i.hot || time >= 20_000 => self.wash(),
            Step::WashLeft if time >= 3_000 => Step::WashRest1,
            Step::WashRest1 if time >= 1_000 => Step::WashRight,
            Step::WashRight if time >= 3_000 => Step::WashRest2,
            Step::WashRest2 if time >= 1_000 => {
                if self.turns < 4 {
                    self.wash()
                } else {
                    self.turns = 0;
                    Step::Drain
                }
            }
            Step::Drain if i.empty => Step::DrainMore,
            Step::DrainMore if time >= 2_000 => Step::RinseFill,
            Step::RinseFill if i.full => {
                self.rinses = self.rinses.wrapping_add(1);
                Step::RinseLeft
            }
            Step::RinseLeft if time >= 2_000 => Step::RinseRest,
            Step::RinseRest if time >= 500 => Step::RinseRight,
            Step::RinseRight if time >= 2_000 => Step::RinseDrain,
            Step::RinseDrain if i.empty => Step::RinseMore,
            Step::RinseMore if time >= 2_000 => {
                if self.rinses < 3 {
                    Step::RinseFill
                } else {
                    self.rinses = 0;
                    Step::Spread
                }
            }
            Step::Spread if i.balanced && time >= 2_000 => Step::Ramp,
            Step::Spread if !i.balanced && time >= 8_000 => Step::Coast,
            Step::Ramp if time >= 1_000 => Step::SpinSlow,
            Step::SpinSlow if time >= 4_000 => Step::SpinFast,
            Step::SpinFast if time >= 6_000 => Step::Coast,
            Step::Coast if time >= 2_000 => Step::Loosen,
            Step::Loosen if time >= 1_000 => {
                self.locked = false;
                Step::Unlock
            }
            Step::Unlock if time >= 1_000 => Step::Done,
            Step::Done if !i.door && time >= 1_000 => Step::Idle,
            _ => return false,
        };
        self.since = now;
        true
    }

    fn wash(&mut self) -> Step {
        self.turns = self.turns.wrapping_add(1);
        Step::WashLeft
    }

    #[inline(always)]
    fn act(&self, i: &ChartInputs, _: u32) -> ChartOutputs {
        let mut q = ChartOutputs { locked: self.locked, ..ChartOutputs::default() };
        match self.step {
            Step::Idle => q.ready = true,
            Step::Fill | Step::RinseFill => q.valve = true,
            Step::NoWater => q.alarm = true,
            Step::Heat => {
                q.heater = true;
                q.left = true;
            }
            Step::WashLeft => {
                q.left = true;
                q.heater = !i.hot;
            }
            Step::WashRight => {
                q.right = true;
                q.heater = !i.hot;
            }
            Step::RinseLeft => q.left = true,
            Step::RinseRight | Step::Loosen => q.right = true,
            Step::Drain | Step::DrainMore | Step::RinseDrain | Step::RinseMore | Step::Coast => q.pump = true,
            Step::Spread => {
                q.left = true;
                q.pump = true;
            }
            Step::Ramp | Step::SpinSlow => {
                q.slow = true;
                q.pump = true;
            }
            Step::SpinFast => {
                q.fast = true;
                q.pump = true;
            }
            Step::Done => {
                q.ready = true;
                q.alarm = i.door;
            }
            Step::Lock | Step::WashRest1 | Step::WashRest2 | Step::RinseRest | Step::Unlock | Step::Init => {}
        }
        q
    }
}

super::timed_dialects!(Idle);
