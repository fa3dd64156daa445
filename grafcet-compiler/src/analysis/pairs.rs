//! Which pairs of steps a situation can contain, where partial grafcets ask for each other's steps, force and enclose each
//! other.
//!
//! The structure of the arrows tells nothing about two partial grafcets. Here a transition clears beside a step only where
//! its condition can hold there, as far as it asks for steps: all steps it asks for must meet its sources, that step and
//! each other. Orders and enclosing steps bring their situations along. It is a superset of what can happen, as long as
//! every pair that an evolution leads to follows from pairs of the situation before it:
//!
//! - Two transitions that clear together lead where one after the other leads, unless both ask for steps, they share a
//!   source, or one that asks for steps activates a source of the other again; those are taken together.
//! - A step stays beside a transition that clears, unless the transition takes it, empties the partial grafcet around it or
//!   has it forced away.

use std::collections::BTreeSet;
use std::rc::Rc;

use super::Relation;
use super::hierarchy::initial_situation;
use crate::model::{Binary, ForceOrder, Id, Model, Read, StepId, TransitionId, Tree, Unary};

/// So many alternatives of a condition are told apart.
const ALTERNATIVES: usize = 32;

/// What was found.
pub(super) struct Pairs {
    pub(super) relation: Relation,
    /// Steps that some situation contains.
    pub(super) reachable: Vec<bool>,
    /// Transitions that some evolution clears.
    pub(super) clears: Vec<bool>,
}

/// The pairs among those that `may_meet`; what the conditions of `granted` ask for is taken for granted.
pub(super) fn of(model: &Model, may_meet: &Relation, granted: &BTreeSet<TransitionId>) -> Pairs {
    let mut search = Search::new(Chart::of(model, granted), may_meet);
    let start: Vec<usize> = initial_situation(model).iter().map(|step| step.index()).collect();
    search.enter_together(&start);
    search.queue_all(&search.chart.sourceless.clone());
    while let Some(arc) = search.work.pop() {
        search.queued[arc] = false;
        search.fire(arc);
    }
    Pairs { relation: search.relation, reachable: search.reachable, clears: search.clears }
}

/// One way for a condition to hold, as far as it is about steps.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Demand {
    active: BTreeSet<usize>,
    inactive: BTreeSet<usize>,
}

/// A transition.
struct Arc {
    sources: Vec<usize>,
    targets: Vec<usize>,
    partial: usize,
    /// In each way: the sources and the steps around them are among those that must be active.
    ways: Vec<Demand>,
    /// The condition asks for steps.
    asks: bool,
    /// Transitions that can clear with it where neither could before the other.
    partners: Vec<usize>,
}

/// What does not change during the search.
struct Chart {
    arcs: Vec<Arc>,
    sourceless: Vec<usize>,
    /// Per step the transitions that need it to be active, or not to be.
    needing: Vec<Vec<usize>>,
    part_of: Vec<usize>,
    /// Per step the situations that it forces, and on which partial grafcet.
    forces: Vec<Vec<(usize, Vec<usize>)>>,
    /// Per step the partial grafcets to which it gives orders.
    commands: Vec<Vec<usize>>,
    /// Per step the linked steps of what it encloses.
    links: Vec<Vec<usize>>,
    /// Per step the steps around it.
    around: Vec<Vec<usize>>,
}

struct Search<'m> {
    chart: Rc<Chart>,
    may_meet: &'m Relation,
    relation: Relation,
    reachable: Vec<bool>,
    clears: Vec<bool>,
    work: Vec<usize>,
    queued: Vec<bool>,
}

impl<'m> Search<'m> {
    fn new(chart: Chart, may_meet: &'m Relation) -> Self {
        let (steps, arcs) = (chart.part_of.len(), chart.arcs.len());
        Self {
            chart: Rc::new(chart),
            may_meet,
            relation: Relation::new(steps),
            reachable: vec![false; steps],
            clears: vec![false; arcs],
            work: Vec::new(),
            queued: vec![false; arcs],
        }
    }

