//! Time as a chart counts it.

use core::ops::{Add, Sub};

/// A time in the clock unit of a chart (`clock 1ms;`, which is the default).
///
/// As a duration (`Step.T`, a `param` of type `time`) it is at most 2^32 - 1 units and its arithmetic saturates. As
/// the argument `now` of `cycle` it is a free-running counter, which may wrap around as often as it likes; but two consecutive
/// cycles lie less than 2^31 units apart (24.8 days in milliseconds, 35 minutes in microseconds).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ticks(u32);

impl Ticks {
    /// No time.
    pub const ZERO: Self = Self(0);
    /// The longest time that can be counted.
    pub const MAX: Self = Self(u32::MAX);

    /// So many clock units of the chart, milliseconds unless it says otherwise. The generated `ticks` computes them from a
    /// [`Duration`](core::time::Duration).
    #[must_use]
    pub const fn new(ticks: u32) -> Self {
        Self(ticks)
    }

    /// How many clock units.
    #[must_use]
    pub const fn get(self) -> u32 {
        self.0
    }

    /// The time from `earlier` to this reading of the counter, which may have wrapped around once in between.
    #[must_use]
    pub const fn since(self, earlier: Self) -> Self {
        Self(self.0.wrapping_sub(earlier.0))
    }

    /// The reading of a free-running counter after a time has passed.
    #[must_use]
    pub const fn after(self, time: Self) -> Self {
        Self(self.0.wrapping_add(time.0))
    }

    /// A duration in units of `unit_nanos` nanoseconds, rounded up, so that a wait is never too short; a longer one
    /// than can be counted becomes [`Ticks::MAX`].
    #[must_use]
    pub const fn from_duration(duration: core::time::Duration, unit_nanos: u64) -> Self {
        let ticks = duration.as_nanos().div_ceil(unit_nanos as u128);
        if ticks > u32::MAX as u128 { Self::MAX } else { Self(truncate(ticks)) }
    }
}

/// The lower half; the caller has checked that it is all.
#[expect(clippy::cast_possible_truncation, reason = "the caller has compared with u32::MAX")]
const fn truncate(ticks: u128) -> u32 {
    ticks as u32
}

/// Whether a time has reached its limit, asked as generated code is shortest.
///
/// LLVM makes "more than 999" of "at least 1000". On ARMv7-M a comparison can hold 1000 and not 999, on ARMv6-M neither: there the limit
/// comes from a table of numbers in any case, and the usual form has fewer of them.
#[doc(hidden)]
#[macro_export]
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
macro_rules! __has_reached {
    ($time:expr, $limit:expr) => {
        !($time < $limit)
    };
}

/// The same on ARMv6-M.
#[doc(hidden)]
#[macro_export]
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
macro_rules! __has_reached {
    ($time:expr, $limit:expr) => {
        $time >= $limit
    };
}

impl From<u32> for Ticks {
    fn from(ticks: u32) -> Self {
        Self(ticks)
    }
}

/// Of two durations: a sum that is too long to be counted is [`Ticks::MAX`]. A reading of the clock wraps around instead, with
/// [`Ticks::after`].
impl Add for Ticks {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

/// Of two durations: what would be less than nothing is [`Ticks::ZERO`]. Between two readings of the clock lies [`Ticks::since`].
impl Sub for Ticks {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

#[cfg(test)]
mod tests {
    use core::time::Duration;

    use super::Ticks;

    #[test]
    fn the_counter_may_wrap_between_two_readings() {
        assert_eq!(Ticks::new(3).since(Ticks::new(u32::MAX - 1)), Ticks::new(5));
    }

    #[test]
    fn arithmetic_saturates() {
        assert_eq!(Ticks::MAX + Ticks::new(1), Ticks::MAX);
        assert_eq!(Ticks::ZERO - Ticks::new(1), Ticks::ZERO);
    }

    #[test]
    fn a_duration_is_rounded_up_and_saturates() {
        assert_eq!(Ticks::from_duration(Duration::from_micros(1001), 1_000_000), Ticks::new(2));
        assert_eq!(Ticks::from_duration(Duration::from_secs(1), 1_000_000), Ticks::new(1000));
        assert_eq!(Ticks::from_duration(Duration::MAX, 1), Ticks::MAX);
    }
}
