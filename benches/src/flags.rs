//! A chart as programs of flip-flops are: one bit for each step.

include!(concat!(env!("OUT_DIR"), "/flags.rs"));
