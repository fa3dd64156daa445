//! Programs worked out by hand: the listings of the source document, timelines, and functions.

mod common;

#[path = "machine/mod.rs"]
mod machine;

use common::model;
use grafcet_exchange::st::{Flavour, Form, Options, Order, structured_text};
use machine::{Dialect, Machine, Statement, Value, statements, units};

fn program(chart: &str, form: Form) -> String {
    match structured_text(&model(chart), &Options { form, ..Options::default() }) {
        Ok(program) => program.text,
        Err(refused) => panic!("{refused:?}"),
    }
}

const LINE: &str = "grafcet Line24V { input b1, b2, b3, b4, b5: bool; output q1, q2, q3: bool;
    initial step S1 { q1; } step S2 { S q2; } step S3 { q3 if b5; } step S4 { R q2; }
    S1 -[b1]-> S2 -[b2]-> S3 -[b3]-> S4 -[b4]-> S1; }";

/// Bild 15 of the source document, statement by statement. Beyond it `Init` resets the outputs: the document says of the flip-flops that an
/// action would stay set otherwise, and what a step has switched on its transition would never switch off.
#[test]
fn bild_15() {
    let options = Options { numbers: (1, 1), step: "schrittnummer".to_owned(), ..Options::default() };
    let text = structured_text(&model(LINE), &options).expect("a translation").text;
    let mut body = units(&text, Dialect::Iec).expect("structured text").pop().expect("a function block").body;
    let Some(Statement::If(branches, _)) = body.first_mut() else { panic!("{body:?}") };
    let resets = branches[0].1.split_off(1);
    assert_eq!(resets, statements("q1 := FALSE; q2 := FALSE; q3 := FALSE;").expect("statements"));
    assert_eq!(body, statements(include_str!("bild15.st")).expect("the listing"));
}

/// In each flavour these are the same statements.
#[test]
fn bild_15_for_each_tool() {
    for (flavour, dialect) in FLAVOURS {
        let options = Options { flavour, numbers: (1, 1), step: "schrittnummer".to_owned(), ..Options::default() };
        let text = structured_text(&model(LINE), &options).expect("a translation").text;
        let mut body = units(&text, dialect).expect("structured text").pop().expect("a function block").body;
        let Some(Statement::If(branches, _)) = body.first_mut() else { panic!("{body:?}") };
        branches[0].1.truncate(1);
        assert_eq!(body, statements(include_str!("bild15.st")).expect("the listing"), "{text}");
    }
}

const FLAVOURS: [(Flavour, Dialect); 3] =
    [(Flavour::Iec, Dialect::Iec), (Flavour::Codesys, Dialect::Codesys), (Flavour::Tia, Dialect::Tia)];

/// What CODESYS and TIA Portal want otherwise, to the letter.
#[test]
fn what_a_tool_wants() {
    let chart =
        "sfc Oven { input level: u16; input wide: u64; output hot: bool; var n: u8 = 0; action heat(limit: i16);
        initial step Off; step On { N heat(80); hot; P1 n = n + 1; P0 n = 3; }
        Off -[limits::valid(level) && level > 5 && n < 9 && wide > 1]-> On -[5s/On]-> Off; }";
    let of = |flavour| {
        structured_text(&model(chart), &Options { flavour, ..Options::default() }).expect("a translation").text
    };
    let has = |text: &str, lines: &[&str]| {
        for line in lines {
            assert!(text.lines().any(|other| other.trim() == *line), "{line}\n{text}");
        }
    };
    let codesys = [
        "// The chart `Oven` (sfc) as structured text for CODESYS 3.5: one CASE for the active step. Written by cargo grafcet.",
        "FUNCTION valid : BOOL",
        "{warning 'valid is to be written'}",
        "FUNCTION_BLOCK Oven",
        "{region \"Back to the beginning\"}",
        "n := TO_USINT(n + 1);",
        "n := 3;",
        "IF valid(level := level) AND level > 5 AND n < 9 AND wide > 1 THEN",
        "{endregion}",
    ];
    has(&of(Flavour::Codesys), &codesys);
    let tia = [
        "// The chart `Oven` (sfc) as structured text for TIA Portal (SCL): one CASE for the active step. Written by cargo grafcet.",
        "// Numbers of 64 bits: an S7-1500 has them, an S7-1200 has not.",
        "FUNCTION \"valid\" : BOOL",
        "#valid := FALSE;",
        "FUNCTION_BLOCK \"FB_heat\"",
        "FUNCTION_BLOCK \"Oven\"",
        "{ S7_Optimized_Access := 'TRUE' }",
        "heat : \"FB_heat\";",
        "T_On {InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME; // how long On is active",
        "BEGIN",
        "REGION Back to the beginning",
        "#T_On(IN := #StepNo = 20, PT := T#24d20h31m23s647ms);",
        "IF \"valid\"(level := #level) AND #level > 5 AND #n < 9 AND #wide > 1 THEN",
        "IF #T_On.ET >= T#5s THEN",
        "#n := #n + 1;",
        "END_REGION",
    ];
    has(&of(Flavour::Tia), &tia);
    let iec = of(Flavour::Iec);
    assert!(!iec.contains(['{', '#', '"']) || iec.contains("T#"), "{iec}");
}

