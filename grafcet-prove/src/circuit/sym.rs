//! Values as wires.

use grafcet_compiler::model::{Id, StepId, Ty, Variants};
use grafcet_compiler::program::{PlaceId, Program, Type, Value};

use super::free::{As, Origin};
use super::{Lowering, Refused};
use crate::aig::Lit;
use crate::bits::{self, Bits};

/// The range of an integer type.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Width {
    pub(super) signed: bool,
    pub(super) bits: usize,
}

/// A value of which nobody knows more than where it came from.
pub(super) type FreeId = usize;

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Sym {
    Bool(Lit),
    /// A literal has no type of its own.
    Int(Bits, Option<Width>),
    /// Without a sign.
    Ticks(Bits),
    /// The number of the step in its region, from one on; zero for none.
    State(Bits),
    /// How an action is called, which nothing depends on.
    Phase,
    /// Rust that is not looked into.
    Free(FreeId),
}

impl Width {
    pub(super) fn of(ty: &Ty) -> Result<Option<Self>, Refused> {
        match ty {
            Ty::Int { signed, bits, rust } => {
                if *bits > 64 {
                    return Err(Refused("integers of 128 bits".to_owned()));
                }
                if grafcet_compiler::model::Integer::of(rust).is_some_and(|integer| integer.is_size) {
                    return Err(Refused("`usize` and `isize`, whose limits are those of the machine".to_owned()));
                }
                Ok(Some(Self { signed: *signed, bits: *bits as usize }))
            }
            _ => Ok(None),
        }
    }
}

impl Sym {
    pub(super) fn bool(value: bool) -> Self {
        Self::Bool(Lit::constant(value))
    }

    pub(super) fn int(value: i128) -> Self {
        Self::Int(bits::constant(value), None)
    }
}

/// The number of a step in its region.
pub(super) fn code(program: &Program<'_>, step: StepId) -> Result<i128, Refused> {
    let place = program.regions.iter().find_map(|steps| steps.iter().position(|other| *other == step));
    match place {
        Some(place) => Ok(i128::try_from(place).unwrap_or(0) + 1),
        None => Err(Refused(format!("step {} has no region", step.index()))),
    }
}

