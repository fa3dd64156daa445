//! Arithmetic of integers that Rust writes as a cast or as a method.

use super::value::{Error, Term, Width, binary, compare, int};
use grafcet_compiler::model::{Binary, How, Integer};

/// The result, or none where it is one that nobody knows.
pub(super) fn computed(how: How, operands: &[Term], text: &str) -> Option<Result<Term, Error>> {
    match (how, operands) {
        (How::Get, [Term::Ticks(ticks)]) => {
            Some(Ok(Term::Int(i128::from(*ticks), Some(Width { signed: false, bits: 32 }))))
        }
        (How::As(into), [value]) => cast(*value, into),
        (How::Min | How::Max, [a, b]) => {
            Some(ordered(*a, *b).map(|(low, high)| if how == How::Min { low } else { high }))
        }
        (How::Clamp, [value, low, high]) => {
            let above = ordered(*value, *low).map(|(_, above)| above);
            Some(above.and_then(|above| ordered(above, *high).map(|(low, _)| low)))
        }
        (How::Wrapping(operator) | How::Saturating(operator), [Term::Int(a, left), Term::Int(b, right)]) => {
            let width = left.or(*right)?;
            let exact = exact(operator, *a, *b)?;
            let wraps = matches!(how, How::Wrapping(_));
            Some(Ok(Term::Int(if wraps { width.wrapped(exact)? } else { width.saturated(exact)? }, Some(width))))
        }
        (_, [Term::Int(value, width)]) => {
            let unsigned = width.map(|width| Width { signed: false, ..width });
            match how {
                How::Abs => Some(int(value.checked_abs(), *width, text)),
                How::UnsignedAbs => Some(int(value.checked_abs(), unsigned, text)),
                How::Signum => Some(Ok(Term::Int(value.signum(), *width))),
                _ => None,
            }
        }
        (_, [Term::Int(a, left), Term::Int(b, right)]) => {
            let width = left.or(*right);
            let unsigned = width.map(|width| Width { signed: false, ..width });
            match how {
                How::AbsDiff => Some(int(a.checked_sub(*b).and_then(i128::checked_abs), unsigned, text)),
                How::DivEuclid | How::RemEuclid if *b == 0 => Some(Err(Error::DivisionByZero)),
                How::DivEuclid => Some(int(a.checked_div_euclid(*b), width, text)),
                // As with `%`, the division has to fit.
                How::RemEuclid => {
                    let fits = a.checked_div_euclid(*b).filter(|of| width.is_none_or(|width| width.holds(*of)));
                    Some(int(fits.and(a.checked_rem_euclid(*b)), width, text))
                }
                How::Pow => {
                    let exponent = u32::try_from(*b).ok();
                    Some(int(exponent.and_then(|exponent| a.checked_pow(exponent)), *left, text))
                }
                _ => None,
            }
        }
        _ => None,
    }
}

/// The smaller one in front.
fn ordered(a: Term, b: Term) -> Result<(Term, Term), Error> {
    // That both are of one type is looked at there.
    binary(Binary::Le, a, b)?;
    let (Term::Int(left, one), Term::Int(right, other)) = (a, b) else {
        return Err(Error::Type(format!("{a:?} with {b:?}")));
    };
    let width = one.or(other);
    let less = compare(Binary::Le, &left, &right) == Some(Term::Bool(true));
    let (low, high) = if less { (left, right) } else { (right, left) };
    Ok((Term::Int(low, width), Term::Int(high, width)))
}

fn exact(operator: Binary, a: i128, b: i128) -> Option<i128> {
    match operator {
        Binary::Add => a.checked_add(b),
        Binary::Sub => a.checked_sub(b),
        Binary::Mul => a.checked_mul(b),
        _ => None,
    }
}

/// `a as u16`. Of `usize`, whose bits nobody knows, what fits into 32 bits.
fn cast(value: Term, into: Integer) -> Option<Result<Term, Error>> {
    let value = match value {
        Term::Bool(value) => i128::from(value),
        // As an enum is numbered that says nothing else.
        Term::Int(value, _) | Term::Name(_, Some(value)) => value,
        _ => return None,
    };
    let width = Width { signed: into.signed, bits: if into.is_size { 32 } else { into.bits } };
    if into.is_size && !width.holds(value) {
        return None;
    }
    Some(Ok(Term::Int(width.wrapped(value)?, Some(width))))
}

impl Width {
    fn range(self) -> Option<(i128, i128)> {
        match (self.signed, self.bits) {
            (_, 127..) => None,
            (true, bits) => Some((-(1 << (bits - 1)), (1 << (bits - 1)) - 1)),
            (false, bits) => Some((0, (1 << bits) - 1)),
        }
    }

    fn saturated(self, value: i128) -> Option<i128> {
        self.range().map(|(low, high)| value.clamp(low, high))
    }

    fn wrapped(self, value: i128) -> Option<i128> {
        let Some((low, _)) = self.range() else { return self.holds(value).then_some(value) };
        Some((value - low).rem_euclid(1 << self.bits) + low)
    }
}
