//! What excludes what: of any two things that are on or off, such as steps and variables, whether they are ever on together, off together, or
//! the one without the other. All such sentences are candidates, as in [`lemmas`](crate::lemmas).
//!
//! A search that goes backwards comes to states that no chart is ever in; it comes to far fewer of them where this is known.

use crate::aig::{Lit, value};
use crate::certificate;
use crate::circuit::{Circuit, Condition, Latch};
use crate::lemmas::always;
use crate::limit::{Limit, Over};

/// More than these are not compared with each other.
const MOST: usize = 80;

/// So many steps of the solver may that take.
const STEPS: u64 = 60_000;

/// So many cycles with inputs at random.
const CYCLES: usize = 400;

/// Leaves out what some cycles from the beginning on show not to be so: most of it, and cheaper than by a solver.
fn seen(circuit: &Circuit, all: &mut Vec<Condition>) {
    let mut state: Vec<bool> = circuit.latches.iter().map(|latch| latch.initial.unwrap_or(false)).collect();
    let mut free = vec![false; circuit.aig.len()];
    // The same on every machine.
    let mut noise = 0x9e37_79b9_7f4a_7c15_u64;
    for _ in 0..CYCLES {
        for (latch, now) in circuit.latches.iter().zip(&state) {
            free[latch.now.node()] = *now;
        }
        for bit in circuit.inputs.iter().flat_map(|wire| &wire.bits) {
            noise ^= noise << 13;
            noise ^= noise >> 7;
            noise ^= noise << 17;
            free[bit.node()] = noise >> 60 < 6;
        }
        let values = circuit.aig.simulate(|node| free[node]);
        if value(&values, circuit.constraint) {
            all.retain(|one| value(&values, one.now) && value(&values, one.end));
            state = circuit.latches.iter().map(|latch| value(&values, latch.next)).collect();
        }
    }
}

/// What is known so; it is assumed of each cycle from then on.
///
/// # Errors
/// The limit is reached.
pub(crate) fn add(circuit: &mut Circuit, relevant: &[usize], limit: &Limit) -> Result<Lit, Over> {
    let is_relevant = |latch: &usize| relevant.binary_search(latch).is_ok();
    let single = circuit.fields.iter().filter(|field| field.width == 1).map(|field| field.first);
    let latches: Vec<Latch> = single.filter(is_relevant).map(|latch| circuit.latches[latch]).collect();
    if latches.len() > MOST {
        return Ok(Lit::TRUE);
    }
    let mut all = Vec::new();
    for (index, one) in latches.iter().enumerate() {
        for other in &latches[..index] {
            for signs in 0..4 {
                let (a, b) = (signs & 1 == 1, signs & 2 == 2);
                let now = !circuit.aig.and(one.now.xor(a), other.now.xor(b));
                let end = !circuit.aig.and(one.next.xor(a), other.next.xor(b));
                all.push(Condition { now, end });
            }
        }
    }
    seen(circuit, &mut all);
    let part = limit.part(STEPS);
    let Ok(left) = always(circuit, &all, &part) else {
        return if limit.is_over() { Err(Over) } else { Ok(Lit::TRUE) };
    };
    let kept: Vec<Condition> = left.into_iter().map(|index| all[index]).collect();
    // What is wrong here would be a false proof.
    match certificate::is_inductive(circuit, &kept, &part) {
        Ok(true) => {}
        Ok(false) => return Ok(Lit::TRUE),
        Err(Over) => return if limit.is_over() { Err(Over) } else { Ok(Lit::TRUE) },
    }
    let known = kept.iter().fold(Lit::TRUE, |all, one| circuit.aig.and(all, one.now));
    circuit.constraint = circuit.aig.and(circuit.constraint, known);
    Ok(known)
}
