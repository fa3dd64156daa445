//! From the properties of a chart to verdicts. None is given without its check: a proof goes to [`certificate`], a way to the interpreter.

use grafcet_compiler::model::Claim;
use grafcet_compiler::program::Program;

use crate::aig::Lit;
use crate::bmc;
use crate::certificate;
use crate::circuit::{Bad, Circuit, Deadline, Outside, Source, Timer};
use crate::clocks;
use crate::differences;
use crate::goal::Goal;
use crate::lemmas::{About, strengthened};
use crate::limit::{Limit, Over};
use crate::pdr::{Answer, Pdr};
use crate::replay::{Shown, Why};
use crate::simplest::simplest;
use crate::task::{Invariant, Task, Way};
use crate::ways::Leads;

/// A proof that has been checked.
#[derive(Clone, Debug)]
pub struct Proof {
    pub invariant: Invariant,
    /// The circuit whose invariant it is, where that is not the chart's own.
    pub beside: Option<Box<Circuit>>,
    /// What it knows of the clocks of steps and of the property, beside the invariant.
    pub clocks: Vec<About>,
    /// What else it knows of clocks, in words.
    pub known: Vec<String>,
    /// Of a `home`: the ways back, from everywhere to the steps of one region, from there to those of the next one, too, and so on.
    pub ways: Vec<Leads>,
}

impl Proof {
    /// Of an invariant of the chart's own circuit.
    pub(crate) fn of(invariant: Invariant) -> Self {
        Self { invariant, beside: None, clocks: Vec::new(), known: Vec::new(), ways: Vec::new() }
    }
}

/// What is found out about a property.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// It always holds.
    Proved(Proof),
    /// The shortest way to where it does not, cycle by cycle.
    Violated(Vec<Shown>),
    /// A way of which the cycles from `again` on, counted from zero, come again and again, and what has to come does not.
    Endless { way: Vec<Shown>, again: usize },
    /// And why.
    Undecided(String),
}

/// A verdict that has failed its check: a mistake of this crate, and no verdict.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Internal(pub String);

impl std::fmt::Display for Internal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "internal error of the prover: {}", self.0)
    }
}

impl std::error::Error for Internal {}

/// So many cycles are looked at one by one before anything else: most faults show there, and soon.
pub(crate) const FIRST_CYCLES: usize = 8;

/// Circuits of so many gates are those of long searches; so many steps of the solver for a proof about their evolutions,
/// and no more than half of those that are left.
const LONG_SEARCH: usize = 4_000;
const FOR_EVOLUTIONS: u64 = 1_000_000;

/// So many steps of the solver IC3 takes before it is looked whether a property follows from itself.
const BEFORE_INDUCTION: u64 = 20_000;

/// So many cycles, and no more, from which that is tried; in so many steps.
const DEEPEST: usize = 4;
const FOR_INDUCTION: u64 = 20_000;

/// So many steps of the solver are taken before it is looked for how clocks go together.
const ALONE: u64 = 10_000;

/// So many before it is looked for how far they are apart, which takes longer.
const BEFORE_SUMS: u64 = 100_000;

/// What is said where the limit is reached.
pub(crate) const OVER: &str = "the solver was stopped at its limit";

/// What is said where no way that breaks a property is certain.
pub(crate) fn uncertain(circuit: &Circuit) -> String {
    let mut texts: Vec<&str> = Vec::new();
    for wire in &circuit.inputs {
        let Source::Rust(Outside { text, can_be_asked: true, .. }) = &wire.source else { continue };
        if texts.contains(&&**text) {
            return format!(
                "it is only broken where arithmetic leaves its type, which panics with overflow checks, or where `{text}` has two \
                 values in one cycle; where such a call has no state, say `assume pure …;`"
            );
        }
        texts.push(text);
    }
    "it is only broken where arithmetic leaves its type, which panics with overflow checks".to_owned()
}

