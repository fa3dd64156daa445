//! The prover beside a naive exploration, and the check of its proofs.

use grafcet_compiler::analysis::{Facts, Prover};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_compiler::program::{Encoding, counted};
use grafcet_compiler::{Wanted, compile_with};
use grafcet_conformance::prove::{Bounds, Counts, Kind, number};
use grafcet_prove::circuit::Circuit;
use grafcet_prove::task::{Invariant, Task};
use grafcet_prove::{Limit, Verdict, by_evolutions, certificate, decide, words};
use proc_macro2::TokenStream;
use quote::quote;
use std::time::Duration;

fn read(text: &str) -> Model {
    let mut sink = Sink::new();
    let tokens = text.parse().expect("tokens");
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink)).expect("a chart");
    assert!(sink.finish().iter().all(|message| message.rule.is_some()), "it is understood");
    model
}

fn verdicts(model: &Model) -> Vec<Verdict> {
    let program = counted(model, &Facts::of(model), Encoding::Regions).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let decided =
        circuit.bad.iter().map(|bad| decide(&program, &circuit, *bad, &Limit::time(Duration::from_secs(600))));
    decided.collect::<Result<_, _>>().expect("no internal error")
}

/// Every verdict and every length as brute force finds them.
#[test]
fn random_charts_are_judged_as_brute_force_finds_them() {
    let mut counts = Counts::default();
    for (grafcet, timed) in [(false, false), (true, false), (false, true), (true, true)] {
        let kind = Kind { grafcet, timed, several: false, abc: false };
        let bounds = Bounds { cycles: 2_000, time: Duration::from_secs(600) };
        for chart in 700..712 {
            number(chart, kind, bounds, &mut counts).expect("no difference");
        }
    }
    assert!(
        counts.proved > 5 && counts.broken > 10 && counts.undecided.is_empty() && counts.refused == 0,
        "{counts:?}"
    );
}

/// A counter that the explicit search does not follow: seven parts and no more.
const COUNTER: &str = "
    sfc Packer {
        input part, full: bool;
        output push, close: bool;
        var parts: u8 = 0;

        initial step Ready;
        step Push { push; P1 parts = parts + 1; }
        step Close { close; P1 parts = 0; }
        step Jam;

        Ready -[parts > 7]-> Jam -[full]-> Ready;
        Ready -[part && parts < 7]-> Push -[!part]-> Ready;
        Ready -[parts >= 7]-> Close -[full]-> Ready;

        never Jam.X;
        always Close.X => close && !push;
    }";

/// Which excludes the other one only as long as both keep to it.
const INTERLOCKED: &str = "
    grafcet Cell {
        input left, right: bool;
        partial L { initial step L0; step L1; L0 -[left && !R1.X]-> L1 -[!left]-> L0; }
        partial R { initial step R0; step R1; R0 -[right && !left && !L1.X]-> R1 -[!right]-> R0; }
        never L1.X && R1.X;
    }";

#[test]
fn what_depends_on_a_count_is_proved() {
    for verdict in verdicts(&read(COUNTER)) {
        assert!(matches!(verdict, Verdict::Proved(_)), "{verdict:?}");
    }
}

/// What an enum that the chart stores begins with, is written and is copied from; what Rust makes of it is any of its variants.
#[test]
fn stored_enums_are_followed() {
    let chart = |decide: &str, claims: &str| {
        let text = format!(
            "grafcet Valve {{
                input open, shut: bool; input asked: Mode in {{Idle, Busy, Failed, Gone}};
                output motor: bool;
                var mode: Mode in {{Idle, Busy, Failed, Gone}} = Mode::Idle; var last: Mode in {{Idle, Busy, Failed, Gone}} = Mode::Gone;
                var alone: Mode in {{Idle}} = Mode::Idle; var made: Mode in {{Idle, Busy, Failed}} = Mode::Idle;
                initial step Rest {{ {decide} }} step Move {{ motor; P1 last = mode; P1 mode = Mode::Busy; P0 mode = Mode::Idle; }}
                step Stuck {{ P1 mode = Mode::Failed; }} step Asked {{ P1 mode = asked; }}
                Rest -[open]-> Move -[shut]-> Rest; Move -[!open && !shut && mode == Mode::Busy]-> Stuck -[shut]-> Asked;
                {claims} }}"
        );
        verdicts(&read(&text))
    };
    let proved = chart(
        "P1 made = decide(open);",
        "never Move.X && mode != Mode::Busy; always Stuck.X => mode == Mode::Failed; always motor => last == Mode::Idle;
         never alone != Mode::Idle; always matches!(made, Mode::Idle | Mode::Busy | Mode::Failed);
         always Rest.X => !matches!(mode, Mode::Failed | Mode::Gone); never Stuck.X && last == Mode::Gone;",
    );
    assert_eq!(proved.len(), 7);
    for verdict in &proved {
        assert!(matches!(verdict, Verdict::Proved(_)), "{verdict:?}");
    }
    let broken = chart("", "never mode == Mode::Failed; never last == Mode::Gone; never mode == Mode::Gone;");
    match &broken[..] {
        [Verdict::Violated(failed), Verdict::Violated(before), Verdict::Violated(gone)] => {
            assert_eq!((failed.len(), before.len(), gone.len()), (2, 1, 3));
        }
        other => panic!("{other:?}"),
    }
}

