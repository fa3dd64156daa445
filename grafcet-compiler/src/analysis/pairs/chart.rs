//! The chart as the search for pairs sees it.

use super::demands::{Demand, holds};
use super::{Relation, drags};
use crate::analysis::Row;
use crate::list::{List, PushAll};
use crate::model::{ForceOrder, Id, Model, StepId, TransitionId};
use crate::sorted::{Set, sort, sort_unstable};

/// A transition.
pub(super) struct Arc {
    pub(super) sources: Vec<usize>,
    pub(super) targets: Vec<usize>,
    /// The targets with all that becomes active with them.
    pub(super) entered: Vec<usize>,
    pub(super) partial: usize,
    /// In each way: the sources and the steps around them are among those that must be active.
    pub(super) demands: Vec<Demand>,
    /// The condition asks for steps.
    pub(super) asks: bool,
    /// Transitions that can clear with it where neither could before the other.
    pub(super) partners: Vec<usize>,
    /// Steps that are left in the evolution in which it clears.
    pub(super) dragged: Vec<usize>,
}

/// What does not change during the search.
pub(super) struct Chart {
    pub(super) arcs: Vec<Arc>,
    pub(super) sourceless: Vec<usize>,
    /// Per step the transitions that need it to be active, or not to be.
    pub(super) needing: Vec<Vec<usize>>,
    pub(super) part_of: Vec<usize>,
    /// Per step the situations that it forces, and on which partial grafcet.
    pub(super) forces: Vec<Vec<(usize, Vec<usize>)>>,
    /// Per step the partial grafcets to which it gives orders.
    pub(super) commands: Vec<Vec<usize>>,
    /// Per step the linked steps of what it encloses.
    pub(super) links: Vec<Vec<usize>>,
    /// Per step the steps around it.
    around: Vec<Vec<usize>>,
    /// Per step those within what it encloses.
    within: Vec<Vec<usize>>,
    /// Per step those that it forces away, or of which it forces away one around them.
    pub(super) away: Vec<Vec<usize>>,
    /// Per partial grafcet the steps that give orders to it.
    commanding: Vec<Vec<usize>>,
}

impl Chart {
    pub(super) fn of(model: &Model, may_meet: &Relation, granted: &Set<TransitionId>) -> Self {
        let steps = model.steps.len();
        let mut chart = Self {
            arcs: Vec::new(),
            sourceless: Vec::new(),
            needing: vec![Vec::new(); steps],
            part_of: model.steps.values().map(|step| step.partial.index()).list(),
            forces: vec![Vec::new(); steps],
            commands: vec![Vec::new(); steps],
            links: vec![Vec::new(); steps],
            around: model.steps.ids().map(|step| around(model, step)).list(),
            within: vec![Vec::new(); steps],
            away: vec![Vec::new(); steps],
            commanding: vec![Vec::new(); model.partials.len()],
        };
        for step in 0..steps {
            for outer in &chart.around[step] {
                chart.within[*outer].push(step);
            }
        }
        for (id, partial) in model.partials.iter() {
            if let Some(outer) = partial.enclosed_by {
                let linked = partial.steps.iter().filter(|step| model.steps[**step].linked);
                chart.links[outer.index()].push_all(linked.map(|step| step.index()));
            }
            for force in model.orders_on(id) {
                chart.commands[force.step.index()].push(id.index());
                chart.commanding[id.index()].push(force.step.index());
                let forced = match &force.order {
                    ForceOrder::Hold => continue,
                    ForceOrder::Steps(steps) => steps.iter().map(|step| step.index()).list(),
                    ForceOrder::Init => {
                        let initial = partial.steps.iter().filter(|step| model.steps[**step].initial);
                        initial.map(|step| step.index()).list()
                    }
                };
                chart.forces[force.step.index()].push((id.index(), forced));
            }
        }
        for step in (0..steps).filter(|step| !chart.forces[*step].is_empty()).list() {
            chart.away[step] = (0..steps).filter(|other| chart.forces_away(step, *other)).list();
        }
        chart.draw(model, granted);
        chart.pair(&drags::of(model, may_meet, granted));
        chart
    }

