//! One question about a circuit: the part of it that decides, and what is found out.

use crate::aig::Lit;
use crate::circuit::{Circuit, Latch};

/// Whether `bad` can hold at the end of a cycle.
#[derive(Clone, Debug)]
pub struct Task<'c> {
    pub circuit: &'c Circuit,
    pub bad: Lit,
    /// The latches on which the answer depends, by their numbers.
    pub latches: Vec<usize>,
}

/// The values of the inputs of each cycle, by the nodes of the circuit; the last cycle is the one in which `bad` holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Way {
    /// Latches that begin with any value, and with which here.
    pub initial: Vec<(usize, bool)>,
    /// By cycle: the free nodes that are true.
    pub inputs: Vec<Vec<usize>>,
}

/// Some latches and their values: the lowest bit says which, the others the number of the latch.
pub type Cube = Vec<u32>;

/// What holds in every state that can be reached: none of these.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Invariant {
    pub excluded: Vec<Cube>,
    /// After so many cycles at whose ends nothing bad holds, nothing bad does in the next one, either, and neither in the first so many;
    /// zero where that follows from what is excluded.
    pub depth: usize,
}

/// A latch of a cube, and its value there.
#[must_use]
pub fn entry(code: u32) -> (usize, bool) {
    ((code >> 1) as usize, code & 1 == 1)
}

/// The latches on which these wires depend, in this cycle and in all before, by their numbers.
pub(crate) fn cone(circuit: &Circuit, mut roots: Vec<Lit>) -> Vec<usize> {
    let mut of_node = vec![usize::MAX; circuit.aig.len()];
    for (index, latch) in circuit.latches.iter().enumerate() {
        of_node[latch.now.node()] = index;
    }
    let mut latches: Vec<usize> = Vec::new();
    loop {
        let mut found = Vec::new();
        for node in circuit.aig.cone(&roots) {
            if of_node[node] != usize::MAX && !latches.contains(&of_node[node]) {
                found.push(of_node[node]);
            }
        }
        if found.is_empty() {
            break;
        }
        roots.extend(found.iter().map(|latch| circuit.latches[*latch].next));
        latches.extend(found);
    }
    latches.sort_unstable();
    latches
}

impl<'c> Task<'c> {
    #[must_use]
    pub fn new(circuit: &'c Circuit, bad: Lit) -> Self {
        Self { circuit, bad, latches: cone(circuit, vec![bad, circuit.constraint]) }
    }

    pub(crate) fn latch(&self, number: usize) -> Latch {
        self.circuit.latches[number]
    }

    /// The free nodes of a cycle that are no latches, as far as they matter.
    pub(crate) fn inputs(&self) -> Vec<Lit> {
        self.circuit.inputs.iter().flat_map(|wire| wire.bits.iter().copied()).collect()
    }

    /// Whether a cube holds none of the states that a chart can begin with.
    pub(crate) fn is_no_beginning(&self, cube: &[u32]) -> bool {
        cube.iter().any(|code| {
            let (latch, value) = entry(*code);
            self.latch(latch).initial.is_some_and(|initial| initial != value)
        })
    }
}
