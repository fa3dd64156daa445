//! Whether some states lead on with inputs that are given.

use super::search::Search;
use crate::aig::{Aig, Lit, Node};
use crate::limit::Over;
use crate::sat::{Sat, Term, Wires};
use crate::task::{Cube, entry};

/// One cycle with inputs that are given: most gates come to nothing then.
pub(super) struct Given {
    sat: Sat,
    /// By latch: its term, where it matters.
    now: Vec<Option<Term>>,
    /// The open inputs.
    open: Vec<Term>,
    /// It does not lead on.
    fails: Term,
}

impl Given {
    pub(super) fn new(search: &Search<'_>, inputs: &[usize], near: &[usize]) -> Self {
        let circuit = search.circuit;
        let mut aig = Aig::default();
        let mut of: Vec<Lit> = vec![Lit::FALSE; circuit.aig.len()];
        let mut chosen = search.chosen.iter().map(|(node, _)| *node).collect::<Vec<usize>>();
        chosen.sort_unstable();
        let mut long = Lit::FALSE;
        for node in &search.nodes {
            of[*node] = match circuit.aig.node(*node) {
                Node::False => Lit::FALSE,
                Node::Free if chosen.binary_search(node).is_ok() => Lit::constant(inputs.binary_search(node).is_ok()),
                Node::Free => aig.free(),
                Node::And(a, b) => {
                    let of = |lit: Lit| of[lit.node()].xor(lit.is_negated());
                    aig.and(of(a), of(b))
                }
            };
            // That the search is short is asked for, and what it would do otherwise is no matter.
            if let Some(lit) = search.short.filter(|lit| lit.node() == *node) {
                long = of[*node].xor(lit.is_negated());
                of[*node] = Lit::constant(lit.is_negated());
            }
        }
        let is = |lit: Lit| of[lit.node()].xor(lit.is_negated());
        let mut arrives = is(search.target.end);
        for lead in near {
            let mut here = Lit::TRUE;
            for code in &search.leads[*lead].cube {
                let (latch, value) = entry(*code);
                here = aig.and(here, is(circuit.latches[latch].next).xor(!value));
            }
            arrives = aig.or(arrives, here);
        }
        let may = aig.and(is(search.may), !long);
        let leads = aig.and(may, arrives);
        let (mut sat, mut wires) = (Sat::of_inputs(&search.limit), Wires::new(&aig));
        let mut now = vec![None; circuit.latches.len()];
        for latch in &search.latches {
            now[*latch] = Some(wires.term(&mut sat, &aig, is(circuit.latches[*latch].now)));
        }
        let known = wires.term(&mut sat, &aig, is(search.steps.known));
        sat.clause(&[known]);
        let open = search.open.iter().map(|(lit, _)| wires.term(&mut sat, &aig, is(*lit))).collect();
        let fails = !wires.term(&mut sat, &aig, leads);
        Self { sat, now, open, fails }
    }

    /// The open inputs in the last model.
    pub(super) fn otherwise(&self) -> Vec<bool> {
        self.open.iter().map(|term| self.sat.holds(*term)).collect()
    }

    /// The part of a cube from which they lead on; none where they do not from all of it.
    pub(super) fn core(&mut self, cube: &[u32]) -> Result<Option<Cube>, Over> {
        let mut assumed = vec![self.fails];
        for code in cube {
            let (latch, value) = entry(*code);
            assumed.extend(self.now[latch].map(|term| if value { term } else { !term }));
        }
        if self.sat.solve(&assumed)? {
            return Ok(None);
        }
        let part = cube.iter().zip(&assumed[1..]).filter(|(_, term)| self.sat.in_core(**term));
        Ok(Some(part.map(|(code, _)| *code).collect()))
    }
}
