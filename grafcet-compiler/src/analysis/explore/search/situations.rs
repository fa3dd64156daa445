//! All situations of a chart, where they are few.

use super::Search;
use super::graph::Seen;
use crate::analysis::explore::net::Net;
use crate::model::{Model, StepId};
use crate::sorted::Set;

/// The situations in which a cycle can end, whatever the inputs are, and the initial one; none where so many units of work do not suffice to find
/// all, where there are more than `most`, or where a search for stability may stop at its bound.
pub(crate) fn situations(model: &Model, work: u64, most: usize) -> Option<Set<Vec<StepId>>> {
    let net = Net::of(model, &[], &[]);
    let mut seen = Seen::nothing(&net);
    let (graph, _) = Search::new(&net, None, false, work, &mut seen).while_it_settles().run();
    if !graph.complete || graph.unstable {
        return None;
    }
    let mut found = Set::new();
    for state in &graph.states {
        found.insert(state.active.to_vec());
        if found.len() > most {
            return None;
        }
    }
    Some(found)
}