/// Bild 5 to 8: a flip-flop for each step and for the stored action, assignments for the continuous ones. A step is reset by the transition to its
/// successor and not by the successor's flag, which is one scan late.
#[test]
fn bild_5_to_8() {
    let text = program(LINE, Form::FlipFlops);
    let body = units(&text, Dialect::Iec).expect("structured text").pop().expect("a function block").body;
    let expected = "
        IF Init THEN
            SR_S1 := TRUE; SR_S2 := FALSE; SR_S3 := FALSE; SR_S4 := FALSE; Started := FALSE;
            q1 := FALSE; q2 := FALSE; q3 := FALSE;
        END_IF;
        Tr_1 := Started AND SR_S1 AND b1;
        Tr_2 := Started AND SR_S2 AND b2;
        Tr_3 := Started AND SR_S3 AND b3;
        Tr_4 := Started AND SR_S4 AND b4;
        SR_S1 := (SR_S1 OR Tr_4) AND NOT Tr_1;
        SR_S2 := (SR_S2 OR Tr_1) AND NOT Tr_2;
        SR_S3 := (SR_S3 OR Tr_2) AND NOT Tr_3;
        SR_S4 := (SR_S4 OR Tr_3) AND NOT Tr_4;
        q1 := SR_S1;
        q2_R := SR_S4;
        q2 := (q2 OR SR_S2) AND NOT q2_R;
        q3 := SR_S3 AND b5;
        Started := TRUE;";
    assert_eq!(body, statements(expected).expect("statements"), "{text}");
}

/// Sets inputs, makes a scan, and shows the values of these names.
fn scan(machine: &mut Machine, now: u64, inputs: &[(&str, bool)], shown: &[&str]) -> Vec<i128> {
    machine.now = now;
    for (name, value) in inputs {
        machine.set(name, Value::Bool(*value)).expect("an input");
    }
    machine.scan().expect("a scan");
    shown.iter().map(|name| machine.get(name).expect("a variable").number()).collect()
}

/// The CASE form acts, then evolves: P1 in the first scan of its step, P0 and the final scan with the transition, the time from the scan in which the step
/// was entered.
#[test]
fn a_timeline_of_the_case_form() {
    let chart = "sfc Mixer { input go: bool; output run: bool; output lit: bool; var starts: u8 = 0; var turns: u8 = 0; var ends: u8 = 0;
        initial step Idle { R lit; }
        step Mix { N run; S lit; P1 starts = starts + 1; N turns = turns + 1; P0 ends = ends + 1; }
        Idle -[go && ends < 200 && turns < 200 && starts < 200]-> Mix -[3s/Mix]-> Idle; }";
    let mut machine = Machine::new(&program(chart, Form::Case)).expect("understood");
    let names = ["StepNo", "run", "lit", "starts", "turns", "ends"];
    let mut scan = |now, go, init| scan(&mut machine, now, &[("go", go), ("Init", init)], &names);
    assert_eq!(scan(0, false, false), [10, 0, 0, 0, 0, 0]);
    // Entered at 1 s; it acts one scan later.
    assert_eq!(scan(1_000, true, false), [20, 0, 0, 0, 0, 0]);
    assert_eq!(scan(2_000, false, false), [20, 1, 1, 1, 1, 0]);
    assert_eq!(scan(3_999, false, false), [20, 1, 1, 1, 2, 0]);
    // Three seconds after it was entered: a turn, the final scan, P0; what is continuous is off, what is stored stays.
    assert_eq!(scan(4_000, false, false), [10, 0, 1, 1, 4, 1]);
    assert_eq!(scan(4_001, true, false), [20, 0, 0, 1, 4, 1]);
    assert_eq!(scan(4_002, false, false), [20, 1, 1, 2, 5, 1]);
    // Back to the beginning, with everything, and no P0.
    assert_eq!(scan(4_003, false, true), [10, 0, 0, 0, 0, 0]);
    // The time of the step does not go on from before.
    assert_eq!(scan(4_004, true, false), [20, 0, 0, 0, 0, 0]);
    assert_eq!(scan(7_003, false, false), [20, 1, 1, 1, 1, 0]);
    assert_eq!(scan(7_004, false, false), [10, 0, 1, 1, 3, 1]);
}

