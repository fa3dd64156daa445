//! `grafcet`: in which order the stored actions of one evolution write.
//!
//! All of them see the values from before the evolution and are committed together (A6). A place can be written in its
//! place at once if no other action reads it and no action may write it without a change of the situation; any other
//! place is first written to a local, which tells whether the evolution changes anything (A25).

use crate::analysis::{Races, combinational};
use crate::list::List;
use crate::model::{Association, AssociationId, Effect, Expr, Model, Name, Place, Qualifier, Read, Ty};
use crate::sorted::Set;

/// The places that stored actions write.
pub struct Stored {
    /// Places that are collected in locals and committed at the end of the evolution.
    pub collected: Set<Place>,
    /// Actions on activation and deactivation that look at nothing an evolution changes, and write what nothing in it looks at:
    /// it makes no difference when they act.
    pub at_any_time: Set<AssociationId>,
}

impl Stored {
    pub(super) fn of(model: &Model, races: &Races) -> Self {
        let mut stored = Self { collected: Set::new(), at_any_time: Set::new() };
        if !model.is_grafcet() {
            return stored;
        }
        for transition in model.transitions.values() {
            stored.collected.extend(transition.clearing.iter().flat(Effect::writes));
            stored.collected.extend(transition.clearing.iter().flat(Effect::reads).flatten().filter_map(place));
        }
        let actions: Vec<&Association> = model.associations.values().filter(|a| is_stored(a)).list();
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
                let clearings = model.transitions.values().flat(|t| &t.clearing);
                let effects = actions.iter().map(|action| &action.effect).and(clearings);
                let written: Set<Place> = effects.flat(Effect::writes).copied().collect();
                stored.collected.retain(|place| written.contains(place));
                stored.at_any_time = at_any_time(model, &stored.collected, races);
                return stored;
            }
        }
    }

    /// A forced evolution may leave and enter steps that never follow each other, whose actions then see each other's values unless all are collected.
    pub(super) fn collect_all(&mut self, model: &Model) {
        let actions = model.associations.values().filter(|association| model.is_grafcet() && is_stored(association));
        self.collected.extend(actions.flat(|action| action.effect.writes()).copied());
        self.at_any_time = Set::new();
    }

    /// Whether the effect writes to locals first.
    #[must_use]
    pub fn is_collected(&self, effect: &Effect) -> bool {
        effect.writes().iter().any(|place| self.collected.contains(place))
    }
}

/// Which actions can act at any time of an evolution. Where two race, the order of the source counts.
fn at_any_time(model: &Model, collected: &Set<Place>, races: &Races) -> Set<AssociationId> {
    let tested: Set<Place> = model.transitions.values().flat(|t| &t.condition.reads).filter_map(place).collect();
    let fits = |association: &Association| {
        let value = match &association.effect {
            Effect::Control(_) => None,
            Effect::Assign(_, value) => Some(value),
            Effect::Call(..) | Effect::Block(_) => return false,
        };
        is_stored(association)
            && association.event.is_none()
            && association
                .effect
                .writes()
                .iter()
                .all(|place| !collected.contains(place) && !tested.contains(place) && !races.are_about(*place))
            && association.condition.iter().and(value).all(|expr| stands_still(model, expr))
    };
    model.associations.iter().filter(|(_, association)| fits(association)).map(|(id, _)| id).collect()
}

/// Whether an expression reads but inputs, parameters and what is stored, and calls no function of the user.
fn stands_still(model: &Model, expr: &Expr) -> bool {
    let stored = |read: &Read| match read {
        Read::Name(Name::Var(var)) => combinational::asserted(model, *var).next().is_none(),
        read => matches!(read, Read::Name(_) | Read::Ticks(_)),
    };
    expr.reads.iter().all(stored) && (!expr.tree.is_opaque() || counts(model, expr))
}

/// `parts.wrapping_add(1)`: a method that Rust's integers have, of a declared one.
fn counts(model: &Model, expr: &Expr) -> bool {
    let syn::Expr::MethodCall(call) = &expr.tokens else { return false };
    let name = call.method.to_string();
    let integer = |read: &Read| match read {
        Read::Name(name) if matches!(model.ty(*name), Ty::Int { .. }) => Some(model.value_name(*name)),
        _ => None,
    };
    let receiver = match &*call.receiver {
        syn::Expr::Path(path) => path.path.get_ident(),
        _ => None,
    };
    (name.starts_with("wrapping_") || name.starts_with("saturating_"))
        && receiver.is_some_and(|receiver| expr.reads.iter().filter_map(integer).any(|name| name == receiver))
        && call.args.iter().all(|arg| matches!(arg, syn::Expr::Lit(_) | syn::Expr::Path(_)))
}

/// Whether the action acts at an instant.
#[must_use]
pub fn is_stored(association: &Association) -> bool {
    association.is_stored()
}

fn place(read: &Read) -> Option<Place> {
    match read {
        Read::Name(Name::Output(id)) => Some(Place::Output(*id)),
        Read::Name(Name::Var(id)) => Some(Place::Var(*id)),
        _ => None,
    }
}
