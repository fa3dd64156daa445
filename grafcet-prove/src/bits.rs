//! Integers as wires: two's complement, as wide as the result needs, so that nothing overflows. The last wire is the sign.

use std::rc::Rc;

use crate::aig::{Aig, Lit};

/// An integer, its lowest bit first; at least one wire.
pub(crate) type Bits = Rc<[Lit]>;

pub(crate) fn constant(value: i128) -> Bits {
    let mut bits: Vec<Lit> = (0..128).map(|bit| Lit::constant(value >> bit & 1 == 1)).collect();
    trim(&mut bits);
    bits.into()
}

/// How many wires without a sign numbers take that are at most so large; one at least.
pub(crate) fn width(most: usize) -> usize {
    (usize::BITS - most.leading_zeros()).max(1) as usize
}

/// The value, where it is a constant.
pub(crate) fn known(bits: &[Lit]) -> Option<i128> {
    let mut value: i128 = 0;
    for (index, bit) in bits.iter().enumerate() {
        let set = i128::from(bit.known()?);
        match index {
            0..127 if index + 1 < bits.len() => value |= set << index,
            0..128 => value -= set << index,
            _ => return None,
        }
    }
    Some(value)
}

/// Takes away what only repeats the sign.
fn trim(bits: &mut Vec<Lit>) {
    while bits.len() > 1 && bits[bits.len() - 1] == bits[bits.len() - 2] {
        bits.pop();
    }
}

fn trimmed(mut bits: Vec<Lit>) -> Bits {
    trim(&mut bits);
    bits.into()
}

pub(crate) fn sign(bits: &[Lit]) -> Lit {
    bits.last().copied().unwrap_or(Lit::FALSE)
}

fn at(bits: &[Lit], index: usize) -> Lit {
    bits.get(index).copied().unwrap_or_else(|| sign(bits))
}

/// A number that is not negative, of wires without a sign.
pub(crate) fn unsigned(bits: &[Lit]) -> Bits {
    let mut bits = bits.to_vec();
    bits.push(Lit::FALSE);
    trimmed(bits)
}

/// Its lowest wires, as many as are asked for.
pub(crate) fn low(bits: &[Lit], width: usize) -> Vec<Lit> {
    (0..width).map(|index| at(bits, index)).collect()
}

fn sum(aig: &mut Aig, a: &[Lit], b: &[Lit], flip: Lit) -> Bits {
    let width = a.len().max(b.len()) + 1;
    let (mut carry, mut bits) = (flip, Vec::with_capacity(width));
    for index in 0..width {
        let (x, y) = (at(a, index), at(b, index).xor(flip == Lit::TRUE));
        let half = aig.xor(x, y);
        bits.push(aig.xor(half, carry));
        let (both, through) = (aig.and(x, y), aig.and(half, carry));
        carry = aig.or(both, through);
    }
    trimmed(bits)
}