/// The same chart where the CASE form evolves first: a step acts in the scan in which it is entered, its final scan is the one in which it is left, and the first
/// scan only enters the initial step.
#[test]
fn a_timeline_of_the_case_form_that_evolves_first() {
    let chart = "sfc Mixer { input go: bool; output run: bool; output lit: bool; var starts: u8 = 0; var turns: u8 = 0; var ends: u8 = 0;
        initial step Idle { R lit; }
        step Mix { N run; S lit; P1 starts = starts + 1; N turns = turns + 1; P0 ends = ends + 1; }
        Idle -[go && ends < 200 && turns < 200 && starts < 200]-> Mix -[3s/Mix]-> Idle; }";
    let options = Options { order: Some(Order::EvolveFirst), ..Options::default() };
    let text = structured_text(&model(chart), &options).expect("a translation").text;
    let mut machine = Machine::new(&text).expect("understood");
    let names = ["StepNo", "run", "lit", "starts", "turns", "ends"];
    let mut scan = |now, go, init| scan(&mut machine, now, &[("go", go), ("Init", init)], &names);
    assert_eq!(scan(0, true, false), [10, 0, 0, 0, 0, 0]);
    assert_eq!(scan(1_000, true, false), [20, 1, 1, 1, 1, 0]);
    assert_eq!(scan(2_000, false, false), [20, 1, 1, 1, 2, 0]);
    assert_eq!(scan(3_999, false, false), [20, 1, 1, 1, 3, 0]);
    assert_eq!(scan(4_000, false, false), [10, 0, 0, 1, 4, 1]);
    assert_eq!(scan(4_001, true, true), [10, 0, 0, 0, 0, 0]);
    assert_eq!(scan(4_002, true, false), [20, 1, 1, 1, 1, 0]);
}

/// The condition of what is continuous sees what was there before the scan, which a CASE that evolves first does not keep.
#[test]
fn what_a_case_that_evolves_first_cannot() {
    let chart = "sfc Count { input go: bool; output lit: bool; var n: u8 = 0; initial step A;
        step B { P1 n = n + 1; N lit if n > 0; } A -[go && n < 200]-> B -[!go]-> A; }";
    let of = |order| structured_text(&model(chart), &Options { order, ..Options::default() });
    assert!(of(None).is_ok() && of(Some(Order::ActFirst)).is_ok());
    let refused = of(Some(Order::EvolveFirst)).expect_err("a value from before the scan");
    assert!(refused[0].to_string().starts_with("it reads `n` as it was before"), "{refused:?}");
}

