//! Comparisons of numbers and times: what is compared with constants is one atom, whose comparisons exclude each other.

use super::Compiler;
use crate::analysis::differences::FAR;
use crate::analysis::explore::net::formula::{AtomId, Formula, Kind};
use crate::analysis::explore::net::links::{Difference, Operand};
use crate::analysis::numbers::{Sort, common, constant, domain, float_constant, is_arithmetic, range};
use crate::model::{Binary, Name, Read, Tree};

/// The position of the infinite among all floats.
const INFINITE: i128 = 0x7FF0_0000_0000_0000;

impl Compiler<'_> {
    /// A comparison of a float with a literal or with another: its position among all floats is the number. What is no
    /// number at all (NaN) lies beyond all of them, and only `!=` holds of it.
    pub(super) fn float_comparison(&mut self, operator: Binary, a: &Tree, b: &Tree) -> Option<Formula> {
        let Some(Sort::Float(float)) = common(self.model, a, b) else { return None };
        let flipped = operator.is_comparison().then(|| operator.mirrored())?;
        let (atom, operator, bound) = match (float_constant(a, float), float_constant(b, float)) {
            (None, Some(bound)) => (self.float(a), operator, bound),
            (Some(bound), None) => (self.float(b), flipped, bound),
            (None, None) => {
                let ((a, b), operator) = if a <= b { ((a, b), operator) } else { ((b, a), flipped) };
                (self.difference(a, b, true), operator, 0)
            }
            (Some(a), Some(b)) => return Some(Formula::Const(compare(operator, a, b))),
        };
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

    /// The atom of a float.
    fn float(&mut self, tree: &Tree) -> AtomId {
        self.approximate |= !matches!(tree, Tree::Read(Read::Name(Name::Input(_) | Name::Param(_))));
        self.atom(tree, Kind::Number(-FAR, FAR + 1))
    }

    /// A comparison of a number with a constant, or of two numbers, of which it matters how far one lies above the other.
    pub(super) fn comparison(&mut self, operator: Binary, a: &Tree, b: &Tree) -> Option<Formula> {
        let flipped = operator.is_comparison().then(|| operator.mirrored())?;
        let (number, operator, bound) = match (constant(a), constant(b)) {
            (Some(a), Some(b)) => return Some(Formula::Const(compare(operator, a, b))),
            (None, Some(bound)) => (self.number(a)?, operator, bound),
            (Some(bound), None) => (self.number(b)?, flipped, bound),
            (None, None) => {
                if !self.is_number(a) || !self.is_number(b) {
                    return None;
                }
                if a == b {
                    return Some(Formula::Const(compare(operator, 0, 0)));
                }
                let ((a, b), operator) = if a <= b { ((a, b), operator) } else { ((b, a), flipped) };
                (self.difference(a, b, false), operator, 0)
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
    fn number(&mut self, tree: &Tree) -> Option<AtomId> {
        let kind = match tree {
            Tree::Read(Read::Since(step)) => Kind::Since(*step),
            Tree::Read(Read::MacroSince(id)) => Kind::MacroSince(*id),
            _ if !self.is_number(tree) && self.model.variants_of_tree(tree).is_none() => return None,
            _ => {
                let (low, high) = domain(self.model, tree).unwrap_or((i128::MIN, i128::MAX));
                Kind::Number(low, high)
            }
        };
        self.approximate |= !matches!(tree, Tree::Read(Read::Name(Name::Input(_) | Name::Param(_))));
        Some(self.atom(tree, kind))
    }

    /// Whether the tree is an integer or a time, so that its comparisons with constants exclude each other.
    fn is_number(&self, tree: &Tree) -> bool {
        match tree {
            Tree::Int(_) | Tree::Opaque { whole: true, .. } => true,
            Tree::Read(_) => range(self.model, tree).is_some(),
            Tree::Unary(_, inner) => self.is_number(inner),
            Tree::Binary(Binary::Shl | Binary::Shr, a, _) => self.is_number(a),
            Tree::Binary(operator, a, b) => is_arithmetic(*operator) && self.is_number(a) && self.is_number(b),
            _ => false,
        }
    }

    /// How far one number lies above another. What a time is compared with is compared with zero where the time is.
    fn difference(&mut self, a: &Tree, b: &Tree, is_float: bool) -> AtomId {
        let pair = (a.clone(), b.clone());
        if let Some(known) = self.differences_of.get(&pair) {
            return *known;
        }
        let is_time = |tree: &Tree| matches!(tree, Tree::Read(Read::Since(_) | Read::MacroSince(_)));
        if is_time(a) || is_time(b) {
            self.approximate = true;
            for tree in [a, b] {
                self.number(tree);
            }
        }
        let is_plain = |tree: &Tree| matches!(tree, Tree::Read(Read::Name(Name::Input(_) | Name::Param(_))));
        self.approximate |= !is_plain(a) || !is_plain(b);
        let what = Tree::Binary(Binary::Lt, Box::new(a.clone()), Box::new(b.clone()));
        let limits = if is_float { (-FAR, FAR + 1) } else { (i128::MIN, i128::MAX) };
        let atom = self.atom(&what, Kind::Number(limits.0, limits.1));
        let operand = |tree: &Tree| {
            // No float lies beyond what is infinite; one that is none is told apart.
            let limits = if is_float { (-INFINITE, INFINITE) } else { limits };
            Operand { tree: tree.clone(), range: range(self.model, tree).unwrap_or(limits) }
        };
        let difference = Difference { atom, a: operand(a), b: operand(b), is_float };
        self.differences.push(difference);
        self.differences_of.insert(pair, atom);
        atom
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
