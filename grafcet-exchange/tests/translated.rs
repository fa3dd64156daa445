//! Of structured text what `tests/imported` does not show: other forms of the same, and what is refused with its reason.

use grafcet_exchange::import::{Imported, import};

fn imported(text: &str) -> Imported {
    import(text, "there.st").unwrap_or_else(|wrong| panic!("{wrong:?}"))
}

/// A program with declarations and one action, which its first step has.
fn program(types: &str, variables: &str, body: &str) -> String {
    format!(
        "{types} PROGRAM P VAR_INPUT a, b : BOOL; n : INT; w : WORD; END_VAR VAR_OUTPUT q : BOOL; m : INT; x : REAL; END_VAR
        VAR {variables} END_VAR
        INITIAL_STEP S1: Act(P1); END_STEP STEP S2: END_STEP
        TRANSITION FROM S1 TO S2 := a; END_TRANSITION TRANSITION FROM S2 TO S1 := b; END_TRANSITION
        ACTION Act: {body} END_ACTION END_PROGRAM"
    )
}

/// What is made of a body, in one line.
fn body(types: &str, variables: &str, text: &str) -> String {
    let done = imported(&program(types, variables, text));
    let begin = done.rust.find("step S1 {").unwrap_or_else(|| panic!("{}", done.rust));
    let end = done.rust.find("        step S2").expect("a second step");
    let lines = done.rust[begin + 9..end].split_whitespace().collect::<Vec<_>>().join(" ");
    lines.strip_suffix('}').unwrap_or(&lines).trim().to_owned()
}

/// Why it is a stub.
fn refused(types: &str, variables: &str, text: &str) -> String {
    let done = imported(&program(types, variables, text));
    let notes = done.charts.iter().flat_map(|chart| &chart.notes).map(|note| &*note.message);
    let found = notes.filter_map(|note| note.strip_prefix("`Act` is a code action to be written in Rust: ")).collect();
    assert!(done.rust.contains(&format!("///     {}", text.lines().next().unwrap_or_default())), "{}", done.rust);
    found
}

#[test]
fn enums_in_other_forms() {
    let types = "TYPE Mode : (Off := 2, Auto) DINT := Auto; Other : Mode; END_TYPE";
    let of = |text: &str| body(types, "v : Other; u : Mode := 2;", text);
    assert_eq!(of("v := Mode.Off;"), "P1 v = Mode::Off;");
    assert_eq!(of("v := mode#AUTO;"), "P1 v = Mode::Auto;");
    assert_eq!(of("v := 3;"), "P1 v = Mode::Auto;");
    assert_eq!(of("IF v <> Off THEN u := v; END_IF"), "P1 { if v != Mode::Off { u = v; } }");
    assert_eq!(of("m := TO_INT(v);"), "P1 m = v as i16;");
    let done = imported(&program(types, "v : Other; u : Mode := 2;", "v := Off; u := Off;"));
    for line in [
        "pub enum Mode {\n    Off = 2,\n    #[default]\n    Auto = 3,\n}",
        "var v: Mode in {Off, Auto} = Mode::Auto;",
        "var u: Mode in {Off, Auto} = Mode::Off;",
    ] {
        assert!(done.rust.contains(line), "{line}\n{}", done.rust);
    }
    assert_eq!(refused(types, "v : Mode;", "v := 7;"), "`Mode` has no value with the number 7");
    assert_eq!(refused(types, "v : Mode;", "v := Mode.Hand;"), "`Mode` has no value `Hand`");
    assert_eq!(refused(types, "v : Mode;", "q := v < Auto;"), "values of an enum are compared with `=` and `<>` alone");
    // Two enums have it, and nothing tells which one is meant.
    let both = "TYPE A : (On, Off); B : (Off, Away); END_TYPE";
    assert_eq!(body(both, "v : B;", "v := Off;"), "P1 v = B::Off;");
    // An enum and a chart of one name.
    let done = imported(&program("TYPE P : (On, Off); END_TYPE", "v : P;", "v := Off;"));
    assert!(done.rust.contains("pub enum PType {") && done.rust.contains("v = PType::Off;"), "{}", done.rust);
}

