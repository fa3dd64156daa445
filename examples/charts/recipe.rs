//! A dyeing machine that is told by a recipe what to do in which step: the "Rezeptsteuerung" of the source document on
//! sequential function charts.

use core::fmt::Write;
use core::time::Duration;

use grafcet::{Phase, grafcet};

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// A dyeing machine. The chart is the same for every fabric; the recipe makes the difference.
    pub sfc Dyer {
        input start, full, empty: bool;
        /// Of the bath, in °C.
        input temperature: i16;
        output inlet, outlet, ready: bool;

        /// Temperature of the washing bath, in °C.
        param wash_at: i16 = 40;
        /// How long to wash.
        param wash: time = 4s;
        /// Speed of the drum while it washes, in 1/min.
        param wash_rpm: u16 = 45;
        /// Temperature of the dyeing bath, in °C.
        param dye_at: i16 = 60;
        /// How long to dye.
        param dye: time = 6s;
        /// Speed of the drum while it dyes, in 1/min.
        param dye_rpm: u16 = 55;

        /// Keeps the bath at a temperature, in °C.
        action heat(setpoint: i16);
        /// Turns the drum, so many times a minute.
        action drum(rpm: u16);

        initial step Idle { N ready; }
        step Fill { N inlet; }
        step Wash { N heat(wash_at); N drum(wash_rpm); }
        step Dye { N heat(dye_at); N drum(dye_rpm); }
        step Drain { N outlet; N drum(wash_rpm); }

        Idle -[rising(start)]-> Fill -[full]-> Wash
             -[temperature >= wash_at && wash/Wash]-> Dye
             -[temperature >= dye_at && dye/Dye]-> Drain -[empty]-> Idle;
    }
}

/// The recipe that stands in the chart.
pub const COTTON: DyerParams = DyerParams::new();

/// A gentler one.
pub const WOOL: DyerParams = DyerParams {
    wash_at: 30,
    wash: Dyer::ticks(Duration::from_secs(3)),
    wash_rpm: 20,
    dye_at: 50,
    dye: Dyer::ticks(Duration::from_secs(5)),
    dye_rpm: 25,
};

/// What a line of the script tells: the inputs of the chart, and on which fabric the operator's switch stands. The chart
/// knows nothing of that switch.
#[derive(Default)]
pub struct Panel {
    inputs: DyerInputs,
    wool: bool,
}

signals!(DyerInputs: start, full, empty, temperature);
signals!(DyerOutputs: inlet, outlet, ready);
signals!(Panel: start in inputs, full in inputs, empty in inputs, temperature in inputs, wool);

impl DyerActions for Notes {
    fn heat(&mut self, phase: Phase, setpoint: i16) {
        self.call("heat", phase, setpoint);
    }

    fn drum(&mut self, phase: Phase, rpm: u16) {
        self.call("drum", phase, rpm);
    }
}

/// Plays a script on a dyeing machine of its own; one plain line per cycle goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut dyer = Dyer::new();
    script::play(script, out, |panel: &Panel, now| {
        let mut notes = Notes::new();
        dyer.set_params(if panel.wool { WOOL } else { COTTON });
        (dyer.cycle(&panel.inputs, now, &mut notes), dyer.active_steps(), notes)
    })
}
