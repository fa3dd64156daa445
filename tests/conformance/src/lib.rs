//! Conformance: what generated code does, cycle by cycle, beside what was worked out by hand and what the interpreter
//! says.
//!
//! - the corpus: the `.chart` files of this folder, run by `cargo test`
//! - [`random`]: well-formed charts made from a number, run by `cargo xtask conformance`
//! - [`recorded`]: some of these in a recorder, and with a loss of power now and then
//! - [`program`]: the naive programs of both beside the interpreter, without rustc; [`programs`]: of random charts
//! - [`circuit`]: the circuits made of these, beside them
//! - [`prove`]: the verdicts of the prover beside a naive exploration; [`with_plants`]: of charts with plants
#![allow(clippy::format_collect, reason = "texts of a few lines; clearer than a loop that writes")]

pub mod asleep;
pub mod batch;
pub mod board;
pub mod brute;
pub mod chart;
pub mod circuit;
pub mod emit;
pub mod fragments;
pub mod generated;
pub mod oracle;
pub mod play;
pub mod program;
pub mod programs;
pub mod prove;
pub mod random;
#[path = "../reader.rs"]
pub mod reader;
pub mod recorded;
pub mod simpler;
mod subject;
pub mod with_plants;

pub use subject::{Entry, Rest, Shown, Subject, Values};
