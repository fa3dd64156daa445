//! From a model to a net.

use super::actions::Actions;
use super::compile::Compiler;
use super::formula::{Atom, AtomId, Formula, Kind, SharedId};
use super::links::Links;
use super::slice::Slice;
use super::slots::Slots;
use super::{Arc, Net, Order, Part};
use super::{actions, clocks, unfollowed, units};
use crate::analysis::Facts;
use crate::analysis::explore::verdicts::rivals::{Rival, Rivals};
use crate::list::List;
use crate::model::{Arena, EdgeId, ForceOrder, Model, PartialId, Step, StepId, Transition, TransitionId, Tree};
use crate::sorted::{Map, sort_unstable};

/// What a chart is explored for.
struct Subject<'a, 'm> {
    watched: &'a [&'a Tree],
    rivals: &'a [(Rival<'m>, Rival<'m>)],
    slice: Option<&'a Slice>,
}

/// The condition of what is left out.
const FALSE: Tree = Tree::Bool(false);

impl Net {
    pub(crate) fn of(model: &Model, facts: &Facts<'_>, watched: &[&Tree], assumed_never: &[&Tree]) -> Self {
        Self::with(model, facts, &Subject { watched, rivals: &[], slice: None }, assumed_never)
    }

    /// Only what decides about the watched expressions, or about where some steps are.
    pub(crate) fn sliced(model: &Model, facts: &Facts<'_>, slice: &Slice, watched: &[&Tree]) -> Self {
        Self::with(model, facts, &Subject { watched, rivals: &[], slice: Some(slice) }, &facts.never)
    }

    /// A chart of which pairs of stored actions are watched.
    pub(crate) fn beside(model: &Model, facts: &Facts<'_>, rivals: &[(Rival<'_>, Rival<'_>)]) -> Self {
        Self::with(model, facts, &Subject { watched: &[], rivals, slice: None }, &facts.never)
    }

    fn with(model: &Model, facts: &Facts<'_>, subject: &Subject<'_, '_>, assumed_never: &[&Tree]) -> Self {
        let (mut net, conditions) = Self::undrawn(model, facts, subject, assumed_never);
        if net.parts.values().any(|part| part.enclosed_by.is_some() || !part.orders.is_empty()) {
            net.hierarchy.clone_from(&facts.top_down);
        }
        net.draw(model, conditions);
        net.note_edges();
        net.note_common();
        net.note_confluence();
        net.clocks = clocks::of(&net);
        let assumed: Vec<AtomId> = net.assumed_never.iter().flat(|formula| net.atoms_of(formula)).list();
        net.beside = unfollowed::beside(&net.atoms, &net.unfollowed, &assumed);
        net
    }

    /// Without its transitions, of which the conditions are returned, and without what follows from those.
    fn undrawn(
        model: &Model,
        facts: &Facts<'_>,
        subject: &Subject<'_, '_>,
        assumed_never: &[&Tree],
    ) -> (Self, Vec<Formula>) {
        let Compiled { slots, atoms, links, edges, shared, conditions, actions, watched, assumed_never, approximate } =
            Compiled::of(model, facts, subject, assumed_never);
        let presumed = unfollowed::presumed(&atoms, &links);
        let unfollowed = unfollowed::atoms(&atoms, &links, &presumed);
        let (count, steps) = (atoms.len(), model.steps.len());
        let (unit_of, units) = units::of(model);
        let is_kept = |step: &&StepId| subject.slice.is_none_or(|slice| slice.has_step(model, **step));
        let net = Self {
            grafcet: model.is_grafcet(),
            arcs: Arena::default(),
            leaving: Arena::filled(steps, Vec::new()),
            sourceless: Vec::new(),
            calls: atoms.ids().filter(|atom| atoms[*atom].what.may_differ()).list(),
            has_volatile: atoms.values().any(|atom| atom.volatile),
            bound: unfollowed::bound(&atoms, &unfollowed),
            atoms,
            links,
            edges,
            shared,
            actions,
            writes_more: unfollowed::writers(model, &slots),
            initial_slots: slots.initial,
            shown_slots: slots.shown,
            initial: facts.initial.iter().filter(is_kept).copied().list(),
            parts: parts(model, subject.slice),
            commands: Arena::of(&model.steps, |_, step| !step.forces.is_empty()),
            governs: Arena::of(&model.steps, |_, step| !step.forces.is_empty() || !step.encloses.is_empty()),
            hierarchy: Vec::new(),
            part_of: Arena::of(&model.steps, |_, step| step.partial),
            has_arcs: Arena::filled(units, false),
            unit_of,
            is_final: Arena::of(&model.steps, |_, step| step.is_final),
            macros: Arena::of(&model.macros, |_, of| of.steps.clone()),
            edge_atoms: Arena::filled(steps, Vec::new()),
            common_edge_atoms: Vec::new(),
            is_edge_atom: Arena::filled(count, false),
            is_common: Arena::filled(count, false),
            unfollowed,
            presumed,
            beside: Map::new(),
            clocks: Vec::new(),
            confluent: (true, Arena::filled(units, true)),
            watched,
            assumed_never,
            approximate,
            max_evolutions: model.max_evolutions.map_or(2 * steps + 2, |n| n as usize),
            structure: None,
        };
        (net, conditions)
    }

