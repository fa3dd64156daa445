//! How a chart can evolve: its reachable situations under all inputs.
//!
//! A cycle is run on inputs that are not known: an atom of a condition (an input, a comparison, a time) is decided when
//! a condition first asks for it, once for each possible answer, so that the cost follows the active steps and not the
//! number of inputs. What one run has decided is a class of valuations that all act alike.
//!
//! - `net/`: the chart made ready to be run, conditions over numbered atoms, what is followed from cycle to cycle
//! - `valuation/`: what one cycle takes its inputs for, as far as it has asked for them
//! - `semantics/`: what a cycle does, in both dialects
//! - `search/`: from situation to situation; which need not be tried, what is done where not all can be
//! - `verdicts/`: what follows, and the ways that show it

mod limits;
mod net;
mod search;
mod semantics;
mod valuation;
mod verdicts;

pub use limits::{Answer, Doubt, Limits};
pub(crate) use search::alone;
pub use search::settles::settles;
pub(crate) use search::situations::{Wanted, pieces, situations};
pub(crate) use verdicts::home::Stay;
pub(crate) use verdicts::rivals::{Rival, rivals_meeting};
pub use verdicts::{
    contention::smallest,
    meeting::{Meeting, Parting},
    path::{Activation, Deadlock, Demand, Given, Path, PathCycle, StuckJoin},
};

use self::limits::{answers, length, limit, several};
use self::net::Net;
use self::net::units::UnitId;
use self::search::graph::{Graph, Seen};
use self::search::some_ways::{self, FoundOnWays};
use self::search::whole::{Budget, Detail, explore_whole};
use self::search::{Search, settles as stability};
use self::verdicts::Report;
use self::verdicts::future::Future;
use super::{Concurrency, Facts};
use crate::list::{List, PushAll};
use crate::model::{Arena, Id, Model, StepId, TransitionId, Tree};
use crate::sorted::{Map, Set};

/// The reachable situations of a chart.
pub struct Exploration {
    net: Net,
    seen: Seen,
    /// The whole chart, as far as the budget sufficed.
    whole: Graph,
    /// Per piece of the chart: everything it can do was seen.
    covered: Arena<UnitId, bool>,
    sources: Vec<Vec<StepId>>,
    unsafe_steps: Map<StepId, Activation>,
    deadlocks: Vec<Deadlock>,
    stuck_joins: Vec<StuckJoin>,
    /// The most active steps, where all is covered.
    max_active: Option<usize>,
    /// Something was taken as unknown.
    approximate: bool,
    /// Per watched expression whether it can hold.
    watched: Vec<Answer>,
    settles: bool,
    /// No search for stability is stopped by its bound.
    end: bool,
    /// Some search for stability was stopped by its bound.
    turns: bool,
    limit: u64,
    work: u64,
}

impl Exploration {
    /// Explores a chart.
    #[must_use]
    pub fn of(model: &Model, limits: &Limits) -> Self {
        Self::watching(model, limits, &[])
    }

    /// Explores a chart, and evaluates boolean expressions at the end of each cycle, on its inputs, outputs and situation.
    #[must_use]
    pub fn watching(model: &Model, limits: &Limits, watched: &[&Tree]) -> Self {
        Self::assuming(model, limits, watched, &[])
    }

    /// The same without the inputs for which one of `assumed_never` holds.
    #[must_use]
    pub fn assuming(model: &Model, limits: &Limits, watched: &[&Tree], assumed_never: &[&Tree]) -> Self {
        Self::presuming(model, &Facts::of(model), limits, watched, assumed_never)
    }

    /// The same of a chart of which facts are known.
    pub(crate) fn presuming(
        model: &Model,
        facts: &Facts<'_>,
        limits: &Limits,
        watched: &[&Tree],
        never: &[&Tree],
    ) -> Self {
        let structure = || Concurrency::assuming(model, never).across_partials_from(model, &facts.initial, &Set::new());
        Self::knowing((model, facts), limits, watched, never, &structure)
    }

    /// The same of a chart of which facts are known, without the inputs that it assumes never to come.
    #[must_use]
    pub fn with(model: &Model, facts: &Facts<'_>, limits: &Limits, watched: &[&Tree]) -> Self {
        Self::knowing((model, facts), limits, watched, &facts.never, &|| facts.across(model).clone())
    }

