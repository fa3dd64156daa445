//! The whole chart, as far as the budget suffices.

use super::Search;
use super::graph::{Graph, Seen};
use crate::analysis::explore::net::Net;

/// The units of work that are left.
pub(crate) struct Budget {
    pub(crate) limit: u64,
    pub(crate) work: u64,
}

impl Budget {
    pub(crate) fn left(&self) -> u64 {
        self.limit.saturating_sub(self.work)
    }

    pub(crate) fn run(&mut self, search: Search<'_, '_>) -> Graph {
        let (graph, work) = search.run();
        self.work += work;
        graph
    }

    /// Until so many units of work have been done in all.
    fn go_on(&mut self, search: &mut Search<'_, '_>, limit: u64) {
        let before = search.valuation.work;
        search.limit = before + limit.saturating_sub(self.work);
        search.explore();
        self.work += search.valuation.work - before;
    }
}

/// How closely the chart is looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Detail {
    /// Times count as unknown.
    Rough,
    /// See [`Search::with_time`].
    Timed,
    /// See [`Search::thoroughly`].
    Thorough,
}

impl Detail {
    fn look<'n, 's>(self, search: Search<'n, 's>) -> Search<'n, 's> {
        match self {
            Self::Rough => search,
            Self::Timed => search.with_time(),
            Self::Thorough => search.thoroughly(),
        }
    }
}

/// The whole chart, as far as the budget suffices; and the graph of a first attempt that was given up.
///
/// First everything is tried in all combinations, which gives the shortest ways, then not what has nothing to do with
/// each other; in a `grafcet` only where its searches are known to `end`: one that is stopped by its bound shows a situation
/// that not every order comes through.
pub(crate) fn explore_whole(
    net: &Net,
    several: bool,
    budget: &mut Budget,
    seen: &mut Seen,
    detail: Detail,
    end: &dyn Fn() -> bool,
) -> (Graph, Option<Graph>) {
    let share = if several { budget.limit / 3 } else { budget.limit };
    // What waits may rely on values that nobody can choose, or on a time that does not stand still.
    let may_wait = match detail {
        Detail::Rough => true,
        Detail::Timed => net.clocks.is_empty(),
        Detail::Thorough => net.clocks.is_empty() && !net.has_unfollowed() && !net.links.any_computed(),
    };
    let lazy = may_wait && (!net.grafcet || net.is_confluent(None));
    let mut all = detail.look(Search::new(net, None, false, 0, seen));
    budget.go_on(&mut all, if lazy { share / 3 } else { share });
    if !all.graph.complete && lazy && (!net.grafcet || end()) {
        let sooner = all.graph;
        let mut some = detail.look(Search::new(net, None, true, 0, seen));
        budget.go_on(&mut some, share);
        return (some.graph, Some(sooner));
    }
    if !all.graph.complete && lazy {
        budget.go_on(&mut all, share);
    }
    (all.graph, None)
}
