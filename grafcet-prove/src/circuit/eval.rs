//! Expressions of the program.

use grafcet_compiler::model::Id;
use grafcet_compiler::program::{Comparison, Expr, PlaceId, Role};

use super::sym::{Sym, code};
use super::{Env, Lowering, Refused};
use crate::aig::Lit;
use crate::bits::{self, Bits};

impl<'m> Lowering<'_, 'm> {
    pub(super) fn holds(&mut self, expr: &Expr<'m>, env: &Env) -> Result<Lit, Refused> {
        match expr {
            Expr::Is(place, steps) => {
                let Sym::State(state) = env[place.0].clone() else { return Err(Refused("a state".to_owned())) };
                let mut any = Lit::FALSE;
                for step in steps {
                    let code = bits::constant(code(self.program, *step)?);
                    let is = bits::equal(&mut self.aig, &state, &code);
                    any = self.aig.or(any, is);
                }
                Ok(any)
            }
            Expr::Not(inner) => Ok(!self.holds(inner, env)?),
            Expr::All(parts) => self.lazily(parts, env, true),
            Expr::Any(parts) => self.lazily(parts, env, false),
            Expr::Compare(comparison, a, b) => {
                let (a, b) = (self.eval(a, env)?, self.eval(b, env)?);
                Ok(match comparison {
                    Comparison::Equal => self.equal(&a, &b)?,
                    Comparison::Differs => !self.equal(&a, &b)?,
                    Comparison::Less => self.less(&a, &b)?,
                    Comparison::AtLeast => !self.less(&a, &b)?,
                })
            }
            other => {
                let sym = self.eval(other, env)?;
                self.bool(&sym)
            }
        }
    }

    /// In this order, and no further than needed.
    fn lazily(&mut self, parts: &[Expr<'m>], env: &Env, all: bool) -> Result<Lit, Refused> {
        let path = self.path;
        let mut so_far = Lit::constant(all);
        for part in parts {
            if so_far == Lit::constant(!all) {
                break;
            }
            self.path = self.aig.and(path, so_far.xor(!all));
            let part = self.holds(part, env)?;
            so_far = if all { self.aig.and(so_far, part) } else { self.aig.or(so_far, part) };
        }
        self.path = path;
        Ok(so_far)
    }

    pub(super) fn equal(&mut self, a: &Sym, b: &Sym) -> Result<Lit, Refused> {
        Ok(match (a, b) {
            (Sym::Bool(a), Sym::Bool(b)) => self.aig.iff(*a, *b),
            (Sym::Int(a, _), Sym::Int(b, _)) | (Sym::Ticks(a), Sym::Ticks(b)) | (Sym::State(a), Sym::State(b)) => {
                bits::equal(&mut self.aig, a, b)
            }
            (Sym::Free(_), Sym::Free(_)) if a == b => Lit::TRUE,
            (Sym::Free(_), _) | (_, Sym::Free(_)) => {
                let made = self.made("=", vec![a.clone(), b.clone()]);
                self.bool(&made)?
            }
            _ => return Err(Refused("a comparison of different things".to_owned())),
        })
    }

    fn less(&mut self, a: &Sym, b: &Sym) -> Result<Lit, Refused> {
        match (a, b) {
            (Sym::Int(a, _), Sym::Int(b, _)) | (Sym::Ticks(a), Sym::Ticks(b)) => Ok(bits::less(&mut self.aig, a, b)),
            _ => Err(Refused("an order of other things than numbers and times".to_owned())),
        }
    }

    pub(super) fn eval(&mut self, expr: &Expr<'m>, env: &Env) -> Result<Sym, Refused> {
        Ok(match expr {
            Expr::Value(value) => self.value(*value)?,
            Expr::Place(place) => self.stored(*place, env)?,
            Expr::Initial(place) => self.initial[place.0].clone(),
            Expr::Input(id) => self.given[id.index()].clone(),
            Expr::Now => return Err(Refused("the reading of the clock".to_owned())),
            Expr::Table(..) => return Err(Refused("a table, which no naive program has".to_owned())),
            Expr::Is(..) | Expr::Not(_) | Expr::All(_) | Expr::Any(_) | Expr::Compare(..) => {
                Sym::Bool(self.holds(expr, env)?)
            }
            Expr::Choose(parts) => {
                let [condition, then, otherwise] = &**parts;
                let condition = self.holds(condition, env)?;
                let path = self.path;
                self.path = self.aig.and(path, condition);
                let then = self.eval(then, env)?;
                self.path = self.aig.and(path, !condition);
                let otherwise = self.eval(otherwise, env)?;
                self.path = path;
                self.mux(condition, &then, &otherwise)?
            }
            Expr::Next(place) => match &env[place.0] {
                Sym::Int(bits, width) => {
                    let (bits, width) = (bits.clone(), *width);
                    Sym::Int(bits::add(&mut self.aig, &bits, &bits::constant(1)), width)
                }
                _ => return Err(Refused("a count that is no number".to_owned())),
            },
            Expr::Add(a, b) => {
                let (a, b) = self.times(a, b, env)?;
                Sym::Ticks(self.add_times(&a, &b))
            }
            Expr::Sub(a, b) => {
                let (a, b) = self.times(a, b, env)?;
                Sym::Ticks(self.sub_times(&a, &b))
            }
            Expr::Since(now, then) => match (&**now, &**then) {
                (Expr::Now, Expr::Place(place)) if self.program.places[place.0].role == Role::Reading => {
                    Sym::Ticks(self.elapsed.clone())
                }
                _ => return Err(Refused("a difference of two readings of the clock".to_owned())),
            },
            Expr::Period(reached, passed, period) => {
                let (reached, passed) = self.times(reached, passed, env)?;
                let sum = bits::add(&mut self.aig, &reached, &passed);
                if *period == 0 {
                    self.ticks(0)
                } else {
                    Sym::Ticks(bits::div_rem(&mut self.aig, &sum, &bits::constant(i128::from(*period))).1)
                }
            }
            Expr::User(user) => {
                let mut reads = Vec::new();
                for (read, bound) in &user.binds {
                    reads.push((*read, self.eval(bound, env)?));
                }
                self.tree(user.tree, &reads)?
            }
        })
    }

    fn stored(&mut self, place: PlaceId, env: &Env) -> Result<Sym, Refused> {
        if self.program.places[place.0].role == Role::Reading {
            return Err(Refused("the reading of the clock".to_owned()));
        }
        Ok(env[place.0].clone())
    }

    fn times(&mut self, a: &Expr<'m>, b: &Expr<'m>, env: &Env) -> Result<(Bits, Bits), Refused> {
        let (a, b) = (self.eval(a, env)?, self.eval(b, env)?);
        Ok((self.time(&a)?, self.time(&b)?))
    }

    /// It saturates.
    pub(super) fn add_times(&mut self, a: &Bits, b: &Bits) -> Bits {
        let sum = bits::add(&mut self.aig, a, b);
        let fits = bits::fits(&mut self.aig, &sum, false, self.clock.width);
        let most = bits::constant((1 << self.clock.width) - 1);
        let kept = bits::wrap(&sum, false, self.clock.width);
        bits::mux(&mut self.aig, fits, &kept, &most)
    }

    pub(super) fn sub_times(&mut self, a: &Bits, b: &Bits) -> Bits {
        let less = bits::sub(&mut self.aig, a, b);
        let negative = bits::sign(&less);
        let kept = bits::wrap(&less, false, self.clock.width);
        bits::mux(&mut self.aig, negative, &bits::constant(0), &kept)
    }
}
