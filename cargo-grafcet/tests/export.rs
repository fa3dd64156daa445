//! What `export` writes, and by which exit code.

mod common;

use std::fs;

use common::{folder, tool};

const PRESS: &str = "grafcet! {
    sfc Press {
        input go, top, bottom: bool;
        output down: bool;
        initial step Up;
        step Down { down; }
        Up -[go && top]-> Down -[bottom]-> Up;
        never Up.X && Down.X && Ram::Bottom.X;
    }
    plant Ram {
        input down: bool;
        output top, bottom: bool;
        initial step Top { top; }
        step Bottom { bottom; }
        Top -[down]-> Bottom -[!down]-> Top;
    }
}
grafcet! {
    sfc Both {
        input a: bool;
        initial step A;
        step B;
        step E;
        A -[a]-> (B, E);
        (B, E) -[!a]-> A;
    }
}
grafcet! { sfc Broken { initial step A; A -[true]-> Nowhere; } }
";

/// The plant is no part of the program; a property that only a solver decides is said to be open, and holds nothing up.
#[test]
fn a_chart_with_a_plant() {
    let folder = folder(&[("press.rs", PRESS)]);
    let done = tool(folder.path(), &["export", "st", "press.rs", "--chart", "Press"]);
    let inputs = done.out.split("VAR_INPUT\n").nth(1).and_then(|rest| rest.split("END_VAR").next()).unwrap_or_default();
    let names: Vec<&str> = inputs.lines().filter_map(|line| line.trim().split(' ').next()).collect();
    assert_eq!(names, ["Init", "go", "top", "bottom"], "{done:?}");
    assert!(done.err.starts_with("error[grafcet::property_undecided]"), "{}", done.err);
}

#[test]
fn what_has_no_translation_is_shown_at_its_place() {
    let folder = folder(&[("press.rs", PRESS)]);
    let done = tool(folder.path(), &["export", "st", "press.rs", "--chart", "Both"]);
    assert_eq!((done.code, done.out.as_str()), (Some(1), ""));
    let lines: Vec<&str> = done.err.lines().collect();
    assert_eq!(
        lines[..2],
        [
            "error: Both has no translation: the CASE form has one number for the active step, and `B` and `E` can be active together: use the form of flip-flops",
            "  --> press.rs:22:14"
        ]
    );
    let done = tool(folder.path(), &["export", "st", "press.rs", "--chart", "Both", "--form", "flip-flops"]);
    assert_eq!(done.code, Some(0), "{done:?}");
    assert!(done.out.contains("SR_E := SR_E AND NOT Tr_2 OR Tr_1;"), "{}", done.out);
}

#[test]
fn to_a_folder_as_far_as_it_goes() {
    let folder = folder(&[("press.rs", PRESS)]);
    let done =
        tool(folder.path(), &["export", "pnml", "press.rs", "--chart", "Both", "--chart", "Broken", "--out", "nets"]);
    assert_eq!((done.code, done.out.as_str()), (Some(1), "nets/Both.pnml\n"));
    assert!(done.err.starts_with("error[grafcet::unknown_step]"), "{}", done.err);
    assert!(
        fs::read_to_string(folder.path().join("nets/Both.pnml")).is_ok_and(|net| net.contains("<place id=\"s3\">"))
    );
}

/// The numbers, the name of the step and that of the input are the user's wish.
#[test]
fn names_and_numbers() {
    let folder = folder(&[("press.rs", PRESS)]);
    let words = ["--first", "1", "--by", "1", "--step", "schrittnummer", "--init", "Start"];
    let done = tool(folder.path(), &[&["export", "st", "press.rs", "--chart", "Press"], &words[..]].concat());
    for part in
        ["  Start : BOOL;", "IF Start THEN", "CASE schrittnummer OF\n  1: // Up, initial", "schrittnummer := 2;"]
    {
        assert!(done.out.contains(part), "{part}: {done:?}");
    }
    assert_eq!(tool(folder.path(), &["export", "st", "press.rs", "--chart", "Press", "--by", "0"]).code, Some(2));
}

/// What could not be translated has its place, what is to be written its name.
#[test]
fn one_json_object_a_chart() {
    const CALLS: &str = "grafcet! { sfc Calls { input level: i16; output lit: bool; initial step Off; step Lit { lit; } Off -[high(level)]-> Lit -[level < 3]-> Off; } }";
    let folder = folder(&[("press.rs", PRESS), ("calls.rs", CALLS)]);
    let objects = |arguments: &[&str], code: i32| -> Vec<serde_json::Value> {
        let done = tool(folder.path(), &[&["export", "st", "--json"], arguments].concat());
        assert_eq!(done.code, Some(code), "{done:?}");
        done.out.lines().map(|line| serde_json::from_str(line).expect("an object")).collect()
    };
    let [calls] = &objects(&["calls.rs"], 0)[..] else { panic!("one chart") };
    assert_eq!((calls["chart"].as_str(), calls["file"].as_str()), (Some("Calls"), Some("calls.rs")));
    let said = tool(folder.path(), &["export", "st", "calls.rs"]);
    assert_eq!(calls["text"], said.out);
    assert_eq!(calls["to_write"].as_array().map(Vec::len), Some(1));
    assert_eq!(calls["to_write"][0]["name"], "high");
    assert_eq!(calls["refused"], serde_json::json!([]));
    let [both, broken] = &objects(&["press.rs", "--chart", "Both", "--chart", "Broken"], 1)[..] else {
        panic!("two charts")
    };
    assert!(both["text"].is_null());
    let refused = &both["refused"][0];
    // As it is shown to people: press.rs:22:14.
    assert_eq!((&refused["start"]["line"], &refused["start"]["column"]), (&22.into(), &14.into()));
    let bytes = |end: usize| usize::try_from(refused["bytes"][end].as_u64().expect("a place")).expect("a place");
    assert_eq!(&PRESS[bytes(0)..bytes(1)], "B");
    // What does not compile has no translation; why is said beside it.
    assert_eq!((&broken["text"], &broken["refused"]), (&serde_json::Value::Null, &serde_json::json!([])));
    assert_eq!(tool(folder.path(), &["export", "pnml", "press.rs", "--json", "--out", "nets"]).code, Some(2));
}

