//! How far clocks are apart, from situation to situation: what takes several steps takes as long as all of them, and IC3, which sees single
//! bits, would add that up value by value.
//!
//! Of any two steps of different nets, and of a step and what is on or off, it is looked for whether they are ever so together, and if they are,
//! for the most by which each clock that matters there is ahead of another. Both begin with what cycles at random have shown; where the
//! solver finds a cycle that leads further, they grow, to the most that one cycle can make of what is known so far, until none does. What
//! grows again and again is given up. What is left always holds, and is checked like any proof.

mod domain;
mod growth;

use grafcet_compiler::program::Program;

use crate::aig::Lit;
use crate::circuit::{Circuit, Condition};
use crate::lemmas::assume;
use crate::limit::{At, Limit, Over};
use domain::Domain;
use growth::Growth;

/// So many steps of the solver may that take.
const STEPS: u64 = 20_000_000;

/// The circuit in which it is known what decides about `bad`, and that in words; none where there is nothing.
///
/// # Errors
/// The limit is reached.
pub(crate) fn known(
    program: &Program<'_>,
    circuit: &Circuit,
    bad: Lit,
    limit: &Limit,
) -> Result<Option<(Circuit, Vec<String>)>, Over> {
    limit.tell(At::Lemmas);
    let limit = &limit.part(STEPS);
    let mut circuit = circuit.clone();
    let Some(domain) = Domain::of(program, &circuit, bad) else { return Ok(None) };
    let mut growth = Growth::new(domain, &mut circuit, bad, limit);
    growth.run()?;
    let (kept, said): (Vec<Condition>, Vec<String>) = growth.needed()?.into_iter().unzip();
    let is_known = !kept.is_empty() && assume(&mut circuit, &kept, limit)?;
    Ok(is_known.then_some((circuit, said)))
}
