//! What is known of an atom, without deciding anything.

use super::knowledge::Known;
use super::{Snapshot, Valuation, When};
use crate::analysis::explore::net::formula::{AtomId, Kind};
use crate::analysis::explore::net::slots::{Bit, SlotId};
use crate::model::{Id, MacroId, StepId};

impl Valuation<'_> {
    /// What is known of an atom.
    pub(super) fn value(&mut self, atom: AtomId, when: When) -> Known {
        if self.reserved[atom] {
            self.spoilt = true;
        }
        self.value_of(atom, when)
    }

    pub(super) fn value_of(&self, atom: AtomId, when: When) -> Known {
        let net = self.net;
        let kind = net.atoms[atom].kind;
        if when == When::Before && self.previous.is_none() {
            return self.recorded_value(atom, kind);
        }
        if let Some((a, b)) =
            net.links.times(atom).filter(|pair| self.is_zero(pair.0, when) || self.is_zero(pair.1, when))
        {
            return between(self.value_of(a, when), self.value_of(b, when));
        }
        match kind {
            Kind::Number(low, high) => match self.given.get(atom) {
                Known::Unknown => Known::Range(low, high),
                known => known,
            },
            Kind::Step(step) if self.is_own(step) => Known::Bool(self.at(when).active.binary_search(&step).is_ok()),
            Kind::Was(step) if self.is_own(step) => {
                Known::Bool(self.at(When::Sample).active.binary_search(&step).is_ok())
            }
            Kind::Macro(id) if self.owns(id) => Known::Bool(self.any_active(id, when)),
            Kind::Phase(step) if self.is_own(step) && self.begins(step, when) => Known::Bool(true),
            Kind::Free | Kind::Step(_) | Kind::Was(_) | Kind::Macro(_) | Kind::Phase(_) => self.given.get(atom),
            Kind::Slot(slot) => self.slot(slot, when),
            Kind::Since(step) => {
                let active = self.at(when).active.binary_search(&step).is_ok();
                let timed = active || self.is_left(&[step], when);
                let zero = self.is_own(step) && (!timed || self.begins(step, when));
                self.time(atom, zero)
            }
            Kind::MacroSince(id) => {
                let timed = self.any_active(id, when) || self.is_left(&net.macros[id], when);
                let zero = self.owns(id) && !timed;
                self.time(atom, zero)
            }
        }
    }

    /// Whether an atom is a time that is zero at this moment.
    pub(super) fn is_zero(&self, atom: AtomId, when: When) -> bool {
        let is_time = matches!(self.net.atoms[atom].kind, Kind::Since(_) | Kind::MacroSince(_));
        is_time && !(when == When::Before && self.previous.is_none()) && self.value_of(atom, when) == Known::Range(0, 0)
    }

    /// Whether the time of a step begins in this cycle. `sfc`: to the edges, which look at the start of the cycle, a step that
    /// is left and entered has the time it had reached.
    fn begins(&self, step: StepId, when: When) -> bool {
        let later = when == When::Sample && self.start.is_some() && !self.edgeless;
        !later && self.just_entered.contains(&step)
    }

    /// `sfc`: whether the actions run of a cycle in which one of the steps was left: it has the time it had reached (A34).
    fn is_left(&self, steps: &[StepId], when: When) -> bool {
        let was = |start: &Snapshot| steps.iter().any(|step| start.active.binary_search(step).is_ok());
        when == When::Now && self.start.as_ref().is_some_and(was)
    }

    fn recorded_value(&self, atom: AtomId, kind: Kind) -> Known {
        match (self.recorded.get(atom), kind) {
            (Known::Unknown, Kind::Number(low, high)) => Known::Range(low, high),
            (Known::Unknown, Kind::Since(_) | Kind::MacroSince(_)) => Known::Range(0, i128::from(u32::MAX)),
            (known, _) => known,
        }
    }

    fn slot(&self, slot: SlotId, when: When) -> Known {
        let own = self.own.iter().rev().find(|(written, _)| *written == slot);
        let bit = match own {
            Some((_, bit)) if when == When::Now => *bit,
            _ => self.at(when).slots[slot.index()],
        };
        match bit {
            Bit::False => Known::Bool(false),
            Bit::True => Known::Bool(true),
            Bit::Any => Known::Unknown,
        }
    }

    fn time(&self, atom: AtomId, zero: bool) -> Known {
        match self.given.get(atom) {
            _ if zero => Known::Range(0, 0),
            Known::Unknown => Known::Range(0, i128::from(u32::MAX)),
            known => known,
        }
    }

    pub(super) fn at(&self, when: When) -> &Snapshot {
        match when {
            When::Now => &self.now,
            When::Sample => self.start.as_ref().unwrap_or(&self.now),
            When::Before => self.previous.as_ref().unwrap_or(&self.now),
        }
    }

    /// Whether the step belongs to what is explored.
    pub(super) fn is_own(&self, step: StepId) -> bool {
        self.unit.is_none_or(|unit| self.net.unit_of[step] == unit)
    }

    pub(super) fn owns(&self, id: MacroId) -> bool {
        self.net.macros[id].first().is_none_or(|step| self.is_own(*step))
    }

    fn any_active(&self, id: MacroId, when: When) -> bool {
        let active = &self.at(when).active;
        self.net.macros[id].iter().any(|step| active.binary_search(step).is_ok())
    }
}

/// What is known of the difference of two numbers.
fn between(a: Known, b: Known) -> Known {
    match (a, b) {
        (Known::Range(low, high), Known::Range(least, most)) => {
            Known::Range(low.saturating_sub(most), high.saturating_sub(least))
        }
        _ => Known::Unknown,
    }
}
