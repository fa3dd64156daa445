//! Ways home, as the solver finds them or finds that there are none: what the exploration of situations leaves open.

use grafcet_compiler::analysis::{Facts, Prover};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_compiler::program::counted;
use grafcet_compiler::{Wanted, compile_with};
use grafcet_prove::aig::Lit;
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Limit, Verdict, certificate, decide_home, words};
use quote::quote;

fn read(text: &str) -> Model {
    let mut sink = Sink::new();
    let tokens = text.parse().expect("tokens");
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink)).expect("a chart");
    assert!(sink.finish().iter().all(|message| message.rule.is_some()), "it is understood");
    model
}

fn within(model: &Model, limit: &dyn Fn() -> Limit) -> Vec<Verdict> {
    let program = counted(model, &Facts::of(model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let decided = circuit.homes.iter().map(|home| decide_home(&program, &circuit, home, &limit()));
    decided.collect::<Result<_, _>>().expect("no internal error")
}

/// In how many cycles it may be lost; none where there is always a way home; why it is not decided.
fn judged(text: &str) -> Vec<Result<Option<usize>, String>> {
    let model = read(text);
    let verdict = |verdict| match verdict {
        Verdict::Proved(_) => Ok(None),
        Verdict::Violated(way) => Ok(Some(way.len())),
        Verdict::Undecided(why) => Err(why),
        Verdict::Endless { .. } => panic!("it is about no cycles that come again"),
    };
    within(&model, &|| Limit::time(std::time::Duration::from_secs(120))).into_iter().map(verdict).collect()
}

/// The errors of the macro, with a solver or without.
fn said(text: &str, solver: bool) -> Vec<String> {
    let prover: Option<&Prover> = if solver { Some(&grafcet_prove::rule) } else { None };
    let tokens = text.parse().expect("tokens");
    let wanted = Wanted { recorded: false, prover };
    grafcet_conformance::chart::errors(&compile_with(&quote!(::grafcet), tokens, wanted).to_string())
}

/// Twelve parts; the count goes back to nothing on the way.
const PACKER: &str = "
    sfc Packer {
        input start, part, full, away: bool;
        output belt, push, close: bool;
        var parts: u8 = 0;

        initial step Empty;
        step Wait { belt; }
        step Push { push; P1 parts = parts + 1; }
        step Close { close; }
        step Out { P1 parts = 0; }

        Empty -[start]-> Wait -[part]-> Push;
        Push -[!part && parts < 12]-> Wait;
        Push -[!part && parts >= 12]-> Close -[full]-> Out -[away]-> Empty;

        home Empty;
    }";

/// Six rounds, by the number of the round.
const WASHER: &str = "
    sfc Washer {
        input start, hot, drained, stop: bool;
        output heat, drum, pump: bool;
        var stage: u8 = 0;

        initial step Idle { P1 stage = 0; }
        step Heat { heat; }
        step Wash { drum; }
        step Next { pump; P1 stage = stage + 1; }
        step End { pump; }

        Idle -[start]-> Heat -[hot]-> Wash;
        Wash -[20s/Wash && stage < 5]-> Next -[drained]-> Heat;
        Wash -[20s/Wash && stage == 5]-> End -[drained && !start]-> Idle;
        Heat -[stop]-> End;

        home Idle;
        never stage > 5;
    }";

/// Ten stations around a table; each works where it has a part, and the parts go on with the table.
fn table() -> String {
    let list = |of: &dyn Fn(usize) -> String, between: &str| (1..=10).map(of).collect::<Vec<_>>().join(between);
    let station = |n: usize| {
        format!(
            "step Wait{n}; step Work{n} {{ work{n}; }} step Done{n};
             Wait{n} -[has{n}]-> Work{n} -[ok{n} && up{n}]-> Done{n}; Wait{n} -[!has{n}]-> Done{n};"
        )
    };
    let shift = (2..=10).rev().map(|n| format!("has{n} = has{};", n - 1)).collect::<Vec<_>>().concat();
    format!(
        "sfc Table {{
            input start, in_place, load: bool;
            input {}: bool;
            output turn: bool;
            output {}: bool;
            var {}: bool = false;

            initial step Rest;
            step Turn {{ turn; }}
            step Shift {{ P1 {{ {shift} has1 = load; }} }}
            Rest -[start]-> Turn -[in_place]-> Shift -[true]-> ({});
            {}
            ({}) -[true]-> Rest;
            home Rest;
        }}",
        list(&|n| format!("ok{n}, up{n}"), ", "),
        list(&|n| format!("work{n}"), ", "),
        list(&|n| format!("has{n}"), ", "),
        list(&|n| format!("Wait{n}"), ", "),
        list(&station, "\n"),
        list(&|n| format!("Done{n}"), ", "),
    )
}

