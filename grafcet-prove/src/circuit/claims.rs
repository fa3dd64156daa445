//! What is assumed of the inputs, and what is claimed of the ends of cycles.

use grafcet_compiler::analysis::combinational::written_out;
use grafcet_compiler::model::{Blinker, Id, MacroId, Model, Name, Property, Read, StepId, TimeRef, Tree};
use grafcet_compiler::program::Role;

use super::sym::Sym;
use super::{Bad, Env, Lowering, Refused};
use crate::aig::Lit;
use crate::bits::{self, Bits};

/// The properties of a circuit.
#[derive(Default)]
pub(super) struct Claims {
    pub(super) bad: Vec<Bad>,
    /// By property: what in it is not modelled.
    pub(super) refused: Vec<(usize, Refused)>,
}

/// Where a property is broken at the end of a cycle; a combinational variable stands for what it is then. None where one cycle alone does not tell.
pub(super) fn violation(model: &Model, property: &Property) -> Option<Result<Tree, Refused>> {
    let violation = property.claim.violation()?;
    let written = written_out(model, &violation);
    Some(written.ok_or_else(|| Refused("a property over variables that stand for too much".to_owned())))
}

/// All conditions that properties look at, as far as they are modelled.
pub(super) fn conditions(model: &Model) -> Vec<Tree> {
    let mut all = Vec::new();
    for property in &model.properties {
        match violation(model, property) {
            Some(violation) => all.extend(violation.ok()),
            None => all.extend(property.claim.expressions().iter().filter_map(|one| written_out(model, &one.tree))),
        }
    }
    all.extend(model.memories.values().filter_map(|memory| written_out(model, &memory.of.tree)));
    all
}

impl Lowering<'_, '_> {
    /// A recipe is exchanged between cycles: at the end of one it is what it was all along.
    pub(super) fn assumptions(&mut self, end: &Env) -> Result<Lit, Refused> {
        let mut all = Lit::TRUE;
        for assumption in &self.program.model.assumptions {
            let mut reads = Vec::new();
            for read in &assumption.never.reads {
                let sym = match read {
                    Read::Name(Name::Param(id)) => self.at(Role::Param(*id), end)?,
                    read => self.of_inputs(*read)?,
                };
                reads.push((*read, sym));
            }
            let never = self.tree(&assumption.never.tree, &reads)?;
            let never = self.bool(&never)?;
            all = self.aig.and(all, !never);
        }
        if let Some(longest) = self.program.model.longest_cycle {
            let elapsed = self.elapsed.clone();
            let longer = bits::less(&mut self.aig, &bits::constant(i128::from(longest)), &elapsed);
            all = self.aig.and(all, !longer);
        }
        Ok(all)
    }

    pub(super) fn of_inputs(&self, read: Read) -> Result<Sym, Refused> {
        match read {
            Read::Name(Name::Input(id)) => Ok(self.given[id.index()].clone()),
            Read::Ticks(ticks) => Ok(self.ticks(ticks)),
            _ => Err(Refused("an assumption over something else than inputs".to_owned())),
        }
    }

    /// `broken`: arithmetic has left its type in this cycle or before. What a property itself computes counts as well.
    pub(super) fn claims(&mut self, end: &Env, broken: Lit) -> Claims {
        let mut claims = Claims::default();
        let (overflow, panics, path) = (self.overflow, self.panics, self.path);
        for (property, one) in self.program.model.properties.iter().enumerate() {
            let Some(violation) = violation(self.program.model, one) else { continue };
            (self.overflow, self.panics, self.path) = (Lit::FALSE, Lit::FALSE, path);
            match violation.and_then(|violation| self.at_end(&violation, end)) {
                Ok(holds) => {
                    let possible = self.aig.and(holds, !self.panics);
                    let in_type = self.aig.and(!broken, !self.overflow);
                    let certain = self.aig.and(possible, in_type);
                    claims.bad.push(Bad { property, possible, certain });
                }
                Err(refused) => claims.refused.push((property, refused)),
            }
        }
        (self.overflow, self.panics, self.path) = (overflow, panics, path);
        claims
    }

    /// Of each property that is about something, where that happens. What is not modelled is left out.
    pub(super) fn triggers(&mut self, end: &Env) -> Vec<(usize, Lit)> {
        let (overflow, panics, path) = (self.overflow, self.panics, self.path);
        let mut all = Vec::new();
        for (property, one) in self.program.model.properties.iter().enumerate() {
            let trigger = one.claim.trigger().and_then(|trigger| written_out(self.program.model, &trigger.tree));
            (self.panics, self.path) = (Lit::FALSE, path);
            if let Some(Ok(happens)) = trigger.map(|trigger| self.at_end(&trigger, end)) {
                all.push((property, self.aig.and(happens, !self.panics)));
            }
        }
        (self.overflow, self.panics, self.path) = (overflow, panics, path);
        all
    }

