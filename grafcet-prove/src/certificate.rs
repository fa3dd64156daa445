//! The check of a proof: by SAT alone, on the circuit as it is, and with nothing of what found the proof.
//!
//! An invariant is one if every chart begins in it, if no cycle leads out of it, and if nothing bad can happen in it.

use crate::aig::{Aig, Lit, Node};
use crate::circuit::Circuit;
use crate::lemmas::Lemma;
use crate::sat::{Limit, Over, Sat, Term};
use crate::task::{Invariant, Task, entry};

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
    let term = |lit: Lit| if lit.is_negated() { !nodes[lit.node()] } else { nodes[lit.node()] };
    sat.clause(&[term(task.circuit.constraint)]);
    for cube in &invariant.excluded {
        let clause: Vec<Term> =
            cube.iter().map(|code| !of(*code, |latch| term(task.circuit.latches[latch].now))).collect();
        sat.clause(&clause);
    }
    if sat.solve(&[term(task.bad)])? {
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

/// Whether these hold wherever a chart begins, and after each cycle before which they do.
///
/// # Errors
/// The limit is reached.
pub fn is_inductive(circuit: &Circuit, lemmas: &[Lemma], limit: &Limit) -> Result<bool, Over> {
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
    for lemma in lemmas {
        if sat.solve(&[begins, !term(lemma.now)])? || sat.solve(&[goes_on, !term(lemma.next)])? {
            return Ok(false);
        }
    }
    Ok(true)
}

fn of(code: u32, term: impl Fn(usize) -> Term) -> Term {
    let (latch, value) = entry(code);
    if value { term(latch) } else { !term(latch) }
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
