//! How the clocks of properties and those of steps go together: IC3 sees single bits, and would look for that value by value.
//!
//! It may never be waited for in a step; and where it is, its clock may be behind that of the step all the time, or ahead of it by no more than
//! the steps before it take. All such sentences are candidates; those that the others do not make certain of the next cycle go, until none does (Houdini). What is left holds always.

use std::collections::BTreeSet;

use grafcet_compiler::model::{Id, Model, Read, StepId, TimeRef};
use grafcet_compiler::program::{Program, Role};

use crate::aig::{Aig, Lit};
use crate::bits;
use crate::certificate;
use crate::circuit::{Circuit, Condition, Deadline, Field, Latch};
use crate::limit::{At, Limit, Over};
use crate::sat::{Sat, Term, Wires};

/// So many candidates, and no more.
const MOST: usize = 400;

/// A sentence about the latches, at the beginning of a cycle and at the beginning of the next one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lemma {
    pub now: Lit,
    pub next: Lit,
    pub about: About,
}

/// What it says, and of which step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct About {
    pub region: usize,
    /// None where no step of the region is active.
    pub step: Option<StepId>,
    pub relation: Relation,
    /// The region has a clock of its own; without one the deadline's is meant.
    pub has_clock: bool,
}

/// The circuit in which it is known, of all cycles, how this deadline's clock goes with those of the steps.
///
/// # Errors
/// The limit is reached.
pub(crate) fn strengthened(
    program: &Program<'_>,
    circuit: &Circuit,
    deadline: Deadline,
    limit: &Limit,
) -> Result<(Circuit, Vec<About>), Over> {
    limit.tell(At::Lemmas);
    let mut circuit = circuit.clone();
    let mut lemmas = candidates(program, &mut circuit, deadline);
    lemmas.truncate(MOST);
    let of = |lemma: &Lemma| Condition { now: lemma.now, end: lemma.next };
    let left = always(&circuit, &lemmas.iter().map(of).collect::<Vec<_>>(), limit)?;
    let mut lemmas: Vec<Lemma> = left.into_iter().map(|index| lemmas[index]).collect();
    let both: Vec<Condition> = lemmas.iter().map(of).collect();
    if !assume(&mut circuit, &both, limit)? {
        lemmas.clear();
    }
    Ok((circuit, lemmas.iter().map(|lemma| lemma.about).collect()))
}

/// What may be so of a step, or of it while something is waited for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Relation {
    Inactive,
    /// Something is waited for, always.
    Active,
    /// It is not active before the first cycle.
    Later,
    /// Its clock stays below this.
    Below(u32),
    /// The deadline's clock is so far ahead of the step's, at most.
    Behind(u32),
    /// It is not after.
    Ahead,
}

/// The candidates for a step: what its own conditions and those on the way to it say of times.
fn relations(model: &Model, step: Option<StepId>, offsets: &[BTreeSet<u32>]) -> Vec<Relation> {
    let mut all = vec![Relation::Inactive, Relation::Active, Relation::Later, Relation::Ahead];
    let Some(step) = step else { return all };
    all.extend(limits(model, step).into_iter().map(Relation::Below));
    all.extend(offsets[step.index()].iter().map(|offset| Relation::Behind(*offset)));
    all
}

/// The times with which conditions that leave a step compare.
pub(crate) fn limits(model: &Model, step: StepId) -> BTreeSet<u32> {
    let time = |read: &Read| match read {
        Read::Ticks(ticks) | Read::Elapsed(TimeRef::Ticks(ticks), _) => Some(*ticks),
        _ => None,
    };
    let leaving = model.leaving[step.index()].iter().flat_map(|id| &model.transitions[*id].condition.reads);
    leaving.filter_map(time).collect()
}

/// So many steps in a row are looked at, and so many offsets for each.
const ROW: usize = 8;

/// By step: by how much a clock that has begun in a step before it may be ahead of its own. A step that is left by a time lasts so long and
/// a cycle more, where it is known how long that is.
fn offsets(model: &Model) -> Vec<BTreeSet<u32>> {
    let mut all = vec![BTreeSet::from([0]); model.steps.len()];
    let Some(cycle) = model.longest_cycle else { return all };
    for _ in 0..ROW {
        let before = all.clone();
        for transition in model.transitions.values() {
            for source in &transition.sources {
                let lasts = limits(model, *source);
                let longer = |offset: &u32| {
                    let offset = *offset;
                    lasts
                        .iter()
                        .map(move |limit| offset.saturating_add(*limit).saturating_add(cycle))
                        .collect::<Vec<_>>()
                };
                let sums: Vec<u32> = before[source.index()].iter().flat_map(longer).collect();
                for target in &transition.targets {
                    let known = &mut all[target.index()];
                    let room = ROW.saturating_sub(known.len());
                    known.extend(sums.iter().take(room));
                }
            }
        }
    }
    all
}

/// Of each step, those of its region that has a clock.
fn candidates(program: &Program<'_>, circuit: &mut Circuit, deadline: Deadline) -> Vec<Lemma> {
    let mut lemmas = of_one(program, None, circuit, deadline);
    for (number, plant) in program.plants.iter().enumerate() {
        lemmas.extend(of_one(plant, Some(number), circuit, deadline));
    }
    lemmas
}

