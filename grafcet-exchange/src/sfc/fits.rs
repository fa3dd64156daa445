//! What SFC of IEC 61131-3 cannot say.

use grafcet_compiler::model::{Model, TransitionId};

use crate::Refused;
use crate::st::fits as st;

/// All of it, in the order of the chart.
pub(super) fn refused(model: &Model) -> Vec<Refused> {
    if model.is_grafcet() {
        let message = "SFC of IEC 61131-3 makes one evolution a scan, and a `grafcet` goes on until nothing changes: export it as structured text (`--form flip-flops`), or make it an `sfc`";
        return vec![Refused::at((&model.name).into(), message)];
    }
    let mut refused = Vec::new();
    st::types(model, false, &mut refused);
    if refused.is_empty() {
        st::anys(model, &mut refused);
    }
    let initial: Vec<_> = model.steps.values().filter(|step| step.initial).collect();
    if let [_, second, ..] = initial[..] {
        let message = format!("`{}` is a second initial step, and a network of IEC 61131-3 has one", second.name);
        refused.push(Refused::at((&second.name).into(), message));
    }
    overlapping(model, &mut refused);
    refused
}

/// Transitions that share some of their steps only: the standard has priorities for branches of one divergence.
fn overlapping(model: &Model, refused: &mut Vec<Refused>) {
    for (id, transition) in model.transitions.iter() {
        let partly = |other: &TransitionId| {
            let other = &model.transitions[*other].sources;
            let shared = other.iter().filter(|step| transition.sources.contains(step)).count();
            shared > 0 && (shared < other.len() || shared < transition.sources.len())
        };
        let before = model.transitions.ids().take_while(|other| *other != id);
        if before.into_iter().any(|other| partly(&other)) {
            let message = "it shares some of its steps, and not all, with another transition: IEC 61131-3 does not say which of the two is first";
            refused.push(Refused::at(transition.mark, message));
        }
    }
}
