//! How long steps and macro-steps have been active, in expressions.

use grafcet_compiler::model::{Blink, Blinker, Id, MacroId, Read, StepId, TimeRef};

use super::expr::{At, Moment, Scope, plain, refuse};
use super::text::{Text, all};
use super::time;
use crate::Refused;

/// A time as a number.
const MILLISECONDS: &str = "TIME_TO_DINT";

impl Scope<'_> {
    /// True and false in turn since the step was activated: where in its period the time of the step is.
    pub(super) fn blink(&mut self, blink: Blink, at: &At<'_>) -> Result<Text, Refused> {
        if self.steps.is_some() {
            return Err(refuse(at, "`blink`", "write it as two steps, each with its time"));
        }
        may_read_times(at)?;
        let [on, off] = [blink.on, blink.off].map(|ticks| time::milliseconds(self.model, ticks, at.mark));
        let (on, off) = (on?, off?);
        let (active, since) = match blink.of {
            Blinker::Step(step) => (self.read(Read::Active(step), at)?, self.since(step)),
            Blinker::Macro(id) => (self.read(Read::MacroActive(id), at)?, self.macro_since(id, at)?),
        };
        self.blinks = true;
        let place = Text::order(format!("{MILLISECONDS}({since}) MOD {} < {on}", on + off));
        Ok(all(vec![active, place]))
    }

    pub(super) fn elapsed(&mut self, time: TimeRef, step: StepId, at: &At<'_>) -> Result<Text, Refused> {
        may_read_times(at)?;
        let limit = self.time(time, at.mark)?;
        let reached = Text::order(format!("{} >= {limit}", self.since(step)));
        // The timer of a step that is not active is at zero: only a time that may be zero asks for more.
        let at_zero = self.steps.as_ref().is_none_or(|steps| steps.active.contains(&step))
            && !matches!(self.moment, Moment::Moved(own) if own != Some(step))
            && self.moment != Moment::Leaving;
        if at_zero && matches!(time, TimeRef::Ticks(1..)) {
            return Ok(reached);
        }
        let active = self.read(Read::Active(step), at)?;
        Ok(all(vec![active, reached]))
    }

    /// How long a step has been active.
    pub(super) fn since(&mut self, step: StepId) -> String {
        match &self.steps {
            Some(steps) => format!("{}.T", steps.names[step.index()]),
            None if self.moment == Moment::Leaving && self.reentered.contains(&step) => {
                let timer = self.timer(step);
                if !self.reached.contains_key(&step) {
                    let name = self.names.own(&format!("{timer}_reached"));
                    self.reached.insert(step, name);
                }
                self.reached[&step].clone()
            }
            None => format!("{}.ET", self.timer(step)),
        }
    }

    pub(super) fn macro_elapsed(&mut self, time: TimeRef, id: MacroId, at: &At<'_>) -> Result<Text, Refused> {
        let since = self.macro_since(id, at)?;
        let reached = Text::order(format!("{since} >= {}", self.time(time, at.mark)?));
        if self.moment == Moment::Called && matches!(time, TimeRef::Ticks(1..)) {
            return Ok(reached);
        }
        let active = self.read(Read::MacroActive(id), at)?;
        Ok(all(vec![active, reached]))
    }

    /// How long a macro-step has been active: since the first of its steps was, whichever of them are.
    pub(super) fn macro_since(&mut self, id: MacroId, at: &At<'_>) -> Result<String, Refused> {
        let of = &self.model.macros[id];
        let left = matches!(self.moment, Moment::Begun(own) if !of.steps.contains(&own));
        if self.steps.is_some() || left {
            return Err(refuse(at, "the time of a macro-step", "ask for the time of one of its steps"));
        }
        may_read_times(at)?;
        if !self.macro_timers.contains_key(&id) {
            let name = self.names.own(&format!("T_{}", plain(&of.name)));
            self.macro_timers.insert(id, name);
        }
        Ok(format!("{}.ET", self.macro_timers[&id]))
    }
}

pub(super) fn may_read_times(at: &At<'_>) -> Result<(), Refused> {
    if at.times {
        return Ok(());
    }
    let message = "the time of a step cannot be read by what runs once in the CASE form, as the timer is another one by then: use the form of flip-flops";
    Err(Refused::at(at.mark, message))
}
