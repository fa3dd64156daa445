//! A part of regions that depend on each other, transition by transition: what clears one, and what it changes, stands in one place, by the state of
//! one of its regions.
//!
//! ```text
//! clears.(A,S)→B = was.state.A is A && was.state.S is S && x      match state.A
//! clears.B→(A,F) = was.state.A is B && !x                           A:
//! if clears.(A,S)→B: state.A = none                                   if state.S is S && x:
//! if clears.(A,S)→B: state.S = none                                     state.A = B
//! if clears.B→(A,F): state.A = none                         ->          state.S = none
//! if clears.B→(A,F): state.A = A                                    B:
//! if clears.(A,S)→B: state.A = B                                      if !x:
//! if clears.B→(A,F): state.S = F                                        state.A = A
//!                                                                       state.S = F
//! ```
//!
//! A condition asks for the state before: of a copy, where a transition in front of it may have written what it asks for. What several write, the one
//! writes last that did so before. Where somebody asks later on what has cleared, each transition says so (`told`).

mod guards;
mod order;
mod sorted;
mod told;

use super::super::edits::{replaced, rewrite};
use super::super::engine::Fact;
use super::super::fold::excludes;
use super::super::parts::Part;
use super::super::uses::Effects;
use super::{Env, Several};
use crate::model::StepId;
use crate::program::build::no;
use crate::program::{Expr, PlaceId, Statement};
use crate::sorted::Set;

use order::{Groups, Writer};
use sorted::Sorted;

/// A transition.
struct Clearing<'m> {
    /// That it clears, and which statement says so.
    truth: PlaceId,
    at: usize,
    /// All of these hold then.
    asks: Vec<Expr<'m>>,
    /// By region that is asked for: one of these steps is active.
    tests: Vec<(usize, Vec<StepId>)>,
    /// By region: which statement writes its state last, and what.
    writes: Vec<(usize, usize, Option<StepId>)>,
    /// Somebody asks for the truth after it.
    is_kept: bool,
}

/// Where it is asked which transitions clear.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Asking {
    /// In one place each; whoever denies another transition, where that one does not clear.
    Denying,
    /// In one place each, but for those that others deny.
    Telling,
    /// Of all for which anybody asks later on, before one clears.
    Beforehand,
}

/// The statements of a part, those that stand for its transitions, and the regions of which these want a copy of the state before.
struct Evolution<'m> {
    sorted: Sorted<'m>,
    statements: Vec<Statement<'m>>,
    copies: Set<usize>,
}

/// A truth that becomes true where transitions clear.
struct Told {
    truth: PlaceId,
    /// Which of them; `None` is each.
    by: Option<Set<usize>>,
    /// It is false before.
    begins: bool,
}

impl Clearing<'_> {
    fn test(&self, region: usize) -> Option<&[StepId]> {
        self.tests.iter().find(|(other, _)| *other == region).map(|(_, steps)| &steps[..])
    }

    fn write(&self, region: usize) -> Option<(usize, Option<StepId>)> {
        self.writes.iter().find(|(other, ..)| *other == region).map(|(_, at, step)| (*at, *step))
    }

    /// It asks for other steps of a region than the one that is active.
    fn is_elsewhere(&self, (region, step): (usize, StepId)) -> bool {
        self.test(region).is_some_and(|steps| !steps.contains(&step))
    }

    /// Two of which one needs a step that the other one cannot have beside its own.
    fn needs_other_steps(&self, other: &Self, several: &Several<'_, '_>) -> bool {
        let may_meet = |(here, step): (usize, StepId), (there, other): (usize, StepId)| {
            if here == there { step == other } else { several.may_meet(Some(step), Some(other)) }
        };
        self.tests.iter().any(|(here, steps)| {
            let meets = |there: usize, others: &[StepId]| {
                steps.iter().any(|step| others.iter().any(|other| may_meet((*here, *step), (there, *other))))
            };
            other.tests.iter().any(|(there, others)| !meets(*there, others))
        })
    }

    /// Two that never clear together, by their steps or as one of them denies the other.
    fn excludes(&self, other: &Self, several: &Several<'_, '_>) -> bool {
        self.needs_other_steps(other, several) || self.denies(other) || other.denies(self)
    }

    /// It asks for the opposite of what the other one asks for, or that this one does not clear.
    fn denies(&self, other: &Self) -> bool {
        let is_denied = |asked: &Expr<'_>| match asked {
            Expr::Not(inner) => {
                matches!(**inner, Expr::Place(truth) if truth == other.truth) || {
                    other.asks.iter().any(|one| excludes(one, asked))
                }
            }
            _ => false,
        };
        self.asks.iter().any(is_denied)
    }

    /// Whether another one that may clear with it says last what becomes of a region.
    fn yields_to(&self, other: &Self, several: &Several<'_, '_>) -> bool {
        let mut written = self.writes.iter();
        let is_overwritten = written.any(|(region, at, step)| {
            other.write(*region).is_some_and(|(later, written)| written != *step && *at < later)
        });
        is_overwritten && !self.excludes(other, several)
    }

    /// Whether it is as true that a region is in one of these states, after it has cleared, as it was before.
    fn keeps(&self, region: usize, steps: &[StepId]) -> bool {
        let Some((_, written)) = self.write(region) else { return true };
        let is_in = written.is_some_and(|step| steps.contains(&step));
        self.test(region).is_some_and(|own| own.iter().all(|step| steps.contains(step) == is_in))
    }

    /// Whether a region has another state after it, unless one clears, too, that leads back to the one before.
    fn moves(
        &self,
        region: usize,
        (all, several): (&[Self], &Several<'_, '_>),
        leads_back: impl Fn(usize) -> bool,
    ) -> bool {
        let (Some(own), Some((_, written))) = (self.test(region), self.write(region)) else { return false };
        let is_back = |other: &Self| match other.write(region) {
            Some((_, Some(step))) => own.contains(&step) && !self.excludes(other, several),
            _ => false,
        };
        let mut back = all.iter().enumerate().filter(|(_, other)| is_back(other));
        written.is_none_or(|step| !own.contains(&step)) && back.all(|(at, _)| leads_back(at))
    }
}

