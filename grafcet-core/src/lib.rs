//! The runtime of [`grafcet`](https://docs.rs/grafcet) on the controller: `no_std`, no heap, no `unsafe`.
//!
//! Use it through the crate `grafcet`, which re-exports everything a program names.
#![no_std]

mod chart;
pub mod description;
#[doc(hidden)]
pub mod fence;
#[doc(hidden)]
pub mod flags;
#[cfg(any(feature = "fugit", feature = "embassy-time"))]
mod instants;
mod phase;
mod possible;
mod range;
#[cfg(feature = "record")]
pub mod record;
#[doc(hidden)]
pub mod situation;
mod ticks;
mod time;
#[doc(hidden)]
pub mod values;

pub use chart::Chart;
pub use description::ActiveSteps;
pub use phase::Phase;
#[doc(hidden)]
pub use possible::Possible;
pub use possible::{ForceError, Forceable};
pub use range::OutOfRange;
pub use ticks::Ticks;
// What generated code computes with times; a program has `next_deadline`.
#[doc(hidden)]
pub use time::{earlier, phase, rest, sooner};
