//! Charts of PLC tools in Rust: what is made of them is worked out by hand. What is no chart: `import_wrong.rs`.

use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::plant;
use grafcet_exchange::import::{Imported, import};

fn imported(text: &str) -> Imported {
    import(text, "there.st").unwrap_or_else(|wrong| panic!("{wrong:?}"))
}

/// What stands after `use`, each line without its indent.
fn source(done: &Imported) -> Vec<&str> {
    let begin = done.rust.find("grafcet! {").expect("a call");
    done.rust[begin..].lines().map(str::trim).filter(|line| !line.is_empty()).collect()
}

fn expect(text: &str, expected: &str) {
    let done = imported(text);
    let expected: Vec<&str> = expected.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    assert_eq!(source(&done), expected, "{}", done.rust);
}

fn notes(done: &Imported) -> Vec<&str> {
    done.charts.iter().flat_map(|chart| &chart.notes).map(|note| &*note.message).collect()
}

/// A station as somebody has written it: names in capitals, comments, an address, a timer, an edge, branches whose priorities are not in their order.
const STATION: &str = include_str!("station.st");

#[test]
fn a_station() {
    expect(
        STATION,
        "grafcet! {
        /// The drilling station.
        pub sfc DrillStation {
        /// the button
        input x_start: bool;
        input part, down: bool;
        param soak_time: time = 1m30s;
        output motor: bool;
        /// At %QX0.1.
        output lamp: bool;
        var count: i16 = 5;
        /// nothing moves
        initial step InitState;
        step Drill { motor; SD 2s lamp; }
        step Watch {
        P1 {
        if down {
        count = count + 1;
        } else {
        count = 0;
        }
        }
        }
        step Reject { R lamp; }
        InitState -[rising(x_start) && part]-> (Drill, Watch);
        InitState -[x_start]-> Reject -[!part]-> InitState;
        // both are ready
        (Drill, Watch) -[soak_time/Drill && (down || count % 3 == 0)]-> Reject;
        }
        }",
    );
    let done = imported(STATION);
    assert!(notes(&done).is_empty(), "{:?}", notes(&done));
    let renamed = |name: &str| done.charts[0].renamed.iter().find(|(there, _)| there == name).map(|(_, here)| &**here);
    assert_eq!(
        ["DRILL_STATION", "xStart", "INIT_STATE", "Drill"].map(renamed),
        [Some("DrillStation"), Some("x_start"), Some("InitState"), None]
    );
}

/// What is made of it the compiler takes.
#[test]
fn it_is_a_chart() {
    let done = imported(STATION);
    let begin = done.rust.find("grafcet! {").expect("a call") + "grafcet! {".len();
    let end = done.rust.rfind('}').expect("an end");
    let mut sink = Sink::new();
    let model = plant::model(done.rust[begin..end].parse().expect("tokens"), &mut sink);
    assert!(model.is_some());
    let said = sink.finish();
    assert!(said.is_empty(), "{said:?}");
}

/// Whatever has no translation is a stub with its text, and said.
#[test]
fn stubs() {
    let done = imported(
        "PROGRAM P
        VAR_INPUT a : BOOL; n : INT; END_VAR
        VAR q : BOOL; T1 : TP; END_VAR
        INITIAL_STEP S1: Work(N); q(N); none(N); END_STEP
        TRANSITION FROM S1 TO S2 := T1.Q; END_TRANSITION
        STEP S2: END_STEP
        TRANSITION FROM S2 TO S1 := SQRT(n) > 3; END_TRANSITION
        ACTION Work: IF q THEN RETURN; END_IF; END_ACTION
        END_PROGRAM",
    );
    let rust = &done.rust;
    for wanted in [
        "action work();",
        "/// To be written: `Work` was structured text\n        ///     IF q THEN RETURN; END_IF;",
        "initial step S1 { N work(); q; }",
        "S1 -[s1_to_s2()]-> S2 -[s2_to_s1()]-> S1;",
        "/// To be written: the condition from S1 to S2, which was\n///     T1.Q;\nfn s1_to_s2() -> bool {\n    todo!(",
        "///     SQRT(n) > 3;\nfn s2_to_s1() -> bool {",
    ] {
        assert!(rust.contains(wanted), "{wanted}\n{rust}");
    }
    let all = notes(&done);
    for (note, wanted) in all.iter().zip([
        "`T1` of type TP is left out",
        "`none` is neither an action nor a boolean",
        "`s1_to_s2` is a function to be written",
        "`s2_to_s1` is a function",
        "`Work` is a code action",
    ]) {
        assert!(note.starts_with(wanted), "{all:?}");
    }
    assert_eq!(all.len(), 5, "{all:?}");
}

