//! The timers of actions and conditions.

use crate::Ticks;

/// A time that is only compared with times of at most 65,535 clock units: there it saturates.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ShortTime(u16);

impl ShortTime {
    /// No time.
    pub const ZERO: Self = Self(0);

    /// The time that has been counted, for the comparison.
    #[must_use]
    pub fn ticks(self) -> Ticks {
        Ticks::new(u32::from(self.0))
    }

    #[cfg(feature = "record")]
    pub(crate) const fn new(count: u16) -> Self {
        Self(count)
    }

    #[cfg(feature = "record")]
    pub(crate) const fn count(self) -> u16 {
        self.0
    }
}

impl core::ops::Add<Ticks> for ShortTime {
    type Output = Self;
    fn add(self, elapsed: Ticks) -> Self {
        let sum = u32::from(self.0) + elapsed.get().min(u32::from(u16::MAX));
        Self(u16::try_from(sum).unwrap_or(u16::MAX))
    }
}

/// TON of IEC 61131-3: true once its input has been true for a time.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnDelay {
    held: Ticks,
    input: bool,
}

impl OnDelay {
    /// A timer whose input has been false.
    #[must_use]
    pub const fn new() -> Self {
        Self { held: Ticks::ZERO, input: false }
    }

    /// Takes the input of this cycle; `elapsed` is the time since the cycle before. With `restart` the time of a true
    /// input begins again. A time of zero has elapsed at once (A35).
    pub fn update(&mut self, input: bool, restart: bool, time: Ticks, elapsed: Ticks) -> bool {
        self.held = if input && self.input && !restart { self.held + elapsed } else { Ticks::ZERO };
        self.input = input;
        input && self.held >= time
    }

    #[cfg(feature = "record")]
    pub(crate) const fn parts(self) -> (Ticks, bool) {
        (self.held, self.input)
    }

    /// No time runs while the input is false.
    #[cfg(feature = "record")]
    pub(crate) fn of_parts(held: Ticks, input: bool) -> Option<Self> {
        (input || held == Ticks::ZERO).then_some(Self { held, input })
    }

    /// How long it still takes until the output becomes true; `None` if nothing is under way.
    #[must_use]
    pub fn remaining(&self, time: Ticks) -> Option<Ticks> {
        (self.input && self.held < time).then(|| time - self.held)
    }
}

impl Default for OnDelay {
    fn default() -> Self {
        Self::new()
    }
}

/// The general delay `t1/e/t2` of IEC 60848: true once `e` has been true for `t1`, false once it has been false for `t2`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Delay {
    /// How long the input has had its value.
    held: Ticks,
    input: bool,
    output: bool,
}

impl Delay {
    /// A delay whose input has been false for long.
    #[must_use]
    pub const fn new() -> Self {
        Self { held: Ticks::MAX, input: false, output: false }
    }

    /// Takes the input of this cycle; `elapsed` is the time since the cycle before.
    pub fn update(&mut self, input: bool, on: Ticks, off: Ticks, elapsed: Ticks) {
        self.held = if input == self.input { self.held + elapsed } else { Ticks::ZERO };
        self.input = input;
        if self.held >= if input { on } else { off } {
            self.output = input;
        }
    }

    #[cfg(feature = "record")]
    pub(crate) const fn parts(self) -> (Ticks, bool, bool) {
        (self.held, self.input, self.output)
    }

    #[cfg(feature = "record")]
    pub(crate) const fn of_parts(held: Ticks, input: bool, output: bool) -> Self {
        Self { held, input, output }
    }

    /// Whether the delayed condition holds.
    #[must_use]
    pub const fn output(&self) -> bool {
        self.output
    }

    /// How long it still takes until the output changes; `None` if nothing is under way.
    #[must_use]
    pub fn remaining(&self, on: Ticks, off: Ticks) -> Option<Ticks> {
        let time = if self.input { on } else { off };
        (self.input != self.output).then(|| time - self.held)
    }
}

impl Default for Delay {
    fn default() -> Self {
        Self::new()
    }
}

/// How long until a time that has been counted reaches a threshold; `None` if it has.
#[must_use]
pub fn until(counted: Ticks, threshold: Ticks) -> Option<Ticks> {
    (counted < threshold).then(|| threshold - counted)
}

/// How far a period is that goes on while time passes: the phase of something that blinks, which neither saturates nor wraps. It is
/// below the period, which is not zero.
#[must_use]
pub fn phase(reached: Ticks, elapsed: Ticks, period: Ticks) -> Ticks {
    let elapsed = if elapsed < period { elapsed.get() } else { elapsed.get().checked_rem(period.get()).unwrap_or(0) };
    let left = period - reached;
    Ticks::new(if elapsed < left.get() {
        reached.get().wrapping_add(elapsed)
    } else {
        elapsed.wrapping_sub(left.get())
    })
}

/// How long until something that blinks changes: at the end of the part in which it is true, or at that of the period.
#[must_use]
pub fn until_change(reached: Ticks, on: Ticks, period: Ticks) -> Ticks {
    if reached < on { on - reached } else { period - reached }
}

