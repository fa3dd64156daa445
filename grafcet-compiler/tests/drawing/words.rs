//! What is written beside what is drawn: actions, comments, names.

use std::fmt::Write as _;

use grafcet_draw::{Heading, Shape};

use crate::{arrows, drawing};

fn texts(chart: &str) -> Vec<String> {
    let drawing = drawing(chart.parse().expect("tokens")).expect("a drawing");
    let text = |shape: Shape| if let Shape::Text { text, .. } = shape { Some(text) } else { None };
    drawing.shapes.into_iter().filter_map(text).collect()
}

/// One form for one thing, that of the standards; blocks are Rust.
#[test]
fn assignments_are_written_as_in_the_standards() {
    let body = |more: &str| {
        format!(
            "input a: bool; output grip, lamp: bool; var n: u16 = 0;
             initial step A {{ S grip; P1 n = n + 1; P0 {{ n = 3; }} }} step B {{ P1 grip = false; P0 lamp = true; }}
             step C {{ R grip; }} A -[a{more}]-> B -[!a]-> C -[a]-> A;"
        )
    };
    let grafcet = texts(&format!("grafcet G {{ {} }}", body(" => n = 0")));
    let sfc = texts(&format!("sfc S {{ {} }}", body("")));
    for shown in [&grafcet, &sfc] {
        for wanted in ["n := n + 1", "grip := 0", "lamp := 1", "{ n = 3; }"] {
            assert!(shown.iter().any(|text| text == wanted), "{wanted} in {shown:?}");
        }
        assert!(!shown.iter().any(|text| text.contains(" = false") || text.contains(" = true")), "{shown:?}");
    }
    assert_eq!(grafcet.iter().filter(|text| *text == "grip := 0").count(), 2, "P1 and R: {grafcet:?}");
    assert!(grafcet.contains(&"grip := 1".to_owned()) && grafcet.contains(&"⇒ n := 0".to_owned()), "{grafcet:?}");
    assert!(sfc.contains(&"grip".to_owned()), "S has its qualifier: {sfc:?}");
}

/// What a user says of a partial grafcet, an enclosure or a macro-step stands in its frame, its first paragraph.
#[test]
fn doc_comments_are_shown() {
    let shown = texts(
        "grafcet G { input a: bool; output q: bool;
         /// Watches the light curtain.
         ///
         /// Not drawn.
         partial Safety { initial step Ready { q; } Ready -[a]-> Stopped -[!a]-> Ready; step Stopped; }
         partial Work {
             initial step Wait; Wait -[a]-> Run -[!a]-> Open -[a]-> Wait;
             enclosing step Run {
                 /// Counts
                 /// parts.
                 partial Inner { linked step One; One -[a]-> Two -[a]-> One; step Two; }
             }
             /// Opens the clamp.
             macro step Open { entry step First; exit step Last; First -[a]-> Last; }
         } }",
    );
    for wanted in ["Watches the light curtain.", "Counts parts.", "Opens the clamp."] {
        assert!(shown.iter().any(|text| text == wanted), "{wanted} in {shown:?}");
    }
    assert!(!shown.iter().any(|text| text.contains("Not drawn")), "{shown:?}");
}

/// What a name stands for is listed beside the chart, with the first paragraph of its doc comment; also of one too large to be
/// drawn, and of one that nothing uses.
#[test]
fn named_conditions_are_listed() {
    let lets = "/// Somebody wants\n/// the next part.\n///\n/// Not drawn.\nlet go = auto || rising(next);
                #[allow(grafcet::unused_let)] let idle = !go;";
    let shown = |rest: &str| {
        texts(&format!(
            "sfc S {{ input auto, next: bool; {lets} initial step A; step B; {rest} A -[go]-> B -[!go]-> A; }}"
        ))
    };
    let (mut steps, mut chain) = (String::new(), String::new());
    for n in 1..152 {
        let _ = write!(steps, "step C{n}; ");
        let _ = write!(chain, "C{n} -[auto]-> ");
    }
    let many = format!("{steps} A -[next]-> {chain} A;");
    for shown in [shown(""), shown(&many)] {
        for wanted in ["go = auto || rising(next)", "Somebody wants the next part.", "idle = !go"] {
            assert!(shown.iter().any(|text| text == wanted), "{wanted} in {shown:?}");
        }
        assert!(!shown.iter().any(|text| text.contains("Not drawn")), "{shown:?}");
    }
}

/// What an `any` leaves stands above its transition; where it leads to a step above, a name does.
#[test]
fn any_is_a_connector() {
    let steps = "input a, b: bool; initial step A; step B; step C; A -[a]-> B -[!a]-> A; C -[a && !b]-> A;";
    let shown = texts(&format!("sfc S {{ {steps} any except B -[b]-> C; }}"));
    assert!(shown.contains(&"any except B".to_owned()) && shown.contains(&"b".to_owned()), "{shown:?}");
    let chart = format!("grafcet G {{ {steps} any -[home: b]-> A; A -[b]-> C; }}");
    let drawing = drawing(chart.parse().expect("tokens")).expect("a drawing");
    assert_eq!((arrows(&drawing, Heading::Down), arrows(&drawing, Heading::Left)), (1, 1));
    let shown = texts(&chart);
    assert_eq!(["any", "home"].map(|word| shown.iter().filter(|text| *text == word).count()), [1, 2], "{shown:?}");
}

/// The words that there is one more take as much room as the last one.
#[test]
fn a_last_single_line_is_shown() {
    use grafcet_core::description::{Description, Dialect, Partial, Step, Transition};
    let overview = |count: usize| {
        let names: Vec<String> = (0..count).map(|n| format!("Part{n}")).collect();
        let partials: Vec<Partial<'_>> = names.iter().map(|name| Partial::new(name)).collect();
        let steps: Vec<Step<'_>> = (0..151).map(|n| Step::new("S", n % count, &[], &[])).collect();
        let chart = Description {
            name: "Large",
            dialect: Dialect::Grafcet,
            partials: &partials,
            macros: &[],
            steps: &steps,
            transitions: &[],
            lets: &[],
        };
        grafcet_draw::text(&chart, &())
    };
    assert!(overview(61).contains("Part60") && !overview(61).contains("more"), "{}", overview(61));
    assert!(overview(62).contains("and 2 more"), "{}", overview(62));
    let condition = |words: usize| {
        let words: Vec<String> = (0..words).map(|n| format!("a_condition_of_many_letters_{n:02}")).collect();
        let condition = words.join(" ");
        let transitions = [Transition::new("", &[0], &[], &condition, &[])];
        let chart = Description {
            name: "Long",
            dialect: Dialect::Grafcet,
            partials: &[Partial::new("")],
            macros: &[],
            steps: &[Step::new("S", 0, &[], &[])],
            transitions: &transitions,
            lets: &[],
        };
        grafcet_draw::text(&chart, &())
    };
    assert!(condition(6).contains("letters_05") && !condition(6).contains('…'), "{}", condition(6));
    assert!(condition(7).contains("letters_04…") && !condition(7).contains("letters_05"), "{}", condition(7));
}
