//! Whether a way breaks a property, as the interpreter sees it: cycle by cycle, with nothing of the circuit.

use grafcet_compiler::model::{Claim, Model, Tree};
use grafcet_sim::interp::{ClosedLoop, Error, Remembered, Value, World};

/// What breaks a property.
pub(crate) enum Goal<'m> {
    /// It holds at the end of the last cycle.
    End(Tree),
    /// The second has not held so many ticks after the first did, or never does.
    Answer(&'m Tree, &'m Tree, Option<u32>),
    /// The second holds, and the first has not held yet.
    Order(&'m Tree, &'m Tree),
    /// Any end, of a chart alone.
    Anywhere,
}

impl<'m> Goal<'m> {
    /// What breaks each of the assumptions over several cycles; a matter of the chart alone has none.
    pub(crate) fn assumed(&self, model: &'m Model) -> Vec<Self> {
        match self {
            Self::Anywhere => Vec::new(),
            _ => model.orders.iter().filter_map(|order| Self::of(&order.claim)).collect(),
        }
    }

    /// None for a home situation.
    pub(crate) fn of(claim: &'m Claim) -> Option<Self> {
        match claim {
            Claim::LeadsTo { from, to, within } => Some(Self::Answer(&from.tree, &to.tree, *within)),
            Claim::Before { first, then } => Some(Self::Order(&first.tree, &then.tree)),
            claim => claim.violation().map(Self::End),
        }
    }
}

/// What has been seen of a goal so far.
pub(crate) struct Watch<'g> {
    goal: &'g Goal<'g>,
    /// The number of the cycle since whose end an answer is waited for, and its reading of the clock.
    since: Option<(usize, u32)>,
    /// What has to come first has come.
    seen: bool,
    remembered: Remembered,
    cycles: usize,
    is_broken: bool,
}

impl<'g> Watch<'g> {
    pub(crate) fn new(model: &Model, goal: &'g Goal<'g>) -> Self {
        let remembered = Remembered::new(model);
        Self { goal, since: None, seen: false, remembered, cycles: 0, is_broken: false }
    }

    /// After a cycle.
    ///
    /// # Errors
    /// The interpreter does not understand the property.
    pub(crate) fn cycle(
        &mut self,
        machine: &ClosedLoop<'_>,
        world: &dyn World,
        inputs: &[Value],
        now: u32,
    ) -> Result<(), Error> {
        self.remembered.cycle(machine.chart(), world, inputs, now);
        let holds = |tree: &Tree| self.remembered.holds(machine.chart(), world, tree, inputs);
        match self.goal {
            Goal::End(violation) => self.is_broken = holds(violation)?,
            Goal::Answer(from, to, within) => {
                let (from, to) = (holds(from)?, holds(to)?);
                match self.since {
                    _ if to => self.since = None,
                    None => self.since = from.then_some((self.cycles, now)),
                    Some(_) => {}
                }
                let late = |ticks: u32| self.since.is_some_and(|(_, since)| now.wrapping_sub(since) >= ticks);
                self.is_broken = within.is_some_and(late);
            }
            Goal::Anywhere => self.is_broken = true,
            Goal::Order(first, then) => {
                self.seen |= holds(first)?;
                self.is_broken = holds(then)? && !self.seen;
            }
        }
        self.cycles += 1;
        Ok(())
    }

    /// At the end of the last cycle.
    pub(crate) fn is_broken(&self) -> bool {
        self.is_broken
    }

    /// An answer has been waited for since before this cycle, which is counted from zero.
    pub(crate) fn waits_since_before(&self, cycle: usize) -> bool {
        self.since.is_some_and(|(since, _)| since < cycle)
    }
}