impl<'m> Several<'_, 'm> {
    /// The part transition by transition, if it is understood.
    pub(super) fn by_clearing(&self, part: &Part<'m>, env: &Env) -> Option<Vec<Statement<'m>>> {
        let each = [Asking::Denying, Asking::Telling, Asking::Beforehand];
        let Evolution { sorted, statements, copies } =
            each.into_iter().find_map(|asking| self.evolution(part, env, asking))?;
        let mut all = Vec::new();
        for region in &*copies {
            let (was, state) = (self.was[*region]?, self.states[*region]);
            if !is_copied(&sorted.before, was, state) {
                all.push(Statement::Set(was, Expr::Place(state)));
            }
        }
        all.extend(sorted.before.iter().cloned());
        for Told { truth, .. } in sorted.told.iter().filter(|told| told.begins) {
            all.push(Statement::Set(*truth, no()));
        }
        let mut env = env.clone();
        self.after(&all, &mut env);
        all.extend(statements);
        for clearing in &sorted.clearings {
            for (region, ..) in &clearing.writes {
                let state = self.states[*region];
                env.facts[state.0] = env.among(self.possible(*region));
                // What was found of the state before says nothing of the one after it.
                env.only.retain(|(_, of, _)| *of != state);
                for fact in &mut env.facts {
                    if *fact == Fact::Copy(state) {
                        *fact = Fact::Nothing;
                    }
                }
            }
        }
        for Told { truth, .. } in &sorted.told {
            env.facts[truth.0] = Fact::Nothing;
        }
        let mut after = sorted.after;
        rewrite(&mut after, &mut |expr| replaced(expr, &|part| self.never_changes(part, &sorted.clearings).then(no)));
        all.extend(self.spec(&after, &env));
        Some(all)
    }

    /// Whether an expression asks that a step has been entered, or left, that none of these transitions enters or leaves.
    fn never_changes(&self, expr: &Expr<'m>, clearings: &[Clearing<'m>]) -> bool {
        let Expr::All(parts) = expr else { return false };
        let asks = |of: PlaceId, step: StepId, holds: bool| {
            parts.iter().any(|part| match part {
                Expr::Is(place, steps) => holds && *place == of && steps[..] == [step],
                Expr::Not(inner) => {
                    !holds && matches!(&**inner, Expr::Is(place, steps) if *place == of && steps[..] == [step])
                }
                _ => false,
            })
        };
        let is_never = |(region, step): (usize, StepId)| {
            let (Some(was), state) = (self.was[region], self.states[region]) else { return false };
            let enters = |one: &Clearing<'m>| one.write(region).is_some_and(|(_, to)| to == Some(step));
            let leaves = |one: &Clearing<'m>| {
                one.write(region).is_some_and(|(_, to)| to != Some(step)) && !one.is_elsewhere((region, step))
            };
            asks(state, step, true) && asks(was, step, false) && !clearings.iter().any(enters)
                || asks(was, step, true) && asks(state, step, false) && !clearings.iter().any(leaves)
        };
        parts.iter().any(|part| match part {
            Expr::Is(place, steps) => match (self.region_of(*place), &steps[..]) {
                (Some(region), [step]) => is_never((region, *step)),
                _ => false,
            },
            _ => false,
        })
    }

    /// A part whose transitions are asked for so, if that is possible.
    fn evolution(&self, part: &Part<'m>, env: &Env, asking: Asking) -> Option<Evolution<'m>> {
        let sorted = self.sorted(&part.statements, env, asking)?;
        let groups = Groups { several: self, clearings: &sorted.clearings, asking };
        let free = self.free(&part.statements, env);
        let mut writer = Writer { groups, told: &sorted.told, free: &free, copies: Set::new(), done: Vec::new() };
        let mut statements = Vec::new();
        for group in &groups.ordered()? {
            statements.extend(writer.group(group)?);
        }
        let copies = writer.copies;
        Some(Evolution { sorted, statements, copies })
    }

    /// The regions of which a copy may be made here: nobody needs another one, or it is the same.
    pub(super) fn free(&self, list: &[Statement<'m>], env: &Env) -> Set<usize> {
        let asked = Effects::of_all(list).reads;
        let mut free = Set::new();
        for (region, (was, state)) in self.was.iter().zip(&self.states).enumerate() {
            let Some(was) = *was else { continue };
            let is_asked = asked.contains(&was) || env.later.contains(&was) || self.read_after.contains(was);
            if !is_asked || env.facts[was.0] == Fact::Copy(*state) || is_copied(list, was, *state) {
                free.insert(region);
            }
        }
        free
    }

    /// The region whose state a place holds, or held before.
    fn region_of(&self, place: PlaceId) -> Option<usize> {
        let state = self.states.iter().position(|state| *state == place);
        state.or_else(|| self.was.iter().position(|was| *was == Some(place)))
    }
}

fn is_copied(list: &[Statement<'_>], was: PlaceId, state: PlaceId) -> bool {
    list.iter().any(|one| matches!(one, Statement::Set(to, Expr::Place(of)) if *to == was && *of == state))
}

/// What all has to hold.
pub(super) fn parts<'e, 'm>(condition: &'e Expr<'m>) -> &'e [Expr<'m>] {
    match condition {
        Expr::All(parts) => parts,
        one => std::slice::from_ref(one),
    }
}
