//! A situation with a bit for each step (`encoding flags;`).

/// The first bit that is set from a byte on, among those of a mask, counted from there; after all of the mask where there is none.
#[must_use]
pub const fn first<const N: usize, const K: usize>(flags: &[u8; N], from: usize, mask: &[u8; K]) -> usize {
    let mut byte = 0;
    while byte < K {
        let at = from.wrapping_add(byte);
        let here = if at < N { flags[at] & mask[byte] } else { 0 };
        if here != 0 {
            return byte.wrapping_mul(8).wrapping_add(here.trailing_zeros() as usize);
        }
        byte += 1;
    }
    K.wrapping_mul(8)
}

/// One bit is set instead of another one; a bit that there is not stands for none.
#[inline]
pub fn exchange<const N: usize>(flags: &mut [u8; N], from: usize, to: usize) {
    if let Some(byte) = flags.get_mut(from / 8) {
        *byte &= !(1 << (from % 8));
    }
    if let Some(byte) = flags.get_mut(to / 8) {
        *byte |= 1 << (to % 8);
    }
}

#[cfg(test)]
mod tests {
    use super::{exchange, first};

    #[test]
    fn the_first_bit_of_a_mask_is_found() {
        let flags = [0b0000_0001, 0b1010_0000, 0b0000_0010];
        assert_eq!(first(&flags, 0, &[0xff]), 0);
        assert_eq!(first(&flags, 1, &[0xff]), 5);
        assert_eq!(first(&flags, 0, &[0xfe, 0xc0]), 15);
        assert_eq!(first(&flags, 1, &[0x0f, 0x0f]), 9);
        assert_eq!(first(&flags, 0, &[0xfe, 0x1f, 0x01]), 24);
        // What is after the flags is not set.
        assert_eq!(first(&flags, 2, &[0x01, 0xff]), 16);
    }

    #[test]
    fn a_bit_takes_the_place_of_another_one() {
        let mut flags = [0b0000_0001, 0b1010_0000];
        exchange(&mut flags, 0, 9);
        assert_eq!(flags, [0, 0b1010_0010]);
        exchange(&mut flags, 16, 0);
        assert_eq!(flags, [1, 0b1010_0010]);
        exchange(&mut flags, 15, usize::MAX);
        assert_eq!(flags, [1, 0b0010_0010]);
    }
}
