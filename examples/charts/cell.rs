//! A machining cell: the means of structure of IEC 60848 in one chart.

use core::fmt::Write;

use grafcet::grafcet;

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// A cell that clamps a part, and drills and stamps it at the same time.
    pub grafcet Cell {
        input estop, ack, auto, part, clamped, drilled, stamped: bool;
        output conveyor, clamp, drill, stamp, alarm: bool;
        /// Made since power-up.
        output parts: u16 = 0;

        /// Stands above all others: what it forces, they have to follow.
        partial Safety {
            initial step Ready;
            step Stopped { force Modes {}; alarm; }
            step Restart { force Modes {INIT}; }

            Ready -[estop]-> Stopped -[!estop && rising(ack)]-> Restart -[true]-> Ready;
        }

        // Proved when the chart is compiled.
        always drill || stamp => clamp && !conveyor;
        never alarm && (conveyor || drill || stamp);
        home (Ready, Manual);

        partial Modes {
            // Stored: an emergency stop leaves the clamp closed, and only here it is opened.
            initial step Manual { R clamp; }
            // Production lives in automatic mode only: it begins with the mode, and is gone with it.
            enclosing step Auto {
                partial Production {
                    linked step Feed { conveyor; }
                    macro step Clamp {
                        entry step Close { S clamp; }
                        exit step Closed;
                        Close -[clamped]-> Closed;
                    }
                    step Drill { drill; }
                    step Drilled;
                    step Stamp { stamp; }
                    step Stamped;
                    step Release { R clamp; P1 parts = parts + 1; }
                    step Deliver { conveyor; }

                    Feed -[part]-> Clamp -[true]-> (Drill, Stamp);
                    Drill -[drilled]-> Drilled;
                    Stamp -[stamped]-> Stamped;
                    (Drilled, Stamped) -[true]-> Release -[!clamped]-> Deliver -[!part]-> Feed;
                }
            }

            // After an emergency stop the mode has to be chosen anew; a part that has been begun is finished first.
            Manual -[rising(auto)]-> Auto -[!auto && Production::Feed.X && !part]-> Manual;
        }
    }
}

signals!(CellInputs: estop, ack, auto, part, clamped, drilled, stamped);
signals!(CellOutputs: conveyor, clamp, drill, stamp, alarm, parts);

/// Plays a script on a cell of its own; one plain line per cycle goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut cell = Cell::new();
    script::play(script, out, |inputs, _| (cell.cycle(inputs), cell.active_steps(), Notes::new()))
}