    /// What clearing a transition can lead to.
    fn fire(&mut self, index: usize) {
        let chart = Rc::clone(&self.chart);
        let arc = &chart.arcs[index];
        for way in &arc.ways {
            if !self.is_possible(&chart, arc, way) {
                continue;
            }
            self.clears[index] = true;
            let entered = chart.entered(&arc.targets);
            self.enter_together(&entered);
            let needed: Vec<usize> = way.active.iter().copied().collect();
            for target in &entered {
                let bystanders =
                    self.relation.common_beyond(&needed, *target).into_iter().chain(needed.iter().copied());
                for bystander in bystanders.collect::<Vec<_>>() {
                    if self.reachable[bystander] && chart.stays(bystander, arc, way, &entered) {
                        self.relate(*target, bystander);
                    }
                }
            }
            for partner in &arc.partners {
                self.fire_together(&chart, way, *partner, &entered);
            }
        }
    }

    /// The same where another transition clears in the same evolution.
    fn fire_together(&mut self, chart: &Chart, way: &Demand, partner: usize, entered: &[usize]) {
        let other = &chart.arcs[partner];
        let meets = |search: &Self, theirs: &Demand| {
            let apart = |a: &usize| theirs.active.iter().any(|b| a != b && !search.relation.contains(*a, *b));
            search.is_possible(chart, other, theirs)
                && way.inactive.is_disjoint(&theirs.active)
                && theirs.inactive.is_disjoint(&way.active)
                && !way.active.iter().any(apart)
        };
        if other.ways.iter().any(|theirs| meets(self, theirs)) {
            for a in entered {
                for b in chart.entered(&other.targets) {
                    self.reach(b);
                    self.relate(*a, b);
                }
            }
        }
    }

    /// Whether some situation may contain all that this way needs, and no order holds the partial grafcet.
    fn is_possible(&self, chart: &Chart, arc: &Arc, way: &Demand) -> bool {
        let meets = |(a, b): (usize, usize)| self.relation.contains(a, b);
        let mut pairs = way.active.iter().flat_map(|a| way.active.range(a + 1..).map(|b| (*a, *b)));
        way.active.iter().all(|step| self.reachable[*step] && !chart.commands[*step].contains(&arc.partial))
            && pairs.all(meets)
    }

    fn enter_together(&mut self, steps: &[usize]) {
        for (position, a) in steps.iter().enumerate() {
            self.reach(*a);
            for b in &steps[position + 1..] {
                self.relate(*a, *b);
            }
        }
    }

    fn reach(&mut self, step: usize) {
        if std::mem::replace(&mut self.reachable[step], true) {
            return;
        }
        let chart = Rc::clone(&self.chart);
        self.queue_all(&chart.needing[step]);
        self.queue_all(&chart.sourceless);
        for (_, forced) in &chart.forces[step] {
            self.enter_together(forced);
            for other in forced {
                self.relate(step, *other);
            }
        }
        for related in self.relation.of(step).collect::<Vec<_>>() {
            self.queue_all(&chart.needing[related]);
        }
    }

    /// Notes that two steps can be active together, and with them what they force.
    fn relate(&mut self, a: usize, b: usize) {
        let chart = Rc::clone(&self.chart);
        let mut pairs = vec![(a, b)];
        while let Some((a, b)) = pairs.pop() {
            let barred = !self.may_meet.contains(a, b) || chart.forces_away(a, b) || chart.forces_away(b, a);
            if a == b || barred || !self.relation.insert(a, b) {
                continue;
            }
            self.queue_all(&chart.needing[a]);
            self.queue_all(&chart.needing[b]);
            for (one, other) in [(a, b), (b, a)] {
                let forced = chart.forces[one].iter().flat_map(|(_, forced)| forced);
                pairs.extend(forced.map(|step| (*step, other)));
            }
        }
    }

    fn queue_all(&mut self, arcs: &[usize]) {
        for arc in arcs {
            if !std::mem::replace(&mut self.queued[*arc], true) {
                self.work.push(*arc);
            }
        }
    }
}

