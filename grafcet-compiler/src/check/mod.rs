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
mod vacuous;
mod waits;

pub(crate) use initial::initial_values;

use crate::analysis::explore::{Exploration, Limits};
use crate::analysis::{Branches, Claims, Constants, Dead, Explained, Facts, Logic, Prover, Races, Rulings, refuted};
use crate::diagnostic::{Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{Model, Name, Read, TransitionId, Tree};
use crate::sorted::Set;

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

/// The rules that look at how the chart evolves; only for charts whose drawing is in order. `prover` is asked for
/// properties that are left open.
pub fn evolution(model: &Model, facts: &Facts<'_>, prover: Option<&Prover>, sink: &mut Sink) {
    let (never, structure, concurrency) = (&facts.never[..], &facts.assumed, facts.across(model));
    let limits = model.budget.map_or_else(Limits::default, Limits::situations);
    let logic = Logic::within(model, concurrency, never);
    let mixed = facts.mixed(model);
    let claims = Claims::of(model, &logic, limits, facts);
    let exploration = &claims.exploration;
    let conditions = model.transitions.values().map(|t| logic.condition(&t.condition.tree)).list();
    let constants = Constants::of(model, &logic, &conditions);
    let dead = Dead::of(model, facts, exploration);
    // What the exploration has seen to be apart is no conflict. In an `sfc` the steps before and after an evolution act
    // in the same cycle, so that steps can race which are never active together.
    let seen = concurrency.without(|a, b| !exploration.together(a, b));
    let racing = if model.is_grafcet() { &seen } else { concurrency };
    let races = Races::of(model, facts, racing, &limits);
    let branches = Branches { model, concurrency: &seen, logic: &logic, conditions: &conditions };
    let rivalry = branches.rivalry(&not_compared(model, &dead, &constants, sink));
    // Of these one of the rules of conditions and branches says that they never clear.
    let mut said = constants.never.clone();
    said.extend(rivalry.shadowed.iter().map(|shadowed| shadowed.id));
    let never_clear: Set<TransitionId> = dead.idle.iter().and(&said).copied().collect();
    let presumed = branches.presumed_exclusive();

    let rulings = Rulings::of(model, &claims, prover, facts);
    properties::check(model, &claims, limits, &rulings, sink);
    let always = conditions::check(model, &logic, &conditions, &constants, sink);
    branches::check(model, &rivalry, &always, sink);
    let mut told = Explained::default();
    reach::check(model, (structure, exploration), &dead, &said, &mut told, sink);
    let partings = if presumed.is_empty() {
        safety::check(model, exploration, sink)
    } else {
        let never: Vec<&Tree> = never.iter().copied().and(&presumed).list();
        safety::check(model, &Exploration::presuming(model, facts, &limits, &[], &never), sink)
    };
    let mut stays = waits::check(model, structure, exploration, &never_clear, &mut told, sink);
    stays.push_all(reach::dead_ends(model, &never_clear, sink));
    let known = properties::Told { stays: &stays, partings: &partings, rulings: &rulings };
    properties::homes(model, &claims, limits, &known, sink);
    silent::check(model, exploration, &dead, told, sink);
    vacuous::check(model, &claims, &rulings, sink);
    let asked = prover.map(|prover| (prover, facts));
    race::check(model, &refuted::left(model, &races, mixed, asked), mixed, sink);
    contention::check(model, &seen, never, sink);
    if !sink.broke(&rules::WRONG_TARGET) {
        set_reset::check(model, concurrency, mixed, sink);
        usage::check(model, sink);
    }
    if model.is_grafcet() {
        structure::two_masters(model, &seen, sink);
        unstable::check(model, facts, exploration, asked, sink);
    }
}

/// What a chart claims together with its plants, which is for the prover alone.
pub fn with_plants(model: &Model, facts: &Facts<'_>, prover: Option<&Prover>, sink: &mut Sink) {
    properties::with_plants(model, prover.map(|prover| (prover, facts)), sink);
}

/// Transitions that no branch is compared with: they never clear, or their condition is not the one that is meant.
fn not_compared(model: &Model, dead: &Dead<'_>, constants: &Constants, sink: &Sink) -> Set<TransitionId> {
    let mut left_out: Set<TransitionId> = dead.idle.iter().and(&constants.never).copied().collect();
    if sink.broke(&rules::READS_CONTINUOUS) {
        let reads_output = |read: &Read| matches!(read, Read::Name(Name::Output(_)));
        let unclear = model.transitions.iter().filter(|(_, t)| t.condition.reads.iter().any(reads_output));
        left_out.extend(unclear.map(|(id, _)| id));
    }
    left_out
}
