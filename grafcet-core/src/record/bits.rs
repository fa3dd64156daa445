//! Values as bits, the lowest first.

/// How many bits tell `count` values apart.
#[must_use]
pub const fn bits_for(count: usize) -> usize {
    match count {
        0 | 1 => 0,
        _ => (usize::BITS - (count - 1).leading_zeros()) as usize,
    }
}

/// How many bytes so many bits take.
pub(crate) const fn bytes_for(bits: usize) -> usize {
    bits.div_ceil(8)
}

/// Puts values into bytes, bit by bit. What does not fit is dropped: whoever makes one knows how many bits there will be.
#[derive(Debug)]
pub struct Writer<'b> {
    bytes: &'b mut [u8],
    at: usize,
}

impl<'b> Writer<'b> {
    /// Writes into these bytes, from their beginning on.
    pub fn new(bytes: &'b mut [u8]) -> Self {
        bytes.fill(0);
        Self { bytes, at: 0 }
    }

    /// The lowest bits of a number.
    pub fn put(&mut self, mut value: u32, mut bits: usize) {
        while bits > 0 {
            let (byte, shift) = (self.at / 8, self.at % 8);
            let room = (8 - shift).min(bits);
            let Some(byte) = self.bytes.get_mut(byte) else { return };
            #[expect(clippy::cast_possible_truncation, reason = "the lowest bits are meant")]
            let part = value as u8 & (0xff >> (8 - room));
            *byte |= part << shift;
            value = value.checked_shr(u32::try_from(room).unwrap_or(32)).unwrap_or(0);
            self.at += room;
            bits -= room;
        }
    }

    /// So many bits that say nothing.
    pub fn skip(&mut self, bits: usize) {
        self.at += bits;
    }
}

/// Takes values out of bytes, as a [`Writer`] put them there.
#[derive(Debug)]
pub struct Reader<'b> {
    bytes: &'b [u8],
    at: usize,
}

impl<'b> Reader<'b> {
    /// Reads these bytes from their beginning on.
    #[must_use]
    pub const fn new(bytes: &'b [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    /// A number of so many bits, of at most 32; `None` after the end.
    pub fn take(&mut self, bits: usize) -> Option<u32> {
        let (mut value, mut done) = (0, 0);
        while done < bits {
            let (byte, shift) = (self.at / 8, self.at % 8);
            let room = (8 - shift).min(bits - done);
            let part = (*self.bytes.get(byte)? >> shift) & (0xff >> (8 - room));
            value |= u32::from(part).checked_shl(u32::try_from(done).ok()?)?;
            self.at += room;
            done += room;
        }
        Some(value)
    }

    /// Whether so many bits follow that all are zero, as they are after the last value.
    pub fn is_empty(&mut self, bits: usize) -> bool {
        (0..bits).all(|_| self.take(1) == Some(0))
    }

    /// How many bits are left.
    #[must_use]
    pub fn left(&self) -> usize {
        (self.bytes.len() * 8).saturating_sub(self.at)
    }
}

#[cfg(test)]
mod tests {
    use super::{Reader, Writer, bits_for};

    #[test]
    fn what_is_put_is_taken() {
        let mut bytes = [0xff; 9];
        let values = [(1, 1), (5, 3), (0xabcd, 16), (0, 0), (0xdead_beef, 32), (0x1ff, 9), (3, 2)];
        let mut writer = Writer::new(&mut bytes);
        for (value, bits) in values {
            writer.put(value, bits);
        }
        let mut reader = Reader::new(&bytes);
        for (value, bits) in values {
            assert_eq!(reader.take(bits), Some(value));
        }
        assert_eq!(reader.left(), 9);
        assert!(reader.is_empty(9) && !reader.is_empty(1));
        assert_eq!(reader.take(1), None);
    }

    #[test]
    fn as_many_bits_as_tell_them_apart() {
        assert_eq!([0, 1, 2, 3, 4, 5, 256, 257].map(bits_for), [0, 0, 1, 2, 2, 3, 8, 9]);
    }
}
