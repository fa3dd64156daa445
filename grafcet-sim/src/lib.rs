//! Charts of `grafcet!` run on the host, from their source alone.
//!
//! [`interp`] executes the compiler's model of a chart, cycle by cycle. It is written from the page of decisions and shares nothing with
//! the code that the macro generates.

pub mod interp;
