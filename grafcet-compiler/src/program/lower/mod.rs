//! From the model to the naive program: a paragraph of `docs/semantics.md`, a function.
//!
//! It copies the situation, decides every transition on the copy, and writes what follows. Nothing here thinks of cost.
//!
//! - `places`: what is stored
//! - `clocks`, `changes`: which times are counted, which are readings of the clock; with what they are compared
//! - `periods`: of what blinks, how its time is kept short
//! - `view`: what an expression reads, at each moment of the cycle
//! - `time`, `sample`, `delays`: times that pass and begin; edges, delays and combinational variables
//! - `decide`: which transitions clear
//! - `sfc`, `control`, `timers`, `runs`: IEC 61131-3, one evolution and `ACTION_CONTROL`
//! - `grafcet`, `hierarchy`, `stored`, `continuous`: IEC 60848, the search for stability
//! - `forced`: the cycle that leads into a situation by hand
//! - `deadline`: until when nothing changes

mod changes;
mod clocks;
mod continuous;
mod control;
mod deadline;
mod decide;
mod delays;
mod forced;
mod grafcet;
mod hierarchy;
mod periods;
mod places;
mod runs;
mod sample;
mod sfc;
mod stored;
mod time;
mod timers;
mod view;

use std::fmt;

use super::{PlaceId, PlaceInfo, Program, Regions, Search, Statement};
use crate::analysis::{EdgeEnd, Facts, Relation, combinational, hierarchy::masters};
use crate::list::List;
use crate::model::{Blinker, Effect, Id, Model, PartialId, Place, Qualifier, StepId, Ty};
use crate::sorted::Set;

use clocks::Clock;
use periods::Periods;
use places::{Delays, Edges, Phases};

/// What has no program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Refused {
    /// Partial grafcets that force or enclose each other (A14), or combinational variables that depend on each other (A22).
    Circle,
    /// A qualifier with a target that the dialect does not have (A32): of this step.
    Target(String),
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Circle => f.write_str("something depends on itself"),
            Self::Target(step) => write!(f, "an action of step {step} has a qualifier that it cannot have"),
        }
    }
}

/// The program of a chart that has passed the checks.
///
/// # Errors
/// The chart has not passed them.
pub fn naive<'m>(model: &'m Model, facts: &Facts<'_>) -> Result<Program<'m>, Refused> {
    in_regions(model, facts, &Regions::of(model, &facts.concurrency, &facts.initial))
}

/// The same, whose regions are known.
pub(super) fn in_regions<'m>(model: &'m Model, facts: &Facts<'_>, regions: &Regions) -> Result<Program<'m>, Refused> {
    program(model, facts, regions, Clocks::Read)
}

/// The same for a reader that has no clock, such as a circuit: times are counted, and a bound stands at every search. Its plants have
/// programs of their own.
///
/// # Errors
/// The chart has not passed the checks.
pub fn counted<'m>(model: &'m Model, facts: &Facts<'_>) -> Result<Program<'m>, Refused> {
    let counted = |model, facts: &Facts<'_>| {
        program(model, facts, &Regions::of(model, &facts.concurrency, &facts.initial), Clocks::Counted)
    };
    let mut all = counted(model, facts)?;
    for plant in &model.plants.list {
        all.plants.push(counted(&plant.model, &Facts::of(&plant.model))?);
    }
    Ok(all)
}

/// Whether a time may be the reading at which it began.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Clocks {
    Read,
    Counted,
}

fn program<'m>(model: &'m Model, facts: &Facts<'_>, regions: &Regions, clocks: Clocks) -> Result<Program<'m>, Refused> {
    possible(model, facts)?;
    let mut lower = Lower::new(model, regions, facts, clocks);
    let Cycles { own: cycle, forced } = if model.is_grafcet() { lower.search_cycle() } else { lower.scan_cycle() };
    let deadline = lower.deadline();
    let regions: Vec<Vec<StepId>> = regions.all().iter().map(|region| region.steps.clone()).list();
    let full = lower.regions.all().iter().map(|region| !region.may_be_empty).list();
    let beside = if regions.len() > 1 { facts.concurrency.relation().clone() } else { Relation::new(0) };
    let searches = facts.searches(model);
    let mut excluding = Vec::new();
    if regions.len() == 1 {
        for (leaving, exclusive) in model.leaving.iter().zip(facts.exclusive(model)) {
            if *exclusive && leaving.len() > 1 {
                excluding.push(leaving.iter().map(|id| lower.clears[id.index()]).list());
            }
        }
    }
    let search = Search {
        comes_back: searches.comes_back,
        ends: searches.ends.steps().clone(),
        is_one_evolution: searches.ends.always(),
        excluding,
    };
    let phases = lower.phases.iter().map(Phases::steps).list();
    Ok(Program {
        model,
        places: lower.places,
        regions,
        full,
        beside,
        meetings: Vec::new(),
        united: Vec::new(),
        search,
        phases,
        cycle,
        forced,
        plants: Vec::new(),
        deadline,
    })
}

/// The cycle of a chart, and the one that is forced, where the chart has it.
struct Cycles<'m> {
    own: Vec<Statement<'m>>,
    forced: Option<Vec<Statement<'m>>>,
}