pub(crate) fn add(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> Bits {
    sum(aig, a, b, Lit::FALSE)
}

pub(crate) fn sub(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> Bits {
    sum(aig, a, b, Lit::TRUE)
}

pub(crate) fn neg(aig: &mut Aig, a: &[Lit]) -> Bits {
    sub(aig, &constant(0), a)
}

pub(crate) fn mul(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> Bits {
    // The fewer rows, the better: those of a constant are folded.
    let (a, b) = if known(a).is_some() { (b, a) } else { (a, b) };
    let width = a.len() + b.len();
    let mut result = constant(0);
    for (index, bit) in b.iter().enumerate() {
        let row: Vec<Lit> = (0..width)
            .map(|place| if place < index { Lit::FALSE } else { aig.and(at(a, place - index), *bit) })
            .collect();
        let last = index + 1 == b.len();
        result = if last { sub(aig, &result, &row) } else { add(aig, &result, &row) };
        result = trimmed(low(&result, width));
    }
    result
}

pub(crate) fn less(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> Lit {
    sign(&sub(aig, a, b))
}

pub(crate) fn equal(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> Lit {
    let width = a.len().max(b.len());
    (0..width).fold(Lit::TRUE, |all, index| {
        let same = aig.iff(at(a, index), at(b, index));
        aig.and(all, same)
    })
}

pub(crate) fn mux(aig: &mut Aig, condition: Lit, then: &[Lit], otherwise: &[Lit]) -> Bits {
    let width = then.len().max(otherwise.len());
    trimmed((0..width).map(|index| aig.mux(condition, at(then, index), at(otherwise, index))).collect())
}

/// Wire by wire.
pub(crate) fn each(aig: &mut Aig, a: &[Lit], b: &[Lit], gate: fn(&mut Aig, Lit, Lit) -> Lit) -> Bits {
    let width = a.len().max(b.len());
    trimmed((0..width).map(|index| gate(aig, at(a, index), at(b, index))).collect())
}

pub(crate) fn flip(bits: &[Lit]) -> Bits {
    bits.iter().map(|bit| !*bit).collect()
}

/// Whether a type of so many bits has the value.
pub(crate) fn fits(aig: &mut Aig, bits: &[Lit], signed: bool, width: usize) -> Lit {
    let top = if signed { at(bits, width - 1) } else { Lit::FALSE };
    (width..bits.len().max(width + 1)).fold(Lit::TRUE, |all, index| {
        let same = aig.iff(at(bits, index), top);
        aig.and(all, same)
    })
}

/// What is left of it in a type.
pub(crate) fn wrap(bits: &[Lit], signed: bool, width: usize) -> Bits {
    let mut kept = low(bits, width);
    if !signed {
        kept.push(Lit::FALSE);
    }
    trimmed(kept)
}

/// Quotient and remainder of Rust, which round towards zero; of a divisor that is not zero.
pub(crate) fn div_rem(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> (Bits, Bits) {
    let (minus_a, minus_b) = (neg(aig, a), neg(aig, b));
    let (sign_a, sign_b) = (sign(a), sign(b));
    let dividend = mux(aig, sign_a, &minus_a, a);
    let divisor = mux(aig, sign_b, &minus_b, b);
    let (mut rest, mut quotient) = (constant(0), vec![Lit::FALSE; dividend.len()]);
    for index in (0..dividend.len()).rev() {
        let mut shifted = vec![dividend[index]];
        shifted.extend(rest.iter());
        let less = sub(aig, &shifted, &divisor);
        let goes = !sign(&less);
        quotient[index] = goes;
        let kept = mux(aig, goes, &less, &shifted);
        rest = trimmed(low(&kept, divisor.len().min(kept.len())));
    }
    quotient.push(Lit::FALSE);
    let quotient = trimmed(quotient);
    let (minus_quotient, minus_rest) = (neg(aig, &quotient), neg(aig, &rest));
    let differ = aig.xor(sign_a, sign_b);
    (mux(aig, differ, &minus_quotient, &quotient), mux(aig, sign_a, &minus_rest, &rest))
}

/// Shifted to the left by what is less than `width`.
pub(crate) fn shift_left(aig: &mut Aig, a: &[Lit], by: &[Lit], width: usize) -> Bits {
    let mut result = low(a, width);
    for (stage, bit) in stages(by, width) {
        result = (0..width)
            .map(|index| {
                let moved = if index < stage { Lit::FALSE } else { result[index - stage] };
                aig.mux(bit, moved, result[index])
            })
            .collect();
    }
    trimmed(result)
}

/// The same to the right, with the sign.
pub(crate) fn shift_right(aig: &mut Aig, a: &[Lit], by: &[Lit], width: usize) -> Bits {
    let mut result = a.to_vec();
    for (stage, bit) in stages(by, width) {
        result = (0..result.len()).map(|index| aig.mux(bit, at(&result, index + stage), result[index])).collect();
    }
    trimmed(result)
}

fn stages(by: &[Lit], width: usize) -> Vec<(usize, Lit)> {
    let count = usize::BITS - width.saturating_sub(1).leading_zeros();
    (0..count as usize).map(|index| (1 << index, at(by, index))).collect()
}
