//! One question alone: what it does not touch does not decide about it, and takes nothing of its budget.

use super::graph::{Graph, Seen};
use super::whole::{Budget, Detail, explore_whole};
use crate::analysis::Facts;
use crate::analysis::explore::Answer;
use crate::analysis::explore::Limits;
use crate::analysis::explore::limits::answers;
use crate::analysis::explore::limits::limit;
use crate::analysis::explore::limits::several;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::slice::Slice;
use crate::analysis::explore::verdicts::home::{self, Stay};
use crate::model::{Model, StepId, Tree};

/// Whether a situation can be reached from which there is no way to `home`, where only what decides about that is looked at;
/// `None` where that is all of the chart, and nothing but the chart `was` looked at. The `others` count as home.
#[must_use]
pub(crate) fn away_from(
    (model, facts): (&Model, &Facts<'_>),
    limits: &Limits,
    (home, others): (&[StepId], &[Stay]),
    was_all: bool,
) -> Option<Answer> {
    let slice = Slice::of(model, home, &[]);
    if slice.is_none() && was_all {
        return None;
    }
    let alone = Alone { model, limits, facts };
    let net = alone.net(slice.as_ref(), &[]);
    let detail = if home::is_plain(&net) { Detail::Rough } else { Detail::Thorough };
    let (graph, _) = alone.explore(&net, detail);
    (!cuts(&graph, slice.as_ref())).then(|| home::away(&net, &graph, home, others))
}

/// Whether an expression can hold at the end of a cycle, where only what decides about that is looked at; `None` where that
/// is all of the chart, and nothing else `was` asked.
#[must_use]
pub(crate) fn watched(
    (model, facts): (&Model, &Facts<'_>),
    limits: &Limits,
    tree: &Tree,
    was_alone: bool,
) -> Option<Answer> {
    let slice = Slice::of(model, &[], &[tree]);
    if slice.is_none() && was_alone {
        return None;
    }
    let alone = Alone { model, limits, facts };
    let net = alone.net(slice.as_ref(), &[tree]);
    let (graph, sooner) = alone.explore(&net, Detail::Rough);
    if cuts(&graph, slice.as_ref()) {
        return None;
    }
    let answer = answers(&net, sooner.as_ref(), &graph).pop();
    if net.clocks.is_empty() || answer == Some(Answer::Never) {
        return answer;
    }
    let (graph, sooner) = alone.explore(&net, Detail::Timed);
    answers(&net, sooner.as_ref(), &graph).pop()
}

/// Where a search for stability has no end it stops at a bound, and where that lies depends on all of the chart.
fn cuts(graph: &Graph, slice: Option<&Slice>) -> bool {
    slice.is_some() && graph.unstable
}

struct Alone<'a> {
    model: &'a Model,
    limits: &'a Limits,
    facts: &'a Facts<'a>,
}

impl Alone<'_> {
    fn net(&self, slice: Option<&Slice>, watched: &[&Tree]) -> Net {
        slice.map_or_else(
            || Net::of(self.model, self.facts, watched, &self.facts.never),
            |slice| Net::sliced(self.model, self.facts, slice, watched),
        )
    }

    fn explore(&self, net: &Net, detail: Detail) -> (Graph, Option<Graph>) {
        let mut budget = Budget { limit: limit(net, self.limits), work: 0 };
        let (is_several, end) = (several(net) && detail == Detail::Rough, || self.facts.all_end(self.model));
        explore_whole(net, is_several, &mut budget, &mut Seen::nothing(net), detail, &end)
    }
}
