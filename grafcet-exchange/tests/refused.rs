//! What has no translation is an error that says why; nothing else is written.

mod common;

use common::model;
use grafcet_exchange::st::{Form, Options, structured_text};

const BOTH: [Form; 2] = [Form::Case, Form::FlipFlops];
const CASE: [Form; 1] = [Form::Case];

/// The forms that refuse a chart, and why.
const CASES: [(&[Form], &str, &str); 32] = [
    (
        &BOTH,
        "sfc C { input go: bool; var last: Mode in {Off, Auto} = Mode::Off; initial step A; step B { P1 last = Other::Auto; } A -[go]-> B -[!go && last == Mode::Off]-> A; }",
        "what `last` gets is neither a variant that it lists",
    ),
    (
        &BOTH,
        "sfc C { input mode: Mode in {Off, Auto}; input last: Mode in {Auto, Off}; initial step A; step B; A -[mode == last && mode == Mode::Auto]-> B -[last == Mode::Off]-> A; }",
        "a comparison of two lists of variants",
    ),
    (
        &BOTH,
        "sfc C { input go: bool; var last: Mode in {Off, Auto}; initial step A; step B { P1 last = Mode::Auto; } A -[go]-> B -[!go && last == Mode::Auto]-> A; }",
        "what `last` is at the beginning the chart does not tell",
    ),
    (
        &BOTH,
        "sfc C { input go: bool; var last: Mode in {Off, Auto} = Mode::Off; initial step A; step B { P1 last = next(last); } A -[go]-> B -[!go && last == Mode::Auto]-> A; }",
        "what `last` gets is neither a variant that it lists",
    ),
    (
        &CASE,
        "grafcet C { input a: bool; partial Net { initial step A; step B; A -[a]-> B -[!a]-> A; } }",
        "partial grafcets",
    ),
    (
        &CASE,
        "grafcet C { input a: bool; partial Net { initial step A; enclosing step B { partial Inner { linked step I; step J; I -[a]-> J -[!a]-> I; } } A -[a]-> B -[!a]-> A; } }",
        "enclosing steps have no translation into the CASE form",
    ),
    (
        &CASE,
        "grafcet C { input a: bool; partial Up { initial step A; step B { force Down {}; } A -[a]-> B -[!a]-> A; } partial Down { initial step I; step J; I -[a]-> J -[!a]-> I; } }",
        "forcing orders have no translation into the CASE form",
    ),
    (
        &CASE,
        "grafcet C { input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; () -[rising(a)]-> A; }",
        "source and sink transitions",
    ),
    (
        &BOTH,
        "sfc C { input level: Level; initial step A; step B; A -[level > LOW]-> B -[level < LOW]-> A; }",
        "`level` is of a type of the program, which",
    ),
    (
        &BOTH,
        "sfc C { input n: usize; initial step A; step B; A -[n > 1]-> B -[n < 1]-> A; }",
        "`n` is an integer that no PLC has",
    ),
    (
        &BOTH,
        "sfc C { clock 1us; input a: bool; initial step A; step B; A -[a]-> B -[1500us/B]-> A; }",
        "`TIME` counts milliseconds",
    ),
    (
        &CASE,
        "grafcet C { input a: bool; output q: bool; var v: bool; initial step A { v; } step B { q if v; } A -[a && v]-> B -[!a]-> A; }",
        "`v` follows the situation",
    ),
    (
        &CASE,
        "grafcet C { input a, b: bool; action run(); initial step A { N run() if b; } step B { N run(); } A -[a]-> B -[!a]-> A; }",
        "`run`",
    ),
    (
        &CASE,
        "sfc C { input a: bool; var n: u8 = 0; initial step A; step B { L 2s n = (n + 1) % 9; } A -[a && n < 9]-> B -[!a]-> A; }",
        "`L` of what runs has a time or a pulse of its own",
    ),
    (
        &CASE,
        "sfc C { input a: bool; action run(); initial step A { R run(); } step B { S run(); } A -[a]-> B -[!a]-> A; }",
        "`run` is called by two kinds of associations",
    ),
    (
        &BOTH,
        "sfc C { input n: i8; initial step A; step B; A -[n >> 1 == 1]-> B -[n == 0]-> A; }",
        "`>>` of an integer with a sign",
    ),
    (
        &BOTH,
        "sfc C { input n: u8; initial step A; step B; A -[n == 1 && f(n) & 3 == g(n)]-> B -[n == 0]-> A; }",
        "an operator on the bits of what is no integer of a known type",
    ),
    (
        &BOTH,
        "sfc C { clock 1us; input a: bool; output q: bool; initial step A; step B { q if blink(1500us); } A -[a]-> B -[!a]-> A; }",
        "`TIME` counts milliseconds",
    ),
    (
        &CASE,
        "sfc C { input a: bool; var n: u8 = 0; initial step A; step B { P1 n = (n + 1) % 9; } A -[a]-> B -[falling(n > 3) || !a]-> A; }",
        "an edge of what the chart itself changes has no translation into the CASE form",
    ),
    (
        &CASE,
        "sfc C { input a: bool; var n: u8 = 0; initial step A; step B { P1 n = (n + 1) % 9; } A -[a]-> B -[2s/(n > 3) || !a]-> A; }",
        "the delay of what the chart itself changes has no translation into the CASE form",
    ),
    (
        &CASE,
        "grafcet C { input a: bool; var n: u8 = 0; initial step A; step B { P1 n = 1 if falling(A.X); } A -[a && n == 0]-> B -[!a]-> A; }",
        "an edge of what the chart itself changes has no translation into the CASE form",
    ),
    (
        &CASE,
        "sfc C { input a: bool; output last: time; initial step A; step B { P0 last = B.T; P1 last = B.T; } A -[a]-> B -[!a]-> A; }",
        "the time of a step cannot be read by what runs once in the CASE form",
    ),
    (
        &BOTH,
        "sfc C { input a: bool; var n: u8 = 0; initial step A; step B { P1 { for i in 0..3 { n += i; } } } A -[a && n < 9]-> B -[!a]-> A; }",
        "this Rust has no translation",
    ),
    (
        &CASE,
        "sfc C { input a: bool; initial step A; step B; step E; A -[a]-> (B, E); (B, E) -[!a]-> A; }",
        "`B` and `E` can be active together: use the form of flip-flops",
    ),
    (
        &CASE,
        "sfc C { input a: bool; output q: bool; initial step A { R q; } step B { SD 2s q; } A -[a]-> B -[!a]-> A; }",
        "what `SD` does outlives its step",
    ),
    (
        &CASE,
        "sfc C { input a: bool; output q: bool; initial step A { L 2s q; } step B { L 2s q; } A -[a]-> B -[!a]-> A; }",
        "share the time of `L`",
    ),
    (
        &CASE,
        "sfc C { input a: bool; output q, p: bool; initial step A { N q; } step B { N p if q; } A -[a]-> B -[!a]-> A; }",
        "it reads `q`, which the CASE form switches off",
    ),
    (
        &CASE,
        "grafcet C { input a: bool; output q: bool; var n, m: u8 = 0; initial step A { P0 n = 1; } step B { P1 m = n; q if m > 0; } A -[a]-> B -[!a]-> A; }",
        "it reads `n` as it was before another action of the same moment",
    ),
    (
        &CASE,
        "grafcet C { input a, b: bool; var n: u8 = 0; initial step A { on rising(b) n = 1; } step B; A -[a && n > 0]-> B -[!a]-> A; }",
        "it reads `n` as it was before the action on an event",
    ),
    (
        &CASE,
        "sfc C { input a: bool; output speed: u8; var n: u8 = 0; initial step A; step B { N n = 3; speed = n; } A -[a]-> B -[!a]-> A; }",
        "it shows `n` while that changes in each scan",
    ),
    (
        &BOTH,
        "sfc C { input n: u8; initial step A; step B; A -[n != 0 && 10 / n > 2]-> B -[n == 0]-> A; }",
        "a division by what may be zero",
    ),
    (
        &CASE,
        "sfc C { input a: bool; action run(); initial step A; step B { N run(); } A -[a]-> B -[!a]-> A; B -[a]-> B; }",
        "`run` goes on where its step is entered anew",
    ),
];

/// One that the compiler accepts.
#[test]
fn what_has_no_translation() {
    for (forms, chart, why) in CASES {
        let model = model(chart);
        for form in [Form::Case, Form::FlipFlops] {
            let done = structured_text(&model, &Options { form, ..Options::default() });
            match done {
                Err(refused) if forms.contains(&form) => {
                    assert!(refused.iter().any(|one| one.message.contains(why)), "{chart}: {refused:?}");
                }
                // The other form can say it.
                Ok(_) if !forms.contains(&form) => {}
                other => panic!("{chart}: {form:?}: {other:?}, expected {why}"),
            }
        }
    }
}
