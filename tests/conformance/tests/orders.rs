//! What is assumed to come one after the other: what is proved with it, what is broken without, and what says nothing.

use std::time::Duration;

use grafcet_compiler::analysis::{Facts, Prover};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::plant;
use grafcet_compiler::program::counted;
use grafcet_compiler::{Wanted, compile_with};
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Limit, Verdict, decide, decide_home, decide_live, says_nothing};
use quote::quote;

/// A tank whose valve is open until it is full.
fn tank(late: &str, assumed: &str, claims: &str) -> String {
    format!(
        "sfc Tank {{
            clock 100ms;
            input go, full: bool;
            output valve, alarm: bool;
            initial step Rest;
            step Fill {{ valve; }}
            step Late {{ alarm; }}
            Rest -[go]-> Fill -[full]-> Rest;
            Fill -[{late}]-> Late -[!go]-> Rest;
            assume cycle within 100ms;
            {assumed}
            {claims}
        }}"
    )
}

/// How many cycles the shortest way to where each is broken has; none where it is proved.
fn broken(text: &str) -> Vec<Option<usize>> {
    let mut sink = Sink::new();
    let model = plant::model(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let messages: Vec<String> = sink.finish().into_iter().flat_map(|one| one.notes).map(|(_, text)| text).collect();
    assert!(messages.is_empty(), "{messages:?}");
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let limit = Limit::time(Duration::from_secs(600));
    let verdict = |property: usize| {
        let bad = circuit.bad.iter().find(|bad| bad.property == property);
        let live = circuit.live.iter().find(|live| live.property == property);
        let home = circuit.homes.iter().find(|home| home.property == property);
        match (bad, live, home) {
            (Some(bad), ..) => decide(&program, &circuit, *bad, &limit),
            (_, Some(live), _) => decide_live(&program, &circuit, *live, &limit),
            (.., home) => decide_home(&program, &circuit, home.expect("it is modelled"), &limit),
        }
    };
    let length = |property| match verdict(property).expect("no internal error") {
        Verdict::Proved(_) => None,
        Verdict::Violated(way) | Verdict::Endless { way, .. } => Some(way.len()),
        Verdict::Undecided(why) => panic!("{why}"),
    };
    (0..model.properties.len()).map(length).collect()
}

/// A tick is a tenth of a second, and so far are two cycles apart at most. The answer that comes with the question is seen a cycle later; if it is gone then, the valve asks
/// once more, from then on: a tick more than it takes to answer.
#[test]
fn what_is_answered_in_time() {
    let claims = "never alarm; Fill leads_to Rest within 1100ms; Fill leads_to Rest within 1s;";
    let answered = "assume valve leads_to full within 1s;";
    // It begins in cycle 2, and ten ticks later is cycle 12.
    assert_eq!(broken(&tank("1200ms/Fill", answered, claims)), [None, None, Some(12)]);
    assert_eq!(broken(&tank("1100ms/Fill", answered, "never alarm;")), [None]);
    assert_eq!(broken(&tank("1s/Fill", answered, "never alarm;")), [Some(12)]);
    let fine = tank("10200ms/Fill", "assume valve leads_to full within 10s;", "never alarm;");
    assert_eq!(broken(&fine.replace("clock 100ms", "clock 10ms")), [None]);
    // Without the assumption nothing answers.
    assert_eq!(broken(&tank("1s/Fill", "", "never alarm; Fill leads_to Rest within 1s;")), [Some(12); 2]);
}

#[test]
fn what_is_answered_some_time() {
    let claims = "Fill leads_to Rest;";
    assert_eq!(broken(&tank("false", "assume valve leads_to full;", claims)), [None]);
    assert!(broken(&tank("false", "", claims))[0].is_some());
    // Something else is answered.
    assert!(broken(&tank("false", "assume alarm leads_to full;", claims))[0].is_some());
}

#[test]
fn what_comes_first() {
    let claims = "never Rest.X && full; Fill before full; valve before full;";
    // The part that is full may be so when it is not filled any more.
    assert_eq!(broken(&tank("12s/Fill", "assume valve before full;", claims)), [Some(3), None, None]);
    assert_eq!(broken(&tank("12s/Fill", "", claims)), [Some(1); 3]);
}

/// What comes first may be an edge; what comes after may be a plant's.
#[test]
fn edges_and_plants() {
    let call =
        tank("12s/Fill", "assume rising(valve) leads_to Hose::Wet within 5s;", "Fill leads_to Hose::Wet within 6s;");
    let call = call.replace("clock 100ms", "clock 1s").replace("cycle within 100ms", "cycle within 1s");
    let call = call
        + "plant Hose {
            input valve: bool;
            choice leak;
            initial step Dry;
            step Wet;
            Dry -[valve && !leak]-> Wet -[!valve]-> Dry;
        }";
    assert_eq!(broken(&call), [None]);
    assert!(broken(&call.replace("assume rising(valve) leads_to Hose::Wet within 5s;", ""))[0].is_some());
}

