//! Times that have to be followed: where waiting too long closes a way, it matters that the time of a step only grows.
//!
//! All others count as unknown in each cycle anew, which is as good: who can wait has any time that is wanted.

use super::Net;
use super::formula::{AtomId, Formula, Kind};
use crate::analysis::explore::valuation::knowledge::{Known, Learnt};
use crate::analysis::explore::valuation::{Valuation, When};
use crate::list::{List, PushAll};
use crate::model::{Arena, StepId};
use crate::sorted::Set;

/// The time of a step or of a macro-step.
#[derive(Debug)]
pub(crate) struct Clock {
    pub(crate) atom: AtomId,
    /// What conditions compare it with, ascending: it is known by which of these it has reached.
    pub(crate) marks: Set<i128>,
}

/// The times of a chart that have to be followed: all that conditions do more with than to wait until they have passed,
/// each for its own steps.
pub(crate) fn of(net: &Net) -> Vec<Clock> {
    let mut reader = Reader { net, followed: Arena::filled(net.atoms.len(), false) };
    for arc in net.arcs.values() {
        reader.read(&arc.condition, &arc.sources, Some(true));
    }
    for formula in net.actions.formulas() {
        reader.read(formula, &[], None);
    }
    let mut marks: Arena<AtomId, Set<i128>> = Arena::filled(net.atoms.len(), Set::new());
    net.formulas().for_each(|formula| note_marks(formula, &mut marks));
    let followed = net.atoms.ids().filter(|atom| reader.followed[*atom]);
    followed.map(|atom| Clock { atom, marks: std::mem::take(&mut marks[atom]) }).list()
}

struct Reader<'n> {
    net: &'n Net,
    /// Per atom.
    followed: Arena<AtomId, bool>,
}

impl Reader<'_> {
    /// Notes the times that a formula does not only wait for while these steps are active. It is wanted to be `wanted`, if
    /// that can be said.
    fn read(&mut self, formula: &Formula, own: &[StepId], wanted: Option<bool>) {
        let net = self.net;
        match formula {
            Formula::Const(_) | Formula::Is(_) => {}
            Formula::Below(atom, _) => {
                let waits = wanted == Some(false) && self.is_own(*atom, own);
                self.followed[*atom] |= !waits && self.is_time(*atom);
            }
            Formula::Equals(atom, _) => self.followed[*atom] |= self.is_time(*atom),
            Formula::Not(inner) => self.read(inner, own, wanted.map(|wanted| !wanted)),
            Formula::And(a, b) | Formula::Or(a, b) => [a, b].iter().for_each(|part| self.read(part, own, wanted)),
            Formula::Same(a, b) => [a, b].iter().for_each(|part| self.read(part, own, None)),
            Formula::Rising(edge) | Formula::Falling(edge) => {
                if let Some(of) = &net.edges[*edge] {
                    self.read(of, own, None);
                }
            }
            Formula::Shared(index) => self.read(&net.shared[*index], own, wanted),
        }
    }

    fn is_time(&self, atom: AtomId) -> bool {
        matches!(self.net.atoms[atom].kind, Kind::Since(_) | Kind::MacroSince(_))
    }

    /// Whether the time runs as long as the steps are active.
    fn is_own(&self, atom: AtomId, steps: &[StepId]) -> bool {
        match self.net.atoms[atom].kind {
            Kind::Since(step) => steps.contains(&step),
            Kind::MacroSince(id) => steps.iter().any(|step| self.net.macros[id].contains(step)),
            _ => false,
        }
    }
}

fn note_marks(formula: &Formula, marks: &mut Arena<AtomId, Set<i128>>) {
    match formula {
        Formula::Below(atom, bound) => marks[*atom].extend([*bound]),
        Formula::Equals(atom, value) => marks[*atom].extend([*value, value.saturating_add(1)]),
        Formula::Not(inner) => note_marks(inner, marks),
        Formula::And(a, b) | Formula::Or(a, b) | Formula::Same(a, b) => {
            note_marks(a, marks);
            note_marks(b, marks);
        }
        Formula::Const(_) | Formula::Is(_) | Formula::Rising(_) | Formula::Falling(_) | Formula::Shared(_) => {}
    }
}

impl Valuation<'_> {
    /// Decides how late it is at the end of a cycle that began with some steps active. Returns what stays so.
    pub(crate) fn ages(&mut self, before: &[StepId]) -> Learnt {
        let net = self.net;
        let mut ages = Vec::new();
        for Clock { atom, marks } in &net.clocks {
            if !self.runs_on(*atom, before) {
                continue;
            }
            let comes = marks.iter().position(|mark| self.decide(&Formula::Below(*atom, *mark), When::Now));
            let reached = marks[..comes.unwrap_or(marks.len())].last();
            ages.push_all(reached.map(|mark| (*atom, Known::Range(*mark, net.range(*atom).1))));
        }
        ages
    }

    /// Whether a time did not begin in this cycle, and goes on in the next.
    fn runs_on(&self, atom: AtomId, before: &[StepId]) -> bool {
        let is_in = |active: &[StepId], step: &StepId| active.binary_search(step).is_ok();
        let after = &self.now.active;
        match self.net.atoms[atom].kind {
            Kind::Since(step) => is_in(before, &step) && is_in(after, &step) && !self.just_entered.contains(&step),
            Kind::MacroSince(id) => {
                let any = |active: &[StepId]| self.net.macros[id].iter().any(|step| is_in(active, step));
                any(before) && any(after)
            }
            _ => false,
        }
    }
}
