//! The ring: blocks of equal length, the oldest of which is overwritten. Each begins with a key state, so that what is left can always
//! be read.

use core::sync::atomic::{Ordering, compiler_fence};

use crc::{CRC_16_XMODEM, Crc, NoTable};

/// The check sum of a block: it begins with zero and is not changed in the end, so that it can go on from where it was.
const CHECK: Crc<u16, NoTable> = Crc::<u16, NoTable>::new(&CRC_16_XMODEM);

/// The first bytes of a block, with the version of the format; how many blocks there are follows.
const MAGIC: [u8; 3] = [b'G', b'R', 1];
/// In front of a block's key state: magic, fingerprint, layout, number of the block, and twice what is valid.
pub(crate) const HEADER: usize = 24;
/// The fields up to those that change while a block is filled.
const FIXED: usize = 16;
/// How much of a block is valid, and its check sum; two of these, written in turn.
const COMMIT: usize = 4;
/// As many blocks as there can be.
pub(crate) const MOST_BLOCKS: usize = 8;
/// One is being filled while the other can be read.
const LEAST_BLOCKS: usize = 2;

/// Which chart a block is of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Owner {
    pub(crate) fingerprint: u32,
    pub(crate) layout: u32,
}

/// Writes to the ring.
#[derive(Debug)]
pub(crate) struct Ring {
    owner: Owner,
    /// How long a block is, and how many there are.
    block: usize,
    blocks: usize,
    /// The number of the block that is being filled, from one on; zero: there is none.
    number: u32,
    /// How much of it is filled, after its header, and the check sum of that.
    filled: usize,
    check: u16,
    /// Which of the two places is written next.
    second: bool,
}

/// In how many blocks, and how long ones, a ring is divided whose entries have up to `most` bytes after a key of `key` bytes.
pub(crate) fn divided(len: usize, key: usize, most: usize) -> Option<(usize, usize)> {
    let comfortable = HEADER + key + 4 * most;
    let least = HEADER + key + most;
    let blocks = (len / comfortable.max(1)).clamp(LEAST_BLOCKS, MOST_BLOCKS);
    let block = length(len, blocks);
    (block >= least).then_some((block, blocks))
}

/// How long each of so many blocks is; none is longer than its fill level can say.
fn length(len: usize, blocks: usize) -> usize {
    (len / blocks).min(usize::from(u16::MAX))
}

/// The least bytes of a ring.
pub(crate) const fn least(key: usize, most: usize) -> usize {
    LEAST_BLOCKS * (HEADER + key + most)
}

impl Ring {
    pub(crate) const fn new(owner: Owner, block: usize, blocks: usize) -> Self {
        Self { owner, block, blocks, number: 0, filled: 0, check: 0, second: false }
    }

    /// How many bytes can still be written to the block.
    pub(crate) const fn room(&self) -> usize {
        if self.number == 0 { 0 } else { self.block - HEADER - self.filled }
    }

    fn start(&self) -> usize {
        // The first block has the number one.
        let index = self.number.wrapping_sub(1) as usize % self.blocks;
        index * self.block
    }

    /// Begins a block with what `write` writes; it says how many bytes these are.
    pub(crate) fn begin(&mut self, bytes: &mut [u8], write: impl FnOnce(&mut [u8]) -> usize) {
        self.number = self.number.wrapping_add(1).max(1);
        let start = self.start();
        let Some(block) = bytes.get_mut(start..start + self.block) else { return };
        let Some((header, _)) = block.split_at_mut_checked(HEADER) else { return };
        // Until its key is there, the block is none.
        header.fill(0);
        compiler_fence(Ordering::SeqCst);
        let [a, b, c] = MAGIC;
        let magic = [a, b, c, u8::try_from(self.blocks).unwrap_or(0)];
        let parts =
            [magic, self.owner.fingerprint.to_le_bytes(), self.owner.layout.to_le_bytes(), self.number.to_le_bytes()];
        for (to, part) in header.chunks_exact_mut(4).zip(parts) {
            to.copy_from_slice(&part);
        }
        self.check = CHECK.checksum(header.get(..FIXED).unwrap_or_default());
        self.filled = 0;
        self.second = false;
        self.append(bytes, write);
    }

