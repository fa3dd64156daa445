//! What has no translation.

use std::fmt;

use grafcet_compiler::diagnostic::Mark;

/// Why a chart, or a part of it, has no translation.
#[derive(Clone, Debug)]
pub struct Refused {
    /// Where it stands in the source; none where it is the chart as a whole.
    pub mark: Option<Mark>,
    /// What, why, and what can be done.
    pub message: String,
}

impl Refused {
    pub(crate) fn at(mark: Mark, message: impl Into<String>) -> Self {
        Self { mark: Some(mark), message: message.into() }
    }

    pub(crate) fn whole(message: impl Into<String>) -> Self {
        Self { mark: None, message: message.into() }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Refused {}
