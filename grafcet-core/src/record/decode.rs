//! What is left in a ring, without the chart: keys and entries.

use super::chart::Recordable;
use super::ring::{self, Found, MOST_BLOCKS, Owner};
use super::varint;

/// The longest inputs of which only what has changed is written.
pub(crate) const MASKED: usize = 32;

/// The two lowest bits of an entry say what it is.
pub(crate) const SAME: u8 = 1;
pub(crate) const CHANGED: u8 = 2;
pub(crate) const KEY: u8 = 3;
/// The flags of a key.
pub(crate) const FRESH: u8 = 1;
pub(crate) const REPLACED: u8 = 2;
/// A number of cycles from here on stands in bytes of its own.
pub(crate) const FEW: u32 = 3;
/// A time from here on stands in bytes of its own.
pub(crate) const SOON: u32 = 15;

/// What is left of a recording.
#[derive(Clone, Copy, Debug)]
pub struct Records<'b> {
    blocks: [Option<Found<'b>>; MOST_BLOCKS],
}

/// Why there is nothing to read, or no more.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Damage {
    /// There is no record in these bytes, or nothing of it is whole.
    NoRecord,
    /// The record is of another chart, or of another version of it.
    OtherChart {
        /// The fingerprint in the record.
        fingerprint: u32,
    },
    /// The chart is the same, but another compiler stores its state otherwise.
    OtherLayout,
    /// Bytes that are whole, but mean nothing: a mistake of whoever wrote them.
    Nonsense,
}

/// A block: a state and what has happened since.
#[derive(Clone, Copy, Debug)]
pub struct Block<'b> {
    /// The number of the block, from one on. Where one is missing, it was overwritten or is damaged.
    pub number: u32,
    /// How many blocks are missing in front of this one.
    pub missing: u32,
    /// The program ended while it wrote the last entry, or a bit of it has changed since: that entry is missing.
    pub torn: bool,
    /// The state at the begin.
    pub key: Key<'b>,
    rest: &'b [u8],
}

/// A state, from which on a chart can be run again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Key<'b> {
    /// Whether the chart is as `new`, `with_params` or `init` leave it: then the recipe says it all.
    pub fresh: bool,
    /// Whether the recording begins here, or the chart was changed from outside (`init`, `set_params`): the state does not follow from what
    /// stands before.
    pub replaced: bool,
    /// How many cycles there were before; after 2^32 of them this begins again at zero.
    pub cycle: u32,
    /// The reading of the clock in the last one, in the clock units of the chart; it wraps around. Of a chart without time it is
    /// the time of the last cycle that was written down.
    pub reading: u32,
    /// The inputs of the last cycle.
    pub inputs: &'b [u8],
    /// The recipe.
    pub params: &'b [u8],
    /// Everything else.
    pub state: &'b [u8],
}

/// What is written in a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Entry<'b> {
    /// How many cycles in front of it did nothing of their own, with the inputs as they were.
    pub skipped: u32,
    /// What has happened.
    pub what: Happened<'b>,
}

/// What has happened.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Happened<'b> {
    /// A cycle.
    Cycle {
        /// The time since the entry before, in the clock units of the chart. The readings of the clock may have wrapped around in
        /// between. The time itself has not, as an entry is written soon enough; but in a chart without time, of which nobody reads the
        /// clock, it may have.
        elapsed: u32,
        /// What has changed of the inputs; `None` if nothing.
        change: Option<Change<'b>>,
    },
    /// The chart is in this state now.
    State(Key<'b>),
}

/// What has changed of the inputs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Change<'b> {
    /// A bit for each byte: it has another value. Empty where all bytes are written.
    mask: &'b [u8],
    values: &'b [u8],
}

impl<'b> Change<'b> {
    /// The new inputs, where all bytes are written.
    pub(crate) const fn all(&self) -> Option<&'b [u8]> {
        if self.mask.is_empty() { Some(self.values) } else { None }
    }

    /// Changes the inputs of the cycle before into those of this one. They are bytes as in [`Key::inputs`], and as many; bytes that have
    /// not changed stay as they are.
    pub fn apply(&self, inputs: &mut [u8]) {
        let mut values = self.values.iter();
        for (index, byte) in inputs.iter_mut().enumerate() {
            let bit = self.mask.get(index / 8).map(|mask| mask >> (index % 8) & 1);
            if bit.unwrap_or(u8::from(self.mask.is_empty())) != 0 {
                if let Some(value) = values.next() {
                    *byte = *value;
                }
            }
        }
    }
}

/// How many bytes the mask has for inputs of so many bytes.
pub(crate) const fn mask_len(inputs: usize) -> usize {
    if inputs > 1 && inputs <= MASKED { inputs.div_ceil(8) } else { 0 }
}

