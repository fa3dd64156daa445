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
    assert!(done.out.contains("SR_E := (SR_E OR Tr_1) AND NOT (Tr_2 AND NOT Tr_1);"), "{}", done.out);
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