#[test]
fn cases() {
    assert_eq!(
        body("", "", "CASE n OF 1, 3: m := 1; -5..-2: m := 2; q := TRUE; END_CASE"),
        "P1 { match n { 1 | 3 => m = 1, -5..=-2 => { m = 2; q = true; } _ => {} } }"
    );
    assert_eq!(
        body("", "", "CASE n + 1 OF 1: CASE m OF 2: q := a; ELSE q := b; END_CASE; END_CASE"),
        "P1 { match n + 1 { 1 => { match m { 2 => q = a, _ => q = b, } } _ => {} } }"
    );
    let labels = "a label of `CASE` is neither a number nor a value of its enum";
    assert_eq!(refused("", "k : INT := 3;", "CASE n OF k: m := 1; END_CASE"), labels);
    assert_eq!(refused("", "", "CASE n OF 40000: m := 1; END_CASE"), labels);
    let of = "`CASE` of what is neither an integer nor an enum";
    assert_eq!(refused("", "", "CASE a OF TRUE: m := 1; END_CASE"), of);
    assert_eq!(refused("", "", "CASE x OF 1: m := 1; END_CASE"), of);
}

#[test]
fn loops() {
    let of = |text: &str| body("", "i, j : INT;", text);
    assert_eq!(of("FOR i := 0 TO n DO m := m + i; END_FOR"), "P1 { for i in 0..=n { m = m + i; } }");
    assert_eq!(
        of("FOR i := n TO 1 BY -1 DO FOR j := i TO 9 BY 3 DO m := i * j; END_FOR; END_FOR"),
        "P1 { for i in (1..=n).rev() { for j in (i..=9).step_by(3) { m = i * j; } } }"
    );
    // What it counts is asked for after it.
    assert_eq!(
        of("FOR i := 9 TO 1 BY -2 DO q := a; END_FOR; m := i;"),
        "P1 { i = 9; while i >= 1 { q = a; i -= 2; } m = i; }"
    );
    assert_eq!(
        of("WHILE m < 5 DO IF a THEN CONTINUE; END_IF; m := m + 1; EXIT; END_WHILE"),
        "P1 { while m < 5 { if a { continue; } m = m + 1; break; } }"
    );
    // And so in a condition.
    let text =
        program("", "i : INT;", "FOR i := 0 TO 3 DO q := a; END_FOR").replace("S1 TO S2 := a;", "S1 TO S2 := i > 3;");
    let done = imported(&text);
    assert!(done.rust.contains("i = 0;") && done.rust.contains("S1 -[i > 3]-> S2"), "{}", done.rust);
    let refused = |text: &str| refused("", "i, j : INT;", text);
    assert_eq!(refused("FOR i := 0 TO 3 BY n DO m := 1; END_FOR"), "`FOR` by what is no literal");
    let by = "`FOR` by a number that its variable cannot hold";
    assert_eq!(refused("FOR i := 0 TO 3 BY 99999999999999999999999 DO m := 1; END_FOR"), by);
    let ends = "`FOR` over `i`, which is read elsewhere, with `CONTINUE` or an end that changes";
    assert_eq!(refused("FOR i := 0 TO m DO m := 1; END_FOR; m := i;"), ends);
    assert_eq!(refused("FOR i := 0 TO 3 DO IF a THEN CONTINUE; END_IF; END_FOR; m := i;"), ends);
    assert_eq!(refused("REPEAT CONTINUE; UNTIL a END_REPEAT"), "`CONTINUE` within `REPEAT`");
    assert_eq!(refused("IF a THEN RETURN; END_IF"), "`RETURN` is not translated");
}

