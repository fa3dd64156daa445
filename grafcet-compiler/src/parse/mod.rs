//! Tokens to syntax: one file a production of the language.
//!
//! The structure of a chart is read with a cursor that can look ahead as far as it likes; the Rust inside it (types, expressions, blocks) is cut out and handed to `syn` piece by piece, so that a mistake in one
//! piece is the mistake of that piece alone. Every body goes on after a broken item.

mod association;
mod attrs;
mod body;
mod buffer;
mod chain;
mod condition;
mod decl;
mod error;
mod force;
mod foreign;
mod fragments;
mod guard;
mod header;
mod input;
mod leaving;
mod named;
mod partial;
mod property;
mod range;
mod recover;
mod refused;
mod rust;
mod setting;
mod step;
mod target;
mod time;
mod transition;
mod types;
mod unbound;
mod variants;
mod words;

use proc_macro2::{Span, TokenStream};

use self::buffer::Buffer;
use self::error::{Error, Result};
use self::input::Input;
use crate::ast::Chart;
use crate::diagnostic::Sink;
use crate::plant;

pub(crate) use association::is_qualifier;
pub(crate) use time::mentions_time;
pub use time::time_literal;

/// Parses the tokens of one macro call.
///
/// Of a call with plants it is the chart alone, without what it claims together with them.
///
/// All mistakes go to `sink`. `None` is for a call whose header could not be read; otherwise broken items are absent,
/// their names stand in [`Body::broken`](crate::ast::Body::broken), and the chart is marked as incomplete.
pub fn chart(tokens: TokenStream, sink: &mut Sink) -> Option<Chart> {
    if tokens.is_empty() {
        sink.notation(
            Span::call_site(),
            "this call holds no chart; write for example `grafcet! { pub sfc Motor { initial step Off; } }`",
        );
        return None;
    }
    let (tokens, plants) = match plant::Call::of(&tokens) {
        Some(call) => (call.chart_and_rest(), call.names()),
        None => (tokens, Vec::new()),
    };
    match Buffer::new(tokens) {
        Ok(buffer) => {
            let mut chart = header::chart(Input::new(&buffer), sink)?;
            if !plants.is_empty() {
                plant::leave_out(&mut chart, plants);
            }
            Some(chart)
        }
        Err(error) => {
            error.report(sink);
            None
        }
    }
}
