//! A chart's state as bytes that outlive a loss of power, and are not believed when they come back.

use core::fmt::{self, Display};

use crc::{CRC_32_ISCSI, Crc, NoTable};

use super::bits::{Reader, Writer, bytes_for};
use super::chart::Recordable;
use crate::Ticks;

/// The check sum of what leaves the controller.
pub(crate) const CHECK: Crc<u32, NoTable> = Crc::<u32, NoTable>::new(&CRC_32_ISCSI);

/// The first bytes, with the version of the format.
const MAGIC: [u8; 4] = [b'G', b'S', 1, 0];
/// Magic, fingerprint, layout.
const HEAD: usize = 12;
/// The check sum at the end.
const TAIL: usize = 4;

/// How many bytes a snapshot of a chart has.
#[must_use]
pub const fn snapshot_len<C: Recordable>() -> usize {
    HEAD + bytes_for(C::PARAM_BITS) + bytes_for(C::STATE_BITS) + TAIL
}

/// Writes a snapshot to the beginning of `to`, of which it takes [`snapshot_len`] bytes and returns them; `None` where `to` is shorter.
///
/// It holds the recipe and the state; times as they have elapsed, and not the reading of the clock.
pub fn snapshot<'b, C: Recordable>(chart: &C, to: &'b mut [u8]) -> Option<&'b [u8]> {
    let all = to.get_mut(..snapshot_len::<C>())?;
    let (content, tail) = all.split_at_mut_checked(snapshot_len::<C>() - TAIL)?;
    let (head, values) = content.split_at_mut_checked(HEAD)?;
    for (to, part) in head.chunks_exact_mut(4).zip([MAGIC, C::FINGERPRINT.to_le_bytes(), C::LAYOUT.to_le_bytes()]) {
        to.copy_from_slice(&part);
    }
    let (params, state) = values.split_at_mut_checked(bytes_for(C::PARAM_BITS))?;
    chart.write_params(&mut Writer::new(params));
    chart.write_state(&mut Writer::new(state));
    tail.copy_from_slice(&CHECK.checksum(content).to_le_bytes());
    Some(all)
}

/// Why bytes are no snapshot of a chart.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RestoreError {
    /// There are more or fewer bytes.
    Length {
        /// As many as a snapshot of this chart has.
        expected: usize,
    },
    /// This is no snapshot, or one of another version of this crate.
    NoSnapshot,
    /// A bit is wrong.
    CheckSum,
    /// It is a snapshot of another chart, or of another version of this one.
    OtherChart {
        /// The fingerprint in the snapshot.
        fingerprint: u32,
    },
    /// The chart is the same, but another compiler stores its state otherwise.
    OtherLayout,
    /// The values are whole, but no chart of this kind has them: a step that does not exist, or steps that are never active together.
    Impossible,
}

impl Display for RestoreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { expected } => write!(f, "a snapshot of this chart has {expected} bytes"),
            Self::NoSnapshot => f.write_str("this is no snapshot, or one of another version"),
            Self::CheckSum => f.write_str("the snapshot is damaged"),
            Self::OtherChart { fingerprint } => write!(f, "the snapshot is of another chart ({fingerprint:08x})"),
            Self::OtherLayout => f.write_str("the snapshot is of another compiler"),
            Self::Impossible => f.write_str("the chart cannot be in this state"),
        }
    }
}

impl core::error::Error for RestoreError {}

/// The chart of a snapshot.
///
/// `now` is the reading of the clock at which the chart goes on: it counts as the time of the last cycle before the snapshot, so the time without power does not count, wherever the
/// clock begins anew. Where the clock has gone on and that time shall count, give the reading of the last cycle before the snapshot.
///
/// # Errors
/// If these bytes are not exactly what [`snapshot`] has written of this chart.
pub fn restore<C: Recordable>(bytes: &[u8], now: impl Into<Ticks>) -> Result<C, RestoreError> {
    let expected = snapshot_len::<C>();
    let word = |at: usize| -> Option<[u8; 4]> { bytes.get(at..)?.first_chunk().copied() };
    let (Some(magic), Some(fingerprint), Some(layout), Some((content, check))) =
        (word(0), word(4), word(8), bytes.split_last_chunk::<TAIL>())
    else {
        return Err(RestoreError::Length { expected });
    };
    if magic != MAGIC {
        return Err(RestoreError::NoSnapshot);
    }
    if CHECK.checksum(content).to_le_bytes() != *check {
        let length = bytes.len() != expected;
        return Err(if length { RestoreError::Length { expected } } else { RestoreError::CheckSum });
    }
    let fingerprint = u32::from_le_bytes(fingerprint);
    if fingerprint != C::FINGERPRINT {
        return Err(RestoreError::OtherChart { fingerprint });
    }
    if layout != C::LAYOUT.to_le_bytes() {
        return Err(RestoreError::OtherLayout);
    }
    if bytes.len() != expected {
        return Err(RestoreError::Length { expected });
    }
    values(content.get(HEAD..).unwrap_or_default(), now.into()).ok_or(RestoreError::Impossible)
}

/// Recipe and state, where they are possible and nothing is left.
fn values<C: Recordable>(bytes: &[u8], now: Ticks) -> Option<C> {
    let (params, state) = bytes.split_at_checked(bytes_for(C::PARAM_BITS))?;
    let (mut params, mut state) = (Reader::new(params), Reader::new(state));
    let chart = C::read(&mut params, &mut state, now)?;
    let nothing_left = [params, state].iter_mut().all(|rest| rest.is_empty(rest.left()));
    (nothing_left && is_possible(&chart)).then_some(chart)
}

/// Whether the active steps can be active together.
pub(crate) fn is_possible<C: Recordable>(chart: &C) -> bool {
    let steps = C::STEPS;
    C::POSSIBLE.allows(steps.len(), |step| steps.get(step).is_some_and(|step| chart.is_active(*step)))
}
