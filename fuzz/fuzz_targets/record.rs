//! `grafcet_record::fuzz::record` with any bytes: `cargo xtask fuzz record`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| grafcet_record::fuzz::record(bytes));
