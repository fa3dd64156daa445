//! The pedestrian crossing.

pub use crate::signals::crossing::{ChartInputs, ChartOutputs};

/// The longest time that a step waits for.
const LONGEST: u32 = 10_000;

#[derive(Clone, Copy)]
enum Step {
    Green,
    Asked,
    Yellow,
    Clear,
    Walk,
    RedYellow,
    Init,
}

struct State {
    /// When the step was entered, or the longest time ago: so the counter cannot wrap around beside it.
    since: u32,
    step: Step,
    wait: bool,
}

impl State {
    fn new() -> Self {
        Self { since: 0, step: Step::Init, wait: false }
    }

    #[inline(always)]
    fn next(&mut self, i: &ChartInputs, now: u32) -> bool {
        let time = now.wrapping_sub(self.since).min(LONGEST);
        self.since = now.wrapping_sub(time);
        let step = match self.step {
            Step::Green if i.request && time >= LONGEST => Step::Asked,
            Step::Asked if time >= 5_000 => Step::Yellow,
            Step::Yellow if time >= 3_000 => Step::Clear,
            Step::Clear if time >= 2_000 => Step::Walk,
            Step::Walk if time >= 8_000 => Step::RedYellow,
            Step::RedYellow if time >= 1_000 => Step::Green,
            Step::Init => Step::Green,
            _ => return false,
        };
        match step {
            Step::Asked => self.wait = true,
            Step::Walk => self.wait = false,
            _ => {}
        }
        self.step = step;
        self.since = now;
        true
    }

    #[inline(always)]
    fn act(&self) -> ChartOutputs {
        let lights = |red, yellow, green, walk| ChartOutputs { red, yellow, green, walk, wait: self.wait };
        match self.step {
            Step::Green | Step::Asked | Step::Init => lights(false, false, true, false),
            Step::Yellow => lights(false, true, false, false),
            Step::Clear => lights(true, false, false, false),
            Step::Walk => lights(true, false, false, true),
            Step::RedYellow => lights(true, true, false, false),
        }
    }
}

/// IEC 61131-3: one evolution per cycle; that of the first activates the initial step.
pub mod sfc {
    use super::State;
    pub use super::{ChartInputs, ChartOutputs};

    pub struct Chart(State);

    impl Chart {
        pub fn new() -> Self {
            Self(State::new())
        }

        pub fn cycle(&mut self, inputs: &ChartInputs, now: u32) -> ChartOutputs {
            self.0.next(inputs, now);
            self.0.act()
        }
    }

    pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
}

/// IEC 60848: evolutions until nothing moves; the times end every search.
pub mod grafcet {
    use super::State;
    pub use super::{ChartInputs, ChartOutputs};

    pub struct Chart(State);

    impl Chart {
        pub fn new() -> Self {
            Self(State::new())
        }

        pub fn is_stable(&self) -> bool {
            true
        }

        pub fn cycle(&mut self, inputs: &ChartInputs, now: u32) -> ChartOutputs {
            while self.0.next(inputs, now) {}
            self.0.act()
        }
    }

    pub const CYCLE: crate::TimedCycle<Chart, ChartInputs, ChartOutputs> = Chart::cycle;
}
