//! What properties remember of the ends of cycles: their edges and delays, which are none of the chart's.

use super::time::Delayed;
use super::{Error, Interpreter, Value, World};
use grafcet_compiler::model::{Id, MemoryId, Model, Remembers, Tree};

/// The memories of a chart's properties, as the end of the last cycle left them.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Remembered {
    /// The time of that cycle; none before the first one.
    now: Option<u32>,
    all: Vec<Kept>,
}

/// What is kept of one expression.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Kept {
    /// What it was.
    signal: Option<bool>,
    delayed: Delayed,
    /// What the memory says; none where the expression is not understood.
    value: Option<bool>,
}

impl Remembered {
    /// Before the first cycle.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        Self { now: None, all: vec![Kept::default(); model.memories.len()] }
    }

    /// After a cycle at a reading of the clock, whose inputs are given.
    pub fn cycle(&mut self, chart: &Interpreter<'_>, world: &dyn World, inputs: &[Value], now: u32) {
        let elapsed = self.now.map_or(0, |before| now.wrapping_sub(before));
        self.now = Some(now);
        // Each stands after those that it reads.
        for (id, memory) in chart.model.memories.iter() {
            let mut kept = self.all[id.index()];
            kept.value = self.next((chart, world), inputs, (memory.kind, &memory.of.tree), elapsed, &mut kept).ok();
            self.all[id.index()] = kept;
        }
    }

    fn next(
        &self,
        (chart, world): (&Interpreter<'_>, &dyn World),
        inputs: &[Value],
        (kind, of): (Remembers, &Tree),
        elapsed: u32,
        kept: &mut Kept,
    ) -> Result<bool, Error> {
        let mut look = chart.look(world, inputs);
        look.remembered = Some(self);
        let signal = look.holds(of);
        let before = std::mem::replace(&mut kept.signal, signal.as_ref().ok().copied());
        let signal = signal?;
        Ok(match kind {
            // A26: in the first cycle there is no edge.
            Remembers::Rise => signal && before == Some(false),
            Remembers::Fall => !signal && before == Some(true),
            Remembers::Delay(on, off) => {
                kept.delayed.step(signal, elapsed, (look.ticks(on)?, look.ticks(off)?));
                kept.delayed.output
            }
        })
    }

    /// Whether a condition of a property holds at the end of the cycle that this was told of last.
    ///
    /// # Errors
    /// It is not understood, or would panic in Rust.
    pub fn holds(
        &self,
        chart: &Interpreter<'_>,
        world: &dyn World,
        tree: &Tree,
        inputs: &[Value],
    ) -> Result<bool, Error> {
        let mut look = chart.look(world, inputs);
        look.remembered = Some(self);
        look.holds(tree)
    }

    pub(super) fn value(&self, id: MemoryId) -> Option<bool> {
        self.all.get(id.index()).and_then(|kept| kept.value)
    }
}
