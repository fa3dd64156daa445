//! One evolution at a time: the circuit of a `grafcet` in which a search for stability takes as many steps as it has evolutions.
//!
//! Unrolled, a search is as many copies of an evolution as it may have, and what is true of each of them has to be found in one piece. Here
//! a step is the beginning of a cycle and its first evolution, or one more of the same search, on the inputs that the cycle was given; only
//! where the search ends is there the end of a cycle. It knows less than the circuit of the whole cycle (the program may say something else
//! in each evolution, and plants, edges of properties and orders are left out), so that what is never so here is never so there.

use std::rc::Rc;

use grafcet_compiler::program::{PlaceId, Program, Role, Statement};

use super::assemble::Kept;
use super::clock::Clock;
use super::free::Origin;
use super::sym::Sym;
use super::{Bad, Circuit, Env, Field, Latch, Lowering, Refused, claims, monitors};
use crate::aig::Lit;

/// The parts of a cycle.
struct Parts<'p, 'm> {
    before: &'p [Statement<'m>],
    evolution: &'p [Statement<'m>],
    /// So many of them at most.
    rounds: u32,
    after: &'p [Statement<'m>],
}

/// What is kept from one evolution to the next.
pub(super) struct Held {
    name: String,
    bits: Vec<Lit>,
    next: Vec<Lit>,
}

impl Circuit {
    /// None for a chart that has no search, or asks for what is left out here.
    pub(crate) fn of_evolutions(program: &Program<'_>) -> Option<Self> {
        let model = program.model;
        if !program.plants.is_empty() || !model.memories.is_empty() {
            return None;
        }
        let clock = Clock::of(program, &claims::conditions(model), monitors::longest(model));
        let lowering = Lowering::new(program, super::LARGEST, clock);
        lowering.evolutions(&parts(&program.cycle)?).ok()
    }
}

fn parts<'p, 'm>(cycle: &'p [Statement<'m>]) -> Option<Parts<'p, 'm>> {
    let search = |statement: &'p Statement<'m>| match statement {
        Statement::Part(_, body) => match &body[..] {
            [Statement::Loop { rounds, body }] => Some((*rounds, &body[..])),
            _ => None,
        },
        _ => None,
    };
    let at = cycle.iter().position(|statement| search(statement).is_some())?;
    let (rounds, evolution) = search(&cycle[at])?;
    Some(Parts { before: &cycle[..at], evolution, rounds, after: &cycle[at + 1..] })
}

impl<'p, 'm> Lowering<'p, 'm> {
    fn evolutions(mut self, parts: &Parts<'p, 'm>) -> Result<Circuit, Refused> {
        // A search that its bound ends is one that counts up to there.
        self.largest_number = self.largest_number.max(parts.rounds as usize);
        self.initials()?;
        let (within, so_far) = (self.aig.free(), self.aig.free());
        self.within = Some(within);
        // What the places hold at the beginning of a cycle, and within a search.
        let (mut begin, mut inside, mut kept) = (Vec::new(), Vec::new(), Vec::new());
        for index in 0..self.program.places.len() {
            let id = PlaceId(index);
            let (sym, field) = self.place(id)?;
            let role = self.program.places[index].role;
            match (field, role) {
                (Some(field), _) => {
                    begin.push(sym.clone());
                    inside.push(sym);
                    kept.push((field, true));
                }
                (None, Role::Param(_) | Role::Reading) => {
                    begin.push(sym.clone());
                    inside.push(sym);
                }
                (None, _) => {
                    begin.push(sym);
                    if let Some((local, field)) = self.kept_place(id)? {
                        inside.push(local);
                        kept.push((field, false));
                    } else {
                        let any = Origin::Made(self.program.places[index].name.clone());
                        inside.push(Sym::Free(self.free(any, Vec::new(), true)));
                    }
                }
            }
        }
        if let Some(Sym::Bool(first)) = self.program.place(Role::First).map(|first| begin[first.0].clone()) {
            self.memories.first = first;
        }
        self.given()?;
        self.path = !within;
        let (first, _) = self.block(Rc::new(begin), parts.before)?;
        self.path = Lit::TRUE;
        let env = self.merge(within, &Rc::new(inside), &first)?;
        let (after, done) = self.block(env, parts.evolution)?;
        self.path = done;
        let (end, _) = self.block(after.clone(), parts.after)?;
        let assumed = self.assumptions(&end)?;
        let broken = self.aig.or(so_far, self.overflow);
        let claims = self.claims(&end, broken);
        self.path = Lit::TRUE;
        let constraint = self.aig.and(self.constraint, assumed);
        self.constraint = self.aig.and(constraint, !self.panics);
        let mut bad = Vec::new();
        for one in claims.bad {
            let possible = self.aig.and(one.possible, done);
            bad.push(Bad { possible, certain: possible, ..one });
        }
        self.of_evolution(kept, (within, done), (&after, &end), bad)
    }

