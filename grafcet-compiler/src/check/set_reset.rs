//! `set_without_reset`, `reset_without_set`: what is stored with no way back, and what is taken back and never stored.

use crate::analysis::Concurrency;
use crate::analysis::one_way::{Form, Latched, Missing, OneWay, Switch, one_way};
use crate::diagnostic::{Mark, Sink, rules};
use crate::model::{Association, Model, Place};
use crate::sorted::Set;

/// Leaves out what is `mixed` already.
pub(super) fn check(model: &Model, concurrency: &Concurrency, mixed: &Set<Place>, sink: &mut Sink) {
    for OneWay { latched, missing, switches } in &one_way(model, concurrency, mixed) {
        let (name, levels) = match *latched {
            Latched::Place(place) => (model.place_name(place), model.levels_of_place(place)),
            Latched::Action(id) => (&model.actions[id].name, &model.actions[id].levels[..]),
        };
        // A message at each place, so that each can be allowed.
        for Switch { by, form } in switches {
            let association = &model.associations[*by];
            let is_control = *form == Form::Control;
            let (rule, message) = match missing {
                Missing::Reset => {
                    let (reset, alone) = if is_control {
                        (format!("R {name}"), format!(", or `{name}` alone if it shall last as long as this step"))
                    } else {
                        (format!("P1 {name} = false"), String::new())
                    };
                    let message = format!(
                        "`{name}` is set here and nothing ever resets it; write `{reset}` where it ends{alone}"
                    );
                    (&rules::SET_WITHOUT_RESET, message)
                }
                Missing::Set => {
                    let set = if is_control { format!("S {name}") } else { format!("P1 {name} = true") };
                    let message = format!(
                        "`{name}` is reset here and nothing ever sets it; write `{set}` where it begins, or remove this"
                    );
                    (&rules::RESET_WITHOUT_SET, message)
                }
            };
            let mut scopes = model.levels_of(&model.steps[association.step]);
            scopes.insert(1, levels);
            sink.rule(rule, &scopes, vec![(mark(association, *form), message)]);
        }
    }
}

fn mark(association: &Association, form: Form) -> Mark {
    let target = association.target_mark;
    match form {
        Form::Control => association.qualifier_mark.unwrap_or(target).to(target),
        Form::Assignment => association.mark,
        Form::Statement => target,
    }
}
