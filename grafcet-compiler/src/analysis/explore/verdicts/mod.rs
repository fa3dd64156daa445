//! Deadlocks and AND-convergences that wait forever, found in the graph of states.

pub(crate) mod contention;
pub(crate) mod future;
pub(crate) mod home;
pub(crate) mod meeting;
pub(crate) mod path;
pub(crate) mod rivals;
pub(crate) mod table;

use self::future::Future;
use self::path::{Activation, Deadlock, Demand, Given, Path, PathCycle, StuckJoin};
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::formula::{AtomId, Kind};
use crate::analysis::explore::net::units::UnitId;
use crate::analysis::explore::search::graph::{Cycle, Doubled, Graph};
use crate::analysis::explore::valuation::knowledge::Known;
use crate::list::{List, PushAll};
use crate::model::{StepId, TransitionId};
use crate::sorted::{Set, sort_unstable};

/// Turns numbers back into names.
pub(crate) struct Report<'n> {
    pub(crate) net: &'n Net,
    pub(crate) graph: &'n Graph,
}

impl Report<'_> {
    /// The shortest way to a state.
    pub(crate) fn path_to(&self, state: usize) -> Path {
        self.path_with(state, &[])
    }

    /// The same, with how late it is at its end, where that is followed.
    pub(crate) fn path_to_age(&self, state: usize) -> Path {
        let mut path = self.path_to(state);
        let ages = &self.graph.states[state].ages;
        if let Some(last) = path.cycles.last_mut().filter(|_| !ages.is_empty()) {
            let known = |given: &Given| ages.iter().any(|(atom, _)| self.net.atoms[*atom].what == given.what);
            last.given.retain(|given| !known(given));
            last.given.push_all(ages.iter().filter_map(|age| self.given(age)));
        }
        path
    }

    /// The same, where at its end this is known of the atoms.
    fn path_with(&self, state: usize, known: &[(AtomId, Known)]) -> Path {
        let mut path = Path::default();
        let (mut at, mut known) = (state, known.to_vec());
        while let Some(origin) = &self.graph.origins[at] {
            self.note(&origin.cycle, &mut path);
            let cycle = self.cycle(&origin.cycle, &known, &self.graph.states[at].active);
            // The cycle that only enters the initial situation shows nothing.
            path.skips_first =
                self.graph.states[origin.from].first && cycle.cleared.is_empty() && cycle.given.is_empty();
            if !path.skips_first {
                path.cycles.push(cycle);
            }
            known.clone_from(&origin.cycle.past);
            at = origin.from;
        }
        path.start = self.graph.states[at].active.to_vec();
        path.cycles.reverse();
        path
    }

    /// The shortest way to a cycle at whose end a watched expression holds.
    pub(crate) fn path_to_watched(&self, index: usize) -> Option<Path> {
        let (from, cycle, end) = self.graph.watched[index].as_ref()?;
        Some(self.path_beyond(*from, cycle, &end.active))
    }

    /// A way to a state, and one more cycle.
    pub(crate) fn path_beyond(&self, from: usize, cycle: &Cycle, active: &[StepId]) -> Path {
        let mut path = self.path_with(from, &cycle.past);
        path.cycles.push(self.cycle(cycle, &[], active));
        self.note(cycle, &mut path);
        path
    }

    /// Notes what a cycle of a way takes for granted.
    fn note(&self, cycle: &Cycle, path: &mut Path) {
        for (atom, _) in &cycle.granted {
            let what = &self.net.atoms[*atom].what;
            if !self.net.presumed[*atom] && !path.granted.contains(what) {
                path.granted.push(what.clone());
            }
        }
    }

    /// A cycle; `later` is what the next one demands of it.
    fn cycle(&self, cycle: &Cycle, later: &[(AtomId, Known)], active: &[StepId]) -> PathCycle {
        let inputs = |(atom, _): &&(AtomId, Known)| matches!(self.net.atoms[*atom].kind, Kind::Free | Kind::Number(..));
        let later: Vec<_> = later.iter().filter(inputs).list();
        let sooner = cycle.given.iter().filter(|(atom, _)| !later.iter().any(|(other, _)| other == atom));
        let given = sooner.and(later.iter().copied()).filter_map(|known| self.given(known));
        PathCycle { given: given.list(), cleared: cycle.cleared.clone(), active: active.to_vec() }
    }

    fn given(&self, (atom, known): &(AtomId, Known)) -> Option<Given> {
        let demand = match known {
            Known::Unknown => return None,
            Known::Bool(value) => Demand::Is(*value),
            Known::Range(low, high) => {
                let (first, last) = self.net.range(*atom);
                Demand::Within((*low > first).then_some(*low), (*high < last).then_some(*high))
            }
        };
        Some(Given { what: self.net.atoms[*atom].what.clone(), demand })
    }

    /// The steps that were activated while they were active.
    pub(crate) fn activations(&self) -> Vec<(StepId, Activation)> {
        let activation = |(step, doubled): &(StepId, Doubled)| {
            let path = self.path_beyond(doubled.from, &doubled.cycle, &doubled.end);
            (*step, Activation { path, by: doubled.by })
        };
        self.graph.doubled.iter().map(activation).list()
    }

    /// Situations from which a piece of the chart never goes on.
    pub(crate) fn deadlocks(&self, future: &Future) -> Vec<Deadlock> {
        self.deadlocks_of(future, 0..self.graph.states.len())
    }

    /// Those among some states.
    pub(crate) fn deadlocks_of(&self, future: &Future, among: impl IntoIterator<Item = usize>) -> Vec<Deadlock> {
        let mut deadlocks = Vec::new();
        let mut known = Set::new();
        let states = among.into_iter().map(|number| (number, &self.graph.states[number]));
        for (number, state) in states.filter(|(_, state)| !state.first) {
            let mut units: Vec<UnitId> = state.active.iter().map(|step| self.net.unit_of[*step]).list();
            sort_unstable(&mut units);
            units.dedup();
            for unit in units {
                if future.moves(number, unit) || !self.net.has_arcs[unit] || self.is_meant(&state.active, unit) {
                    continue;
                }
                let here = self.own(&state.active, unit);
                if !known.insert(here.clone()) {
                    continue;
                }
                let partial = self.net.part_of[here[0]];
                deadlocks.push(Deadlock { partial, steps: here, path: self.path_to(number) });
            }
        }
        deadlocks
    }

    /// AND-convergences of which a source is active forever and another never.
    pub(crate) fn stuck_joins(&self, future: &Future) -> Vec<StuckJoin> {
        self.stuck_joins_of(future, 0..self.graph.states.len())
    }

    /// Those among some states.
    pub(crate) fn stuck_joins_of(&self, future: &Future, among: impl IntoIterator<Item = usize>) -> Vec<StuckJoin> {
        let mut stuck = Vec::new();
        let mut known = Set::new();
        if future.joins.is_empty() {
            return stuck;
        }
        let states = among.into_iter().map(|number| (number, &self.graph.states[number]));
        for (number, state) in states.filter(|(_, state)| !state.first) {
            for step in state.active.iter().filter(|step| future.waiting.binary_search(step).is_ok()) {
                let unit = self.net.unit_of[*step];
                if future.leaves(number, *step) || self.is_meant(&state.active, unit) {
                    continue;
                }
                for join in self.net.leaving[*step].iter().filter(|t| future.joins.binary_search(t).is_ok()) {
                    if !future.enables(number, *join) && known.insert((*join, *step)) {
                        stuck.push(StuckJoin {
                            join: *join,
                            waiting: *step,
                            culprit: self.culprit(future, number, *join),
                            path: self.path_to(number),
                        });
                    }
                }
            }
        }
        stuck
    }

    /// The transition on the way to a state with which the convergence became impossible.
    fn culprit(&self, future: &Future, state: usize, join: TransitionId) -> Option<TransitionId> {
        self.parted_by(state, join, &|before| future.enables(before, join))
    }

    /// The transition on the way to a state that parted it from the last one in front of it with which it `was` possible; rather one
    /// that does not lead to the convergence.
    pub(crate) fn parted_by(
        &self,
        state: usize,
        join: TransitionId,
        was: &dyn Fn(usize) -> bool,
    ) -> Option<TransitionId> {
        let mut at = state;
        while let Some(origin) = &self.graph.origins[at] {
            if was(origin.from) {
                let leads_elsewhere = |t: &&TransitionId| {
                    let arc = &self.net.arcs[**t];
                    !arc.targets.iter().any(|target| self.net.arcs[join].sources.contains(target))
                };
                let cleared = &origin.cycle.cleared;
                return cleared.iter().find(leads_elsewhere).or(cleared.first()).copied();
            }
            at = origin.from;
        }
        None
    }

    fn own(&self, active: &[StepId], unit: UnitId) -> Vec<StepId> {
        active.iter().filter(|step| self.net.unit_of[**step] == unit).copied().list()
    }

    /// Whether the piece may stay where it is: a final step of it is active, or an order holds it.
    fn is_meant(&self, active: &[StepId], unit: UnitId) -> bool {
        let here = self.own(active, unit);
        let held = |step: &StepId| self.net.order(self.net.part_of[*step], active).is_some();
        here.iter().any(|step| self.net.is_final[*step]) || self.graph.unit.is_none() && here.first().is_some_and(held)
    }
}
