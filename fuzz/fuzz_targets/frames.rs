//! `grafcet_record::fuzz::frames` with any bytes: `cargo xtask fuzz frames`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| grafcet_record::fuzz::frames(bytes));