#[test]
fn a_way_home_may_go_through_counts_and_many_branches() {
    for text in [PACKER, WASHER, &table()] {
        assert_eq!(said(text, true), Vec::<String>::new(), "{text}");
        let open = said(text, false);
        assert!(open.iter().any(|one| one.contains("grafcet's feature `prove`")), "{text}: {open:?}");
    }
    let inputs = (0..26).map(|n| format!("a{n}, b{n}")).collect::<Vec<_>>().join(", ");
    let edges = (0..26).map(|n| format!("rising(a{n} && !b{n})")).collect::<Vec<_>>().join(" || ");
    for dialect in ["sfc", "grafcet"] {
        let text = format!(
            "{dialect} Edges {{ input {inputs}: bool; output lamp: bool; initial step Off; step On {{ lamp; }}
             Off -[{edges}]-> On -[3s/On]-> Off; home Off; never lamp && Off.X; }}"
        );
        assert_eq!(said(&text, true), Vec::<String>::new(), "{dialect}");
    }
}

/// Twenty of them, two of which forget each other; all ask for thirty inputs. The others are proved.
#[test]
fn a_fault_in_two_of_twenty_partial_grafcets_is_found() {
    let list = |of: &dyn Fn(usize) -> String| (0..20).map(of).collect::<Vec<_>>().join(" ");
    let cell = |n: usize| {
        let (before, after) = ((n + 19) % 20, (n + 1) % 20);
        let lock = match n {
            6 => format!("!B{before}.X"),
            7 => format!("!B{after}.X"),
            _ if n % 2 == 1 => format!("!B{before}.X && !B{after}.X && !go{before} && !go{after}"),
            _ => format!("!B{before}.X && !B{after}.X"),
        };
        format!(
            "partial U{n} {{ initial step A{n}; step B{n} {{ run{n}; }} step C{n};
             A{n} -[go{n} && {lock}]-> B{n} -[end{}]-> C{n} -[!go{n}]-> A{n}; }}",
            n % 10
        )
    };
    let text = format!(
        "grafcet Cells {{ {} {} {} {} never run6 && run7; never run0 && run1; }}",
        list(&|n| format!("input go{n}: bool;")),
        (0..10).map(|n| format!("input end{n}: bool;")).collect::<Vec<_>>().concat(),
        list(&|n| format!("output run{n}: bool;")),
        list(&cell)
    );
    let errors = said(&text, true);
    let [message] = &errors[..] else { panic!("{errors:?}") };
    assert!(message.starts_with("at the end of the first cycle `run6 && run7` holds"), "{message}");
}

/// The count is never set back: with the fifth part, in cycle 10, it is lost.
#[test]
fn where_there_is_no_way_home_the_shortest_way_is_shown() {
    let text = "sfc Lost { input go, stop: bool; output lamp: bool; var n: u8 = 0;
        initial step A; step B { P1 n = n + 1; } step C { lamp; }
        A -[go && n < 4]-> B -[!go]-> A; A -[n >= 4 && stop]-> C -[n < 4]-> A; home A; }";
    assert_eq!(judged(text), [Ok(Some(10))]);
    let errors = said(text, true);
    let [message] = &errors[..] else { panic!("{errors:?}") };
    assert!(message.starts_with("from the end of cycle 10 on there is no way back to exactly `A`"), "{message}");
    assert!(message.contains("A → C"), "{message}");
    // A time that is over does not come back: too late from the second cycle on.
    let late = "sfc Late { input go, a: bool; initial step A; step B; A -[go]-> B -[a && B.T < 5s]-> A; home A; }";
    assert_eq!(judged(late), [Ok(Some(3))]);
    // The third way is all there is, and it is assumed not to come.
    let held = "sfc Held { input go, a: bool; initial step A; step B; assume never a; A -[go]-> B -[a]-> A; home A; }";
    assert_eq!(judged(held), [Ok(Some(2))]);
}

