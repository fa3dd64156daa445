//! Step chains written inline in Rust: GRAFCET (IEC 60848) and SFC (IEC 61131-3).
#![no_std]

pub use grafcet_core::{Chart, Phase, Ticks, heapless};

/// Turns a chart into a state enum and a cycle function.
#[macro_export]
macro_rules! grafcet {
    ($($chart:tt)*) => { $crate::__private::chart! { [$crate] $($chart)* } };
}

/// What generated code names. Not for anybody else: it may change with every version.
#[doc(hidden)]
pub mod __private {
    pub extern crate core;
    pub use core::primitive::{bool, str, u8, u32};

    pub use grafcet_core::{Chart, Phase, Ticks, heapless};
    pub use grafcet_macros::chart;
}
