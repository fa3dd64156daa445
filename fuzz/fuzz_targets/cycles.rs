//! `grafcet_record::fuzz::cycles` with any bytes: `cargo xtask fuzz cycles`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| grafcet_record::fuzz::cycles(bytes));
