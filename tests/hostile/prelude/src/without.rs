//! There is no prelude beside the charts.
#![no_implicit_prelude]

::core::include!("charts.rs");
