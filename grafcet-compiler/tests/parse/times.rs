//! Durations.

use grafcet_compiler::parse::time_literal;

fn time(text: &str) -> Option<Result<u64, String>> {
    let lit = syn::parse_str::<syn::Lit>(text).expect("a literal");
    time_literal(&lit).map(|time| time.map(|time| time.nanos))
}

#[test]
fn units_and_their_combinations() {
    for (text, nanos) in [
        ("5s", 5_000_000_000),
        ("0s", 0),
        ("500ms", 500_000_000),
        ("1.5s", 1_500_000_000),
        ("1.500s", 1_500_000_000),
        ("0.000001ms", 1),
        ("1h30m", 5_400_000_000_000),
        ("1h1m1s1ms1us", 3_661_001_001_000),
        ("250us", 250_000),
        ("10_000ms", 10_000_000_000),
        ("2m", 120_000_000_000),
        ("0.25h", 900_000_000_000),
    ] {
        assert_eq!(time(text), Some(Ok(nanos)), "{text}");
    }
}

#[test]
fn ordinary_numbers_are_no_times() {
    for text in ["5", "5u8", "5i64", "1.5", "1.5f32", "1e3", "\"5s\"", "'s'", "true", "0x5", "5usize"] {
        assert_eq!(time(text), None, "{text}");
    }
}

#[test]
fn mistakes_are_explained() {
    for (text, message) in [
        ("5min", "`min` is no unit"),
        ("5ns", "`ns` is no unit"),
        ("5S", "`S` is no unit"),
        ("0x5s", "`x` is no unit"),
        ("1h30", "its end has no unit"),
        ("30m1h", "write the larger unit first"),
        ("1s1s", "write the larger unit first"),
        ("0.0001us", "too fine"),
        ("9999999999h", "too long"),
        ("5000000h5000000m5000000000000s", "too long"),
        ("99999999999999999999s", "too long"),
    ] {
        let error = time(text).expect("meant as a time").expect_err(text);
        assert!(error.contains(message), "{text}: {error}");
    }
}
