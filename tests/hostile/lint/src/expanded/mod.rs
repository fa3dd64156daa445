//! The golden expansions as source: here rustc's lints look at all of it.
#![allow(dead_code, unused_assignments, unused_variables, reason = "what a chart does not need is for the optimiser")]
#![allow(clippy::complexity, clippy::pedantic, clippy::style, reason = "a matter of taste in code that people write")]

/// The expansion `batch`.
#[rustfmt::skip]
#[path = "../../../../golden/batch.rs"]
pub mod batch;
/// The expansion `cell`.
#[rustfmt::skip]
#[path = "../../../../golden/cell.rs"]
pub mod cell;
/// The expansion `line24v`.
#[rustfmt::skip]
#[path = "../../../../golden/line24v.rs"]
pub mod line24v;
/// The expansion `motor`.
#[rustfmt::skip]
#[path = "../../../../golden/motor.rs"]
pub mod motor;
/// The expansion `stations`.
#[rustfmt::skip]
#[path = "../../../../golden/stations.rs"]
pub mod stations;
