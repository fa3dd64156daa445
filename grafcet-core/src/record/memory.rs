//! A record in memory: the ring, and the bytes that it lies in.

use super::chart::Recordable;
use super::encode::{Cycle, State, cycle_len, key_entry_len, key_len};
use super::keep::Keep;
use super::recorder::TooSmall;
use super::ring::{self, Owner, Ring};

/// Keeps a record in memory, whose oldest part is overwritten when it is full.
#[derive(Debug)]
pub struct Memory<M> {
    bytes: M,
    ring: Ring,
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Memory<M> {
    /// For a chart `C`; clears what is there.
    pub(crate) fn of<C: Recordable>(mut bytes: M) -> Result<Self, TooSmall> {
        let all = bytes.as_mut();
        let divided = ring::divided(all.len(), key_len::<C>(), cycle_len::<C>());
        let (block, blocks) = divided.ok_or(TooSmall { needed: least::<C>() })?;
        all.fill(0);
        let owner = Owner { fingerprint: C::FINGERPRINT, layout: C::LAYOUT };
        Ok(Self { bytes, ring: Ring::new(owner, block, blocks) })
    }

    /// The record, for [`Records`](super::Records).
    pub fn bytes(&self) -> &[u8] {
        self.bytes.as_ref()
    }

    pub(crate) fn into_bytes(self) -> M {
        self.bytes
    }
}

/// The least bytes for a record of a chart.
pub(crate) const fn least<C: Recordable>() -> usize {
    ring::least(key_len::<C>(), cycle_len::<C>())
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Keep for Memory<M> {
    fn is_due<C: Recordable>(&self) -> bool {
        self.ring.room() < cycle_len::<C>()
    }

    /// In this block, or at the begin of the next one.
    fn state<C: Recordable>(&mut self, state: &State<'_, C>) {
        if self.ring.room() < key_entry_len::<C>() {
            self.ring.begin(self.bytes.as_mut(), |to| state.write_key(to));
        } else {
            self.ring.append(self.bytes.as_mut(), |to| state.write_entry(to));
        }
    }

    fn cycle<C: Recordable>(&mut self, cycle: &Cycle<'_, C>) {
        self.ring.append(self.bytes.as_mut(), |to| cycle.write(to));
    }
}