    /// `structure` tells which steps can be active together, where that is asked for.
    fn knowing(
        (model, facts): (&Model, &Facts<'_>),
        limits: &Limits,
        watched: &[&Tree],
        assumed_never: &[&Tree],
        structure: &dyn Fn() -> Concurrency,
    ) -> Self {
        let end = || facts.all_end(model);
        let mut net = Net::of(model, facts, watched, assumed_never);
        let mut seen = Seen::nothing(&net);
        let (limit, several) = (limit(&net, limits), several(&net));
        // Each situation takes more than one unit.
        let nesting = if watched.is_empty() { facts.nesting(model) } else { None };
        let is_told =
            nesting.is_some_and(|nesting| nesting.situations() > limit && nesting.tells_all(model, assumed_never));
        let mut budget = Budget { limit: if limits.only_ways || is_told { 0 } else { limit }, work: 0 };
        let (whole, sooner) = explore_whole(&net, several, &mut budget, &mut seen, Detail::Rough, &end);
        // In a `grafcet` a search for stability that does not come to an end stops wherever its bound lies.
        let approximate = net.approximate || net.grafcet && sooner.is_some();
        let mut watched = answers(&net, sooner.as_ref(), &whole);
        if !net.clocks.is_empty() && watched.iter().any(|answer| *answer != Answer::Never) {
            // Times that fall back may be what makes it possible.
            watched = timed_answers(&net, several, limit, &end);
        }
        let settles = sooner.is_none() && stability::settled(&net, &whole);
        let end = settles || end();
        let mut covered = Arena::filled(net.has_arcs.len(), whole.complete);
        net.structure = (!whole.complete).then(structure);
        let alone = !whole.complete && several;
        let pieces = if alone { explore_pieces(&net, end, &mut budget, &mut seen) } else { Vec::new() };
        for (unit, graph) in pieces.iter().filter_map(|graph| Some((graph.unit?, graph))) {
            covered[unit] = graph.complete;
        }
        let ways =
            (!whole.complete && !is_told).then(|| some_ways::go(&net, limits.work / 3 + length(&net), &mut seen));
        let mut exploration = Self {
            turns: whole.unstable || sooner.as_ref().is_some_and(|graph| graph.unstable),
            settles,
            end,
            sources: model.transitions.values().map(|transition| transition.sources.clone()).list(),
            unsafe_steps: Map::new(),
            deadlocks: Vec::new(),
            stuck_joins: Vec::new(),
            max_active: None,
            net,
            seen,
            whole,
            covered,
            approximate,
            watched,
            limit,
            work: budget.work,
        };
        exploration.judge(sooner.as_ref(), &pieces);
        exploration.add(ways);
        exploration
    }

    fn judge(&mut self, sooner: Option<&Graph>, pieces: &[Graph]) {
        for graph in sooner.into_iter().and([&self.whole]).and(pieces) {
            let report = Report { net: &self.net, graph };
            for (step, activation) in report.activations() {
                self.unsafe_steps.or_insert_with(step, || activation);
            }
            if graph.complete {
                let future = Future::of(&self.net, graph);
                self.deadlocks.push_all(report.deadlocks(&future));
                self.stuck_joins.push_all(report.stuck_joins(&future));
            }
        }
        let most = |graph: &Graph| graph.states.iter().map(|state| state.active.len()).max().unwrap_or(0);
        if self.whole.complete {
            self.max_active = Some(most(&self.whole));
        }
    }

    /// What was found on some ways, where not all were gone.
    fn add(&mut self, ways: Option<FoundOnWays>) {
        let Some(FoundOnWays { graphs, deadlocks, stuck_joins, work }) = ways else { return };
        for graph in &graphs {
            for (step, activation) in (Report { net: &self.net, graph }).activations() {
                self.unsafe_steps.or_insert_with(step, || activation);
            }
        }
        let known: Vec<Vec<StepId>> = self.deadlocks.iter().map(|deadlock| deadlock.steps.clone()).list();
        self.deadlocks.push_all(deadlocks.into_iter().filter(|deadlock| !known.contains(&deadlock.steps)));
        for stuck in stuck_joins {
            let same = |other: &StuckJoin| (other.join, other.waiting) == (stuck.join, stuck.waiting);
            if !self.stuck_joins.iter().any(same) {
                self.stuck_joins.push(stuck);
            }
        }
        self.work += work;
    }

    /// The budget sufficed: what is said never to happen never does, and everything that can happen was seen.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.whole.complete
    }