    fn draw(&mut self, model: &Model, conditions: Vec<Formula>) {
        for ((id, transition), condition) in model.transitions.iter().zip(conditions) {
            let mut sources: Vec<StepId> = transition.sources.clone();
            sort_unstable(&mut sources);
            for source in &sources {
                self.leaving[*source].push(id);
            }
            if sources.is_empty() {
                self.sourceless.push(id);
            }
            let (mut atoms, mut edge_atoms) = (Vec::new(), Vec::new());
            self.collect(&condition, &mut atoms, &mut edge_atoms);
            for step in transition.sources.iter().and(&transition.targets) {
                self.has_arcs[self.unit_of[*step]] = true;
            }
            let mut reads_steps: Vec<StepId> = Vec::new();
            for atom in &atoms {
                match self.atoms[*atom].kind {
                    Kind::Step(step) | Kind::Was(step) | Kind::Since(step) | Kind::Phase(step) => {
                        reads_steps.push(step);
                    }
                    Kind::Macro(id) | Kind::MacroSince(id) => reads_steps.extend(&self.macros[id]),
                    Kind::Free | Kind::Number(..) | Kind::Slot(_) => {}
                }
            }
            // Its own sources are active when it is asked; an edge of them is another matter.
            let is_step =
                |atom: &AtomId| matches!(self.atoms[*atom].kind, Kind::Step(_) | Kind::Since(_) | Kind::Phase(_));
            reads_steps.retain(|step| !sources.contains(step) || edge_atoms.iter().any(is_step));
            let reads_slots = atoms.iter().any(|atom| matches!(self.atoms[*atom].kind, Kind::Slot(_)));
            let targets = transition.targets.clone();
            let partial = transition.partial;
            let is_any = transition.any.is_some();
            self.arcs.push(Arc {
                sources,
                targets,
                condition,
                partial,
                atoms,
                reads_steps,
                reads_slots,
                edge_atoms,
                is_any,
            });
        }
    }

    /// The atoms of a condition, those of its edges beside; and what they are tied to.
    pub(crate) fn collect(&self, formula: &Formula, atoms: &mut Vec<AtomId>, edge_atoms: &mut Vec<AtomId>) {
        match formula {
            Formula::Const(_) => {}
            Formula::Is(atom) | Formula::Below(atom, _) | Formula::Equals(atom, _) => {
                add(atoms, *atom);
                self.links.with(*atom).iter().for_each(|other| add(atoms, *other));
            }
            Formula::Not(inner) => self.collect(inner, atoms, edge_atoms),
            Formula::And(a, b) | Formula::Or(a, b) | Formula::Same(a, b) => {
                self.collect(a, atoms, edge_atoms);
                self.collect(b, atoms, edge_atoms);
            }
            Formula::Rising(edge) | Formula::Falling(edge) => {
                if let Some(of) = &self.edges[*edge] {
                    let (mut inside, mut nested) = (Vec::new(), Vec::new());
                    self.collect(of, &mut inside, &mut nested);
                    for atom in inside {
                        add(atoms, atom);
                        add(edge_atoms, atom);
                    }
                }
            }
            Formula::Shared(index) => self.collect(&self.shared[*index], atoms, edge_atoms),
        }
    }

    fn note_common(&mut self) {
        let mut common = Vec::new();
        for formula in self.watched.iter().and(&self.assumed_never) {
            self.collect(formula, &mut common, &mut Vec::new());
        }
        for atom in common {
            self.is_common[atom] = true;
        }
        for atom in self.arcs.values().flat(|arc| &arc.edge_atoms) {
            self.is_edge_atom[*atom] = true;
        }
        for atom in &self.common_edge_atoms {
            self.is_edge_atom[*atom] = true;
        }
    }

    /// See [`Net::is_confluent`].
    fn note_confluence(&mut self) {
        self.confluent.0 = self.hierarchy.is_empty();
        for (id, arc) in self.arcs.iter() {
            let unit = self.unit_of_arc(id);
            let own = |step: &StepId| self.unit_of[*step] == unit;
            let asymmetric = |step: &StepId| self.leaving[*step].iter().any(|t| self.arcs[*t].sources != arc.sources);
            if arc.sources.iter().any(asymmetric) || arc.reads_slots || arc.sources.is_empty() {
                self.confluent.0 = false;
                self.confluent.1[unit] = false;
            }
            if !arc.reads_steps.is_empty() {
                self.confluent.0 = false;
                self.confluent.1[unit] &= !arc.reads_steps.iter().any(own);
            }
        }
    }

