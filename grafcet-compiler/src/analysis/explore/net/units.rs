//! The connected pieces of partial grafcets: what evolves by itself.

use crate::analysis::Union;
use crate::list::List;
use crate::model::{Arena, Id, Model, StepId};

/// The number of each step's piece, and how many there are.
pub(crate) fn of(model: &Model) -> (Arena<StepId, usize>, usize) {
    let mut union = Union::new(model.steps.len());
    for transition in model.transitions.values() {
        let mut steps = transition.sources.iter().and(&transition.targets).map(|step| step.index());
        let Some(first) = steps.next() else { continue };
        for other in steps {
            union.join(first, other);
        }
    }
    let mut numbers = vec![usize::MAX; model.steps.len()];
    let mut count = 0;
    let units = Arena::of(&model.steps, |step, _| {
        let root = union.root(step.index());
        if numbers[root] == usize::MAX {
            numbers[root] = count;
            count += 1;
        }
        numbers[root]
    });
    (units, count)
}
