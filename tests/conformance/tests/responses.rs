//! Properties over more than one cycle: `leads_to`, with a limit and without, `before`, and what is assumed for them.

use std::time::Duration;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_compiler::program::counted;
use grafcet_conformance::prove::{Bounds, Counts, Kind, number};
use grafcet_prove::aig::Lit;
use grafcet_prove::circuit::{Circuit, Condition};

use grafcet_prove::{Limit, Verdict, certificate, decide, decide_live};

fn read(text: &str) -> Model {
    let mut sink = Sink::new();
    let tokens = text.parse().expect("tokens");
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink)).expect("a chart");
    let wrong = sink.finish().into_iter().find(|message| message.rule.is_none());
    assert!(wrong.is_none(), "{:?}", wrong.map(|message| message.notes));
    model
}

/// `proved`, `in 3` for the last cycle of a way, `from 2 to 3` for cycles that come again and again, or why it is undecided.
fn verdicts(text: &str) -> Vec<String> {
    let model = read(text);
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let decided = (0..model.properties.len()).map(|property| {
        let limit = Limit::time(Duration::from_secs(600));
        let bad = circuit.bad.iter().find(|bad| bad.property == property);
        let live = circuit.live.iter().find(|live| live.property == property);
        let verdict = match (bad, live) {
            (Some(bad), _) => decide(&program, &circuit, *bad, &limit),
            (_, Some(live)) => decide_live(&program, &circuit, *live, &limit),
            (None, None) => return format!("{:?}", circuit.refused),
        };
        match verdict.expect("no internal error") {
            Verdict::Proved(_) => "proved".to_owned(),
            Verdict::Violated(way) => format!("in {}", way.len()),
            Verdict::Endless { way, again } => format!("from {} to {}", again + 1, way.len()),
            Verdict::Undecided(why) => why,
        }
    });
    decided.collect()
}

/// A press with a time, and these lines in it.
fn press(lines: &str) -> Vec<String> {
    verdicts(&format!(
        "sfc Press {{ input start, down, closed: bool; output lower: bool;
         initial step Rest; step Press {{ lower; }} step Full;
         Rest -[start]-> Press -[10s/Press || down]-> Full -[closed]-> Rest; {lines} }}"
    ))
}

#[test]
fn what_a_step_waits_for_itself_comes() {
    assert_eq!(press("Press leads_to Full; Press leads_to Full within 10s;"), ["proved", "proved"]);
    assert_eq!(press("Press leads_to Full within 9s;"), ["in 3"]);
    // In an sfc the first cycle clears nothing, and the button may be let go then.
    assert_eq!(press("start && Rest.X leads_to Press;"), ["from 3 to 3"]);
}

#[test]
fn a_param_stays_in_its_range() {
    let press = |range: &str, lines: &str| {
        verdicts(&format!(
            "sfc Press {{ input start: bool; output lower: bool; param hold: time{range} = 2s; param most: i8{} = 3; var n: i8 = 0;
             initial step Rest {{ P1 n = most; }} step Press {{ lower; }}
             Rest -[start]-> Press -[hold/Press]-> Rest; {lines} }}",
            if range.is_empty() { "" } else { " in -2..=3" }
        ))
    };
    let lines = "never Press.T > 10s; never Press.T > 9s; Press leads_to Rest within 10s; always n <= 3 && n >= -2; never n == -2; always hold < 10s;";
    let ranged = press(" in 1s..10s", lines);
    assert_eq!(ranged, ["proved", "in 3", "proved", "proved", "in 1", "proved"]);
    let free = press("", lines);
    assert!(free.iter().all(|verdict| verdict.starts_with("in ")), "{free:?}");
    let low =
        press("", "assume never hold >= 10s; assume never most > 3 || most < -2; never Press.T > 10s; always n <= 3;");
    assert_eq!(low, ["proved", "proved"]);
}

#[test]
fn what_depends_on_an_input_comes_where_that_comes_again_and_again() {
    assert_eq!(press("Press leads_to Rest;").len(), 1);
    assert_ne!(press("Press leads_to Rest;"), ["proved"]);
    assert_eq!(press("assume often closed; Press leads_to Rest;"), ["proved"]);
    assert_ne!(press("assume often !closed; Press leads_to Rest;"), ["proved"]);
}

#[test]
fn within_0s_is_the_same_cycle() {
    assert_eq!(press("Press leads_to lower within 0s; Full leads_to !lower within 0s;"), ["proved", "proved"]);
    assert_eq!(press("start leads_to Press within 0s;"), ["in 1"]);
}

#[test]
fn before_is_about_the_first_time() {
    assert_eq!(press("Press before Full; Rest before lower;"), ["proved", "proved"]);
    assert_eq!(press("Full before Press;"), ["in 2"]);
    // In the same cycle is early enough.
    assert_eq!(press("Press before lower; lower before Press;"), ["proved", "proved"]);
}

