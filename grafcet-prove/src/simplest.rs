//! A way without what it does not need.

use grafcet_compiler::program::Program;

use crate::circuit::Circuit;
use crate::goal::Goal;
use crate::replay::{Shown, Why, replay};
use crate::task::Way;

/// So many times the interpreter goes a way, and no more.
const TRIES: usize = 500;

/// The way with as little as possible on, as the interpreter goes it: each bit of its inputs and times that can be 0 is, as far as the way is
/// `accepted` so.
///
/// # Errors
/// The interpreter does not go the way that is given.
pub(crate) fn simplest(
    program: &Program<'_>,
    circuit: &Circuit,
    goal: &Goal<'_>,
    way: &Way,
    accepted: &dyn Fn(&Way, &[Shown]) -> bool,
) -> Result<Vec<Shown>, Why> {
    let (mut way, mut shown) = (way.clone(), replay(program, circuit, goal, way)?);
    if !accepted(&way, &shown) {
        return Err(Why::Differs("the interpreter is not where the circuit is".to_owned()));
    }
    let mut tries = 0;
    for cycle in 0..way.inputs.len() {
        // From the highest bit downwards, so that a number gets small.
        for index in (0..way.inputs[cycle].len()).rev() {
            if tries == TRIES {
                return Ok(shown);
            }
            tries += 1;
            let node = way.inputs[cycle].remove(index);
            match replay(program, circuit, goal, &way) {
                Ok(less) if accepted(&way, &less) => shown = less,
                Ok(_) | Err(_) => way.inputs[cycle].insert(index, node),
            }
        }
    }
    Ok(shown)
}
