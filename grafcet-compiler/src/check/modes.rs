//! `mixed_modes`: one output or variable has one kind of action (A8).

use syn::Ident;

use super::targets;
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::List;
use crate::model::{Association, Dialect, Effect, Model, Place, Qualifier};

/// What actions do with a place.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    /// `grafcet`: while a step is active. `sfc`: `speed = e`.
    Assigned,
    /// `grafcet`: at an instant. `sfc`: written by a run, `P1 speed = e` or a block.
    Written,
    /// `sfc`: by the action control, `N q`, `S q`.
    Controlled,
}

pub(super) fn check(model: &Model, sink: &mut Sink) {
    let places = model.outputs.ids().map(Place::Output).and(model.vars.ids().map(Place::Var));
    for place in places {
        let uses = uses(model, place);
        let Some(first) = uses.first() else { continue };
        let Some(other) = uses.iter().find(|other| other.mode != first.mode) else { continue };
        let name = model.place_name(place);
        let note = |here: &Use, elsewhere: &Use| {
            let message = format!(
                "`{name}` is {} here and {} {}; keep to one of them, or use two names",
                word(model, here.mode),
                word(model, elsewhere.mode),
                if elsewhere.place == here.place {
                    "in the same step".to_owned()
                } else {
                    format!("in {}", elsewhere.place)
                }
            );
            (here.mark, message + &here.unsure(name))
        };
        sink.rule(&rules::MIXED_MODES, &[], vec![note(first, other), note(other, first)]);
    }
}

/// Something that acts on a place.
struct Use {
    mode: Mode,
    mark: Mark,
    /// `` step `On` ``
    place: String,
    /// What may write the place there, where nobody can know: `n.bump(…)`.
    unsure: Option<String>,
}

impl Use {
    /// What to write where a call only reads.
    fn unsure(&self, name: &Ident) -> String {
        let Some(call) = &self.unsure else { return String::new() };
        format!(". `{call}` counts as writing `{name}`; if it only reads, hand it a copy: `let value = {name};`")
    }
}

fn uses(model: &Model, place: Place) -> Vec<Use> {
    // What is refused as it stands takes no part.
    let fits = |association: &&Association| targets::mistake(model, association).is_none();
    let of_steps = model.associations.values().filter(|a| a.effect.writes().contains(&place)).filter(fits);
    let of_steps = of_steps.map(|association| Use {
        mode: mode(model, association),
        mark: association.mark,
        place: format!("step `{}`", model.steps[association.step].name),
        unsure: association.effect.unsure(place).map(str::to_owned),
    });
    let mut uses: Vec<Use> = of_steps.list();
    for transition in model.transitions.values().filter(|_| model.is_grafcet()) {
        for effect in transition.clearing.iter().filter(|effect| effect.writes().contains(&place)) {
            uses.push(Use {
                mode: Mode::Written,
                mark: transition.mark,
                place: format!("the transition {}", model.transition_text(transition)),
                unsure: effect.unsure(place).map(str::to_owned),
            });
        }
    }
    uses
}

fn mode(model: &Model, association: &Association) -> Mode {
    if model.dialect == Dialect::Grafcet {
        return if association.is_stored() { Mode::Written } else { Mode::Assigned };
    }
    match &association.effect {
        Effect::Control(_) => Mode::Controlled,
        Effect::Assign(Place::Output(_), _) if association.qualifier == Qualifier::N => Mode::Assigned,
        _ => Mode::Written,
    }
}

fn word(model: &Model, mode: Mode) -> &'static str {
    match (model.dialect, mode) {
        (Dialect::Grafcet, Mode::Assigned) => "assigned while a step is active (continuous action)",
        (Dialect::Grafcet, _) => "set at an instant (stored action)",
        (Dialect::Sfc, Mode::Assigned) => "given a value while a step is active",
        (Dialect::Sfc, Mode::Written) => "written by an action",
        (Dialect::Sfc, Mode::Controlled) => "switched by its qualifiers",
    }
}
