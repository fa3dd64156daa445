//! Which things meet, of those that belong to steps.

use super::Concurrency;
use crate::list::List;
use crate::model::StepId;
use crate::sorted::{Map, Set};

/// More pairs than this are not looked at: a chart has to be far out of order to have them.
const PAIRS: usize = 100_000;

/// The pairs of things, smaller number first, whose steps are the same or can be active together; a thing without a step
/// meets all.
pub(crate) fn pairs(concurrency: &Concurrency, things: &[(usize, Option<StepId>)]) -> Set<(usize, usize)> {
    let mut at: Map<StepId, Vec<usize>> = Map::new();
    for (thing, step) in things {
        if let Some(step) = step {
            at.or_default(*step).push(*thing);
        }
    }
    let mut found = Set::new();
    for (thing, step) in things {
        let others: Vec<usize> = match step {
            Some(step) => concurrency
                .beside(*step)
                .and([*step])
                .filter_map(|other| at.get(&other))
                .flat(|things| things.iter().copied())
                .list(),
            None => things.iter().map(|(other, _)| *other).list(),
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