impl Chart {
    fn of(model: &Model, granted: &BTreeSet<TransitionId>) -> Self {
        let steps = model.steps.len();
        let mut chart = Self {
            arcs: Vec::new(),
            sourceless: Vec::new(),
            needing: vec![Vec::new(); steps],
            part_of: model.steps.values().map(|step| step.partial.index()).collect(),
            forces: vec![Vec::new(); steps],
            commands: vec![Vec::new(); steps],
            links: vec![Vec::new(); steps],
            around: model.steps.ids().map(|step| around(model, step)).collect(),
        };
        for (id, partial) in model.partials.iter() {
            if let Some(outer) = partial.enclosed_by {
                let linked = partial.steps.iter().filter(|step| model.steps[**step].linked);
                chart.links[outer.index()].extend(linked.map(|step| step.index()));
            }
            for force in model.forces.values().filter(|force| force.target == id) {
                chart.commands[force.step.index()].push(id.index());
                let forced = match &force.order {
                    ForceOrder::Hold => continue,
                    ForceOrder::Steps(steps) => steps.iter().map(|step| step.index()).collect(),
                    ForceOrder::Init => {
                        let initial = partial.steps.iter().filter(|step| model.steps[**step].initial);
                        initial.map(|step| step.index()).collect()
                    }
                };
                chart.forces[force.step.index()].push((id.index(), forced));
            }
        }
        chart.draw(model, granted);
        chart.pair();
        chart
    }

    fn draw(&mut self, model: &Model, granted: &BTreeSet<TransitionId>) {
        for (index, (id, transition)) in model.transitions.iter().enumerate() {
            let sources: Vec<usize> = transition.sources.iter().map(|step| step.index()).collect();
            let anyhow = granted.contains(&id);
            let mut ways =
                if anyhow { vec![Demand::default()] } else { holds(model, &transition.condition.tree, true) };
            let asks = ways != [Demand::default()];
            let outer = model.partials[transition.partial].enclosed_by;
            let outside: Vec<usize> = outer
                .map(|step| std::iter::once(step.index()).chain(self.around[step.index()].iter().copied()).collect())
                .unwrap_or_default();
            for way in &mut ways {
                way.active.extend(sources.iter().chain(&outside));
            }
            ways.retain(|way| way.active.is_disjoint(&way.inactive));
            let needed: BTreeSet<usize> = ways.iter().flat_map(|way| &way.active).copied().collect();
            for step in needed {
                self.needing[step].push(index);
            }
            if sources.is_empty() {
                self.sourceless.push(index);
            }
            self.arcs.push(Arc {
                sources,
                targets: transition.targets.iter().map(|step| step.index()).collect(),
                partial: transition.partial.index(),
                ways,
                asks,
                partners: Vec::new(),
            });
        }
    }

    /// Finds the transitions that must be looked at together.
    fn pair(&mut self) {
        let share = |a: &Arc, b: &Arc| a.sources.iter().any(|source| b.sources.contains(source));
        let enters = |a: &Arc, b: &Arc| a.asks && a.targets.iter().any(|target| b.sources.contains(target));
        let together = |a: &Arc, b: &Arc| a.asks && b.asks || share(a, b) || enters(a, b) || enters(b, a);
        let partners = |(index, arc): (usize, &Arc)| -> Vec<usize> {
            let others = self.arcs.iter().enumerate().filter(|(other, _)| *other != index);
            others.filter(|(_, b)| together(arc, b)).map(|(other, _)| other).collect()
        };
        let partners: Vec<Vec<usize>> = self.arcs.iter().enumerate().map(partners).collect();
        for (arc, partners) in self.arcs.iter_mut().zip(partners) {
            arc.partners = partners;
        }
    }

    /// The steps with all that becomes active with them: what they enclose and force.
    fn entered(&self, steps: &[usize]) -> Vec<usize> {
        let mut entered: Vec<usize> = Vec::new();
        let mut open = steps.to_vec();
        while let Some(step) = open.pop() {
            if !entered.contains(&step) {
                entered.push(step);
                open.extend(&self.links[step]);
                open.extend(self.forces[step].iter().flat_map(|(_, forced)| forced));
            }
        }
        entered.sort_unstable();
        entered
    }

