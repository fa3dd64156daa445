//! Proofs and counterexamples for what charts of `grafcet!` claim.
#![allow(missing_docs, reason = "a name says what it holds; a doc is where that is not enough")]

pub mod aig;
mod around;
mod bits;
mod bmc;
pub mod certificate;
pub mod checker;
pub mod circuit;
mod clocks;
mod differences;
mod exclusions;
pub mod export;
mod goal;
mod home;
pub mod lemmas;
mod limit;
mod live;
mod pdr;
pub mod play;
mod probe;
mod questions;
pub mod replay;
mod ruling;
mod sat;
mod simplest;
mod steps;
mod table;
pub mod task;
mod verdict;
pub mod ways;
pub mod words;

pub use home::decide_home;
pub use limit::{At, Limit, Over};
pub use live::decide_live;
pub use questions::is_so;
pub use ruling::rule;
pub use table::table;
pub use verdict::{Internal, Proof, Verdict, by_evolutions, decide, never, says_nothing, vacuous};
