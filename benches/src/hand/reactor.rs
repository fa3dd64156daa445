//! The reactor: the main sequence and the branch that heats are one enum, the branch that stirs has its own, which has a
//! meaning while the other one heats.
//!
//! A step's time is `now` less the reading at which it was entered. `Mix` and `Sample` go on as soon as their time is over,
//! whatever the sensors say; a pressure that stays high in `Vent` for 49.7 days makes it vent one second more.

pub use crate::signals::reactor::{ChartInputs, ChartOutputs};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    Idle,
    FillA,
    FillB,
    Sample,
    Drain,
    Rinse,
    /// Before the first cycle.
    Init,
    // With the other branch beside them.
    Heat,
    Hold,
    Cool,
    Cooled,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Stirring {
    Stir,
    Dose,
    Mix,
    Vent,
    Rest,
    Mixed,
}

struct State {
    since: u32,
    stirring_since: u32,
    step: Step,
    stirring: Stirring,
}

impl State {
    fn new(step: Step) -> Self {
        Self { since: 0, stirring_since: 0, step, stirring: Stirring::Mixed }
    }

    /// One evolution; whether anything has moved.
    #[inline(always)]
    fn next(&mut self, i: &ChartInputs, now: u32) -> bool {
        let time = now.wrapping_sub(self.since);
        let before = self.stirring;
        let stirred = matches!(self.step, Step::Heat | Step::Hold | Step::Cool | Step::Cooled) && self.stir(i, now);
        self.step = match self.step {
            Step::Init => Step::Idle,
            Step::Idle if i.start && i.level < 50 => Step::FillA,
            Step::FillA if i.level >= 400 => Step::FillB,
            Step::FillB if i.level >= 700 => self.react(now),
            Step::Heat if i.temperature >= 780 => Step::Hold,
            Step::Hold if time >= 5_000 => Step::Cool,
            Step::Cool if i.temperature < 400 => Step::Cooled,
            Step::Cooled if before == Stirring::Mixed => Step::Sample,
            Step::Sample if time >= 2_000 => {
                if i.good {
                    Step::Drain
                } else {
                    self.react(now)
                }
            }
            Step::Drain if i.level < 20 => Step::Rinse,
            Step::Rinse if time >= 3_000 => Step::Idle,
            _ => return stirred,
        };
        self.since = now;
        true
    }

    /// Enters both branches.
    fn react(&mut self, now: u32) -> Step {
        self.stirring = Stirring::Stir;
        self.stirring_since = now;
        Step::Heat
    }

    #[inline(always)]
    fn stir(&mut self, i: &ChartInputs, now: u32) -> bool {
        let time = now.wrapping_sub(self.stirring_since);
        self.stirring = match self.stirring {
            Stirring::Stir if time >= 2_000 => Stirring::Dose,
            Stirring::Dose if i.level >= 900 || time >= 3_000 => Stirring::Mix,
            Stirring::Mix if i.pressure >= 950 => Stirring::Vent,
            Stirring::Mix if time >= 4_000 => Stirring::Rest,
            Stirring::Vent if i.pressure < 300 && time >= 1_000 => Stirring::Mix,
            Stirring::Rest if time >= 1_000 => Stirring::Mixed,
            _ => return false,
        };
        self.stirring_since = now;
        true
    }

    #[inline(always)]
    fn act(&self, i: &ChartInputs, _: u32) -> ChartOutputs {
        let mut q = ChartOutputs::default();
        match self.step {
            Step::Idle => q.ready = true,
            Step::FillA => q.inlet_a = true,
            Step::FillB => q.inlet_b = true,
            Step::Sample => q.sampled = true,
            Step::Drain => q.drain = true,
            Step::Rinse => {
                q.inlet_a = true;
                q.drain = true;
            }
            Step::Heat | Step::Hold | Step::Cool | Step::Cooled => {
                match self.step {
                    Step::Heat => q.power = 1000,
                    Step::Hold => q.power = if i.temperature < 780 { 400 } else { 100 },
                    Step::Cool => q.cooler = true,
                    _ => {}
                }
                match self.stirring {
                    Stirring::Stir | Stirring::Mix => q.stirrer = true,
                    Stirring::Dose => {
                        q.dose = true;
                        q.stirrer = true;
                    }
                    Stirring::Vent => q.vent = true,
                    Stirring::Rest | Stirring::Mixed => {}
                }
            }
            Step::Init => {}
        }
        q
    }
}

super::timed_dialects!(Idle);
