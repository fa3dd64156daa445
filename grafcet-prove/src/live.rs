//! Properties about what comes some time (`a leads_to b;`).
//!
//! - A proof: between `a` and `b` what is assumed to come again and again comes, all of it, at most so many times (k-liveness). That is a
//!   property of the ends of cycles, so IC3 decides it; as the bound rises, it becomes true where `b` always comes.
//! - A counterexample: cycles that lead back to where they began, in which `a` has held, all of that comes, and `b` does not. The state
//!   with which they begin is kept in latches beside the chart's.
//!
//! Time passes, without end. So every value that time alone raises ends at its highest, or is set back: each of them is something that
//! comes again and again, too, which no search has to find out tick by tick.

use grafcet_compiler::program::{Program, Type};

use crate::aig::{Aig, Lit};
use crate::bits;
use crate::bmc::Unrolled;
use crate::certificate;
use crate::circuit::{Circuit, Field, Latch, Live, Source, Wire};
use crate::goal::Goal;
use crate::limit::Limit;
use crate::pdr::{Answer, Pdr};
use crate::replay::{self, Why};
use crate::task::{Task, Way, cone};
use crate::verdict::{Internal, OVER, Proof, Verdict, differs};

/// So many steps of the solver for the first bound; twice as many for each next one.
const FIRST_STEPS: u64 = 5_000;

/// So many cycles are looked at before the first bound is tried.
const CYCLES: usize = 8;

/// And so many more before each next one. Cycles that come again and again are hard to look for where there are none, so that a proof with a small
/// bound comes first; a way is mostly short.
const MORE_CYCLES: [usize; 4] = [1, 1, 2, 4];

/// Decides a property about what comes some time, within a limit.
///
/// # Errors
/// A verdict that fails its check.
pub fn decide_live(program: &Program<'_>, circuit: &Circuit, live: Live, limit: &Limit) -> Result<Verdict, Internal> {
    let Some(goal) = Goal::of(&program.model.properties[live.property].claim) else {
        return Ok(Verdict::Undecided("it is not about cycles".to_owned()));
    };
    let lasso = Lasso::new(circuit, live);
    let task = Task::new(&lasso.circuit, lasso.bad);
    let mut unrolled = Unrolled::new(&task, limit);
    let (mut bound, mut steps) = (1, FIRST_STEPS);
    let mut more = std::iter::once(CYCLES).chain(MORE_CYCLES);
    loop {
        for _ in 0..more.next().unwrap_or(CYCLES) {
            match unrolled.cycle() {
                Ok(Some(way)) => return shown(program, circuit, &goal, &lasso, &way),
                Ok(None) => {}
                Err(_) => return Ok(Verdict::Undecided(OVER.to_owned())),
            }
        }
        if let Some(proof) = proof(program, circuit, live, bound, &limit.part(steps))? {
            return Ok(Verdict::Proved(proof));
        }
        if limit.is_over() {
            return Ok(Verdict::Undecided(OVER.to_owned()));
        }
        (bound, steps) = (bound * 2, steps * 2);
    }
}

/// That the chart waits for less than so many rounds; none where that is not so, or not found out.
fn proof(
    program: &Program<'_>,
    circuit: &Circuit,
    live: Live,
    bound: usize,
    limit: &Limit,
) -> Result<Option<Proof>, Internal> {
    let (rounds, bad) = rounds(program, circuit, live, bound);
    let task = Task::new(&rounds, bad);
    let Ok(Answer::Holds(invariant)) = Pdr::new(&task, limit).run() else { return Ok(None) };
    match certificate::fault(&task, &invariant, limit) {
        Ok(None) => Ok(Some(Proof { beside: Some(Box::new(rounds.clone())), ..Proof::of(invariant) })),
        Ok(Some(fault)) => Err(Internal(format!("a proof that is none: {fault}"))),
        Err(_) => Ok(None),
    }
}

/// The circuit that counts, while the chart waits, how often everything that comes again and again has come; and where that is as often
/// as the bound.
fn rounds(program: &Program<'_>, circuit: &Circuit, live: Live, bound: usize) -> (Circuit, Lit) {
    let mut circuit = circuit.clone();
    let often = [circuit.often.clone(), times(program, &mut circuit)].concat();
    let aig = &mut circuit.aig;
    let still = aig.and(live.waits.now, live.waits.next);
    let (mut all, mut seen) = (Lit::TRUE, Vec::new());
    for comes in often {
        let now = aig.free();
        let has = aig.or(now, comes);
        all = aig.and(all, has);
        seen.push((now, has));
    }
    let all = aig.and(still, all);
    let mut latches = Vec::new();
    for (now, has) in seen {
        let kept = aig.and(still, has);
        latches.push(Latch { now, next: aig.and(kept, !all), initial: Some(false) });
    }
    extend(&mut circuit, "seen", latches);
    let (mut before, mut counted) = (Lit::TRUE, Vec::new());
    for _ in 1..bound {
        let now = circuit.aig.free();
        let more = circuit.aig.and(all, before);
        let reached = circuit.aig.or(now, more);
        counted.push(Latch { now, next: circuit.aig.and(still, reached), initial: Some(false) });
        before = now;
    }
    extend(&mut circuit, "rounds", counted);
    let bad = circuit.aig.and(all, before);
    (circuit, bad)
}

