//! What is sampled: edges, delays (A36) and combinational variables (A22), each after those it reads.

use super::Lower;
use super::places::{Asked, Edges};
use super::view::Moment;
use crate::analysis::{EdgeEnd, Gone, combinational};
use crate::list::{List, PushAll};
use crate::model::{DelayId, EdgeId, Effect, Id, Name, Place, Read, VarId};
use crate::program::build::{all, any, differ, no, not, when, yes};
use crate::program::{Expr, Statement};
use crate::sorted::Set;

/// Something that is sampled.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Sample {
    Edge(EdgeId),
    Delay(DelayId),
    Combinational(VarId),
}

/// In the first evolution it compares with itself: there is no edge.
fn hide<'m>(body: &mut Vec<Statement<'m>>, edges: Edges, first_evolution: &Expr<'m>) {
    if edges.is_hidden {
        when(body, first_evolution.clone(), vec![Statement::Set(edges.before, Expr::Place(edges.now))]);
    }
}

impl<'m> Lower<'_, 'm> {
    /// Everything that a cycle samples once: delays, and what they look at. In an `sfc` all edges of conditions too.
    pub(super) fn sample_once(&self) -> Vec<Statement<'m>> {
        let mut order = Vec::new();
        let mut seen = Set::new();
        for id in self.model.delays.ids() {
            self.visit(Sample::Delay(id), &mut seen, &mut order);
        }
        if !self.model.is_grafcet() {
            self.visit_edges(&mut seen, &mut order);
        }
        self.samples(&order, &Expr::Place(self.first))
    }

    /// What each evolution of a search samples: edges and combinational variables. `first_evolution` says that it is the very first one,
    /// which has no edges (A26).
    pub(super) fn sample_evolution(&self, first_evolution: &Expr<'m>) -> Vec<Statement<'m>> {
        let mut order = Vec::new();
        let mut seen = Set::new();
        self.visit_edges(&mut seen, &mut order);
        for var in self.model.vars.ids() {
            if self.combinational[var.index()].is_some() {
                self.visit(Sample::Combinational(var), &mut seen, &mut order);
            }
        }
        order.retain(|sample| !matches!(sample, Sample::Delay(_)));
        self.samples(&order, first_evolution)
    }

    /// Point 8: the edges that the actions of an `sfc` see.
    pub(super) fn sample_for_actions(&self) -> Vec<Statement<'m>> {
        let mut order = Vec::new();
        let mut seen = Set::new();
        for id in self.model.edges.ids() {
            if self.action_edges[id.index()].is_some() {
                self.visit(Sample::Edge(id), &mut seen, &mut order);
            }
        }
        let mut body = Vec::new();
        for sample in order {
            let Sample::Edge(id) = sample else { continue };
            let Some(edges) = self.action_edges[id.index()] else { continue };
            body.push(Statement::Set(edges.now, self.user(&self.model.edges[id].of, Moment::After)));
            hide(&mut body, edges, &Expr::Place(self.first));
        }
        body
    }

    /// The edges are seen: the next ones compare with what is now.
    pub(super) fn use_up_edges(&self) -> Vec<Statement<'m>> {
        let edges = self.edges.iter().flatten();
        edges.map(|edges| Statement::Set(edges.before, Expr::Place(edges.now))).list()
    }

    /// The same of those that actions see.
    pub(super) fn use_up_action_edges(&self) -> Vec<Statement<'m>> {
        let edges = self.action_edges.iter().flatten();
        edges.map(|edges| Statement::Set(edges.before, Expr::Place(edges.now))).list()
    }

    /// Whether there is an edge of which the end may change something: it is gone in the next cycle.
    pub(super) fn has_edges(&self) -> Expr<'m> {
        let mut found = Vec::new();
        for id in self.model.edges.ids() {
            let EdgeEnd { evolving, acting } = &self.edge_ends[id.index()];
            let gone = if self.model.is_grafcet() {
                [self.gone(evolving.always || acting.always, acting), no()]
            } else {
                [self.gone(evolving.always, evolving), self.gone(acting.always, acting)]
            };
            let places = [self.edges[id.index()], self.action_edges[id.index()]];
            for (edges, gone) in places.into_iter().zip(gone) {
                let Some(edges) = edges else { continue };
                let (before, now) = (Expr::Place(edges.before), Expr::Place(edges.now));
                let there = match edges.asked {
                    Asked::Both => differ(edges.before, edges.now),
                    Asked::Rising => all(vec![not(before), now]),
                    Asked::Falling => all(vec![before, not(now)]),
                };
                found.push(all(vec![gone, there]));
            }
        }
        any(found)
    }

    /// Whether the end of an edge may change something.
    fn gone(&self, always: bool, gone: &Gone) -> Expr<'m> {
        if always { yes() } else { Self::by_region(gone.steps.iter().map(|step| self.is(*step)).list()) }
    }

    fn visit_edges(&self, seen: &mut Set<Sample>, order: &mut Vec<Sample>) {
        for id in self.model.edges.ids() {
            if self.edges[id.index()].is_some() {
                self.visit(Sample::Edge(id), seen, order);
            }
        }
    }

    /// Puts a sample after those it reads.
    fn visit(&self, sample: Sample, seen: &mut Set<Sample>, order: &mut Vec<Sample>) {
        if !seen.insert(sample) {
            return;
        }
        let mut reads: Vec<Read> = Vec::new();
        match sample {
            Sample::Edge(id) => reads.extend(&self.model.edges[id].of.reads),
            Sample::Delay(id) => reads.extend(&self.model.delays[id].of.reads),
            Sample::Combinational(id) => {
                for condition in combinational::asserted(self.model, id).filter_map(|one| one.condition.as_ref()) {
                    reads.extend(&condition.reads);
                }
            }
        }
        for read in reads {
            match read {
                Read::Rising(id) | Read::Falling(id) => self.visit(Sample::Edge(id), seen, order),
                Read::Delay(id) => self.visit(Sample::Delay(id), seen, order),
                Read::Name(Name::Var(id)) if self.combinational[id.index()].is_some() => {
                    self.visit(Sample::Combinational(id), seen, order);
                }
                _ => {}
            }
        }
        order.push(sample);
    }

    fn samples(&self, order: &[Sample], first_evolution: &Expr<'m>) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for sample in order {
            match *sample {
                Sample::Edge(id) => {
                    let Some(edges) = self.edges[id.index()] else { continue };
                    body.push(Statement::Set(edges.now, self.user(&self.model.edges[id].of, Moment::Before)));
                    hide(&mut body, edges, first_evolution);
                }
                Sample::Delay(id) => body.push_all(self.sample_delay(id)),
                Sample::Combinational(id) => body.push_all(self.combinational(id)),
            }
        }
        body
    }

    /// A22: the OR over its associations.
    fn combinational(&self, var: VarId) -> Vec<Statement<'m>> {
        let Some(place) = self.combinational[var.index()] else { return Vec::new() };
        let mut terms = Vec::new();
        for (id, association) in self.model.associations.iter() {
            if self.is_continuous(id) && matches!(association.effect, Effect::Control(Place::Var(at)) if at == var) {
                terms.push(self.asserts(id));
            }
        }
        vec![Statement::Set(place, any(terms))]
    }
}
