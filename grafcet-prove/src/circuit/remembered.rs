//! Edges, delays and what blinks in properties: latches that remember the ends of cycles.

use grafcet_compiler::analysis::combinational::written_out;
use grafcet_compiler::model::{Blink, Blinker, Id, MemoryId, Remembers, TimeRef, Tree};
use grafcet_compiler::program::Role;

use super::sym::Sym;
use super::{Env, Field, Latch, Lowering, Refused, Timer};
use crate::aig::Lit;
use crate::bits::{self, Bits};

/// How a clock is called, after what it belongs to. In front of it stands what it counts since it changed.
const TIME: &str = ": time";

/// What has been made for the memories of properties.
#[derive(Default)]
pub(super) struct Memories {
    /// The chart makes its first cycle.
    pub(super) first: Lit,
    /// By memory: its value at the end of the cycle, once it has been asked for.
    values: Vec<Option<Result<Lit, Refused>>>,
    fields: Vec<(String, Vec<Latch>)>,
}

impl Memories {
    /// The latches, after those that are there; the clocks among them.
    pub(super) fn finish(self, latches: &mut Vec<Latch>, fields: &mut Vec<Field>) -> Vec<Timer> {
        let mut timers = Vec::new();
        for (name, new) in self.fields {
            let (first, width) = (latches.len(), new.len());
            if name.ends_with(TIME) {
                timers.push(Timer { of: first - 1, first, width });
            }
            fields.push(Field { place: None, plant: None, name, first, width, signed: false });
            latches.extend(new);
        }
        timers
    }
}

impl Lowering<'_, '_> {
    /// The value of a memory at the end of the cycle.
    pub(super) fn remembered(&mut self, id: MemoryId, end: &Env) -> Result<Lit, Refused> {
        self.memories.values.resize(self.program.model.memories.len(), None);
        if let Some(known) = &self.memories.values[id.index()] {
            return known.clone();
        }
        let memory = &self.program.model.memories[id];
        let value = self.watched(&memory.of.tree, end).and_then(|of| match memory.kind {
            Remembers::Rise => Ok(self.rises(id, of)),
            Remembers::Fall => Ok(self.falls(id, of)),
            Remembers::Delay(on, off) => {
                let (on, off) = (self.delay_time(on, end)?, self.delay_time(off, end)?);
                Ok(self.delays(id, of, (on, off)))
            }
        });
        self.memories.values[id.index()] = Some(value.clone());
        value
    }

    /// What it looks at. Where arithmetic leaves its type, what was remembered would be another thing with overflow checks.
    fn watched(&mut self, of: &Tree, end: &Env) -> Result<Lit, Refused> {
        let written = written_out(self.program.model, of);
        let written = written.ok_or_else(|| Refused("a property over variables that stand for too much".to_owned()))?;
        let before = (self.overflow, self.panics, self.path);
        (self.overflow, self.panics) = (Lit::FALSE, Lit::FALSE);
        let value = self.at_end(&written, end);
        let fits = (self.overflow, self.panics) == (Lit::FALSE, Lit::FALSE);
        (self.overflow, self.panics, self.path) = before;
        if fits {
            value
        } else {
            value.and(Err(Refused("arithmetic that can leave its type in an edge or a delay of a property".to_owned())))
        }
    }

    fn memory(&mut self, id: MemoryId, what: &str, latches: Vec<Latch>) {
        let text = self.program.model.read_text(grafcet_compiler::model::Read::Memory(id));
        self.memories.fields.push((format!("{text}{what}"), latches));
    }

    /// A26: at the end of the first cycle nothing has risen.
    fn rises(&mut self, id: MemoryId, of: Lit) -> Lit {
        let now = self.aig.free();
        self.memory(id, ": before", vec![Latch { now, next: of, initial: Some(false) }]);
        let new = self.aig.and(of, !now);
        self.aig.and(new, !self.memories.first)
    }

    fn falls(&mut self, id: MemoryId, of: Lit) -> Lit {
        let now = self.aig.free();
        self.memory(id, ": before", vec![Latch { now, next: of, initial: Some(false) }]);
        self.aig.and(now, !of)
    }

    fn delay_time(&mut self, time: TimeRef, end: &Env) -> Result<Bits, Refused> {
        let time = match time {
            TimeRef::Ticks(ticks) => self.ticks(ticks),
            TimeRef::Param(id) => self.at(Role::Param(id), end)?,
            TimeRef::Var(id) => self.at(Role::Var(id), end)?,
        };
        self.time(&time)
    }

    /// A36, with the ends of cycles for the moments at which it is sampled.
    fn delays(&mut self, id: MemoryId, of: Lit, (on, off): (Bits, Bits)) -> Lit {
        let (before, out) = (self.aig.free(), self.aig.free());
        let counted: Vec<Lit> = (0..self.clock.width).map(|_| self.aig.free()).collect();
        let elapsed = self.elapsed.clone();
        let passed = self.add_times(&bits::unsigned(&counted), &elapsed);
        let same = self.aig.iff(before, of);
        let goes_on = self.aig.and(same, !self.memories.first);
        let held = bits::mux(&mut self.aig, goes_on, &passed, &bits::constant(0));
        let time = bits::mux(&mut self.aig, of, &on, &off);
        let over = !bits::less(&mut self.aig, &held, &time);
        let value = self.aig.mux(over, of, out);
        let width = self.clock.width;
        let held = bits::low(&held, width);
        let timer = counted.into_iter().zip(held).map(|(now, next)| Latch { now, next, initial: Some(false) });
        self.memory(id, ": before", vec![Latch { now: before, next: of, initial: Some(false) }]);
        self.memory(id, TIME, timer.collect());
        self.memory(id, "", vec![Latch { now: out, next: value, initial: Some(false) }]);
        value
    }

    /// As the program counts it, which knows what blinks in properties, too.
    pub(super) fn blinks(&mut self, blink: Blink, end: &Env) -> Result<Lit, Refused> {
        let (period, active) = (
            blink.period(),
            match blink.of {
                Blinker::Step(step) => self.is_active(step, end)?,
                Blinker::Macro(id) => self.is_macro_active(id, end)?,
            },
        );
        let role = match blink.of {
            Blinker::Step(step) => {
                let region = self.program.regions.iter().position(|steps| steps.contains(&step));
                let region = region.ok_or_else(|| Refused("a step that is not stored".to_owned()))?;
                Role::Phase { region, period: Some(period) }
            }
            Blinker::Macro(of) => Role::MacroPhase { of, period },
        };
        let Sym::Ticks(phase) = self.at(role, end)? else { return Err(Refused("a phase that is no time".to_owned())) };
        let shines = bits::less(&mut self.aig, &phase, &bits::constant(i128::from(blink.on)));
        Ok(self.aig.and(active, shines))
    }
}
