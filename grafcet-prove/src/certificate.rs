//! The check of a proof: by SAT alone, on the circuit as it is, and with nothing of what found the proof.
//!
//! An invariant is one if every chart begins in it, if no cycle leads out of it, and if nothing bad can happen in it. By k-induction nothing bad
//! happens in the first cycles, nor after as many in which nothing bad did.

use crate::aig::{Aig, Lit, Node};
use crate::circuit::{Circuit, Condition};
use crate::limit::{Limit, Over};
use crate::sat::{Sat, Term};
use crate::task::{Invariant, Task, entry};
use crate::ways::{self, Leads};

/// What is wrong with a proof; none if it is right.
///
/// # Errors
/// The limit is reached.
pub fn fault(task: &Task<'_>, invariant: &Invariant, limit: &Limit) -> Result<Option<String>, Over> {
    for cube in &invariant.excluded {
        let outside = cube.iter().any(|code| {
            let (latch, value) = entry(*code);
            task.circuit.latches[latch].initial == Some(!value)
        });
        if !outside {
            return Ok(Some(format!("a chart may begin in {cube:?}")));
        }
    }
    let mut sat = Sat::new(limit);
    let nodes = nodes(&mut sat, &task.circuit.aig);
    let term = |lit: Lit| at(&nodes, lit);
    sat.clause(&[term(task.circuit.constraint)]);
    for cube in &invariant.excluded {
        let clause: Vec<Term> =
            cube.iter().map(|code| !of(*code, |latch| term(task.circuit.latches[latch].now))).collect();
        sat.clause(&clause);
    }
    if invariant.depth > 0 {
        if let Some(fault) = fault_of_depth(task, invariant, limit)? {
            return Ok(Some(fault));
        }
    } else if sat.solve(&[term(task.bad)])? {
        return Ok(Some("something bad can happen in it".to_owned()));
    }
    for cube in &invariant.excluded {
        let after: Vec<Term> =
            cube.iter().map(|code| of(*code, |latch| term(task.circuit.latches[latch].next))).collect();
        if sat.solve(&after)? {
            return Ok(Some(format!("a cycle leads to {cube:?}")));
        }
    }
    Ok(None)
}

/// Nothing bad in the first cycles, and nothing bad after as many without.
fn fault_of_depth(task: &Task<'_>, invariant: &Invariant, limit: &Limit) -> Result<Option<String>, Over> {
    let circuit = task.circuit;
    for begins in [true, false] {
        let mut sat = Sat::new(limit);
        let first = nodes(&mut sat, &circuit.aig);
        for latch in circuit.latches.iter().filter(|_| begins) {
            if let Some(initial) = latch.initial {
                sat.clause(&[at(&first, latch.now.xor(!initial))]);
            }
        }
        for cube in &invariant.excluded {
            let outside = cube.iter().map(|code| !of(*code, |latch| at(&first, circuit.latches[latch].now)));
            sat.clause(&outside.collect::<Vec<Term>>());
        }
        let mut cycle = first;
        for number in 1..=invariant.depth + usize::from(!begins) {
            sat.clause(&[at(&cycle, circuit.constraint)]);
            let bad = at(&cycle, task.bad);
            if (begins || number > invariant.depth) && sat.solve(&[bad])? {
                let what = if begins {
                    format!("something bad can happen in cycle {number}")
                } else {
                    "it does not follow from itself".to_owned()
                };
                return Ok(Some(what));
            }
            sat.clause(&[!bad]);
            cycle = following(&mut sat, circuit, &cycle);
        }
    }
    Ok(None)
}

/// The gates of the cycle after one.
fn following(sat: &mut Sat, circuit: &Circuit, cycle: &[Term]) -> Vec<Term> {
    let later = nodes(sat, &circuit.aig);
    for latch in &circuit.latches {
        let (now, next) = (at(&later, latch.now), at(cycle, latch.next));
        sat.clause(&[!now, next]);
        sat.clause(&[now, !next]);
    }
    later
}

