//! What the compiler takes for granted about a chart must be true of all that brute force sees.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::analysis::{self, Concurrency, Condition, Logic, Stability, explore};
use grafcet_compiler::model::{Effect, Expr, Id, Model, Place, Qualifier, StepId, TransitionId, Tree};
use grafcet_sim::interp::Evolution;

use super::compare::Difference;
use super::graph::Graph;
use super::replay;
use super::verdicts::Verdicts;

/// Which facts are none.
#[must_use]
pub(super) fn check(model: &Model, graph: &Graph, verdicts: &Verdicts) -> Vec<Difference> {
    let mut wrong = Facts { model, wrong: Vec::new() };
    wrong.concurrency(verdicts, &Concurrency::assuming(model, &assumed(model)));
    wrong.concurrency(verdicts, &Concurrency::assuming(model, &assumed(model)).across_partials(model));
    wrong.logic(graph);
    wrong.stability(graph);
    wrong.wrong
}

struct Facts<'m> {
    model: &'m Model,
    wrong: Vec<Difference>,
}

impl Facts<'_> {
    fn report(&mut self, kind: &str, text: String) {
        self.wrong.push(Difference { kind: format!("not a fact: {kind}"), text });
    }

    fn concurrency(&mut self, verdicts: &Verdicts, concurrency: &Concurrency) {
        let model = self.model;
        let name = |step: &StepId| model.steps[*step].name.to_string();
        for step in verdicts.reachable.iter().filter(|step| !concurrency.reachable(**step)) {
            self.report("never active", name(step));
        }
        for (a, b) in verdicts.together.iter().filter(|(a, b)| !concurrency.together(*a, *b)) {
            self.report("never together", format!("{}, {}", name(a), name(b)));
        }
        for transition in verdicts.fireable.iter().filter(|transition| !concurrency.can_clear(**transition)) {
            self.report("never clears", replay::arrow(model, *transition));
        }
        for step in verdicts.unsafe_steps.iter().filter(|step| !concurrency.activated_while_active(**step)) {
            self.report("never activated while active", name(step));
        }
    }

    /// What is shown about conditions, in general and in the situations that can be reached.
    fn logic(&mut self, graph: &Graph) {
        let model = self.model;
        let never = assumed(model);
        let concurrency = Concurrency::assuming(model, &never).across_partials(model);
        // Which transitions were enabled, and of which of them the conditions held.
        let evolutions = graph.cycles().flat_map(|(_, edge)| &edge.evolutions);
        let seen: BTreeSet<_> = evolutions.map(|evolution| (&evolution.enabled, &evolution.fireable)).collect();
        for logic in [Logic::new(model), Logic::within(model, &concurrency, &never)] {
            let conditions: Vec<Condition> =
                model.transitions.values().map(|t| logic.condition(&t.condition.tree)).collect();
            let of = |id: &TransitionId| &conditions[id.index()];
            let ids: Vec<TransitionId> = model.transitions.ids().collect();
            for a in &ids {
                let (never, always) = (logic.never(of(a)), logic.always(of(a)));
                if never && seen.iter().any(|(_, holding)| holding.contains(a)) {
                    self.report("never true", replay::arrow(model, *a));
                }
                if always && seen.iter().any(|(enabled, holding)| enabled.contains(a) && !holding.contains(a)) {
                    self.report("always true", replay::arrow(model, *a));
                }
                for b in ids.iter().filter(|b| *b != a) {
                    let (exclusive, implies) = (logic.exclusive(of(a), of(b)), logic.implies(of(a), &[of(b)]));
                    let names = || format!("{}; {}", replay::arrow(model, *a), replay::arrow(model, *b));
                    if exclusive && seen.iter().any(|(_, holding)| holding.contains(a) && holding.contains(b)) {
                        self.report("exclusive", names());
                    }
                    let alone = |enabled: &BTreeSet<_>, holding: &BTreeSet<_>| {
                        holding.contains(a) && enabled.contains(b) && !holding.contains(b)
                    };
                    if implies && seen.iter().any(|(enabled, holding)| alone(enabled, holding)) {
                        self.report("implied", names());
                    }
                }
            }
        }
    }

    /// Every search of a chart that is certain to become stable does so.
    fn stability(&mut self, graph: &Graph) {
        let model = self.model;
        if model.is_grafcet()
            && (Stability::of(model, &Concurrency::of(model)).is_certain()
                || explore::settles(model, &analysis::Facts::of(model), 1_000_000))
        {
            if let Some((_, edge)) = graph.cycles().find(|(_, edge)| !edge.stable) {
                self.report("stable", replay::names(model, &graph.states[edge.to].situation).join(", "));
            }
        }
    }
}

fn assumed(model: &Model) -> Vec<&Tree> {
    model.assumptions.iter().map(|assumption| &assumption.never.tree).collect()
}

/// The places to which two stored actions after S, R, P1 or P0 give different values in one evolution of a `grafcet`.
#[must_use]
pub(super) fn races(model: &Model, graph: &Graph) -> BTreeSet<Place> {
    let mut races = BTreeSet::new();
    if model.is_grafcet() {
        for (_, edge) in graph.cycles() {
            edge.done(model).iter().for_each(|evolution| race(model, evolution, &mut races));
        }
    }
    races
}

fn race(model: &Model, evolution: &Evolution, races: &mut BTreeSet<Place>) {
    let mut written = BTreeMap::new();
    for association in model.associations.values().filter(|association| association.condition.is_none()) {
        let (was, is) = (evolution.before.contains(&association.step), evolution.after.contains(&association.step));
        let occurs = match association.qualifier {
            Qualifier::S | Qualifier::R | Qualifier::P1 => !was && is,
            Qualifier::P0 => was && !is,
            _ => false,
        };
        let (place, value) = match &association.effect {
            Effect::Control(place) => (*place, association.qualifier == Qualifier::S),
            Effect::Assign(place, Expr { tree: Tree::Bool(value), .. }) => (*place, *value),
            _ => continue,
        };
        if occurs && written.insert(place, value).is_some_and(|other| other != value) {
            races.insert(place);
        }
    }
}