/// Listed variants are numbers: their places in the list, in conditions, values and initial values, and beside the declaration stands which is which.
#[test]
fn listed_variants() {
    let chart = "sfc Drive { input go: bool; input mode: Mode in {Off, Auto, Manual} ; param first: Mode in {Off, Auto, Manual} = Mode::Auto; var last: Mode in {Off, Auto, Manual} = Mode::Manual;
        initial step Idle; step Run { P1 last = mode; }
        Idle -[go && mode != Mode::Off]-> Run -[mode == Mode::Off || last != mode && first == Mode::Auto]-> Idle; }";
    for form in [Form::Case, Form::FlipFlops] {
        let text = program(chart, form);
        for line in [
            "mode : INT; // Off = 0, Auto = 1, Manual = 2\n",
            "first : INT := 1; // parameter: Off = 0, Auto = 1, Manual = 2\n",
            "last : INT := 2; // Off = 0, Auto = 1, Manual = 2\n",
        ] {
            assert!(text.contains(line), "{line}{text}");
        }
    }
    let mut machine = Machine::new(&program(chart, Form::FlipFlops)).expect("understood");
    let mut cycle = |now, go, mode| {
        machine.set("mode", Value::Int(mode)).expect("an input");
        scan(&mut machine, now, &[("go", go), ("Init", false)], &["SR_Run", "last"])
    };
    assert_eq!(cycle(0, true, 1), [0, 2]);
    assert_eq!(cycle(100, true, 0), [0, 2]);
    assert_eq!(cycle(200, true, 2), [1, 2]);
    assert_eq!(cycle(300, true, 1), [0, 2]);
    assert_eq!(cycle(400, true, 1), [1, 1]);
    assert_eq!(cycle(500, false, 0), [0, 1]);
}

/// What blinks is told by the time of its step, to the millisecond: it begins on, whatever the scans are.
#[test]
fn what_blinks() {
    let chart =
        "sfc Lamp { input go: bool; output lit: bool; initial step Idle; step Run { lit if blink(700ms/300ms); }
        Idle -[go]-> Run -[!go]-> Idle; }";
    for (flavour, dialect) in FLAVOURS {
        let options = Options { form: Form::FlipFlops, flavour, ..Options::default() };
        let text = structured_text(&model(chart), &options).expect("a translation").text;
        let of = if flavour == Flavour::Tia { "#T_Run" } else { "T_Run" };
        assert!(text.contains(&format!("TIME_TO_DINT({of}.ET) MOD 1000 < 700")), "{text}");
        assert!(text.contains("// What blinks stands still"), "{text}");
        let mut machine = Machine::of(&text, dialect).expect("understood");
        let mut lit = |now, go| scan(&mut machine, now, &[("go", go), ("Init", false)], &["lit"])[0];
        let times = [0, 1_000, 1_699, 1_700, 1_999, 2_000, 2_650, 2_701, 12_699, 12_700];
        let shown = times.map(|now| lit(now, now > 0));
        assert_eq!(shown, [0, 1, 1, 0, 0, 1, 1, 0, 1, 0], "{text}");
        // It begins anew with the step.
        assert_eq!(
            [(12_900, false), (13_500, true), (14_199, true), (14_200, true)].map(|(now, go)| lit(now, go)),
            [0, 1, 1, 0]
        );
    }
}

/// Flip-flops have one order.
#[test]
fn flip_flops_evolve_first() {
    let of = |order| structured_text(&model(LINE), &Options { form: Form::FlipFlops, order, ..Options::default() });
    let text = |order| of(order).expect("a translation").text;
    assert_eq!(text(Some(Order::EvolveFirst)), text(None));
    let refused = of(Some(Order::ActFirst)).expect_err("an order that there is not");
    assert_eq!(refused.len(), 1);
    assert!(refused[0].to_string().starts_with("flip-flops evolve first: "), "{refused:?}");
}

/// The form of flip-flops evolves, then acts: a reset dominates a set of the same scan, SD counts on beyond its condition, a limit ends, P1 and P0 run once, and
/// values are those of the last step in the source.
#[test]
fn a_timeline_of_the_flip_flops() {
    let chart = "sfc Cell { #![allow(grafcet::conflicting_values)]
        input go, stop: bool; output q, kept, late, short: bool; output speed: u8 = 1; var ins: u8 = 0; var outs: u8 = 0;
        initial step A; step B { S q; S kept; SD 2s late; L 1s short; N speed = 5; P1 ins = ins + 1; P0 outs = outs + 1; }
        step E { R q; N speed = 7; } step F { R kept; R late; }
        A -[go && ins < 200 && outs < 200]-> (B, E); (B, E) -[!go]-> F -[stop]-> A; }";
    let mut machine = Machine::new(&program(chart, Form::FlipFlops)).expect("understood");
    let names = ["SR_A", "SR_B", "SR_E", "SR_F", "q", "kept", "late", "short", "speed", "ins", "outs"];
    let mut scan = |now, go, stop| scan(&mut machine, now, &[("go", go), ("stop", stop)], &names);
    // The first scan only enters the initial step.
    assert_eq!(scan(0, true, false), [1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0]);
    assert_eq!(scan(1_000, true, false), [0, 1, 1, 0, 0, 1, 0, 1, 7, 1, 0]);
    assert_eq!(scan(1_999, true, false), [0, 1, 1, 0, 0, 1, 0, 1, 7, 1, 0]);
    assert_eq!(scan(2_000, true, false), [0, 1, 1, 0, 0, 1, 0, 0, 7, 1, 0]);
    assert_eq!(scan(3_000, true, false), [0, 1, 1, 0, 0, 1, 1, 0, 7, 1, 0]);
    assert_eq!(scan(4_000, false, false), [0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1]);
    assert_eq!(scan(4_500, true, true), [1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1]);
    assert_eq!(scan(4_600, true, true), [0, 1, 1, 0, 0, 1, 0, 1, 7, 2, 1]);
}