#[test]
fn for_a_tool_and_in_an_order() {
    let folder = folder(&[("press.rs", PRESS)]);
    let export =
        |more: &[&str]| tool(folder.path(), &[&["export", "st", "press.rs", "--chart", "Press"], more].concat());
    let done = export(&["--for", "tia", "--out", "scl"]);
    assert_eq!((done.code, done.out.as_str()), (Some(0), "scl/Press.scl\n"), "{done:?}");
    let text = fs::read_to_string(folder.path().join("scl/Press.scl")).expect("a file");
    assert!(text.contains("FUNCTION_BLOCK \"Press\"\n") && text.contains("IF #go AND #top THEN"), "{text}");
    let done = export(&["--for", "codesys"]);
    assert!(done.out.contains("{region \"The sequence\"}\nCASE StepNo OF"), "{}", done.out);
    let done = export(&["--order", "evolve-first"]);
    let [first, act] = ["// Transitions, but in the first scan", "// Actions\nCASE"].map(|part| done.out.find(part));
    assert!(first.is_some() && first < act, "{}", done.out);
    assert_eq!(export(&["--order", "act-first"]).out, export(&[]).out);
    let done = export(&["--form", "flip-flops", "--order", "act-first"]);
    let said = "error: Press has no translation: flip-flops evolve first: ";
    assert!(done.code == Some(1) && done.err.contains(said), "{done:?}");
}

/// The circuit is the one of the prover, with the plant: each step that it can be in is there.
#[test]
fn circuits() {
    let folder = folder(&[("press.rs", PRESS)]);
    let run = |arguments: &[&str]| tool(folder.path(), arguments);
    let read = |file: &str| fs::read_to_string(folder.path().join(file)).expect(file);
    for (notation, option, file) in [("aiger", "--aiger", "press.aag"), ("btor2", "--btor2", "press.btor2")] {
        let done = run(&["export", notation, "press.rs", "--chart", "Press"]);
        assert_eq!((done.code, done.err.as_str()), (Some(0), ""), "{notation}: {done:?}");
        assert_eq!(run(&["prove", "press.rs", "--chart", "Press", option, file]).code, Some(0));
        assert_eq!(done.out, read(file), "{notation}");
        let json = run(&["export", notation, "press.rs", "--chart", "Press", "--json"]);
        let object: serde_json::Value = serde_json::from_str(json.out.trim_end()).expect("an object");
        assert_eq!((object["text"].as_str(), &object["refused"]), (Some(&*done.out), &serde_json::json!([])));
        let done = run(&["export", notation, "press.rs", "--chart", "Broken"]);
        assert!(
            done.code == Some(1) && done.out.is_empty() && done.err.contains("--> press.rs:"),
            "{notation}: {done:?}"
        );
        let done = run(&["export", notation, "press.rs", "--out", "all"]);
        let ending = file.split('.').next_back().expect("an ending");
        assert_eq!((done.code, done.out), (Some(1), format!("all/Press.{ending}\nall/Both.{ending}\n")));
    }
    assert!(read("press.aag").starts_with("aag "));
    assert!(read("press.btor2").contains(" bad "));
}

/// A property that is open holds no circuit up; what the chart does wrong does, and is said once.
#[test]
fn no_circuit_of_a_chart_that_has_errors() {
    let dead = "grafcet! { sfc Dead { input a: bool; never B.X; initial step A; step B; step C; A -[a]-> B -[!a]-> A; C -[a]-> A; } }";
    let folder = folder(&[("dead.rs", dead)]);
    for notation in ["aiger", "btor2"] {
        let done = tool(folder.path(), &["export", notation, "dead.rs"]);
        assert_eq!((done.code, done.out.as_str()), (Some(1), ""), "{notation}: {done:?}");
        assert!(done.err.contains("unreachable_step") && !done.err.contains("property_violated"), "{}", done.err);
        assert_eq!(done.err.matches("--> dead.rs:").count(), done.err.matches("error[").count(), "{}", done.err);
    }
}

/// Both editions hold the same chart.
#[test]
fn editions_of_plcopen() {
    let folder = folder(&[("press.rs", PRESS)]);
    let export = |edition: &[&str], file: &str| {
        let words = [&["export", "plcopen", "press.rs", "--chart", "Both", "-o", file], edition].concat();
        assert_eq!(tool(folder.path(), &words).code, Some(0), "{words:?}");
        let text = fs::read_to_string(folder.path().join(file)).expect("a file");
        let back = tool(folder.path(), &["import", file]);
        assert_eq!(back.code, Some(0), "{back:?}");
        (text, back.out.replace(file, "FILE"))
    };
    let (tc6, from_tc6) = export(&[], "both.xml");
    let (same, _) = export(&["--edition", "tc6"], "same.xml");
    let (part10, from_part10) = export(&["--edition", "iec61131-10"], "both10.xml");
    assert!(tc6.contains("http://www.plcopen.org/xml/tc6_0201") && tc6 == same);
    assert!(part10.contains("www.iec.ch/public/TC65SC65BWG7TF10"), "{part10}");
    assert_eq!(from_tc6, from_part10);
    assert_eq!(tool(folder.path(), &["export", "plcopen", "press.rs", "--edition", "tc7"]).code, Some(2));
}
