//! `wrong_target`: a qualifier whose target it cannot have.

use crate::diagnostic::{Sink, rules};
use crate::model::{Association, Dialect, Effect, Model, Place, Qualifier, Tree, Ty};

pub(super) fn check(model: &Model, sink: &mut Sink) {
    for association in model.associations.values() {
        if let Some(message) = mistake(model, association) {
            sink.rule(&rules::WRONG_TARGET, &[], vec![(association.mark, message)]);
        }
    }
}

fn mistake(model: &Model, association: &Association) -> Option<String> {
    let word = word(association.qualifier);
    if model.dialect == Dialect::Grafcet {
        let only_sfc = matches!(association.qualifier, Qualifier::P | Qualifier::Sd | Qualifier::Ds | Qualifier::Sl);
        if only_sfc {
            return Some(format!(
                "`{word}` is a qualifier of IEC 61131-3, a `grafcet` does not have it; \
                 write a condition (`q if 5s/Step`) or a stored action (`S`, `R`, `P1`, `P0`)"
            ));
        }
    } else if association.qualifier == Qualifier::On {
        return Some(
            "an action on an event is a form of IEC 60848, an `sfc` does not have it; \
                     write a step that waits for the event"
                .to_owned(),
        );
    }
    match &association.effect {
        Effect::Control(place) => control(model, association, *place, word),
        Effect::Assign(place, value) => assign(model, association, *place, &value.text, word),
        Effect::Call(..) | Effect::Block(_) => body(model, association, word),
    }
}

/// A boolean that is controlled.
fn control(model: &Model, association: &Association, place: Place, word: &str) -> Option<String> {
    let name = model.place_name(place);
    if !matches!(model.place_ty(place), Ty::Bool(_)) {
        return Some(format!(
            "`{name}` is not a `bool`, so it is not simply on or off; write what it shall be: `{name} = …`"
        ));
    }
    match association.qualifier {
        Qualifier::P1 | Qualifier::P0 | Qualifier::On => Some(format!(
            "`{word}` runs once and does not keep `{name}` on; write `P {name}` for a pulse, `S {name}` to set it, \
             or `{word} {name} = true`"
        )),
        Qualifier::N | Qualifier::L | Qualifier::D if starts_true(model, place) => Some(format!(
            "`{name}` starts as `true`, so an action that is true while a step is active cannot be seen; \
             start it as `false`, or write `S {name}` and `R {name}`"
        )),
        _ => None,
    }
}

fn starts_true(model: &Model, place: Place) -> bool {
    let init = match place {
        Place::Output(id) => model.outputs[id].init.as_ref(),
        Place::Var(id) => model.vars[id].init.as_ref(),
    };
    init.is_some_and(|init| init.tree == Tree::Bool(true))
}

/// `speed = e` behind a qualifier.
fn assign(model: &Model, association: &Association, place: Place, value: &str, word: &str) -> Option<String> {
    let name = model.place_name(place);
    match (association.qualifier, place) {
        (Qualifier::N, Place::Var(_)) if model.is_grafcet() => Some(format!(
            "`{name}` is a variable, which a `grafcet` writes at an instant, not while a step is active; \
             write `P1 {name} = {value}`"
        )),
        (Qualifier::N | Qualifier::P1 | Qualifier::P0 | Qualifier::On, _) => None,
        (Qualifier::S | Qualifier::R, _) if matches!(model.place_ty(place), Ty::Bool(_)) => {
            Some(format!("`{word}` already says what `{name}` becomes; write `{word} {name}`"))
        }
        (Qualifier::R, _) => Some(format!("`R` ends an action, it does not assign; write `P1 {name} = {value}`")),
        (_, Place::Output(_)) | (Qualifier::S | Qualifier::L | Qualifier::D, _) if model.is_grafcet() => {
            Some(format!("`{word}` cannot assign a value; write `P1 {name} = {value}`"))
        }
        _ => None,
    }
}

/// A call or a block behind a qualifier.
fn body(model: &Model, association: &Association, word: &str) -> Option<String> {
    match (association.qualifier, &association.effect) {
        (Qualifier::R, Effect::Block(_)) => Some(
            "`R` ends an action that another step has set, and a block is an action of its own; \
                  declare an `action` and name it in both steps"
                .to_owned(),
        ),
        (Qualifier::S | Qualifier::R | Qualifier::L | Qualifier::D, _) if model.is_grafcet() => Some(format!(
            "`{word}` acts on a boolean in a `grafcet`; write `P1` or `P0` in front of what shall run once"
        )),
        (Qualifier::N, Effect::Block(_)) if model.is_grafcet() => {
            Some("a block runs at an instant in a `grafcet`, not while a step is active; write `P1 { … }`".to_owned())
        }
        _ => None,
    }
}

/// A qualifier as the user writes it.
fn word(qualifier: Qualifier) -> &'static str {
    match qualifier {
        Qualifier::N => "N",
        Qualifier::S => "S",
        Qualifier::R => "R",
        Qualifier::L => "L",
        Qualifier::D => "D",
        Qualifier::P => "P",
        Qualifier::P1 => "P1",
        Qualifier::P0 => "P0",
        Qualifier::Sd => "SD",
        Qualifier::Ds => "DS",
        Qualifier::Sl => "SL",
        Qualifier::On => "on",
    }
}
