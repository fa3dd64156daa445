//! `set_without_reset`, `reset_without_set`: what is stored with no way back, and what is taken back and never stored.

use crate::analysis::Concurrency;
use crate::diagnostic::{Mark, Rule, Sink, rules};
use crate::list::List;
use crate::model::{ActionId, Association, Effect, LevelAttr, Model, Place, Qualifier, Statement, StepId, Tree, Ty};
use crate::sorted::{Map, Set};

/// What keeps a value: a boolean output or variable, or in an `sfc` an action.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Stored {
    Place(Place),
    Action(ActionId),
}

/// A place in the source that sets or resets.
struct Write {
    mark: Mark,
    step: StepId,
    /// `lamp = true`, not `S lamp`.
    is_assignment: bool,
}

/// What the chart does to it.
#[derive(Default)]
struct Uses {
    /// What makes it true to stay.
    sets: Vec<Write>,
    /// What makes it false.
    resets: Vec<Write>,
    /// Steps in which it is true as long as something lasts: N, L, D and P of an `sfc`.
    shows: Vec<StepId>,
    /// Something gives it a value that is not known before.
    unknown: bool,
}

/// Leaves out what is `mixed` already.
pub(super) fn check(model: &Model, concurrency: &Concurrency, mixed: &Set<Place>, sink: &mut Sink) {
    let is_mixed = |stored: &Stored| matches!(stored, Stored::Place(place) if mixed.contains(place));
    for (stored, uses) in collect(model).into_iter().filter(|(stored, _)| !is_mixed(stored)) {
        let (name, levels, may_start_true) = match stored {
            Stored::Place(place) => {
                (model.place_name(place), model.levels_of_place(place), model.may_start_true(place))
            }
            Stored::Action(id) => (&model.actions[id].name, &model.actions[id].levels[..], false),
        };
        if uses.unknown {
            continue;
        }
        // A variable may be a mark that something has happened, once and for all.
        if uses.resets.is_empty() && !matches!(stored, Stored::Place(Place::Var(_))) {
            let message = |write: &Write| {
                let (reset, alone) = if write.is_assignment {
                    (format!("P1 {name} = false"), String::new())
                } else {
                    (format!("R {name}"), format!(", or `{name}` alone if it shall last as long as this step"))
                };
                format!("`{name}` is set here and nothing ever resets it; write `{reset}` where it ends{alone}")
            };
            report(model, &rules::SET_WITHOUT_RESET, levels, &uses.sets, message, sink);
        }
        let meets = |step: StepId| uses.shows.iter().any(|other| *other == step || concurrency.together(*other, step));
        if uses.sets.is_empty() && !may_start_true && !uses.resets.iter().any(|write| meets(write.step)) {
            let message = |write: &Write| {
                let set = if write.is_assignment { format!("P1 {name} = true") } else { format!("S {name}") };
                format!(
                    "`{name}` is reset here and nothing ever sets it; write `{set}` where it begins, or remove this"
                )
            };
            report(model, &rules::RESET_WITHOUT_SET, levels, &uses.resets, message, sink);
        }
    }
}

/// A message at each place, so that each can be allowed.
fn report(
    model: &Model,
    rule: &'static Rule,
    levels: &[LevelAttr],
    places: &[Write],
    message: impl Fn(&Write) -> String,
    sink: &mut Sink,
) {
    for write in places {
        let mut scopes = model.levels_of(&model.steps[write.step]);
        scopes.insert(1, levels);
        sink.rule(rule, &scopes, vec![(write.mark, message(write))]);
    }
}

fn collect(model: &Model) -> Map<Stored, Uses> {
    let mut all: Map<Stored, Uses> = Map::new();
    for association in model.associations.values() {
        match &association.effect {
            Effect::Control(place) => control(all.or_default(Stored::Place(*place)), association),
            Effect::Call(action, _) if !model.is_grafcet() => {
                control(all.or_default(Stored::Action(*action)), association);
            }
            Effect::Assign(place, value) if is_bool(model, *place) => {
                let uses = all.or_default(Stored::Place(*place));
                if association.qualifier.runs_once() {
                    assign(uses, &value.tree, association.mark, association.step);
                } else {
                    uses.unknown = true;
                }
            }
            Effect::Call(..) | Effect::Assign(..) => {}
            Effect::Block(code) => match &code.statements {
                Some(statements) => statements.iter().for_each(|s| statement(&mut all, s, association)),
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
fn written(all: &mut Map<Stored, Uses>, effect: &Effect) {
    for place in effect.writes() {
        all.or_default(Stored::Place(*place)).unknown = true;
    }
}

fn control(uses: &mut Uses, association: &Association) {
    let target = association.target_mark;
    let mark = association.qualifier_mark.unwrap_or(target).to(target);
    let write = Write { mark, step: association.step, is_assignment: false };
    match association.qualifier {
        qualifier if qualifier.has_flip_flop() => uses.sets.push(write),
        Qualifier::R => uses.resets.push(write),
        _ => uses.shows.push(association.step),
    }
}

/// `P1 lamp = true`
fn assign(uses: &mut Uses, value: &Tree, mark: Mark, step: StepId) {
    let write = Write { mark, step, is_assignment: true };
    match value {
        Tree::Bool(true) => uses.sets.push(write),
        Tree::Bool(false) => uses.resets.push(write),
        _ => uses.unknown = true,
    }
}

fn statement(all: &mut Map<Stored, Uses>, statement: &Statement, association: &Association) {
    match statement {
        Statement::Assign(place, value) => {
            assign(all.or_default(Stored::Place(*place)), value, association.target_mark, association.step);
        }
        Statement::If(_, then, otherwise) => {
            then.iter().and(otherwise).for_each(|inner| self::statement(all, inner, association));
        }
    }
}

fn is_bool(model: &Model, place: Place) -> bool {
    matches!(model.place_ty(place), Ty::Bool(_))
}
