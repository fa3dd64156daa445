//! `grafcet`: IEC 60848's classes of conditions: an assignation condition is a level, an event is an edge.

use crate::analysis::has_edge;
use crate::diagnostic::{Sink, rules};
use crate::model::{Effect, Model, Qualifier};

pub(super) fn check(model: &Model, sink: &mut Sink) {
    for association in model.associations.values() {
        let scopes = [&model.steps[association.step].levels[..], &model.levels];
        if let (Some(condition), false) = (&association.condition, association.is_stored()) {
            if has_edge(condition) {
                let message = "an assignation condition holds while the action does, and an edge has no duration; \
                               write the level itself, or a stored action: `on rising(…) …`";
                sink.rule(&rules::EDGE_IN_ASSIGNATION, &scopes, vec![(condition.mark, message.to_owned())]);
            }
        }
        if let (Effect::Assign(_, value), false) = (&association.effect, association.is_stored()) {
            if has_edge(value) {
                let message = "an assigned value lasts as long as its action, and an edge has no duration; write the \
                               level itself, or a stored action: `on rising(…) …`";
                sink.rule(&rules::EDGE_IN_ASSIGNATION, &scopes, vec![(value.mark, message.to_owned())]);
            }
        }
        if let (Some(event), Qualifier::On) = (&association.event, association.qualifier) {
            if !has_edge(event) {
                let message = format!(
                    "an event happens at an instant, and this is a level; write the edge that is meant: `on rising({})`",
                    event.text
                );
                sink.rule(&rules::EVENT_WITHOUT_EDGE, &scopes, vec![(event.mark, message)]);
            }
        }
    }
}
