//! Steps that are missing at the ends of transitions.

use super::Resolver;
use super::chains::End;
use crate::ast::Node;
use crate::diagnostic::rules;
use crate::list::List;
use crate::model::{Dialect, PartialId, StepId};

impl Resolver<'_> {
    /// `-[x]-> A;` and `A -[x]->;`: an arc was forgotten, in either dialect.
    pub(super) fn forgotten(&mut self, node: &Node, end: End) {
        let Node::Forgotten(mark) = node else { return };
        let (rule, message) = match end {
            End::Source => {
                (&rules::SOURCE_TRANSITION, "no step stands in front of this transition; name it: `A -[x]-> …`")
            }
            End::Target => (&rules::SINK_TRANSITION, "no step stands after this transition; name it: `… -[x]-> A`"),
        };
        let message = match (self.model.dialect, end) {
            (Dialect::Sfc, _) => message.to_owned(),
            (Dialect::Grafcet, End::Source) => format!("{message}; one without is written `() -[x]-> …`"),
            (Dialect::Grafcet, End::Target) => format!("{message}; one without is written `… -[x]-> ()`"),
        };
        self.forgotten += 1;
        self.sink.rule(rule, &[], vec![(*mark, message)]);
    }

    /// Steps that no transition touches may be those that are missing, where as many are: one message tells of both.
    pub(super) fn touched_by_forgotten(&mut self, partial: PartialId, forgotten: usize) {
        let model = &mut self.model;
        let alone: Vec<StepId> =
            model.partials[partial].steps.iter().copied().filter(|step| !model.steps[*step].drawn).list();
        if alone.len() <= forgotten {
            for step in alone {
                model.steps[step].drawn = true;
            }
        }
    }
}
