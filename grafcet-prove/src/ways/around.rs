//! Around a state that leads on: as few inputs as do, and as many states as they lead on from.

use super::given::Given;
use super::search::Search;
use super::times;
use crate::aig::{Lit, value};
use crate::limit::Over;
use crate::pdr::code;
use crate::sat::Term;
use crate::task::{Cube, entry};

/// What a cube costs in steps of the solver, as measured.
const NODES_PER_STEP: u64 = 4;

/// A cube is widened as far as its inputs lead to one of the last so many before it.
const NEAR: usize = 100;

impl Search<'_> {
    /// The cubes with which one is looked for around the state in the last model: those found last, and one to which it leads. With open inputs
    /// all of them, as it may lead elsewhere with each value of these.
    pub(super) fn near(&self, inputs: &[usize], known: usize) -> Vec<usize> {
        if !self.open.is_empty() {
            return (0..known).collect();
        }
        let values = self.values(&self.free(inputs));
        let last = known.saturating_sub(NEAR);
        let mut near: Vec<usize> = (0..last).filter(|lead| self.is_inside(*lead, &values)).take(1).collect();
        near.extend(last..known);
        near
    }

    /// The free nodes in the last model, with these inputs.
    fn free(&self, inputs: &[usize]) -> Vec<bool> {
        let mut free = vec![false; self.circuit.aig.len()];
        for (latch, term) in self.latches.iter().zip(&self.now) {
            free[self.circuit.latches[*latch].now.node()] = self.sat.holds(*term);
        }
        for (lit, term) in &self.open {
            free[lit.node()] = self.sat.holds(*term);
        }
        for node in inputs {
            free[*node] = true;
        }
        free
    }

    fn values(&self, free: &[bool]) -> Vec<bool> {
        self.circuit.aig.simulate(|node| free[node])
    }

    /// Whether a cycle ends in a cube.
    fn is_inside(&self, lead: usize, values: &[bool]) -> bool {
        let cube = self.leads[lead].cube.iter().map(|code| entry(*code));
        cube.into_iter().all(|(latch, on)| value(values, self.circuit.latches[latch].next) == on)
    }

    /// The inputs of the last model without those that can be off, and with as much time as can pass: what happens beside the way is as little as can be,
    /// so that it is gone from more states.
    pub(super) fn simpler(&self, inputs: &[usize], near: &[usize]) -> Vec<usize> {
        let mut free = self.free(inputs);
        let time = times(self.circuit);
        // From the last one on: what is declared first is what the plant is about.
        for (node, _) in self.chosen.iter().rev() {
            let before = free[*node];
            free[*node] = time.contains(node);
            if free[*node] != before && !self.leads_on(&free, near) {
                free[*node] = before;
            }
        }
        let mut on: Vec<usize> = self.chosen.iter().map(|(node, _)| *node).filter(|node| free[*node]).collect();
        on.sort_unstable();
        on
    }

    /// Whether a cycle leads on, by the values of free nodes, to what a cube around the state is looked for with.
    fn leads_on(&self, free: &[bool], near: &[usize]) -> bool {
        let values = self.values(free);
        let is = |lit: Lit| value(&values, lit);
        let short = self.short.is_none_or(|long| !is(long));
        let arrives = || is(self.target.end) || near.iter().any(|lead| self.is_inside(*lead, &values));
        short && is(self.may) && arrives()
    }

    /// The state in the last model. Which step of a region is active is told by that step alone.
    pub(super) fn state(&self) -> Cube {
        let code = |(latch, term): (&usize, &Term)| {
            let value = self.sat.holds(*term);
            (!self.steps.is_told(*latch, value)).then(|| code(*latch, value))
        };
        self.latches.iter().zip(&self.now).filter_map(code).collect()
    }

    /// The cube around a state, as large as can be, from which these inputs lead on whatever the open ones are; where that is not so of the state
    /// itself, open ones with which they do not.
    pub(super) fn widened(
        &self,
        state: &[u32],
        inputs: &[usize],
        near: &[usize],
    ) -> Result<Result<Cube, Vec<bool>>, Over> {
        // Its gates are gone through several times.
        self.limit.spend(self.nodes.len() as u64 / NODES_PER_STEP);
        let mut given = Given::new(self, inputs, near);
        let Some(mut cube) = given.core(state)? else { return Ok(Err(given.otherwise())) };
        for code in cube.clone() {
            let fewer: Cube = cube.iter().copied().filter(|other| *other != code).collect();
            if fewer.len() < cube.len() {
                if let Some(less) = given.core(&fewer)? {
                    cube = less;
                }
            }
        }
        // Where it need not be this step, some others are left out.
        for code in cube.clone() {
            let Some(others) = self.steps.beside(code) else { continue };
            let wider: Cube = cube.iter().copied().filter(|other| *other != code).chain(others.clone()).collect();
            if let Some(wider) = given.core(&wider)? {
                if others.iter().any(|other| !wider.contains(other)) {
                    cube = wider;
                }
            }
        }
        cube.sort_unstable();
        Ok(Ok(cube))
    }
}