/// A search that may go through all of the chart is no longer circuit for what is proved from evolution to evolution.
#[test]
fn a_long_search_is_gone_through_evolution_by_evolution() {
    let model = read(
        "grafcet Mixer {
            input start, stop, reset, full, hot: bool; input select: Mode in {Manual, Auto, Clean};
            output inlet, heater, stirrer, horn: bool;
            var mode: Mode in {Manual, Auto, Clean} = Mode::Manual; var alarms: u8 = 0;
            param soak: time in 1s..60s = 10s;
            initial step Idle { P1 mode = Mode::Manual; } step Chosen { P1 mode = select; } step Fill { inlet; }
            step Heat { heater; stirrer if mode != Mode::Clean; } step Soak { stirrer; } step Fault { horn; P1 alarms = alarms.saturating_add(1); }
            Idle -[start && alarms < 3]-> Chosen; Chosen -[mode == Mode::Auto || mode == Mode::Clean]-> Fill; Chosen -[mode == Mode::Manual && !start]-> Idle;
            Fill -[full && !stop]-> Heat; Fill -[30s/Fill && !full || stop]-> Fault; Heat -[hot && !stop]-> Soak; Heat -[stop]-> Fault;
            Soak -[Soak.T >= soak]-> Idle; Fault -[reset && alarms < 3]-> Idle;
            never heater && mode == Mode::Manual; always alarms <= 3; never Soak.T > 60s; never alarms > 2 && Fill.X;
            never alarms > 1; never Fill.X && mode == Mode::Clean; }",
    );
    let found = verdicts(&model);
    for verdict in &found[..4] {
        let Verdict::Proved(proof) = verdict else { panic!("{verdict:?}") };
        let circuit = proof.beside.as_ref().expect("the circuit of one evolution");
        assert!(circuit.fields.iter().any(|field| field.name == "within a search"));
    }
    // Shortest ways are those of whole cycles; one is enough here.
    for (verdict, cycles) in found[4..].iter().zip([1, 1]) {
        let Verdict::Violated(way) = verdict else { panic!("{verdict:?}") };
        assert_eq!(way.len(), cycles, "{way:?}");
    }
}

/// A search that circles ends at its bound, also where it is gone through evolution by evolution, and on the inputs with which it began.
#[test]
fn what_a_search_leaves_at_its_bound_is_no_secret() {
    let model = read(
        "grafcet C { input a, b: bool; output q: bool; initial step A; step B { q; } step D; A -[a]-> B -[a]-> A; A -[b && !a]-> D -[!b]-> A;
         never a && A.X; never a && B.X; never !a && q && b; never D.X && !b; never D.X && a && q; }",
    );
    let program = counted(&model, &Facts::of(&model), Encoding::Regions).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let mut broken = 0;
    for bad in &circuit.bad {
        let verdict = decide(&program, &circuit, *bad, &Limit::none()).expect("no internal error");
        let proof = by_evolutions(&program, bad.property, &Limit::none()).expect("no internal error");
        match verdict {
            Verdict::Violated(_) => {
                broken += 1;
                assert!(proof.is_none(), "property {} is broken", bad.property);
            }
            verdict => assert!(matches!(verdict, Verdict::Proved(_)) && proof.is_some(), "property {}", bad.property),
        }
    }
    assert_eq!(broken, 3);
}