/// The earlier of two times from now.
#[must_use]
pub fn sooner(a: Option<Ticks>, b: Option<Ticks>) -> Option<Ticks> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if a < b { a } else { b }),
        (a, b) => a.or(b),
    }
}

/// The earlier of two readings of the clock, which lie less than 2^31 ticks apart.
#[must_use]
pub fn earlier(a: Option<Ticks>, b: Ticks) -> Option<Ticks> {
    Some(a.filter(|a| a.since(b).get() > u32::MAX / 2).unwrap_or(b))
}

#[cfg(test)]
mod tests {
    use super::{Delay, OnDelay, ShortTime, earlier, phase, sooner, until_change};
    use crate::Ticks;

    const fn ticks(n: u32) -> Ticks {
        Ticks::new(n)
    }

    #[test]
    fn a_short_time_stays_at_its_highest_count() {
        let counted = ShortTime::ZERO + ticks(65_534);
        assert_eq!(counted.ticks(), ticks(65_534));
        assert_eq!((counted + ticks(1)).ticks(), ticks(65_535));
        assert_eq!((counted + ticks(2)).ticks(), ticks(65_535));
        assert_eq!((counted + Ticks::MAX).ticks(), ticks(65_535));
    }

    #[test]
    fn on_delay_counts_while_its_input_is_true() {
        let mut timer = OnDelay::new();
        assert!(!timer.update(true, false, ticks(5), ticks(100)));
        assert_eq!(timer.remaining(ticks(5)), Some(ticks(5)));
        assert!(!timer.update(true, false, ticks(5), ticks(4)));
        assert!(timer.update(true, false, ticks(5), ticks(1)));
        assert!(!timer.update(true, true, ticks(5), ticks(1)));
        assert!(!timer.update(false, false, ticks(0), ticks(1)));
        assert!(timer.update(true, false, ticks(0), ticks(1)));
    }

    #[test]
    fn delay_follows_late_in_both_directions() {
        let mut delay = Delay::new();
        let mut step = |input, elapsed| {
            delay.update(input, ticks(3), ticks(2), ticks(elapsed));
            delay.output()
        };
        assert!(!step(false, 0));
        assert!(!step(true, 1));
        assert!(!step(true, 2));
        assert!(step(true, 1));
        assert!(step(false, 5));
        assert!(step(false, 1));
        assert!(!step(false, 1));
    }

    #[test]
    fn a_phase_goes_on_for_ever() {
        let next = |reached, elapsed, period| phase(ticks(reached), ticks(elapsed), ticks(period));
        assert_eq!(next(0, 999, 1000), ticks(999));
        assert_eq!(next(0, 1000, 1000), ticks(0));
        assert_eq!(next(999, 1, 1000), ticks(0));
        assert_eq!(next(999, 1001, 1000), ticks(0));
        assert_eq!(next(400, 2_700, 1000), ticks(100));
        // The longest time between two cycles, and the longest period.
        assert_eq!(next(999, u32::MAX, 1000), ticks(294));
        assert_eq!(next(u32::MAX - 1, 1, u32::MAX), ticks(0));
        assert_eq!(next(u32::MAX - 1, u32::MAX - 1, u32::MAX), ticks(u32::MAX - 2));
        assert_eq!(next(u32::MAX - 1, u32::MAX, u32::MAX), ticks(u32::MAX - 1));
        assert_eq!(next(0, 5, 1), ticks(0));
    }

    #[test]
    fn the_next_change_of_what_blinks() {
        let change = |reached| until_change(ticks(reached), ticks(700), ticks(1000));
        assert_eq!([change(0), change(699), change(700), change(999)], [ticks(700), ticks(1), ticks(300), ticks(1)]);
    }

    #[test]
    fn the_earlier_of_two_readings_of_a_clock_that_may_wrap_around() {
        let last = u32::MAX;
        assert_eq!(earlier(None, ticks(5)), Some(ticks(5)));
        assert_eq!(earlier(Some(ticks(4)), ticks(5)), Some(ticks(4)));
        assert_eq!(earlier(Some(ticks(5)), ticks(4)), Some(ticks(4)));
        assert_eq!(earlier(Some(ticks(5)), ticks(5)), Some(ticks(5)));
        assert_eq!(earlier(Some(ticks(last)), ticks(1)), Some(ticks(last)));
        assert_eq!(earlier(Some(ticks(1)), ticks(last)), Some(ticks(last)));
        assert_eq!(earlier(Some(ticks(0)), ticks(last / 2)), Some(ticks(0)));
        assert_eq!(earlier(Some(ticks(last / 2)), ticks(0)), Some(ticks(0)));
    }

    #[test]
    fn the_sooner_of_two_times() {
        assert_eq!(sooner(Some(ticks(3)), Some(ticks(2))), Some(ticks(2)));
        assert_eq!(sooner(None, Some(ticks(2))), Some(ticks(2)));
        assert_eq!(sooner(None, None), None);
    }
}
