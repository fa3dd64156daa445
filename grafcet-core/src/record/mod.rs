//! The flight recorder: the inputs of a chart as they change, in a ring of bytes, from which everything else follows.
//!
//! A chart is deterministic: its state and the inputs of each cycle say what it does. A [`Recorder`] runs a chart and notes the
//! inputs where they differ from those of the cycle before, and the cycles in which the chart does something of its own
//! accord. [`Records`] reads what is left in the ring, on the controller or on another machine, and [`replay`] runs the chart on it again.
//! The format stands in the page `docs/record.md`.

mod bits;
#[cfg(feature = "postcard")]
#[doc(hidden)]
pub mod by_serde;
mod chart;
mod coding;
mod decode;
mod encode;
mod keep;
mod memory;
mod recorder;
mod replay;
mod ring;
mod snapshot;
#[cfg(feature = "steer")]
pub mod steer;
#[cfg(feature = "serde")]
mod stored;
mod value;
mod varint;
#[cfg(feature = "wire")]
pub mod wire;

pub use bits::{Reader, Writer, bits_for};
#[cfg(feature = "postcard")]
pub use by_serde::postcard_len;
pub use chart::{Blocked, Recordable};
pub use decode::{Block, Change, Damage, Entry, Happened, Key, Records};
pub use keep::Keep;
pub use memory::Memory;
pub use recorder::{Recorder, TooSmall};
pub use replay::{Moment, ReplayError, replay};
pub use snapshot::{RestoreError, restore, snapshot, snapshot_len};
#[cfg(feature = "serde")]
pub use stored::Stored;
pub use value::Record;

/// What generated code names.
#[doc(hidden)]
pub mod names {
    pub use core::marker::Copy;
    pub use core::mem::discriminant;
    pub use core::option::Option;
    pub use core::primitive::{bool, u32, usize};

    pub use super::coding::{Coding, Optional, Own};
    pub use super::value::number_in;
    pub use super::{Reader, Record, Recordable, Writer, bits_for};
    pub use crate::{Possible, Ticks};
}
