//! The rules: each pass looks at the model and the facts about it, and reports.

mod assumptions;
mod branches;
mod conditions;
mod contention;
mod continuous;
mod derives;
mod drawing;
mod events;
mod initial;
mod modes;
mod properties;
mod race;
mod reach;
mod rivals;
mod safety;
mod set_reset;
mod silent;
mod structure;
mod targets;
mod unstable;
mod usage;
mod waits;

pub use initial::initial_values;

use self::silent::{Silent, Told};

use crate::analysis::explore::{Exploration, Limits};
use crate::analysis::{Facts, Logic, Races, mixed};
use crate::diagnostic::{Sink, rules};
use crate::list::List;
use crate::model::{Model, Name, Read, Tree};

/// The rules that need no more than the drawing itself; most hold on a chart with unresolved parts too.
pub fn drawing(model: &Model, sink: &mut Sink) {
    drawing::check(model, sink);
    targets::check(model, sink);
    modes::check(model, sink);
    derives::check(model, sink);
    if !model.incomplete {
        assumptions::check(model, sink);
    }
    if model.is_grafcet() && !model.incomplete {
        structure::check(model, sink);
        continuous::check(model, sink);
        events::check(model, sink);
    }
}

/// The rules that look at how the chart evolves; only for charts whose drawing is in order. Returned are the races that were
/// found, whatever the chart says of them: they are facts for the plan too.
pub fn evolution(model: &Model, facts: &Facts<'_>, sink: &mut Sink) -> Races {
    let (never, independent) = (&facts.never[..], &facts.assumed);
    let concurrency = independent.across_partials(model);
    let logic = Logic::within(model, &concurrency, never);
    // Of these it has been said that they make no sense.
    let mixed = mixed(model);
    let limits = model.budget.map_or_else(Limits::default, Limits::situations);
    let (exploration, aways) = properties::check(model, &logic, limits, never, sink);
    let conditions: Vec<_> = model.transitions.values().map(|t| logic.condition(&t.condition.tree)).list();
    let conditions::Said { never: mut said, always } = conditions::check(model, &logic, &conditions, sink);
    // What the exploration has seen to be apart is no conflict. In an `sfc` the steps before and behind an evolution act
    // in the same cycle, so that steps can race which are never active together.
    let seen = concurrency.without(|a, b| !exploration.together(a, b));
    let racing = if model.is_grafcet() { &seen } else { &concurrency };
    let mut dead = reach::idle(model, &exploration);
    dead.extend(&said);
    let branches =
        branches::Branches { model, concurrency: &seen, logic: &logic, conditions: &conditions, always: &always };
    if sink.broke(&rules::READS_CONTINUOUS) {
        // Such a condition is not the one that is meant.
        let reads_output = |read: &Read| matches!(read, Read::Name(Name::Output(_)));
        let unclear = model.transitions.iter().filter(|(_, t)| t.condition.reads.iter().any(reads_output));
        dead.extend(unclear.map(|(id, _)| id));
    }
    said.extend(branches.check(&dead, sink));
    let mut told = Told::default();
    let mut dead = reach::check(model, independent, &exploration, &said, &mut told, sink);
    dead.extend(&said);
    let presumed = branches.presumed_exclusive();
    let partings = if presumed.is_empty() {
        safety::check(model, &exploration, sink)
    } else {
        let never: Vec<&Tree> = never.iter().copied().chain(&presumed).list();
        safety::check(model, &Exploration::assuming(model, &limits, &[], &never), sink)
    };
    let mut stays = waits::check(model, independent, &exploration, &dead, &mut told, sink);
    stays.extend(reach::dead_ends(model, &dead, sink));
    let excuses = properties::Told { stays: &stays, partings: &partings };
    properties::homes(model, (&exploration, limits), &aways, &excuses, never, sink);
    Silent { model, structure: independent, exploration: &exploration }.check(told, sink);
    let races = Races::of(model, racing, &limits, never);
    race::check(model, &races, &mixed, sink);
    contention::check(model, &seen, never, sink);
    if !sink.broke(&rules::WRONG_TARGET) {
        set_reset::check(model, &concurrency, &mixed, sink);
        usage::check(model, sink);
    }
    if model.is_grafcet() {
        structure::two_masters(model, &seen, sink);
        unstable::check(model, &concurrency, never, exploration.settles(), sink);
    }
    races
}
