#![doc = include_str!("../README.md")]

pub mod import;
pub mod plcopen;
pub mod pnml;
mod refused;
pub mod sfc;
pub mod st;

pub use refused::Refused;
