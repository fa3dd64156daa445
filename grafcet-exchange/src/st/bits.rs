//! Operators on the bits of integers: a PLC has them for strings of bits, so that a number is one for as long as they last.

use grafcet_compiler::model::{Binary, Tree, Unary};

use super::expr::{At, Kind, Scope, refuse};
use super::text::{Text, not, strength};
use crate::Refused;

/// `WORD` of `UINT`, how many bits it has, and whether the number has a sign.
fn string(name: &str) -> (&'static str, u32, bool) {
    let (string, bits) = match name.trim_start_matches('U') {
        "SINT" => ("BYTE", 8),
        "INT" => ("WORD", 16),
        "DINT" => ("DWORD", 32),
        _ => ("LWORD", 64),
    };
    (string, bits, !name.starts_with('U'))
}

fn operates(tree: &Tree) -> bool {
    use Binary::{BitAnd, BitOr, BitXor, Shl, Shr};
    matches!(tree, Tree::Unary(Unary::Not, _) | Tree::Binary(BitAnd | BitOr | BitXor | Shl | Shr, ..))
}

impl Scope<'_> {
    /// Whether an operator is one on bits, and not on truths.
    pub(super) fn is_of_bits(&self, tree: &Tree, wanted: &Kind) -> bool {
        operates(tree) && *self.kind(tree).as_ref().unwrap_or(wanted) != Kind::Bool
    }

    /// Its result as a number.
    pub(super) fn of_bits(&mut self, tree: &Tree, wanted: &Kind, at: &At<'_>) -> Result<Text, Refused> {
        if self.steps.is_some() {
            let mend = "write it as arithmetic, or as a function of the program";
            return Err(refuse(at, "in SFC an operator on the bits of integers", mend));
        }
        let kind = self.kind(tree).filter(|kind| *kind != Kind::Number).unwrap_or_else(|| wanted.clone());
        let Kind::Int(name) = kind else {
            return Err(refuse(
                at,
                "an operator on the bits of what is no integer of a known type",
                "declare it as a value",
            ));
        };
        if let Some(number) = folded(tree, name) {
            return self.tree(&Tree::Int(number), &kind, at);
        }
        let bits = self.bits(tree, name, at)?;
        Ok(Text::word(format!("{}_TO_{name}({})", string(name).0, bits.text)))
    }

    /// Both sides of a comparison for equality as bits, where one side is made of them and the other one is a number: `(… AND 16#3) = 16#1`.
    pub(super) fn as_bits(
        &mut self,
        operator: Binary,
        [a, b]: [&Tree; 2],
        kind: &Kind,
        at: &At<'_>,
    ) -> Result<Option<[Text; 2]>, Refused> {
        let (Binary::Eq | Binary::Ne, Kind::Int(name)) = (operator, kind) else { return Ok(None) };
        let [left, right] = [a, b].map(|tree| folded(tree, name));
        let one = left.is_none() && operates(a) && right.is_some() || right.is_none() && operates(b) && left.is_some();
        if !one || self.steps.is_some() {
            return Ok(None);
        }
        Ok(Some([self.bits(a, name, at)?, self.bits(b, name, at)?]))
    }

    /// A number as bits.
    fn bits(&mut self, tree: &Tree, name: &'static str, at: &At<'_>) -> Result<Text, Refused> {
        let (string, bits, signed) = string(name);
        if let Some(number) = folded(tree, name) {
            return Ok(Text::word(format!("16#{:X}", number & mask(bits))));
        }
        let (word, strength) = match tree {
            Tree::Unary(Unary::Not, inner) => return Ok(not(self.bits(inner, name, at)?)),
            Tree::Binary(Binary::BitAnd, ..) => ("AND", strength::AND),
            Tree::Binary(Binary::BitOr, ..) => ("OR", strength::OR),
            Tree::Binary(Binary::BitXor, ..) => ("XOR", strength::XOR),
            Tree::Binary(Binary::Shr, ..) if signed => {
                let mend = "take an integer without a sign, or a function of the program";
                return Err(refuse(at, "`>>` of an integer with a sign, which keeps the sign,", mend));
            }
            Tree::Binary(Binary::Shl, ..) => ("SHL", strength::WORD),
            Tree::Binary(Binary::Shr, ..) => ("SHR", strength::WORD),
            other => {
                let number = self.tree(other, &Kind::Int(name), at)?;
                return Ok(Text::word(format!("{name}_TO_{string}({})", number.text)));
            }
        };
        let Tree::Binary(operator, a, b) = tree else {
            return Err(refuse(at, "this operator", "write it as arithmetic"));
        };
        if !matches!(operator, Binary::Shl | Binary::Shr) {
            let [left, right] = [self.bits(a, name, at)?, self.bits(b, name, at)?].map(|side| side.within(strength));
            return Ok(Text { text: format!("{left} {word} {right}"), strength });
        }
        // A literal alone does not say how many bits it has.
        let moved = match folded(a, name) {
            Some(number) => format!("{name}_TO_{string}({number})"),
            None => self.bits(a, name, at)?.text,
        };
        let places = self.kind(b).unwrap_or(Kind::Number);
        let places = self.tree(b, &places, at)?.text;
        Ok(Text::word(format!("{word}(IN := {moved}, N := {places})")))
    }
}

fn mask(bits: u32) -> i128 {
    (1 << bits) - 1
}

/// The number that is made of literals alone, as an integer of this type.
fn folded(tree: &Tree, name: &str) -> Option<i128> {
    let (_, bits, signed) = string(name);
    let number = match tree {
        Tree::Int(number) => *number,
        Tree::Unary(Unary::Neg, inner) => -folded(inner, name)?,
        Tree::Unary(Unary::Not, inner) => !folded(inner, name)?,
        Tree::Binary(operator, a, b) => {
            let (a, b) = (folded(a, name)?, folded(b, name)?);
            let places = u32::try_from(b).ok().filter(|places| *places < bits);
            match operator {
                Binary::BitAnd => a & b,
                Binary::BitOr => a | b,
                Binary::BitXor => a ^ b,
                Binary::Shl => a << places?,
                Binary::Shr => a >> places?,
                _ => return None,
            }
        }
        _ => return None,
    };
    let low = number & mask(bits);
    Some(if signed && low > mask(bits - 1) { low - mask(bits) - 1 } else { low })
}
