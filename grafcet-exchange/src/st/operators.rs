//! Operators between two values.

use grafcet_compiler::model::{Binary, Tree};

use super::expr::{At, Kind, Scope, refuse};
use super::text::{Text, strength};
use super::{real, variants};
use crate::Refused;

impl Scope<'_> {
    pub(super) fn binary(
        &mut self,
        operator: Binary,
        [a, b]: [&Tree; 2],
        wanted: &Kind,
        at: &At<'_>,
    ) -> Result<Text, Refused> {
        let is = |one: &Option<Kind>, kind: &Kind| one.as_ref() == Some(kind);
        let (left, right) = (self.kind(a), self.kind(b));
        let logical = is(&left, &Kind::Bool) || is(&right, &Kind::Bool);
        let (word, strength, of_bool) = match operator {
            Binary::And | Binary::BitAnd => ("AND", strength::AND, true),
            Binary::Or | Binary::BitOr => ("OR", strength::OR, true),
            Binary::BitXor => ("XOR", strength::XOR, true),
            Binary::Eq => ("=", strength::EQUAL, false),
            Binary::Ne => ("<>", strength::EQUAL, false),
            Binary::Lt => ("<", strength::ORDER, false),
            Binary::Le => ("<=", strength::ORDER, false),
            Binary::Gt => (">", strength::ORDER, false),
            Binary::Ge => (">=", strength::ORDER, false),
            Binary::Add => ("+", strength::SUM, false),
            Binary::Sub => ("-", strength::SUM, false),
            Binary::Mul => ("*", strength::PRODUCT, false),
            Binary::Div => ("/", strength::PRODUCT, false),
            Binary::Rem => ("MOD", strength::PRODUCT, false),
            Binary::Shl | Binary::Shr => return Err(refuse(at, "a shift of truths", "shift a number")),
        };
        // Of `n != 0 && 10 / n > 2` a PLC computes both sides.
        if matches!(operator, Binary::Div | Binary::Rem) && !matches!(b, Tree::Int(1..)) && !real::is_above_zero(b) {
            let what = "a division by what may be zero";
            return Err(refuse(at, what, "divide by a number, or write a function of the program"));
        }
        let compares = strength == strength::EQUAL || strength == strength::ORDER;
        let lists = [a, b].map(|side| self.model.variants_of_tree(side));
        if matches!(lists, [Some(one), Some(other)] if !variants::same_list(one, other)) {
            return Err(refuse(at, "a comparison of two lists of variants", "let both list the same ones"));
        }
        let both = [&left, &right].into_iter().flatten().find(|kind| **kind != Kind::Number).cloned();
        if operator == Binary::Rem && matches!(both, Some(Kind::Real(_))) {
            return Err(refuse(at, "`%` on floats", "write it as a function of the program"));
        }
        if strength == strength::ORDER && logical {
            return Err(refuse(at, "the order of truths", "write it with `&&` and `!`"));
        }
        if !compares && !of_bool && is(&both, &Kind::Time) {
            return self.of_times(operator, [a, b], at);
        }
        let kind = match (of_bool, compares) {
            (true, _) => Kind::Bool,
            (_, true) => both.unwrap_or(Kind::Number),
            _ => both.unwrap_or_else(|| wanted.clone()),
        };
        // From left to right: the right side has to hold more strongly, and so has the left one of a comparison.
        let tight = strength + 1;
        let [left, right] = match self.as_bits(operator, [a, b], &kind, at)? {
            Some(sides) => sides,
            None => [self.tree(a, &kind, at)?, self.tree(b, &kind, at)?],
        };
        let left = left.within(if compares { tight } else { strength });
        let right = right.within(if of_bool { strength } else { tight });
        Ok(Text { text: format!("{left} {word} {right}"), strength })
    }
}