/// A proof speaks of an enum by its variants.
#[test]
fn a_proof_names_the_variants() {
    let model = read(
        "sfc Press { input go: bool; output ram: bool; var mode: Mode in {Idle, Busy, Done} = Mode::Idle;
         initial step Rest; step Run { P1 mode = Mode::Busy; } step End { ram; P1 mode = Mode::Done; }
         Rest -[go]-> Run -[!go]-> End -[go]-> Rest; never ram && mode == Mode::Busy; }",
    );
    let program = counted(&model, &Facts::of(&model), Encoding::Regions).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let proof = decide(&program, &circuit, circuit.bad[0], &Limit::none()).expect("no internal error");
    let Verdict::Proved(proof) = proof else { panic!("{proof:?}") };
    let lines = words::lines(&program, &circuit, &proof.invariant);
    assert!(
        lines.iter().any(|line| line.contains("mode in {Busy}") || line.contains("mode in {Idle, Busy}")),
        "{lines:?}"
    );
}

/// Eight branches of five steps are more situations than anybody goes through; the fault shows in cycle 2.
#[test]
fn interlocked_partial_grafcets_are_no_matter_of_situations() {
    let list = |of: &dyn Fn(usize) -> String| (0..8).map(of).collect::<Vec<_>>().join(" ");
    let branch = |index: usize| {
        let other = (index + 1) % 8;
        // The last one forgets its neighbour.
        let free = if index == 7 { String::new() } else { format!(" && !B{other}.X") };
        format!(
            "partial P{index} {{ initial step A{index}; step B{index} {{ run{index}; }} step C{index};
             A{index} -[go{index}{free}]-> B{index} -[end{index}]-> C{index} -[!go{index}]-> A{index}; }}"
        )
    };
    let mut text = format!(
        "grafcet Line {{ {} {} {}",
        list(&|index| format!("input go{index}, end{index}: bool;")),
        list(&|index| format!("output run{index}: bool;")),
        list(&branch)
    );
    text += "never run7 && run0; never run6 && run7 && run5 && !go0 && go0; }";
    match &verdicts(&read(&text))[..] {
        [Verdict::Violated(way), Verdict::Proved(_)] => assert_eq!(way.len(), 1),
        other => panic!("{other:?}"),
    }
}

/// The checker of proofs refuses what is none.
#[test]
fn a_proof_that_is_none_is_refused() {
    let model = read(INTERLOCKED);
    let program = counted(&model, &Facts::of(&model), Encoding::Regions).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let task = Task::new(&circuit, circuit.bad[0].possible);
    let limit = Limit::none();
    let fault = |excluded: Vec<Vec<u32>>| {
        certificate::fault(&task, &Invariant { excluded, depth: 0 }, &limit).expect("no limit")
    };
    let Verdict::Proved(proof) = verdicts(&model).remove(0) else { panic!("it is proved") };
    assert_eq!(fault(proof.invariant.excluded.clone()), None);
    assert!(fault(Vec::new()).is_some(), "nothing is known, so something bad can happen");
    // The initial state, and with it every chart.
    let beginning =
        circuit.latches.iter().zip(0_u32..).map(|(latch, index)| index * 2 + u32::from(latch.initial == Some(true)));
    assert!(fault(vec![beginning.collect()]).is_some_and(|what| what.contains("begin")));
    // One cycle leads out of it: the first one is over.
    let first = circuit.fields.iter().find(|field| field.name == "first").expect("the first cycle");
    let over = vec![u32::try_from(first.first).expect("small") * 2];
    assert!(fault([proof.invariant.excluded, vec![over]].concat()).is_some_and(|what| what.contains("leads to")));
}

