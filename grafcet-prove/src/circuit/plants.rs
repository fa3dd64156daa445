//! A chart together with its plants: in each cycle it reads what they showed at the end of the cycle before, then they evolve on its outputs.
//!
//! What a plant shows is latches beside those of its state. All begin with what its first cycle leaves, on outputs that are off: the
//! machine stands there before the controller is switched on.

use std::rc::Rc;

use grafcet_compiler::model::{Id, InputId, Model, Name, Seen, Ty, Wire as From};
use grafcet_compiler::program::{PlaceId, Program, Role, Type};

use super::assemble::Kept;
use super::sym::{Sym, Width};
use super::{Env, Field, Latch, Lowering, Refused, Source};
use crate::aig::Lit;
use crate::bits::{self, Bits};

/// A plant under construction.
pub(super) struct Part<'p, 'm> {
    number: usize,
    lowering: Lowering<'p, 'm>,
    env: Env,
    kept: Vec<Kept>,
    /// By output: its latches.
    shown: Vec<Kept>,
    /// What its places hold after its first cycle.
    begin: Env,
    /// The same at the end of this one.
    end: Env,
}

impl<'p, 'm> Lowering<'p, 'm> {
    /// The plants at the beginning of a cycle.
    pub(super) fn plants(&mut self) -> Result<Vec<Part<'p, 'm>>, Refused> {
        let mut parts = Vec::new();
        let programs: &'p [Program<'m>] = &self.program.plants;
        for (number, program) in programs.iter().enumerate() {
            let mut lowering = Self::new(program, self.largest, self.clock);
            lowering.is_plant = true;
            std::mem::swap(&mut self.aig, &mut lowering.aig);
            let part = Part::begin(number, lowering);
            let mut part = part?;
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            self.shown.push(part.shown()?);
            parts.push(part);
        }
        Ok(parts)
    }

    /// The plants at its end; the chart's outputs are those of `end`.
    pub(super) fn plants_evolve(&mut self, parts: &mut [Part<'p, 'm>], end: &Env) -> Result<(), Refused> {
        for part in parts.iter_mut() {
            let given = self.given_to(part, end)?;
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            let evolved = part.evolve(given, self.elapsed.clone());
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            evolved?;
            let of_part = &mut part.lowering;
            self.inputs.append(&mut of_part.inputs);
            self.constants.append(&mut of_part.constants);
            self.overflow = self.aig.or(self.overflow, of_part.overflow);
            self.panics = self.aig.or(self.panics, of_part.panics);
            self.constraint = self.aig.and(self.constraint, of_part.constraint);
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            let moves = part.moves();
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            self.moves.push(moves?);
        }
        let model: &'m Model = self.program.model;
        for watched in &model.plants.watched {
            let part = &mut parts[watched.plant];
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            let seen = part.seen(watched.what);
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            self.given[watched.input.index()] = exchanged(seen?)?;
        }
        Ok(())
    }

    /// What stands for an input that the chart's surroundings do not give it.
    pub(super) fn of_plants(&self, input: InputId) -> Option<Sym> {
        let plants = &self.program.model.plants;
        if plants.is_watched(input) {
            // Only the ends of cycles ask for it, and it is known there.
            return Some(Sym::bool(false));
        }
        let driven = plants.driven.iter().find(|driven| driven.input == input)?;
        Some(self.shown[driven.plant][driven.output.index()].clone())
    }

    fn given_to(&mut self, part: &Part<'p, 'm>, end: &Env) -> Result<Vec<Sym>, Refused> {
        let plant = &self.program.model.plants.list[part.number];
        let mut given = Vec::new();
        for (input, wire) in plant.model.inputs.ids().zip(&plant.wires) {
            let sym = match *wire {
                From::Output(id) => self.at(Role::Output(id), end)?,
                From::Shown(other, id) => self.shown[other][id.index()].clone(),
                From::Shared(id) => self.given[id.index()].clone(),
                From::Free => {
                    let (ty, text) = (plant.model.ty(Name::Input(input)), &plant.model.inputs[input].name);
                    self.declared(ty, Name::Input(input), Source::Plant(part.number, input), &text.to_string())?
                }
            };
            given.push(exchanged(sym)?);
        }
        Ok(given)
    }

    /// The latches of the plants, after those of the chart.
    pub(super) fn finish_plants(
        &mut self,
        parts: Vec<Part<'p, 'm>>,
        latches: &mut Vec<Latch>,
        fields: &mut Vec<Field>,
    ) -> Result<(), Refused> {
        for mut part in parts {
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            let finished = part.finish(latches, fields);
            std::mem::swap(&mut self.aig, &mut part.lowering.aig);
            finished?;
        }
        Ok(())
    }
}

/// Between a chart and its plants only what is followed is exchanged.
fn exchanged(sym: Sym) -> Result<Sym, Refused> {
    match sym {
        Sym::Bool(_) | Sym::Int(..) | Sym::Ticks(_) => Ok(sym),
        _ => Err(Refused("a value between chart and plant that is not looked into".to_owned())),
    }
}

