//! How much time passes between two cycles: of many magnitudes, but always less than 2^31 ticks, as generated charts ask for.

use super::Rng;

/// The longest time between two cycles.
const LONGEST: u32 = (1 << 31) - 1;

/// A free-running counter that wraps.
pub(super) struct Clock {
    now: u32,
    /// How many cycles nothing but time passes, in leaps: so steps stay active while the counter wraps.
    night: usize,
}

impl Clock {
    /// It need not begin with zero.
    pub(super) fn new(rng: &mut Rng) -> Self {
        let now = *rng.pick(&[0, 0, 1000, u32::MAX - 20, 0x8000_0000, LONGEST]);
        Self { now, night: 0 }
    }

    /// Whether inputs stay as they are.
    pub(super) fn is_night(&self) -> bool {
        self.night > 0
    }

    /// The reading of the next cycle, which comes so much later by day.
    pub(super) fn next(&mut self, rng: &mut Rng, pause: u32) -> u32 {
        let leaps = self.night > 0 || rng.below(60) == 0;
        self.now = self.now.wrapping_add(if leaps { leap(rng) } else { pause });
        self.night = match self.night {
            0 if rng.below(90) == 0 => rng.between(2, 14),
            night => night.saturating_sub(1),
        };
        self.now
    }
}

fn leap(rng: &mut Rng) -> u32 {
    let few = u32::try_from(rng.below(12)).unwrap_or_default();
    match rng.below(8) {
        0 | 1 => LONGEST,
        2 => LONGEST - few,
        3 => 1 << rng.below(31),
        4 => (1 << rng.below(31)) + few,
        5 => 0x4000_0000,
        6 => 70_000,
        _ => few,
    }
}