    /// Complete, and nothing was taken as unknown: what is said to happen really can.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.whole.complete && !self.approximate
    }

    /// Every search for stability comes to its end before the bound, as far as the assumptions allow it; `false` also where
    /// that is not known.
    #[must_use]
    pub fn settles(&self) -> bool {
        self.settles
    }

    /// The circles that turn for ever once they are entered (A30), each in the direction of evolution; `None` where that is not
    /// known.
    #[must_use]
    pub fn endless(&self, model: &Model) -> Option<Vec<Vec<TransitionId>>> {
        if !self.turns {
            return None;
        }
        if !search::endless::may_be(&self.net, &self.whole) {
            return Some(Vec::new());
        }
        // A chart whose situations take more than the budget is large, and each of its turns is long.
        let limit = if self.whole.complete { self.limit } else { self.limit / 8 };
        search::endless::circles(model, &self.net, limit)
    }

    /// The units of work it took.
    #[must_use]
    pub fn work(&self) -> u64 {
        self.work
    }

    /// How many states were found: situations, with the followed variables and what edges compare with.
    #[must_use]
    pub fn states(&self) -> usize {
        self.whole.states.len()
    }

    /// Whether some situation contains the step, transient ones included; `true` also where that could not be excluded.
    #[must_use]
    pub fn reachable(&self, step: StepId) -> bool {
        let may_be = |structure: &Concurrency| structure.reachable(step);
        (self.seen.reachable[step] || !self.covered[self.net.unit_of[step]])
            && self.net.structure.as_ref().is_none_or(may_be)
    }

    /// Whether some situation enables the transition, or that could not be excluded.
    #[must_use]
    pub fn is_enabled(&self, transition: TransitionId) -> bool {
        self.seen.enabled[transition] || self.may_be_enabled(transition)
    }

    /// Whether the condition of the transition can hold while it is enabled (`sfc`: also where an earlier branch takes
    /// precedence), or that could not be excluded.
    #[must_use]
    pub fn can_clear(&self, transition: TransitionId) -> bool {
        (self.seen.able[transition] || !self.covered[self.net.unit_of_arc(transition)])
            && self.net.structure.as_ref().is_none_or(|structure| structure.can_clear(transition))
    }

    /// Whether the structure alone tells that the transition never clears.
    #[must_use]
    pub(crate) fn is_barred(&self, transition: TransitionId) -> bool {
        self.net.structure.as_ref().is_some_and(|structure| !structure.can_clear(transition))
    }

    /// Whether the structure lets the transition be enabled, where its piece of the chart is not covered.
    fn may_be_enabled(&self, transition: TransitionId) -> bool {
        let Some(structure) = &self.net.structure else { return false };
        let sources = &self.sources[transition.index()];
        !self.covered[self.net.unit_of_arc(transition)]
            && sources.iter().all(|source| structure.reachable(*source))
            && sources.iter().enumerate().all(|(i, a)| sources[i + 1..].iter().all(|b| structure.together(*a, *b)))
    }

    /// The shortest way to an evolution that activates the step while it is active and not left by that evolution.
    #[must_use]
    pub fn unsafe_step(&self, step: StepId) -> Option<&Activation> {
        self.unsafe_steps.get(&step)
    }

    /// Situations at the end of a cycle from which a partial grafcet never goes on, those with a final step excepted;
    /// one for each set of its steps.
    #[must_use]
    pub fn deadlocks(&self) -> &[Deadlock] {
        &self.deadlocks
    }

    /// AND-convergences that wait forever, one for each of their sources that waits.
    #[must_use]
    pub fn stuck_joins(&self) -> &[StuckJoin] {
        &self.stuck_joins
    }

    /// Whether two different steps can be active together, transient situations included; `true` also where that could not
    /// be excluded.
    #[must_use]
    pub fn together(&self, a: StepId, b: StepId) -> bool {
        let unit = self.net.unit_of[a];
        let covered = self.covered[unit] && (self.whole.complete || unit == self.net.unit_of[b]);
        (self.seen.together.contains(a.index(), b.index()) || !covered)
            && self.net.structure.as_ref().is_none_or(|structure| structure.together(a, b))
    }

    /// The most steps that are ever active at the end of a cycle; `None` if not everything was seen.
    #[must_use]
    pub fn max_active(&self) -> Option<usize> {
        self.max_active
    }

    /// Whether the watched expression can hold at the end of a cycle.
    #[must_use]
    pub fn watched(&self, index: usize) -> Answer {
        self.watched[index].clone()
    }
}

/// Each piece that has transitions, by itself.
fn explore_pieces(net: &Net, end: bool, budget: &mut Budget, seen: &mut Seen) -> Vec<Graph> {
    let mut pieces = Vec::new();
    for unit in net.has_arcs.ids().filter(|unit| net.has_arcs[*unit]) {
        let search = Search::new(net, Some(unit), end, budget.left(), seen).cut_anywhere(!end);
        pieces.push(budget.run(search));
    }
    pieces
}

/// Per watched expression whether it can hold where no time falls back.
fn timed_answers(net: &Net, several: bool, limit: u64, end: &dyn Fn() -> bool) -> Vec<Answer> {
    let mut budget = Budget { limit, work: 0 };
    let (whole, sooner) = explore_whole(net, several, &mut budget, &mut Seen::nothing(net), Detail::Timed, end);
    answers(net, sooner.as_ref(), &whole)
}