/// What the exploration leaves open, the macro's feature `prove` decides: numbers and times, proved, or refuted by a way that is as short
/// as can be and shows no more than it needs.
#[test]
fn the_compiler_asks_for_what_is_left_open() {
    let chart = |property: &str| {
        format!(
            "sfc Press {{ input start, down: bool; output lower: bool; var parts: u8 = 0; \
             initial step Rest; step Press {{ lower; P1 parts = parts + 1; }} step Full {{ P1 parts = 0; }} \
             Rest -[start && parts < 3]-> Press -[10s/Press || down]-> Rest; Rest -[parts >= 3]-> Full -[!start]-> Rest; {property} }}"
        )
    };
    let said = |property: &str, prover: Option<&Prover>| {
        let wanted = Wanted { recorded: false, prover };
        let tokens = chart(property).parse().expect("tokens");
        grafcet_conformance::chart::errors(&compile_with(&quote!(::grafcet), tokens, wanted).to_string())
    };
    let prover: Option<&Prover> = Some(&grafcet_prove::rule);
    for property in
        ["always parts <= 3;", "never Press.T > 10s;", "always Full.X => parts == 0;", "never 1s/Full && parts > 0;"]
    {
        assert_eq!(said(property, prover), Vec::<String>::new(), "{property}");
        let open = said(property, None);
        assert!(matches!(&open[..], [one] if one.contains("grafcet's feature `prove`")), "{property}: {open:?}");
    }
    let broken = said("never parts > 2;", prover);
    let [message] = &broken[..] else { panic!("{broken:?}") };
    assert!(message.contains("at the end of cycle 6 `parts > 2` holds"), "{message}");
    assert!(message.contains("Rest → Press | Press"), "{message}");
    assert!(!message.contains("start, down"), "one of them is enough: {message}");
    let asked = said("never near(parts);", prover);
    assert!(
        matches!(&asked[..], [one] if one.contains("if the program ever comes to these values of `near(parts)`")),
        "{asked:?}"
    );
    let unknown = said("never parts.count_ones() > 3;", prover);
    assert!(matches!(&unknown[..], [one] if one.contains("a solver was asked, too")), "{unknown:?}");
}

/// What is about several cycles, the macro's feature `prove` decides alone.
#[test]
fn the_compiler_asks_for_what_takes_several_cycles() {
    let said = |property: &str| {
        let chart = format!(
            "sfc Press {{ input start, down, closed: bool; output lower: bool; initial step Rest; step Press {{ lower; }} step Full; \
             Rest -[start]-> Press -[10s/Press || down]-> Full -[closed]-> Rest; {property} }}"
        );
        let wanted = Wanted { recorded: false, prover: Some(&grafcet_prove::rule) };
        let tokens = chart.parse().expect("tokens");
        grafcet_conformance::chart::errors(&compile_with(&quote!(::grafcet), tokens, wanted).to_string())
    };
    for property in [
        "Press leads_to Full;",
        "Press leads_to Full within 10s;",
        "assume often closed; Press leads_to Rest;",
        "Press before Full;",
    ] {
        assert_eq!(said(property), Vec::<String>::new(), "{property}");
    }
    for (property, what) in [
        (
            "Press leads_to Full within 9s;",
            "at the end of cycle 3 it is too late: `Press.X` has held, and `Full.X` not since",
        ),
        ("Full before Press;", "at the end of cycle 2 `Press.X` holds, and `Full.X` has not held yet"),
        ("Press leads_to Rest;", "`Press.X` has held, and `Rest.X` never follows where"),
    ] {
        let said = said(property);
        assert!(matches!(&said[..], [one] if one.starts_with(what)), "{property}: {said:?}");
    }
}

/// A delayed and a limited output are followed by the tick, at each side of their times.
#[test]
fn delayed_and_limited_outputs_are_followed() {
    let text = "sfc Lamp { input go, stop: bool; output late, short: bool;
        initial step Rest; step Run { D 3s late; L 2s short; }
        Rest -[go]-> Run -[stop]-> Rest;
        never late && Run.T < 3s; always Run.T >= 3s => late; never short && Run.T >= 2s; always Run.X && Run.T < 2s => short;
        never late && short; never late; never Run.X && !short && !late; always Run.T >= 2s => late; }";
    let said: Vec<Option<usize>> = verdicts(&read(text))
        .into_iter()
        .map(|verdict| match verdict {
            Verdict::Proved(_) => None,
            Verdict::Violated(way) => Some(way.len()),
            other => panic!("{other:?}"),
        })
        .collect();
    // Entered in the second cycle, and so late in the third.
    assert_eq!(said, [None, None, None, None, None, Some(3), Some(3), Some(3)]);
}

