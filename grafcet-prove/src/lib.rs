//! Proofs and counterexamples for what charts of `grafcet!` claim.
#![allow(missing_docs, reason = "a name says what it holds; a doc is where that is not enough")]

pub mod aig;
mod bits;
mod bmc;
pub mod certificate;
pub mod circuit;
pub mod export;
mod pdr;
pub mod play;
pub mod replay;
mod sat;
pub mod task;
mod verdict;
pub mod words;

pub use sat::{Limit, Over};
pub use verdict::{Internal, Verdict, decide};