    /// Whether the step stays active when a transition clears in this way.
    fn stays(&self, step: usize, arc: &Arc, way: &Demand, entered: &[usize]) -> bool {
        let left = |other: &usize| arc.sources.contains(other) && !arc.targets.contains(other);
        !arc.sources.contains(&step)
            && !way.inactive.contains(&step)
            && !self.commands[step].contains(&arc.partial)
            && !self.around[step].iter().any(left)
            && !entered.iter().any(|other| self.forces_away(*other, step))
    }

    /// Whether a step forces away the other, or a step around it.
    fn forces_away(&self, step: usize, other: usize) -> bool {
        let away = |other: &usize, (target, forced): &(usize, Vec<usize>)| {
            *target == self.part_of[*other] && !forced.contains(other)
        };
        let mut chain = std::iter::once(&other).chain(&self.around[other]);
        chain.any(|other| self.forces[step].iter().any(|order| away(other, order)))
    }
}

/// The steps around a step, outwards.
fn around(model: &Model, step: StepId) -> Vec<usize> {
    let mut around = Vec::new();
    let mut at = step;
    while let Some(outer) = model.partials[model.steps[at].partial].enclosed_by {
        if outer == step || around.contains(&outer.index()) {
            break;
        }
        around.push(outer.index());
        at = outer;
    }
    around
}

/// The ways in which an expression can have this value, as far as it is about steps.
fn holds(model: &Model, tree: &Tree, value: bool) -> Vec<Demand> {
    let anyhow = || vec![Demand::default()];
    let any_of = |steps: &[StepId], value: bool| -> Vec<Demand> {
        let steps = steps.iter().map(|step| step.index());
        if value {
            let one = |step| Demand { active: BTreeSet::from([step]), inactive: BTreeSet::new() };
            return steps.map(one).collect();
        }
        vec![Demand { active: BTreeSet::new(), inactive: steps.collect() }]
    };
    match tree {
        Tree::Bool(constant) if *constant == value => anyhow(),
        Tree::Bool(_) => Vec::new(),
        Tree::Read(Read::Active(step)) => any_of(&[*step], value),
        Tree::Read(Read::MacroActive(id)) => any_of(&model.macros[*id].steps, value),
        Tree::Elapsed(_, step) if value => any_of(&[*step], true),
        Tree::MacroElapsed(_, id) if value => any_of(&model.macros[*id].steps, true),
        Tree::Read(Read::Rising(edge)) if value => holds(model, &model.edges[*edge].of.tree, true),
        Tree::Read(Read::Falling(edge)) if value => holds(model, &model.edges[*edge].of.tree, false),
        Tree::Unary(Unary::Not, inner) => holds(model, inner, !value),
        Tree::Binary(Binary::And | Binary::BitAnd, a, b) if value => {
            all(&holds(model, a, true), &holds(model, b, true))
        }
        Tree::Binary(Binary::And | Binary::BitAnd, a, b) => any(holds(model, a, false), holds(model, b, false)),
        Tree::Binary(Binary::Or | Binary::BitOr, a, b) if value => any(holds(model, a, true), holds(model, b, true)),
        Tree::Binary(Binary::Or | Binary::BitOr, a, b) => all(&holds(model, a, false), &holds(model, b, false)),
        _ => anyhow(),
    }
}

/// Either of two.
fn any(mut a: Vec<Demand>, b: Vec<Demand>) -> Vec<Demand> {
    a.extend(b);
    a.sort();
    a.dedup();
    // Where one of them demands nothing, that is enough.
    if a.len() > ALTERNATIVES || a.first() == Some(&Demand::default()) { vec![Demand::default()] } else { a }
}

/// Both of two.
fn all(a: &[Demand], b: &[Demand]) -> Vec<Demand> {
    if a.len() * b.len() > ALTERNATIVES {
        return a.to_vec();
    }
    let both = |one: &Demand, other: &Demand| Demand {
        active: one.active.union(&other.active).copied().collect(),
        inactive: one.inactive.union(&other.inactive).copied().collect(),
    };
    let mut both: Vec<Demand> = a.iter().flat_map(|one| b.iter().map(move |other| both(one, other))).collect();
    both.retain(|way| way.active.is_disjoint(&way.inactive));
    both.sort();
    both.dedup();
    both
}
