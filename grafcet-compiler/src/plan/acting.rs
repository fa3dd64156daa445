//! Whether the arms of parallel branches that evolve in place act, too: one dispatch for each branch, and not one to evolve and one to
//! act.

use super::{BranchGroup, Control, Drive, Shape};
use crate::model::{Association, Effect, Id, Model, Name, Place, Qualifier, Read, StepId};

/// In instructions of a Cortex-M3, what each branch saves in a cycle: state, range, table, and the state written anew where it waits.
const SAVED: usize = 6;

/// In bytes, what an action takes in one more place, and what a dispatch takes that falls away.
const ACTION: usize = 4;
const DISPATCH: usize = 10;

/// Bytes that an instruction in each cycle is worth.
const WORTH: usize = 2;

/// Whether it is possible, and not too large: each transition acts for the steps it enters.
pub(super) fn acts_in_arms(
    model: &Model,
    shape: &Shape,
    groups: &[BranchGroup],
    drives: &[Drive],
    control: &Control,
) -> bool {
    let [group] = groups else { return false };
    if model.is_grafcet() || !shape.is_in_place() || group.head != 0 || !control.targets.is_empty() {
        return false;
    }
    if !model.associations.values().all(|association| acts_alone(association, drives)) {
        return false;
    }
    let acts = |steps: &[StepId]| steps.iter().map(|step| model.steps[*step].associations.len()).sum::<usize>();
    let more = ACTION * model.transitions.values().map(|transition| acts(&transition.targets)).sum::<usize>();
    let branches = group.regions.len();
    more <= branches * (DISPATCH + WORTH * SAVED)
}

/// Whether an action does the same wherever in the cycle it stands after the evolution of its own branch: it looks at nothing that
/// other branches change, and waits for no other action.
fn acts_alone(association: &Association, drives: &[Drive]) -> bool {
    let Effect::Control(Place::Output(output)) = association.effect else { return false };
    let still = |read: &Read| matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_));
    let drive = &drives[output.index()];
    matches!(association.qualifier, Qualifier::N | Qualifier::S | Qualifier::R)
        && !drive.reset_flag
        && !drive.read
        && association.time.is_none()
        && association
            .condition
            .iter()
            .all(|condition| !condition.tree.is_opaque() && condition.reads.iter().all(still))
}
