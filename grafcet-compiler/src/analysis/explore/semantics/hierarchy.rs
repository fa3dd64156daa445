//! `grafcet`: an evolution of partial grafcets that force and enclose each other (A11-A19).

use super::{Done, evolve as clear, note_doubled};
use crate::analysis::explore::net::{Net, Order};
use crate::list::{List, PushAll};
use crate::model::{PartialId, StepId, TransitionId};
use crate::sorted::sort_unstable;

/// Whether what stands above imposes nothing new in an evolution from a situation that an evolution has led to: no step
/// that gives orders or encloses is left or entered.
pub(crate) fn is_free(net: &Net, fireable: &[TransitionId]) -> bool {
    let governs = |step: &StepId| net.governs[*step];
    let mut arcs = fireable.iter().map(|transition| &net.arcs[*transition]);
    !arcs.any(|arc| arc.sources.iter().and(&arc.targets).any(governs))
}

/// The situation after the evolution, and the transitions cleared in it.
pub(crate) fn evolve(
    net: &Net,
    before: &[StepId],
    fireable: &[TransitionId],
    done: &mut Done,
) -> (Vec<StepId>, Vec<TransitionId>) {
    let mut after: Vec<StepId> = Vec::new();
    let mut cleared = Vec::new();
    for part in &net.hierarchy {
        let here: Vec<StepId> = before.iter().filter(|step| net.part_of[**step] == *part).copied().list();
        let later = match imposed(net, *part, &here, before, &after) {
            Some(situation) => situation,
            None => {
                let own = fireable.iter().filter(|transition| net.arcs[**transition].partial == *part);
                let own: Vec<TransitionId> = own.copied().list();
                let left: Vec<StepId> = own.iter().flat(|t| &net.arcs[*t].sources).copied().list();
                let targets: Vec<StepId> = own.iter().flat(|t| &net.arcs[*t].targets).copied().list();
                note_doubled(net, before, &left, &own, done);
                cleared.push_all(own);
                clear(&here, &left, &targets)
            }
        };
        after.push_all(later);
        sort_unstable(&mut after);
    }
    sort_unstable(&mut cleared);
    (after, cleared)
}

/// The situation that what stands above imposes on a partial grafcet; none where it is free. `above` is the situation
/// after the evolution of what stands above.
fn imposed(net: &Net, part: PartialId, here: &[StepId], before: &[StepId], above: &[StepId]) -> Option<Vec<StepId>> {
    match net.order(part, above) {
        Some(Order::To(steps)) => return Some(steps.clone()),
        Some(Order::Hold) => return Some(here.to_vec()),
        None => {}
    }
    let enclosing = net.parts[part].enclosed_by?;
    match (before.binary_search(&enclosing).is_ok(), above.binary_search(&enclosing).is_ok()) {
        (_, false) => Some(Vec::new()),
        (false, true) => Some(net.parts[part].linked.clone()),
        (true, true) => None,
    }
}
