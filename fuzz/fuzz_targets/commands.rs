//! `grafcet_record::fuzz::commands` with any bytes: `cargo xtask fuzz commands`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| grafcet_record::fuzz::commands(bytes));