/// Decides one property of a circuit, within a limit.
///
/// # Errors
/// A verdict that fails its check.
pub fn decide(program: &Program<'_>, circuit: &Circuit, bad: Bad, limit: &Limit) -> Result<Verdict, Internal> {
    let Some(goal) = Goal::of(&program.model.properties[bad.property].claim) else {
        return Ok(Verdict::Undecided("it is not about the ends of cycles".to_owned()));
    };
    let deadline = circuit.deadlines.iter().find(|deadline| deadline.property == bad.property);
    if let Some(deadline) = deadline {
        return in_time(program, circuit, (bad, *deadline), &goal, limit);
    }
    if !clocks::are_several(program, circuit, bad.possible) {
        return decide_on(program, circuit, bad, &goal, limit);
    }
    // It may do without.
    match decide_on(program, circuit, bad, &goal, &limit.part(ALONE))? {
        Verdict::Undecided(why) if why == OVER && !limit.is_over() => {}
        verdict => return Ok(verdict),
    }
    let mut known = Known::nothing(circuit);
    if let Ok(Some((with, said))) = clocks::known(program, circuit, bad.possible, limit) {
        known = Known { circuit: with, clocks: Vec::new(), said };
    }
    with_sums(program, known, bad, &goal, limit)
}

/// What is known of a circuit's clocks, and the circuit in which it is.
struct Known {
    circuit: Circuit,
    clocks: Vec<About>,
    said: Vec<String>,
}

impl Known {
    fn nothing(circuit: &Circuit) -> Self {
        Self { circuit: circuit.clone(), clocks: Vec::new(), said: Vec::new() }
    }

    fn decide(
        self,
        program: &Program<'_>,
        bad: Bad,
        goal: &Goal<'_>,
        limit: &Limit,
    ) -> Result<(Verdict, Self), Internal> {
        let verdict = match decide_on(program, &self.circuit, bad, goal, limit)? {
            Verdict::Proved(Proof { invariant, .. }) => {
                let (clocks, known) = (self.clocks.clone(), self.said.clone());
                let beside = Some(Box::new(self.circuit.clone()));
                Verdict::Proved(Proof { beside, clocks, known, ..Proof::of(invariant) })
            }
            verdict => verdict,
        };
        Ok((verdict, self))
    }
}

/// With what is known of its clocks; where that is not enough, with how far they are apart, too.
fn with_sums(
    program: &Program<'_>,
    known: Known,
    bad: Bad,
    goal: &Goal<'_>,
    limit: &Limit,
) -> Result<Verdict, Internal> {
    let mut known = match known.decide(program, bad, goal, &limit.part(BEFORE_SUMS))? {
        (Verdict::Undecided(why), known) if why == OVER && !limit.is_over() => known,
        (verdict, _) => return Ok(verdict),
    };
    if let Ok(Some((with, said))) = differences::known(program, &known.circuit, bad.possible, limit) {
        known.circuit = with;
        known.said.extend(said);
    }
    Ok(known.decide(program, bad, goal, limit)?.0)
}

/// Why what a property is about never happens; none where it does, or where that is not found out.
///
/// # Errors
/// A proof that fails its check.
pub fn vacuous(circuit: &Circuit, property: usize, limit: &Limit) -> Result<Option<Invariant>, Internal> {
    let trigger = circuit.triggers.iter().find(|(other, _)| *other == property);
    trigger.map_or(Ok(None), |(_, happens)| never(circuit, *happens, limit))
}

/// Why what is assumed to come one after the other, with this number, is asked for at no time, though nothing of that is assumed.
///
/// # Errors
/// A proof that fails its check.
pub fn says_nothing(circuit: &Circuit, order: usize, limit: &Limit) -> Result<Option<Invariant>, Internal> {
    let free = Circuit { constraint: circuit.without_orders, ..circuit.clone() };
    never(&free, circuit.orders[order], limit)
}

/// Why a wire is never true; none where it can be, or where that is not found out.
///
/// # Errors
/// A proof that fails its check.
pub fn never(circuit: &Circuit, wire: Lit, limit: &Limit) -> Result<Option<Invariant>, Internal> {
    let task = Task::new(circuit, wire);
    match first(&task, limit) {
        Err(None) | Ok(Found::Fails(_) | Found::MayFail(_)) => Ok(None),
        Err(Some(internal)) => Err(internal),
        Ok(Found::Holds(invariant)) => Ok(Some(invariant)),
    }
}

