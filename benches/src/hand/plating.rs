//! The plating line of 40 steps: what is the same at every bath is written once.
//!
//! A step's time is `now` less the reading at which it was entered. Where a step goes on as soon as its time is over the
//! counter cannot wrap in it; in `DripRinse` (without a recipe) and `Rework` (without a sensor) it wraps after 49.7 days, and
//! the hoist then waits half a second or a second more.

pub use crate::signals::plating::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy)]
enum Step {
    Idle,
    Grip,
    Raise,
    ToDegrease,
    LowerDegrease,
    Degrease,
    LiftDegrease,
    DripDegrease,
    ToRinse,
    LowerRinse,
    Rinse,
    LiftRinse,
    DripRinse,
    ToNickel,
    LowerNickel,
    Nickel,
    LiftNickel,
    DripNickel,
    ToChrome,
    LowerChrome,
    Chrome,
    LiftChrome,
    DripChrome,
    ToZinc,
    LowerZinc,
    Zinc,
    LiftZinc,
    DripZinc,
    ToClean,
    LowerClean,
    Clean,
    LiftClean,
    DripClean,
    ToDryer,
    Dry,
    Inspect,
    Rework,
    Reject,
    Unload,
    Return,
    /// Before the first cycle.
    Init,
}

struct State {
    since: u32,
    step: Step,
    grip: bool,
    dips: u8,
    tries: u8,
    parts: u16,
}

impl State {
    fn new(step: Step) -> Self {
        Self { since: 0, step, grip: false, dips: 0, tries: 0, parts: 0 }
    }

    /// One evolution; whether anything has moved.
    #[inline(always)]
    fn next(&mut self, i: &ChartInputs, now: u32) -> bool {
        let time = now.wrapping_sub(self.since);
        self.step = match self.step {
            Step::Init => Step::Idle,
            Step::Idle if i.start && i.home => {
                self.grip = true;
                Step::Grip
            }
            Step::Grip if time >= 500 => Step::Raise,
            Step::Raise if i.high => Step::ToDegrease,
            Step::ToDegrease if i.there => Step::LowerDegrease,
            Step::LowerDegrease if i.low => Step::Degrease,
            Step::Degrease if time >= 3_000 => Step::LiftDegrease,
            Step::LiftDegrease if i.high => Step::DripDegrease,
            Step::DripDegrease if time >= 1_000 => Step::ToRinse,
            Step::ToRinse if i.there => Step::LowerRinse,
            Step::LowerRinse if i.low => {
                self.dips = self.dips.wrapping_add(1);
                Step::Rinse
            }
            Step::Rinse if time >= 1_000 => Step::LiftRinse,
            Step::LiftRinse if i.high => {
                if self.dips < 3 {
                    Step::LowerRinse
                } else {
                    self.dips = 0;
                    Step::DripRinse
                }
            }
            Step::DripRinse if time >= 1_000 => match i.recipe {
                1 => Step::ToNickel,
                2 => Step::ToChrome,
                3 => Step::ToZinc,
                _ => return false,
            },
            Step::ToNickel if i.there => Step::LowerNickel,
            Step::LowerNickel if i.low => Step::Nickel,
            Step::Nickel if time >= 3_000 => Step::LiftNickel,
            Step::LiftNickel if i.high => Step::DripNickel,
            Step::ToChrome if i.there => Step::LowerChrome,
            Step::LowerChrome if i.low => Step::Chrome,
            Step::Chrome if time >= 5_000 => Step::LiftChrome,
            Step::LiftChrome if i.high => Step::DripChrome,
            Step::ToZinc if i.there => Step::LowerZinc,
            Step::LowerZinc if i.low => Step::Zinc,
            Step::Zinc if time >= 2_000 => Step::LiftZinc,
            Step::LiftZinc if i.high => Step::DripZinc,
            Step::DripNickel | Step::DripChrome | Step::DripZinc if time >= 1_000 => Step::ToClean,
            Step::ToClean if i.there => Step::LowerClean,
            Step::LowerClean if i.low => {
                self.dips = self.dips.wrapping_add(1);
                Step::Clean
            }
            Step::Clean if time >= 1_000 => Step::LiftClean,
            Step::LiftClean if i.high => {
                if self.dips < 2 {
                    Step::LowerClean
                } else {
                    self.dips = 0;
                    Step::DripClean
                }
            }
            Step::DripClean if time >= 1_000 => Step::ToDryer,
            Step::ToDryer if i.there => Step::Dry,
            Step::Dry if time >= 4_000 => Step::Inspect,
            Step::Inspect => {
                if i.good {
                    self.parts = self.parts.wrapping_add(1);
                    self.let_go(Step::Unload)
                } else if self.tries < 2 {
                    self.tries = self.tries.wrapping_add(1);
                    Step::Rework
                } else {
                    self.let_go(Step::Reject)
                }
            }
            Step::Rework if i.there && time >= 500 => Step::LowerRinse,
            Step::Reject if time >= 1_000 => Step::Return,
            Step::Unload if i.low => Step::Return,
            Step::Return if i.home => Step::Idle,
            _ => return false,
        };
        self.since = now;
        true
    }

    fn let_go(&mut self, step: Step) -> Step {
        self.grip = false;
        self.tries = 0;
        step
    }

    #[inline(always)]
    fn act(&self, _: &ChartInputs, _: u32) -> ChartOutputs {
        let mut q = ChartOutputs { grip: self.grip, parts: self.parts, ..ChartOutputs::default() };
        match self.step {
            Step::Idle => q.ready = true,
            Step::ToDegrease | Step::ToRinse | Step::ToNickel | Step::ToChrome | Step::ToZinc => q.forward = true,
            Step::ToClean | Step::ToDryer => q.forward = true,
            Step::LowerDegrease | Step::LowerRinse | Step::LowerNickel | Step::LowerChrome => q.lower = true,
            Step::LowerZinc | Step::LowerClean | Step::Unload => q.lower = true,
            Step::Raise | Step::LiftDegrease | Step::LiftRinse | Step::LiftNickel => q.lift = true,
            Step::LiftChrome | Step::LiftZinc | Step::LiftClean => q.lift = true,
            Step::Degrease => q.heat = true,
            Step::Rinse | Step::Clean => q.water = true,
            Step::Nickel => q.current = true,
            Step::Chrome => {
                q.current = true;
                q.heat = true;
            }
            Step::Zinc => {
                q.current = true;
                q.air = true;
            }
            Step::Dry => {
                q.air = true;
                q.heat = true;
            }
            Step::Rework | Step::Return => q.backward = true,
            Step::Reject => q.reject = true,
            Step::Grip | Step::DripDegrease | Step::DripRinse | Step::DripNickel | Step::DripChrome => {}
            Step::DripZinc | Step::DripClean | Step::Inspect | Step::Init => {}
        }
        q
    }
}

super::timed_dialects!(Idle);
