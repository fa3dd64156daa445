//! What is assumed of the inputs, and what is claimed of the ends of cycles.

use grafcet_compiler::model::{Id, Name, Read, StepId, Tree};
use grafcet_compiler::program::Role;

use super::sym::Sym;
use super::{Bad, Env, Lowering, Refused};
use crate::aig::Lit;
use crate::bits;

impl Lowering<'_, '_> {
    pub(super) fn assumptions(&mut self) -> Result<Lit, Refused> {
        let mut all = Lit::TRUE;
        for assumption in &self.program.model.assumptions {
            let mut reads = Vec::new();
            for read in &assumption.never.reads {
                reads.push((*read, self.of_inputs(*read)?));
            }
            let never = self.tree(&assumption.never.tree, &reads)?;
            let never = self.bool(&never)?;
            all = self.aig.and(all, !never);
        }
        Ok(all)
    }

    fn of_inputs(&self, read: Read) -> Result<Sym, Refused> {
        match read {
            Read::Name(Name::Input(id)) => Ok(self.given[id.index()].clone()),
            Read::Ticks(ticks) => Ok(self.ticks(ticks)),
            _ => Err(Refused("an assumption over something else than inputs".to_owned())),
        }
    }

    /// `broken`: arithmetic has left its type in this cycle or before. What a property itself computes counts as well.
    pub(super) fn claims(&mut self, end: &Env, broken: Lit) -> Result<Vec<Bad>, Refused> {
        let mut all = Vec::new();
        let (overflow, panics) = (self.overflow, self.panics);
        for (property, one) in self.program.model.properties.iter().enumerate() {
            let Some(violation) = one.claim.violation() else { continue };
            (self.overflow, self.panics) = (Lit::FALSE, Lit::FALSE);
            let holds = self.at_end(&violation, end)?;
            let possible = self.aig.and(holds, !self.panics);
            let in_type = self.aig.and(!broken, !self.overflow);
            let certain = self.aig.and(possible, in_type);
            all.push(Bad { property, possible, certain });
        }
        (self.overflow, self.panics) = (overflow, panics);
        Ok(all)
    }

    /// Whether a condition holds at the end of the cycle.
    fn at_end(&mut self, tree: &Tree, end: &Env) -> Result<Lit, Refused> {
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
            Read::MacroActive(id) => {
                let mut any = Lit::FALSE;
                for step in &self.program.model.macros[id].steps {
                    let is = self.is_active(*step, end)?;
                    any = self.aig.or(any, is);
                }
                return Ok(Sym::Bool(any));
            }
            _ => return Err(Refused("a property over an edge or a time".to_owned())),
        };
        let place = self.program.place(role).ok_or_else(|| Refused("a property over what is not stored".to_owned()))?;
        Ok(end[place.0].clone())
    }

    fn is_active(&mut self, step: StepId, end: &Env) -> Result<Lit, Refused> {
        for (place, sym) in self.program.places.iter().zip(end.iter()) {
            match (place.role, sym) {
                (Role::Bit(other), Sym::Bool(lit)) if other == step => return Ok(*lit),
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