/// The standard's final call of an action that goes on is none of the blocks that two steps have; a time counts only while its step is active.
#[test]
fn what_differs_is_said() {
    let done = imported(
        "PROGRAM P VAR_INPUT a : BOOL; END_VAR VAR n : INT; END_VAR
        INITIAL_STEP S1: Up(N); END_STEP STEP S2: Up(N); END_STEP STEP S3: END_STEP
        TRANSITION FROM S1 TO S2 := a; END_TRANSITION
        TRANSITION FROM S2 TO S3 := S1.T >= T#2s; END_TRANSITION
        TRANSITION FROM S3 TO S1 := NOT a; END_TRANSITION
        ACTION Up: n := n + 1; END_ACTION END_PROGRAM",
    );
    let all = notes(&done);
    assert!(all.iter().any(|note| note.starts_with("`Up` goes on from `S1` to `S2` in the file")), "{all:?}");
    assert!(all.contains(&"`S1.T` is zero here while the step is not active"), "{all:?}");
}

/// What is assigned in one step and switched by its qualifier in another is assigned in both.
#[test]
fn switched_and_assigned() {
    let done = imported(
        "PROGRAM P VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q, p : BOOL; END_VAR
        INITIAL_STEP S1: Off(P1); p(N); END_STEP STEP S2: q(N); END_STEP STEP S3: q(R); q(S); END_STEP
        TRANSITION FROM S1 TO S2 := a; END_TRANSITION
        TRANSITION FROM S2 TO S3 := NOT a; END_TRANSITION
        TRANSITION FROM S3 TO S1 := a; END_TRANSITION
        ACTION Off: q := 0; END_ACTION END_PROGRAM",
    );
    for wanted in [
        "initial step S1 { P1 q = false; p; }",
        "step S2 { P1 q = true; P0 q = false; }",
        "step S3 { P1 q = false; P1 q = true; }",
    ] {
        assert!(done.rust.contains(wanted), "{wanted}\n{}", done.rust);
    }
    assert_eq!(notes(&done).len(), 3, "{:?}", notes(&done));
}

/// A copy is the memory of an edge only where nobody reads it otherwise.
#[test]
fn a_copy_that_is_read_as_it_is() {
    let text = |condition: &str| {
        format!(
            "PROGRAM P VAR_INPUT a : BOOL; END_VAR VAR old : BOOL; END_VAR
            INITIAL_STEP S1: Keep(N); END_STEP STEP S2: Keep(N); END_STEP
            TRANSITION FROM S1 TO S2 := a AND NOT old; END_TRANSITION
            TRANSITION FROM S2 TO S1 := {condition}; END_TRANSITION
            ACTION Keep: old := a; END_ACTION END_PROGRAM"
        )
    };
    let edge = imported(&text("NOT a AND old"));
    assert!(edge.rust.contains("S1 -[rising(a)]-> S2 -[falling(a)]-> S1;"), "{}", edge.rust);
    let copy = imported(&text("old"));
    assert!(copy.rust.contains("step S2 { N old = a; }"), "{}", copy.rust);
    assert!(copy.rust.contains("S1 -[a && !old]-> S2 -[old]-> S1;"), "{}", copy.rust);
}

