//! The shape of an evolution's code, decided once. The code generator matches on it and asks the chart nothing.

use super::{Descent, Evolution, Memory, Regions, Stored};
use crate::analysis::Facts;
use crate::model::{AssociationId, Effect, Model, Qualifier};
use crate::program::{self, Program, Refused};
use crate::sorted::Set;

/// How an evolution finds the next situation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// The cycle is printed from a program (`program/`): one region; or parallel branches and partial grafcets
    /// of which the program is not much longer than the chart, or no longer than without looking anything up by state.
    Program,
    /// `encoding flags;`: a bit for each step, looked at byte by byte.
    Flags,
    /// Parallel branches that write a state where a transition clears.
    InPlace,
    /// The situation after is a copy, which is compared with the one before.
    Compared,
}

/// How a `grafcet` searches for stability.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Search {
    /// An `sfc` evolves once in a cycle; of a program, what that says.
    None,
    /// Until nothing clears, and it is certain that this comes.
    Ends,
    /// Until nothing changes, or the bound is reached (A30).
    Bounded,
}

/// A program, where the chart has passed the checks.
type Made<'m> = Result<Program<'m>, Refused>;

/// What the plan already says when the shape is chosen.
pub(super) struct Known<'p> {
    pub(super) regions: &'p Regions,
    pub(super) evolution: &'p Evolution,
    pub(super) memory: &'p Memory,
    pub(super) stored: &'p Stored,
    pub(super) descent: Descent,
    /// Parallel branches lie within one another.
    pub(super) groups: bool,
    pub(super) may_be_unstable: bool,
    /// The program of several regions is short enough (`program::lean`).
    pub(super) is_lean: bool,
}

impl Known<'_> {
    /// The shape of the chart, and its program, where that says what an evolution does.
    pub(super) fn shaped<'m>(
        mut self,
        model: &'m Model,
        facts: &Facts<'_>,
        recorded: bool,
    ) -> (Shape, Option<Made<'m>>) {
        let mut shape = Shape::of(model, &self);
        let has_branches = self.regions.all().len() > 1;
        let lean = if has_branches && !shape.is_flags() { program::lean(model, facts, recorded) } else { None };
        if lean.is_some() {
            self.is_lean = true;
            shape = Shape::of(model, &self);
        }
        let made = || lean.map_or_else(|| program::optimised(model, facts, recorded), Ok);
        let program = (shape.form == Form::Program).then(made);
        (shape, program)
    }
}

/// The shape of an evolution and what follows from it.
pub struct Shape {
    /// How it finds the next situation.
    pub form: Form,
    /// How often.
    pub search: Search,
    /// It changes the situation or nothing.
    pub only_situation: bool,
    /// A transition that clears begins the times of the steps it enters.
    pub begins_on_entry: bool,
    /// It notes that it has changed the situation.
    pub notes_moves: bool,
    /// Partial grafcets evolve from the top downwards, each only where nothing above it has decided about it.
    pub descends: bool,
    /// Where a transition is looked at, its condition takes for granted that its source steps are active.
    pub takes_for_granted: bool,
    /// Stored actions that act where the transition clears.
    pub at_once: Set<AssociationId>,
    /// The situation after it is given (`forceable;`).
    pub given: bool,
}

impl Shape {
    /// The shape that suits a chart of which all else is planned.
    pub(super) fn of(model: &Model, plan: &Known<'_>) -> Self {
        let only_situation = changes_only_situation(model, plan);
        let form = form(plan);
        let in_place = form == Form::InPlace;
        let descends = model.partials.len() > 1 && in_place && plan.descent != Descent::Compares;
        let at_once = if in_place && (model.partials.len() == 1 || descends) {
            plan.stored.at_any_time.clone()
        } else {
            Set::new()
        };
        let begins_on_entry = in_place && plan.memory.begins_on_entry;
        let sees_moves =
            in_place || form == Form::Flags && model.partials.len() == 1 && plan.evolution.entered_last.is_empty();
        let mut shape = Self {
            form,
            search: Search::None,
            only_situation,
            begins_on_entry,
            notes_moves: sees_moves && (model.is_grafcet() || plan.memory.time),
            descends,
            takes_for_granted: !model.is_grafcet(),
            at_once,
            given: false,
        };
        shape.search = shape.search_of(model, plan);
        shape
    }

    /// The evolution of a forced cycle: the situation after is another one than that before, and nobody looks how it came about.
    pub(super) fn forced(flags: bool) -> Self {
        Self {
            form: if flags { Form::Flags } else { Form::Compared },
            search: Search::None,
            only_situation: false,
            begins_on_entry: false,
            notes_moves: false,
            descends: false,
            takes_for_granted: false,
            at_once: Set::new(),
            given: true,
        }
    }

    fn search_of(&self, model: &Model, plan: &Known<'_>) -> Search {
        // That of a program is its own.
        if !model.is_grafcet() || self.form == Form::Program {
            return Search::None;
        }
        if plan.may_be_unstable { Search::Bounded } else { Search::Ends }
    }

    /// A bit for each step.
    #[must_use]
    pub fn is_flags(&self) -> bool {
        self.form == Form::Flags
    }

    /// Regions are written where a transition clears.
    #[must_use]
    pub fn is_in_place(&self) -> bool {
        self.form == Form::InPlace
    }
}

/// Whether nothing but a change of the situation makes a search go on: no collected place, no call that is due (A25).
fn changes_only_situation(model: &Model, plan: &Known<'_>) -> bool {
    let calls = |effect: &Effect| matches!(effect, Effect::Call(..));
    plan.stored.collected.is_empty()
        && !model.associations.values().any(|a| a.qualifier == Qualifier::On && calls(&a.effect))
        && !model.transitions.values().any(|transition| transition.clearing.iter().any(calls))
}

fn form(plan: &Known<'_>) -> Form {
    if plan.regions.are_flags() {
        return Form::Flags;
    }
    if plan.regions.is_single() || plan.is_lean {
        return Form::Program;
    }
    // Where a search may have no end, its last evolution is compared with the situation before, which stays (A30).
    if plan.groups && !plan.may_be_unstable { Form::InPlace } else { Form::Compared }
}
