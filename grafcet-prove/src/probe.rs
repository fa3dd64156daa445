//! Whether a search is ever so long: what never is, is not unrolled.
//!
//! The program says after how many rounds it is cut off; most searches end long before.

use crate::aig::{Aig, Lit};
use crate::limit::Limit;
use crate::sat::{Sat, Wires};

/// So many steps of the solver for one search, in all: twice of what the largest charts of the gallery take.
const STEPS: u64 = 90_000;

pub(crate) struct Probe {
    /// The gates so far, and the round in which the next question is asked; none once the limit is reached.
    asked: Option<(Sat, Wires, u32)>,
}

impl Probe {
    pub(crate) fn new() -> Self {
        let limit = Limit::work(STEPS);
        Self { asked: Some((Sat::new(&limit), Wires::new(&Aig::default()), 2)) }
    }

    /// Whether it is certain that no state and no inputs lead to this round. Not each is asked about: the number of rounds grows by a half.
    pub(crate) fn is_never(&mut self, round: u32, aig: &Aig, path: Lit) -> bool {
        let Some((sat, wires, next)) = &mut self.asked else { return false };
        if round < *next {
            return false;
        }
        *next = round + round.div_ceil(2);
        let here = wires.term(sat, aig, path);
        match sat.solve(&[here]) {
            Ok(found) => !found,
            Err(_) => {
                self.asked = None;
                false
            }
        }
    }
}
