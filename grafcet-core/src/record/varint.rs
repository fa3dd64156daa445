//! Numbers in as many bytes as they need: seven bits each, the lowest first; the highest bit says that another one follows.

/// The most bytes that a number takes.
pub(crate) const MOST: usize = 5;

/// Writes a number to the beginning of `to` and says how many bytes it took.
pub(crate) fn write(mut value: u32, to: &mut [u8]) -> usize {
    let mut taken = 0;
    for byte in to {
        let low = value.to_le_bytes()[0] & 0x7f;
        value >>= 7;
        taken += 1;
        if value == 0 {
            *byte = low;
            break;
        }
        *byte = low | 0x80;
    }
    taken
}

/// The number at the beginning and what follows it; `None` where it does not end, or is longer than it has to be or can be.
pub(crate) fn read(from: &[u8]) -> Option<(u32, &[u8])> {
    let mut value = 0;
    for (index, byte) in from.iter().take(MOST).enumerate() {
        let shift = 7 * u32::try_from(index).ok()?;
        let part = u32::from(byte & 0x7f);
        let shifted = part << shift;
        if shifted >> shift != part || index > 0 && *byte == 0 {
            return None;
        }
        value |= shifted;
        if byte & 0x80 == 0 {
            return Some((value, from.get(index + 1..)?));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{MOST, read, write};

    #[test]
    fn what_is_written_is_read() {
        for value in [0, 1, 127, 128, 300, 16_383, 16_384, 0x0fff_ffff, 0x1000_0000, u32::MAX] {
            let mut bytes = [0xaa; MOST + 1];
            let taken = write(value, &mut bytes);
            assert_eq!(read(&bytes), Some((value, &bytes[taken..])));
            assert_eq!(read(&bytes[..taken - 1]), None);
        }
    }

    #[test]
    fn there_is_one_way_to_write_a_number() {
        assert_eq!(read(&[0x80, 0x00]), None);
        assert_eq!(read(&[0xff, 0xff, 0xff, 0xff, 0x1f]), None);
        assert_eq!(read(&[0xff; 6]), None);
    }
}
