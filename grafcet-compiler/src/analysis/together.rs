//! Which situations a chart can be in, as a table by which one that comes from outside is looked at: a stored one, or one that is asked for by hand.

use super::{Concurrency, Facts, Nesting, explore};
use crate::list::{List, PushAll};
use crate::model::{Id, Model, Name, Read, StepId};

/// Of charts with more steps a stored situation is not looked at: a table of pairs grows with the square of their number.
const MOST_STEPS: usize = 256;

/// Up to so many situations are listed.
const MOST_SITUATIONS: usize = 128;

/// In so many bytes.
const MOST_BYTES: usize = 1024;

/// How many units of work it is worth to find them.
const WORK: u64 = 20_000;

/// What is known of the situations; in each table, a row has a bit for each step, in whole bytes.
pub enum Situations {
    /// Nothing.
    Unknown,
    /// Each has one step, or none.
    Alone,
    /// A row for each.
    Listed(Vec<u8>),
    /// A row for each step: with which others it can be active.
    Pairs(Vec<u8>),
    /// The same, and as many as can be together always are: so it is in a chart that is well nested, whose branches exclude each other.
    Whole(Vec<u8>),
}

impl Situations {
    /// For a situation that was stored.
    pub(crate) fn stored(model: &Model, facts: &Facts<'_>) -> Self {
        if model.steps.len() > MOST_STEPS { Self::Unknown } else { Self::of(model, facts) }
    }

    /// For one that is asked for, whatever the table takes.
    #[must_use]
    pub fn of(model: &Model, facts: &Facts<'_>) -> Self {
        let row = model.steps.len().div_ceil(8);
        let most = MOST_SITUATIONS.min(MOST_BYTES / row.max(1));
        let found = if forgets(model) { None } else { explore::situations(model, WORK, most) };
        if let Some(found) = found {
            return Self::Listed(found.iter().flat(|steps| bits(steps, row)).list());
        }
        let exclusive = Concurrency::of_exclusive_branches(model);
        let concurrency = facts.concurrency.across_partials(model);
        let mut is_whole = Nesting::of(model).is_some();
        let mut table = Vec::with_capacity(row * model.steps.len());
        for a in model.steps.ids() {
            let mut others = Vec::new();
            for b in model.steps.ids() {
                let together = a != b && concurrency.together(a, b);
                is_whole &= a == b || together == exclusive.together(a, b);
                if together {
                    others.push(b);
                }
            }
            table.push_all(bits(&others, row));
        }
        if is_whole { Self::Whole(table) } else { Self::Pairs(table) }
    }
}

/// Whether a cycle by hand (A38) leaves behind what no way of the chart's own does, and some condition asks for it: another value, an edge of a step.
fn forgets(model: &Model) -> bool {
    let is_of_inputs = |read: &Read| matches!(read, Read::Name(Name::Input(_) | Name::Param(_)));
    let stays = |read: &Read| match read {
        Read::Rising(id) | Read::Falling(id) => model.edges[*id].of.reads.iter().all(is_of_inputs),
        Read::Name(Name::Var(_) | Name::Output(_)) | Read::Delay(_) => false,
        // When times are over is taken to be open.
        _ => true,
    };
    model.forceable && !model.transitions.values().all(|transition| transition.condition.reads.iter().all(stays))
}

/// A row with the bits of these steps.
fn bits(steps: &[StepId], row: usize) -> Vec<u8> {
    let mut bytes = vec![0; row];
    for step in steps {
        bytes[step.index() / 8] |= 1_u8 << (step.index() % 8);
    }
    bytes
}
