//! The shape of an evolution's code, decided once. The code generator matches on it and asks the chart nothing.

use super::{Descent, Evolution, Memory, Regions, Stored};
use crate::analysis::Ends;
use crate::model::{AssociationId, Effect, Id, Model, Place, Qualifier, StepId, TransitionId, Tree};
use crate::sorted::{Map, Set};

/// From how many steps with one transition on a table is smaller than code.
const LONG: usize = 20;

/// One of so many steps may wait for something of its own where a table says what the active step waits for.
const ALONE: usize = 5;

/// Up to so many fields, keeping them in each evolution takes less than calling it as a function and once more on a copy; with
/// more, it takes a tenth more flash and more.
const FEW_FIELDS: usize = 3;

/// Up to so many steps, a path of a search that clears nothing leaves it at once; with more, paths that all end in a state are
/// the smaller code.
const FEW_STEPS: usize = 24;

/// How an evolution finds the next situation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// The cycle is printed from a program (`program/`): one region, each transition from one step to one.
    Program,
    /// `encoding flags;`: a bit for each step, looked at byte by byte.
    Flags,
    /// One region, each transition from one step to one: one `match` from a step to the next.
    Sequence,
    /// Such a chart of many steps, most of which have but one transition: a test for each condition, and a table.
    LongSequence,
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
    /// Nothing can follow the first evolution.
    Once,
    /// Until nothing clears, and it is certain that this comes; at some steps it is known without another look.
    Ends,
    /// From step to step, as often as the bound says: a step that has come back by then shows that it goes on.
    Walk,
    /// Until nothing changes, or the bound is reached (A30).
    Bounded(Undo),
}

/// How a search whose bound is reached knows whether it would go on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Undo {
    /// The situation before is at hand anyway.
    Nothing,
    /// What an evolution changes is little: it is kept, and put back.
    PutBack,
    /// The evolution is a function, and the last one works on a copy of the chart.
    Copy,
}

/// What the plan already says when the shape is chosen.
pub(super) struct Known<'p> {
    pub(super) regions: &'p Regions,
    pub(super) evolution: &'p Evolution,
    pub(super) memory: &'p Memory,
    pub(super) stored: &'p Stored,
    pub(super) descent: Descent,
    pub(super) search_ends: &'p Ends,
    /// Parallel branches lie within one another.
    pub(super) nests: bool,
    pub(super) may_be_unstable: bool,
    pub(super) comes_back: bool,
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
    /// The paths of the search that clear nothing leave it at once.
    pub breaks_out: bool,
    /// Where a transition is looked at, its condition takes for granted that its source steps are active. In a short search LLVM finds
    /// that out by itself, and the same in front of all.
    pub takes_for_granted: bool,
    /// What the active step of a long sequence waits for comes out of a table.
    pub looks_up_waits: bool,
    /// Stored actions that act where the transition clears.
    pub at_once: Set<AssociationId>,
    /// The situation after it is given (`forceable;`).
    pub given: bool,
}