/// Whether these hold wherever a chart begins, and after each cycle before which they do.
///
/// # Errors
/// The limit is reached.
pub fn is_inductive(circuit: &Circuit, lemmas: &[Condition], limit: &Limit) -> Result<bool, Over> {
    let mut sat = Sat::new(limit);
    let nodes = nodes(&mut sat, &circuit.aig);
    let term = |lit: Lit| if lit.is_negated() { !nodes[lit.node()] } else { nodes[lit.node()] };
    let (begins, goes_on) = (sat.term(), sat.term());
    for latch in &circuit.latches {
        if let Some(initial) = latch.initial {
            sat.clause(&[!begins, term(latch.now.xor(!initial))]);
        }
    }
    sat.clause(&[!goes_on, term(circuit.constraint)]);
    for lemma in lemmas {
        sat.clause(&[!goes_on, term(lemma.now)]);
    }
    let wires: Vec<Lit> = lemmas.iter().map(|lemma| lemma.now).collect();
    let after = after_cycle(&mut sat, circuit, &wires, &nodes);
    for (lemma, end) in lemmas.iter().zip(after) {
        if sat.solve(&[begins, !term(lemma.now)])? || sat.solve(&[goes_on, !end])? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// What wires are once the cycle has led on: not as who found them says it, but the same gates over the latches as they then are.
fn after_cycle(sat: &mut Sat, circuit: &Circuit, wires: &[Lit], nodes: &[Term]) -> Vec<Term> {
    let aig = &circuit.aig;
    let mut is_asked = vec![false; aig.len()];
    for wire in wires {
        is_asked[wire.node()] = true;
    }
    for index in (0..aig.len()).rev() {
        if let (true, Node::And(a, b)) = (is_asked[index], aig.node(index)) {
            (is_asked[a.node()], is_asked[b.node()]) = (true, true);
        }
    }
    let mut later = nodes.to_vec();
    for index in 0..aig.len() {
        if let (true, Node::Free | Node::And(..)) = (is_asked[index], aig.node(index)) {
            later[index] = sat.term();
        }
    }
    for latch in &circuit.latches {
        let (now, next) = (latch.now.node(), latch.next);
        let next = if next.is_negated() { !nodes[next.node()] } else { nodes[next.node()] };
        later[now] = if latch.now.is_negated() { !next } else { next };
    }
    for index in 0..aig.len() {
        if let (true, Node::And(a, b)) = (is_asked[index], aig.node(index)) {
            let (term, x, y) = (later[index], at(&later, a), at(&later, b));
            sat.clause(&[!term, x]);
            sat.clause(&[!term, y]);
            sat.clause(&[term, !x, !y]);
        }
    }
    wires.iter().map(|wire| at(&later, *wire)).collect()
}

/// What is wrong with ways; none where each cube of theirs leads on as it says, with the inputs that it names and whatever the others are.
///
/// `known` is so in every state, `may` holds in each cycle of them.
///
/// # Errors
/// The limit is reached.
pub fn fault_of_ways(
    circuit: &Circuit,
    (known, may): (Lit, Lit),
    ways: &Leads,
    limit: &Limit,
) -> Result<Option<String>, Over> {
    let mut sat = Sat::new(limit);
    let nodes = nodes(&mut sat, &circuit.aig);
    let term = |lit: Lit| if lit.is_negated() { !nodes[lit.node()] } else { nodes[lit.node()] };
    let chosen = ways::inputs(circuit).0;
    // Where the target is reached, and what an earlier cube holds, is no matter of a later one: there the way of that one is gone.
    sat.clause(&[!term(ways.target.now)]);
    sat.clause(&[term(known)]);
    // A cycle that does not count, or that arrives nowhere: that is asked for, and it must not be.
    let nowhere = sat.term();
    let arrives = after_cycle(&mut sat, circuit, &[ways.target.now], &nodes);
    sat.clause(&[!nowhere, !term(may), !arrives[0]]);
    let mut nearer = 0;
    for (number, lead) in ways.leads.iter().enumerate() {
        if number > 0 && lead.after < ways.leads[number - 1].after {
            return Ok(Some(format!("cube {number} is nearer than the one in front of it")));
        }
        while ways.leads[nearer].after < lead.after {
            let outside =
                ways.leads[nearer].cube.iter().map(|code| !of(*code, |latch| term(circuit.latches[latch].next)));
            sat.clause(&[!nowhere, !term(may)].into_iter().chain(outside).collect::<Vec<Term>>());
            nearer += 1;
        }
        let here: Vec<Term> =
            lead.cube.iter().map(|code| of(*code, |latch| term(circuit.latches[latch].now))).collect();
        let given = chosen.iter().map(|lit| term(lit.xor(lead.inputs.binary_search(&lit.node()).is_err())));
        let assumed: Vec<Term> = [nowhere].into_iter().chain(given).chain(here.iter().copied()).collect();
        if sat.solve(&assumed)? {
            return Ok(Some(format!("the inputs of cube {number} do not lead on")));
        }
        let elsewhere: Vec<Term> = here.into_iter().map(|term| !term).collect();
        sat.clause(&elsewhere);
    }
    Ok(None)
}

/// Whether no cycle leads from where this does not hold to where it does.
///
/// # Errors
/// The limit is reached.
pub fn is_closed(circuit: &Circuit, inside: Lit, limit: &Limit) -> Result<bool, Over> {
    let mut sat = Sat::new(limit);
    let nodes = nodes(&mut sat, &circuit.aig);
    let term = |lit: Lit| if lit.is_negated() { !nodes[lit.node()] } else { nodes[lit.node()] };
    let after = after_cycle(&mut sat, circuit, &[inside], &nodes);
    Ok(!sat.solve(&[term(circuit.constraint), !term(inside), after[0]])?)
}

fn of(code: u32, term: impl Fn(usize) -> Term) -> Term {
    let (latch, value) = entry(code);
    if value { term(latch) } else { !term(latch) }
}

fn at(nodes: &[Term], lit: Lit) -> Term {
    if lit.is_negated() { !nodes[lit.node()] } else { nodes[lit.node()] }
}

/// Every gate of the circuit as clauses, whether it matters or not.
fn nodes(sat: &mut Sat, aig: &Aig) -> Vec<Term> {
    let mut terms: Vec<Term> = Vec::with_capacity(aig.len());
    for index in 0..aig.len() {
        let term = sat.term();
        match aig.node(index) {
            Node::Free => {}
            Node::False => sat.clause(&[!term]),
            Node::And(a, b) => {
                let operand = |lit: Lit| if lit.is_negated() { !terms[lit.node()] } else { terms[lit.node()] };
                let (x, y) = (operand(a), operand(b));
                sat.clause(&[!term, x]);
                sat.clause(&[!term, y]);
                sat.clause(&[term, !x, !y]);
            }
        }
        terms.push(term);
    }
    terms
}
