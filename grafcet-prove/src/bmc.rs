//! Bounded model checking: the cycles from the beginning on, one after the other, so that what is found first is shortest.

use crate::limit::{At, Limit, Over};
use crate::sat::{Sat, Term, Wires};
use crate::task::{Task, Way};

/// The first cycles of a chart in a solver.
pub(crate) struct Unrolled<'t, 'c> {
    task: &'t Task<'c>,
    sat: Sat,
    limit: Limit,
    cycles: Vec<Wires>,
    next: Vec<Term>,
    /// Latches that may begin with any value.
    open: Vec<(usize, Term)>,
}

impl<'t, 'c> Unrolled<'t, 'c> {
    pub(crate) fn new(task: &'t Task<'c>, limit: &Limit) -> Self {
        Self::from(task, limit, &|latch| task.latch(latch).initial)
    }

    /// From any state on, whether a chart can be in it or not.
    fn anywhere(task: &'t Task<'c>, limit: &Limit) -> Self {
        Self::from(task, limit, &|_| None)
    }

    fn from(task: &'t Task<'c>, limit: &Limit, initial: &dyn Fn(usize) -> Option<bool>) -> Self {
        let mut sat = Sat::new(limit);
        let truth = sat.term();
        sat.clause(&[truth]);
        let (mut next, mut open) = (Vec::new(), Vec::new());
        for latch in &task.latches {
            let term = match initial(*latch) {
                Some(true) => truth,
                Some(false) => !truth,
                None => {
                    let term = sat.term();
                    open.push((*latch, term));
                    term
                }
            };
            next.push(term);
        }
        Self { task, sat, limit: limit.clone(), cycles: Vec::new(), next, open }
    }

    /// One cycle more; the way, if `bad` can hold at its end.
    pub(crate) fn cycle(&mut self) -> Result<Option<Way>, Over> {
        let (aig, task) = (&self.task.circuit.aig, self.task);
        self.limit.tell(At::Cycle(self.cycles.len() + 1));
        let mut wires = Wires::new(aig);
        for (latch, term) in task.latches.iter().zip(&self.next) {
            wires.bind(task.latch(*latch).now, *term);
        }
        let constraint = wires.term(&mut self.sat, aig, task.circuit.constraint);
        self.sat.clause(&[constraint]);
        let bad = wires.term(&mut self.sat, aig, task.bad);
        let found = self.sat.solve(&[bad])?;
        self.cycles.push(wires);
        let way = if found { Some(self.way()) } else { None };
        self.sat.clause(&[!bad]);
        if let Some(wires) = self.cycles.last_mut() {
            for (latch, term) in task.latches.iter().zip(&mut self.next) {
                *term = wires.term(&mut self.sat, aig, task.latch(*latch).next);
            }
        }
        Ok(way)
    }

    fn way(&mut self) -> Way {
        let (aig, task) = (&self.task.circuit.aig, self.task);
        let initial = self.open.iter().map(|(latch, term)| (*latch, self.sat.holds(*term))).collect();
        let mut inputs = Vec::new();
        for wires in &mut self.cycles {
            let mut on = Vec::new();
            for lit in task.inputs() {
                if wires.has(lit) {
                    let term = wires.term(&mut self.sat, aig, lit);
                    if self.sat.holds(term) {
                        on.push(lit.node());
                    }
                }
            }
            inputs.push(on);
        }
        Way { initial, inputs }
    }
}

/// The shortest way of at most so many cycles.
pub(crate) fn shortest(task: &Task<'_>, most: usize, limit: &Limit) -> Result<Option<Way>, Over> {
    let mut unrolled = Unrolled::new(task, limit);
    for _ in 0..most {
        if let Some(way) = unrolled.cycle()? {
            return Ok(Some(way));
        }
    }
    Ok(None)
}

/// After how many cycles at whose ends nothing bad holds nothing bad can hold in the next one, either; none where more than so many would be needed.
pub(crate) fn inductive(task: &Task<'_>, most: usize, limit: &Limit) -> Result<Option<usize>, Over> {
    let mut unrolled = Unrolled::anywhere(task, limit);
    for depth in 0..=most {
        if unrolled.cycle()?.is_none() {
            return Ok(Some(depth));
        }
    }
    Ok(None)
}
