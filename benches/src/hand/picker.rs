//! Pick and place. The watchdogs end every step that has one, so its time does not wrap; `Recover` waits for `ack` to be
//! released, and a second more if that takes 49.7 days.

pub use crate::signals::picker::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy)]
enum Step {
    Home,
    Wait,
    LowerPick,
    Grip,
    RaisePick,
    Carry,
    LowerPlace,
    Release,
    RaisePlace,
    Back,
    NotMoved,
    NotLowered,
    NotGripped,
    NotRaised,
    Lost,
    Recover,
    /// Before the first cycle.
    Init,
}

struct State {
    since: u32,
    step: Step,
    suck: bool,
    tries: u8,
}

impl State {
    fn new(step: Step) -> Self {
        Self { since: 0, step, suck: false, tries: 0 }
    }

    /// One evolution; whether anything has moved.
    #[inline(always)]
    fn next(&mut self, i: &ChartInputs, now: u32) -> bool {
        let time = now.wrapping_sub(self.since);
        self.step = match self.step {
            Step::Init => Step::Home,
            Step::Home if i.left && i.up => Step::Wait,
            Step::Home if time >= 4_000 => Step::NotMoved,
            Step::Wait if i.start && i.part => Step::LowerPick,
            Step::LowerPick if i.down => {
                self.suck = true;
                self.tries = self.tries.wrapping_add(1);
                Step::Grip
            }
            Step::LowerPick if time >= 1_000 => Step::NotLowered,
            Step::Grip if i.vacuum => {
                if time < 300 {
                    return false;
                }
                Step::RaisePick
            }
            Step::Grip if time >= 800 => {
                if self.tries < 3 {
                    Step::LowerPick
                } else {
                    self.let_go(Step::NotGripped)
                }
            }
            Step::RaisePick if i.up => Step::Carry,
            Step::RaisePick if time >= 500 => Step::NotRaised,
            Step::Carry if i.right => Step::LowerPlace,
            Step::Carry if !i.vacuum && time >= 200 => self.let_go(Step::Lost),
            Step::Carry if i.vacuum && time >= 500 => Step::NotMoved,
            Step::LowerPlace if i.down => self.let_go(Step::Release),
            Step::LowerPlace if time >= 500 => Step::NotLowered,
            Step::Release if !i.vacuum && time >= 200 => Step::RaisePlace,
            Step::RaisePlace if i.up => Step::Back,
            Step::RaisePlace if time >= 500 => Step::NotRaised,
            Step::Back if i.left => Step::Wait,
            Step::Back if time >= 500 => Step::NotMoved,
            Step::NotMoved | Step::NotLowered | Step::NotGripped | Step::NotRaised | Step::Lost if i.ack => {
                self.suck = false;
                Step::Recover
            }
            Step::Recover if !i.ack && time >= 1_000 => Step::Home,
            _ => return false,
        };
        self.since = now;
        true
    }

    fn let_go(&mut self, step: Step) -> Step {
        self.suck = false;
        self.tries = 0;
        step
    }

    #[inline(always)]
    fn act(&self, _: &ChartInputs, _: u32) -> ChartOutputs {
        let mut q = ChartOutputs { suck: self.suck, ..ChartOutputs::default() };
        match self.step {
            Step::Home | Step::Back => q.go_left = true,
            Step::Wait => q.ready = true,
            Step::LowerPick | Step::LowerPlace => q.lower = true,
            Step::Carry => q.go_right = true,
            Step::Release => q.blow = true,
            Step::NotMoved => alarm(&mut q, 1),
            Step::NotLowered => alarm(&mut q, 2),
            Step::NotGripped => alarm(&mut q, 3),
            Step::NotRaised => alarm(&mut q, 4),
            Step::Lost => alarm(&mut q, 5),
            Step::Grip | Step::RaisePick | Step::RaisePlace | Step::Recover | Step::Init => {}
        }
        q
    }
}

fn alarm(q: &mut ChartOutputs, code: u8) {
    q.alarm = true;
    q.code = code;
}

super::timed_dialects!(Home);
