//! What the machine code will look like: which steps share a byte, which states there are, what is remembered.
//! No tokens yet.

#![allow(missing_docs, reason = "a field says what it holds by its name; a doc is where that is not enough")]

mod acting;
mod branch_group;
mod control;
mod descent;
mod drive;
mod evolution;
mod left_over;
mod memory;
mod regions;
mod shape;
mod stored;

pub use branch_group::BranchGroup;
pub use control::{Control, Target, What, source_order};
pub use descent::Descent;
pub(crate) use descent::{Below, directly, is_top};
pub use drive::Drive;
pub use evolution::Evolution;
pub use memory::{Counted, Memory, Phase};
pub use regions::{Region, RegionId, Regions};
pub use shape::{Form, Search, Shape};
pub use stored::{Stored, is_stored};

use crate::analysis::{Facts, Races};
use crate::model::{Blink, Blinker, Dialect, Effect, Model, Place, Qualifier, Read, StepId, Tree, Ty};
use crate::program::{Program, Refused};
use crate::sorted::Set;

/// The plan for one chart.
pub struct Plan<'m> {
    pub regions: Regions,
    /// The situation is one step: the chart has no parallel branches and never stands without an active step.
    pub one_step: bool,
    /// As many steps as this can be active together, as far as is known.
    pub most_active: usize,
    pub evolution: Evolution,
    /// The form of its code.
    pub shape: Shape,
    /// What its cycle is printed from, where the form is that.
    pub(crate) program: Option<Result<Program<'m>, Refused>>,
    /// How parallel branches evolve in place; `None` where they have to be compared with the situation before.
    pub groups: Option<Vec<BranchGroup>>,
    /// The arms of these branches act, too.
    pub acts_in_arms: bool,
    /// How partial grafcets that evolve in place know what those above them have decided.
    pub descent: Descent,
    /// How each output gets its value, by output.
    pub drives: Vec<Drive>,
    pub control: Control,
    pub stored: Stored,
    pub memory: Memory,
    /// A flag tells `next_deadline` that the last cycle left something to the next one.
    pub flags_left_over: bool,
    /// The active steps of the initial situation.
    pub initial: Set<StepId>,
    /// The first cycle differs from the others, so the state says whether it is still to come.
    pub has_start: bool,
    /// Per region, whether an action can see that a step was left and entered again in one evolution.
    pub sees_reentry: Vec<bool>,
    /// A search for stability may have no end, as far as is known (A30).
    pub may_be_unstable: bool,
    /// After how many evolutions that changed something such a search is given up.
    pub max_evolutions: u32,
    /// `forceable;`: how a cycle is made that leads into a given situation, where no program says it.
    pub forced: Option<Box<Self>>,
}

impl<'m> Plan<'m> {
    /// Plans a chart that has passed all checks; `races` is what they found, which the chart may allow. One that is `recorded` keeps the reading of the clock.
    #[must_use]
    pub fn of(model: &'m Model, facts: &Facts<'_>, races: &Races, recorded: bool) -> Self {
        let mut plan = Self::once(model, facts, races, recorded);
        if model.forceable && plan.shape.form != Form::Program {
            plan.forced = Some(Box::new(Self::once(model, facts, races, recorded).forced(model)));
        }
        plan
    }

    /// The same state, and an evolution whose situation is given: what clears, and where, plays no part.
    fn forced(mut self, model: &Model) -> Self {
        self.stored.collect_all(model);
        self.shape = Shape::forced(self.regions.are_flags());
        self.groups = None;
        self.acts_in_arms = false;
        self
    }

