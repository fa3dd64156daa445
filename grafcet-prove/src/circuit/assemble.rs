//! The cycle as a whole: what the places hold in front of it, what it does, what the properties ask of its end, and what the latches hold next.

use std::rc::Rc;

use grafcet_compiler::model::{Name, Ty, Variants};
use grafcet_compiler::program::{PlaceId, Role, Type};

use super::claims::Claims;
use super::free::{As, Origin};
use super::homes::Home;
use super::monitors::Monitors;
use super::plants::Part;
use super::sym::{Sym, Width};
use super::{Circuit, Env, Field, Latch, Lowering, Refused};
use crate::aig::Lit;
use crate::bits::{self, Bits};

/// What the properties ask for.
struct Asked {
    claims: Claims,
    monitors: Monitors,
    homes: Vec<Home>,
    triggers: Vec<(usize, Lit)>,
    often: Vec<Lit>,
    orders: Vec<Lit>,
    without_orders: Lit,
}

/// A field under construction.
pub(super) struct Kept {
    pub(super) place: PlaceId,
    pub(super) bits: Vec<Lit>,
    pub(super) signed: bool,
}

impl<'p, 'm> Lowering<'p, 'm> {
    pub(super) fn circuit(mut self) -> Result<Circuit, Refused> {
        let program = self.program;
        self.initials()?;
        let (mut env, mut kept) = (Vec::new(), Vec::new());
        for index in 0..program.places.len() {
            let (sym, field) = self.place(PlaceId(index))?;
            env.push(sym);
            kept.extend(field);
        }
        if let Some(Sym::Bool(first)) = program.place(Role::First).map(|first| env[first.0].clone()) {
            self.memories.first = first;
        }
        let so_far = self.aig.free();
        let mut plants = self.plants()?;
        self.given()?;
        let env = Rc::new(env);
        let (end, _) = self.block(env.clone(), &program.cycle)?;
        self.plants_evolve(&mut plants, &end)?;
        let constraint = self.assumptions(&end)?;
        self.constraint = self.aig.and(self.constraint, constraint);
        let (overflow, differing) = (self.overflow, self.differing());
        let overflow = self.aig.or(overflow, differing);
        let broken = self.aig.or(so_far, overflow);
        let mut claims = self.claims(&end, broken);
        let (homes, refused) = self.homes(&env, &end);
        claims.refused.extend(refused);
        let mut monitors = self.monitors(&end, broken);
        let orders = self.orders(&mut monitors, &end)?;
        let triggers = self.triggers(&end);
        let mut often = self.recurring()?;
        often.extend(orders.often);
        let without_orders = self.aig.and(self.constraint, !self.panics);
        self.constraint = self.aig.and(without_orders, orders.hold);
        let orders = orders.triggers;
        let asked = Asked { claims, monitors, homes, triggers, often, orders, without_orders };
        self.finish((kept, plants), &end, (so_far, broken), asked)
    }

    fn finish(
        mut self,
        (kept, plants): (Vec<Kept>, Vec<Part<'p, 'm>>),
        end: &Env,
        (so_far, broken): (Lit, Lit),
        asked: Asked,
    ) -> Result<Circuit, Refused> {
        let (mut latches, mut fields) = (Vec::new(), Vec::new());
        for one in kept {
            let place = &self.program.places[one.place.0];
            let width = one.bits.len();
            let (initial, next) = (self.initial[one.place.0].clone(), end[one.place.0].clone());
            let initial = match initial {
                Sym::Free(_) => vec![None; width],
                sym => self.wires_of(sym, width, one.signed)?.into_iter().map(Lit::known).collect(),
            };
            let next = self.wires_of(next, width, one.signed)?;
            let (name, first, signed) = (place.name.clone(), latches.len(), one.signed);
            fields.push(Field { place: Some(one.place), plant: None, name, first, width, signed });
            for ((now, next), initial) in one.bits.into_iter().zip(next).zip(initial) {
                latches.push(Latch { now, next, initial });
            }
        }
        self.finish_plants(plants, &mut latches, &mut fields)?;
        fields.push(Field {
            place: None,
            plant: None,
            name: "overflowed".to_owned(),
            first: latches.len(),
            width: 1,
            signed: false,
        });
        latches.push(Latch { now: so_far, next: broken, initial: Some(false) });
        self.keep_constants(&mut latches, &mut fields);
        let mut timers = std::mem::take(&mut self.memories).finish(&mut latches, &mut fields);
        let Asked { mut claims, mut monitors, homes, triggers, often, orders, without_orders } = asked;
        claims.refused.append(&mut monitors.refused);
        let ended = monitors.finish(&mut latches, &mut fields);
        claims.bad.extend(ended.bad);
        timers.extend(ended.timers);
        Ok(Circuit {
            aig: self.aig,
            inputs: self.inputs,
            latches,
            fields,
            constraint: self.constraint,
            without_orders,
            overflow: self.overflow,
            constants: self.constants,
            uncomputed: self.uncomputed,
            bad: claims.bad,
            live: ended.live,
            deadlines: ended.deadlines,
            homes,
            triggers,
            often,
            orders,
            moves: self.moves,
            refused: claims.refused,
            rounds: self.rounds,
            evolutions: self.evolutions,
            unsettled: match self.program.place(Role::Stable).map(|place| &end[place.0]) {
                Some(Sym::Bool(stable)) => !*stable,
                _ => Lit::FALSE,
            },
            timers,
            time_bits: self.clock.width,
            period: self.clock.period,
        })
    }

