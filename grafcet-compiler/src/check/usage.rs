//! `unused_input`, `undriven_output`, `unused_variable`, `unused_action`, `unused_param`, `unused_let`: what is declared and takes no
//! part in the chart. As in rustc, a name that begins with `_` says that this is meant.

use proc_macro2::Ident;

use crate::analysis::Usage;
use crate::diagnostic::{Rule, Sink, rules};
use crate::model::{LevelAttr, Model, Name, Place};

pub(super) fn check(model: &Model, sink: &mut Sink) {
    let usage = Usage::of(model);
    let mut report = |rule: &'static Rule, name: &Ident, levels: &[LevelAttr], message: String| {
        if !name.to_string().trim_start_matches("r#").starts_with('_') {
            sink.rule(rule, &[levels, &model.levels], vec![(name.into(), message)]);
        }
    };
    for (id, input) in model.inputs.iter().filter(|(id, _)| !usage.reads(Name::Input(*id))) {
        let name = &model.inputs[id].name;
        // Those of a plant may be written as its faults and choices.
        let what = if model.is_plant { "" } else { "input " };
        report(&rules::UNUSED_INPUT, name, &input.levels, format!("{what}`{name}` is never read; {}", mend(name)));
    }
    for (id, output) in model.outputs.iter().filter(|(id, _)| !usage.writes(Place::Output(*id))) {
        let name = &model.outputs[id].name;
        let message = format!(
            "no action of the chart gives output `{name}` a value; let a step do so, delete it, or call it `{}` if \
             that is meant",
            meant(name)
        );
        report(&rules::UNDRIVEN_OUTPUT, name, &output.levels, message);
    }
    for (id, var) in model.vars.iter() {
        let name = &var.name;
        let message = match (usage.reads(Name::Var(id)), usage.writes(Place::Var(id))) {
            (true, true) => continue,
            (true, false) => {
                format!(
                    "variable `{name}` is read and never written; make it a `param`, write it, or call it `{}`",
                    meant(name)
                )
            }
            // The program may.
            (false, true) => format!(
                "variable `{name}` is written and never read in the chart; read it, delete it, or call it `{}` if only the \
                 program reads it, by `vars()`",
                meant(name)
            ),
            (false, false) => format!("variable `{name}` is never used; {}", mend(name)),
        };
        report(&rules::UNUSED_VARIABLE, name, &var.levels, message);
    }
    for (_, action) in model.actions.iter().filter(|(id, _)| !usage.calls(*id)) {
        let name = &action.name;
        let message = format!("action `{name}` is never called; {}", mend(name));
        report(&rules::UNUSED_ACTION, name, &action.levels, message);
    }
    for (id, param) in model.params.iter().filter(|(id, _)| !usage.reads(Name::Param(*id))) {
        let name = &model.params[id].name;
        report(&rules::UNUSED_PARAM, name, &param.levels, format!("param `{name}` is never read; {}", mend(name)));
    }
    for named in model.lets.values().filter(|named| !named.used) {
        let name = &named.name;
        report(&rules::UNUSED_LET, name, &named.levels, format!("condition `{name}` is never used; {}", mend(name)));
    }
}

fn mend(name: &Ident) -> String {
    format!("use it, delete it, or call it `{}` if that is meant", meant(name))
}

/// The name of something that takes no part in the chart, and is meant to: `_mod` for `r#mod`.
fn meant(name: &Ident) -> String {
    format!("_{}", name.to_string().trim_start_matches("r#"))
}
