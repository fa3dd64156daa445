//! The prover beside a naive exploration, and the check of its proofs.

mod asked;
mod evolutions;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_compiler::program::counted;
use grafcet_conformance::prove::{Bounds, Counts, Kind, number};
use grafcet_prove::circuit::Circuit;
use grafcet_prove::task::{Invariant, Task};
use grafcet_prove::{Limit, Verdict, certificate, decide, words};
use std::time::Duration;

fn read(text: &str) -> Model {
    let mut sink = Sink::new();
    let tokens = text.parse().expect("tokens");
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink)).expect("a chart");
    assert!(sink.finish().iter().all(|message| message.rule.is_some()), "it is understood");
    model
}

fn verdicts(model: &Model) -> Vec<Verdict> {
    let program = counted(model, &Facts::of(model)).expect("a program");
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

/// A proof speaks of an enum by its variants.
#[test]
fn a_proof_names_the_variants() {
    let model = read(
        "sfc Press { input go: bool; output ram: bool; var mode: Mode in {Idle, Busy, Done} = Mode::Idle;
         initial step Rest; step Run { P1 mode = Mode::Busy; } step End { ram; P1 mode = Mode::Done; }
         Rest -[go]-> Run -[!go]-> End -[go]-> Rest; never ram && mode == Mode::Busy; }",
    );
    let program = counted(&model, &Facts::of(&model)).expect("a program");
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
    let program = counted(&model, &Facts::of(&model)).expect("a program");
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

/// A proof about a time says what it knows of clocks, step by step, the narrowest bound of several.
#[test]
fn what_is_known_of_clocks_is_said() {
    let model = read(
        "sfc Press { input start, down: bool; output lower: bool; initial step Rest; step Press { lower; } step Full; \
         Rest -[start]-> Press -[10s/Press || down]-> Full -[5s/Full]-> Rest; assume cycle within 100ms; \
         Press leads_to Rest within 16s; }",
    );
    let program = counted(&model, &Facts::of(&model)).expect("a program");
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
