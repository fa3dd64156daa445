//! All situations of a chart, or of its pieces, for who looks at one that comes from outside.

use super::Search;
use super::graph::{Graph, Seen};
use super::whole::{Budget, Detail, explore_whole};
use crate::analysis::Facts;
use crate::analysis::explore::net::units::UnitId;
use crate::analysis::explore::net::{Net, Order};
use crate::list::List;
use crate::model::{Model, StepId};
use crate::sorted::Set;

/// How much is looked for.
#[derive(Clone, Copy)]
pub(crate) struct Wanted {
    /// So many units of work are worth it.
    pub(crate) work: u64,
    /// With more situations there is no answer.
    pub(crate) most: usize,
    /// The chart is put into situations by hand: from each it goes on with whatever its variables, outputs and edges hold, as a cycle by hand may leave behind
    /// there what no way of the chart's own does.
    pub(crate) by_hand: bool,
}

/// The situations in which a cycle can end, whatever the inputs are, and the initial one; none where the work does not suffice to find all.
pub(crate) fn situations(model: &Model, facts: &Facts<'_>, wanted: Wanted) -> Option<Set<Vec<StepId>>> {
    let net = Net::of(model, facts, &[], &[]);
    if !wanted.by_hand {
        let mut budget = Budget { limit: wanted.work, work: 0 };
        let end = || facts.all_end(model);
        let (graph, sooner) = explore_whole(&net, false, &mut budget, &mut Seen::nothing(&net), Detail::Rough, &end);
        if !graph.unstable && sooner.is_none_or(|graph| !graph.unstable) {
            let found = graph.complete.then(|| ends(&graph))?;
            return (found.len() <= wanted.most).then_some(found);
        }
    }
    all(&net, None, wanted)
}

/// The situations of the states.
fn ends(graph: &Graph) -> Set<Vec<StepId>> {
    graph.states.iter().map(|state| state.active.to_vec()).collect()
}

/// Those of a piece, or of the whole chart. Where a search does not come to its end it may be stopped anywhere, wherever the bound lies. There, and after a cycle by hand,
/// it goes on with whatever it remembers.
fn all(net: &Net, unit: Option<UnitId>, wanted: Wanted) -> Option<Set<Vec<StepId>>> {
    let mut seen = Seen { situations: Some(Set::new()), ..Seen::nothing(net) };
    let mut search = Search::new(net, unit, false, wanted.work, &mut seen);
    search.roots();
    let (mut begun, mut at) = (Set::new(), 0);
    loop {
        while let Some(state) = search.graph.states.get(at) {
            let active = state.active.to_vec();
            if wanted.by_hand && begun.insert(active.clone()) {
                search.root(false, active);
            }
            if !search.expand(at) || begun.len() > wanted.most {
                return None;
            }
            at += 1;
        }
        if !search.graph.unstable {
            let found = ends(&search.graph);
            return (found.len() <= wanted.most).then_some(found);
        }
        let passed = search.seen.situations.clone()?;
        if passed.len() > wanted.most {
            return None;
        }
        let before = begun.len();
        for active in &passed {
            if begun.insert(active.clone()) {
                search.root(false, active.clone());
            }
        }
        if before == begun.len() {
            return Some(passed);
        }
    }
}

/// A piece of a chart of partial grafcets.
pub(crate) struct Piece {
    /// Its steps.
    pub(crate) steps: Vec<StepId>,
    /// Which of them are active in the situations of the chart, whatever the other pieces do; of one that is enclosed, as long as that is active by which it is.
    pub(crate) situations: Set<Vec<StepId>>,
    /// The step without which none of its steps is active.
    pub(crate) enclosed_by: Option<StepId>,
}

/// The pieces of a chart of partial grafcets, as far as the work suffices for each.
pub(crate) fn pieces(model: &Model, facts: &Facts<'_>, wanted: Wanted) -> Vec<Piece> {
    let net = Net::of(model, facts, &[], &[]);
    if !net.grafcet {
        return Vec::new();
    }
    net.has_arcs.ids().filter(|unit| net.has_arcs[*unit]).filter_map(|unit| piece(&net, unit, wanted)).list()
}

fn piece(net: &Net, unit: UnitId, wanted: Wanted) -> Option<Piece> {
    let steps = net.unit_of.iter().filter(|(_, of)| **of == unit).map(|(step, _)| step).list();
    let part = &net.parts[net.part_of[*steps.first()?]];
    let own = |all: &[StepId]| all.iter().filter(|step| net.unit_of[**step] == unit).copied().list();
    let mut found = all(net, Some(unit), wanted)?;
    found.extend(part.orders.iter().filter_map(|(_, order)| match order {
        Order::To(steps) => Some(own(steps)),
        Order::Hold => None,
    }));
    // What is enclosed gets no orders but those of its enclosure.
    let enclosed_by = part.enclosed_by;
    if enclosed_by.is_none() {
        found.insert(own(&net.initial));
    }
    (found.len() <= wanted.most).then_some(Piece { steps, situations: found, enclosed_by })
}
