//! What comes one by one, put together: what `collect` does, as loops.
//!
//! Whoever uses the macro builds it without optimisation, and there each `collect` into a vector is a dozen functions of its own, one
//! into tokens thirty.

use proc_macro2::TokenStream;

/// Puts together what an iterator yields.
pub(crate) trait List: Iterator + Sized {
    /// All of it, as a vector.
    fn list(self) -> Vec<Self::Item> {
        let mut all = Vec::new();
        for item in self {
            all.push(item);
        }
        all
    }

    /// All tokens, one after the other.
    fn tokens(self) -> TokenStream
    where
        Self: Iterator<Item = TokenStream>,
    {
        let mut all = TokenStream::new();
        for tokens in self {
            all.extend(tokens);
        }
        all
    }
}

impl<I: Iterator> List for I {}
