//! `grafcet`: in which order the stored actions of one evolution write.
//!
//! All of them see the values from before the evolution and are committed together (A6). A place can be written in its
//! place at once if no other action reads it and no action may write it without a change of the situation; any other
//! place is first written to a local, which tells whether the evolution changes anything (A25).

use crate::model::{Association, Effect, Model, Name, Place, Qualifier, Read};
use crate::sorted::Set;

/// The places that stored actions write.
pub struct Stored {
    /// Places that are collected in locals and committed at the end of the evolution.
    pub collected: Set<Place>,
}

impl Stored {
    pub(super) fn of(model: &Model) -> Self {
        let mut stored = Self { collected: Set::new() };
        if !model.is_grafcet() {
            return stored;
        }
        for transition in model.transitions.values() {
            stored.collected.extend(transition.clearing.iter().flat_map(Effect::writes));
            stored.collected.extend(transition.clearing.iter().flat_map(Effect::reads).flatten().filter_map(place));
        }
        let actions: Vec<&Association> = model.associations.values().filter(|a| is_stored(a)).collect();
        for action in &actions {
            if action.qualifier == Qualifier::On {
                stored.collected.extend(action.effect.writes());
            }
            let own = action.effect.writes();
            let read = action.reads().into_iter().flatten().filter_map(place);
            stored.collected.extend(read.filter(|place| !own.contains(place)));
        }
        // A block writes all its places in the same way.
        loop {
            let before = stored.collected.len();
            for action in &actions {
                if stored.is_collected(&action.effect) {
                    stored.collected.extend(action.effect.writes());
                }
            }
            if stored.collected.len() == before {
                // What is only read needs no local.
                let clearings = model.transitions.values().flat_map(|t| &t.clearing);
                let effects = actions.iter().map(|action| &action.effect).chain(clearings);
                let written: Set<Place> = effects.flat_map(Effect::writes).copied().collect();
                stored.collected.retain(|place| written.contains(place));
                return stored;
            }
        }
    }

    /// Whether the effect writes to locals first.
    #[must_use]
    pub fn is_collected(&self, effect: &Effect) -> bool {
        effect.writes().iter().any(|place| self.collected.contains(place))
    }
}

/// Whether the action acts at an instant.
#[must_use]
pub fn is_stored(association: &Association) -> bool {
    matches!(association.qualifier, Qualifier::S | Qualifier::R | Qualifier::P1 | Qualifier::P0 | Qualifier::On)
}

fn place(read: &Read) -> Option<Place> {
    match read {
        Read::Name(Name::Output(id)) => Some(Place::Output(*id)),
        Read::Name(Name::Var(id)) => Some(Place::Var(*id)),
        _ => None,
    }
}