    /// Appends what `write` writes to the rest of the block; it says how many bytes these are.
    pub(crate) fn append(&mut self, bytes: &mut [u8], write: impl FnOnce(&mut [u8]) -> usize) {
        let (from, to) = (self.start() + HEADER + self.filled, self.start() + self.block);
        let written = bytes.get_mut(from..to).map_or(0, write);
        self.commit(bytes, written);
    }

    /// What has been written is valid from now on. Whatever happens in between, one of both places says what is.
    fn commit(&mut self, bytes: &mut [u8], written: usize) {
        let start = self.start();
        let from = start + HEADER + self.filled;
        let mut digest = CHECK.digest_with_initial(self.check);
        digest.update(bytes.get(from..from + written).unwrap_or_default());
        self.check = digest.finalize();
        self.filled += written;
        compiler_fence(Ordering::SeqCst);
        let place = start + FIXED + if self.second { COMMIT } else { 0 };
        self.second = !self.second;
        let filled = u16::try_from(self.filled).unwrap_or(u16::MAX).to_le_bytes();
        let check = self.check.to_le_bytes();
        if let Some(to) = bytes.get_mut(place..place + COMMIT) {
            to.copy_from_slice(&[filled[0], filled[1], check[0], check[1]]);
        }
        compiler_fence(Ordering::SeqCst);
    }
}

/// A block as it is found.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found<'b> {
    pub(crate) owner: Owner,
    pub(crate) number: u32,
    /// What stands after the header, as far as it is valid.
    pub(crate) content: &'b [u8],
    /// The last entry was being written when the program ended.
    pub(crate) torn: bool,
}

/// All blocks of a ring, in the order in which they were written, and how many bytes each has; whatever the length of the ring says.
pub(crate) fn all(bytes: &[u8]) -> [Option<Found<'_>>; MOST_BLOCKS] {
    let mut best = [None; MOST_BLOCKS];
    for blocks in LEAST_BLOCKS..=MOST_BLOCKS {
        let mut these = [None; MOST_BLOCKS];
        let parts = bytes.chunks_exact(length(bytes.len(), blocks).max(1)).take(blocks);
        for (found, block) in these.iter_mut().zip(parts) {
            *found = found_in(block, blocks);
        }
        let count = |all: &[Option<Found<'_>>]| all.iter().flatten().count();
        if count(&these) > count(&best) {
            best = these;
        }
    }
    best.sort_unstable_by_key(|block| block.map_or(u32::MAX, |block| block.number));
    best
}

/// A block of a ring of so many; `None` where there is none, or nothing in it is valid.
fn found_in(block: &[u8], blocks: usize) -> Option<Found<'_>> {
    let (header, rest) = block.split_at_checked(HEADER)?;
    if header.get(..3)? != MAGIC || usize::from(*header.get(3)?) != blocks {
        return None;
    }
    let word = |at: usize| Some(u32::from_le_bytes(header.get(at..at + 4)?.try_into().ok()?));
    let fixed = CHECK.checksum(header.get(..FIXED)?);
    let valid = |at: usize| {
        let [low, high, check_low, check_high] = word(at)?.to_le_bytes();
        let content = rest.get(..usize::from(u16::from_le_bytes([low, high])))?;
        let mut digest = CHECK.digest_with_initial(fixed);
        digest.update(content);
        let whole = !content.is_empty() && digest.finalize() == u16::from_le_bytes([check_low, check_high]);
        whole.then_some(content)
    };
    let (one, other) = (valid(FIXED), valid(FIXED + COMMIT));
    let content = [one, other].into_iter().flatten().max_by_key(|content| content.len())?;
    // The place that is not used yet holds nothing.
    let damaged = |content: Option<&[u8]>, at| content.is_none() && word(at) != Some(0);
    let torn = damaged(one, FIXED) || damaged(other, FIXED + COMMIT);
    Some(Found { owner: Owner { fingerprint: word(4)?, layout: word(8)? }, number: word(12)?, content, torn })
}
