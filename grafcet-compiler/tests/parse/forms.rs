//! Every form of the language, and what it means.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use crate::{run, show};

/// What the items of a chart's body mean; there must be no error.
fn items(text: &str) -> String {
    let (chart, errors) = run(&format!("grafcet C {{ {text} }}"));
    assert_eq!(errors, [], "{text}");
    let chart = chart.expect("a chart");
    assert!(!chart.incomplete && chart.body.broken.is_empty(), "{text}");
    show::body(&chart.body)
}

/// What the lines of a step mean.
fn lines(text: &str) -> String {
    let shown = items(&format!("step A {{ {text} }}"));
    shown.strip_prefix("step A {").and_then(|rest| rest.strip_suffix('}')).expect("a step").to_owned()
}

fn check(meaning: impl Fn(&str) -> String, cases: &[(&str, &str)]) {
    for (text, expected) in cases {
        assert_eq!(&meaning(text), expected, "{text}");
    }
}

#[test]
fn both_charts_of_the_source_documents() {
    let (motor, errors) = run("
        /// A motor that can be switched on and off, guarded against over-temperature.
        pub sfc Motor {
            input on, off, over_temp: bool;
            output relay, green, red: bool;

            initial step Off { N red; }
            step On { N relay; N green; }

            Off -[on && !over_temp]-> On -[off || over_temp]-> Off;
        }");
    assert_eq!(errors, []);
    let motor = show::chart(&motor.expect("a chart"));
    assert!(motor.starts_with("# [doc = \" A motor that can be"), "{motor}");
    let expected = "pub Sfc Motor {Input on, off, over_temp: bool; Output relay, green, red: bool; \
        initial step Off {N red}; step On {N relay; N green}; Off -[on && ! over_temp]-> On -[off || over_temp]-> Off}";
    assert!(motor.ends_with(expected), "{motor}");

    let (line, errors) = run("
        pub grafcet Line24V {
            input b1, b2, b3, b4, b5: bool;
            output q1, q2, q3: bool;

            initial step S1 { q1; }          // continuous action
            step S2 { S q2; }                // stored action: set
            step S3 { q3 if b5; }            // continuous action with an assignation condition
            step S4 { R q2; }                // stored action: reset

            S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1;
        }");
    assert_eq!(errors, []);
    let expected = "pub Grafcet Line24V {Input b1, b2, b3, b4, b5: bool; Output q1, q2, q3: bool; initial step S1 {q1}; \
        step S2 {S q2}; step S3 {q3 if b5}; step S4 {R q2}; S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1}";
    assert_eq!(show::chart(&line.expect("a chart")), expected);
}

#[test]
fn headers() {
    let header = |text: &str| {
        let (chart, errors) = run(text);
        assert_eq!(errors, [], "{text}");
        show::chart(&chart.expect("a chart"))
    };
    check(
        header,
        &[
            ("sfc M {}", "Sfc M {}"),
            ("pub grafcet M {}", "pub Grafcet M {}"),
            ("pub(crate) sfc M {}", "pub (crate) Sfc M {}"),
            ("pub(in crate::a) sfc M {}", "pub (in crate :: a) Sfc M {}"),
            ("#[allow(dead_code)] sfc M {}", "# [allow (dead_code)]  Sfc M {}"),
            ("sfc sfc {}", "Sfc sfc {}"),
        ],
    );
}

#[test]
fn declarations() {
    check(
        items,
        &[
            ("input on, off: bool;", "Input on, off: bool"),
            ("input level: u16;", "Input level: u16"),
            ("output speed: u16 = 0;", "Output speed: u16 = 0"),
            ("var count: [u8; 3] = [0; 3];", "Var count: [u8 ; 3] = [0 ; 3]"),
            ("var m: Option<core::time::Duration> = None;", "Var m: Option < core :: time :: Duration > = None"),
            ("var m: Mode = Mode { a: 1 };", "Var m: Mode = Mode { a : 1 }"),
            ("param t_max: i16 = -80;", "Param t_max: i16 = - 80"),
            ("param soak, rest: time = 5s;", "Param soak, rest: TIME = 5s"),
            ("var t: time::Duration;", "Var t: time :: Duration"),
            ("action stop();", "action stop()"),
            ("action heat(setpoint: i16, t: time,);", "action heat(setpoint: i16, t: TIME)"),
        ],
    );
}

#[test]
fn settings_and_properties() {
    check(
        items,
        &[
            ("clock 1ms;", "clock 1000000ns"),
            ("max_evolutions 20;", "max_evolutions 20"),
            ("budget 100_000;", "budget 100_000"),
            ("assume never b1 && b3;", "assume never b1 && b3"),
            ("assume often b1 || b3;", "assume often b1 || b3"),
            ("assume q leads_to b1 within 2ms;", "assume q leads_to b1 within 2000000ns"),
            ("assume q leads_to b1 || b3;", "assume q leads_to b1 || b3"),
            ("assume q before b1;", "assume q before b1"),
            ("assume cycle within 2ms;", "assume cycle within 2000000ns"),
            ("optimize size;", "optimize size"),
            ("encoding flags;", "encoding flags"),
            ("forceable;", "forceable"),
            ("modes;", "modes"),
            ("never Up.X && Down.X;", "never Up . X && Down . X"),
            ("never -x > 3;", "never - x > 3"),
            ("never match x { 1 => true, _ => false };", "never match x { 1 => true , _ => false }"),
            ("always relay => !over_temp || On.X;", "always relay => ! over_temp || On . X"),
            ("always !a || b;", "always ! a || b"),
            ("start leads_to Done;", "start leads_to Done"),
            ("(a || b) && c leads_to !d within 5s;", "(a || b) && c leads_to ! d within 5000000000ns"),
            ("x > 3 before Up.X;", "x > 3 before Up . X"),
            ("home Off;", "home (Off)"),
            ("home (A, B);", "home (A, B)"),
        ],
    );
}

#[test]
fn steps() {
    check(
        items,
        &[
            ("initial step Off { }", "initial step Off {}"),
            ("step Wait;", "step Wait {}"),
            ("step Wait {};", "step Wait {}"),
            ("final step Done;", "final step Done {}"),
            ("initial linked step A;", "initial linked step A {}"),
            (
                "macro step M { entry step A; exit step B; A -[x]-> B; }",
                "macro step M {entry step A {}; exit step B {}; A -[x]-> B}",
            ),
            ("initial macro step M { }", "initial macro step M {}"),
            (
                "enclosing step E { q; partial P { linked step A; } S r; }",
                "enclosing step E {q; S r; partial P {linked step A {}}}",
            ),
            ("partial P { initial step A; A -[x]-> A; }", "partial P {initial step A {}; A -[x]-> A}"),
            ("step step; step r#match; step input { }", "step step {}; step r#match {}; step input {}"),
        ],
    );
}

#[test]
fn associations() {
    check(
        lines,
        &[
            ("q;", "q"),
            ("N q;", "N q"),
            ("q if a && b;", "q if a && b"),
            ("N q if if a { b } else { c };", "N q if if a { b } else { c }"),
            ("speed = 3 * x;", "speed := 3 * x"),
            ("N speed = x if a;", "N speed := x if a"),
            ("N count = count + 1;", "N count := count + 1"),
            ("S q; R q;", "S q; R q"),
            ("P1 q = true; P0 q = false;", "P1 q := true; P0 q := false"),
            ("P+ a(1); P- a(2);", "P1 a(1); P0 a(2)"),
            ("P q;", "P q"),
            (
                "L 5s q; D 2s q; SD 2s q; DS 2s q; SL 5s q;",
                "L 5000000000ns q; D 2000000000ns q; Sd 2000000000ns q; Ds 2000000000ns q; Sl 5000000000ns q",
            ),
            ("L soak q; D soak heat(80); SD soak { x(); }", "L <soak> q; D <soak> heat(80); Sd <soak> { x () ; }"),
            ("L soak\n q; SL soak\n{ x(); } D soak\n heat(80);", "L <soak> q; Sl <soak> { x () ; }; D <soak> heat(80)"),
            ("DS 1ms heat(80, a + b) if ready;", "Ds 1000000ns heat(80, a + b) if ready"),
            ("N heat(80); heat();", "N heat(80); heat()"),
            ("P1 { count += 1; } q;", "P1 { count += 1 ; }; q"),
            ("P1 { count += 1; }; q;", "P1 { count += 1 ; }; q"),
            ("N { x } if a; q;", "N { x } if a; q"),
            ("on rising(a) count = count + 1;", "On <rising (a)> count := count + 1"),
            ("on (a && rising(b)) q;", "On <(a && rising (b))> q"),
            ("on a { x(); } q;", "On <a> { x () ; }; q"),
            ("on rising(a) heat(80) if b;", "On <rising (a)> heat(80) if b"),
            (
                "force G {S1, S2}; force G {*}; force G {}; force G {INIT};",
                "force G <S1, S2>; force G <HOLD>; force G <EMPTY>; force G <INITIAL>",
            ),
            ("force G {} q;", "q; force G <EMPTY>"),
        ],
    );
}

#[test]
fn words_of_the_notation_are_free_for_names() {
    check(
        lines,
        &[
            ("on; on = 5; on if a; on(80); on(80) if a;", "on; on := 5; on if a; on(80); on(80) if a"),
            ("force; force = 1; force if a; force();", "force; force := 1; force if a; force()"),
            ("S step; R input; input; step = 3; final if a;", "S step; R input; input; step := 3; final if a"),
            ("S = 3; L(5); P = 1;", "S := 3; L(5); P := 1"),
        ],
    );
    check(
        items,
        &[
            ("input on, step, force, input, time, S: bool;", "Input on, step, force, input, time, S: bool"),
            ("input -[x]-> step -[y]-> home; home -[x]-> never;", "input -[x]-> step -[y]-> home; home -[x]-> never"),
        ],
    );
}

#[test]
fn chains() {
    check(
        items,
        &[
            ("A -[x]-> (B, C); (B, C,) -[x]-> D;", "A -[x]-> (B, C); (B, C) -[x]-> D"),
            ("A -[go: x && y]-> B;", "A -[go: x && y]-> B"),
            ("A -[go::now]-> B;", "A -[go :: now]-> B"),
            ("A -[true]-> B -[x]-> C\n-[y]-> D;", "A -[true]-> B -[x]-> C -[y]-> D"),
            ("A -[x => count = 0]-> B;", "A -[x => count := 0]-> B"),
            ("A -[go: x => a = 0, { b() }, c(1)]-> B;", "A -[go: x => a := 0, { b () }, c(1)]-> B"),
            ("() -[x]-> A -[y]-> ();", "() -[x]-> A -[y]-> ()"),
            ("A -[5s/Step && 3s/(a || b)/2s]-> B;", "A -[5s / Step && 3s / (a || b) / 2s]-> B"),
            (
                "A -[matches!(x, 1 | 2) && [1, 2].contains(&x)]-> B;",
                "A -[matches ! (x , 1 | 2) && [1 , 2] . contains (& x)]-> B",
            ),
            ("A -[and && or(not)]-> B;", "A -[and && or (not)]-> B"),
        ],
    );
}

/// What a rule refuses later has to be understood first.
#[test]
fn mistakes_that_are_for_the_rules() {
    check(
        items,
        &[
            ("A -> B -> C;", "A BARE B BARE C"),
            ("A -[x]-[y]-> B;", "A -[x]-> MISSING -[y]-> B"),
            ("A -[x]- -[y]-> B;", "A -[x]-> MISSING -[y]-> B"),
            ("A -[x]-> -[y]-> B;", "A -[x]-> MISSING -[y]-> B"),
            ("A -[x]-[y]-[z]-> B;", "A -[x]-> MISSING -[y]-> MISSING -[z]-> B"),
            ("A -> -[x]-> B;", "A BARE MISSING -[x]-> B"),
            ("A -[x]-> ;", "A -[x]-> FORGOTTEN"),
            ("-[x]-> A;", "FORGOTTEN -[x]-> A"),
        ],
    );
}

#[test]
fn attributes() {
    check(
        items,
        &[
            (
                "/** Doc. */ #[allow(dead_code, clippy::x)] input a: bool;",
                "# [doc = \" Doc. \"] # [allow (dead_code , clippy :: x)] Input a: bool",
            ),
            (
                "#[allow(grafcet::several_initial_steps, grafcet::several_initial_steps)] step A;",
                "[Allow several_initial_steps] [Allow several_initial_steps] step A {}",
            ),
            (
                "#[warn(grafcet::several_initial_steps)] #[deny(grafcet::several_initial_steps)] #[forbid(grafcet::several_initial_steps)] A -[x]-> B;",
                "[Warn several_initial_steps] [Deny several_initial_steps] [Deny several_initial_steps] A -[x]-> B",
            ),
            (
                "#[allow(grafcet::several_initial_steps, dead_code, reason = \"why\")] step A;",
                "# [allow (dead_code , reason = \"why\" ,)] [Allow several_initial_steps] step A {}",
            ),
            (
                "#[allow(grafcet::several_initial_steps, reason = \"why\")] step A;",
                "[Allow several_initial_steps] step A {}",
            ),
            ("#[expect(dead_code)] action x();", "# [expect (dead_code)] action x()"),
            (
                "#[doc(hidden)] partial P { #![allow(grafcet::several_initial_steps)] }",
                "# [doc (hidden)] partial P {#![Allow several_initial_steps] }",
            ),
            ("#[allow(grafcet::several_initial_steps)] never A.X;", "[Allow several_initial_steps] never A . X"),
            (
                "#![deny(grafcet::several_initial_steps)] #![warn(grafcet::several_initial_steps)] step A;",
                "#![Deny several_initial_steps] #![Warn several_initial_steps] step A {}",
            ),
        ],
    );
}

fn replace(tokens: TokenStream, invisible: &impl Fn(&str) -> TokenTree) -> TokenStream {
    let one = |tree| match tree {
        TokenTree::Ident(ident) if ident == "VIS" => invisible("pub"),
        TokenTree::Ident(ident) if ident == "TY" => invisible("Option<u8>"),
        TokenTree::Ident(ident) if ident == "COND" => invisible("a || b"),
        TokenTree::Group(group) => Group::new(group.delimiter(), replace(group.stream(), invisible)).into(),
        other => other,
    };
    tokens.into_iter().map(one).collect()
}

/// A macro by example hands over identifiers, types and expressions in groups without delimiters.
#[test]
fn invisible_groups() {
    let invisible = |text: &str| TokenTree::from(Group::new(Delimiter::None, text.parse().expect("tokens")));
    let text = "VIS sfc M { input a: TY; initial step A { q if COND; } A -[COND]-> B; step B; }";
    let mut sink = grafcet_compiler::diagnostic::Sink::new();
    let tokens = replace(text.parse().expect("tokens"), &invisible);
    let chart = grafcet_compiler::parse::chart(tokens, &mut sink).expect("a chart");
    assert_eq!(sink.finish().len(), 0);
    let shown = show::chart(&chart);
    assert!(shown.starts_with("pub Sfc M {Input a: Option < u8 >; "), "{shown}");
    assert!(shown.contains("A -[") && shown.contains("a || b"), "{shown}");
}

#[test]
fn a_type_may_follow_the_name_of_a_lifetime() {
    let cases = [
        ("input a: &'a u8;", "Input a: & 'a u8"),
        ("input a: for<'a> fn(&'a u8) -> &'a u8;", "Input a: for < 'a > fn (& 'a u8) -> & 'a u8"),
        ("input a: Option<for<'a> fn(&'a u8) -> &'a u8>;", "Input a: Option < for < 'a > fn (& 'a u8) -> & 'a u8 >"),
        ("input a: Part<'a, &'a mut Other<'b>>;", "Input a: Part < 'a , & 'a mut Other < 'b > >"),
        ("output a: u8 = 'on: { if b { break 'on 3 } 4 };", "Output a: u8 = 'on : { if b { break 'on 3 } 4 }"),
    ];
    check(items, &cases);
    // As much as before is taken for a type where `;` is missing.
    let (chart, errors) = run("sfc C { input a: &'a u8 input b: bool; }");
    assert_eq!(errors.len(), 1);
    assert_eq!(show::body(&chart.expect("a chart").body), "Input a: & 'a u8; Input b: bool");
}
