//! What a chart is given, and what its places begin with.

use grafcet_compiler::model::{Expr as Written, Name, ParamId, Read, Ty, Variants};
use grafcet_compiler::program::{Initial, PlaceId, Program, Type, Value};

use super::free::Origin;
use super::sym::{Sym, Width};
use super::{Lowering, Refused, Source, Wire};
use crate::aig::Lit;
use crate::bits::{self, Bits};

/// An enum that is listed in two orders. In the circuit a variant is its place, which has to be the same in all lists that it may be copied between.
pub(super) fn in_two_orders(program: &Program<'_>) -> Option<String> {
    let models = std::iter::once(program.model).chain(program.plants.iter().map(|plant| plant.model));
    let lists: Vec<&Variants> = models.flat_map(|model| &model.variants).collect();
    let ty = |list: &Variants| list.path.segments.last().map(|segment| segment.ident.to_string());
    let differs = |a: &Variants, b: &Variants| a.list.iter().zip(&b.list).any(|(a, b)| a.name != b.name);
    let twice = |(at, list): (usize, &&Variants)| {
        let differs = |other: &&Variants| ty(other) == ty(list) && differs(other, list);
        if lists[..at].iter().any(differs) { ty(list) } else { None }
    };
    lists.iter().enumerate().find_map(twice)
}

impl Lowering<'_, '_> {
    /// What the chart is given in this cycle.
    pub(super) fn given(&mut self) -> Result<(), Refused> {
        for (id, input) in self.program.model.inputs.iter() {
            let sym = match self.of_plants(id) {
                Some(sym) => sym,
                None => self.declared(&input.ty, Name::Input(id), Source::Input(id), &input.name.to_string())?,
            };
            self.given.push(sym);
        }
        if self.has_time() {
            let bits: Vec<Lit> = (0..self.clock.width).map(|_| self.aig.free()).collect();
            self.inputs.push(Wire { source: Source::Elapsed, bits: bits.clone() });
            let bits = self.as_given("elapsed", bits);
            self.elapsed = bits::unsigned(&bits);
        }
        Ok(())
    }

    pub(super) fn param(&mut self, id: ParamId) -> Result<Sym, Refused> {
        let param = &self.program.model.params[id];
        self.declared(&param.ty, Name::Param(id), Source::Param(id), &param.name.to_string())
    }

    pub(super) fn declared(&mut self, ty: &Ty, name: Name, source: Source, text: &str) -> Result<Sym, Refused> {
        let (width, signed) = match ty {
            Ty::Bool(_) => (1, false),
            Ty::Time(_) => (self.clock.width, false),
            Ty::Int { .. } => match Width::of(ty)? {
                Some(width) => (width.bits, width.signed),
                None => return Err(Refused(text.to_owned())),
            },
            Ty::Other(_) => match self.program.model.variants_of(name) {
                Some(variants) => (bits::width(variants.list.len() - 1), false),
                None => return Ok(Sym::Free(self.free(Origin::Made(text.to_owned()), Vec::new(), true))),
            },
        };
        let bits: Vec<Lit> = (0..width).map(|_| self.aig.free()).collect();
        self.inputs.push(Wire { source, bits: bits.clone() });
        let bits = self.as_given(text, bits);
        let number: Bits = if signed { bits.clone().into() } else { bits::unsigned(&bits) };
        Ok(match ty {
            Ty::Bool(_) => Sym::Bool(bits[0]),
            Ty::Time(_) => Sym::Ticks(number),
            Ty::Int { .. } => Sym::Int(number, Width::of(ty)?),
            Ty::Other(_) => {
                let count = self.program.model.variants_of(name).map_or(0, |variants| variants.list.len());
                let most = bits::constant(i128::try_from(count).unwrap_or(0));
                let is_one = bits::less(&mut self.aig, &number, &most);
                self.constraint = self.aig.and(self.constraint, is_one);
                Sym::Int(number, None)
            }
        })
    }

    /// What the places begin with.
    pub(super) fn initials(&mut self) -> Result<(), Refused> {
        for (index, place) in self.program.places.iter().enumerate() {
            let sym = match place.initial {
                Initial::Value(value) => self.value(value)?,
                Initial::Constant(expr) => {
                    let sym = self.constant(expr)?;
                    self.kept(sym, PlaceId(index))?
                }
                Initial::Default => match place.ty {
                    Type::Bool | Type::User(Ty::Bool(_)) => Sym::bool(false),
                    Type::Ticks | Type::User(Ty::Time(_)) => self.ticks(0),
                    Type::State(_) => self.value(Value::Step(None))?,
                    Type::Number | Type::Kind { .. } => Sym::int(0),
                    Type::User(ty @ Ty::Int { .. }) => Sym::Int(bits::constant(0), Width::of(ty)?),
                    // Which variant it is, the type says.
                    Type::User(Ty::Other(_)) => {
                        Sym::Free(self.free(Origin::Made(place.name.clone()), Vec::new(), false))
                    }
                },
            };
            self.initial.push(sym);
        }
        Ok(())
    }

    fn constant(&mut self, expr: &Written) -> Result<Sym, Refused> {
        let mut reads = Vec::new();
        for read in &expr.reads {
            if let Read::Ticks(ticks) = read {
                reads.push((*read, self.ticks(*ticks)));
            }
        }
        self.tree(&expr.tree, &reads)
    }
}
