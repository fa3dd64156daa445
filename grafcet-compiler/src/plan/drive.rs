//! How each output gets its value.

use super::{Control, What};
use crate::analysis::Concurrency;
use crate::list::List;
use crate::model::{Association, Dialect, Effect, Id, Model, Name, OutputId, Place, Qualifier, Read};
use crate::sorted::Set;

/// How one output gets its value.
pub struct Drive {
    /// Something is true of it in this cycle only (N, `speed = e`, P): a local collects it.
    pub continuous: bool,
    /// It keeps a value from cycle to cycle (S, R, P1 …): a field holds it.
    pub stored: bool,
    /// An R has to come after what else the cycle does to it: a flag waits for that.
    pub reset_flag: bool,
    /// An action reads its value of the cycle before, which the cycle may overwrite before.
    pub read_by_actions: bool,
    /// An expression reads it.
    pub read: bool,
    /// Its value of the cycle before is remembered only because it is read.
    pub last: bool,
}

impl Drive {
    /// Those of all outputs, for whoever needs no plan.
    #[must_use]
    pub fn all(model: &Model, concurrency: &Concurrency) -> Vec<Self> {
        all(model, concurrency, &Control::of(model, concurrency))
    }

    /// A field holds its value from cycle to cycle.
    #[must_use]
    pub fn is_remembered(&self) -> bool {
        self.stored || self.last
    }
}

/// The drives of all outputs.
pub(super) fn all(model: &Model, concurrency: &Concurrency, control: &Control) -> Vec<Drive> {
    let uses = Uses::of(model, control);
    model.outputs.ids().map(|output| of(concurrency, &uses, output)).list()
}

fn of(concurrency: &Concurrency, uses: &Uses<'_>, output: OutputId) -> Drive {
    let associations = &uses.associations[output.index()];
    let steps = |qualifier: Qualifier| associations.iter().filter(|a| a.qualifier == qualifier).map(|a| a.step).list();
    let continuous = associations.iter().any(|a| is_continuous(a));
    let resets = steps(Qualifier::R);
    let stored = associations.iter().any(|a| !is_continuous(a) && a.qualifier != Qualifier::R)
        || uses.cleared.contains(&output)
        || !resets.is_empty() && !continuous;
    let contended = steps(Qualifier::S)
        .iter()
        .any(|set| resets.iter().any(|reset| set == reset || concurrency.together(*set, *reset)));
    let (read, by_actions) = (uses.read.contains(&output), uses.read_by_actions.contains(&output));
    if uses.controlled.contains(&output) {
        // The action control computes its Q into a local.
        return Drive { continuous: true, stored: false, reset_flag: false, read_by_actions: false, read, last: read };
    }
    Drive {
        continuous,
        stored,
        reset_flag: !resets.is_empty() && (continuous || contended),
        read_by_actions: stored && !continuous && by_actions,
        read,
        last: (continuous || !stored) && read,
    }
}

/// Whether an association is about this cycle only.
fn is_continuous(association: &Association) -> bool {
    match association.effect {
        Effect::Control(_) => !association.qualifier.has_flip_flop() && association.qualifier != Qualifier::R,
        Effect::Assign(..) => association.qualifier == Qualifier::N,
        Effect::Call(..) | Effect::Block(_) => false,
    }
}

/// What is said of the outputs, collected in one walk.
struct Uses<'m> {
    /// By output, the associations that write it.
    associations: Vec<Vec<&'m Association>>,
    /// Outputs that actions on clearing write.
    cleared: Set<OutputId>,
    /// Outputs whose Q the action control computes.
    controlled: Set<OutputId>,
    /// In a `grafcet` only stored outputs can be read (A22), and their fields hold what is read: none is in here.
    read: Set<OutputId>,
    read_by_actions: Set<OutputId>,
}

impl<'m> Uses<'m> {
    fn of(model: &'m Model, control: &Control) -> Self {
        let mut associations = vec![Vec::new(); model.outputs.len()];
        let (mut cleared, mut read, mut read_by_actions) = (Set::new(), Set::new(), Set::new());
        for association in model.associations.values() {
            let written: Set<OutputId> = association.effect.writes().iter().copied().filter_map(written).collect();
            for output in written {
                associations[output.index()].push(association);
            }
            read_by_actions.extend(association.reads().into_iter().flatten().filter_map(output));
        }
        for effect in model.transitions.values().flat(|t| &t.clearing) {
            cleared.extend(effect.writes().iter().copied().filter_map(written));
        }
        if model.dialect == Dialect::Sfc {
            read.extend(model.expressions().into_iter().flatten().filter_map(output));
        }
        let controlled = control.targets.iter().filter_map(|target| match target.what {
            What::Boolean(Place::Output(output)) => Some(output),
            _ => None,
        });
        Self { associations, cleared, controlled: controlled.collect(), read, read_by_actions }
    }
}

fn output(read: &Read) -> Option<OutputId> {
    match read {
        Read::Name(Name::Output(output)) => Some(*output),
        _ => None,
    }
}

fn written(place: Place) -> Option<OutputId> {
    match place {
        Place::Output(output) => Some(output),
        Place::Var(_) => None,
    }
}
