//! The instants of other crates as the argument `now` of `cycle`.
//!
//! They are taken as they count: the chart's `clock` has to be the unit of the instant, `clock 1us;` for a
//! `fugit::MonotonicTimerInstantU32<1_000_000>` or an embassy time driver of 1 MHz. Scaling them instead would break the
//! difference of two readings when the counter wraps around. Two consecutive cycles lie less than 2^31 of these units apart.

use crate::Ticks;

#[cfg(feature = "fugit")]
impl<const NOM: u64, const DENOM: u64, K: fugit::kind::Kind> From<fugit::Instant<u32, NOM, DENOM, K>> for Ticks {
    /// The count of the instant; `NOM / DENOM` seconds have to be the chart's clock unit.
    fn from(now: fugit::Instant<u32, NOM, DENOM, K>) -> Self {
        Self::new(now.as_ticks())
    }
}

#[cfg(feature = "fugit")]
impl<const NOM: u64, const DENOM: u64, K: fugit::kind::Kind> From<fugit::Instant<u64, NOM, DENOM, K>> for Ticks {
    /// The lower half of the count, which wraps around as a 32-bit counter does; `NOM / DENOM` seconds have to be the
    /// chart's clock unit.
    fn from(now: fugit::Instant<u64, NOM, DENOM, K>) -> Self {
        Self::new(lower_half(now.as_ticks()))
    }
}

#[cfg(feature = "embassy-time")]
impl From<embassy_time::Instant> for Ticks {
    /// The lower half of the count, which wraps around as a 32-bit counter does; a tick of the time driver has to be the
    /// chart's clock unit.
    fn from(now: embassy_time::Instant) -> Self {
        Self::new(lower_half(now.as_ticks()))
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a wrapping counter is what is wanted")]
const fn lower_half(ticks: u64) -> u32 {
    ticks as u32
}

#[cfg(all(test, feature = "fugit"))]
mod tests {
    use crate::Ticks;

    #[test]
    fn instants_are_taken_as_they_count() {
        assert_eq!(Ticks::from(fugit::WrappingTimerInstantU32::<1_000>::from_ticks(7)), Ticks::new(7));
        assert_eq!(Ticks::from(fugit::MonotonicTimerInstantU64::<1_000>::from_ticks((1 << 32) + 7)), Ticks::new(7));
    }
}
