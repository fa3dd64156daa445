//! `grafcet_record::fuzz::restored` with any bytes: `cargo xtask fuzz snapshot`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| grafcet_record::fuzz::restored(bytes));
