//! `param n: u8 in 1..=8 = 2;`: what a param may be, for every rule and property.

mod judged;

use judged::said;

/// A chart that reads what is declared.
fn chart(declaration: &str, items: &str) -> String {
    format!(
        "sfc C {{ #![allow(grafcet::unused_param, grafcet::unused_input, grafcet::undriven_output)] {declaration} input go: bool; input level: u8; output q: bool; \
         initial step A; step B; A -[go]-> B -[!go]-> A; {items} }}"
    )
}

fn fine(declaration: &str, items: &str) {
    let chart = chart(declaration, items);
    assert_eq!(said(&chart), Vec::<String>::new(), "{chart}");
}

fn refused(declaration: &str, items: &str, words: &str) {
    let chart = chart(declaration, items);
    let said = said(&chart);
    assert!(said.iter().all(|one| one.contains(words)) && !said.is_empty(), "{chart}: {said:#?}");
}

#[test]
fn ranges_are_written_as_in_rust() {
    for declaration in [
        "param n: u8 in 1..=8 = 8;",
        "param n: u8 in 1..8 = 7;",
        "param n: u8 in 0..=255;",
        "param n: i16 in -5..=-1 = -5;",
        "param n: i16 in -0x10..1_000;",
        "param n, m: usize in 1..4 = 3;",
        "param n: u8 in 1..=8 = 2 * 4;",
        "param n: u8 in 1..=8 = MOST;",
        "param t: time in 1s..10s = 9999ms;",
        "param t: time in 1s..=10s = 10s;",
        "param t: time in 0s..1h30m;",
    ] {
        fine(declaration, "");
    }
}

#[test]
fn what_is_no_range_is_refused() {
    for (declaration, words) in [
        ("param n: u8 in 1..=8 = 9;", "`9` is not in `1..=8`, the range of `n`"),
        ("param n: u8 in 1..8 = 8;", "`8` is not in `1..8`"),
        ("param n: i8 in 1..8 = -1;", "`-1` is not in `1..8`"),
        ("param t: time in 1s..10s = 10s;", "`10s` is not in `1s..10s`"),
        (
            "param n: u8 in 1..=8;",
            "`n` is 0 where nothing else is said, which is not in `1..=8`; state what it is: `= 1;`",
        ),
        ("param n: u8 in 8..8;", "there is nothing in `8..8`"),
        ("param n: u8 in 8..=7;", "there is nothing in `8..=7`"),
        ("param n: u8 in 0..=256;", "`256` is no `u8`"),
        ("param n: u8 in -1..=2;", "`-1` is no `u8`"),
        ("param n: u128 in 0..=2;", "at most 64 bits"),
        ("param n: bool in 0..=1;", "only an integer"),
        ("param n: f32 in 0..=1;", "only an integer"),
        ("param n: f32 in 0.0..=1.0;", "neither"),
        ("param n: u8 in 1s..2s;", "`1s` is a time"),
        ("param t: time in 1..2s;", "`1` has no unit of time"),
        ("param t: time in -1s..2s;", "bad_time"),
        ("param t: time in 1s..2d;", "bad_time"),
        ("param n: u8 in 1...8;", "expected a number"),
        ("param n: u8 in 1..;", "expected a number"),
        ("param n: u8 in ..8;", "expected a number"),
        ("param n: u8 in 1 - 8;", "expected `..`"),
        ("param n: u8 in LOW..8;", "or the range of a param"),
        ("input n: u8 in 1..10;", "`assume never level > 8;`"),
        ("var n: u8 in 1..10;", "`always n <= 8;`"),
        ("output n: u8 in 1..10;", "`always n <= 8;`"),
    ] {
        refused(declaration, "", words);
    }
}

#[test]
fn proofs_rely_on_them() {
    let n = "param n: u8 in 1..=8 = 2;";
    fine(n, "never n == 0; always n < 9; never level > 9 && level < n;");
    refused(n, "never n == 1;", "property_violated");
    refused(n, "never n == 8;", "property_violated");
    refused("param n: u8 in 1..8 = 2;", "never n == 7;", "property_violated");
    fine("param n: u8 in 1..8 = 2;", "never n == 8;");
    let t = "param t: time in 1s..10s = 2s;";
    fine(t, "never t < 1s; never t >= 10s;");
    refused(t, "never t == 1s;", "property_violated");
    refused(t, "never t == 9999ms;", "property_violated");
    // Rules, too.
    refused(n, "B -[n == 9]-> A;", "never_true");
    fine(n, "A -[n == 8 && !go]-> B;");
}

#[test]
fn assumptions_are_over_params_too() {
    let two = "param low: u8 in 1..=8 = 2; param high: u8 in 4..=9 = 9;";
    refused(two, "never low > high;", "property_violated");
    fine(two, "assume never low > high; never low > high;");
    refused(two, "assume never low > 0;", "exclude every input");
    refused(two, "assume often low > 3;", "`low` is a param");
}
