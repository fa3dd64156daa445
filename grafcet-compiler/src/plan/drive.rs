//! How each output gets its value.

use super::{Control, What};
use crate::analysis::Concurrency;
use crate::model::{Association, Dialect, Effect, Model, Name, OutputId, Place, Qualifier, Read, StepId};

/// How one output gets its value.
pub struct Drive {
    /// Something is true of it in this cycle only (N, `speed = e`, P): a local collects it.
    pub continuous: bool,
    /// It keeps a value from cycle to cycle (S, R, P1 …): a field holds it.
    pub stored: bool,
    /// An R has to come behind what else the cycle does to it: a flag waits for that.
    pub reset_flag: bool,
    /// An action reads its value of the cycle before, which the cycle may overwrite before.
    pub read_by_actions: bool,
    /// An expression reads it.
    pub read: bool,
    /// Its value of the cycle before is remembered only because it is read.
    pub last: bool,
}

/// The drives of all outputs.
pub(super) fn all(model: &Model, concurrency: &Concurrency, control: &Control) -> Vec<Drive> {
    model.outputs.ids().map(|output| of(model, concurrency, control, output)).collect()
}

fn of(model: &Model, concurrency: &Concurrency, control: &Control, output: OutputId) -> Drive {
    let mine = |association: &&Association| writes(&association.effect, output);
    let associations: Vec<_> = model.associations.values().filter(mine).collect();
    let steps = |qualifier: Qualifier| {
        associations.iter().filter(|a| a.qualifier == qualifier).map(|a| a.step).collect::<Vec<StepId>>()
    };
    let continuous = associations.iter().any(|a| is_continuous(a));
    let resets = steps(Qualifier::R);
    let stored = associations.iter().any(|a| !is_continuous(a) && a.qualifier != Qualifier::R)
        || model.transitions.values().flat_map(|t| &t.clearing).any(|effect| writes(effect, output))
        || !resets.is_empty() && !continuous;
    let contended = steps(Qualifier::S)
        .iter()
        .any(|set| resets.iter().any(|reset| set == reset || concurrency.together(*set, *reset)));
    let read = reads(model, output);
    if control.targets.iter().any(|target| target.what == What::Boolean(Place::Output(output))) {
        // The action control computes its Q into a local.
        return Drive {
            continuous: true,
            stored: false,
            reset_flag: false,
            read_by_actions: false,
            read: read.anywhere,
            last: read.anywhere,
        };
    }
    Drive {
        continuous,
        stored,
        reset_flag: !resets.is_empty() && (continuous || contended),
        read_by_actions: stored && !continuous && read.by_actions,
        read: read.anywhere,
        last: (continuous || !stored) && read.anywhere,
    }
}

/// Whether an association is about this cycle only.
fn is_continuous(association: &Association) -> bool {
    match association.effect {
        Effect::Control(_) => !matches!(
            association.qualifier,
            Qualifier::S | Qualifier::R | Qualifier::Sd | Qualifier::Ds | Qualifier::Sl
        ),
        Effect::Assign(..) => association.qualifier == Qualifier::N,
        Effect::Call(..) | Effect::Block(_) => false,
    }
}

fn writes(effect: &Effect, output: OutputId) -> bool {
    match effect {
        Effect::Control(place) | Effect::Assign(place, _) => *place == Place::Output(output),
        Effect::Block(code) => code.writes.contains(&Place::Output(output)),
        Effect::Call(..) => false,
    }
}

struct Reads {
    anywhere: bool,
    by_actions: bool,
}

fn reads(model: &Model, output: OutputId) -> Reads {
    let read = Read::Name(Name::Output(output));
    let by_actions = model.associations.values().any(|a| {
        let conditions = a.condition.iter().chain(&a.event).map(|e| &e.reads[..]);
        conditions.chain(a.effect.reads()).any(|reads| reads.contains(&read))
    });
    Reads {
        // In a `grafcet` only stored outputs can be read (A22), and their fields hold what is read.
        anywhere: model.dialect == Dialect::Sfc && model.expressions().any(|reads| reads.contains(&read)),
        by_actions,
    }
}