impl Shape {
    /// The shape that suits a chart of which all else is planned.
    pub(super) fn of(model: &Model, plan: &Known<'_>) -> Self {
        let only_situation = changes_only_situation(model, plan);
        let form = form(model, plan, only_situation);
        let in_place = form == Form::InPlace;
        let is_sequence = matches!(form, Form::Sequence | Form::LongSequence);
        let descends = model.partials.len() > 1 && in_place && plan.descent != Descent::Compares;
        let at_once = if in_place && (model.partials.len() == 1 || descends) {
            plan.stored.at_any_time.clone()
        } else {
            Set::new()
        };
        let walks = model.is_grafcet()
            && plan.may_be_unstable
            && plan.comes_back
            && plan.memory.edges.is_empty()
            && is_sequence;
        // An evolution that the bound forbids has been found by then.
        let never_taken_back = !plan.may_be_unstable || walks;
        let begins_on_entry = (in_place || form == Form::Sequence && never_taken_back) && plan.memory.begins_on_entry;
        let sees_moves = in_place
            || form == Form::Sequence && !model.is_grafcet()
            || form == Form::Flags && model.partials.len() == 1 && plan.evolution.entered_last.is_empty();
        let mut shape = Self {
            form,
            search: Search::None,
            only_situation,
            begins_on_entry,
            notes_moves: sees_moves && (model.is_grafcet() || plan.memory.time),
            descends,
            breaks_out: model.is_grafcet() && is_sequence && model.steps.len() <= FEW_STEPS,
            takes_for_granted: !model.is_grafcet() || form == Form::LongSequence,
            looks_up_waits: form == Form::LongSequence && (model.optimize_size || copies_few(model, plan.evolution)),
            at_once,
            given: false,
        };
        shape.search = shape.search_of(model, plan, walks);
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
            breaks_out: false,
            takes_for_granted: false,
            looks_up_waits: false,
            at_once: Set::new(),
            given: true,
        }
    }

    fn search_of(&self, model: &Model, plan: &Known<'_>, walks: bool) -> Search {
        // That of a program is its own.
        if !model.is_grafcet() || self.form == Form::Program {
            return Search::None;
        }
        match (plan.may_be_unstable, walks) {
            (true, true) => Search::Walk,
            (true, false) if self.form != Form::InPlace => Search::Bounded(Undo::Nothing),
            (true, false) if self.changed_fields(model, plan) <= FEW_FIELDS => Search::Bounded(Undo::PutBack),
            (true, false) => Search::Bounded(Undo::Copy),
            (false, _) if self.form == Form::Sequence && plan.search_ends.always() => Search::Once,
            (false, _) => Search::Ends,
        }
    }

    /// How many fields an evolution in place changes where a transition clears.
    fn changed_fields(&self, model: &Model, plan: &Known<'_>) -> usize {
        let regions = plan.regions.all().len();
        let times: usize = (0..regions).map(|region| plan.memory.counters(region)).sum();
        let mut places: Set<Place> = Set::new();
        for id in &self.at_once {
            places.extend(model.associations[*id].effect.writes().iter().copied());
        }
        regions + if self.begins_on_entry { times } else { 0 } + places.len()
    }

    /// A bit for each step.
    #[must_use]
    pub fn is_flags(&self) -> bool {
        self.form == Form::Flags
    }

    /// One `match` from a step to the next, or the tables of a long one.
    #[must_use]
    pub fn is_sequence(&self) -> bool {
        matches!(self.form, Form::Sequence | Form::LongSequence)
    }

    /// The tables of a long sequence.
    #[must_use]
    pub fn is_long(&self) -> bool {
        self.form == Form::LongSequence
    }

    /// Regions are written where a transition clears.
    #[must_use]
    pub fn is_in_place(&self) -> bool {
        self.form == Form::InPlace
    }

    /// The search goes from step to step as often as the bound says.
    #[must_use]
    pub fn walks(&self) -> bool {
        self.search == Search::Walk
    }

    /// Each search ends with its first evolution.
    #[must_use]
    pub fn evolves_once(&self) -> bool {
        self.search == Search::Once
    }

    /// A search without end takes its last evolution back.
    #[must_use]
    pub fn takes_back(&self) -> bool {
        self.search == Search::Bounded(Undo::PutBack)
    }

    /// The evolution is a function of its own, so that a search without end can try another one on a copy.
    #[must_use]
    pub fn evolves_apart(&self) -> bool {
        self.search == Search::Bounded(Undo::Copy)
    }
}

/// Whether nothing but a change of the situation makes a search go on: no collected place, no call that is due (A25).
fn changes_only_situation(model: &Model, plan: &Known<'_>) -> bool {
    let calls = |effect: &Effect| matches!(effect, Effect::Call(..));
    plan.stored.collected.is_empty()
        && !model.associations.values().any(|a| a.qualifier == Qualifier::On && calls(&a.effect))
        && !model.transitions.values().any(|transition| transition.clearing.iter().any(calls))
}

