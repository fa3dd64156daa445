//! The 24 V production line of the source document on GRAFCET.

use core::fmt::Write;

use grafcet::grafcet;

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// The 24 V production line.
    pub grafcet Line24V {
        input b1, b2, b3, b4, b5: bool;
        output q1, q2, q3: bool;

        initial step S1 { q1; }          // continuous action
        step S2 { S q2; }                // stored action: set
        step S3 { q3 if b5; }            // continuous action with an assignation condition
        step S4 { R q2; }                // stored action: reset

        S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1;
    }
}

signals!(Line24VInputs: b1, b2, b3, b4, b5);
signals!(Line24VOutputs: q1, q2, q3);

/// Plays a script on a line of its own; one plain line per cycle goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut line = Line24V::new();
    script::play(script, out, |inputs, _| (line.cycle(inputs), line.active_steps(), Notes::new()))
}
