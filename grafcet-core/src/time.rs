//! Times: how far a period is, and which of two is the earlier one.

use crate::Ticks;

/// How far a period is that goes on while time passes: the phase of something that blinks, which neither saturates nor wraps. It is
/// below the period, which is not zero.
#[must_use]
pub fn phase(reached: Ticks, elapsed: Ticks, period: Ticks) -> Ticks {
    let elapsed = if elapsed < period { elapsed } else { rest(elapsed, period) }.get();
    let left = period - reached;
    Ticks::new(if elapsed < left.get() {
        reached.get().wrapping_add(elapsed)
    } else {
        elapsed.wrapping_sub(left.get())
    })
}

/// What is left of a time after whole periods, none of which is zero.
#[must_use]
pub fn rest(elapsed: Ticks, period: Ticks) -> Ticks {
    // ARMv6-M divides by a call that takes two hundred bytes.
    Ticks::new(if cfg!(all(target_arch = "arm", not(target_has_atomic = "32"))) {
        rest_by_subtraction(elapsed.get(), period.get())
    } else {
        elapsed.get().checked_rem(period.get()).unwrap_or(0)
    })
}

#[inline(never)]
fn rest_by_subtraction(elapsed: u32, period: u32) -> u32 {
    if period == 0 {
        return 0;
    }
    let (mut rest, mut periods) = (elapsed, period);
    while periods <= rest >> 1 {
        periods <<= 1;
    }
    while periods >= period {
        if periods <= rest {
            rest = rest.wrapping_sub(periods);
        }
        periods >>= 1;
    }
    rest
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
    use super::{earlier, phase, rest_by_subtraction, sooner};
    use crate::Ticks;

    const fn ticks(n: u32) -> Ticks {
        Ticks::new(n)
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

    #[test]
    fn what_is_left_after_whole_periods_is_the_remainder() {
        let times = [
            0,
            1,
            2,
            3,
            499,
            500,
            501,
            999,
            1_000,
            65_535,
            65_536,
            86_400_000,
            u32::MAX / 2,
            u32::MAX / 2 + 1,
            u32::MAX - 1,
            u32::MAX,
        ];
        for elapsed in times {
            for period in times {
                assert_eq!(
                    rest_by_subtraction(elapsed, period),
                    elapsed.checked_rem(period).unwrap_or(0),
                    "{elapsed} {period}"
                );
            }
        }
    }
}
