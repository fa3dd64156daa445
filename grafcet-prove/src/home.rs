//! Properties that say to where there is always a way back (`home Rest;`).
//!
//! - A proof: ways to it ([`ways`](crate::ways)), and an invariant by which a chart is never where none of them begins. With several regions
//!   this is proved one after the other: from everywhere to where the first one is at home; from there, to where the second one is, too. So
//!   the ways of one need not know where all the others are.
//! - A counterexample: a way to where none is found, though no more are to be found at all: no cycle leads out of such states.

use grafcet_compiler::program::{Program, Role};
use grafcet_sim::interp::Value;

use crate::aig::{Aig, Lit};
use crate::certificate;
use crate::circuit::{Circuit, Condition, Home, Source};
use crate::exclusions;
use crate::goal::Goal;
use crate::limit::Limit;
use crate::play::Player;
use crate::replay::{Shown, Why};
use crate::simplest::simplest;
use crate::steps::Steps;
use crate::task::{Invariant, Task, Way, cone, entry};
use crate::verdict::{Internal, Judged, OVER, Proof, Verdict, differs, invariant, judge};
use crate::ways::{Leads, Search, Trust, inputs, may};

/// So many cubes for each target, and no more.
const MOST: usize = 4_000;

/// So many by way of where branches meet.
const FEW: usize = 500;

/// Everywhere.
const ANYWHERE: Condition = Condition { now: Lit::TRUE, end: Lit::TRUE };

/// Decides whether there is always a way back, within a limit.
///
/// # Errors
/// A verdict that fails its check.
pub fn decide_home(program: &Program<'_>, circuit: &Circuit, home: &Home, limit: &Limit) -> Result<Verdict, Internal> {
    let mut circuit = circuit.clone();
    // It is a matter of the chart alone.
    circuit.constraint = circuit.without_orders;
    let roots = home.parts.iter().flat_map(|part| [part.now, part.end]).chain([circuit.constraint]);
    let relevant = cone(&circuit, roots.collect());
    let mays = [may(&mut circuit, Trust::Certain), circuit.constraint];
    let Ok(mut steps) = Steps::add(program, &mut circuit, &relevant, limit) else {
        return Ok(Verdict::Undecided(OVER.to_owned()));
    };
    // Latches that have been added are steps.
    let compared: Vec<usize> = relevant.iter().copied().chain(steps.latches()).collect();
    match exclusions::add(&mut circuit, &compared, limit) {
        Ok(known) => steps.known = circuit.aig.and(steps.known, known),
        Err(_) => return Ok(Verdict::Undecided(OVER.to_owned())),
    }
    let circuits = (&mut circuit, &steps);
    // By way of where branches meet, if there are such places; and without.
    let by_meetings = home.meetings.iter().map(|meeting| (&meeting[..], FEW));
    for (via, most) in by_meetings.chain([(&[][..], MOST)]) {
        match chain((&mut *circuits.0, circuits.1), (via, &home.parts), mays[0], (most, limit))? {
            Chained::Always(proof) => {
                let beside = Some(Box::new(circuits.0.clone()));
                return Ok(Verdict::Proved(Proof { beside, ..proof }));
            }
            Chained::Lost(target) => return lost(program, (circuits.0, circuits.1), (target, mays[1]), limit),
            Chained::Open if limit.is_over() => break,
            Chained::Open => {}
        }
    }
    Ok(Verdict::Undecided(OVER.to_owned()))
}

/// What comes of some targets, one after the other.
enum Chained {
    Always(Proof),
    /// There is no certain way to this one, which belongs to home.
    Lost(Condition),
    Open,
}

