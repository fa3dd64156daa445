//! Charts in unusual places, with unusual names and types.
#![forbid(unsafe_code)]
#![deny(warnings, clippy::all, clippy::pedantic, missing_docs, unreachable_pub)]

pub mod fragments;
pub mod hygiene;
pub mod in_the_way;
pub mod outside;
pub mod passed_on;
pub mod places;
pub mod types;
pub mod written;
