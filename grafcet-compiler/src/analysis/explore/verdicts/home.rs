//! Whether there is always a way back to a situation.

use super::Report;
use super::future::backwards;
use crate::analysis::explore::Answer;
use crate::analysis::explore::Budget;
use crate::analysis::explore::Detail;
use crate::analysis::explore::Doubt;
use crate::analysis::explore::Exploration;
use crate::analysis::explore::explore_whole;
use crate::analysis::explore::limits::budget_doubt;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::formula::{AtomId, Kind};
use crate::analysis::explore::net::slots::Bit;
use crate::analysis::explore::search::graph::{Edge, Graph, Seen};
use crate::analysis::explore::valuation::knowledge::Known;
use crate::list::List;
use crate::model::{PartialId, StepId, Tree};
use crate::sorted::sort_unstable;

/// In how many cases it is looked whether one of several ways exists.
const CASES: usize = 1000;

/// Situations from which nothing leads on, as is known.
#[derive(Clone, Debug)]
pub(crate) struct Stay {
    /// These steps are active.
    pub(crate) active: Vec<StepId>,
    /// No others than these.
    pub(crate) within: Option<Vec<StepId>>,
}

impl Stay {
    fn holds(&self, active: &[StepId]) -> bool {
        self.active.iter().all(|step| active.contains(step))
            && self.within.as_ref().is_none_or(|within| active.iter().all(|step| within.contains(step)))
    }
}

impl Exploration {
    /// Whether a situation can be reached at the end of a cycle from which there is no way to exactly `home` (at the end
    /// of a cycle).
    ///
    /// Inputs and times may be chosen on the way back, but for a time that is over; values that are not followed may not.
    #[must_use]
    pub fn away_from(&self, home: &[StepId]) -> Answer {
        self.away_but_for(home, &[])
    }

    /// The same, where each of these situations counts as home.
    pub(crate) fn away_but_for(&self, home: &[StepId], others: &[Stay]) -> Answer {
        let explored = if is_plain(&self.net) { None } else { Some(self.explored_thoroughly()) };
        away(&self.net, explored.as_ref().unwrap_or(&self.whole), home, others)
    }

    fn explored_thoroughly(&self) -> Graph {
        let mut budget = Budget { limit: self.limit, work: 0 };
        explore_whole(&self.net, false, &mut budget, &mut Seen::nothing(&self.net), Detail::Thorough, &|| self.end).0
    }
}

/// Whether what can be done from a state can be done from each situation that it stands for.
pub(crate) fn is_plain(net: &Net) -> bool {
    net.edges.values().all(Option::is_none)
        && net.clocks.is_empty()
        && !net.has_unfollowed()
        && !net.links.any_computed()
        && !net.is_any_slot_open()
}

/// Whether from some state of the graph there is no way to `home` nor to one of the `others`.
pub(crate) fn away(net: &Net, graph: &Graph, home: &[StepId], others: &[Stay]) -> Answer {
    if !graph.complete || graph.cut_off {
        return Answer::Unknown(budget_doubt(net, graph));
    }
    let home = At::of(net, graph, home, others);
    let lost = home.lost(graph);
    let report = Report { net, graph };
    let mut doubtful = None;
    for state in lost {
        let path = report.path_to_age(state);
        if path.granted.is_empty() {
            return Answer::Possible(path);
        }
        doubtful.get_or_insert(path.granted);
    }
    match doubtful.or_else(|| home.doubt(net, graph)) {
        Some(granted) => Answer::Unknown(Doubt::Unfollowed(granted)),
        None => Answer::Never,
    }
}

/// The states in which exactly the home situation is active, in the partial grafcets that hold its steps.
struct At {
    home: Vec<usize>,
    /// Per state those from which a cycle leads to it.
    back: Vec<Vec<usize>>,
}

impl At {
    fn of(net: &Net, graph: &Graph, home: &[StepId], others: &[Stay]) -> Self {
        let mut steps = home.to_vec();
        sort_unstable(&mut steps);
        let mut parts: Vec<PartialId> = steps.iter().map(|step| net.part_of[*step]).list();
        sort_unstable(&mut parts);
        let is_concerned = |step: &&StepId| parts.binary_search(&net.part_of[**step]).is_ok();
        let states = graph.states.iter().enumerate().filter(|(_, state)| !state.first);
        let at_home = states.filter(|(_, state)| {
            state.active.iter().filter(is_concerned).eq(&steps) || others.iter().any(|stay| stay.holds(&state.active))
        });
        Self { home: at_home.map(|(number, _)| number).list(), back: backwards(graph) }
    }

    /// The ends of cycles from which nothing leads home, the nearest first.
    fn lost(&self, graph: &Graph) -> Vec<usize> {
        let mut returns = vec![false; graph.states.len()];
        let mut work = self.home.clone();
        while let Some(state) = work.pop() {
            if !std::mem::replace(&mut returns[state], true) {
                work.extend(&self.back[state]);
            }
        }
        (0..returns.len()).filter(|state| !returns[*state] && !graph.states[*state].first).list()
    }

