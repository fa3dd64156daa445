//! A press with operating modes.

use core::fmt::Write;

use grafcet::grafcet;

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// A press that runs by itself, step by step, or by hand, and can be paused.
    pub sfc Press {
        modes;
        input start, top, bottom: bool;
        output lower, lift, lamp: bool;

        initial step Rest { N lamp; }
        // Only clearing is paused: what must not go on meanwhile says so.
        step Lower { N lower if !paused; }
        step Hold;
        step Lift { N lift if !paused; }

        Rest -[start && top]-> Lower -[bottom]-> Hold -[1s/Hold]-> Lift -[top]-> Rest;

        never lower && lift;
    }
}

signals!(PressInputs: start, top, bottom, semi_automatic, manual, paused, push);
signals!(PressOutputs: lower, lift, lamp);

/// Plays a script on a press of its own; one plain line per cycle goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut press = Press::new();
    script::play(script, out, |inputs, now| (press.cycle(inputs, now), press.active_steps(), Notes::new()))
}
