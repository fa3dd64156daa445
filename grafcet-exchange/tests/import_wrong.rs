//! Files that are no charts, or none that anybody would write: what is wrong has its place, and nothing makes the reader panic.

use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::plant;
use grafcet_exchange::import::{Imported, Wrong, import};
use grafcet_exchange::plcopen::{Edition, Options, plcopen};

/// A station as somebody has written it.
const STATION: &str = include_str!("station.st");

fn notes(done: &Imported) -> Vec<&str> {
    done.charts.iter().flat_map(|chart| &chart.notes).map(|note| &*note.message).collect()
}

/// The place of what is wrong: the text under the mark.
fn wrong(text: &str) -> (String, String) {
    let Wrong { at, message } = import(text, "there").expect_err(text);
    (text[at].to_owned(), message)
}

#[test]
fn errors_have_their_place() {
    let missing = "PROGRAM P INITIAL_STEP S1: END_STEP TRANSITION FROM S1 TO S9 := TRUE; END_TRANSITION END_PROGRAM";
    assert_eq!(wrong(missing), ("TRANSITION FROM S1 TO S9".to_owned(), "there is no step `S9`".to_owned()));
    let open = "PROGRAM P INITIAL_STEP S1: q(N) END_STEP END_PROGRAM";
    assert_eq!(wrong(open), ("END_STEP".to_owned(), "expected `;`, found `END_STEP`".to_owned()));
    let twice = "PROGRAM P INITIAL_STEP S1: END_STEP STEP s1: END_STEP END_PROGRAM";
    assert_eq!(wrong(twice), ("s1".to_owned(), "there are two steps `s1`".to_owned()));
    let none = "FUNCTION_BLOCK F VAR a : BOOL; END_VAR a := TRUE; END_FUNCTION_BLOCK";
    assert_eq!(wrong(none).1, "there is no SFC in this file: no step");
    let comment = "PROGRAM P (* open";
    assert_eq!(wrong(comment).1, "this comment has no end `*)`");
    assert!(wrong("<project><a></project>").1.starts_with("this is no XML"));
    assert!(wrong("<html/>").1.starts_with("this is no PLCopen XML"));
    assert!(wrong("fn main() {}").1.starts_with("expected `PROGRAM`"));
    let sfc = |inside: &str| {
        format!("<project><pou name='P' pouType='program'><body><SFC>{inside}</SFC></body></pou></project>")
    };
    let double = sfc("<step localId='1' name='A'/><step localId='1' name='B'/>");
    assert_eq!(wrong(&double), ("<step".to_owned(), "two elements have the number 1".to_owned()));
}

/// Whatever is thrown at it, it answers.
#[test]
fn garbage() {
    let chart = "sfc C { input a, b: bool; output q, p: bool; output n: u8; initial step A { q if b; } step B { p; n = 3; } step E { L 2s p; } A -[rising(a)]-> (B, E); A -[b]-> A; (B, E) -[5s/B && !a]-> A; }";
    let mut sink = Sink::new();
    let model = plant::model(chart.parse().expect("tokens"), &mut sink).expect("a chart");
    _ = sink.finish();
    let xml = [Edition::Tc6, Edition::Iec61131Part10]
        .map(|edition| plcopen(&model, Options { edition, ..Options::default() }).expect("a translation").text);
    let words = include_str!("../../tests/imported/words.st");
    let blocks = include_str!("../../tests/imported/blocks.st");
    for text in [&*xml[0], &*xml[1], STATION, words, blocks] {
        for end in (0..text.len()).step_by(text.len() / 250 + 1) {
            if text.is_char_boundary(end) {
                _ = import(&text[..end], "there");
            }
        }
        let mut state = 1_u64;
        let mut random = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(state >> 33).unwrap_or(0) % below
        };
        let signs = [
            "<",
            ">",
            "\"",
            "&",
            "(",
            ")",
            ":",
            ";",
            ":=",
            "'",
            "(*",
            "0",
            "999999999999999999999999999999999999999999",
            "END_STEP",
            "é",
            "localId=\"1\"",
            "connectionPointOutId=\"1\"",
            "xsi:type=\"Step\"",
            "%",
            "T#",
            "#",
            ".",
        ];
        for _ in 0..250 {
            let mut changed = text.to_owned();
            for _ in 0..=random(3) {
                let (from, length) = (random(changed.len()), random(12));
                let to = (from + length).min(changed.len());
                if changed.is_char_boundary(from) && changed.is_char_boundary(to) {
                    changed.replace_range(from..to, signs[random(signs.len())]);
                }
            }
            if let Err(wrong) = import(&changed, "there") {
                assert!(changed.get(wrong.at.clone()).is_some(), "{wrong:?}\n{changed}");
            }
        }
    }
    let deep = format!(
        "PROGRAM P INITIAL_STEP A: END_STEP TRANSITION FROM A TO A := {}a{}; END_TRANSITION END_PROGRAM",
        "(".repeat(100_000),
        ")".repeat(100_000)
    );
    assert!(import(&deep, "there").is_ok_and(|done| notes(&done).len() == 1));
    let long = format!(
        "PROGRAM P INITIAL_STEP A: END_STEP TRANSITION FROM A TO A := a{}; END_TRANSITION END_PROGRAM",
        " OR a".repeat(100_000)
    );
    assert!(import(&long, "there").is_ok_and(|done| notes(&done).len() == 1));
    _ = import(&"<a>".repeat(100_000), "there");
}

/// Divergences that lead to each other, where nobody comes to an end.
#[test]
fn a_drawing_in_circles() {
    let lines: Vec<String> = (1..=30).map(|from| format!("<connection refLocalId='{from}'/>")).collect();
    let lines = format!("<connectionPointIn>{}</connectionPointIn>", lines.concat());
    let one = |id: usize| format!("<selectionDivergence localId='{id}'>{lines}</selectionDivergence>");
    let all = (1..=30).map(one).collect::<Vec<_>>().concat();
    let text = format!(
        "<project><pou name='P'><body><SFC><step localId='40' name='A'/>{all}<transition localId='50'>{lines}</transition></SFC></body></pou></project>"
    );
    assert_eq!(notes(&import(&text, "there.st").expect("a chart")), ["left out: a transition, as no step leads to it"]);
}
