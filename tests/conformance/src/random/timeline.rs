//! Random timelines: few inputs change at a time, the clock is irregular and wraps.

use std::fmt::Write as _;

use super::Gen;
use super::clock::Clock;
use super::names::{Role, Ty};

impl Gen {
    pub(super) fn timeline(&mut self, cycles: usize) -> String {
        let (bools, bytes) = (self.names.of(Role::Input, Ty::Bool), self.names.of(Role::Input, Ty::U8));
        let ints = self.names.of(Role::Input, Ty::I16);
        let mut on = vec![false; bools.len()];
        let (mut byte, mut int, mut mode) = (0, 0, 0);
        let mut clock = Clock::new(&mut self.rng);
        let mut text = String::new();
        for _ in 0..cycles {
            self.directive(&mut text);
            // A calm stretch lets timers elapse and searches settle; a storm finds the coincidences.
            let changes = *self.rng.pick(&[0, 0, 1, 1, 1, 2, 3]);
            for _ in 0..if clock.is_night() { 0 } else { changes } {
                let index = self.rng.below(bools.len());
                on[index] = !on[index];
            }
            if self.rng.chance(20) && !clock.is_night() {
                byte = self.rng.below(9);
                int = self.rng.between(0, 16);
            }
            let named = bools.iter().zip(&on).filter(|(_, on)| **on).map(|(name, _)| format!("{name} "));
            text.extend(named);
            for name in &bytes {
                _ = write!(text, "{name}={byte} ");
            }
            for name in &ints {
                _ = write!(text, "{name}={} ", i32::try_from(int).unwrap_or_default() - 8);
            }
            if self.names.modes {
                mode = if self.rng.chance(20) { self.rng.below(3) } else { mode };
                _ = write!(text, "mode={mode} ");
            }
            let pause = self.pause();
            let now = clock.next(&mut self.rng, pause);
            _ = writeln!(text, "@{now} | |");
        }
        text
    }

    /// The time to the next cycle.
    fn pause(&mut self) -> u32 {
        match self.rng.below(100) {
            0..=9 => 0,
            10..=49 => 1,
            50..=79 => *self.rng.pick(&[2, 3, 4, 5]),
            80..=97 => *self.rng.pick(&[6, 8, 10, 13, 20, 40]),
            _ => 5000,
        }
    }

    /// An `init` or another recipe, now and then.
    fn directive(&mut self, text: &mut String) {
        if self.rng.below(200) == 0 {
            text.push_str("init\n");
        }
        let params: Vec<_> = self.names.values.iter().filter(|value| value.role == Role::Param).cloned().collect();
        if params.is_empty() || self.rng.below(60) > 0 {
            return;
        }
        text.push_str("params");
        for param in params {
            let value = match param.ty {
                Ty::Bool => self.rng.below(2),
                _ => self.rng.below(10),
            };
            _ = write!(text, " {}={value}", param.name);
        }
        text.push('\n');
    }
}