/// `home` is a matter of the chart alone: it may fill it, whatever comes first.
#[test]
fn a_way_home_does_not_wait_for_it() {
    assert_eq!(broken(&tank("12s/Fill", "assume alarm before full;", "home Rest;")), [None]);
}

/// The exploration finds ways that do not happen; the macro asks the solver, and without one says so.
#[test]
fn the_macro_relies_on_it() {
    let root = quote!(::grafcet);
    let compiled = |text: &str, prover: Option<&Prover>| {
        compile_with(&root, text.parse().expect("tokens"), Wanted { prover, ..Wanted::default() }).to_string()
    };
    let chart =
        tank("12s/Fill", "assume valve before full;", "never Rest.X && full && !go;").replace("-[full]->", "-[go]->");
    let broken = chart.replace("assume valve before full;", "");
    assert!(compiled(&broken, None).contains("property_violated"));
    assert!(compiled(&chart, None).contains("property_undecided"));
    let solved = compiled(&chart, Some(&grafcet_prove::rule));
    assert!(solved.contains("at the end of cycle 4"), "{solved}");
    let holds = tank("12s/Fill", "assume valve before full;", "Fill before full;");
    assert!(!compiled(&holds, Some(&grafcet_prove::rule)).contains("compile_error"));
}

#[test]
fn what_nothing_asks_for_is_said() {
    let root = quote!(::grafcet);
    let prover: &Prover = &grafcet_prove::rule;
    let compiled = |text: String| {
        let wanted = Wanted { prover: Some(prover), ..Wanted::default() };
        compile_with(&root, text.parse().expect("tokens"), wanted).to_string()
    };
    let claims = "Fill before full;";
    let nothing =
        compiled(tank("12s/Fill", "assume valve && alarm leads_to full within 1s; assume valve before full;", claims));
    assert!(
        nothing.contains("`valve && alarm` holds at the end of no cycle, so this assumption excludes nothing"),
        "{nothing}"
    );
    assert!(!nothing.contains("`full` holds at the end of no cycle"), "{nothing}");
    // It excludes much, and so `full` never comes.
    let much = compiled(tank("12s/Fill", "assume valve && alarm before full;", claims));
    assert!(!much.contains("excludes nothing"), "{much}");
    let all = compiled(tank("12s/Fill", "assume valve before !full; assume alarm before full;", "never alarm && go;"));
    assert!(all.contains("these assumptions exclude every cycle"), "{all}");
}

/// What is wrong is said at its place.
#[test]
fn mistakes_are_said() {
    let root = quote!(::grafcet);
    let said = |assumed: &str| {
        let text = tank("12s/Fill", assumed, "never alarm && valve;");
        compile_with(&root, text.parse().expect("tokens"), Wanted::default()).to_string()
    };
    for (assumed, message) in [
        (
            "assume full leads_to valve;",
            "what comes after is the machine's doing, a condition over inputs, and `valve` is an output",
        ),
        (
            "assume valve before Fill.X;",
            "what comes after is the machine's doing, a condition over inputs, and this is a step",
        ),
        ("assume valve leads_to full within 0s;", "nothing is answered in the cycle in which it is asked"),
        ("assume valve leads_to full within;", "after `within` stands how long it may take"),
        ("assume valve follows full;", "what it answers `assume valve leads_to full within 10s;`"),
    ] {
        let said = said(assumed);
        assert!(said.contains(message), "{assumed}: {said}");
    }
}

/// It is a part of what other checkers read.
#[test]
fn it_says_nothing_only_where_that_is_proved() {
    let mut sink = Sink::new();
    let text =
        tank("12s/Fill", "assume valve leads_to full; assume valve && alarm leads_to full;", "never alarm && valve;");
    let model = plant::model(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let limit = Limit::time(Duration::from_secs(600));
    let nothing = |order| says_nothing(&circuit, order, &limit).expect("no internal error").is_some();
    assert_eq!([nothing(0), nothing(1)], [false, true]);
}
