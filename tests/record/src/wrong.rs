//! Bytes that are nearly right: with a few other bits, or after check sums that fit them.

use grafcet::record::Recordable;

use crate::Chance;

/// CRC-32C, bit by bit.
#[must_use]
pub fn check(bytes: &[u8]) -> [u8; 4] {
    let step = |sum: u32| if sum & 1 == 0 { sum >> 1 } else { sum >> 1 ^ 0x82f6_3b78 };
    let byte = |sum: u32, byte: &u8| (0..8).fold(sum ^ u32::from(*byte), |sum, _| step(sum));
    (!bytes.iter().fold(u32::MAX, byte)).to_le_bytes()
}

/// CRC-16/XMODEM, bit by bit.
fn short_check(bytes: impl Iterator<Item = u8>) -> [u8; 2] {
    let step = |sum: u16| if sum & 0x8000 == 0 { sum << 1 } else { sum << 1 ^ 0x1021 };
    bytes.fold(0, |sum, byte| (0..8).fold(sum ^ u16::from(byte) << 8, |sum, _| step(sum))).to_le_bytes()
}

/// The same with a few other bits, bytes or lengths.
#[must_use]
pub fn spoilt(bytes: &[u8], chance: &mut Chance) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=chance.below(4) {
        if bytes.is_empty() {
            bytes.push(0);
        }
        let place = chance.below(u32::try_from(bytes.len()).unwrap_or(1)) as usize;
        match chance.below(6) {
            0 => bytes.truncate(place.max(1)),
            1 => bytes.insert(place, chance.number().to_le_bytes()[0]),
            2 => bytes[place] = chance.number().to_le_bytes()[0],
            3 => bytes[place] = 0xff,
            _ => bytes[place] ^= 1 << chance.below(8),
        }
    }
    bytes
}

/// A frame of this content.
#[must_use]
pub fn frame(content: &[u8]) -> Vec<u8> {
    let mut frame = Vec::new();
    let whole = [content, &check(content)].concat();
    for part in whole.split(|byte| *byte == 0) {
        let mut parts = part.chunks(254).peekable();
        if part.is_empty() {
            frame.push(1);
        }
        while let Some(chunk) = parts.next() {
            frame.push(u8::try_from(chunk.len() + 1).unwrap_or(u8::MAX));
            frame.extend(chunk);
            if chunk.len() == 254 && parts.peek().is_none() {
                frame.push(1);
            }
        }
    }
    frame.push(0);
    frame
}

/// The content of a frame.
#[must_use]
pub fn content(frame: &[u8]) -> Option<Vec<u8>> {
    let (mut content, mut rest) = (Vec::new(), frame.strip_suffix(&[0])?);
    while let Some((len, after)) = rest.split_first() {
        let (part, after) = after.split_at_checked(usize::from(*len) - 1)?;
        content.extend(part);
        if *len < 255 && !after.is_empty() {
            content.push(0);
        }
        rest = after;
    }
    content.truncate(content.len().checked_sub(4)?);
    Some(content)
}

/// A snapshot of a chart with these bytes for recipe and state, as far as they go.
#[must_use]
pub fn snapshot_of<C: Recordable>(values: &[u8]) -> Vec<u8> {
    let mut bytes = [*b"GS\x01\0", C::FINGERPRINT.to_le_bytes(), C::LAYOUT.to_le_bytes()].concat();
    let len = C::PARAM_BITS.div_ceil(8) + C::STATE_BITS.div_ceil(8);
    bytes.extend(values.iter().copied().chain(std::iter::repeat(0)).take(len));
    bytes.extend(check(&bytes));
    bytes
}

/// A record of a chart in blocks of so many bytes, each with one of these contents, as far as it goes.
#[must_use]
pub fn record_of<C: Recordable>(block: usize, contents: &[&[u8]]) -> Vec<u8> {
    const HEAD: usize = 24;
    let blocks = contents.len().clamp(2, 8);
    let mut record = vec![0; blocks * block];
    for (index, (to, content)) in record.chunks_mut(block).zip(contents).enumerate() {
        let len = content.len().min(block - HEAD);
        let number = u32::try_from(index + 1).unwrap_or(0);
        let count = u8::try_from(blocks).unwrap_or(0);
        let head =
            [[b'G', b'R', 1, count], C::FINGERPRINT.to_le_bytes(), C::LAYOUT.to_le_bytes(), number.to_le_bytes()];
        to[..16].copy_from_slice(&head.concat());
        to[HEAD..HEAD + len].copy_from_slice(&content[..len]);
        let valid = u16::try_from(len).unwrap_or(0).to_le_bytes();
        let sum = short_check(to[..16].iter().chain(&to[HEAD..HEAD + len]).copied());
        to[16..20].copy_from_slice(&[valid, sum].concat());
    }
    record
}
