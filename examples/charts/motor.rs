//! The motor of the source document on sequential function charts.

use core::fmt::Write;

use grafcet::grafcet;

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// A motor that can be switched on and off, guarded against over-temperature.
    pub sfc Motor {
        input on, off, over_temp: bool;
        output relay, green, red: bool;

        initial step Off { N red; }
        step On { N relay; N green; }

        Off -[on && !over_temp]-> On -[off || over_temp]-> Off;
    }
}

signals!(MotorInputs: on, off, over_temp);
signals!(MotorOutputs: relay, green, red);

/// Plays a script on a motor of its own; one plain line per cycle goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut motor = Motor::new();
    script::play(script, out, |inputs, _| (motor.cycle(inputs), motor.active_steps(), Notes::new()))
}