    fn draw(&mut self, model: &Model, granted: &Set<TransitionId>) {
        for (index, (id, transition)) in model.transitions.iter().enumerate() {
            let sources: Vec<usize> = transition.sources.iter().map(|step| step.index()).list();
            let anyhow = granted.contains(&id);
            let mut demands =
                if anyhow { vec![Demand::default()] } else { holds(model, &transition.condition.tree, true) };
            let asks = demands != [Demand::default()];
            let outer = model.partials[transition.partial].enclosed_by;
            let outside: Vec<usize> = outer
                .map(|step| std::iter::once(step.index()).and(self.around[step.index()].iter().copied()).list())
                .unwrap_or_default();
            for demand in &mut demands {
                demand.active.extend(sources.iter().and(&outside));
            }
            demands.retain(|demand| demand.active.is_disjoint(&demand.inactive));
            let needed: Set<usize> = demands.iter().flat(|demand| &demand.active).copied().collect();
            for step in needed {
                self.needing[step].push(index);
            }
            if sources.is_empty() {
                self.sourceless.push(index);
            }
            let targets: Vec<usize> = transition.targets.iter().map(|step| step.index()).list();
            self.arcs.push(Arc {
                sources,
                entered: self.entered(&targets),
                targets,
                partial: transition.partial.index(),
                demands,
                asks,
                partners: Vec::new(),
                dragged: Vec::new(),
            });
        }
    }

    /// Finds the transitions that must be looked at together: both ask for steps, they share a source, or one that asks activates a source of
    /// the other.
    fn pair(&mut self, drags: &[Vec<usize>]) {
        let arcs = &self.arcs;
        let leaving = self.by_step(arcs.iter().map(|arc| &arc.sources[..]));
        let entering = self.by_step(arcs.iter().map(|arc| &arc.entered[..]));
        let asking: Vec<usize> = (0..arcs.len()).filter(|index| arcs[*index].asks).list();
        let mut activating = vec![Vec::new(); self.part_of.len()];
        for index in &asking {
            for target in &arcs[*index].targets {
                activating[*target].push(*index);
            }
        }
        let mut partners: Vec<Vec<usize>> = Vec::with_capacity(arcs.len());
        let mut dragged: Vec<Vec<usize>> = Vec::with_capacity(arcs.len());
        for arc in arcs {
            let mut found = Vec::new();
            if arc.asks {
                found.extend(&asking);
                arc.targets.iter().for_each(|target| found.extend(&leaving[*target]));
            }
            for source in &arc.sources {
                found.extend(&leaving[*source]);
                found.extend(&activating[*source]);
            }
            partners.push(found);
        }
        for (index, drags) in drags.iter().enumerate() {
            let steps: Vec<usize> = drags.iter().flat(|drag| arcs[*drag].sources.iter().copied()).list();
            // Whatever leaves or enters such a step in the same evolution is not seen one after the other.
            for step in &steps {
                for other in leaving[*step].iter().and(&entering[*step]) {
                    partners[index].push(*other);
                    partners[*other].push(index);
                }
            }
            dragged.push(steps);
        }
        for (index, (mut partners, dragged)) in partners.into_iter().zip(dragged).enumerate() {
            sort_unstable(&mut partners);
            partners.dedup();
            partners.retain(|other| *other != index);
            (self.arcs[index].partners, self.arcs[index].dragged) = (partners, dragged);
        }
    }

    /// Per step the transitions that have it among these of theirs.
    fn by_step<'s>(&self, of_arcs: impl Iterator<Item = &'s [usize]>) -> Vec<Vec<usize>> {
        let mut by_step = vec![Vec::new(); self.part_of.len()];
        for (index, steps) in of_arcs.enumerate() {
            for step in steps {
                by_step[*step].push(index);
            }
        }
        by_step
    }

    /// The steps with all that becomes active with them: what they enclose and force.
    fn entered(&self, steps: &[usize]) -> Vec<usize> {
        let mut entered: Vec<usize> = Vec::new();
        let mut open = steps.to_vec();
        while let Some(step) = open.pop() {
            if !entered.contains(&step) {
                entered.push(step);
                open.extend(&self.links[step]);
                open.extend(self.forces[step].iter().flat(|(_, forced)| forced));
            }
        }
        sort(&mut entered);
        entered
    }

    /// The steps that do not stay active when a transition clears on this demand.
    pub(super) fn gone(&self, arc: &Arc, demand: &Demand) -> Row {
        let mut gone = Row::new(self.part_of.len());
        gone.add(&arc.sources);
        gone.add(&arc.dragged);
        gone.add(&demand.inactive);
        gone.add(&self.commanding[arc.partial]);
        for left in arc.sources.iter().filter(|source| !arc.targets.contains(source)) {
            gone.add(&self.within[*left]);
        }
        for step in &arc.entered {
            gone.add(&self.away[*step]);
        }
        gone
    }

    /// Whether a step forces away the other, or a step around it.
    fn forces_away(&self, step: usize, other: usize) -> bool {
        let away = |other: &usize, (target, forced): &(usize, Vec<usize>)| {
            *target == self.part_of[*other] && !forced.contains(other)
        };
        let mut chain = std::iter::once(&other).and(&self.around[other]);
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
