//! Strings of bits, and what makes them of numbers.

use super::{Type, Value, type_of};

/// How many bits a `WORD` has.
pub(super) fn length(name: &str) -> Option<u32> {
    [("byte", 8), ("word", 16), ("dword", 32), ("lword", 64)]
        .into_iter()
        .find(|(of, _)| *of == name)
        .map(|(_, bits)| bits)
}

/// `INT_TO_WORD`, `WORD_TO_INT`: the bits stay, so both have as many.
pub(super) fn converted(from: &str, to: &str, value: Value) -> Result<Value, String> {
    let wrong = || Err(format!("{from}_TO_{to}({value:?})"));
    match (length(from), length(to), value) {
        (None, Some(bits), Value::Int(number)) => match type_of(from)? {
            Type::Int(low, high) if high - low == mask(bits) && (low..=high).contains(&number) => {
                Ok(Value::Bits(Some(bits), u64::try_from(number & mask(bits)).unwrap_or(0)))
            }
            _ => wrong(),
        },
        (Some(bits), None, Value::Bits(of, value)) if of.is_none_or(|of| of == bits) => match type_of(to)? {
            Type::Int(low, high) if high - low == mask(bits) => {
                let number = i128::from(value);
                Ok(Value::Int(if number > high { number - mask(bits) - 1 } else { number }))
            }
            _ => wrong(),
        },
        _ => wrong(),
    }
}

/// Both of one length; the result is, too.
pub(super) fn binary(
    operator: &str,
    (a, first): (Option<u32>, u64),
    (b, second): (Option<u32>, u64),
) -> Result<Value, String> {
    let bits = a.or(b);
    if b.is_some_and(|of| Some(of) != bits) || bits.is_none() {
        return Err(format!("{a:?} bits {operator} {b:?} bits"));
    }
    if let Some(literal) = [first, second].into_iter().find(|value| i128::from(*value) > mask(bits.unwrap_or(64))) {
        return Err(format!("16#{literal:X} has more than {bits:?} bits"));
    }
    Ok(match operator {
        "and" => Value::Bits(bits, first & second),
        "or" => Value::Bits(bits, first | second),
        "xor" => Value::Bits(bits, first ^ second),
        "=" => Value::Bool(first == second),
        "<>" => Value::Bool(first != second),
        _ => return Err(format!("{operator} of bits")),
    })
}

pub(super) fn not(bits: u32, value: u64) -> Value {
    Value::Bits(Some(bits), u64::try_from(!i128::from(value) & mask(bits)).unwrap_or(0))
}

/// `SHL`, `SHR`: what is shifted out is lost.
pub(super) fn shifted(function: &str, value: Value, places: Value) -> Result<Value, String> {
    let (Value::Bits(Some(bits), value), Value::Int(places @ 0..=63)) = (value, places) else {
        return Err(format!("{function}({value:?}, {places:?})"));
    };
    let wide = i128::from(value);
    let moved = if function == "shl" { wide << places & mask(bits) } else { wide >> places };
    Ok(Value::Bits(Some(bits), u64::try_from(moved).unwrap_or(0)))
}

fn mask(bits: u32) -> i128 {
    (1 << bits) - 1
}
