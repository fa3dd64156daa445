//! Charts in a library without the standard library, without an allocator and without `unsafe`.
#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings)]

mod full;
mod seeds;

pub use full::*;
pub use seeds::*;
