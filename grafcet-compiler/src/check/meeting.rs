//! Which things meet, of those that belong to steps.

use std::collections::{BTreeMap, BTreeSet};

use crate::analysis::Concurrency;
use crate::model::StepId;

/// More pairs than this are not looked at: a chart has to be far out of order to have them.
const PAIRS: usize = 100_000;

/// The pairs of things, smaller number first, whose steps are the same or can be active together; a thing without a step
/// meets all.
pub(super) fn pairs(concurrency: &Concurrency, things: &[(usize, Option<StepId>)]) -> BTreeSet<(usize, usize)> {
    let mut at: BTreeMap<StepId, Vec<usize>> = BTreeMap::new();
    for (thing, step) in things {
        if let Some(step) = step {
            at.entry(*step).or_default().push(*thing);
        }
    }
    let mut found = BTreeSet::new();
    for (thing, step) in things {
        let others: Vec<usize> = match step {
            Some(step) => concurrency
                .beside(*step)
                .chain([*step])
                .filter_map(|other| at.get(&other))
                .flat_map(|things| things.iter().copied())
                .collect(),
            None => things.iter().map(|(other, _)| *other).collect(),
        };
        for other in others.into_iter().filter(|other| other != thing) {
            if found.len() >= PAIRS {
                return found;
            }
            found.insert((other.min(*thing), other.max(*thing)));
        }
    }
    found
}
