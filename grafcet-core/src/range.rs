//! What a recipe may not be.

use core::fmt;

/// A param of a recipe is not in the range that the chart states (`param soak: time in 1s..10s = 5s;`).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutOfRange {
    /// Which one; of several, the first in the chart.
    pub param: &'static str,
    /// The range as it stands in the chart.
    pub range: &'static str,
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is not in `{}`", self.param, self.range)
    }
}

impl core::error::Error for OutOfRange {}
