//! Cycles and states as bytes, for the ring and for the wire.

use super::bits::{Writer, bytes_for};
use super::chart::Recordable;
use super::decode::{CHANGED, FEW, FRESH, KEY, MASKED, SAME, SOON, mask_len};
use super::value::Record;
use super::varint;
use crate::Ticks;

/// A cycle whose inputs are written down, in front of it.
#[derive(Debug)]
pub struct Cycle<'r, C: Recordable> {
    pub(crate) skipped: u32,
    pub(crate) elapsed: u32,
    pub(crate) before: &'r C::Inputs,
    pub(crate) inputs: &'r C::Inputs,
}

/// A state that is written down.
#[derive(Debug)]
pub struct State<'r, C: Recordable> {
    pub(crate) chart: &'r C,
    pub(crate) inputs: &'r C::Inputs,
    pub(crate) flags: u8,
    /// How many cycles in front of it are written nowhere, and how many there were in all.
    pub(crate) skipped: u32,
    pub(crate) cycles: u32,
    pub(crate) at: Ticks,
}

/// How many bytes inputs, recipe and state of a chart take.
pub(crate) const fn inputs_len<C: Recordable>() -> usize {
    bytes_for(<C::Inputs as Record>::BITS)
}

pub(crate) const fn params_len<C: Recordable>() -> usize {
    bytes_for(C::PARAM_BITS)
}

pub(crate) const fn state_len<C: Recordable>() -> usize {
    bytes_for(C::STATE_BITS)
}

/// The most bytes of a key: flags, cycle, reading, and three parts with their lengths.
pub(crate) const fn key_len<C: Recordable>() -> usize {
    9 + inputs_len::<C>() + params_len::<C>() + state_len::<C>() + 3 * 3
}

/// The most bytes of a key as an entry: control and a number in front of it.
pub(crate) const fn key_entry_len<C: Recordable>() -> usize {
    1 + varint::MOST + key_len::<C>()
}

/// The most bytes of a cycle: control, two numbers and inputs.
pub(crate) const fn cycle_len<C: Recordable>() -> usize {
    1 + 2 * varint::MOST + mask_len(inputs_len::<C>()) + inputs_len::<C>()
}

impl<C: Recordable> Cycle<'_, C> {
    /// As an entry; how many bytes it takes.
    pub(crate) fn write(&self, to: &mut [u8]) -> usize {
        let mut to = Bytes { to, at: 1 };
        let is_changed = !self.inputs.is_same(self.before);
        let control = to.number(self.skipped, FEW) << 2 | to.number(self.elapsed, SOON) << 4;
        to.set(0, control | if is_changed { CHANGED } else { SAME });
        if is_changed {
            to.change::<C>(self.before, self.inputs);
        }
        to.at
    }
}

impl<C: Recordable> State<'_, C> {
    /// As the key of a block; how many bytes it takes.
    pub(crate) fn write_key(&self, to: &mut [u8]) -> usize {
        let mut to = Bytes { to, at: 0 };
        to.key(self);
        to.at
    }

    /// As an entry; how many bytes it takes.
    pub(crate) fn write_entry(&self, to: &mut [u8]) -> usize {
        let mut to = Bytes { to, at: 1 };
        let control = to.number(self.skipped, FEW) << 2;
        to.set(0, control | KEY);
        to.key(self);
        to.at
    }
}

/// Bytes that are filled from the front. There is always enough room, which is asked for before.
struct Bytes<'b> {
    to: &'b mut [u8],
    at: usize,
}

impl Bytes<'_> {
    fn set(&mut self, at: usize, value: u8) {
        if let Some(byte) = self.to.get_mut(at) {
            *byte = value;
        }
    }

    fn push(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.set(self.at, *byte);
            self.at += 1;
        }
    }

    /// A number as bits of the control byte; what does not fit there follows.
    fn number(&mut self, number: u32, limit: u32) -> u8 {
        match number.checked_sub(limit) {
            Some(more) => {
                self.varint(more);
                limit.to_le_bytes()[0]
            }
            None => number.to_le_bytes()[0],
        }
    }

    fn varint(&mut self, number: u32) {
        self.at += varint::write(number, self.to.get_mut(self.at..).unwrap_or_default());
    }

    /// So many bytes, which `write` fills.
    fn packed(&mut self, len: usize, write: impl FnOnce(&mut Writer<'_>)) {
        if let Some(to) = self.to.get_mut(self.at..self.at + len) {
            write(&mut Writer::new(to));
            self.at += len;
        }
    }

    fn part(&mut self, bits: usize, write: impl FnOnce(&mut Writer<'_>)) {
        let len = bytes_for(bits);
        self.varint(u32::try_from(len).unwrap_or(u32::MAX));
        self.packed(len, write);
    }

    fn key<C: Recordable>(&mut self, state: &State<'_, C>) {
        let State { chart, inputs, flags, cycles, at, .. } = state;
        let fresh = if chart.is_same_state(&chart.begun_anew()) { FRESH } else { 0 };
        self.push(&[fresh | flags]);
        self.push(&cycles.to_le_bytes());
        self.push(&at.get().to_le_bytes());
        self.part(<C::Inputs as Record>::BITS, |to| inputs.write(to));
        self.part(C::PARAM_BITS, |to| chart.write_params(to));
        self.part(C::STATE_BITS, |to| chart.write_state(to));
    }

    /// What has changed of the inputs, byte by byte.
    fn change<C: Recordable>(&mut self, before: &C::Inputs, inputs: &C::Inputs) {
        let len = bytes_for(<C::Inputs as Record>::BITS);
        let mask_len = mask_len(len);
        if mask_len == 0 {
            return self.packed(len, |to| inputs.write(to));
        }
        let (mut old, mut new) = ([0; MASKED], [0; MASKED]);
        before.write(&mut Writer::new(&mut old));
        inputs.write(&mut Writer::new(&mut new));
        let mask = self.at;
        self.push(&[0; MASKED / 8][..mask_len]);
        for (index, (old, new)) in old.iter().zip(&new).enumerate() {
            if old != new {
                if let Some(mask) = self.to.get_mut(mask + index / 8) {
                    *mask |= 1 << (index % 8);
                }
                self.push(&[*new]);
            }
        }
    }
}
