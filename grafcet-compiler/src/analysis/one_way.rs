//! What is stored with no way back, and what is taken back and never stored.

use super::Concurrency;
use crate::list::List;
use crate::model::{
    ActionId, Association, AssociationId, Effect, Model, Place, Qualifier, Statement, StepId, Tree, Ty,
};
use crate::sorted::{Map, Set};

/// What keeps a value: a boolean output or variable, or in an `sfc` an action.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Latched {
    Place(Place),
    Action(ActionId),
}

/// How something is set or reset.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// `S lamp`
    Control,
    /// `P1 lamp = true`
    Assignment,
    /// `lamp = true;` in a block.
    Statement,
}

/// What sets or resets.
#[derive(Clone, Copy)]
pub(crate) struct Switch {
    pub(crate) by: AssociationId,
    pub(crate) form: Form,
}

/// Which of the two is missing.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Missing {
    Set,
    Reset,
}

/// What is set and never reset, or the other way round.
pub(crate) struct OneWay {
    pub(crate) latched: Latched,
    pub(crate) missing: Missing,
    /// All that does the other one.
    pub(crate) switches: Vec<Switch>,
}

/// What the chart does to it.
#[derive(Default)]
struct Uses {
    /// What makes it true to stay.
    sets: Vec<Switch>,
    /// What makes it false.
    resets: Vec<Switch>,
    /// Steps in which it is true as long as something lasts: N, L, D and P of an `sfc`.
    shows: Vec<StepId>,
    /// Something gives it a value that is not known before.
    unknown: bool,
}

/// All of a chart, but for what is `mixed`.
pub(crate) fn one_way(model: &Model, concurrency: &Concurrency, mixed: &Set<Place>) -> Vec<OneWay> {
    let is_mixed = |latched: &Latched| matches!(latched, Latched::Place(place) if mixed.contains(place));
    let mut found = Vec::new();
    for (latched, uses) in collect(model).into_iter().filter(|(latched, uses)| !is_mixed(latched) && !uses.unknown) {
        let may_start_true = matches!(latched, Latched::Place(place) if model.may_start_true(place));
        let meets = |step: StepId| uses.shows.iter().any(|other| *other == step || concurrency.together(*other, step));
        let is_shown = |switch: &Switch| meets(model.associations[switch.by].step);
        // A variable may be a mark that something has happened, once and for all.
        let is_mark = matches!(latched, Latched::Place(Place::Var(_)));
        if uses.sets.is_empty() && !may_start_true && !uses.resets.iter().any(is_shown) {
            found.push(OneWay { latched, missing: Missing::Set, switches: uses.resets });
        } else if uses.resets.is_empty() && !is_mark {
            found.push(OneWay { latched, missing: Missing::Reset, switches: uses.sets });
        }
    }
    found
}

fn collect(model: &Model) -> Map<Latched, Uses> {
    let mut all: Map<Latched, Uses> = Map::new();
    for (id, association) in model.associations.iter() {
        match &association.effect {
            Effect::Control(place) => control(all.or_default(Latched::Place(*place)), id, association),
            Effect::Call(action, _) if !model.is_grafcet() => {
                control(all.or_default(Latched::Action(*action)), id, association);
            }
            Effect::Assign(place, value) if is_bool(model, *place) => {
                let uses = all.or_default(Latched::Place(*place));
                if association.qualifier.runs_once() {
                    assign(uses, &value.tree, Switch { by: id, form: Form::Assignment });
                } else {
                    uses.unknown = true;
                }
            }
            Effect::Call(..) | Effect::Assign(..) => {}
            Effect::Block(code) => match &code.statements {
                Some(statements) => statements.iter().for_each(|s| statement(&mut all, s, id)),
                None => written(&mut all, &association.effect),
            },
        }
    }
    for effect in model.transitions.values().flat(|transition| &transition.clearing) {
        written(&mut all, effect);
    }
    all
}

/// What is written in a way that is not looked into may get any value.
fn written(all: &mut Map<Latched, Uses>, effect: &Effect) {
    for place in effect.writes() {
        all.or_default(Latched::Place(*place)).unknown = true;
    }
}

fn control(uses: &mut Uses, id: AssociationId, association: &Association) {
    let switch = Switch { by: id, form: Form::Control };
    match association.qualifier {
        qualifier if qualifier.has_flip_flop() => uses.sets.push(switch),
        Qualifier::R => uses.resets.push(switch),
        _ => uses.shows.push(association.step),
    }
}

/// `P1 lamp = true`
fn assign(uses: &mut Uses, value: &Tree, switch: Switch) {
    match value {
        Tree::Bool(true) => uses.sets.push(switch),
        Tree::Bool(false) => uses.resets.push(switch),
        _ => uses.unknown = true,
    }
}

fn statement(all: &mut Map<Latched, Uses>, statement: &Statement, by: AssociationId) {
    match statement {
        Statement::Assign(place, value) => {
            assign(all.or_default(Latched::Place(*place)), value, Switch { by, form: Form::Statement });
        }
        Statement::If(_, then, otherwise) => {
            then.iter().and(otherwise).for_each(|inner| self::statement(all, inner, by));
        }
    }
}

fn is_bool(model: &Model, place: Place) -> bool {
    matches!(model.place_ty(place), Ty::Bool(_))
}
