//! The golden expansions as source: here no lint of the compiler is silent.
#![allow(
    clippy::blocks_in_conditions,
    clippy::match_wildcard_for_single_variants,
    reason = "a matter of taste in code that people write"
)]

/// The motor.
#[path = "../../../../golden/motor.rs"]
pub mod motor;