    /// What a place holds at the beginning of a cycle.
    pub(super) fn place(&mut self, id: PlaceId) -> Result<(Sym, Option<Kept>), Refused> {
        let place = &self.program.places[id.0];
        match place.role {
            Role::Param(param) => return Ok((self.param(param)?, None)),
            Role::Reading => return Ok((self.ticks(0), None)),
            _ if !place.is_field => return Ok((self.initial[id.0].clone(), None)),
            _ => {}
        }
        if let Some((sym, kept)) = self.kept_place(id)? {
            return Ok((sym, Some(kept)));
        }
        let again = self.free(Origin::Made(place.name.clone()), Vec::new(), true);
        Ok((Sym::Free(again), None))
    }

    /// What a place holds, in latches of its own; none where nothing is known about its type.
    pub(super) fn kept_place(&mut self, id: PlaceId) -> Result<Option<(Sym, Kept)>, Refused> {
        let Some((width, signed)) = self.shape(id)? else { return Ok(None) };
        let place = &self.program.places[id.0];
        let bits: Vec<Lit> = (0..width).map(|_| self.aig.free()).collect();
        let number: Bits = if signed { bits.clone().into() } else { bits::unsigned(&bits) };
        let sym = match place.ty {
            Type::Bool | Type::User(Ty::Bool(_)) => Sym::Bool(bits[0]),
            Type::Ticks | Type::User(Ty::Time(_)) => Sym::Ticks(number),
            Type::State(_) => Sym::State(number),
            Type::Number | Type::Kind { .. } => Sym::Int(number, None),
            Type::User(ty) => Sym::Int(number, Width::of(ty)?),
        };
        Ok(Some((sym, Kept { place: id, bits, signed })))
    }

    /// How many bits a field has, and whether the last one is a sign; none where nothing is known about its type.
    pub(super) fn shape(&self, id: PlaceId) -> Result<Option<(usize, bool)>, Refused> {
        let place = &self.program.places[id.0];
        let bits = bits::width;
        Ok(Some(match place.ty {
            Type::Bool | Type::User(Ty::Bool(_)) => (1, false),
            Type::Ticks | Type::User(Ty::Time(_)) => (self.clock.width, false),
            Type::State(region) => (bits(self.program.regions[region].len()), false),
            Type::Number => (bits(self.largest_number), false),
            Type::Kind { count, .. } => (bits(usize::try_from(count).unwrap_or(usize::MAX)), false),
            Type::User(ty @ Ty::Int { .. }) => match Width::of(ty)? {
                Some(width) => (width.bits, width.signed),
                None => return Ok(None),
            },
            Type::User(Ty::Other(_)) => match self.variants(id) {
                Some(variants) => (bits(variants.list.len() - 1), false),
                None => return Ok(None),
            },
        }))
    }

    /// The variants that the chart lists of what a place holds.
    pub(super) fn variants(&self, id: PlaceId) -> Option<&'m Variants> {
        match self.program.places[id.0].role {
            Role::Var(id) => self.program.model.variants_of(Name::Var(id)),
            _ => None,
        }
    }

    /// The lowest wires of a value; where it does not fit, which happens to nothing but numbers, the circuit would be wrong.
    pub(super) fn wires_of(&mut self, sym: Sym, width: usize, signed: bool) -> Result<Vec<Lit>, Refused> {
        Ok(match sym {
            Sym::Bool(lit) => vec![lit],
            Sym::Phase => vec![Lit::FALSE],
            Sym::Int(bits, _) | Sym::Ticks(bits) | Sym::State(bits) => bits::low(&bits, width),
            Sym::Free(id) => bits::low(&self.free_bits(id, width, As::Number { signed })?, width),
        })
    }
}
