//! What a comparison of integers tells of another one: of `n < 4` and `n >= 4` exactly one holds.
//!
//! Of floats and the user's own types nothing is known: where `a < b` does not hold, `a >= b` need not.

use super::super::{Expr, User};
use super::uses::same;
use crate::analysis::integer;
use crate::model::{Binary, Model, Read, Tree, Unary};

/// Whether a comparison holds where another one has been found to hold, or not to.
pub(super) fn tells(model: &Model, (told, holds): (&User<'_>, bool), asked: &User<'_>) -> Option<bool> {
    let is_bound = |(read, value): &(Read, Expr<'_>)| told.binds.iter().any(|(one, a)| one == read && same(a, value));
    if !asked.binds.iter().all(is_bound) {
        return None;
    }
    let (told, asked) = (Comparison::of(model, told.tree)?, Comparison::of(model, asked.tree)?);
    if told.left != asked.left {
        return None;
    }
    let told = if holds { told } else { told.not() };
    match (literal(told.right), literal(asked.right)) {
        (Some(a), Some(b)) => decides(Values::of(told.operator, a)?, Values::of(asked.operator, b)?),
        _ if told.right == asked.right => orders(told.operator, asked.operator),
        _ => None,
    }
}

/// A comparison of integers, with a literal on its right if it has one.
struct Comparison<'t> {
    left: &'t Tree,
    operator: Binary,
    right: &'t Tree,
}

impl<'t> Comparison<'t> {
    fn of(model: &Model, tree: &'t Tree) -> Option<Self> {
        let Tree::Binary(operator, a, b) = tree else { return None };
        let is_one = matches!(operator, Binary::Lt | Binary::Le | Binary::Gt | Binary::Ge | Binary::Eq | Binary::Ne);
        integer(model, a).or_else(|| integer(model, b)).filter(|_| is_one)?;
        // Of two that are no literals the lesser one stands on the left.
        let turns = literal(a).is_some() || literal(b).is_none() && b < a;
        let (left, operator, right) = if turns { (b, operator.mirrored(), a) } else { (a, *operator, b) };
        Some(Self { left, operator, right })
    }

    fn not(self) -> Self {
        use Binary::{Eq, Ge, Gt, Le, Lt, Ne};
        let operator = match self.operator {
            Lt => Ge,
            Le => Gt,
            Gt => Le,
            Ge => Lt,
            Eq => Ne,
            _ => Eq,
        };
        Self { operator, ..self }
    }
}

fn literal(tree: &Tree) -> Option<i128> {
    match tree {
        Tree::Int(value) => Some(*value),
        Tree::Unary(Unary::Neg, inner) => literal(inner)?.checked_neg(),
        _ => None,
    }
}

/// The values that a comparison with a literal leaves.
#[derive(Clone, Copy)]
enum Values {
    Between(i128, i128),
    AllBut(i128),
}

impl Values {
    fn of(operator: Binary, than: i128) -> Option<Self> {
        let (lowest, highest) = (i128::MIN, i128::MAX);
        Some(match operator {
            Binary::Lt => Self::Between(lowest, than.checked_sub(1)?),
            Binary::Le => Self::Between(lowest, than),
            Binary::Gt => Self::Between(than.checked_add(1)?, highest),
            Binary::Ge => Self::Between(than, highest),
            Binary::Eq => Self::Between(than, than),
            _ => Self::AllBut(than),
        })
    }
}

/// Whether all or none of the values that are left are among those that are asked for.
fn decides(left: Values, asked: Values) -> Option<bool> {
    use Values::{AllBut, Between};
    let (all, none) = match (left, asked) {
        (Between(low, high), Between(least, most)) => (least <= low && high <= most, high < least || most < low),
        (Between(low, high), AllBut(value)) => (value < low || high < value, (low, high) == (value, value)),
        (AllBut(value), Between(least, most)) => (false, (least, most) == (value, value)),
        (AllBut(value), AllBut(other)) => (value == other, false),
    };
    (all || none).then_some(all)
}

/// The same of two operands of which nothing else is known.
fn orders(left: Binary, asked: Binary) -> Option<bool> {
    // Less, equal, greater.
    let set = |operator: Binary| match operator {
        Binary::Lt => 0b100,
        Binary::Le => 0b110,
        Binary::Gt => 0b001,
        Binary::Ge => 0b011,
        Binary::Eq => 0b010,
        _ => 0b101,
    };
    let (left, asked): (u8, u8) = (set(left), set(asked));
    let (all, none) = (left & !asked == 0, left & asked == 0);
    (all || none).then_some(all)
}