fn form(model: &Model, plan: &Known<'_>, only_situation: bool) -> Form {
    if plan.regions.are_flags() {
        return Form::Flags;
    }
    if is_sequence(model, plan, only_situation) {
        return Form::Program;
    }
    // Where a search may have no end, the last evolution is tried on a copy of the chart, or taken back (A30); what else an
    // evolution reads and writes would have to be copied too.
    let copies = only_situation && plan.memory.edges.is_empty() && plan.memory.combinational.is_empty();
    if plan.nests && (!plan.may_be_unstable || copies) { Form::InPlace } else { Form::Compared }
}

/// One region, each transition from one step to one, and in a `grafcet` no change but that of the situation.
fn is_sequence(model: &Model, plan: &Known<'_>, only_situation: bool) -> bool {
    let moves = || model.transitions.values().any(|t| t.sources != t.targets);
    let search = || only_situation && moves() && plan.evolution.exclusive.iter().all(|exclusive| *exclusive);
    plan.regions.is_single()
        && model.partials.len() == 1
        && (!model.is_grafcet() || search())
        && plan.evolution.entered_last.is_empty()
        && model.transitions.values().all(|t| t.sources.len() == 1 && t.targets.len() == 1)
}

/// Whether enough steps of a sequence, two of three, have but one transition.
fn is_long(model: &Model, plan: &Known<'_>) -> bool {
    let Some(region) = plan.regions.all().first() else { return false };
    let exits = || region.steps.iter().filter(|step| plan.evolution.only_exit(model, **step).is_some()).count();
    region.steps.len() >= LONG && !region.may_be_empty && exits() >= LONG.max(region.steps.len() * 2 / 3)
}

/// Whether a long sequence is as small by way of a program, which has one table, that of the next steps, and this where each step has one
/// transition. Where something reads a time it was in all that were measured: arms that ask whether the same time is over are one.
fn suits_program(model: &Model, evolution: &Evolution) -> bool {
    let has_one = |step| evolution.only_exit(model, step).is_some();
    let is_table = || !copies_few(model, evolution) && model.steps.ids().all(has_one);
    !model.optimize_size && (model.uses_time() || is_table())
}

/// Whether a few steps of a long sequence wait for something that no other one waits for. LLVM copies the actions of such a step
/// after its test, unless a table says which test it is. The table costs a byte a step and four instructions a cycle: with one such
/// step in five it saved an eighth of the flash (Seq64), with one in four half of that, with nearly each other one none.
fn copies_few(model: &Model, evolution: &Evolution) -> bool {
    let (mut alone, mut shared) = (0, Map::<Tree, usize>::new());
    for step in model.steps.ids() {
        match evolution.waits_for(model, step) {
            None => alone += 1,
            Some(Tree::Bool(true)) => {}
            Some(condition) => *shared.or_default(condition) += 1,
        }
    }
    alone += shared.values().filter(|steps| **steps == 1).count();
    alone > 0 && alone * ALONE <= model.steps.len()
}

impl Evolution {
    /// The transition of a step that has but one, which does nothing but lead to another step.
    #[must_use]
    pub fn only_exit(&self, model: &Model, step: StepId) -> Option<TransitionId> {
        let [id] = self.owned[step.index()][..] else { return None };
        let transition = &model.transitions[id];
        (transition.clearing.is_empty() && transition.sources != transition.targets).then_some(id)
    }

    /// What a step with such a transition waits for: the same for steps that say the same of themselves, as `5s/Heat` in `Heat`
    /// and `5s/Cool` in `Cool`.
    #[must_use]
    pub fn waits_for(&self, model: &Model, step: StepId) -> Option<Tree> {
        let exit = self.only_exit(model, step)?;
        Some(model.transitions[exit].condition.tree.renamed(step, StepId::new(model.steps.len())))
    }

    /// Whether a transition leads from a step to another one.
    #[must_use]
    pub fn leads_on(&self, model: &Model, step: StepId) -> bool {
        let mut transitions = self.owned[step.index()].iter().map(|id| &model.transitions[*id]);
        transitions.any(|transition| transition.sources != transition.targets)
    }
}