impl<'b> Records<'b> {
    /// Looks for what is left of a recording in the memory of a [`Recorder`](super::Recorder).
    ///
    /// # Errors
    /// If nothing whole is found.
    pub fn of(bytes: &'b [u8]) -> Result<Self, Damage> {
        let blocks = ring::all(bytes);
        if blocks.iter().flatten().next().is_none() { Err(Damage::NoRecord) } else { Ok(Self { blocks }) }
    }

    /// The fingerprint of the chart that was recorded.
    #[must_use]
    pub fn fingerprint(&self) -> u32 {
        self.owner().fingerprint
    }

    /// How the compiler stored the chart's state.
    #[must_use]
    pub fn layout(&self) -> u32 {
        self.owner().layout
    }

    fn owner(&self) -> Owner {
        self.blocks.iter().flatten().next().map_or(Owner { fingerprint: 0, layout: 0 }, |block| block.owner)
    }

    /// Whether it is a recording of the chart `C`.
    ///
    /// # Errors
    /// If it is one of another chart, or of another version of this one.
    pub fn check<C: Recordable>(&self) -> Result<(), Damage> {
        let Owner { fingerprint, layout } = self.owner();
        if fingerprint != C::FINGERPRINT {
            return Err(Damage::OtherChart { fingerprint });
        }
        if layout == C::LAYOUT { Ok(()) } else { Err(Damage::OtherLayout) }
    }

    /// The blocks in the order of time; what is overwritten or damaged is missing.
    pub fn blocks(&self) -> impl Iterator<Item = Result<Block<'b>, Damage>> + use<'b> {
        let owner = self.owner();
        let mut expected = 1;
        self.blocks.into_iter().flatten().map(move |found| {
            let missing = found.number.wrapping_sub(expected);
            expected = found.number.wrapping_add(1);
            if found.owner != owner {
                return Err(Damage::OtherChart { fingerprint: found.owner.fingerprint });
            }
            let (key, rest) = key(found.content).ok_or(Damage::Nonsense)?;
            Ok(Block { number: found.number, missing, torn: found.torn, key, rest })
        })
    }
}

impl<'b> Block<'b> {
    /// What has happened since the block's begin.
    pub fn entries(&self) -> impl Iterator<Item = Result<Entry<'b>, Damage>> + use<'b> {
        let (mut rest, inputs) = (self.rest, self.key.inputs.len());
        core::iter::from_fn(move || {
            if rest.is_empty() {
                return None;
            }
            match entry(rest, inputs) {
                Some((entry, after)) => {
                    rest = after;
                    Some(Ok(entry))
                }
                None => {
                    rest = &[];
                    Some(Err(Damage::Nonsense))
                }
            }
        })
    }
}

fn key(bytes: &[u8]) -> Option<(Key<'_>, &[u8])> {
    let (flags, rest) = bytes.split_first()?;
    let (cycle, rest) = rest.split_first_chunk()?;
    let (reading, rest) = rest.split_first_chunk()?;
    let (inputs, rest) = part(rest)?;
    let (params, rest) = part(rest)?;
    let (state, rest) = part(rest)?;
    let [cycle, reading] = [cycle, reading].map(|number| u32::from_le_bytes(*number));
    let (fresh, replaced) = (flags & FRESH != 0, flags & REPLACED != 0);
    (*flags <= FRESH | REPLACED).then_some((Key { fresh, replaced, cycle, reading, inputs, params, state }, rest))
}

/// A length and so many bytes.
fn part(bytes: &[u8]) -> Option<(&[u8], &[u8])> {
    let (len, rest) = varint::read(bytes)?;
    rest.split_at_checked(usize::try_from(len).ok()?)
}

pub(crate) fn entry(bytes: &[u8], inputs: usize) -> Option<(Entry<'_>, &[u8])> {
    let (control, rest) = bytes.split_first()?;
    let number = |short: u32, limit: u32, rest| {
        if short < limit {
            return Some((short, rest));
        }
        let (more, rest) = varint::read(rest)?;
        Some((limit.checked_add(more)?, rest))
    };
    let (skipped, rest) = number(u32::from(control >> 2 & 3), FEW, rest)?;
    if control & 3 == KEY {
        let (key, rest) = key(rest)?;
        return (control >> 4 == 0).then_some((Entry { skipped, what: Happened::State(key) }, rest));
    }
    let (elapsed, rest) = number(u32::from(control >> 4), SOON, rest)?;
    let (change, rest) = match control & 3 {
        SAME => (None, rest),
        CHANGED => {
            let (mask, rest) = rest.split_at_checked(mask_len(inputs))?;
            let set = mask.iter().map(|byte| byte.count_ones() as usize).sum();
            let (values, rest) = rest.split_at_checked(if mask.is_empty() { inputs } else { set })?;
            (Some(Change { mask, values }), rest)
        }
        _ => return None,
    };
    Some((Entry { skipped, what: Happened::Cycle { elapsed, change } }, rest))
}
