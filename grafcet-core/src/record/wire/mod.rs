//! A record over a wire: a frame for each cycle that is written down, for a state now and then, and for the hash of one in between.
//!
//! A frame is COBS-encoded and ends with a zero. It holds its kind, its number, and a CRC-32C of all of it.

mod answer;
mod decode;
mod follow;
mod send;

use super::bits::Writer;
use super::chart::Recordable;
use super::encode::{cycle_len, key_entry_len, params_len, state_len};
use super::snapshot::CHECK;

pub use answer::{Answer, Refused};
#[cfg(feature = "steer")]
pub(super) use decode::checked;
pub use decode::{Decoder, Frame, Received};
pub use follow::{Follow, Seen, Trouble};
pub use send::{Wire, wire_len};

/// The kinds of frames, with the version of the format above them.
const VERSION: u8 = 0x10;
const STATE: u8 = VERSION | 1;
const CYCLE: u8 = VERSION | 2;
const HASH: u8 = VERSION | 3;
const ANSWER: u8 = VERSION | 4;
/// In front of what a frame says: its kind and its number.
const HEAD: usize = 3;
/// The check sum after it.
const TAIL: usize = 4;
/// In front of a state: which chart it is of.
const OWNER: usize = 8;

/// How long the frames of a chart are at most, before they are encoded.
const fn raw_len<C: Recordable>() -> usize {
    let (state, cycle) = (OWNER + key_entry_len::<C>(), cycle_len::<C>());
    HEAD + if state > cycle { state } else { cycle } + TAIL
}

/// How many bytes a [`Decoder`] needs for the frames of a chart.
#[must_use]
pub const fn frame_len<C: Recordable>() -> usize {
    cobs::max_encoding_length(raw_len::<C>())
}

/// The CRC-32C of a chart's recipe and state, which `scratch` has room for.
fn hash<C: Recordable>(chart: &C, scratch: &mut [u8]) -> Option<u32> {
    let (params, rest) = scratch.split_at_mut_checked(params_len::<C>())?;
    chart.write_params(&mut Writer::new(params));
    let state = rest.get_mut(..state_len::<C>())?;
    chart.write_state(&mut Writer::new(state));
    let mut digest = CHECK.digest();
    digest.update(params);
    digest.update(state);
    Some(digest.finalize())
}
