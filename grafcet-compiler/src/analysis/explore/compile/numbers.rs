//! Comparisons of numbers and times: what is compared with constants is one atom, whose comparisons exclude each other.

use super::Compiler;
use crate::analysis::explore::formula::{Formula, Kind};
use crate::analysis::logic::{FAR, float, float_constant};
use crate::model::{Binary, Id, Name, Read, Tree, Ty, Unary};

const TICKS: (i128, i128) = (0, u32::MAX as i128);

impl Compiler<'_> {
    /// A comparison of a float with a literal: its position among all floats is the number. What is no number at all
    /// (NaN) lies beyond all of them, and only `!=` holds of it.
    pub(super) fn float_comparison(&mut self, operator: Binary, a: &Tree, b: &Tree) -> Option<Formula> {
        let float = float(self.model, a).or_else(|| float(self.model, b))?;
        let flipped = flipped(operator)?;
        let (value, operator, bound) = match (float_constant(a, float), float_constant(b, float)) {
            (None, Some(bound)) => (a, operator, bound),
            (Some(bound), None) => (b, flipped, bound),
            _ => return None,
        };
        self.approximate |= !matches!(value, Tree::Read(Read::Name(Name::Input(_) | Name::Param(_))));
        let atom = self.atom(value, Kind::Number(-FAR, FAR + 1));
        let below = |bound| Formula::Below(atom, bound);
        Some(match operator {
            Binary::Eq => Formula::Equals(atom, bound),
            Binary::Ne => Formula::Equals(atom, bound).negate(),
            Binary::Lt => below(bound),
            Binary::Le => below(bound + 1),
            Binary::Gt => below(bound + 1).negate().and(below(FAR + 1)),
            _ => below(bound).negate().and(below(FAR + 1)),
        })
    }

    /// A comparison of a number with a constant, or of two numbers, whose difference then is the number.
    pub(super) fn comparison(&mut self, operator: Binary, a: &Tree, b: &Tree) -> Option<Formula> {
        let flipped = flipped(operator)?;
        let (number, operator, bound) = match (constant(a), constant(b)) {
            (Some(a), Some(b)) => return Some(Formula::Const(compare(operator, a, b))),
            (None, Some(bound)) => (self.number(a)?, operator, bound),
            (Some(bound), None) => (self.number(b)?, flipped, bound),
            (None, None) => {
                if !self.is_number(a) || !self.is_number(b) {
                    return None;
                }
                self.approximate = true;
                let ((a, b), operator) = if a <= b { ((a, b), operator) } else { ((b, a), flipped) };
                let difference = Tree::Binary(Binary::Sub, Box::new(a.clone()), Box::new(b.clone()));
                (self.atom(&difference, Kind::Number(i128::MIN, i128::MAX)), operator, 0)
            }
        };
        let below = |bound| Formula::Below(number, bound);
        Some(match operator {
            Binary::Eq => Formula::Equals(number, bound),
            Binary::Ne => Formula::Equals(number, bound).negate(),
            Binary::Lt => below(bound),
            Binary::Le => below(bound.saturating_add(1)),
            Binary::Gt => below(bound.saturating_add(1)).negate(),
            _ => below(bound).negate(),
        })
    }

    /// The atom of a number.
    fn number(&mut self, tree: &Tree) -> Option<usize> {
        let kind = match tree {
            Tree::Read(Read::Since(step)) => Kind::Since(step.index()),
            Tree::Read(Read::MacroSince(id)) => Kind::MacroSince(id.index()),
            _ if !self.is_number(tree) => return None,
            _ => {
                let (low, high) = self.range(tree).unwrap_or((i128::MIN, i128::MAX));
                Kind::Number(low, high)
            }
        };
        self.approximate |= !matches!(tree, Tree::Read(Read::Name(Name::Input(_) | Name::Param(_))));
        Some(self.atom(tree, kind))
    }

    /// Whether the tree is an integer or a time, so that its comparisons with constants exclude each other.
    fn is_number(&self, tree: &Tree) -> bool {
        match tree {
            Tree::Int(_) => true,
            Tree::Read(_) => self.range(tree).is_some(),
            Tree::Unary(_, inner) => self.is_number(inner),
            Tree::Binary(Binary::Shl | Binary::Shr, a, _) => self.is_number(a),
            Tree::Binary(operator, a, b) => {
                let arithmetic = matches!(
                    operator,
                    Binary::Add
                        | Binary::Sub
                        | Binary::Mul
                        | Binary::Div
                        | Binary::Rem
                        | Binary::BitAnd
                        | Binary::BitOr
                        | Binary::BitXor
                );
                arithmetic && self.is_number(a) && self.is_number(b)
            }
            _ => false,
        }
    }

    /// The values that the type of a number has: in Rust, the operands of arithmetic have one type.
    fn range(&self, tree: &Tree) -> Option<(i128, i128)> {
        let ty = match tree {
            Tree::Read(Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)) => return Some(TICKS),
            Tree::Read(Read::Name(name)) => self.ty(*name),
            Tree::Unary(_, inner) => return self.range(inner),
            Tree::Binary(_, a, b) => return self.range(a).or_else(|| self.range(b)),
            _ => return None,
        };
        match ty {
            Ty::Int { signed: false, bits, .. } if *bits < 127 => Some((0, (1 << bits) - 1)),
            Ty::Int { signed: false, .. } => Some((0, i128::MAX)),
            Ty::Int { signed: true, bits, .. } if *bits < 128 => Some((-(1 << (bits - 1)), (1 << (bits - 1)) - 1)),
            Ty::Int { .. } => Some((i128::MIN, i128::MAX)),
            Ty::Time(_) => Some(TICKS),
            Ty::Bool(_) | Ty::Other(_) => None,
        }
    }
}

/// `a < b` is `b > a`; none where it is no comparison.
fn flipped(operator: Binary) -> Option<Binary> {
    Some(match operator {
        Binary::Eq | Binary::Ne => operator,
        Binary::Lt => Binary::Gt,
        Binary::Le => Binary::Ge,
        Binary::Gt => Binary::Lt,
        Binary::Ge => Binary::Le,
        _ => return None,
    })
}

fn constant(tree: &Tree) -> Option<i128> {
    match tree {
        Tree::Int(value) => Some(*value),
        Tree::Read(Read::Ticks(ticks)) => Some(i128::from(*ticks)),
        Tree::Unary(Unary::Neg, inner) => constant(inner)?.checked_neg(),
        Tree::Binary(Binary::Add, a, b) => constant(a)?.checked_add(constant(b)?),
        Tree::Binary(Binary::Sub, a, b) => constant(a)?.checked_sub(constant(b)?),
        Tree::Binary(Binary::Mul, a, b) => constant(a)?.checked_mul(constant(b)?),
        _ => None,
    }
}

fn compare(operator: Binary, a: i128, b: i128) -> bool {
    match operator {
        Binary::Eq => a == b,
        Binary::Ne => a != b,
        Binary::Lt => a < b,
        Binary::Le => a <= b,
        Binary::Gt => a > b,
        _ => a >= b,
    }
}
