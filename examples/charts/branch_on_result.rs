//! A step that computes a result, and a branch on that result directly after it: the figure "berechne Z" of the source
//! document on sequential function charts.
//!
//! With actions on transitions only, the chart would need a step of its own between the measurement and the branch, to
//! have a place in which the result is known.

use core::fmt::Write;

use grafcet::grafcet;

use super::script::{self, Notes, PlayError, signals};

grafcet! {
    /// Sorts pieces by their length.
    pub sfc Sorter {
        /// There is one below the gauge.
        input piece: bool;
        /// What the gauge reads, in 1/10 mm.
        input length: u16;
        output feed, keep, reject: bool;
        /// Whether the piece is as long as it should be: the source document's Z.
        var z: bool = false;
        /// In 1/10 mm.
        param nominal: u16 = 500;
        /// In 1/10 mm, to both sides.
        param tolerance: u16 = 3;

        initial step Feed { N feed; }
        step Measure { P1 z = length.abs_diff(nominal) <= tolerance; }
        step Keep { N keep; }
        step Reject { N reject; }

        Feed -[piece]-> Measure;
        Measure -[z]-> Keep -[!piece]-> Feed;
        Measure -[!z]-> Reject -[!piece]-> Feed;
    }
}

signals!(SorterInputs: piece, length);
signals!(SorterOutputs: feed, keep, reject);

/// Plays a script on a sorter of its own; one plain line per cycle goes to `out`.
///
/// # Errors
/// As [`script::play`].
pub fn play<'s>(script: &'s str, out: &mut dyn Write) -> Result<(), PlayError<'s>> {
    let mut sorter = Sorter::new();
    script::play(script, out, |inputs, _| (sorter.cycle(inputs), sorter.active_steps(), Notes::new()))
}
