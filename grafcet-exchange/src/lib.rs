#![doc = include_str!("../README.md")]

mod refused;
pub mod st;

pub use refused::Refused;