/// A source transition is enabled without a step, a sink transition leaves none.
#[test]
fn sources_and_sinks_of_flip_flops() {
    let chart =
        "grafcet Feed { input part, go, gone: bool; output busy: bool; initial step Ready; step In { busy; } step Out;
        () -[rising(part)]-> In; (Ready, In) -[rising(go)]-> (Ready, Out); Out -[rising(gone)]-> (); }";
    let text = program(chart, Form::FlipFlops);
    assert!(text.contains("Tr_1 : BOOL; // () to In\n"), "{text}");
    let mut machine = Machine::new(&text).expect("understood");
    let names = ["SR_Ready", "SR_In", "SR_Out", "busy"];
    let mut scan = |part, go, gone| scan(&mut machine, 0, &[("part", part), ("go", go), ("gone", gone)], &names);
    assert_eq!(scan(false, false, false), [1, 0, 0, 0]);
    assert_eq!(scan(true, false, false), [1, 1, 0, 1]);
    assert_eq!(scan(true, false, false), [1, 1, 0, 1]);
    assert_eq!(scan(false, true, false), [1, 0, 1, 0]);
    // What is entered is active beside what is there.
    assert_eq!(scan(true, true, false), [1, 1, 1, 1]);
    assert_eq!(scan(false, false, true), [1, 1, 0, 1]);
    // Left and entered at once, it stays active.
    assert_eq!(scan(true, true, false), [1, 1, 1, 1]);
}

/// Partial grafcets stand beside each other and look at each other's steps.
#[test]
fn partial_grafcets_of_flip_flops() {
    let chart = "grafcet Cell { input a, b: bool; output p, q: bool;
        partial Left { initial step Ready; step Work { p; } Ready -[a && Idle.X]-> Work -[2s/Work]-> Ready; }
        partial Right { initial step Idle; step Run { q; } Idle -[b && !Left::Work.X]-> Run -[!b]-> Idle; } }";
    let mut machine = Machine::new(&program(chart, Form::FlipFlops)).expect("understood");
    let names = ["SR_Ready", "SR_Work", "SR_Idle", "SR_Run", "p", "q"];
    let mut scan = |now, a, b| scan(&mut machine, now, &[("a", a), ("b", b)], &names);
    assert_eq!(scan(0, true, true), [1, 0, 1, 0, 0, 0]);
    // Both look at the situation of the scan before.
    assert_eq!(scan(100, true, true), [0, 1, 0, 1, 1, 1]);
    assert_eq!(scan(2_000, true, false), [0, 1, 1, 0, 1, 0]);
    assert_eq!(scan(2_099, true, true), [0, 1, 1, 0, 1, 0]);
    assert_eq!(scan(2_100, false, true), [1, 0, 1, 0, 0, 0]);
    assert_eq!(scan(2_200, false, true), [1, 0, 0, 1, 0, 1]);
    assert_eq!(scan(2_300, true, true), [1, 0, 0, 1, 0, 1]);
}

