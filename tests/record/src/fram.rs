//! Snapshots in an FRAM: two places, written in turn, so that one of them is whole whenever the power goes. `docs/record.md` shows it.

use grafcet::Ticks;
use grafcet::record::{Recordable, restore, snapshot};

/// Memory that keeps what was written byte by byte, up to where the power went.
pub trait Fram {
    /// Reads from an address on.
    fn read(&mut self, address: usize, to: &mut [u8]);
    /// Writes from an address on.
    fn write(&mut self, address: usize, bytes: &[u8]);
}

/// The number of a snapshot, and the same with all bits turned over.
const HEAD: usize = 8;

/// Two places for snapshots of a chart, from an address on; `LEN` is `snapshot_len` of the chart.
#[derive(Debug)]
pub struct Places<F, const LEN: usize> {
    fram: F,
    address: usize,
    /// Of the last snapshot, which stands at place `number % 2`.
    number: u32,
}

impl<F: Fram, const LEN: usize> Places<F, LEN> {
    /// The bytes that they take.
    pub const BYTES: usize = 2 * (HEAD + LEN);

    /// The chart as it was stored last, if it was ever stored; `now` is the reading at which it goes on, as of [`restore`].
    pub fn open<C: Recordable>(fram: F, address: usize, now: Ticks) -> (Self, Option<C>) {
        let mut places = Self { fram, address, number: 0 };
        let found = [0, 1].map(|place| places.load::<C>(place, now));
        let newest = found.into_iter().flatten().max_by_key(|(number, _)| *number);
        places.number = newest.as_ref().map_or(0, |(number, _)| *number);
        (places, newest.map(|(_, chart)| chart))
    }

    /// Stores the chart: a snapshot at the place of the older one, and then its number.
    pub fn store<C: Recordable>(&mut self, chart: &C) {
        let mut bytes = [0; LEN];
        let Some(bytes) = snapshot(chart, &mut bytes) else { return };
        self.number += 1;
        let at = self.at(self.number);
        // From here on the older one is none.
        self.fram.write(at, &[0; HEAD]);
        self.fram.write(at + HEAD, bytes);
        self.fram.write(at, &head(self.number));
    }

    fn load<C: Recordable>(&mut self, place: u32, now: Ticks) -> Option<(u32, C)> {
        let (mut found, mut bytes) = ([0; HEAD], [0; LEN]);
        let at = self.at(place);
        self.fram.read(at, &mut found);
        self.fram.read(at + HEAD, &mut bytes);
        let number = u32::from_le_bytes(*found.first_chunk()?);
        (found == head(number)).then_some((number, restore(&bytes, now).ok()?))
    }

    fn at(&self, number: u32) -> usize {
        self.address + (HEAD + LEN) * (number % 2) as usize
    }
}

fn head(number: u32) -> [u8; HEAD] {
    let [a, b, c, d] = number.to_le_bytes();
    [a, b, c, d, !a, !b, !c, !d]
}