    /// What is given in this cycle: within a search, as it was at the beginning.
    pub(super) fn as_given(&mut self, name: &str, fresh: Vec<Lit>) -> Vec<Lit> {
        let Some(within) = self.within else { return fresh };
        let bits: Vec<Lit> = fresh.iter().map(|_| self.aig.free()).collect();
        let next: Vec<Lit> = bits.iter().zip(&fresh).map(|(held, new)| self.aig.mux(within, *held, *new)).collect();
        self.held.push(Held { name: name.to_owned(), bits, next: next.clone() });
        next
    }

    /// The fields go on with what they hold at the end of the cycle, where this is one, the others with what they hold after the evolution.
    fn of_evolution(
        mut self,
        kept: Vec<(Kept, bool)>,
        (within, done): (Lit, Lit),
        (after, end): (&Env, &Env),
        bad: Vec<Bad>,
    ) -> Result<Circuit, Refused> {
        let (mut latches, mut fields) = (Vec::new(), Vec::new());
        for (one, is_field) in kept {
            let (index, width) = (one.place.0, one.bits.len());
            let mut initial = vec![Some(false); width];
            let mut next = self.wires_of(after[index].clone(), width, one.signed)?;
            if is_field {
                let last = self.wires_of(end[index].clone(), width, one.signed)?;
                next = next.into_iter().zip(last).map(|(next, last)| self.aig.mux(done, last, next)).collect();
                initial = match self.initial[index].clone() {
                    Sym::Free(_) => vec![None; width],
                    sym => self.wires_of(sym, width, one.signed)?.into_iter().map(Lit::known).collect(),
                };
            }
            let (name, first, signed) = (self.program.places[index].name.clone(), latches.len(), one.signed);
            fields.push(Field { place: Some(one.place), plant: None, name, first, width, signed });
            let all = one.bits.into_iter().zip(next).zip(initial);
            latches.extend(all.map(|((now, next), initial)| Latch { now, next, initial }));
        }
        let within = Held { name: "within a search".to_owned(), bits: vec![within], next: vec![!done] };
        for one in std::mem::take(&mut self.held).into_iter().chain([within]) {
            let (first, width) = (latches.len(), one.bits.len());
            fields.push(Field { place: None, plant: None, name: one.name, first, width, signed: false });
            let all = one.bits.into_iter().zip(one.next);
            latches.extend(all.map(|(now, next)| Latch { now, next, initial: Some(false) }));
        }
        self.keep_constants(&mut latches, &mut fields);
        Ok(Circuit {
            aig: self.aig,
            inputs: self.inputs,
            latches,
            fields,
            constraint: self.constraint,
            without_orders: self.constraint,
            overflow: Lit::FALSE,
            constants: self.constants,
            uncomputed: self.uncomputed,
            bad,
            live: Vec::new(),
            deadlines: Vec::new(),
            homes: Vec::new(),
            triggers: Vec::new(),
            often: Vec::new(),
            moves: Vec::new(),
            orders: Vec::new(),
            refused: Vec::new(),
            rounds: Vec::new(),
            evolutions: Vec::new(),
            unsettled: Lit::FALSE,
            timers: Vec::new(),
            time_bits: self.clock.width,
            period: self.clock.period,
        })
    }
}