#[test]
fn functions() {
    let of = |text: &str| body("", "d : DINT; f : LREAL;", text);
    for (text, rust) in [
        ("m := LIMIT(1, n, 9);", "P1 m = n.max(1).min(9);"),
        ("m := MAX(3, n, 4);", "P1 m = n.max(3).max(4);"),
        ("m := SEL(a, n, 4);", "P1 m = if a { 4 } else { n };"),
        ("m := MOVE(n) + SEL(IN1 := 1, IN0 := 2, G := b);", "P1 m = n + (if b { 1 } else { 2 });"),
        ("d := INT_TO_DINT(n) / 2;", "P1 d = (n as i32) / 2;"),
        ("m := DINT_TO_INT(d);", "P1 m = d as i16;"),
        ("m := BOOL_TO_INT(a AND b);", "P1 m = i16::from(a && b);"),
        ("q := INT_TO_BOOL(n);", "P1 q = n != 0;"),
        ("f := INT_TO_LREAL(n);", "P1 f = n as f64;"),
        ("q := w.15 XOR NE(n, 3);", "P1 q = (w & (1 << 15) != 0) ^ (n != 3);"),
        ("q := OR(a, b, n != 2);", "P1 q = a || b || n != 2;"),
        ("m := WORD_TO_INT(SHR(w, 4) AND 16#0F);", "P1 m = ((w >> 4) & 15) as i16;"),
        ("q := a = FALSE AND TRUE <> b;", "P1 q = !a && !b;"),
        ("m := INT#-5;", "P1 m = -5;"),
    ] {
        assert_eq!(of(text), rust);
    }
    // Nothing is lost where a type has all values of the other.
    for (text, rust) in [
        ("d := n;", "P1 d = i32::from(n);"),
        ("q := n < d;", "P1 q = i32::from(n) < d;"),
        ("f := n * 2;", "P1 f = f64::from(n * 2);"),
        ("x := n + 0;", "P1 x = f32::from(n + 0);"),
        ("d := MAX(n, d, 3) + w;", "P1 d = i32::from(n).max(d).max(3) + i32::from(w);"),
    ] {
        assert_eq!(of(text), rust);
    }
    let refused = |text: &str| refused("", "d : DINT; f : LREAL; v : WORD;", text);
    assert_eq!(refused("m := LREAL_TO_INT(f);"), "a f64 as a i16");
    assert_eq!(refused("v := SHL(w, 16); q := v.2;"), "`SHL` by 16");
    assert_eq!(refused("v := SHL(w, n); q := v.2;"), "`SHL` by what is no literal");
    assert_eq!(refused("m := MIN(1, 2);"), "`MIN` of literals alone");
    assert_eq!(refused("q := w.16;"), "`w` has no bit 16");
    // A float keeps 24 bits exactly.
    let two = refused("x := d;");
    assert_eq!(two, "i32 and f32 are two types, and Rust would need to be told how one becomes the other");
    assert_eq!(
        refused("m := d;"),
        "i32 and i16 are two types, and Rust would need to be told how one becomes the other"
    );
}

#[test]
fn blocks_that_say_something_else_are_left() {
    // An input by name; an argument that is none of its inputs.
    assert_eq!(
        refused("", "c : CTU;", "c.PV := 3; c(CU := a); q := c.Q;"),
        "`c.PV` is not declared as a value that Rust has"
    );
    assert_eq!(refused("", "c : CTU;", "c(XX := a); q := c.Q;"), "`c(…)` among other statements");
    // What is given in one call alone keeps its value in the other.
    assert_eq!(refused("", "c : SR;", "c(S1 := a, R := b); c(S1 := b); q := c.Q1;"), "`c(…)` among other statements");
    assert_eq!(
        body("", "c : CTU_DINT;", "c(a, b, 7, Q => q);"),
        "P1 { if b { c_cv = 0; } else if a && !c_cu_before { c_cv = c_cv.saturating_add(1); } c_cu_before = a; c_q = c_cv >= 7; q = c_q; }"
    );
    assert!(imported(&program("", "c : CTU_DINT;", "c(a, b, 7, Q => q);")).rust.contains("var c_cv: i32;"));
    // What nobody reads is not kept.
    assert_eq!(body("", "c : SR;", "c(SET1 := a, RESET := b);"), "P1 c_q1 = a || !b && c_q1;");
}

