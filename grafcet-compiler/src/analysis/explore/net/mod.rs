//! A chart made ready to be run: everything by number, conditions compiled.

pub(crate) mod actions;
mod build;
pub(crate) mod clocks;
pub(crate) mod compile;
pub(crate) mod formula;
pub(crate) mod links;
pub(crate) mod slice;
pub(crate) mod slots;
pub(crate) mod unfollowed;
pub(crate) mod units;

use self::actions::Actions;
use self::clocks::Clock;
use self::formula::{Atom, AtomId, Formula, Kind, SharedId};
use self::links::Links;
use self::slots::{Bit, SlotId};
use self::units::UnitId;
use crate::analysis::Concurrency;
use crate::list::List;
use crate::model::{Arena, EdgeId, Id, MacroId, PartialId, StepId, TransitionId};
use crate::sorted::{Map, sort_unstable};

/// A transition.
pub(crate) struct Arc {
    pub(crate) sources: Vec<StepId>,
    pub(crate) targets: Vec<StepId>,
    pub(crate) condition: Formula,
    pub(crate) partial: PartialId,
    /// The atoms of the condition.
    pub(crate) atoms: Vec<AtomId>,
    /// Steps that the condition reads, its sources excepted.
    pub(crate) reads_steps: Vec<StepId>,
    /// The condition reads variables that are followed.
    pub(crate) reads_slots: bool,
    /// The atoms that the edges in its condition look at.
    pub(crate) edge_atoms: Vec<AtomId>,
    /// It is one of those for which an `any` stands.
    pub(crate) is_any: bool,
}

/// A partial grafcet, as forcing and enclosing see it.
pub(crate) struct Part {
    pub(crate) enclosed_by: Option<StepId>,
    pub(crate) linked: Vec<StepId>,
    /// The orders it may get: from which step, and which.
    pub(crate) orders: Vec<(StepId, Order)>,
}

/// A forcing order.
pub(crate) enum Order {
    To(Vec<StepId>),
    Hold,
}

/// A chart.
pub(crate) struct Net {
    pub(crate) grafcet: bool,
    pub(crate) arcs: Arena<TransitionId, Arc>,
    /// Per step the transitions that leave it.
    pub(crate) leaving: Arena<StepId, Vec<TransitionId>>,
    pub(crate) sourceless: Vec<TransitionId>,
    pub(crate) atoms: Arena<AtomId, Atom>,
    pub(crate) links: Links,
    /// Atoms whose values may differ in each evaluation.
    pub(crate) calls: Vec<AtomId>,
    /// Actions that are not followed may change some atoms.
    pub(crate) has_volatile: bool,
    /// What each edge looks at, where it is used.
    pub(crate) edges: Arena<EdgeId, Option<Formula>>,
    pub(crate) shared: Arena<SharedId, Formula>,
    pub(crate) actions: Actions,
    pub(crate) initial_slots: Arena<SlotId, Bit>,
    /// Slots that hold nothing for the next cycle.
    pub(crate) shown_slots: Vec<SlotId>,
    /// Steps active before the first cycle.
    pub(crate) initial: Vec<StepId>,
    pub(crate) parts: Arena<PartialId, Part>,
    /// Steps that give orders to other partial grafcets.
    commands: Arena<StepId, bool>,
    /// Those, and the steps that enclose some.
    pub(crate) governs: Arena<StepId, bool>,
    /// From top to bottom; empty where no partial grafcet acts on another.
    pub(crate) hierarchy: Vec<PartialId>,
    pub(crate) part_of: Arena<StepId, PartialId>,
    /// The connected piece of its partial grafcet to which each step belongs.
    pub(crate) unit_of: Arena<StepId, UnitId>,
    /// Of each piece, whether it has transitions.
    pub(crate) has_arcs: Arena<UnitId, bool>,
    pub(crate) is_final: Arena<StepId, bool>,
    pub(crate) macros: Arena<MacroId, Vec<StepId>>,
    /// Per step the atoms that edges in the conditions of its transitions look at.
    pub(crate) edge_atoms: Arena<StepId, Vec<AtomId>>,
    /// Those that edges in actions and in source transitions look at.
    pub(crate) common_edge_atoms: Vec<AtomId>,
    /// Atoms that edges look at.
    pub(crate) is_edge_atom: Arena<AtomId, bool>,
    /// Atoms of assumptions and watched expressions.
    pub(crate) is_common: Arena<AtomId, bool>,
    /// See [`unfollowed::atoms`].
    pub(crate) unfollowed: Arena<AtomId, bool>,
    /// See [`unfollowed::presumed`].
    pub(crate) presumed: Arena<AtomId, bool>,
    /// See [`unfollowed::bound`].
    pub(crate) bound: Arena<AtomId, bool>,
    /// See [`unfollowed::beside`].
    pub(crate) beside: Map<AtomId, Vec<AtomId>>,
    /// Times that have to be followed, where that is asked for.
    pub(crate) clocks: Vec<Clock>,
    /// Steps and transitions with actions that write what is not followed.
    pub(crate) writes_more: (Arena<StepId, bool>, Arena<TransitionId, bool>),
    /// See [`Net::is_confluent`]: of the whole chart, and of each piece alone.
    confluent: (bool, Arena<UnitId, bool>),
    pub(crate) watched: Vec<Formula>,
    pub(crate) assumed_never: Vec<Formula>,
    /// Something is taken as unknown.
    pub(crate) approximate: bool,
    pub(crate) max_evolutions: usize,
    /// What the structure tells, where the chart is not explored as a whole.
    pub(crate) structure: Option<Concurrency>,
}