/// Stored ones, too, and the macro gets no counterexample that is none.
#[test]
fn what_time_does_to_actions_is_left_to_the_solver() {
    let said = |property: &str| {
        let chart = format!(
            "sfc Oven {{ input start, door: bool; output heat, horn, fan, lamp, bell: bool;
             initial step Idle {{ D 5s horn; R lamp; R bell; }} step Bake {{ L 10s heat; SD 3s fan; DS 3s lamp; SL 3s bell; }}
             step Cool {{ R fan; }} Idle -[start]-> Bake -[30s/Bake]-> Cool -[door && 5s/Cool]-> Idle; {property} }}"
        );
        let wanted = Wanted { recorded: false, prover: Some(&grafcet_prove::rule) };
        let tokens = chart.parse().expect("tokens");
        grafcet_conformance::chart::errors(&compile_with(&quote!(::grafcet), tokens, wanted).to_string())
    };
    assert_eq!(said("never horn && Idle.T < 5s;"), Vec::<String>::new());
    // Where thirty seconds pass at once, nobody has seen three.
    for (property, when) in [
        ("never heat;", "cycle 2"),
        ("never horn;", "cycle 2"),
        ("never fan && heat;", "cycle 3"),
        ("always Cool.X => lamp || bell;", "cycle 3"),
        ("never lamp && Cool.X;", "cycle 4"),
    ] {
        let errors = said(property);
        assert!(
            matches!(&errors[..], [one] if one.contains(&format!("at the end of {when} "))),
            "{property}: {errors:?}"
        );
    }
}

/// Time passes also where nothing but a property asks for it.
#[test]
fn a_property_may_be_all_that_asks_for_time() {
    for (dialect, property) in
        [("sfc", "never Off.T > 5s;"), ("grafcet", "never 5s/Off;"), ("sfc", "always On.T < 5s || Off.X;")]
    {
        let text = format!(
            "{dialect} Lamp {{ input on: bool; output lamp: bool; initial step Off; step On {{ lamp; }} \
             Off -[on]-> On -[!on]-> Off; {property} }}"
        );
        assert!(matches!(&verdicts(&read(&text))[..], [Verdict::Violated(_)]), "{dialect}: {property}");
    }
    let text = "grafcet M { input a: bool; initial step A; macro step M { entry step E; exit step F; E -[a]-> F; } \
                A -[a]-> M -[!a]-> A; never M.T > 5s; never A.T > 5s && !A.X; }";
    assert!(matches!(&verdicts(&read(text))[..], [Verdict::Violated(_), Verdict::Proved(_)]));
}

/// The page shows what the compiler says of its chart, word for word but for the mend.
#[test]
fn the_chart_of_the_page_is_judged_as_the_page_says() {
    let page = include_str!("../../../docs/proof.md");
    let chart = page.split("```").find(|part| part.starts_with("text\nsfc Press")).expect("the chart");
    let tokens = chart.trim_start_matches("text").parse().expect("tokens");
    let wanted = Wanted { recorded: false, prover: Some(&grafcet_prove::rule) };
    let said = grafcet_conformance::chart::errors(&compile_with(&quote!(::grafcet), tokens, wanted).to_string());
    let [message] = &said[..] else { panic!("{said:?}") };
    let (first, table) = message.split_once("\\n").expect("a table");
    assert!(first.starts_with("at the end of cycle 6 `parts > 2` holds"), "{first}");
    for row in table.split("\\n") {
        assert!(page.contains(&format!("       {row}\n")), "not on the page: {row}");
    }
}

/// So are the lines about several cycles: what stands behind each of them is what it is.
#[test]
fn the_lines_of_the_page_about_several_cycles_are_what_it_says() {
    let page = include_str!("../../../docs/proof.md");
    let block = |start: &str| page.split("```").find(|part| part.starts_with(start)).expect("a block").to_owned();
    let (chart, lines) = (block("text\nsfc Press"), block("text\nstart leads_to"));
    let (chart, _) = chart.trim_start_matches("text").split_once("always parts").expect("properties");
    let mut judged = 0;
    for (line, said) in lines.lines().filter_map(|line| line.split_once(" // ")) {
        let tokens = format!("{chart} assume often down; {line} }}").parse().expect("tokens");
        let wanted = Wanted { recorded: false, prover: Some(&grafcet_prove::rule) };
        let errors = grafcet_conformance::chart::errors(&compile_with(&quote!(::grafcet), tokens, wanted).to_string());
        assert_eq!(errors.is_empty(), said.starts_with("proved"), "{line}: {errors:?}");
        judged += 1;
    }
    assert_eq!(judged, 4);
}