impl<'m> Lowering<'_, 'm> {
    pub(super) fn value(&self, value: Value) -> Result<Sym, Refused> {
        Ok(match value {
            Value::Bool(value) => Sym::bool(value),
            Value::Int(value) => Sym::int(value),
            Value::Ticks(ticks) => self.ticks(ticks),
            Value::Step(None) => Sym::State(bits::constant(0)),
            Value::Step(Some(step)) => Sym::State(bits::constant(code(self.program, step)?)),
            Value::Phase(_) => Sym::Phase,
            Value::Start(_) | Value::Other(_) => return Err(Refused("a value that only the program knows".to_owned())),
        })
    }

    /// A time; at least the longest that anything compares with, where it is longer.
    pub(super) fn ticks(&self, ticks: u32) -> Sym {
        let most = (1_i128 << self.clock.width) - 1;
        Sym::Ticks(bits::constant(i128::from(ticks).min(most)))
    }

    pub(super) fn mux(&mut self, condition: Lit, then: &Sym, otherwise: &Sym) -> Result<Sym, Refused> {
        if then == otherwise {
            return Ok(then.clone());
        }
        match condition.known() {
            Some(true) => return Ok(then.clone()),
            Some(false) => return Ok(otherwise.clone()),
            None => {}
        }
        Ok(match (then, otherwise) {
            (Sym::Bool(a), Sym::Bool(b)) => Sym::Bool(self.aig.mux(condition, *a, *b)),
            (Sym::Int(a, left), Sym::Int(b, right)) => {
                Sym::Int(bits::mux(&mut self.aig, condition, a, b), left.or(*right))
            }
            (Sym::Ticks(a), Sym::Ticks(b)) => Sym::Ticks(bits::mux(&mut self.aig, condition, a, b)),
            (Sym::State(a), Sym::State(b)) => Sym::State(bits::mux(&mut self.aig, condition, a, b)),
            (Sym::Free(id), Sym::Bool(b)) => {
                let a = self.free_bool(*id)?;
                Sym::Bool(self.aig.mux(condition, a, *b))
            }
            (Sym::Bool(_), Sym::Free(_)) => self.mux(!condition, otherwise, then)?,
            (Sym::Free(_), _) | (_, Sym::Free(_)) => {
                let choice = Origin::Choice(condition, then.clone(), otherwise.clone());
                Sym::Free(self.free(choice, Vec::new(), true))
            }
            _ => return Err(Refused("values that do not belong together".to_owned())),
        })
    }

    pub(super) fn bool(&mut self, sym: &Sym) -> Result<Lit, Refused> {
        match sym {
            Sym::Bool(lit) => Ok(*lit),
            Sym::Free(id) => self.free_bool(*id),
            _ => Err(Refused("a condition that is no boolean".to_owned())),
        }
    }

    pub(super) fn time(&mut self, sym: &Sym) -> Result<Bits, Refused> {
        match sym {
            Sym::Ticks(bits) => Ok(bits.clone()),
            Sym::Free(id) => self.free_bits(*id, self.clock.width, As::Time),
            _ => Err(Refused("a time that is none".to_owned())),
        }
    }

    /// What a place takes of a value. An integer that does not fit goes on at the other end, and is noted.
    pub(super) fn placed(&mut self, sym: Sym, ty: Type<'m>) -> Result<Sym, Refused> {
        match (ty, sym) {
            (Type::Bool | Type::User(Ty::Bool(_)), sym) => Ok(Sym::Bool(self.bool(&sym)?)),
            (Type::Ticks | Type::User(Ty::Time(_)), sym) => Ok(Sym::Ticks(self.time(&sym)?)),
            (Type::User(ty @ Ty::Int { .. }), sym) => {
                let Some(width) = Width::of(ty)? else { return Err(Refused("an integer".to_owned())) };
                match sym {
                    Sym::Int(bits, _) => Ok(self.fitted(&bits, Some(width))),
                    Sym::Free(id) => self.free_number(id, width),
                    _ => Err(Refused("an integer that is none".to_owned())),
                }
            }
            (Type::State(_), sym @ Sym::State(_))
            | (Type::Number | Type::Kind { .. }, sym @ Sym::Int(..))
            | (Type::User(_), sym) => Ok(sym),
            _ => Err(Refused("a value of another type".to_owned())),
        }
    }

    /// An integer of a type of which nobody knows more.
    pub(super) fn free_number(&mut self, id: FreeId, width: Width) -> Result<Sym, Refused> {
        Ok(Sym::Int(self.free_bits(id, width.bits, As::Number { signed: width.signed })?, Some(width)))
    }

    /// What a place keeps of a value: of an enum whose variants the chart lists, the variant's place in the list.
    pub(super) fn kept(&mut self, sym: Sym, place: PlaceId) -> Result<Sym, Refused> {
        match self.variants(place) {
            Some(variants) => self.variant(sym, variants),
            None => self.placed(sym, self.program.places[place.0].ty),
        }
    }

    /// The place of a variant in its list.
    fn variant(&mut self, sym: Sym, variants: &Variants) -> Result<Sym, Refused> {
        match sym {
            Sym::Int(..) => Ok(sym),
            Sym::Free(id) => self.free_variant(id, variants),
            _ => Err(Refused("a variant that is none".to_owned())),
        }
    }

    /// The same of Rust: the path of a variant, one of two, or any.
    fn free_variant(&mut self, id: FreeId, variants: &Variants) -> Result<Sym, Refused> {
        match &self.origins[id] {
            Origin::Choice(condition, then, otherwise) => {
                let (condition, then, otherwise) = (*condition, then.clone(), otherwise.clone());
                let (then, otherwise) = (self.variant(then, variants)?, self.variant(otherwise, variants)?);
                return self.mux(condition, &then, &otherwise);
            }
            Origin::Text(text, _) | Origin::Constant(text) | Origin::Made(text) => {
                if let Some(place) = variants.place_of(text) {
                    return Ok(Sym::int(i128::try_from(place).unwrap_or(0)));
                }
            }
        }
        let count = variants.list.len();
        let bits = self.free_bits(id, bits::width(count - 1), As::Number { signed: false })?;
        let is_one = bits::less(&mut self.aig, &bits, &bits::constant(i128::try_from(count).unwrap_or(0)));
        self.constraint = self.aig.and(self.constraint, is_one);
        Ok(Sym::Int(bits, None))
    }

    /// An integer in its type.
    pub(super) fn fitted(&mut self, exact: &Bits, width: Option<Width>) -> Sym {
        let Some(width) = width else { return Sym::Int(exact.clone(), None) };
        let fits = bits::fits(&mut self.aig, exact, width.signed, width.bits);
        self.note_overflow(!fits);
        Sym::Int(bits::wrap(exact, width.signed, width.bits), Some(width))
    }

    /// Rust would panic in a debug build.
    pub(super) fn note_overflow(&mut self, when: Lit) {
        let here = self.aig.and(self.path, when);
        self.overflow = self.aig.or(self.overflow, here);
    }

    /// Rust panics in every build: there is no such cycle.
    pub(super) fn note_panic(&mut self, when: Lit) {
        let here = self.aig.and(self.path, when);
        self.panics = self.aig.or(self.panics, here);
    }
}