impl<'p, 'm> Part<'p, 'm> {
    fn begin(number: usize, mut lowering: Lowering<'p, 'm>) -> Result<Self, Refused> {
        let program = lowering.program;
        lowering.initials()?;
        for input in program.model.inputs.values() {
            lowering.given.push(match &input.ty {
                Ty::Bool(_) => Sym::bool(false),
                Ty::Time(_) => lowering.ticks(0),
                ty => Sym::Int(bits::constant(0), Width::of(ty)?),
            });
        }
        let (begin, _) = lowering.block(Rc::new(lowering.initial.clone()), &program.cycle)?;
        (lowering.overflow, lowering.panics, lowering.path) = (Lit::FALSE, Lit::FALSE, Lit::TRUE);
        let (mut env, mut kept) = (Vec::new(), Vec::new());
        for index in 0..program.places.len() {
            let (sym, field) = lowering.place(PlaceId(index))?;
            env.push(sym);
            kept.extend(field);
        }
        let mut shown = Vec::new();
        for id in program.model.outputs.ids() {
            let Some(place) = program.place(Role::Output(id)) else {
                return Err(Refused("an output that is not stored".to_owned()));
            };
            let Some((width, signed)) = lowering.shape(place)? else {
                return Err(Refused(program.places[place.0].name.clone()));
            };
            let bits = (0..width).map(|_| lowering.aig.free()).collect();
            shown.push(Kept { place, bits, signed });
        }
        let env = Rc::new(env);
        Ok(Self { number, lowering, end: env.clone(), env, kept, shown, begin })
    }

    /// Its outputs at the end of the cycle before.
    fn shown(&self) -> Result<Vec<Sym>, Refused> {
        let mut all = Vec::new();
        for kept in &self.shown {
            let number: Bits = if kept.signed { kept.bits.clone().into() } else { bits::unsigned(&kept.bits) };
            let ty = self.lowering.program.places[kept.place.0].ty;
            all.push(match ty {
                Type::Bool | Type::User(Ty::Bool(_)) => Sym::Bool(kept.bits[0]),
                Type::Ticks | Type::User(Ty::Time(_)) => Sym::Ticks(number),
                Type::User(ty @ Ty::Int { .. }) => Sym::Int(number, Width::of(ty)?),
                _ => return Err(Refused("an output of a plant that is neither `bool` nor a number".to_owned())),
            });
        }
        Ok(all)
    }

    fn evolve(&mut self, given: Vec<Sym>, elapsed: Bits) -> Result<(), Refused> {
        let of_part = &mut self.lowering;
        (of_part.given, of_part.elapsed) = (given, elapsed);
        let program = of_part.program;
        let (end, _) = of_part.block(self.env.clone(), &program.cycle)?;
        let assumed = of_part.assumptions(&end)?;
        of_part.constraint = of_part.aig.and(of_part.constraint, assumed);
        self.end = end;
        Ok(())
    }

    /// Its situation is not the initial one at the end of the cycle.
    fn moves(&mut self) -> Result<Lit, Refused> {
        let (begin, end) = (self.begin.clone(), self.end.clone());
        let mut moves = Lit::FALSE;
        for step in self.lowering.program.model.steps.ids() {
            let was = self.lowering.is_active(step, &begin)?;
            let is = self.lowering.is_active(step, &end)?;
            let aig = &mut self.lowering.aig;
            let same = aig.iff(was, is);
            moves = aig.or(moves, !same);
        }
        Ok(moves)
    }

    fn seen(&mut self, what: Seen) -> Result<Sym, Refused> {
        let end = self.end.clone();
        Ok(match what {
            Seen::Step(step) => Sym::Bool(self.lowering.is_active(step, &end)?),
            Seen::Macro(id) => Sym::Bool(self.lowering.is_macro_active(id, &end)?),
            Seen::Value(Name::Input(id)) => self.lowering.given[id.index()].clone(),
            Seen::Value(Name::Output(id)) => self.lowering.at(Role::Output(id), &end)?,
            Seen::Value(Name::Var(id)) => self.lowering.at(Role::Var(id), &end)?,
            Seen::Value(Name::Param(id)) => self.lowering.at(Role::Param(id), &end)?,
        })
    }

    fn finish(&mut self, latches: &mut Vec<Latch>, fields: &mut Vec<Field>) -> Result<(), Refused> {
        let states = self.kept.len();
        let all = self.kept.drain(..).chain(self.shown.drain(..)).collect::<Vec<Kept>>();
        for (index, one) in all.into_iter().enumerate() {
            let (width, program) = (one.bits.len(), self.lowering.program);
            let begin = match self.begin[one.place.0].clone() {
                Sym::Free(_) => vec![None; width],
                sym => self.lowering.wires_of(sym, width, one.signed)?.into_iter().map(Lit::known).collect(),
            };
            let next = self.lowering.wires_of(self.end[one.place.0].clone(), width, one.signed)?;
            let was = if index < states { "" } else { " shown" };
            fields.push(Field {
                place: (index < states).then_some(one.place),
                plant: Some(self.number),
                name: format!("{}::{}{was}", program.model.name, program.places[one.place.0].name),
                first: latches.len(),
                width,
                signed: one.signed,
            });
            for ((now, next), initial) in one.bits.into_iter().zip(next).zip(begin) {
                latches.push(Latch { now, next, initial });
            }
        }
        Ok(())
    }
}
