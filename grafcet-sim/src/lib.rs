#![doc = include_str!("../README.md")]
#![allow(missing_docs, reason = "a field says what it holds by its name; a doc is where that is not enough")]

mod beside;
mod blocked;
mod calls;
mod chart;
mod coverage;
mod cycle;
pub mod interp;
#[cfg(feature = "json")]
pub mod json;
mod names;
mod outside;
mod program;
mod regression;
mod replay;
mod script;
mod show;
mod simulation;
mod trace;
mod value;

pub use beside::Beside;
pub use blocked::{Blocked, HeldBack, Part, Wait, Waiting, Why};
pub use calls::{calls, chart_name};
pub use chart::{Chart, Refused};
pub use coverage::{Coverage, Criterion, Missing};
pub use cycle::{Call, Cycle, Evolution, Forced, Gap, Phase, Ran};
pub use names::{Kind, Names, Signal, Step, Transition};
pub use program::{Asked, Program};
pub use regression::{Changed, test_of_record};
pub use replay::{Layout, Live, Replay, ReplayError};
pub use script::{BadLine, Scripted, script, script_line, script_of, script_words};
pub use show::{chronogram, happened, page, table, vcd};
pub use simulation::{Error, Simulation};
pub use trace::{Difference, Trace};
pub use value::Value;

/// The page for users, whose blocks are tests.
#[cfg(doctest)]
#[doc = include_str!("../../docs/replay.md")]
mod page_for_users {}