/// Each region for itself, and both together: `(A, C)` never comes, as they turn at the same time.
#[test]
fn several_steps_are_home_together() {
    let text = |home: &str| {
        format!(
            "grafcet Two {{ input go: bool; var n: u8 = 0;
             partial One {{ initial step A; step B {{ P1 n = (n + 1) % 3; }} A -[rising(go)]-> B -[rising(go)]-> A; }}
             partial Other {{ step C; initial step D; D -[rising(go)]-> C -[rising(go)]-> D; }} home {home}; }}"
        )
    };
    assert_eq!(judged(&text("(A, D)")), [Ok(None)]);
    assert_eq!(judged(&text("(B, C)")), [Ok(None)]);
    assert_eq!(judged(&text("C")), [Ok(None)]);
    assert_eq!(judged(&text("(A, C)")), [Ok(Some(1))]);
}

/// A way home relies on neither; that there is none does not rely on them, either.
#[test]
fn rust_and_what_leaves_its_type_lead_nowhere() {
    let call = |back: &str| {
        format!(
            "sfc C {{ input x: u8; input stop: bool; var n: u8 = 0; initial step A; step B {{ P1 n = (n + 1) % 5; }}
             A -[x > 3]-> B {back} home A; }}"
        )
    };
    let [Err(why)] = &judged(&call("-[near(x) && n < 9]-> A;"))[..] else { panic!("it is not decided") };
    assert_eq!(why, "a way home may rely on what is not looked into: `near(x)`");
    assert_eq!(judged(&call("-[near(x) && stop]-> A; B -[!near(x) && stop && n < 9]-> A;")), [Err(why.clone())]);
    assert_eq!(judged(&call("-[near(x)]-> A; B -[stop]-> A;")), [Ok(None)]);
    assert_eq!(judged(&call("-[near(x) && n > 9]-> A;")), [Ok(Some(2))]);
    let wraps = "sfc W { input up: bool; var n: u8 = 0; initial step A; step B { P1 n = n + 1; } step C;
        A -[up]-> B -[n == 0]-> A; B -[n > 0 && !up]-> C -[up]-> B; home A; }";
    let [Err(why)] = &judged(wraps)[..] else { panic!("it is not decided") };
    assert!(why.contains("arithmetic that leaves its type"), "{why}");
    // Only the third hundred, which does not fit, leads to where it is lost.
    let trap = "sfc T { input up: bool; var n: u8 = 0; initial step A; step B { P1 n = n + 100; } step C;
        A -[up]-> B -[n < 100]-> C -[false]-> A; B -[n >= 100 && !up]-> A; home A; }";
    assert!(matches!(&judged(trap)[..], [Err(why)] if why.contains("arithmetic that leaves its type")));
}

/// The checker refuses ways that are none.
#[test]
fn ways_that_are_none_are_refused() {
    let model = read(PACKER);
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let limit = Limit::none();
    let verdict = decide_home(&program, &circuit, &circuit.homes[0], &limit).expect("no internal error");
    let Verdict::Proved(proof) = verdict else { panic!("it is proved") };
    let circuit = proof.beside.as_deref().expect("its circuit");
    let (known, may) = (circuit.constraint, circuit.constraint);
    let ways = &proof.ways[0];
    assert!(ways.leads.len() > 12 && ways.longest() > 12, "a way for each count");
    let page = include_str!("../../../docs/proof.md");
    for line in words::ways(&proof.ways).iter().map(String::as_str).chain(PACKER.lines().map(str::trim)) {
        assert!(page.contains(line), "not on the page: {line}");
    }
    let fault = |ways: &_| certificate::fault_of_ways(circuit, (known, may), ways, &limit).expect("no limit");
    assert_eq!(fault(ways), None);
    // A cube that is said to be nearer than it is, in its place and in front of all, one that holds more than it may, and a cycle with other inputs.
    let mut turned = ways.clone();
    let last = turned.leads.last_mut().expect("some");
    last.after = 0;
    assert!(fault(&turned).is_some_and(|what| what.contains("nearer than the one in front of it")));
    let nearest = turned.leads.pop().expect("some");
    turned.leads.insert(0, nearest);
    assert!(fault(&turned).is_some_and(|what| what.contains("do not lead on")));
    let mut wider = ways.clone();
    wider.leads[3].cube.clear();
    assert!(fault(&wider).is_some());
    let without = |number: usize| {
        let mut less = ways.clone();
        less.leads[number].inputs.clear();
        fault(&less)
    };
    assert!((0..ways.leads.len()).any(|number| without(number).is_some()), "some need an input");
    // Everything but home is not closed: a cycle leads out of it.
    assert!(!certificate::is_closed(circuit, ways.target.now, &limit).expect("no limit"));
    assert!(certificate::is_closed(circuit, Lit::TRUE, &limit).expect("no limit"));
    // What is home at the end of a cycle is not what the ways say of it: with another home no input leads there.
    let mut moved = ways.clone();
    moved.target.now = Lit::FALSE;
    assert!(fault(&moved).is_some());
}