/// The same of the chart alone, or of one of its plants.
fn of_one(program: &Program<'_>, plant: Option<usize>, circuit: &mut Circuit, deadline: Deadline) -> Vec<Lemma> {
    let role = |field: &Field| field.place.filter(|_| field.plant == plant).map(|place| program.places[place.0].role);
    let field = |wanted: Role| circuit.fields.iter().find(|field| role(field) == Some(wanted)).cloned();
    let (timer, first) = (deadline.field(circuit), field(Role::First));
    let mut all = Vec::new();
    for (region, steps) in program.regions.iter().enumerate() {
        // Without a clock of its own it is compared with the deadline's, which says nothing.
        let own = field(Role::Time(region));
        let (has_clock, clock) = (own.is_some(), own.unwrap_or_else(|| timer.clone()));
        let Some(state) = field(Role::State(region)) else { continue };
        let codes = [None].into_iter().chain(steps.iter().copied().map(Some));
        all.extend(
            (0_i128..).zip(codes).map(|(code, step)| (clock.clone(), state.clone(), code, (region, step, has_clock))),
        );
    }
    let offsets = offsets(program.model);
    let mut lemmas = Vec::new();
    for (clock, state, code, (region, step, has_clock)) in all {
        for relation in relations(program.model, step, &offsets) {
            let about = About { region, step, relation, has_clock };
            let mut at = |of: fn(&Latch) -> Lit| {
                let bits = |field: &Field| {
                    let latches = &circuit.latches[field.first..field.first + field.width];
                    bits::unsigned(&latches.iter().map(of).collect::<Vec<Lit>>())
                };
                let (state, timer, clock) = (bits(&state), bits(&timer), bits(&clock));
                let waits = of(&circuit.latches[deadline.waits]);
                let first = first.as_ref().map_or(Lit::FALSE, |field| of(&circuit.latches[field.first]));
                let active = bits::equal(&mut circuit.aig, &state, &bits::constant(code));
                let wrong = wrong(&mut circuit.aig, relation, (waits, first), &timer, &clock);
                !circuit.aig.and(active, wrong)
            };
            lemmas.push(Lemma { now: at(|latch| latch.now), next: at(|latch| latch.next), about });
        }
    }
    lemmas
}

/// Where it is not so.
fn wrong(aig: &mut Aig, relation: Relation, (waits, first): (Lit, Lit), timer: &[Lit], clock: &[Lit]) -> Lit {
    match relation {
        Relation::Inactive => waits,
        Relation::Active => aig.and(!waits, !first),
        Relation::Later => first,
        Relation::Below(limit) => !bits::less(aig, clock, &bits::constant(i128::from(limit))),
        Relation::Behind(offset) => {
            let most = bits::add(aig, clock, &bits::constant(i128::from(offset)));
            let ahead = bits::less(aig, &most, timer);
            aig.and(waits, ahead)
        }
        Relation::Ahead => {
            let behind = bits::less(aig, timer, clock);
            aig.and(waits, behind)
        }
    }
}

/// From here on assumes these of each cycle, if they always hold; whether they do, by the checker of proofs once more: what is wrong here would be a
/// false proof.
///
/// # Errors
/// The limit is reached.
pub(crate) fn assume(circuit: &mut Circuit, all: &[Condition], limit: &Limit) -> Result<bool, Over> {
    let holds = certificate::is_inductive(circuit, all, limit)?;
    for condition in all.iter().filter(|_| holds) {
        circuit.constraint = circuit.aig.and(circuit.constraint, condition.now);
    }
    Ok(holds)
}

/// Those of some conditions that hold wherever a chart begins, and that together go on to hold, by their numbers.
pub(crate) fn always(circuit: &Circuit, all: &[Condition], limit: &Limit) -> Result<Vec<usize>, Over> {
    let (mut sat, mut wires) = (Sat::new(limit), Wires::new(&circuit.aig));
    let (begins, goes_on) = (sat.term(), sat.term());
    for latch in &circuit.latches {
        if let Some(initial) = latch.initial {
            let term = wires.term(&mut sat, &circuit.aig, latch.now.xor(!initial));
            sat.clause(&[!begins, term]);
        }
    }
    let constraint = wires.term(&mut sat, &circuit.aig, circuit.constraint);
    sat.clause(&[!goes_on, constraint]);
    let mut terms = Vec::new();
    for condition in all {
        let now = wires.term(&mut sat, &circuit.aig, condition.now);
        terms.push((now, wires.term(&mut sat, &circuit.aig, condition.end)));
    }
    let mut left: Vec<usize> = (0..all.len()).collect();
    fewer(&mut sat, &mut left, &|index| terms[index].0, &|_| vec![begins])?;
    let here = |left: &[usize]| left.iter().map(|index| terms[*index].0).chain([goes_on]).collect();
    fewer(&mut sat, &mut left, &|index| terms[index].1, &here)?;
    Ok(left)
}

/// Leaves out, model by model, what does not hold where all that is left is assumed as this says.
fn fewer(
    sat: &mut Sat,
    left: &mut Vec<usize>,
    holds: &dyn Fn(usize) -> Term,
    assumed: &dyn Fn(&[usize]) -> Vec<Term>,
) -> Result<(), Over> {
    while !left.is_empty() {
        let ask = sat.term();
        let clause: Vec<Term> = left.iter().map(|index| !holds(*index)).chain([!ask]).collect();
        sat.clause(&clause);
        let mut all = assumed(left);
        all.push(ask);
        if !sat.solve(&all)? {
            return Ok(());
        }
        left.retain(|index| sat.holds(holds(*index)));
        sat.clause(&[!ask]);
    }
    Ok(())
}