/// From everywhere to where branches meet, and from there home; in both, more and more of it is so.
fn chain(
    (circuit, steps): (&mut Circuit, &Steps),
    (via, home): (&[Condition], &[Condition]),
    may: Lit,
    (most, limit): (usize, &Limit),
) -> Result<Chained, Internal> {
    let (mut proof, mut from) = (Proof::of(Invariant::default()), ANYWHERE);
    for (is_home, parts) in [(false, via), (true, home)] {
        let mut so_far = ANYWHERE;
        for part in parts {
            let target =
                Condition { now: circuit.aig.and(so_far.now, part.now), end: circuit.aig.and(so_far.end, part.end) };
            match nearer((circuit, steps), (from, target), may, (most, limit))? {
                Nearer::Always(ways, invariant) => {
                    proof.ways.push(ways);
                    proof.invariant.excluded.extend(invariant.excluded);
                }
                Nearer::NotAlways if is_home => return Ok(Chained::Lost(target)),
                // Where branches meet there need not be a way to.
                Nearer::NotAlways | Nearer::Open => return Ok(Chained::Open),
            }
            (so_far, from) = (target, target);
        }
    }
    proof.invariant.excluded.sort_unstable();
    proof.invariant.excluded.dedup();
    Ok(Chained::Always(proof))
}

/// Whether there is always a way to a target from where it is reached in part.
enum Nearer {
    Always(Leads, Invariant),
    /// None that is certain.
    NotAlways,
    Open,
}

