//! The verdicts of the checker beside those of the naive exploration.

use std::collections::BTreeSet;

use grafcet_compiler::analysis::explore::{Answer, Exploration, Limits};
use grafcet_compiler::model::{Model, StepId, Tree};

use super::graph::{Edge, Graph};
use super::replay;
use super::verdicts::Verdicts;
use super::{facts, nested};

/// Something that both do not say.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// Of what kind it is: charts are made smaller as long as it stays.
    pub kind: String,
    /// In the words of the chart.
    pub text: String,
}

/// What both say about one chart.
pub struct Comparison {
    /// Empty where both agree.
    pub differences: Vec<Difference>,
    /// The checker took nothing as unknown, so that both have to say the same.
    pub exact: bool,
    /// How many properties that stand in the chart are proved, broken and undecided.
    pub claims: [usize; 3],
    /// How many ways back the structure proves, and of how many charts it tells all.
    pub nested: [usize; 2],
}

/// Compares a chart. `watched` are expressions over inputs, outputs and steps, `home` are situations.
///
/// # Errors
/// The interpreter does not understand an expression.
pub fn compare(model: &Model, graph: &Graph, watched: &[Tree], home: &[StepId]) -> Result<Comparison, String> {
    let verdicts = Verdicts::of(model, graph);
    let trees: Vec<&Tree> = watched.iter().collect();
    let assumed: Vec<&Tree> = model.assumptions.iter().map(|assumption| &assumption.never.tree).collect();
    let explored = Exploration::assuming(model, &Limits::situations(1_000_000), &trees, &assumed);
    let exact = explored.is_exact() && !model.uses_time();
    let stable = graph.cycles().all(|(_, edge)| edge.stable);
    let mut both = Both { model, graph, verdicts, explored, exact, stable, differences: Vec::new() };
    both.differences.extend(facts::check(model, graph, &both.verdicts));
    both.steps();
    both.transitions();
    both.pairs();
    both.properties(watched, home)?;
    if exact && stable {
        both.ends();
        both.differences.extend(replay::check(model, graph, &both.explored));
        both.some_ways(&assumed);
    }
    let mut nested = [0; 2];
    if stable && (exact || Graph::is_whole(model)) {
        let (differences, count) = nested::check(model, graph, &both.verdicts, &assumed);
        both.differences.extend(differences);
        nested = count;
    }
    Ok(Comparison { differences: both.differences, exact, claims: [0; 3], nested })
}

struct Both<'m> {
    model: &'m Model,
    graph: &'m Graph,
    verdicts: Verdicts,
    explored: Exploration,
    exact: bool,
    /// Every search ends in a stable situation.
    stable: bool,
    differences: Vec<Difference>,
}

