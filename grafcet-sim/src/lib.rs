#![doc = include_str!("../README.md")]
#![allow(missing_docs, reason = "a field says what it holds by its name; a doc is where that is not enough")]

mod blocked;
mod chart;
mod coverage;
mod cycle;
pub mod interp;
mod names;
mod program;
mod simulation;
mod trace;
mod value;

pub use blocked::{Blocked, Part, Wait, Waiting, Why};
pub use chart::{Chart, Refused};
pub use coverage::{Coverage, Missing};
pub use cycle::{Call, Cycle, Evolution, Forced, Gap, Phase, Ran};
pub use names::{Kind, Names, Signal, Step, Transition};
pub use program::{Asked, Program};
pub use simulation::{Error, Simulation};
pub use trace::{Difference, Trace};
pub use value::Value;
