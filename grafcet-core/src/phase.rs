//! Which call of a code action this is.

/// What a code action is told about the call it gets.
///
/// The three marks of a step's time line in the classic drawing of an action: the first time, the times in between
/// and the last time ("1. Mal", "x. Mal", "letztes Mal"). The last one is the final scan of IEC 61131-3: the place to
/// switch off what the first call switched on.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Phase {
    /// The action has just become active, or it is a single call (`P1`, `P0`, an event).
    First,
    /// The action goes on.
    Repeated,
    /// The action has just ended.
    Final,
}
