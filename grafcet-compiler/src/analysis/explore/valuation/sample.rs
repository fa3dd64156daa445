//! What the end of a cycle leaves to the next one: what was decided, and what edges compare with.

use super::knowledge::{Knowledge, Known, Learnt};
use super::{Valuation, When};
use crate::analysis::explore::net::formula::{AtomId, Formula, Kind};
use crate::list::List;
use crate::sorted::{sort, sort_unstable};

impl Valuation<'_> {
    /// What was decided about this cycle, and about the cycle before it, ascending.
    pub(crate) fn decided(&self) -> (Learnt, Learnt) {
        let decided = |knowledge: &Knowledge| {
            let pairs = knowledge.learnt().iter().map(|atom| (*atom, knowledge.get(*atom)));
            let mut pairs: Vec<_> = pairs.filter(|(_, known)| *known != Known::Unknown).list();
            sort(&mut pairs);
            pairs.dedup();
            pairs
        };
        // What assumptions say of other inputs of the cycle before need not be what was decided there.
        let mut past = decided(&self.recorded);
        past.retain(|(atom, _)| self.net.is_edge_atom[*atom]);
        (decided(&self.given), past)
    }

    /// Whether something is known of an atom of the formula, which is about inputs: in this cycle, or the one before.
    pub(crate) fn touches(&self, formula: &Formula, when: When) -> bool {
        let knowledge = if when == When::Before { &self.recorded } else { &self.given };
        match formula {
            Formula::Is(atom) | Formula::Below(atom, _) | Formula::Equals(atom, _) => {
                let known = |atom: &AtomId| knowledge.get(*atom) != Known::Unknown;
                let beside = self.net.beside.get(atom).map_or(&[][..], Vec::as_slice);
                known(atom) || self.net.links.with(*atom).iter().and(beside).any(known)
            }
            Formula::Not(inner) => self.touches(inner, when),
            Formula::And(a, b) | Formula::Or(a, b) | Formula::Same(a, b) => {
                self.touches(a, when) || self.touches(b, when)
            }
            Formula::Const(_) | Formula::Rising(_) | Formula::Falling(_) | Formula::Shared(_) => false,
        }
    }

    /// The same as [`Valuation::decide`] for what is about inputs: in this cycle, or the one before.
    pub(crate) fn decide_inputs(&mut self, formula: &Formula, when: When) -> bool {
        // Between evolutions of one cycle the inputs do not change.
        let previous = self.previous.take();
        let value = self.decide(formula, when);
        self.previous = previous;
        value
    }

    /// The atoms that edges look at which may be asked for in the next cycle, ascending.
    fn edge_atoms(&self) -> Vec<AtomId> {
        let mut atoms: Vec<AtomId> = Vec::new();
        for step in &self.now.active {
            atoms.extend(&self.net.edge_atoms[*step]);
        }
        atoms.extend(&self.net.common_edge_atoms);
        sort_unstable(&mut atoms);
        atoms.dedup();
        atoms
    }

    /// Decides all that the edges of the next cycle may compare with.
    pub(crate) fn decide_edges(&mut self, when: When) {
        let (net, atoms) = (self.net, self.edge_atoms());
        for (edge, of) in net.edges.iter() {
            if let Some(of) = of.as_ref().filter(|_| net.edge_reads(edge, &atoms)) {
                self.decide(of, when);
            }
        }
    }

    /// What the edges that may be asked for in the next cycle compare with.
    pub(crate) fn sample(&self, when: When) -> Vec<(AtomId, Known)> {
        let net = self.net;
        let mut sampled = Vec::new();
        for atom in self.edge_atoms() {
            let known = self.value_of(atom, when);
            let said = match net.atoms[atom].kind {
                Kind::Number(low, high) => known != Known::Range(low, high),
                Kind::Since(_) | Kind::MacroSince(_) => known != Known::Range(0, i128::from(u32::MAX)),
                _ => known != Known::Unknown,
            };
            if said {
                sampled.push((atom, known));
            }
        }
        sampled
    }
}