/// Conditions drawn as contacts and blocks, by name and beside the chart; negated wherever that can stand. What holds more than a condition is a stub.
#[test]
fn conditions_of_networks() {
    let line = |from: usize| format!("<connectionPointIn><connection refLocalId='{from}'/></connectionPointIn>");
    let transition = |id: usize, from: usize, condition: &str| {
        format!("<transition localId='{id}'>{}<condition{condition}</condition></transition>", line(from))
    };
    let jump = |id: usize, from: usize, to: &str| {
        format!("<jumpStep localId='{id}' targetName='{to}'>{}</jumpStep>", line(from))
    };
    let contact = |id: usize, name: &str, negated: bool, from: usize| {
        format!("<contact localId='{id}' negated='{negated}'>{}<variable>{name}</variable></contact>", line(from))
    };
    let pin = |from: usize| format!("<variable formalParameter='IN{from}'>{}</variable>", line(from));
    let block = |id: usize, kind: &str, more: &str, from: [usize; 2]| {
        let pins = from.map(pin).concat();
        format!("<block localId='{id}' typeName='{kind}'{more}><inputVariables>{pins}</inputVariables></block>")
    };
    let value = |id: usize, name: &str| {
        format!("<inVariable localId='{id}' negated='false'><expression>{name}</expression></inVariable>")
    };
    let steps = ["S1", "S2", "S3", "S4"]
        .iter()
        .zip(1..)
        .map(|(name, id)| format!("<step localId='{id}' name='{name}' initialStep='{}'/>", id == 1));
    let sfc = [
        steps.collect::<Vec<_>>().concat(),
        // a and not b in a row of contacts
        "<leftPowerRail localId='20'/>".to_owned() + &contact(21, "a", false, 20) + &contact(22, "b", true, 21),
        transition(11, 1, &format!(">{}", line(22))) + &jump(31, 11, "S2"),
        // not (a xor b) by name
        transition(12, 2, " negated='true'><reference name='Differ'/>") + &jump(32, 12, "S3"),
        // a or b
        value(23, "a") + &value(24, "b") + &block(25, "OR", "", [23, 24]),
        transition(13, 3, &format!(">{}", line(25))) + &jump(33, 13, "S4"),
        // a flip-flop is more than a condition
        block(26, "SR", " instanceName='SR0'", [23, 24]),
        transition(14, 4, &format!(">{}", line(26))) + &jump(34, 14, "S1"),
        transition(15, 4, " negated='true'><inline name=''><ST><p>a OR b;</p></ST></inline>") + &jump(35, 15, "S2"),
    ];
    let named = value(1, "a")
        + &value(2, "b")
        + &block(3, "XOR", "", [1, 2])
        + &format!("<outVariable localId='4' negated='false'>{}<expression>differ</expression></outVariable>", line(3));
    let text = format!(
        "<project><types><pous><pou name='P' pouType='program'><interface><inputVars><variable name='a'><type><BOOL/></type></variable><variable name='b'><type><BOOL/></type></variable></inputVars></interface><transitions><transition name='Differ'><body><FBD>{named}</FBD></body></transition></transitions><body><SFC>{}</SFC></body></pou></pous></types></project>",
        sfc.concat()
    );
    let done = imported(&text);
    let lines = source(&done);
    let expected = ["S1 -[a && !b]-> S2 -[!(a ^ b)]-> S3 -[a || b]-> S4 -[s4_to_s1()]-> S1;", "S4 -[!(a || b)]-> S2;"];
    for line in expected {
        assert!(lines.contains(&line), "{line}\n{}", done.rust);
    }
    assert!(
        done.rust
            .contains("///     block 26 SR SR0, from 23 and 24\n///     inVariable 23: a\n///     inVariable 24: b"),
        "{}",
        done.rust
    );
}

/// Comments within bodies and in front of actions stay with what the steps do.
#[test]
fn comments_in_bodies() {
    let text = "PROGRAM P VAR_INPUT a : BOOL; END_VAR VAR n, m : INT; END_VAR
        INITIAL_STEP Up: Count(P1); END_STEP
        TRANSITION FROM Up TO Down := a; END_TRANSITION
        STEP Down: Both(P1); END_STEP
        TRANSITION FROM Down TO Up := NOT a; END_TRANSITION
        (* one more *)
        ACTION Count: n := n + 1; // never too many
        END_ACTION
        ACTION Both:
          (* first this,
             then that *)
          n := 0; m := n; { a pragma }
        END_ACTION END_PROGRAM";
    expect(
        text,
        "grafcet! {
        pub sfc P {
        input a: bool;
        var n, m: i16;
        initial step Up {
        // one more
        // never too many
        P1 n = n + 1;
        }
        step Down {
        // first this,
        // then that
        P1 {
        n = 0;
        m = n;
        }
        }
        Up -[a]-> Down -[!a]-> Up;
        }
        }",
    );
}