impl Both<'_> {
    /// What happens must have been seen; what was seen must happen where nothing was taken as unknown.
    fn same(&mut self, kind: &str, what: impl Fn() -> String, naive: bool, explored: bool) {
        if naive != explored && (naive || self.exact) {
            let by = if naive { "brute force" } else { "the checker" };
            self.differ(&format!("{kind} by {by} alone"), what());
        }
    }

    fn differ(&mut self, kind: &str, text: String) {
        self.differences.push(Difference { kind: kind.to_owned(), text });
    }

    fn steps(&mut self) {
        let model = self.model;
        for step in model.steps.ids() {
            let name = || model.steps[step].name.to_string();
            let (naive, explored) = (self.verdicts.reachable.contains(&step), self.explored.reachable(step));
            self.same("reachable", name, naive, explored);
            let (naive, explored) =
                (self.verdicts.unsafe_steps.contains(&step), self.explored.unsafe_step(step).is_some());
            if self.explored.is_complete() {
                self.same("unsafe", name, naive, explored);
            }
        }
    }

    fn transitions(&mut self) {
        let model = self.model;
        for id in model.transitions.ids() {
            let name = || replay::arrow(model, id);
            let (naive, explored) = (self.verdicts.enabled.contains(&id), self.explored.is_enabled(id));
            self.same("enabled", name, naive, explored);
            let (naive, explored) = (self.verdicts.fireable.contains(&id), self.explored.can_clear(id));
            self.same("can clear", name, naive, explored);
        }
    }

    fn pairs(&mut self) {
        let model = self.model;
        for a in model.steps.ids() {
            for b in model.steps.ids().filter(|b| a < *b) {
                let naive = self.verdicts.together.contains(&(a, b));
                let explored = self.explored.together(a, b);
                let names = || format!("{}, {}", model.steps[a].name, model.steps[b].name);
                self.same("together", names, naive, explored);
            }
        }
        let most = self.graph.states.iter().map(|state| state.situation.len()).max().unwrap_or_default();
        match self.explored.max_active() {
            Some(explored) if explored < most || self.exact && explored > most => {
                self.differ("most active steps", format!("{most} by brute force, {explored} by the checker"));
            }
            None if self.exact => self.differ("most active steps", "not known".to_owned()),
            _ => {}
        }
    }

    fn properties(&mut self, watched: &[Tree], home: &[StepId]) -> Result<(), String> {
        for (index, tree) in watched.iter().enumerate() {
            let naive = self.graph.can_hold(self.model, tree)?;
            let answer = self.explored.watched(index);
            self.answer("property", &format!("{tree:?}"), naive, &answer);
            self.leads(&format!("{tree:?}"), &answer, |edge| self.graph.holds(self.model, edge, tree) == Ok(true));
        }
        let home: BTreeSet<StepId> = home.iter().copied().collect();
        let naive = self.graph.can_miss(self.model, &home);
        let answer = self.explored.away_from(&home.iter().copied().collect::<Vec<_>>());
        // With something unknown there may be fewer ways back, or more.
        if self.exact {
            let name = replay::names(self.model, &home).join(", ");
            self.answer("home", &name, naive, &answer);
            let misses = self.graph.misses(self.model, &home);
            self.leads(&name, &answer, |edge| misses[edge.to]);
        }
        Ok(())
    }

    fn answer(&mut self, kind: &str, what: &str, naive: bool, answer: &Answer) {
        match answer {
            Answer::Never => self.same(kind, || what.to_owned(), naive, false),
            Answer::Possible(_) => self.same(kind, || what.to_owned(), naive, true),
            Answer::Unknown(_) if self.exact => self.differ(&format!("{kind} not answered"), what.to_owned()),
            Answer::Unknown(_) => {}
        }
    }

    /// The way of an answer leads where it says. Where an instable search is cut off, the checker need not know.
    fn leads(&mut self, what: &str, answer: &Answer, end: impl Fn(&Edge) -> bool) {
        if let (Answer::Possible(path), true, true) = (answer, self.exact, self.stable) {
            self.differences.extend(replay::leads(self.model, self.graph, path, what, end));
        }
    }

    /// What is found in a chart that is too large, by going some ways only, happens; not all that happens is found.
    fn some_ways(&mut self, assumed: &[&Tree]) {
        let limits = Limits { only_ways: true, ..Limits::default() };
        let explored = Exploration::assuming(self.model, &limits, &[], assumed);
        self.differences.extend(replay::real(self.model, self.graph, &explored));
        let stuck = explored.stuck_joins().iter().map(|stuck| (stuck.join, stuck.waiting));
        let deadlocks = explored.deadlocks().iter();
        let deadlocks = deadlocks.map(|deadlock| (deadlock.partial, deadlock.steps.iter().copied().collect()));
        let wrong = stuck.filter(|key| !self.verdicts.stuck.contains(key)).count()
            + deadlocks.filter(|key| !self.verdicts.deadlocks.contains(key)).count();
        let unseen = |step: &StepId| self.verdicts.reachable.contains(step) && !explored.reachable(*step);
        if wrong > 0 || self.model.steps.ids().any(|step| unseen(&step)) {
            self.differ("on some ways", format!("{wrong} ends are none, or a step is reachable"));
        }
    }

    /// Deadlocks and stuck convergences.
    fn ends(&mut self) {
        let model = self.model;
        let explored = self.explored.deadlocks().iter();
        let explored: BTreeSet<_> =
            explored.map(|deadlock| (deadlock.partial, deadlock.steps.iter().copied().collect())).collect();
        for (partial, steps) in self.verdicts.deadlocks.clone().union(&explored) {
            let key = (*partial, steps.clone());
            let (naive, explored) = (self.verdicts.deadlocks.contains(&key), explored.contains(&key));
            self.same("deadlock", || replay::names(model, steps).join(", "), naive, explored);
        }
        let explored = self.explored.stuck_joins().iter();
        let explored: BTreeSet<_> = explored.map(|stuck| (stuck.join, stuck.waiting)).collect();
        for key in self.verdicts.stuck.clone().union(&explored) {
            let what = || format!("{} waits in {}", replay::arrow(model, key.0), model.steps[key.1].name);
            let (naive, explored) = (self.verdicts.stuck.contains(key), explored.contains(key));
            self.same("stuck", what, naive, explored);
        }
    }
}
