//! `wrong_target`: a qualifier whose target it cannot have.

use quote::ToTokens;

use crate::diagnostic::{Mark, Sink, rules};
use crate::model::{Association, Dialect, Effect, Model, Place, Qualifier, Ty};

pub(super) fn check(model: &Model, sink: &mut Sink) {
    for association in model.associations.values() {
        if let Some((mark, message)) = mistake(model, association) {
            sink.rule(&rules::WRONG_TARGET, &[], vec![(mark, message)]);
        }
    }
}

/// What is wrong, at the tokens that say it: the qualifier, its target, or from one to the other where only the pair is.
pub(super) fn mistake(model: &Model, association: &Association) -> Option<(Mark, String)> {
    let target = association.target_mark;
    let qualifier = association.qualifier_mark.unwrap_or(target);
    let pair = qualifier.to(target);
    if let Some(message) = other_dialect(model, association.qualifier) {
        return Some((qualifier, message));
    }
    match &association.effect {
        Effect::Control(place) if !may_be_bool(model.place_ty(*place)) => {
            Some((pair, not_bool(model, association.qualifier, *place)))
        }
        Effect::Control(place) if model.starts_true(*place) && association.qualifier.shows_with_its_step() => {
            let name = model.place_name(*place);
            let message = format!(
                "`{name}` starts as `true`, so an action that makes it true while a step is active cannot be seen; \
                 start it as `false`, or write `S {name}` and `R {name}`"
            );
            Some((target, message))
        }
        Effect::Control(place) => once(model, association.qualifier, *place).map(|message| (pair, message)),
        Effect::Assign(place, value) => {
            assign(model, association.qualifier, *place, &value.text).map(|message| (pair, message))
        }
        Effect::Call(..) => body(model, association.qualifier, "a call").map(|message| (pair, message)),
        Effect::Block(_) => body(model, association.qualifier, "a block").map(|message| (qualifier, message)),
    }
}

/// Qualifiers that only the other standard has.
fn other_dialect(model: &Model, qualifier: Qualifier) -> Option<String> {
    let word = qualifier.word();
    if qualifier.is_of(model.dialect) {
        return None;
    }
    Some(match model.dialect {
        Dialect::Grafcet => format!(
            "`{word}` is a qualifier of IEC 61131-3 and a `grafcet` does not have it; \
             write a condition, such as `q if 5s/Step`, or a stored action: `S`, `R`, `P1`, `P0` or `on`"
        ),
        Dialect::Sfc => "an action on an event is a form of IEC 60848 and an `sfc` does not have it; \
             write a step that waits for the event, or `N q if rising(…)`"
            .to_owned(),
    })
}

/// A name like `boool` is no known type: an alias of `bool`, or a slip of the pen that rustc reports.
fn may_be_bool(ty: &Ty) -> bool {
    match ty {
        Ty::Bool(_) => true,
        Ty::Other(ty) => {
            let name = written(ty);
            let known = ["f32", "f64", "char", "str"].contains(&name.as_str());
            !known && name.chars().all(|c| c.is_alphanumeric() || c == '_') && name.starts_with(char::is_lowercase)
        }
        _ => false,
    }
}

/// A value that is neither true nor false.
fn not_bool(model: &Model, qualifier: Qualifier, place: Place) -> String {
    let name = model.place_name(place);
    let ty = text_of(model.place_ty(place));
    let mend = match (qualifier, place) {
        (Qualifier::N, Place::Output(_)) => format!("{name} = …"),
        (Qualifier::On, _) => format!("on … {name} = …"),
        (Qualifier::P0, _) => format!("P0 {name} = …"),
        (Qualifier::N, Place::Var(_)) if !model.is_grafcet() => format!("N {name} = …"),
        _ => format!("P1 {name} = …"),
    };
    format!("`{name}` is a `{ty}`, so it is not simply on or off; say what it becomes: `{mend}`")
}

/// A type as the chart writes it.
pub(super) fn text_of(ty: &Ty) -> String {
    match ty {
        Ty::Time(_) => "time".to_owned(),
        Ty::Bool(ty) | Ty::Int { rust: ty, .. } | Ty::Other(ty) => written(ty),
    }
}

/// A type as one writes it, without the blanks between its tokens.
fn written(ty: &syn::Type) -> String {
    let text = ty.to_token_stream().to_string();
    [" < ", " >", " ;", " :: "].into_iter().fold(text, |text, wide| text.replace(wide, wide.trim()))
}

/// A bare boolean after a qualifier that runs something once.
fn once(model: &Model, qualifier: Qualifier, place: Place) -> Option<String> {
    if !qualifier.runs_once() {
        return None;
    }
    let (name, word) = (model.place_name(place), qualifier.word());
    let assignment = match qualifier {
        Qualifier::On => format!("on … {name} = true"),
        _ => format!("{word} {name} = true"),
    };
    let others = match (qualifier, model.is_grafcet()) {
        (Qualifier::P1, false) => format!("`P {name}` for one pulse, `S {name}` to set it, or "),
        (Qualifier::P1, true) => format!("`S {name}` to set it, or "),
        _ => String::new(),
    };
    Some(format!("`{word}` runs once and does not say what `{name}` becomes; write {others}`{assignment}`"))
}

/// `speed = e` after a qualifier.
fn assign(model: &Model, qualifier: Qualifier, place: Place, value: &str) -> Option<String> {
    let (name, word) = (model.place_name(place), qualifier.word());
    match (qualifier, place) {
        (Qualifier::N, Place::Var(_)) if model.is_grafcet() => Some(format!(
            "`{name}` is a variable, which a `grafcet` writes at an instant, not while a step is active; \
             write `P1 {name} = {value}`"
        )),
        (Qualifier::N | Qualifier::P1 | Qualifier::P0 | Qualifier::On, _) => None,
        (Qualifier::S | Qualifier::R, _) if matches!(model.place_ty(place), Ty::Bool(_)) => {
            Some(format!("`{word}` already says what `{name}` becomes; write `{word} {name}`"))
        }
        (Qualifier::R, _) => Some(format!("`R` ends an action and assigns nothing; write `P1 {name} = {value}`")),
        _ if model.is_grafcet() => Some(format!("`{word}` cannot assign a value; write `P1 {name} = {value}`")),
        _ => None,
    }
}

/// A call or a block after a qualifier.
fn body(model: &Model, qualifier: Qualifier, what: &str) -> Option<String> {
    let word = qualifier.word();
    match qualifier {
        Qualifier::R if what == "a block" => Some(
            "`R` ends an action that another step has set, and a block is an action of its own; \
             declare an `action` and name it in both steps"
                .to_owned(),
        ),
        Qualifier::S | Qualifier::R | Qualifier::L | Qualifier::D if model.is_grafcet() => Some(format!(
            "`{word}` acts on a boolean in a `grafcet`, not on {what}; write `P1`, `P0` or `on` in front of what runs once"
        )),
        Qualifier::N if what == "a block" && model.is_grafcet() => {
            Some("a block runs at an instant in a `grafcet`, not while a step is active; write `P1 { … }`".to_owned())
        }
        _ => None,
    }
}
