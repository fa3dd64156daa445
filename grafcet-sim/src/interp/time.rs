//! Timers: the on-delay of IEC 61131-3 and the general delay of IEC 60848.

use std::collections::{BTreeMap, BTreeSet};

use super::value::Error;
use super::view::View;
use grafcet_compiler::model::{AssociationId, DelayId, Expr, Model, Name, Place, Read, TimeRef};

/// How long a signal has had a value. The time between two cycles counts if the signal had it in both.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Stopwatch {
    running: bool,
    elapsed: u32,
}

impl Stopwatch {
    /// As it was left.
    pub(super) const fn of(running: bool, elapsed: u32) -> Self {
        Self { running, elapsed }
    }

    /// One cycle, `elapsed` ticks after the one before; `restart` begins anew without a gap in the signal.
    pub(super) fn step(&mut self, signal: bool, elapsed: u32, restart: bool) {
        self.elapsed = if signal && self.running && !restart { self.elapsed.saturating_add(elapsed) } else { 0 };
        self.running = signal;
    }

    /// No longer than this.
    pub(super) fn settle(&mut self, longest: u32) {
        self.elapsed = self.elapsed.min(longest);
    }

    /// Whether the signal has been there for `time`; a time of zero counts as elapsed at once (A35).
    pub(super) fn reached(self, time: u32) -> bool {
        self.running && self.elapsed >= time
    }
}

/// `t1/e/t2`: true once `e` has been true for `t1`, false once it has been false for `t2`.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Delayed {
    on: Stopwatch,
    off: Stopwatch,
    pub(super) output: bool,
}

impl Delayed {
    /// As it was left: what it has seen, and how long that has been so.
    pub(super) fn of(signal: bool, held: u32, output: bool) -> Self {
        let (still, counted) = (Stopwatch::default(), Stopwatch::of(true, held));
        let (on, off) = if signal { (counted, still) } else { (still, counted) };
        Self { on, off, output }
    }

    /// No longer than this.
    pub(super) fn settle(&mut self, longest: u32) {
        self.on.settle(longest);
        self.off.settle(longest);
    }

    /// The signal of the last cycle, and how long it has been so.
    pub(super) fn counted(self) -> (bool, u32) {
        if self.on.running { (true, self.on.elapsed) } else { (false, self.off.elapsed) }
    }

    /// One cycle, `elapsed` ticks after the one before.
    pub(super) fn step(&mut self, signal: bool, elapsed: u32, (on, off): (u32, u32)) {
        self.on.step(signal, elapsed, false);
        self.off.step(!signal, elapsed, false);
        if self.on.reached(on) {
            self.output = true;
        }
        if self.off.reached(off) {
            self.output = false;
        }
    }
}

/// A36: samples every delay once per cycle, on the situation the cycle starts from, inner delays first.
pub(super) fn sample_delays(
    delays: &mut BTreeMap<DelayId, Delayed>,
    elapsed: u32,
    view: &View<'_>,
) -> Result<BTreeMap<DelayId, bool>, Error> {
    let mut outputs = BTreeMap::new();
    for id in innermost_first(view.model) {
        let delay = &view.model.delays[id];
        let view = View { delays: &outputs, ..*view };
        let signal = view.holds(&delay.of.tree)?;
        let times = (view.ticks(delay.on)?, view.ticks(delay.off)?);
        let state = delays.entry(id).or_default();
        state.step(signal, elapsed, times);
        outputs.insert(id, state.output);
    }
    Ok(outputs)
}

/// All delays, each after those that its expression reads.
fn innermost_first(model: &Model) -> Vec<DelayId> {
    let mut order = Order { model, seen: BTreeSet::new(), delays: Vec::new() };
    model.delays.ids().for_each(|id| order.read(Read::Delay(id)));
    order.delays
}

/// A walk over what expressions read, through edges and combinational variables.
struct Order<'m> {
    model: &'m Model,
    seen: BTreeSet<Read>,
    delays: Vec<DelayId>,
}

impl Order<'_> {
    fn read(&mut self, read: Read) {
        if !self.seen.insert(read) {
            return;
        }
        match read {
            Read::Rising(edge) | Read::Falling(edge) => self.expr(&self.model.edges[edge].of),
            Read::Delay(id) => {
                let delay = &self.model.delays[id];
                self.expr(&delay.of);
                self.time(delay.on);
                self.time(delay.off);
                self.delays.push(id);
            }
            Read::Name(Name::Var(var)) => {
                for id in super::continuous::associations_of(self.model, Place::Var(var)) {
                    self.association(id);
                }
            }
            _ => {}
        }
    }

    fn expr(&mut self, expr: &Expr) {
        expr.reads.iter().for_each(|read| self.read(*read));
    }

    fn time(&mut self, time: TimeRef) {
        if let TimeRef::Var(id) = time {
            self.read(Read::Name(Name::Var(id)));
        }
    }

    fn association(&mut self, id: AssociationId) {
        if let Some(condition) = &self.model.associations[id].condition {
            self.expr(condition);
        }
    }
}