    /// What the way home depends on from some state, where it exists for some values only that are not followed.
    fn doubt(&self, net: &Net, graph: &Graph) -> Option<Vec<Tree>> {
        let mut returns = vec![false; graph.states.len()];
        let mut work = self.home.clone();
        while let Some(state) = work.pop() {
            if std::mem::replace(&mut returns[state], true) {
                continue;
            }
            for before in &self.back[state] {
                let leads = |edge: &&Edge| edge.to == state || returns[edge.to];
                if !returns[*before] && exists(net, graph.edges[*before].iter().filter(leads)) {
                    work.push(*before);
                }
            }
        }
        let mut open = (0..returns.len()).filter(|state| !returns[*state]).peekable();
        open.peek()?;
        let mut what: Vec<Tree> = Vec::new();
        let edges = open.flat(|state| &graph.edges[state]);
        let granted = edges.filter_map(|edge| edge.granted.as_deref()).flatten();
        for tree in granted.map(|(atom, _)| &net.atoms[*atom].what) {
            if !what.contains(tree) {
                what.push(tree.clone());
            }
        }
        Some(if what.is_empty() { unfollowed(net) } else { what })
    }
}

/// What conditions of transitions read that is not followed, where no more is known of it.
fn unfollowed(net: &Net) -> Vec<Tree> {
    let open = |atom: &&AtomId| match net.atoms[**atom].kind {
        Kind::Slot(slot) => net.initial_slots[slot] == Bit::Any,
        _ => net.unfollowed[**atom] || net.links.is_computed(**atom),
    };
    let mut atoms: Vec<AtomId> = net.arcs.values().flat(|arc| &arc.atoms).filter(open).copied().list();
    if atoms.is_empty() {
        let all: Vec<AtomId> = net.atoms.ids().list();
        atoms.extend(all.iter().filter(open));
    }
    sort_unstable(&mut atoms);
    atoms.dedup();
    atoms.into_iter().map(|atom| net.atoms[atom].what.clone()).list()
}

/// Whether one of the cycles can be taken whatever the values are that they take for granted.
fn exists<'g>(net: &Net, edges: impl Iterator<Item = &'g Edge>) -> bool {
    // Where nothing can be taken for granted, nothing is written down.
    let nothing = !net.has_unfollowed() && !net.links.any_computed() && !net.is_any_slot_open();
    let ways = edges.filter_map(|edge| if nothing { Some(&[][..]) } else { edge.granted.as_deref() });
    let ways: Vec<&[(AtomId, Known)]> = ways.list();
    covers(net, &ways, &[], &mut CASES.clone())
}

/// Whether in every case one of the ways is open, where this is `known` already.
fn covers(net: &Net, ways: &[&[(AtomId, Known)]], known: &[(AtomId, Known)], cases: &mut usize) -> bool {
    if *cases == 0 {
        return false;
    }
    *cases -= 1;
    let of =
        |known: &[(AtomId, Known)], atom: AtomId| known.iter().find(|(other, _)| *other == atom).map(|(_, is)| *is);
    let possible = |way: &&&[(AtomId, Known)]| {
        way.iter().all(|(atom, demand)| of(known, *atom).is_none_or(|is| meet(is, *demand)))
    };
    let ways: Vec<&[(AtomId, Known)]> = ways.iter().filter(possible).copied().list();
    let Some(first) = ways.first() else { return false };
    let open = first.iter().find(|(atom, demand)| !of(known, *atom).is_some_and(|is| within(is, *demand)));
    let Some((atom, demand)) = open else { return true };
    let (whole, (first, last)) = (of(known, *atom), net.range(*atom));
    let others: Vec<(AtomId, Known)> = known.iter().filter(|(other, _)| other != atom).copied().list();
    parts(whole.unwrap_or(Known::Range(first, last)), *demand).into_iter().all(|part| {
        let mut known = others.clone();
        known.push((*atom, part));
        covers(net, &ways, &known, cases)
    })
}

/// The cases to be told apart, for a value of which `whole` is known, where a way demands something of it.
fn parts(whole: Known, demand: Known) -> Vec<Known> {
    let (Known::Range(low, high), Known::Range(first, last)) = (demand, whole) else {
        return vec![Known::Bool(false), Known::Bool(true)];
    };
    let mut parts = vec![Known::Range(low.max(first), high.min(last))];
    if first < low {
        parts.push(Known::Range(first, low - 1));
    }
    if high < last {
        parts.push(Known::Range(high + 1, last));
    }
    parts
}

/// Whether a known value can be as demanded.
fn meet(known: Known, demand: Known) -> bool {
    match (known, demand) {
        (Known::Range(a, b), Known::Range(low, high)) => a <= high && low <= b,
        (a, b) => a == b,
    }
}

/// Whether all that a known value can be is as demanded.
fn within(known: Known, demand: Known) -> bool {
    match (known, demand) {
        (Known::Range(a, b), Known::Range(low, high)) => low <= a && b <= high,
        (a, b) => a == b,
    }
}