impl Net {
    /// `grafcet`: whether the situation in which a search for stability ends is the same in whatever order transitions
    /// clear, as long as the inputs stay: no transition takes a source from another that waits for more than that, and no
    /// condition reads a step or a variable that others change.
    pub(crate) fn is_confluent(&self, unit: Option<UnitId>) -> bool {
        unit.map_or(self.confluent.0, |unit| self.confluent.1[unit])
    }

    /// Whether anything is not followed that conditions read; see [`unfollowed::atoms`].
    pub(crate) fn has_unfollowed(&self) -> bool {
        self.unfollowed.values().any(|is| *is)
    }

    /// Whether something that is followed may begin with any value.
    pub(crate) fn is_any_slot_open(&self) -> bool {
        self.initial_slots.values().any(|bit| *bit == Bit::Any)
    }

    /// Whether the edge looks at one of these atoms.
    pub(crate) fn edge_reads(&self, edge: EdgeId, among: &[AtomId]) -> bool {
        let read = |of| self.atoms_of(of).iter().any(|atom| among.binary_search(atom).is_ok());
        self.edges[edge].as_ref().is_some_and(read)
    }

    /// All that is evaluated.
    pub(crate) fn formulas(&self) -> impl Iterator<Item = &Formula> {
        let conditions = self.arcs.values().map(|arc| &arc.condition);
        let parts = self.shared.values().and(self.edges.values().flatten()).and(&self.watched);
        conditions.and(parts).and(self.actions.formulas())
    }

    fn atoms_of(&self, formula: &Formula) -> Vec<AtomId> {
        let mut atoms = Vec::new();
        self.collect(formula, &mut atoms, &mut Vec::new());
        atoms
    }

    /// The piece of a transition.
    pub(crate) fn unit_of_arc(&self, transition: TransitionId) -> UnitId {
        let arc = &self.arcs[transition];
        arc.sources.first().or(arc.targets.first()).map_or_else(|| UnitId::new(0), |step| self.unit_of[*step])
    }

    /// The values a number can have.
    pub(crate) fn range(&self, atom: AtomId) -> (i128, i128) {
        match self.atoms[atom].kind {
            Kind::Number(low, high) => (low, high),
            _ => (0, i128::from(u32::MAX)),
        }
    }

    /// The slots that actions of other pieces than this one write.
    pub(crate) fn foreign_slots(&self, unit: UnitId) -> Vec<SlotId> {
        let writers = self.actions.writers();
        let foreign = |(step, arc): (Option<StepId>, Option<TransitionId>)| {
            let unit_of = step.map(|step| self.unit_of[step]).or_else(|| arc.map(|arc| self.unit_of_arc(arc)));
            unit_of != Some(unit)
        };
        let slots = writers.into_iter().filter(|(_, by)| foreign(*by)).map(|(slot, _)| slot);
        let mut slots: Vec<SlotId> = slots.list();
        sort_unstable(&mut slots);
        slots.dedup();
        slots
    }

    /// Whether the structure lets two steps be active together.
    pub(crate) fn may_meet(&self, a: StepId, b: StepId) -> bool {
        self.structure.as_ref().is_none_or(|structure| structure.together(a, b))
    }

    /// Whether a situation gives any orders.
    pub(crate) fn orders_any(&self, active: &[StepId]) -> bool {
        active.iter().any(|step| self.commands[*step])
    }

    /// The order that a situation gives to a partial grafcet; A14 leaves at most one.
    pub(crate) fn order(&self, part: PartialId, active: &[StepId]) -> Option<&Order> {
        let orders = self.parts[part].orders.iter().rev();
        orders.filter(|(step, _)| active.binary_search(step).is_ok()).map(|(_, order)| order).next()
    }
}
