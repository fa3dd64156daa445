//! Floats: `REAL` and `LREAL`, by the same arithmetic (IEEE 754).

use grafcet_compiler::model::Tree;

/// `2.5E-3` of a literal of Rust such as `2.5e-3` or `2.5e-3f32`; none of what is no float.
pub(super) fn literal(text: &str) -> Option<String> {
    let text = text.replace('_', "");
    let number = text.strip_suffix("f32").or_else(|| text.strip_suffix("f64"));
    let number = match number {
        Some(number) => number,
        None if text.contains(['.', 'e', 'E']) => &text,
        None => return None,
    };
    if !number.starts_with(|c: char| c.is_ascii_digit()) || number.parse::<f64>().is_err() {
        return None;
    }
    let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, ""));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let part = if part.is_empty() { "0" } else { part };
    let exponent = if exponent.is_empty() { String::new() } else { format!("E{exponent}") };
    Some(format!("{whole}.{part}{exponent}"))
}

/// Whether something in it is Rust that is not looked into; a literal is not.
pub(super) fn is_rust(tree: &Tree) -> bool {
    match tree {
        Tree::Opaque { text, .. } => literal(text).is_none(),
        Tree::Unary(_, inner) => is_rust(inner),
        Tree::Binary(_, a, b) => is_rust(a) || is_rust(b),
        _ => false,
    }
}

/// Whether it is a literal that can be divided by.
pub(super) fn is_above_zero(tree: &Tree) -> bool {
    let Tree::Opaque { text, .. } = tree else { return false };
    literal(text).and_then(|number| number.parse::<f64>().ok()).is_some_and(|number| number > 0.0)
}

#[cfg(test)]
mod tests {
    use super::literal;

    #[test]
    fn literals_of_rust() {
        for (rust, number) in [
            ("2.5", "2.5"),
            ("2.", "2.0"),
            ("1_000.25_5", "1000.255"),
            ("1e-3", "1.0E-3"),
            ("2.5E+10", "2.5E+10"),
            ("7f32", "7.0"),
            ("0.1f64", "0.1"),
        ] {
            assert_eq!(literal(rust).as_deref(), Some(number), "{rust}");
        }
        for rust in ["7", "0xef32", "0x1e3", "f32", "e", "PI", "x.abs()", "1.0.max(x)", "inf"] {
            assert_eq!(literal(rust), None, "{rust}");
        }
    }
}