/// What is made for one chart, and what is known about it meanwhile.
struct Lower<'r, 'm> {
    model: &'m Model,
    regions: &'r Regions,
    initial: Set<StepId>,
    /// The partial grafcets, each after those that act on it.
    partials: Vec<PartialId>,
    places: Vec<PlaceInfo<'m>>,
    first: PlaceId,
    /// By region: its state, and that before the evolution.
    state: Vec<PlaceId>,
    was: Vec<PlaceId>,
    /// The same of the situation that is asked for by hand, in a chart that takes one.
    asked: Vec<PlaceId>,
    clocks: Clocks,
    /// By region, where it counts: the time, and that reached before the evolution of an `sfc` (A34).
    time: Vec<Option<Clock>>,
    reached: Vec<Option<PlaceId>>,
    /// The same by macro-step.
    macro_time: Vec<Option<Clock>>,
    macro_reached: Vec<Option<PlaceId>>,
    phases: Vec<Phases>,
    /// By region, whether none of its steps blinks in two ways, so that one phase is enough.
    common_phase: Vec<bool>,
    /// Of the steps whose time tells how far a period is.
    periods: Vec<Periods>,
    /// The longest time that each is compared with.
    longest: Vec<(Blinker, u32)>,
    /// The times that can be over while their step stays active.
    outlasted: Set<(Blinker, u32)>,
    /// By region, whether such a time is over for the active step, where that is remembered.
    passed: Vec<Option<PlaceId>>,
    /// Since the cycle before, where something counts it.
    elapsed: Option<PlaceId>,
    reading: Option<PlaceId>,
    settled: Option<PlaceId>,
    /// By edge, what may happen because it is gone.
    edge_ends: Vec<EdgeEnd>,
    /// `sfc`: a block or an assignment has begun or ended; in a chart that uses time.
    turned: Option<PlaceId>,
    /// A block of the user that is not looked into has run, or an action was called: nobody sees what it has changed. In a chart that uses
    /// time.
    opaque_ran: Option<PlaceId>,
    /// The timers of action controls.
    timers: Vec<timers::Timer<'m>>,
    /// What a block writes, and whether it has: by the place it is for.
    own: Vec<(PlaceId, PlaceId, PlaceId)>,
    /// By edge, where it is asked for: in conditions, and in the actions of an `sfc`.
    edges: Vec<Option<Edges>>,
    action_edges: Vec<Option<Edges>>,
    delays: Vec<Delays>,
    outputs: Vec<PlaceId>,
    /// By output: what the cycle before returned, where an action of an `sfc` reads it.
    last_outputs: Vec<Option<PlaceId>>,
    vars: Vec<PlaceId>,
    params: Vec<PlaceId>,
    /// By variable, where it is one.
    combinational: Vec<Option<PlaceId>>,
    /// By transition and by `any`: whether it clears.
    clears: Vec<PlaceId>,
    anys: Vec<PlaceId>,
    /// `sfc`, by step: whether it has been left, or entered.
    left: Vec<PlaceId>,
    entered: Vec<PlaceId>,
    /// By partial grafcet below another one: nothing above keeps it from clearing.
    free: Vec<Option<PlaceId>>,
    /// `grafcet`: how many evolutions have changed something.
    evolutions: PlaceId,
    /// Each search is certain to end: no bound stops it (A30).
    search_ends: bool,
    /// One that has made as many evolutions as the bound says goes on for ever.
    comes_back: bool,
    /// After so many evolutions a search is given up.
    bound: u32,
}

/// Whether each search is certain to end, and no value that is stored says of itself that it is another one.
fn ends(model: &Model, facts: &Facts<'_>) -> bool {
    let compared = |ty: &Ty| matches!(ty, Ty::Other(_)) && !ty.is_float();
    let opaque =
        model.outputs.values().any(|output| compared(&output.ty)) || model.vars.values().any(|var| compared(&var.ty));
    !opaque && model.is_grafcet() && !facts.searches(model).may_go_on
}

/// What the rules of the dialect and of the hierarchy exclude.
fn possible(model: &Model, facts: &Facts<'_>) -> Result<(), Refused> {
    let order = &facts.top_down;
    for (index, partial) in order.iter().enumerate() {
        if masters(model, *partial).iter().any(|master| !order[..index].contains(master)) {
            return Err(Refused::Circle);
        }
    }
    let vars = facts.combinational(model);
    for (index, var) in vars.iter().enumerate() {
        if combinational::reads(model, *var).iter().any(|other| vars[index..].contains(other)) {
            return Err(Refused::Circle);
        }
    }
    for association in model.associations.values() {
        use Qualifier::{D, L, N, On, P0, P1, R, S};
        let possible = match (model.is_grafcet(), association.qualifier, &association.effect) {
            (false, On, _) => false,
            (_, P1 | P0 | On, effect) => !matches!(effect, Effect::Control(_)),
            (false, ..) => true,
            (true, S | R, effect) => matches!(effect, Effect::Control(_)),
            (true, N | L | D, effect) => {
                matches!(effect, Effect::Control(_) | Effect::Assign(Place::Output(_), _) | Effect::Call(..))
            }
            (true, ..) => false,
        };
        if !possible {
            return Err(Refused::Target(model.steps[association.step].name.to_string()));
        }
    }
    Ok(())
}