    /// Which atoms' values must be remembered while a step is active, because an edge may be asked for in the next cycle.
    fn note_edges(&mut self) {
        for arc in self.arcs.values() {
            for source in &arc.sources {
                for atom in &arc.edge_atoms {
                    add(&mut self.edge_atoms[*source], *atom);
                }
            }
        }
        let mut common: Vec<AtomId> = Vec::new();
        for formula in self.actions.formulas() {
            self.collect(formula, &mut Vec::new(), &mut common);
        }
        for transition in &self.sourceless {
            for atom in &self.arcs[*transition].edge_atoms {
                add(&mut common, *atom);
            }
        }
        let assumed: Vec<Vec<AtomId>> = self.assumed_never.iter().map(|formula| self.atoms_of(formula)).list();
        self.common_edge_atoms = with_assumed(common, &assumed);
        for step in self.edge_atoms.ids() {
            let mut atoms = with_assumed(std::mem::take(&mut self.edge_atoms[step]), &assumed);
            sort_unstable(&mut atoms);
            self.edge_atoms[step] = atoms;
        }
    }
}

/// All expressions of a chart, over the same atoms.
struct Compiled {
    slots: Slots,
    atoms: Arena<AtomId, Atom>,
    links: Links,
    edges: Arena<EdgeId, Option<Formula>>,
    shared: Arena<SharedId, Formula>,
    /// By transition.
    conditions: Vec<Formula>,
    actions: Actions,
    watched: Vec<Formula>,
    assumed_never: Vec<Formula>,
    /// Something but the assumptions takes a value as unknown.
    approximate: bool,
}

impl Compiled {
    fn of(model: &Model, facts: &Facts<'_>, subject: &Subject<'_, '_>, assumed_never: &[&Tree]) -> Self {
        let Subject { watched, rivals, slice } = *subject;
        let kept = |id: TransitionId| slice.is_none_or(|slice| slice.has_transition(model, id));
        let asked = rivals.iter().flat(|(a, b)| a.conditions().and(b.conditions()));
        let asked: Vec<&Tree> = watched.iter().copied().and(asked).list();
        let mixed = facts.mixed(model);
        let slots = Slots::of(model, mixed, &asked, &kept);
        let mut compiler = Compiler::new(model, &slots.numbers, mixed);
        let condition =
            |(id, t): (TransitionId, &Transition)| compiler.formula(if kept(id) { &t.condition.tree } else { &FALSE });
        let conditions = model.transitions.iter().map(condition).list();
        compiler.in_action = true;
        let mut actions = actions::compile(model, &slots, &mut compiler);
        compiler.in_action = false;
        actions.rivals = Rivals::of(rivals, &mut compiler);
        let watched = watched.iter().map(|tree| compiler.formula(tree)).list();
        let approximate = compiler.approximate;
        let assumed_never = assumed_never.iter().map(|tree| compiler.formula(tree)).list();
        let Compiler { atoms, edges, shared, numbers, differences, .. } = compiler;
        let links = Links::of(model, &atoms, &differences, &numbers);
        Self { slots, atoms, links, edges, shared, conditions, actions, watched, assumed_never, approximate }
    }
}

fn add(atoms: &mut Vec<AtomId>, atom: AtomId) {
    if !atoms.contains(&atom) {
        atoms.push(atom);
    }
}

fn parts(model: &Model, slice: Option<&Slice>) -> Arena<PartialId, Part> {
    let mut orders: Map<PartialId, Vec<(StepId, Order)>> = Map::new();
    let pick = |part: &crate::model::Partial, wanted: fn(&Step) -> bool| -> Vec<StepId> {
        let mut steps: Vec<StepId> = part.steps.iter().filter(|step| wanted(&model.steps[**step])).copied().list();
        sort_unstable(&mut steps);
        steps
    };
    let is_left_out = |id: PartialId| slice.is_some_and(|slice| !slice.has_partial(id));
    for force in model.forces.values().filter(|force| !is_left_out(force.target)) {
        let order = match &force.order {
            ForceOrder::Steps(steps) => {
                let mut steps: Vec<StepId> = steps.clone();
                sort_unstable(&mut steps);
                Order::To(steps)
            }
            ForceOrder::Init => Order::To(pick(&model.partials[force.target], |step| step.initial)),
            ForceOrder::Hold => Order::Hold,
        };
        orders.or_default(force.target).push((force.step, order));
    }
    Arena::of(&model.partials, |id, partial| Part {
        enclosed_by: partial.enclosed_by,
        linked: if is_left_out(id) { Vec::new() } else { pick(partial, |step| step.linked) },
        orders: orders.remove(&id).unwrap_or_default(),
    })
}

/// With what assumptions connect these atoms with: what is known of one of them in the cycle before may exclude a value of
/// another.
fn with_assumed(mut atoms: Vec<AtomId>, assumed: &[Vec<AtomId>]) -> Vec<AtomId> {
    let mut next = 0;
    while let Some(atom) = atoms.get(next).copied() {
        for other in assumed.iter().filter(|assumed| assumed.contains(&atom)).flatten() {
            add(&mut atoms, *other);
        }
        next += 1;
    }
    atoms
}