/// With what is known of its clock, where the limit allows it.
fn in_time(
    program: &Program<'_>,
    circuit: &Circuit,
    (bad, deadline): (Bad, Deadline),
    goal: &Goal<'_>,
    limit: &Limit,
) -> Result<Verdict, Internal> {
    let Ok((circuit, clocks)) = strengthened(program, circuit, deadline, limit) else {
        return Ok(Verdict::Undecided(OVER.to_owned()));
    };
    let mut known = Known { circuit, clocks, said: Vec::new() };
    if !program.model.orders.is_empty() {
        // How its clock goes with those of what is assumed.
        let mut all = known.circuit.clone();
        all.timers.push(Timer { of: deadline.waits, first: deadline.waits + 1, width: deadline.width });
        if let Ok(Some((with, said))) = clocks::known(program, &all, bad.possible, limit) {
            known = Known { circuit: with, said, ..known };
        }
    }
    with_sums(program, known, bad, goal, limit)
}

fn decide_on(
    program: &Program<'_>,
    circuit: &Circuit,
    bad: Bad,
    goal: &Goal<'_>,
    limit: &Limit,
) -> Result<Verdict, Internal> {
    let over = |_: Over| Verdict::Undecided(OVER.to_owned());
    if circuit.aig.len() >= LONG_SEARCH {
        if let Some(proof) = by_evolutions(program, bad.property, &limit.half(FOR_EVOLUTIONS))? {
            return Ok(Verdict::Proved(proof));
        }
    }
    // What holds where arithmetic goes on at the other end holds where it panics, too: there are fewer ends of cycles then.
    match judge(circuit, bad.possible, limit) {
        Err(fault) => fault.map_or_else(|| Ok(over(Over)), Err),
        Ok(Judged::Holds(invariant)) => Ok(Verdict::Proved(Proof::of(invariant))),
        Ok(Judged::Fails(way)) => shown(program, circuit, bad, goal, &way, limit),
    }
}

/// A proof that goes from one evolution of a search for stability to the next, where that is enough. What is not proved so may hold all the same.
///
/// # Errors
/// A proof that fails its check.
pub fn by_evolutions(program: &Program<'_>, property: usize, limit: &Limit) -> Result<Option<Proof>, Internal> {
    if !matches!(program.model.properties[property].claim, Claim::Never(_) | Claim::Always { .. }) {
        return Ok(None);
    }
    let Some(evolutions) = Circuit::of_evolutions(program) else { return Ok(None) };
    let Some(bad) = evolutions.bad.iter().find(|one| one.property == property) else { return Ok(None) };
    let found = invariant(&Task::new(&evolutions, bad.possible), limit);
    match found {
        Ok(Ok(invariant)) => Ok(Some(Proof { beside: Some(Box::new(evolutions)), ..Proof::of(invariant) })),
        // A way there may be none of the whole cycles.
        Ok(Err(_)) | Err(None) => Ok(None),
        Err(Some(internal)) => Err(internal),
    }
}

/// What the engine says, checked as far as that goes without the chart.
pub(crate) enum Judged {
    Holds(Invariant),
    Fails(Way),
}

/// The same before the shortest way is looked for.
enum Found {
    Holds(Invariant),
    Fails(Way),
    /// In so many cycles at most.
    MayFail(usize),
}

/// None for the limit.
pub(crate) fn judge(circuit: &Circuit, bad: Lit, limit: &Limit) -> Result<Judged, Option<Internal>> {
    let task = Task::new(circuit, bad);
    match first(&task, limit)? {
        Found::Holds(invariant) => Ok(Judged::Holds(invariant)),
        Found::Fails(way) => Ok(Judged::Fails(way)),
        Found::MayFail(length) => match bmc::shortest(&task, length, limit).map_err(|_| None)? {
            Some(way) => Ok(Judged::Fails(way)),
            None => Err(Some(Internal(format!("a way of {length} cycles that is none")))),
        },
    }
}