fn nearer(
    (circuit, steps): (&Circuit, &Steps),
    (from, target): (Condition, Condition),
    may: Lit,
    (most, limit): (usize, &Limit),
) -> Result<Nearer, Internal> {
    let search = || Search::new((circuit, steps), target, may, Trust::Certain, limit);
    let mut ways = Leads { target, leads: Vec::new() };
    // First cycles in which what is waited for is over, and short ones; and first along states that are where the parts before it are at home.
    let patient = || search().patient();
    let short = [patient().and_then(Search::short), patient(), search().short()].into_iter().flatten();
    let mut insides = vec![from.now, Lit::TRUE];
    insides.dedup();
    let mut searches: Vec<(Search<'_>, Lit)> = short.map(|short| (short, Lit::TRUE)).collect();
    searches.extend(insides.into_iter().map(|inside| (search(), inside)));
    let whole = searches.len() - 1;
    let mut all = false;
    for (number, (search, inside)) in searches.into_iter().enumerate() {
        let mut search = search.knowing(ways);
        let Ok(complete) = search.run(inside, most) else { return Ok(Nearer::Open) };
        all = complete && number == whole;
        ways = search.ways();
        let mut with = circuit.clone();
        let reached = reached(&mut with, &ways).end;
        let bad = with.aig.and(from.end, !reached);
        match invariant(&Task::new(&with, bad), limit) {
            Err(None) => return Ok(Nearer::Open),
            Err(Some(internal)) => return Err(internal),
            Ok(Err(_)) => {}
            Ok(Ok(invariant)) => {
                return match certificate::fault_of_ways(circuit, (steps.known, may), &ways, limit) {
                    Ok(None) => Ok(Nearer::Always(ways, invariant)),
                    Ok(Some(fault)) => Err(Internal(format!("a way home that is none: {fault}"))),
                    Err(_) => Ok(Nearer::Open),
                };
            }
        }
    }
    Ok(if all { Nearer::NotAlways } else { Nearer::Open })
}

/// Where the target is reached, or a way to it is known.
fn reached(circuit: &mut Circuit, ways: &Leads) -> Condition {
    let mut any = ways.target;
    for lead in &ways.leads {
        let latches: Vec<_> =
            lead.cube.iter().map(|code| entry(*code)).map(|(latch, on)| (circuit.latches[latch], on)).collect();
        let of = |aig: &mut Aig, next: bool| {
            latches.iter().fold(Lit::TRUE, |all, (latch, on)| {
                let wire = if next { latch.next } else { latch.now };
                aig.and(all, wire.xor(!on))
            })
        };
        let (now, end) = (of(&mut circuit.aig, false), of(&mut circuit.aig, true));
        any = Condition { now: circuit.aig.or(any.now, now), end: circuit.aig.or(any.end, end) };
    }
    any
}

/// The shortest way to where no way leads to the target, whatever is relied on.
fn lost(
    program: &Program<'_>,
    (circuit, steps): (&Circuit, &Steps),
    (target, may): (Condition, Lit),
    limit: &Limit,
) -> Result<Verdict, Internal> {
    let over = || Ok(Verdict::Undecided(OVER.to_owned()));
    let mut search = Search::new((circuit, steps), target, may, Trust::Possible, limit);
    let Ok(true) = search.run(Lit::TRUE, MOST) else { return over() };
    let ways = search.ways();
    let mut with = circuit.clone();
    let reached = reached(&mut with, &ways);
    match certificate::is_closed(&with, reached.now, limit) {
        Ok(true) => {}
        Ok(false) => return Err(Internal("a state without a way home that has one".to_owned())),
        Err(_) => return over(),
    }
    let bad = with.aig.and(!reached.end, !overflowed(&with));
    match judge(&with, bad, limit) {
        Err(None) => over(),
        Err(Some(internal)) => Err(internal),
        Ok(Judged::Holds(_)) => Ok(Verdict::Undecided(relied_on(program, circuit, target))),
        Ok(Judged::Fails(way)) => {
            let is_lost = |way: &Way, shown: &[Shown]| is_lost(program, &with, (bad, reached.now), way, shown);
            match simplest(program, circuit, &Goal::Anywhere, &way, &is_lost) {
                Ok(shown) => Ok(Verdict::Violated(shown)),
                Err(Why::NotUnderstood(what)) => Ok(Verdict::Undecided(format!(
                    "a way to where it may be lost depends on what is not looked into: {what}"
                ))),
                Err(Why::Differs(what)) => differs(circuit, what),
            }
        }
    }
}

/// Arithmetic has left its type up to the end of the cycle.
fn overflowed(circuit: &Circuit) -> Lit {
    let field = circuit.fields.iter().find(|field| field.place.is_none() && field.name == "overflowed");
    field.map_or(Lit::FALSE, |field| circuit.latches[field.first].next)
}

/// What a way home would have to rely on.
fn relied_on(program: &Program<'_>, circuit: &Circuit, target: Condition) -> String {
    let roots = vec![target.now, target.end, circuit.constraint];
    let wires: Vec<Lit> =
        cone(circuit, roots.clone()).into_iter().map(|latch| circuit.latches[latch].next).chain(roots).collect();
    let seen = circuit.aig.cone(&wires);
    let open = inputs(circuit).1;
    let decides = |bit: &Lit| open.contains(bit) && seen.binary_search(&bit.node()).is_ok();
    let mut texts: Vec<String> = Vec::new();
    for wire in circuit.inputs.iter().filter(|wire| wire.bits.iter().any(decides)) {
        let Source::Rust(_) = &wire.source else { continue };
        let text = format!("`{}`", crate::play::wire_name(program, wire));
        if !texts.contains(&text) {
            texts.push(text);
        }
    }
    if texts.is_empty() {
        "it depends on arithmetic that leaves its type, which panics with overflow checks".to_owned()
    } else {
        format!("a way home may rely on what is not looked into: {}", texts.join(", "))
    }
}

/// Whether the circuit, run on a way, ends where it is lost, and so does the interpreter.
fn is_lost(
    program: &Program<'_>,
    circuit: &Circuit,
    (bad, leads_home): (Lit, Lit),
    way: &Way,
    shown: &[Shown],
) -> bool {
    let mut player = Player::beginning(circuit, &way.initial);
    for on in &way.inputs {
        player.cycle_on(on);
        if !player.holds(circuit.constraint) {
            return false;
        }
    }
    let Some(end) = shown.last() else { return false };
    let is_there = player.holds(bad)
        && circuit.fields.iter().filter(|field| field.plant.is_none()).all(|field| {
            let Some(place) = field.place else { return true };
            let held = player.field(field);
            match program.places[place.0].role {
                Role::State(region) => {
                    let steps = &program.regions[region];
                    let is = |step: usize| i128::try_from(step + 1) == Ok(held);
                    steps.iter().enumerate().all(|(number, step)| {
                        let name = program.model.steps[*step].name.to_string();
                        end.active.iter().any(|active| active == name.trim_start_matches("r#")) == is(number)
                    })
                }
                Role::Var(id) => match end.vars.get(grafcet_compiler::model::Id::index(id)) {
                    Some(Value::Bool(value)) => i128::from(*value) == held,
                    Some(Value::Int(value)) => *value == held,
                    _ => true,
                },
                _ => true,
            }
        });
    // In the state as it then is, not as the circuit foretells it.
    player.cycle_on(&[]);
    is_there && !player.holds(leads_home)
}
