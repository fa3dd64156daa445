//! The connected pieces of partial grafcets: what evolves by itself.

use crate::analysis::Union;
use crate::list::List;
use crate::model::{Arena, Id, Model, StepId, ids};

ids! {
    /// A connected piece of a partial grafcet.
    pub(crate) UnitId;
}

/// Each step's piece, and how many there are.
pub(crate) fn of(model: &Model) -> (Arena<StepId, UnitId>, usize) {
    let mut union = Union::new(model.steps.len());
    for transition in model.transitions.values() {
        let mut steps = transition.sources.iter().and(&transition.targets).map(|step| step.index());
        let Some(first) = steps.next() else { continue };
        for other in steps {
            union.join(first, other);
        }
    }
    let mut known: Vec<Option<UnitId>> = vec![None; model.steps.len()];
    let mut count = 0;
    let units = Arena::of(&model.steps, |step, _| {
        *known[union.root(step.index())].get_or_insert_with(|| {
            count += 1;
            UnitId::new(count - 1)
        })
    });
    (units, count)
}
