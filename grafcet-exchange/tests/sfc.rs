//! SFC of IEC 61131-3 in its textual form: what is written is worked out by hand, what is not has its reason.

mod common;

use common::model;
use grafcet_exchange::sfc::textual;

/// The program without its header, its lines without what is said after them.
fn program(chart: &str) -> Vec<String> {
    let done = textual(&model(chart)).expect("a translation");
    let lines = done.text.lines().map(|line| line.split("(*").next().unwrap_or_default().trim());
    lines.filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

fn expect(chart: &str, expected: &str) {
    let expected: Vec<&str> = expected.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    assert_eq!(program(chart), expected);
}

/// `On` is a keyword of the standard (`RESOURCE … ON …`).
#[test]
fn a_step_that_has_the_name_of_an_input_gets_another() {
    let chart = "sfc Motor { input go, off: bool; output relay: bool; initial step Off; step On { relay; } Off -[go && !off]-> On -[off]-> Off; }";
    expect(
        chart,
        "PROGRAM Motor
        VAR_INPUT
        go : BOOL;
        off : BOOL;
        END_VAR
        VAR_OUTPUT
        relay : BOOL := FALSE;
        END_VAR
        INITIAL_STEP OffStep:
        END_STEP
        TRANSITION FROM OffStep TO OnStep
        := go AND NOT off;
        END_TRANSITION
        STEP OnStep:
        relay(N);
        END_STEP
        TRANSITION FROM OnStep TO OffStep
        := off;
        END_TRANSITION
        END_PROGRAM",
    );
    let renamed = textual(&model(chart)).expect("a translation").renamed;
    assert_eq!(renamed, [("Off".to_owned(), "OffStep".to_owned()), ("On".to_owned(), "OnStep".to_owned())]);
}

/// Qualifiers with times as they stand; what has a condition or a value is done in each scan, by an action that asks which step is active.
#[test]
fn actions_of_all_kinds() {
    let chart = "sfc C {
        input a, b: bool; param t: time = 2s;
        output q, p, w, l, v: bool; output speed: u8 = 7; var n: u16 = 0;
        initial step A { q if b; R w; L 5s l; speed = 3; P0 n = n + 1; }
        step B { q; S w; D t l; }
        step E { P1 { if b { n = 0; } } P p; v; speed = 4 if b; }
        A -[a]-> B -[!a]-> E -[a]-> A;
    }";
    // `n` is written where `A` is left and where `E` is entered, which no transition does in one scan.
    expect(
        chart,
        "PROGRAM C
        VAR_INPUT
        a : BOOL;
        b : BOOL;
        t : TIME := T#2s;
        END_VAR
        VAR_OUTPUT
        q : BOOL := FALSE;
        p : BOOL := FALSE;
        w : BOOL := FALSE;
        l : BOOL := FALSE;
        v : BOOL := FALSE;
        speed : USINT := 7;
        END_VAR
        VAR
        n : UINT := 0;
        END_VAR
        INITIAL_STEP AStep:
        w(R);
        l(L, T#5s);
        AStep_P0(P0);
        Always(S);
        END_STEP
        TRANSITION FROM AStep TO BStep
        := a;
        END_TRANSITION
        STEP BStep:
        w(S);
        l(D, t);
        END_STEP
        TRANSITION FROM BStep TO E
        := NOT a;
        END_TRANSITION
        STEP E:
        E_P1(P1);
        p(P);
        v(N);
        END_STEP
        TRANSITION FROM E TO AStep
        := a;
        END_TRANSITION
        ACTION AStep_P0:
        n := n + 1;
        END_ACTION
        ACTION E_P1:
        IF b THEN
        n := 0;
        END_IF;
        END_ACTION
        ACTION Always:
        q := AStep.X AND b OR BStep.X;
        IF E.X AND b THEN
        speed := 4;
        ELSIF AStep.X THEN
        speed := 3;
        ELSE
        speed := 7;
        END_IF;
        END_ACTION
        END_PROGRAM",
    );
}

/// Branches have priorities in their order; edges compare with what that action remembers, after the transitions.
#[test]
fn branches_times_and_edges() {
    let chart = "sfc C {
        input a, b: bool;
        initial step S1; step S2; step S3; step S4;
        S1 -[rising(a)]-> (S2, S3);
        S1 -[falling(a) || b]-> S4;
        (S2, S3) -[5s/S2 && 1s/S4]-> S1;
        S4 -[S4.T > 3s && S1.X]-> S1;
        S4 -[else]-> S1;
    }";
    expect(
        chart,
        "PROGRAM C
        VAR_INPUT
        a : BOOL;
        b : BOOL;
        END_VAR
        VAR
        a_was : BOOL := FALSE;
        END_VAR
        INITIAL_STEP S1:
        Always(S);
        END_STEP
        TRANSITION (PRIORITY := 1) FROM S1 TO (S2, S3)
        := a AND NOT a_was;
        END_TRANSITION
        TRANSITION (PRIORITY := 2) FROM S1 TO S4
        := NOT a AND a_was OR b;
        END_TRANSITION
        STEP S2:
        END_STEP
        TRANSITION FROM (S2, S3) TO S1
        := S2.T >= T#5s AND S4.X AND S4.T >= T#1s;
        END_TRANSITION
        STEP S3:
        END_STEP
        STEP S4:
        END_STEP
        TRANSITION (PRIORITY := 1) FROM S4 TO S1
        := S4.T > T#3s AND S1.X;
        END_TRANSITION
        TRANSITION (PRIORITY := 2) FROM S4 TO S1
        := NOT (S4.T > T#3s AND S1.X);
        END_TRANSITION
        ACTION Always:
        a_was := a;
        END_ACTION
        END_PROGRAM",
    );
}

/// Where a step follows another that drives the same boolean, both do it by the action that runs in each scan: of two steps with a boolean of one name Beremiz
/// lets the one decide that ends, if it stands after the other.
#[test]
fn what_goes_on_from_step_to_step() {
    let chart = "sfc C { input a: bool; output q, p: bool; initial step S1; step S2 { q; p; } step S3 { q; } S1 -[a]-> S2 -[!a]-> S3 -[a]-> S1; }";
    let lines = program(chart);
    assert!(lines.contains(&"q := S2.X OR S3.X;".to_owned()) && lines.contains(&"p(N);".to_owned()), "{lines:#?}");
    let beside = "sfc C { input a, b: bool; output q: bool; initial step S1; step S2 { q; } step S3; step S4 { q; } step S5; S1 -[a]-> (S2, S4); S2 -[b]-> S3; S4 -[!b]-> S5; (S3, S5) -[!a]-> S1; }";
    assert!(program(beside).contains(&"q := S2.X OR S4.X;".to_owned()));
}

/// Set and reset under conditions are one action, in which reset is the last to be asked.
#[test]
fn reset_dominates() {
    let chart = "sfc C { input a, b: bool; output q: bool; initial step S1; step S2 { R q; } step S3 { S q if b; } S1 -[a]-> (S2, S3); (S2, S3) -[!a]-> S1; }";
    let lines = program(chart);
    let begin = lines.iter().position(|line| line == "ACTION Always:").expect("an action");
    let expected =
        ["IF S3.X AND b THEN", "q := TRUE;", "END_IF;", "IF S2.X THEN", "q := FALSE;", "END_IF;", "END_ACTION"];
    assert_eq!(lines[begin + 1..begin + 8], expected);
}

/// A code action is a function block that is told whether it still runs.
#[test]
fn calls() {
    let chart = "sfc C { input a: bool; input level: u8; action heat(setpoint: u8); initial step S1; step S2 { N heat(level); } S1 -[a]-> S2 -[!a]-> S1; }";
    let lines = program(chart);
    let has = |wanted: &str| assert!(lines.iter().any(|line| line == wanted), "{wanted}: {lines:#?}");
    has("FUNCTION_BLOCK FB_heat");
    has("run : BOOL;");
    has("heat : FB_heat;");
    has("heat(run := S2.X, setpoint := level);");
}

/// What the language cannot say.
const REFUSED: [(&str, &str); 12] = [
    ("grafcet C { input a: bool; initial step S1; step S2; S1 -[a]-> S2 -[!a]-> S1; }", "makes one evolution a scan"),
    (
        "sfc C { input a: bool; initial step S1; step S2; step S3; S1 -[a]-> (S2, S3); (S2, S3) -[!a]-> S1; S2 -[a && S3.X]-> S2; }",
        "shares some of its steps, and not all",
    ),
    (
        "sfc C { input a: bool; var n: u8 = 0; initial step S1 { P0 n = 1; } step S2 { P1 n = n + 1; } S1 -[a && n < 9]-> S2 -[!a]-> S1; }",
        "`n` depends on which of an action of `S1` and this one of `S2` runs first",
    ),
    (
        "sfc C { input a: bool; var n: u8 = 0; initial step S1; step S2 { P1 n = 1; N n = n + 1; } S1 -[a && n < 9]-> S2 -[!a]-> S1; }",
        "`n` depends on which of two actions of `S2` runs first",
    ),
    (
        "sfc C { input a: bool; output q, p: bool; initial step S1; step S2 { N q; N p if q; } S1 -[a]-> S2 -[!a]-> S1; }",
        "`q` depends on which",
    ),
    (
        "sfc C { input a: bool; var n: u8 = 0; initial step S1; step S2 { N { n = n + 1; } if a; } S1 -[a && n < 9]-> S2 -[!a]-> S1; }",
        "what runs under a condition has a final call of its own",
    ),
    (
        "sfc C { input a: bool; output q: bool; initial step S1; step S2 { L 2s q if a; } S1 -[a]-> S2 -[!a]-> S1; }",
        "`if` beside other qualifiers of `q`",
    ),
    (
        "sfc C { input a: bool; output q: bool; initial step S1 { L 2s q; } step S2; step S3 { L 3s q; } S1 -[a]-> S2 -[!a]-> S3 -[a]-> S1; }",
        "`L` of `q` has two times",
    ),
    ("sfc C { input a: bool; initial step S1; step S2; S1 -[2s/a/1s]-> S2 -[!a]-> S1; }", "a delay has no translation"),
    (
        "sfc C { input a: bool; output q: bool; initial step S1; step S2 { q if rising(a); } S1 -[a]-> S2 -[!a]-> S1; }",
        "an edge in an action",
    ),
    (
        "sfc C { input a: bool; initial step S1; step S2; S1 -[a]-> S2 -[S1.T > 2s || !a]-> S1; }",
        "the time of a step that may not be active",
    ),
    (
        "sfc C { input a: bool; action run(n: u8); initial step S1 { N run(1); } step S2 { N run(2); } S1 -[a]-> S2 -[!a]-> S1; }",
        "`run` is called by several associations",
    ),
];

#[test]
fn what_has_no_translation() {
    for (chart, why) in REFUSED {
        let refused = textual(&model(chart)).expect_err(chart);
        assert!(refused.iter().any(|one| one.message.contains(why)), "{chart}: {refused:?}");
    }
}

/// A comment ends where it ends, also for a compiler that lets comments stand within comments; and what is left out is said as it is.
#[test]
fn what_is_said_in_comments() {
    let chart = "
        /// Stops (* at once *) (*)
        sfc C {
            /// (* on
            input a: bool; output q: bool;
            initial step A; step B within 5s { q if B.late; }
            A -[a]-> B -[!a || B.late]-> A;
        }";
    let text = textual(&model(chart)).expect("a translation").text;
    assert!(text.starts_with("(* Stops ( * at once * ) ( * ) *)\n"), "{text}");
    assert!(text.contains("  a : BOOL; (* ( * on *)\n"), "{text}");
    for line in text.lines() {
        let count = |sign: &str| line.matches(sign).count();
        assert!(count("(*") <= 1 && count("(*") == count("*)"), "{line}");
    }
    let late = "(* Left out: `within` of B; where a condition asks whether one is late, it is there. *)\n";
    assert!(text.contains(late), "{text}");
    let options = grafcet_exchange::st::Options::default();
    let text = grafcet_exchange::st::structured_text(&model(chart), &options).expect("a translation").text;
    assert!(text.contains(&format!("// {}", &late[3..late.len() - 4])), "{text}");
}

/// Structured text has the variants of a list as numbers; that SFC has not is said so.
#[test]
fn lists_of_variants() {
    let chart = "sfc C { input mode: Mode in {Off, Auto}; initial step A; step B; A -[mode == Mode::Auto]-> B -[mode == Mode::Off]-> A; }";
    let refused = textual(&model(chart)).expect_err("a list");
    let messages: Vec<String> = refused.into_iter().map(|refused| refused.message).collect();
    assert_eq!(
        messages,
        [
            "`mode` is a variant of a list, which structured text has as a number (`cargo grafcet export st`) and SFC has not; use an integer"
        ]
    );
    let options = grafcet_exchange::st::Options::default();
    assert!(grafcet_exchange::st::structured_text(&model(chart), &options).is_ok());
}