/// The first cycles one by one, then IC3; none for the limit.
fn first(task: &Task<'_>, limit: &Limit) -> Result<Found, Option<Internal>> {
    let over = |_: Over| None;
    if let Some(way) = bmc::shortest(task, FIRST_CYCLES, limit).map_err(over)? {
        return Ok(Found::Fails(way));
    }
    // What IC3 does not find soon may follow from itself.
    let found = match invariant(task, &limit.part(BEFORE_INDUCTION)) {
        Err(None) if !limit.is_over() => match inductive(task, limit)? {
            Some(invariant) => return Ok(Found::Holds(invariant)),
            None => invariant(task, limit)?,
        },
        found => found?,
    };
    Ok(match found {
        Ok(invariant) => Found::Holds(invariant),
        Err(way) => Found::MayFail(way.inputs.len()),
    })
}

/// By k-induction, checked; none where it does not follow from so few cycles.
fn inductive(task: &Task<'_>, limit: &Limit) -> Result<Option<Invariant>, Option<Internal>> {
    let Ok(Some(depth)) = bmc::inductive(task, DEEPEST, &limit.part(FOR_INDUCTION)) else { return Ok(None) };
    let invariant = Invariant { excluded: Vec::new(), depth };
    match certificate::fault(task, &invariant, limit).map_err(|_| None)? {
        None => Ok(Some(invariant)),
        Some(fault) => Err(Some(Internal(format!("a proof that is none: {fault}")))),
    }
}

/// IC3 alone: an invariant that has been checked, or a way that need not be the shortest; none for the limit.
pub(crate) fn invariant(task: &Task<'_>, limit: &Limit) -> Result<Result<Invariant, Way>, Option<Internal>> {
    let over = |_: Over| None;
    match Pdr::new(task, limit).run().map_err(over)? {
        Answer::Holds(invariant) => match certificate::fault(task, &invariant, limit).map_err(over)? {
            None => Ok(Ok(invariant)),
            Some(fault) => Err(Some(Internal(format!("a proof that is none: {fault}")))),
        },
        Answer::Fails(way) => Ok(Err(way)),
    }
}

/// A way that is real: no arithmetic has left its type on it, and the interpreter goes it.
fn shown(
    program: &Program<'_>,
    circuit: &Circuit,
    bad: Bad,
    goal: &Goal<'_>,
    way: &Way,
    limit: &Limit,
) -> Result<Verdict, Internal> {
    let certain = if bad.certain == bad.possible {
        way.clone()
    } else {
        match judge(circuit, bad.certain, limit) {
            Err(Some(fault)) => return Err(fault),
            Err(None) => return Ok(Verdict::Undecided(OVER.to_owned())),
            Ok(Judged::Holds(_)) => return Ok(Verdict::Undecided(uncertain(circuit))),
            Ok(Judged::Fails(way)) => way,
        }
    };
    gone(program, circuit, goal, &certain)
}

/// The way without what it does not need, as the interpreter goes it.
pub(crate) fn gone(program: &Program<'_>, circuit: &Circuit, goal: &Goal<'_>, way: &Way) -> Result<Verdict, Internal> {
    match simplest(program, circuit, goal, way, &|_, _| true) {
        Ok(shown) => Ok(Verdict::Violated(shown)),
        Err(Why::NotUnderstood(what)) => {
            Ok(Verdict::Undecided(format!("a way that may break it depends on what is not looked into: {what}")))
        }
        Err(Why::Differs(what)) => differs(circuit, what),
    }
}

/// The interpreter goes another way than the circuit: a mistake, where both compute the same.
pub(crate) fn differs(circuit: &Circuit, what: String) -> Result<Verdict, Internal> {
    match circuit.uncomputed.first() {
        None => Err(Internal(what)),
        Some(text) => {
            Ok(Verdict::Undecided(format!("a way that may break it depends on what is not looked into: `{text}`")))
        }
    }
}