/// Two steps take as long as both of them, and a cycle more for each.
#[test]
fn how_far_cycles_are_apart_limits_how_late_something_comes() {
    let steps = |lines: &str| {
        verdicts(&format!(
            "sfc C {{ input a: bool; initial step A; step B; step D; A -[a]-> B -[3ms/B]-> D -[4ms/D]-> A; {lines} }}"
        ))
    };
    assert_eq!(steps("B leads_to A within 7ms;"), ["in 3"], "a cycle that comes late");
    assert_eq!(steps("assume cycle within 1ms; B leads_to A within 7ms;"), ["proved"]);
    assert_ne!(steps("assume cycle within 1ms; B leads_to A within 6ms;"), ["proved"]);
    assert_eq!(steps("assume cycle within 2ms; B leads_to A within 8ms;"), ["proved"]);
    assert_ne!(steps("assume cycle within 2ms; B leads_to A within 7ms;"), ["proved"]);
}

/// Parallel branches come to their end, in both dialects. In a `grafcet` the end of a cycle does not show a step that is passed.
#[test]
fn branches_meet() {
    for dialect in ["sfc", "grafcet"] {
        let text = format!(
            "{dialect} C {{ input a, b, c: bool; initial step R; step A1; step A2; step B1; step B2;
             assume often b; assume often c;
             R -[a && !b && !c]-> (A1, B1); A1 -[b]-> A2; B1 -[c]-> B2; (A2, B2) -[true]-> R;
             A1 leads_to R; B1 leads_to R; R leads_to A1; }}"
        );
        let said = verdicts(&text);
        assert_eq!(said[..2], ["proved", "proved"], "{dialect}");
        assert!(said[2].starts_with("from"), "{dialect}: {}", said[2]);
    }
}

/// A count that comes to its end.
#[test]
fn a_count_comes_to_its_end() {
    let text = "sfc C { input part: bool; var n: u8 = 0; initial step Ready; step Push { P1 n = n + 1; } step Full { P1 n = 0; }
                assume often part; assume often !part;
                Ready -[n >= 3]-> Full -[true]-> Ready; Ready -[part && n < 3]-> Push -[!part]-> Ready;
                Ready leads_to Full; Full leads_to n == 2; Push leads_to n == 4; }";
    let said = verdicts(text);
    assert_eq!(said[..2], ["proved", "proved"]);
    assert!(said[2].starts_with("from"), "{}", said[2]);
}

/// Random charts beside brute force; in a `grafcet` a search makes the circuits large. `cargo xtask prove --random` compares more.
#[test]
fn random_charts_are_judged_as_brute_force_finds_them() {
    let mut counts = Counts::default();
    for (grafcet, timed, charts) in [(false, false, 10), (false, true, 3), (true, false, 3)] {
        let kind = Kind { grafcet, timed, several: true, abc: false };
        let bounds = Bounds { cycles: 1_000, time: Duration::from_secs(600) };
        for chart in 800..800 + charts {
            number(chart, kind, bounds, &mut counts).expect("no difference");
        }
    }
    let decided = counts.proved + counts.broken;
    assert!(counts.proved > 5 && counts.broken > 10 && counts.undecided.len() * 20 < decided, "{counts:?}");
}

/// What is said to be known of clocks is checked: not of the beginning, and not after a cycle.
#[test]
fn what_is_not_always_so_is_no_lemma() {
    let model =
        read("sfc C { input a: bool; initial step A; step B; A -[a]-> B -[3ms/B]-> A; B leads_to A within 3ms; }");
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let is_inductive =
        |now, end| certificate::is_inductive(&circuit, &[Condition { now, end }], &Limit::none()).expect("no limit");
    let waits = circuit.latches[circuit.deadlines[0].waits];
    assert!(!is_inductive(waits.now, waits.next), "it does not begin so");
    assert!(!is_inductive(!waits.now, !waits.next), "a cycle leads to it");
    let first = circuit.fields.iter().find(|field| field.name == "first").expect("the first cycle");
    let first = circuit.latches[first.first];
    assert!(is_inductive(Lit::TRUE, Lit::TRUE) && !is_inductive(first.now, first.next));
}

/// What does not decide about a property may go on while its cycles come again and again.
#[test]
fn what_comes_again_and_again_is_what_decides() {
    for (dialect, chain) in [
        ("sfc", "A -[true]-> B -[true]-> C -[true]-> D -[a]-> A;"),
        ("grafcet", "A -[rising(a)]-> B -[rising(b)]-> C -[rising(a)]-> D -[rising(b)]-> A;"),
        ("sfc", "A -[true]-> B -[true]-> C -[true]-> D -[true]-> A;"),
    ] {
        let model = read(&format!(
            "{dialect} C {{ input a, b: bool; var n: u8 = 0; initial step A; step B; step C; step D; {chain} n == 0 leads_to n == 1; }}"
        ));
        let program = counted(&model, &Facts::of(&model)).expect("a program");
        let circuit = Circuit::of(&program).expect("a circuit");
        let verdict = decide_live(&program, &circuit, circuit.live[0], &Limit::none()).expect("no internal error");
        assert!(matches!(verdict, Verdict::Endless { .. }), "{chain}: {verdict:?}");
    }
}