#[test]
fn actions_that_are_called_and_inputs_that_are_written() {
    let done = imported(
        "PROGRAM P VAR_INPUT go : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR
        INITIAL_STEP S1: One(P1); END_STEP STEP S2: Own(P1); END_STEP
        TRANSITION FROM S1 TO S2 := go; END_TRANSITION TRANSITION FROM S2 TO S1 := go; END_TRANSITION
        ACTION One: go := FALSE; IF go THEN Two(); END_IF; END_ACTION
        ACTION Two: q := TRUE; END_ACTION ACTION Three: q := FALSE; END_ACTION
        ACTION Own: Own(); END_ACTION
        END_PROGRAM",
    );
    let notes: Vec<&str> = done.charts[0].notes.iter().map(|note| &*note.message).collect();
    assert_eq!(
        notes,
        [
            "`go` is an input, which whoever calls the chart gives: left out is `go := FALSE` in `one`",
            "left out: the action `Three`, which belongs to no step",
            "`Own` is a code action to be written in Rust: `Own` is not declared",
        ]
    );
    assert!(done.rust.contains("if go {\n                    q = true;"), "{}", done.rust);
}

/// A timer in an action of some steps: with what is asked around its call, and of several calls that which belongs to the step.
#[test]
fn timers_of_steps() {
    let done = imported(
        "PROGRAM P VAR_INPUT a, b : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR VAR T1, T2 : TON; END_VAR
        INITIAL_STEP S1: A1(N); END_STEP STEP S2: A2(N); END_STEP STEP S3: A3(N); END_STEP
        TRANSITION FROM S1 TO S2 := T1.Q; END_TRANSITION TRANSITION FROM S2 TO S3 := T1.Q; END_TRANSITION
        TRANSITION FROM S3 TO S1 := T1.Q OR T2.Q; END_TRANSITION
        ACTION A1: T1(IN := TRUE, PT := T#1s); T2(IN := FALSE, PT := T#0s); END_ACTION
        ACTION A2: IF a = TRUE THEN T1(IN := b, PT := T#2s); q := T1.Q; ELSE T1(FALSE, T#0s); END_IF; END_ACTION
        ACTION A3: IF b THEN T2(IN := b, PT := T#3s); END_IF; q := T2.Q; END_ACTION
        END_PROGRAM",
    );
    for part in ["S1 -[1s/S1]-> S2 -[2s/S2 && 2s/(a && b)]-> S3 -[s3_to_s1()]-> S1;", "N { q = 3s/S3 && 3s/b; }"] {
        assert!(done.rust.contains(part), "{part}\n{}", done.rust);
    }
    let found = done.charts[0].notes.iter().any(|note| note.message.contains("`T1` is called in several steps"));
    assert!(found, "{:?}", done.charts[0].notes);
}

/// A variable and an action that are called as a step is.
#[test]
fn one_name_for_two() {
    let done = imported(
        "PROGRAM P VAR_INPUT init, go : BOOL; END_VAR VAR n : INT; END_VAR
        INITIAL_STEP Init: Go(N); END_STEP STEP Go: END_STEP
        TRANSITION FROM Init TO Go := init AND n == 0; END_TRANSITION TRANSITION FROM Go TO Init := NOT Init.X AND go; END_TRANSITION
        ACTION Go: n := buf[3]; END_ACTION END_PROGRAM",
    );
    for part in [
        "input init, go: bool;",
        "initial step Init { N go_2(); }",
        "Init -[init && n == 0]-> Go -[!Init.X && go]-> Init;",
    ] {
        assert!(done.rust.contains(part), "{part}\n{}", done.rust);
    }
}

/// Files that only their tool reads are told by their root, with what to do.
#[test]
fn files_of_other_tools() {
    for (text, message) in [
        (
            "<?xml version='1.0'?>\n<!-- a POU --><TcPlcObject Version='1.1'/>",
            "this is a POU as TwinCAT keeps it; export it as PLCopen XML (in the context menu of the PLC project)",
        ),
        (
            "\u{feff}<ExportFile></ExportFile>",
            "this is an export of CODESYS in its own format; export it as PLCopen XML (Project, Export PLCopenXML)",
        ),
        (
            "<RSLogix5000Content/>",
            "this is a project of Logix Designer, which writes no PLCopen XML: its SFC is not read",
        ),
    ] {
        let wrong = import(text, "there").expect_err("no chart");
        assert_eq!(wrong.message, message);
        assert!(text[wrong.at].starts_with('<'));
    }
}