/// What has no translation is a stub with all of its text, said at its place; nothing is lost and nothing is an error.
#[test]
fn what_has_no_translation_is_kept() {
    let text = "TYPE Colour : (Dark, Green, Red); END_TYPE
TYPE Axis : STRUCT pos : INT; ok : BOOL; END_STRUCT END_TYPE
PROGRAM Odd
VAR_INPUT start : BOOL; level : ARRAY[0..3] OF INT; axis : Axis; col : Colour; name : STRING[20]; w : WORD; END_VAR
VAR_OUTPUT q : BOOL; n : INT; END_VAR
VAR i : INT; buf : ARRAY[0..9] OF INT; END_VAR
INITIAL_STEP Init: END_STEP
TRANSITION FROM Init TO Work := start AND level[2] > 5; END_TRANSITION
STEP Work: Act(N); q(N); END_STEP
TRANSITION FROM Work TO Rest := axis.ok AND col = Red; END_TRANSITION
STEP Rest: Loops(P1); Repeats(P1); Parts(P0); END_STEP
TRANSITION FROM Rest TO Init := name = 'done' OR w.3; END_TRANSITION
ACTION Act: (* why *) CASE n OF 1: q := TRUE; // first
  2..4: q := name = 'x'; ELSE n := 0; END_CASE; END_ACTION
ACTION Loops: FOR i := 0 TO 9 DO buf[i] := 0; END_FOR; WHILE n > 0 DO n := n - 1; END_WHILE; END_ACTION
ACTION Repeats: REPEAT n := n + 1; IF q THEN CONTINUE; END_IF; UNTIL n > 5 END_REPEAT; END_ACTION
ACTION Parts: axis.pos := 3; buf[0] := level[1]; END_ACTION
END_PROGRAM
";
    let done = imported(text);
    // All of the text, line by line.
    let rust: String =
        done.rust.lines().map(|line| line.trim().trim_start_matches("///").trim()).collect::<Vec<_>>().join(" ");
    for part in [
        "(* why *) CASE n OF 1: q := TRUE; // first 2..4: q := name = 'x'; ELSE n := 0; END_CASE;",
        "FOR i := 0 TO 9 DO buf[i] := 0; END_FOR; WHILE n > 0 DO n := n - 1; END_WHILE;",
        "REPEAT n := n + 1; IF q THEN CONTINUE; END_IF; UNTIL n > 5 END_REPEAT;",
        "axis.pos := 3; buf[0] := level[1];",
        "start AND level[2] > 5;",
        "axis.ok AND col = Red;",
        "name = 'done' OR w.3;",
    ] {
        assert!(rust.contains(part), "{part}\n{}", done.rust);
    }
    let notes: Vec<(&str, &str)> = done
        .charts
        .iter()
        .flat_map(|chart| &chart.notes)
        .map(|note| (&*note.message, &text[note.at.clone()]))
        .collect();
    let at = |begin: &str, place: &str| {
        let found = notes.iter().find(|(message, _)| message.starts_with(begin));
        assert!(found.is_some_and(|(_, at)| at.trim_start().starts_with(place)), "{begin} at {place}: {notes:#?}");
    };
    for (name, ty) in [("level", "ARRAY"), ("axis", "Axis"), ("name", "STRING"), ("buf", "ARRAY")] {
        at(&format!("`{name}` of type {ty}"), name);
    }
    at("`Act` is a code action to be written in Rust: expected a value, found the text 'x'", "(* why *)");
    at(
        "`Loops` is a code action to be written in Rust: expected `:=`, or a call: other statements are not translated, found `[`",
        "FOR",
    );
    at("`Repeats` is a code action to be written in Rust: `CONTINUE` within `REPEAT`", "REPEAT");
    at("`Parts` is a code action to be written in Rust: ", "axis.pos");
    at("`init_to_work` is a function to be written in Rust: ", "start AND");
    at("`work_to_rest` is a function to be written in Rust: `axis.ok` is a part of something", "axis.ok");
    at("`rest_to_init` is a function to be written in Rust: expected a value, found the text 'done'", "name = ");
    // And the chart is one.
    let begin = done.rust.find("grafcet! {").expect("a call");
    assert!(done.rust[begin..].parse::<proc_macro2::TokenStream>().is_ok(), "{}", done.rust);
}

/// What the file shares with others is written here as an output; that others write it, too, is said.
#[test]
fn what_belongs_to_others_too() {
    let text = "FUNCTION_BLOCK Counts
VAR_INPUT go : BOOL; END_VAR
VAR_IN_OUT total, limit : INT; END_VAR
VAR_EXTERNAL alarm, mode : BOOL; END_VAR
INITIAL_STEP Rest: END_STEP
STEP Run: Count(P1); alarm(S); END_STEP
TRANSITION FROM Rest TO Run := go AND total < limit; END_TRANSITION
TRANSITION FROM Run TO Rest := NOT go OR mode; END_TRANSITION
ACTION Count: total := total + 1; END_ACTION
END_FUNCTION_BLOCK
";
    let done = imported(text);
    for declared in ["input mode: bool;", "input limit: i16;", "output total: i16;", "output alarm: bool;"] {
        assert!(done.rust.contains(declared), "{declared}\n{}", done.rust);
    }
    let notes: Vec<&str> = done.charts[0].notes.iter().map(|note| &*note.message).collect();
    let seen = "is an output: what others write to it is not seen; what the chart has to know of that is an input";
    assert_eq!(notes, [format!("`total`, an in-out variable, {seen}"), format!("`alarm`, a global variable, {seen}")]);
}
