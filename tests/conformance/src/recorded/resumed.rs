//! A chart that loses its power at random moments.

use grafcet::{Chart, Ticks};
use grafcet_core::record::{Recordable, restore, snapshot, snapshot_len};

use super::Recorded;
use crate::random::Rng;
use crate::{Shown, Subject, Values};

/// A chart that is stored, dropped and restored now and then, its clock where it was or elsewhere.
pub(super) struct Resumed<S: Recorded> {
    chart: S::Chart,
    recipe: Values,
    shown: Shown,
    /// The reading of its own clock in its last cycle.
    last: u32,
    /// How far that clock is ahead of the one that never stops.
    ahead: u32,
    rng: Rng,
}

/// Where a clock may begin anew.
const BEGINS: [u32; 6] = [0, 1, 40_000, u32::MAX - 3, 0x7fff_fff0, 0x8000_0000];

impl<S: Recorded> Resumed<S> {
    pub(super) fn new(seed: u64) -> Self {
        let chart = S::make();
        let shown = S::begun(&chart);
        Self { chart, recipe: Values::new(), shown, last: 0, ahead: 0, rng: Rng::new(seed) }
    }

    fn lose_power(&mut self) -> Result<(), String> {
        let stored = bytes_of(&self.chart)?;
        let reading = if self.rng.chance(50) { self.last } else { *self.rng.pick(&BEGINS) };
        self.ahead = self.ahead.wrapping_add(reading.wrapping_sub(self.last));
        self.last = reading;
        self.chart = restore(&stored, reading).map_err(|error| format!("not restored: {error}"))?;
        if bytes_of(&self.chart)? == stored { Ok(()) } else { Err("what was restored is stored otherwise".to_owned()) }
    }
}

pub(super) fn bytes_of<C: Recordable>(chart: &C) -> Result<Vec<u8>, String> {
    let mut bytes = vec![0xa5; snapshot_len::<C>()];
    snapshot(chart, &mut bytes).ok_or("a snapshot is longer than it says")?;
    Ok(bytes)
}

impl<S: Recorded> Subject for Resumed<S> {
    fn cycle(&mut self, inputs: &Values, now: u32) -> Result<Shown, String> {
        if self.rng.chance(20) {
            self.lose_power()?;
        }
        self.last = now.wrapping_add(self.ahead);
        let (inputs, reading, chart) = (S::inputs(inputs), Ticks::new(self.last), &mut self.chart);
        let mut outputs = None;
        let calls = S::called(&mut |actions| outputs = Some(chart.scan(&inputs, reading, actions)));
        self.shown = S::shown(&self.chart, &outputs.ok_or("no cycle")?);
        Ok(Shown { calls, ..self.shown.clone() })
    }

    fn init(&mut self) -> Result<(), String> {
        self.chart.init();
        self.shown = S::begun(&self.chart);
        if self.rng.chance(50) { self.lose_power() } else { Ok(()) }
    }

    fn set_params(&mut self, changed: &Values) -> Result<(), String> {
        self.recipe.extend(changed.clone());
        S::set_params(&mut self.chart, &self.recipe);
        Ok(())
    }

    fn shown(&self) -> Shown {
        self.shown.clone()
    }

    fn next_deadline(&self) -> Option<u32> {
        self.chart.wakes_at().map(|deadline| deadline.get().wrapping_sub(self.ahead))
    }
}