/// What the cookbook allows to be undecided is proved where there is a solver.
#[test]
fn what_the_cookbook_leaves_to_the_solver_is_proved() {
    const ALLOWED: &str = "#![allow(grafcet::property_undecided)]";
    let blocks = include_str!("../../../docs/cookbook.md").split("```").filter(|block| block.contains(ALLOWED));
    let mut judged = 0;
    for block in blocks {
        let chart = block.split_once("grafcet! {").and_then(|(_, rest)| rest.split_once("\n}")).expect("a chart").0;
        let tokens: TokenStream = chart.replace(ALLOWED, "").parse().expect("tokens");
        let said = |prover: Option<&Prover>| {
            let wanted = Wanted { recorded: false, prover };
            grafcet_conformance::chart::errors(&compile_with(&quote!(::grafcet), tokens.clone(), wanted).to_string())
        };
        assert_eq!(said(Some(&grafcet_prove::rule)), Vec::<String>::new());
        assert!(!said(None).is_empty(), "nothing is left to the solver");
        judged += 1;
    }
    assert_eq!(judged, 3);
}

/// What never happens, and what the assumptions leave, where it takes values and times to see that.
#[test]
fn what_says_nothing_is_found_by_the_solver() {
    let said = |lines: &str, prover: Option<&Prover>| {
        let chart = format!(
            "sfc Press {{ #![deny(grafcet::vacuous_property, grafcet::vacuous_assumption)] \
             input start, down: bool; #[allow(grafcet::unused_input)] input x, y: u64; input level: u8; output lower: bool; var parts: u8 = 0; \
             initial step Rest; step Press {{ lower; P1 parts = parts + 1; }} step Full {{ P1 parts = 0; }} \
             Rest -[start && parts < 3]-> Press -[10s/Press || down && level > 0]-> Rest; \
             Rest -[parts >= 3]-> Full -[!start]-> Rest; {lines} }}"
        );
        let wanted = Wanted { recorded: false, prover };
        let tokens = chart.parse().expect("tokens");
        grafcet_conformance::chart::errors(&compile_with(&quote!(::grafcet), tokens, wanted).to_string())
    };
    let prover: Option<&Prover> = Some(&grafcet_prove::rule);
    for (lines, what) in [
        ("always parts > 3 => start;", "`parts > 3` holds at the end of no cycle: nothing follows from it"),
        ("Press.T > 10s leads_to Rest;", "`Press.T > 10s` holds at the end of no cycle: nothing follows from it"),
        ("Press before parts > 3;", "`parts > 3` holds at the end of no cycle: nothing has to come before it"),
        (
            "assume never level < 9; assume often level > 3 && level / 3 < 3; Press before Full;",
            "`level > 3 && level/3 < 3` never holds, so it cannot come again and again",
        ),
    ] {
        let errors = said(lines, prover);
        assert!(matches!(&errors[..], [one] if one.starts_with(what)), "{lines}: {errors:?}");
    }
    for lines in
        ["always parts > 2 => !start || !lower || parts < 4;", "Press.T > 9s leads_to Rest;", "Press before parts > 2;"]
    {
        assert_eq!(said(lines, prover), Vec::<String>::new(), "{lines}");
    }
    // Without a solver nobody knows.
    let open = said("always parts > 3 => Full.X || !Full.X;", None);
    assert_eq!(open, Vec::<String>::new());
    // What leaves nothing, so that the conditions alone do not show it.
    let nothing = said("assume never (x ^ y) & y == y & !x; always parts <= 3;", prover);
    assert!(matches!(&nothing[..], [one] if one.contains("exclude every")), "{nothing:?}");
}

/// A proof about a time says what it knows of clocks, step by step, the narrowest bound of several.
#[test]
fn what_is_known_of_clocks_is_said() {
    let model = read(
        "sfc Press { input start, down: bool; output lower: bool; initial step Rest; step Press { lower; } step Full; \
         Rest -[start]-> Press -[10s/Press || down]-> Full -[5s/Full]-> Rest; assume cycle within 100ms; \
         Press leads_to Rest within 16s; }",
    );
    let program = counted(&model, &Facts::of(&model), Encoding::Regions).expect("a program");
    let [Verdict::Proved(proof)] = &verdicts(&model)[..] else { panic!("it is proved") };
    let said = words::clocks(&program, &proof.clocks);
    let expected = [
        "in Rest: nothing is waited for",
        "in Press: something is waited for, not before the first cycle, the time waited >= Press.T, Press.T < 10000 ticks, \
         the time waited <= Press.T",
        "in Full: something is waited for, not before the first cycle, the time waited >= Full.T, Full.T < 5000 ticks, \
         the time waited <= Full.T + 10100 ticks",
    ];
    assert_eq!(said, expected);
}
