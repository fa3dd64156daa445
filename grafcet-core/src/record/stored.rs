//! A snapshot in whatever format `serde` writes.

use core::fmt;

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, Serializer};

use super::chart::Recordable;
use super::snapshot::{RestoreError, restore, snapshot, snapshot_len};
use crate::Ticks;

/// What `serde` stores of a chart, and reads back: a [`snapshot`], of which [`restore`](Self::restore) makes a chart if it is one.
///
/// It has [`snapshot_len`] bytes, so a program names it `type StoredMotor = Stored<{ snapshot_len::<Motor>() }>`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Stored<const N: usize>([u8; N]);

impl<const N: usize> Stored<N> {
    /// The state of a chart as it is.
    #[must_use]
    pub fn of<C: Recordable>(chart: &C) -> Self {
        const { assert!(N == snapshot_len::<C>(), "`Stored` has as many bytes as `snapshot_len` says of the chart") };
        let mut bytes = [0; N];
        _ = snapshot(chart, &mut bytes);
        Self(bytes)
    }

    /// The chart, as [`restore`] makes it of a snapshot.
    ///
    /// # Errors
    /// If this is not exactly what [`Stored::of`] has made of this chart.
    pub fn restore<C: Recordable>(&self, now: impl Into<Ticks>) -> Result<C, RestoreError> {
        restore(&self.0, now)
    }

    /// The snapshot.
    #[must_use]
    pub const fn as_bytes(&self) -> &[u8] {
        &self.0
    }
}

impl<const N: usize> Serialize for Stored<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_bytes(&self.0)
    }
}

impl<'de, const N: usize> Deserialize<'de> for Stored<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_bytes(Bytes)
    }
}

struct Bytes<const N: usize>;

impl<'de, const N: usize> Visitor<'de> for Bytes<N> {
    type Value = Stored<N>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the {N} bytes of a chart's snapshot")
    }

    fn visit_bytes<E: Error>(self, bytes: &[u8]) -> Result<Self::Value, E> {
        bytes.try_into().map(Stored).map_err(|_| E::invalid_length(bytes.len(), &self))
    }

    /// Formats for people have no bytes.
    fn visit_seq<A: SeqAccess<'de>>(self, mut bytes: A) -> Result<Self::Value, A::Error> {
        let mut all = [0; N];
        for (index, to) in all.iter_mut().enumerate() {
            *to = bytes.next_element()?.ok_or_else(|| A::Error::invalid_length(index, &self))?;
        }
        match bytes.next_element::<u8>()? {
            None => Ok(Stored(all)),
            Some(_) => Err(A::Error::invalid_length(N + 1, &self)),
        }
    }
}