/// An elevator of four floors that remembers its calls: `edge` is what a call takes, a level or `rising`, `up` where the car stops on its way up.
fn elevator(edge: &str, up: &str) -> String {
    let of_floor = |floor: usize| {
        format!(
            "partial Calls{floor} {{ initial step C{floor}; step W{floor} {{ S want{floor}; }} step S{floor} {{ R want{floor}; }}
             C{floor} -[{edge}(call{floor})]-> W{floor} -[Served.X && at{floor}]-> S{floor} -[!call{floor}]-> C{floor}; }}"
        )
    };
    let calls: Vec<String> = (0..4).map(of_floor).collect();
    let calls = calls.join(" ");
    format!(
        "grafcet Elevator {{
         input call0, call1, call2, call3, at0, at1, at2, at3, door_open, door_closed: bool;
         output up, down, opening, closing: bool; var want0, want1, want2, want3: bool = false;
         let here = want0 && at0 || want1 && at1 || want2 && at2 || want3 && at3;
         let above = at0 && (want1 || want2 || want3) || at1 && (want2 || want3) || at2 && want3;
         let below = at3 && (want0 || want1 || want2) || at2 && (want0 || want1) || at1 && want0;
         {calls}
         partial Car {{
           initial step Idle; step Up {{ up; }} step Down {{ down; }} step Opening {{ opening; }} step Served; step Closing {{ closing; }}
           Idle -[here]-> Opening; Idle -[above && !here]-> Up; Idle -[below && !above && !here]-> Down;
           Up -[{up}]-> Opening; Down -[here || at0]-> Opening; Opening -[door_open]-> Served -[3s/Served]-> Closing;
           Closing -[door_closed && !here]-> Idle; Closing -[here && !door_closed]-> Opening; }}
         assume never at0 && at1; assume never at0 && at2; assume never at0 && at3;
         assume never at1 && at2; assume never at1 && at3; assume never at2 && at3; assume never door_open && door_closed;
         home Idle; home (Idle, C0, C1, C2, C3); }}"
    )
}

/// Within the limit of a macro.
const STEPS: u64 = 400_000;

#[test]
fn an_elevator_that_remembers_calls_comes_home() {
    for calls in ["", "rising"] {
        for verdict in within(&read(&elevator(calls, "here || at3")), &|| Limit::work(STEPS)) {
            assert!(matches!(verdict, Verdict::Proved(_)), "{calls}: {verdict:?}");
        }
    }
    // Going up it never stops, once it is on its way: called in the first cycle, in which it goes.
    for verdict in within(&read(&elevator("", "here && at0 && at1")), &|| Limit::work(STEPS)) {
        assert!(matches!(&verdict, Verdict::Violated(way) if way.len() == 1), "{verdict:?}");
    }
}

/// A rotary table with ten stations, each a partial grafcet that the main one waits for.
#[test]
fn a_rotary_table_comes_home() {
    let all = |of: &dyn Fn(usize) -> String, by: &str| (0..10).map(of).collect::<Vec<_>>().join(by);
    let stations = all(
        &|n| {
            format!(
                "partial S{n} {{ initial step I{n}; step W{n} {{ tool{n}; }} step R{n};
                 I{n} -[Work.X]-> W{n} -[done{n} || !part{n}]-> R{n} -[Turn.X]-> I{n}; }}"
            )
        },
        " ",
    );
    let (idle, ready) = (all(&|n| format!("I{n}.X"), " && "), all(&|n| format!("R{n}.X"), " && "));
    let text = format!(
        "grafcet Table {{ input start, turned: bool; {} {} output turn: bool;
         partial Main {{ initial step Idle; step Turn {{ turn; }} step Work;
         Idle -[start && !turned && {idle}]-> Work -[{ready}]-> Turn -[turned && {idle}]-> Idle; }} {stations} home Idle; }}",
        all(&|n| format!("input done{n}, part{n}: bool;"), " "),
        all(&|n| format!("output tool{n}: bool;"), " "),
    );
    for verdict in within(&read(&text), &|| Limit::work(STEPS)) {
        assert!(matches!(verdict, Verdict::Proved(_)), "{verdict:?}");
    }
}
