//! Which steps can be active together, as a table by which a stored situation is looked at.

use super::{Concurrency, Facts, Nesting};
use crate::model::{Id, Model};

/// Charts with more steps have no table: it grows with the square of their number.
const MOST_STEPS: usize = 256;

/// With which others each step can be active.
#[derive(Default)]
pub(crate) struct Together {
    /// A row of bits for each step, in whole bytes. Empty where it says nothing.
    pub(crate) table: Vec<u8>,
    /// Whether as many as can be together always are: so it is in a chart that is well nested, whose branches exclude each other.
    pub(crate) is_whole: bool,
}

impl Together {
    pub(crate) fn of(model: &Model, facts: &Facts<'_>) -> Self {
        if model.steps.len() > MOST_STEPS {
            return Self::default();
        }
        let exclusive = Concurrency::of_exclusive_branches(model);
        let concurrency = facts.concurrency.across_partials(model);
        let mut is_whole = Nesting::of(model).is_some();
        let row = model.steps.len().div_ceil(8);
        let mut table = vec![0; row * model.steps.len()];
        for a in model.steps.ids() {
            for b in model.steps.ids() {
                let together = a != b && concurrency.together(a, b);
                is_whole &= a == b || together == exclusive.together(a, b);
                if together {
                    table[a.index() * row + b.index() / 8] |= 1_u8 << (b.index() % 8);
                }
            }
        }
        Self { table, is_whole }
    }
}