    /// Whether a condition holds at the end of the cycle.
    pub(super) fn at_end(&mut self, tree: &Tree, end: &Env) -> Result<Lit, Refused> {
        let mut mentioned = Vec::new();
        tree.each_read(&mut |read| mentioned.push(read));
        let mut reads: Vec<(Read, Sym)> = Vec::new();
        for read in mentioned {
            if reads.iter().all(|(other, _)| *other != read) {
                reads.push((read, self.seen(read, end)?));
            }
        }
        let holds = self.tree(tree, &reads)?;
        self.bool(&holds)
    }

    fn seen(&mut self, read: Read, end: &Env) -> Result<Sym, Refused> {
        let role = match read {
            Read::Name(Name::Input(id)) => return Ok(self.given[id.index()].clone()),
            Read::Name(Name::Output(id)) => Role::Output(id),
            Read::Name(Name::Var(id)) => Role::Var(id),
            Read::Name(Name::Param(id)) => Role::Param(id),
            Read::Ticks(ticks) => return Ok(self.ticks(ticks)),
            Read::Active(step) => return Ok(Sym::Bool(self.is_active(step, end)?)),
            Read::MacroActive(id) => return Ok(Sym::Bool(self.is_macro_active(id, end)?)),
            Read::Since(_) | Read::MacroSince(_) => return Ok(Sym::Ticks(self.time_at_end(read, end)?)),
            Read::Elapsed(time, _) | Read::MacroElapsed(time, _) => {
                let (active, passed) = (self.about(read, end)?, self.time_at_end(read, end)?);
                let whole = match time {
                    TimeRef::Ticks(ticks) => self.ticks(ticks),
                    TimeRef::Param(id) => self.at(Role::Param(id), end)?,
                    TimeRef::Var(id) => self.at(Role::Var(id), end)?,
                };
                let Sym::Ticks(whole) = whole else { return Err(Refused("a time that is none".to_owned())) };
                let over = !bits::less(&mut self.aig, &passed, &whole);
                return Ok(Sym::Bool(self.aig.and(active, over)));
            }
            Read::Blink(blink) => return Ok(Sym::Bool(self.blinks(blink, end)?)),
            Read::Memory(id) => return Ok(Sym::Bool(self.remembered(id, end)?)),
            // A combinational variable may stand for one of the chart.
            Read::Rising(_) | Read::Falling(_) | Read::Delay(_) => {
                return Err(Refused("a variable that stands for an edge or a delay of the chart".to_owned()));
            }
        };
        self.at(role, end)
    }

    pub(super) fn at(&self, role: Role, end: &Env) -> Result<Sym, Refused> {
        let place = self.program.place(role).ok_or_else(|| Refused("a property over what is not stored".to_owned()))?;
        Ok(end[place.0].clone())
    }

    /// For how long a step or macro-step has been active at the end of the cycle; zero where it is not.
    fn time_at_end(&mut self, read: Read, end: &Env) -> Result<Bits, Refused> {
        let role = match read.about() {
            Some(Blinker::Step(step)) => {
                let region = self.program.regions.iter().position(|steps| steps.contains(&step));
                region.map(Role::Time)
            }
            Some(Blinker::Macro(id)) => Some(Role::MacroTime(id)),
            None => None,
        };
        let counted = role.map(|role| self.at(role, end)).transpose()?;
        let Some(Sym::Ticks(time)) = counted else { return Err(Refused("a time that is not counted".to_owned())) };
        let active = self.about(read, end)?;
        Ok(bits::mux(&mut self.aig, active, &time, &bits::constant(0)))
    }

    /// Whether the step or macro-step that something is about is active.
    fn about(&mut self, read: Read, end: &Env) -> Result<Lit, Refused> {
        match read.about() {
            Some(Blinker::Step(step)) => self.is_active(step, end),
            Some(Blinker::Macro(id)) => self.is_macro_active(id, end),
            None => Err(Refused("it is about no step".to_owned())),
        }
    }

    pub(super) fn is_macro_active(&mut self, id: MacroId, end: &Env) -> Result<Lit, Refused> {
        let mut any = Lit::FALSE;
        for step in &self.program.model.macros[id].steps {
            let is = self.is_active(*step, end)?;
            any = self.aig.or(any, is);
        }
        Ok(any)
    }

    pub(super) fn is_active(&mut self, step: StepId, end: &Env) -> Result<Lit, Refused> {
        for (place, sym) in self.program.places.iter().zip(end.iter()) {
            match (place.role, sym) {
                (Role::State(region), Sym::State(state)) if self.program.regions[region].contains(&step) => {
                    let code = bits::constant(super::sym::code(self.program, step)?);
                    let state = state.clone();
                    return Ok(bits::equal(&mut self.aig, &state, &code));
                }
                _ => {}
            }
        }
        Err(Refused("a step that is not stored".to_owned()))
    }
}
