//! A mistake of notation on its way to the sink.

use crate::diagnostic::{Mark, Sink};
use crate::list::List;

pub(super) type Result<T> = std::result::Result<T, Error>;

/// Why a piece could not be parsed: one message or several, each at its tokens.
#[derive(Debug)]
pub(super) struct Error(Vec<(Mark, String)>);

impl Error {
    pub(super) fn new(mark: impl Into<Mark>, message: impl Into<String>) -> Self {
        Self(vec![(mark.into(), message.into())])
    }

    /// Several mistakes of one piece; `None` where there is none.
    pub(super) fn several(notes: Vec<(Mark, String)>) -> Option<Self> {
        (!notes.is_empty()).then_some(Self(notes))
    }

    /// What went wrong is reported already.
    pub(super) fn reported() -> Self {
        Self(Vec::new())
    }

    pub(super) fn report(self, sink: &mut Sink) {
        for (mark, message) in self.0 {
            sink.notation(mark, message);
        }
    }
}

impl From<syn::Error> for Error {
    fn from(error: syn::Error) -> Self {
        Self(error.into_iter().map(|part| (part.span().into(), part.to_string())).list())
    }
}