/// What is on in the first scan has not risen, nor has it after `Init`.
#[test]
fn no_edge_at_the_beginning() {
    let chart = "grafcet Door { input a: bool; output q: bool; initial step Shut; step Open { q; }
        Shut -[rising(a)]-> Open -[falling(a)]-> Shut; }";
    for form in [Form::Case, Form::FlipFlops] {
        let mut machine = Machine::new(&program(chart, form)).expect("understood");
        let mut after = |a, init| {
            // Twice, so that what the step does shows in both forms.
            scan(&mut machine, 0, &[("a", a), ("Init", init)], &[]);
            scan(&mut machine, 0, &[("Init", false)], &["q"])[0]
        };
        assert_eq!(
            [after(true, false), after(false, false), after(true, false), after(true, false)],
            [0, 0, 1, 1],
            "{form:?}"
        );
        assert_eq!(
            [after(true, true), after(true, false), after(false, false), after(true, false)],
            [0, 0, 0, 1],
            "{form:?}"
        );
        assert_eq!(after(false, false), 0, "{form:?}");
    }
}

/// In a `grafcet` a stored action asks its condition, and a call its arguments, of variables too.
#[test]
fn conditions_over_variables() {
    let chart = "grafcet Batch { input a: bool; output q: u8; var m: u8 = 0; action tell(count: u8);
        initial step A { P1 m = 3; } step B { P1 q = 7 if m > 2; N tell(m) if m > 2; }
        A -[a]-> B -[!a]-> A; }";
    for form in [Form::Case, Form::FlipFlops] {
        let Ok(done) = structured_text(&model(chart), &Options { form, ..Options::default() }) else {
            assert_eq!(form, Form::Case, "whether the call has begun depends on a condition");
            continue;
        };
        let mut machine = Machine::new(&done.text).expect("understood");
        assert_eq!(scan(&mut machine, 0, &[("a", false)], &["q", "m"]), [0, 3]);
        assert_eq!(scan(&mut machine, 0, &[("a", true)], &["q", "m"]), [7, 3]);
        assert_eq!(
            machine.calls.iter().map(|call| call.arguments.clone()).collect::<Vec<_>>(),
            [[Value::Int(0), Value::Int(3)]]
        );
        assert_eq!(scan(&mut machine, 0, &[("a", true)], &["q", "m"]), [7, 3]);
        assert_eq!(
            machine.calls.iter().map(|call| call.arguments.clone()).collect::<Vec<_>>(),
            [[Value::Int(1), Value::Int(3)]]
        );
    }
}

/// Rust functions are functions to be written, code actions function blocks.
#[test]
fn functions_of_the_program() {
    let chart = "sfc Oven { input level: u16; output hot: bool; action heat(limit: i16); action beep();
        initial step Off { P1 beep(); } step On { N heat(80); hot; }
        Off -[limits::valid(level) && level > 5]-> On -[!limits::valid(level)]-> Off; }";
    for form in [Form::Case, Form::FlipFlops] {
        let done = structured_text(&model(chart), &Options { form, ..Options::default() }).expect("a translation");
        let names: Vec<&str> = done.to_write.iter().map(|(name, _)| name.as_str()).collect();
        let mut sorted = names.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, ["FB_beep", "FB_heat", "valid"], "{form:?}");
        assert!(done.to_write.iter().any(|(_, rust)| rust == "limits::valid(level)"), "{:?}", done.to_write);
        let mut machine = Machine::new(&done.text).expect("understood");
        // What the function returns.
        machine.world = |name, arguments| {
            assert_eq!(name, "valid");
            Value::Bool(arguments == [Value::Int(9)])
        };
        let mut calls: Vec<Vec<(String, Vec<i128>)>> = Vec::new();
        for level in [0, 9, 9, 9, 0, 0] {
            machine.set("level", Value::Int(level)).expect("an input");
            machine.scan().expect("a scan");
            calls.push(
                machine
                    .calls
                    .iter()
                    .map(|call| (call.instance.clone(), call.arguments.iter().map(|value| value.number()).collect()))
                    .collect(),
            );
        }
        let beep = || ("beep".to_owned(), vec![0]);
        let heat = |phase| ("heat".to_owned(), vec![phase, 80]);
        let expected: [Vec<(String, Vec<i128>)>; 6] = match form {
            // It beeps once, and enters the step; there it heats first, again, and in the scan in which it is left again and for the last time.
            Form::Case => [vec![beep()], vec![], vec![heat(0)], vec![heat(1)], vec![heat(1), heat(2)], vec![beep()]],
            Form::FlipFlops => {
                [vec![beep()], vec![heat(0)], vec![heat(1)], vec![heat(1)], vec![heat(2), beep()], vec![]]
            }
        };
        assert_eq!(calls, expected, "{form:?}");
    }
}
