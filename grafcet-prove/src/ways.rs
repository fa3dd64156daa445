//! From where inputs lead to a target: backwards from it, cube by cube, each with the inputs of one cycle.
//!
//! A state from which a cycle leads to a cube that is known is looked for; around it a cube is made, as large as can be, from all of which the
//! same inputs lead there. Nothing is asked about how a chart gets to such a state. Where no more are found, no others have a way.

mod around;
mod given;
mod search;

use crate::aig::Lit;
use crate::circuit::{Circuit, Condition, Source};
use crate::task::Cube;

pub(crate) use search::Search;

/// What a way may rely on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trust {
    /// On what is certain: whatever Rust that is not looked into comes to, and with no result that leaves its type.
    Certain,
    /// On anything that can be.
    Possible,
}

/// From all of a cube these inputs lead, in one cycle, to the target, or to cubes that are nearer to it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Lead {
    pub cube: Cube,
    /// The inputs that are on, by their nodes, ascending.
    pub inputs: Vec<usize>,
    /// How many cycles it may take after this one.
    pub after: usize,
}

/// Ways to a target.
#[derive(Clone, Debug)]
pub struct Leads {
    pub target: Condition,
    /// The nearer ones first.
    pub leads: Vec<Lead>,
}

impl Leads {
    /// So many cycles, at most, where they are gone as they are found.
    #[must_use]
    pub fn longest(&self) -> usize {
        self.leads.last().map_or(0, |lead| lead.after + 1)
    }
}

/// The inputs of a circuit that whoever looks for a way may choose, and those that are as they like.
pub(crate) fn inputs(circuit: &Circuit) -> (Vec<Lit>, Vec<Lit>) {
    let (mut chosen, mut open) = (Vec::new(), Vec::new());
    for wire in &circuit.inputs {
        let kind = if matches!(wire.source, Source::Rust(_)) { &mut open } else { &mut chosen };
        kind.extend(&wire.bits);
    }
    (chosen, open)
}

/// The bits of the time that passes between two cycles, by their nodes.
fn times(circuit: &Circuit) -> Vec<usize> {
    let times = circuit.inputs.iter().filter(|wire| wire.source == Source::Elapsed);
    times.flat_map(|wire| &wire.bits).map(|bit| bit.node()).collect()
}

/// What has to hold in each cycle of a way.
pub(crate) fn may(circuit: &mut Circuit, trust: Trust) -> Lit {
    let no_overflow = if trust == Trust::Certain { !circuit.overflow } else { Lit::TRUE };
    circuit.aig.and(circuit.constraint, no_overflow)
}