pub(crate) fn extend(circuit: &mut Circuit, name: &str, latches: Vec<Latch>) {
    if latches.is_empty() {
        return;
    }
    let (first, width) = (circuit.latches.len(), latches.len());
    circuit.fields.push(Field { place: None, plant: None, name: name.to_owned(), first, width, signed: false });
    circuit.latches.extend(latches);
}

/// Of each value that time raises: it is as high as it gets, it has been set back, or it stands still while time passes.
fn times(program: &Program<'_>, circuit: &mut Circuit) -> Vec<Lit> {
    let Some(elapsed) = circuit.inputs.iter().find(|wire| wire.source == Source::Elapsed).cloned() else {
        return Vec::new();
    };
    let is_time = |field: &&Field| match field.place {
        Some(place) => matches!(field.program(program).places[place.0].ty, Type::Ticks),
        None => circuit.timers.iter().any(|timer| timer.first == field.first),
    };
    let fields: Vec<Field> = circuit.fields.iter().filter(is_time).cloned().collect();
    let mut all = Vec::new();
    for field in fields {
        let latches = &circuit.latches[field.first..field.first + field.width];
        let (now, next): (Vec<Lit>, Vec<Lit>) = latches.iter().map(|latch| (latch.now, latch.next)).unzip();
        let aig = &mut circuit.aig;
        let highest = next.iter().fold(Lit::TRUE, |all, bit| aig.and(all, *bit));
        let (now, next) = (bits::unsigned(&now), bits::unsigned(&next));
        let back = bits::less(aig, &next, &now);
        let same = bits::equal(aig, &next, &now);
        let passes = any(aig, &elapsed.bits);
        let stands = aig.and(same, passes);
        let ends = aig.or(highest, back);
        all.push(aig.or(ends, stands));
    }
    all
}

fn any(aig: &mut Aig, lits: &[Lit]) -> Lit {
    lits.iter().fold(Lit::FALSE, |any, lit| aig.or(any, *lit))
}

/// The circuit in which one cycle is chosen, to whose beginning later ones lead back.
pub(crate) struct Lasso {
    pub(crate) circuit: Circuit,
    /// Where the cycle is chosen, the first time.
    choose: Lit,
    pub(crate) bad: Lit,
}

impl Lasso {
    pub(crate) fn new(circuit: &Circuit, live: Live) -> Self {
        let mut lasso = circuit.clone();
        let roots = [&[live.waits.now, live.waits.next, live.broken, circuit.constraint], &circuit.often[..]].concat();
        let relevant = cone(circuit, roots);
        let aig = &mut lasso.aig;
        let (choose, chosen) = (aig.free(), aig.free());
        lasso.inputs.push(Wire { source: Source::Again, bits: vec![choose] });
        let goes = aig.or(chosen, choose);
        let first = aig.and(choose, !chosen);
        let mut latches = vec![Latch { now: chosen, next: goes, initial: Some(false) }];
        let mut bad = aig.and(goes, !live.broken);
        let mut keep = |now: Lit, next: Lit| latches.push(Latch { now, next, initial: Some(false) });
        // It waits in all of these cycles, from before the first one on.
        let waited = aig.free();
        let before = aig.or(first, waited);
        let still = aig.and(live.waits.now, live.waits.next);
        let waits = aig.and(before, still);
        keep(waited, waits);
        bad = aig.and(bad, waits);
        for comes in &circuit.often {
            let now = aig.free();
            let has = aig.or(now, *comes);
            let has = aig.and(goes, has);
            keep(now, has);
            bad = aig.and(bad, has);
        }
        for index in relevant {
            let (latch, now) = (circuit.latches[index], aig.free());
            let kept = aig.mux(first, latch.now, now);
            keep(now, kept);
            let same = aig.iff(latch.next, kept);
            bad = aig.and(bad, same);
        }
        extend(&mut lasso, "again", latches);
        Self { circuit: lasso, choose, bad }
    }
}

/// The way with the cycles that come again and again, as the interpreter goes it.
pub(crate) fn shown(
    program: &Program<'_>,
    circuit: &Circuit,
    goal: &Goal<'_>,
    lasso: &Lasso,
    way: &Way,
) -> Result<Verdict, Internal> {
    let chosen = |on: &Vec<usize>| on.binary_search(&lasso.choose.node()).is_ok();
    let Some(again) = way.inputs.iter().position(chosen) else {
        return Err(Internal("cycles that come again and again, and do not begin".to_owned()));
    };
    match replay::endless(program, circuit, goal, way, again) {
        Ok(way) => Ok(Verdict::Endless { way, again }),
        Err(Why::NotUnderstood(what)) => {
            Ok(Verdict::Undecided(format!("a way that may break it depends on what is not looked into: {what}")))
        }
        Err(Why::Differs(what)) => differs(circuit, what),
    }
}
