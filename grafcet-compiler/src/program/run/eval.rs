//! Expressions on values: those of the program, and the user's over their trees.

use super::value::Term;
use super::{Error, Running};
use crate::model::{Binary, Id, Read, Tree, Ty};
use crate::program::{Comparison, Expr, PlaceId, Type, User, Value};

impl<'m> Running<'_, 'm> {
    /// Whether a condition holds.
    pub(super) fn holds(&mut self, expr: &Expr<'m>) -> Result<bool, Error> {
        match expr {
            Expr::Place(place) => match self.values[place.0] {
                Value::Bool(value) => Ok(value),
                other => Err(Error::Type(format!("{other:?} for a boolean"))),
            },
            Expr::Is(place, steps) => {
                Ok(matches!(self.values[place.0], Value::Step(Some(step)) if steps.contains(&step)))
            }
            Expr::Not(inner) => Ok(!self.holds(inner)?),
            Expr::All(parts) => {
                for part in parts {
                    if !self.holds(part)? {
                        return Ok(false);
                    }
                }
                Ok(true)
            }
            Expr::Any(parts) => {
                for part in parts {
                    if self.holds(part)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
            Expr::Compare(comparison, a, b) => {
                let (a, b) = (self.eval(a)?.plain(), self.eval(b)?.plain());
                Ok(match comparison {
                    Comparison::Equal => a == b,
                    Comparison::Differs => a != b,
                    Comparison::Less => a < b,
                    Comparison::AtLeast => a >= b,
                })
            }
            other => self.eval(other)?.bool(),
        }
    }

    pub(super) fn ticks(&mut self, expr: &Expr<'m>) -> Result<u32, Error> {
        self.eval(expr)?.ticks()
    }

    fn stored(&self, place: PlaceId) -> Term {
        Term::of(self.values[place.0], width(self.program.places[place.0].ty))
    }

    pub(super) fn eval(&mut self, expr: &Expr<'m>) -> Result<Term, Error> {
        let time = |ticks| Ok(Term::Value(Value::Ticks(ticks)));
        match expr {
            Expr::Value(value) => Ok(Term::of(*value, None)),
            Expr::Place(place) => Ok(self.stored(*place)),
            Expr::Initial(place) => Ok(Term::of(self.initial[place.0], None)),
            Expr::Input(id) => {
                let ty = &self.program.model.inputs[*id].ty;
                let value = self.inputs.get(id.index()).copied().ok_or(Error::NotUnderstood("an input".to_owned()))?;
                Ok(Term::of(value, Some(ty)))
            }
            Expr::Now => time(self.now),
            Expr::Is(..) | Expr::Not(_) | Expr::All(_) | Expr::Any(_) | Expr::Compare(..) => {
                Ok(Term::Value(Value::Bool(self.holds(expr)?)))
            }
            Expr::Choose(parts) => {
                let [condition, then, otherwise] = &**parts;
                if self.holds(condition)? { self.eval(then) } else { self.eval(otherwise) }
            }
            Expr::Table(place, table) => {
                let state = self.values[place.0];
                let found = table.iter().find(|(from, _)| *from == state).map_or(state, |(_, to)| *to);
                Ok(Term::of(found, None))
            }
            Expr::Next(place) => match self.values[place.0] {
                Value::Int(number) => Ok(Term::of(Value::Int(number.saturating_add(1)), None)),
                other => Err(Error::Type(format!("{other:?} for a number"))),
            },
            Expr::Add(a, b) => time(self.ticks(a)?.saturating_add(self.ticks(b)?)),
            Expr::Sub(a, b) => time(self.ticks(a)?.saturating_sub(self.ticks(b)?)),
            Expr::Since(a, b) => time(self.ticks(a)?.wrapping_sub(self.ticks(b)?)),
            Expr::Period(reached, passed, period) => {
                let sum = u64::from(self.ticks(reached)?) + u64::from(self.ticks(passed)?);
                let rest = sum.checked_rem(u64::from(*period)).unwrap_or(0);
                time(u32::try_from(rest).unwrap_or(0))
            }
            Expr::User(user) => {
                let User { tree, binds, .. } = &**user;
                self.tree(tree, binds)
            }
        }
    }

    /// The user's own operators.
    pub(super) fn tree(&mut self, tree: &Tree, binds: &[(Read, Expr<'m>)]) -> Result<Term, Error> {
        match tree {
            Tree::Bool(value) => Ok(Term::Value(Value::Bool(*value))),
            Tree::Int(value) => Ok(Term::of(Value::Int(*value), None)),
            Tree::Read(read) => self.bound(*read, binds),
            Tree::Elapsed(time, step) => self.bound(Read::Elapsed(*time, *step), binds),
            Tree::MacroElapsed(time, id) => self.bound(Read::MacroElapsed(*time, *id), binds),
            Tree::Unary(operator, operand) => self.tree(operand, binds)?.unary(*operator),
            Tree::Binary(Binary::And, a, b) => {
                let holds = self.tree(a, binds)?.bool()? && self.tree(b, binds)?.bool()?;
                Ok(Term::Value(Value::Bool(holds)))
            }
            Tree::Binary(Binary::Or, a, b) => {
                let holds = self.tree(a, binds)?.bool()? || self.tree(b, binds)?.bool()?;
                Ok(Term::Value(Value::Bool(holds)))
            }
            Tree::Binary(operator, a, b) => self.tree(a, binds)?.binary(*operator, self.tree(b, binds)?),
            Tree::Opaque { text, reads, .. } => {
                let reads = self.read_all(binds, Some(reads))?;
                Ok(Term::of(self.foreign.value(text, &reads)?, None))
            }
        }
    }

    fn bound(&mut self, read: Read, binds: &[(Read, Expr<'m>)]) -> Result<Term, Error> {
        match binds.iter().find(|(other, _)| *other == read) {
            Some((_, value)) => self.eval(value),
            None => Err(Error::NotUnderstood(format!("{read:?}"))),
        }
    }

    /// The values of all that is bound, or of what is wanted.
    pub(super) fn read_all(
        &mut self,
        binds: &[(Read, Expr<'m>)],
        wanted: Option<&[Read]>,
    ) -> Result<Vec<(Read, Value)>, Error> {
        let mut values = Vec::new();
        for (read, value) in binds {
            if wanted.is_none_or(|wanted| wanted.contains(read)) {
                values.push((*read, self.eval(value)?.plain()));
            }
        }
        Ok(values)
    }
}

/// The declared type of a place, where its integers have one.
fn width(ty: Type<'_>) -> Option<&Ty> {
    match ty {
        Type::User(ty) => Some(ty),
        _ => None,
    }
}