    fn once(model: &'m Model, facts: &Facts<'_>, races: &Races, recorded: bool) -> Self {
        let (concurrency, initial) = (&facts.concurrency, facts.initial.clone());
        let mut regions = Regions::of(model, concurrency, &initial);
        let control = Control::of(model, concurrency);
        let drives = drive::all(model, concurrency, &control);
        let evolution = Evolution::of(model, facts);
        regions.allow_leaving(&evolution.entered_last);
        if model.dialect == Dialect::Sfc && regions.all().len() > 1 {
            // Before the first cycle nothing is active yet: its activation is seen as a change of the situation.
            regions.allow_leaving(&initial);
        }
        // What the chart is from outside does not depend on its encoding.
        let (one_step, most_active) = (regions.is_single(), regions.all().len());
        if model.flags {
            regions = Regions::flags(model, &initial);
        }
        let sees_reentry = sees_reentry(model, &regions, &evolution);
        let stored = Stored::of(model, races);
        let memory = Memory::of(model, &regions, &drives, &control);
        let groups = BranchGroup::all(model, &regions, &evolution, concurrency);
        let descent = Descent::of(model, &regions, concurrency);
        let may_be_unstable = model.is_grafcet() && may_be_unstable(model, &stored, facts);
        let searches = facts.searches(model);
        let known = shape::Known {
            regions: &regions,
            evolution: &evolution,
            memory: &memory,
            stored: &stored,
            descent,
            groups: groups.is_some(),
            may_be_unstable,
            is_lean: false,
        };
        let (shape, program) = known.shaped(model, facts, recorded);
        let flags_left_over = left_over::has_flag(
            model,
            &left_over::Known { memory: &memory, evolution: &evolution, drives: &drives, may_be_unstable },
        );
        let acts_in_arms =
            acting::acts_in_arms(model, &shape, groups.as_deref().unwrap_or_default(), &drives, &control);
        Self {
            flags_left_over,
            acts_in_arms,
            has_start: has_start(model, &initial, &memory),
            memory,
            groups,
            descent,
            shape,
            program,
            one_step,
            most_active,
            sees_reentry,
            may_be_unstable,
            max_evolutions: searches.bound,
            stored,
            regions,
            evolution,
            drives,
            control,
            initial,
            forced: None,
        }
    }
}

/// A4s: in an `sfc`, a step that is left and entered in one cycle is deactivated and activated. In a `grafcet` (A4g)
/// nothing happens to it.
fn sees_reentry(model: &Model, regions: &Regions, evolution: &Evolution) -> Vec<bool> {
    let mut sees = vec![false; regions.all().len()];
    if model.dialect != Dialect::Sfc {
        return sees;
    }
    let timed = |read: &Read| match read {
        Read::Since(step) | Read::Elapsed(_, step) | Read::Blink(Blink { of: Blinker::Step(step), .. }) => Some(*step),
        _ => None,
    };
    let timed: Set<StepId> = model.expressions().into_iter().flatten().filter_map(timed).collect();
    let looks = |step: &StepId| {
        let mut associations = model.steps[*step].associations.iter().map(|id| &model.associations[*id]);
        associations.any(|a| !matches!(a.qualifier, Qualifier::N | Qualifier::S | Qualifier::R)) || timed.contains(step)
    };
    let mut reentered = evolution.entered_last.clone();
    for transition in model.transitions.values() {
        reentered.extend(transition.sources.iter().filter(|step| transition.targets.contains(step)));
    }
    for step in reentered.into_iter().filter(looks) {
        sees[regions.of_step(step)] = true;
    }
    sees
}

/// Whether the first cycle differs from the others.
///
/// In an `sfc` it does not evolve (A27). In a `grafcet` it differs where something happens on the activation of the
/// initial situation, or where something looks at the time or at the evolution before.
fn has_start(model: &Model, initial: &Set<StepId>, memory: &Memory) -> bool {
    // A place that has the value already.
    let has = |place: &Place, value: bool| {
        let init = match place {
            Place::Output(id) => &model.outputs[*id].init,
            Place::Var(id) => &model.vars[*id].init,
        };
        init.as_ref().map_or(!value, |init| init.tree == Tree::Bool(value))
    };
    let acts = |step: StepId| {
        model.steps[step].associations.iter().map(|id| &model.associations[*id]).any(|association| {
            match (association.qualifier, &association.effect) {
                (_, Effect::Call(..)) => true,
                (qualifier, _) if qualifier.is_continuous() => false,
                (Qualifier::S, Effect::Control(place)) => !has(place, true),
                (Qualifier::R, Effect::Control(place)) => !has(place, false),
                _ => true,
            }
        })
    };
    model.dialect == Dialect::Sfc
        || memory.asks_for_start()
        || model.uses_time()
        || initial.iter().any(|step| acts(*step))
}

/// A30: the search may clear in a circle, or store a value that says of itself that it is another one.
fn may_be_unstable(model: &Model, stored: &Stored, facts: &Facts<'_>) -> bool {
    let compared = |place: &Place| matches!(model.place_ty(*place), Ty::Other(_)) && !model.place_ty(*place).is_float();
    stored.collected.iter().any(compared) || facts.searches(model).may_go_on
}
