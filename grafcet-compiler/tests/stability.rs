//! Which searches for stability are certain to end (A30).

use grafcet_compiler::analysis::{Concurrency, Facts, Stability, explore};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;

fn model(text: &str) -> Model {
    let text = format!("grafcet C {{ input a, b, c: bool; {text} }}");
    let mut sink = Sink::new();
    let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    let messages: Vec<String> = sink.finish().into_iter().flat_map(|d| d.notes).map(|(_, text)| text).collect();
    assert_eq!(messages, [""; 0], "{text}");
    model
}

fn stability(model: &Model) -> Stability {
    Stability::of(model, &Concurrency::of(model))
}

fn is_certain(model: &Model) -> bool {
    stability(model).is_certain()
}

/// What a source transition fills again and again can turn other steps on and off: such a search needs its bound.
#[test]
fn a_source_transition_may_keep_a_search_going() {
    let chart = |condition: &str| {
        let steps = "initial step S1; initial step S6; step S4; step S5;";
        model(&format!("{steps} S5 -[a]-> S6; S6 -[b]-> S1; S4 -[{condition}]-> S5; () -[a]-> S4;"))
    };
    assert!(!is_certain(&chart("S6.X")));
    assert!(is_certain(&chart("c")));
    // What is done on clearing is done again and again, wherever it stands.
    let drained = |first: &str, then: &str| {
        model(&format!("var n: u8 = 0; step S1; step S2; () -[a{first}]-> S1 -[a{then}]-> S2 -[!a]-> ();"))
    };
    let counts = " => n = n.wrapping_add(1)";
    assert!(is_certain(&drained("", "")));
    assert!(!is_certain(&drained(counts, "")));
    assert!(!is_certain(&drained("", counts)));
    // A convergence takes two at a time, so what is active can go on changing.
    assert!(!is_certain(&model("initial step S1; step S2; step S3; () -[a]-> S2; (S1, S2) -[b]-> S3 -[a]-> S1;")));
}

/// A search ends where each circle needs what does not hold twice in a cycle, or not together.
#[test]
fn a_circle_that_needs_what_holds_once_ends() {
    let ends = |text: &str| is_certain(&model(text));
    let ring = |last: &str| format!("initial step S1; step S2; step S3; S1 -[a]-> S2 -[b]-> S3 -[{last}]-> S1;");
    assert!(!ends(&ring("c")));
    // Somewhere else in the circle, not only in the neighbouring transition.
    assert!(ends(&format!("{} step S4; S3 -[c]-> S4 -[!b]-> S1;", ring("!a"))));
    assert!(!ends(&format!("{} step S4; S3 -[c]-> S4 -[b]-> S1;", ring("!a"))));
    // An edge of inputs is one in the first evolution (A2), one of a step in any.
    assert!(ends(&ring("rising(c) && a")));
    assert!(!ends(&ring("rising(c) || a")));
    assert!(!ends(&ring("rising(S3.X)")));
    // The time of a step begins anew with it, but one of zero has elapsed at once (A35).
    assert!(ends(&ring("5s/S3")));
    assert!(!ends(&ring("0s/S3")));
    assert!(!ends(&ring("5s/S1")));
    assert!(!ends(&ring("!(5s/S3)")));
    // What is entered while it is left goes on with its time (A4g).
    assert!(!ends("initial step S1; initial step S2; S1 -[5s/S1]-> S2 -[a]-> S1;"));
}

/// What a step forces or encloses is activated with it, by no other transition.
#[test]
fn partial_grafcets_end_one_after_the_other() {
    let ends = |text: &str| is_certain(&model(text));
    let above = |condition: &str| {
        format!(
            "partial Above {{ initial step S1; step S2 {{ force Below {{INIT}}; }} S1 -[a]-> S2 -[{condition}]-> S1; }}"
        )
    };
    let below = "partial Below { initial step S3; step S4; S3 -[b]-> S4; }";
    assert!(ends(&format!("{} {below}", above("!a"))));
    assert!(!ends(&format!("{} {below}", above("b"))));
    let modes = |condition: &str| {
        format!(
            "partial Modes {{ initial step S1; enclosing step S2 {{ partial Inner {{ linked step S3; step S4; \
             S3 -[b]-> S4 -[{condition}]-> S3; }} }} S1 -[rising(a)]-> S2 -[!a]-> S1; }}"
        )
    };
    assert!(ends(&modes("!b")));
    assert!(!ends(&modes("c")));
}

/// A loop that counts how often it turns, and turns while that is little, ends by itself.
#[test]
fn a_circle_that_counts_its_turns_ends() {
    let ends = |text: &str| is_certain(&model(text));
    let with = |ty: &str, count: &str, limit: &str| {
        format!(
            "var m: u8 = 0; var n: {ty} = 0; initial step S1; step S2 {{ {count} }} step S3; S1 -[a]-> S2 -[b]-> S3 -[{limit}]-> S2;"
        )
    };
    let asked = |limit: &str| with("u8", "P1 n = n + 1;", limit);
    for limit in ["n < 3", "c && n <= 2", "3 > n", "!(n >= 3)", "n == 1", "n < 3 && b || c && 2 > n", "!(n > 2 || c)"] {
        assert!(ends(&asked(limit)), "{limit}");
    }
    for limit in ["c", "n < 3 || c", "n != 3", "n > 0", "n < m", "m < 3", "!(n >= 3 && c)"] {
        assert!(!ends(&asked(limit)), "{limit}");
    }
    let counted = |count: &str| with("u8", count, "n < 3");
    let counts = ["P1 n = 2 + n;", "P1 { n += 1; m = n; }", "P1 n = n.wrapping_add(1);", "P1 n = n.saturating_add(1);"];
    for count in counts {
        assert!(ends(&counted(count)), "{count}");
    }
    for count in [
        "P1 n = n + 1 if c;",
        "P1 n = n + m;",
        "P1 n = n - 1;",
        "P1 n = n + 0;",
        "P1 n = 1;",
        "P1 { if c { n += 1; } }",
        "P1 { n += 1; n = 0; }",
        "P0 n = n + 1;",
        "on rising(c) n = n + 1;",
        "P1 n = n + 1; P0 n = 0;",
        "P1 n = n + 1; on rising(c) n = 0;",
    ] {
        assert!(!ends(&counted(count)), "{count}");
    }
    // From two on it is the last number of a type, or begins anew.
    assert!(ends(&counted("P1 n = n.wrapping_add(253);")));
    assert!(!ends(&counted("P1 n = n.wrapping_add(254);")));
    assert!(ends(&with("u16", "P1 n = n.wrapping_add(254);", "n < 3")));
    assert!(!ends(&with("i8", "P1 n = n + 1;", "n < 3")));
    // On a controller of 16 bits a `usize` has no more, and the second turn would begin it anew.
    for (ty, by) in [("usize", 32_767), ("u32", 65_535), ("u64", 65_535), ("u128", 65_535)] {
        assert!(ends(&with(ty, &format!("P1 n = n + {by};"), "n < 32_769")), "{ty}");
    }
    assert!(!ends(&with("usize", "P1 n = n + 32_768;", "n < 32_769")));
    // What a transition does when it clears counts as well.
    assert!(ends(&counted("").replace("[n < 3]-> S2", "[n < 3 => n = n + 1]-> S2")));
}

/// Nothing else on the way may write the count, every way round counts and is limited, and one step of it is active at a time.
#[test]
fn a_count_ends_a_circle_that_nothing_else_disturbs() {
    let ends = |text: &str| is_certain(&model(text));
    let with = |initial: &str, more: &str| {
        format!(
            "var n: u8 = 0; initial step S1; step S2 {{ P1 n = n + 1; }} {initial} step S3; step S4; S1 -[a]-> S2 -[b]-> S3 -[c && n < 3]-> S2; {more}"
        )
    };
    let ring = |more: &str| with("", more);
    assert!(ends(&ring("")));
    assert!(ends(&ring("S3 -[n < 2 && !c]-> S4 -[b]-> S2;")));
    assert!(!ends(&ring("").replace("step S3;", "step S3 { P1 n = 0; }")));
    assert!(!ends(&ring("").replace("[b]", "[b => n = 0]")));
    // A way round that is not limited, or that does not count.
    let forked = |condition: &str, to: &str| {
        ring("").replace("c && n < 3", "c && m && n < 3")
            + &format!("var m: bool; S3 -[!m{condition}]-> S4 -[b]-> {to};")
    };
    assert!(ends(&forked(" && n < 2", "S2")));
    assert!(!ends(&forked("", "S2")));
    assert!(!ends(&forked(" && n < 2", "S3")));
    // What is left and entered at once stays active, and does nothing anew (A4g).
    let alone = "var n: u8 = 0; initial step S1; step S2 { P1 n = n + 1; } S1 -[a]-> S2 -[n < 3]-> S2;";
    assert!(!ends(alone));
    // Two tokens, of which one may wait where the other one counts.
    assert!(!ends(&with("initial", "")));
    assert!(!ends(&ring("S2 -[b]-> S4;  S4 -[c]-> S3;")));
    assert!(!ends(&ring("").replace("-[b]-> S3 -[c", "-[b]-> (S3, S4) -[c")));
    // By hand the chart can be put anywhere.
    assert!(!ends(&format!("forceable; {}", ring(""))));

    // Who leaves for good takes the only token along, and does not come back to begin anew.
    let out = |condition: &str, back: &str| {
        ring("").replace("step S4;", "step S4 { P1 n = 0; }") + &format!("S3 -[{condition}]-> S4 -[{back}]-> S2;")
    };
    assert!(ends(&out("c && n >= 3", "!c")));
    assert!(!ends(&out("c && n >= 3", "c")));
    // Here it does not: both may clear.
    assert!(!ends(&out("c && n >= 2", "!c")));
    assert!(!ends(&out("c && n >= 3", "!c").replace("n < 3", "n < 4")));
    let spilt = |condition: &str| {
        ring("").replace("step S4;", "step S4 { P1 n = 0; } step S5;") + &format!("S3 -[{condition}]-> S4 -[b]-> S5;")
    };
    let forked = ring("S6 -[b]-> S4 -[b]-> S5;").replace("step S4;", "step S4 { P1 n = 0; } step S5; step S6;");
    assert!(!ends(&forked.replace("-[b]-> S3 -[c", "-[b]-> (S3, S6); S3 -[c")));
    assert!(ends(&spilt("n >= 3")));
    assert!(!ends(&spilt("b")));
    // A reset on the way out is no other.
    let left = |step: &str| {
        ring("").replace("step S4;", "step S4 { P0 n = 0; }") + &format!("{step} -[c && n >= 3]-> S4 -[!c]-> S1;")
    };
    assert!(ends(&left("S3")));
    assert!(!ends(&left("S3").replace("P0 n = 0", "N n = 0")));
    // What is forced is not activated where it is active already.
    let ordered = |count: &str, inside: &str| {
        format!(
            "var n: u8 = 0; partial Own {{ initial step S1; step S2 {{ {count} force Other {{T1}}; }} step S3; S1 -[a]-> S2 -[b]-> S3 -[c && n < 3]-> S2; }} \
             partial Other {{ initial step T1 {{ {inside} }} }}"
        )
    };
    assert!(!ends(&ordered("", "P1 n = n + 1;")));
    // And what a circle forces would begin anew as often as it turns.
    assert!(!ends(&ordered("P1 n = n + 1;", "")));
    assert!(ends(&ordered("P1 n = n + 1;", "").replace("force Other {T1};", "")));
    // Another partial grafcet that resets it in a circle of its own.
    let beside = |condition: &str| {
        let other =
            format!("partial Other {{ initial step T1; step T2 {{ P1 n = 0; }} T1 -[a]-> T2 -[{condition}]-> T1; }}");
        ring("").replacen("initial step S1", "partial Own { initial step S1", 1) + "}" + &other
    };
    assert!(ends(&beside("!a").replace("P1 n = 0;", "")));
    assert!(ends(&beside("!a")));
    assert!(!ends(&beside("b")));
}

/// A search that a count ends has to end before its bound, as somebody who knows nothing of that would stop it there.
#[test]
fn a_count_ends_a_circle_within_the_bound() {
    let chain = |limit: u32| {
        let steps = "step S4; step S5; step S6; step S7; step S8; step S9; step S10; step S11;";
        let chain = "S3 -[!b]-> S4 -[!b]-> S5 -[!b]-> S6 -[!b]-> S7 -[!b]-> S8 -[!b]-> S9 -[!b]-> S10 -[!b]-> S11;";
        format!(
            "initial step S1; step S2 {{ P1 n = n + 1; }} step S3; {steps} S1 -[a]-> S2 -[b]-> S3 -[n < {limit}]-> S2; {chain}"
        )
    };
    let may_go_on = |text: &str| {
        let model = model(&format!("var n: u8 = 0; {text}"));
        assert!(is_certain(&model), "{text}");
        Facts::of(&model).searches(&model).may_go_on
    };
    // Two transitions: eleven steps give 24 evolutions, of which eleven transitions may take one each.
    assert!(!may_go_on(&chain(5)));
    assert!(may_go_on(&chain(6)));
    assert!(!may_go_on(&format!("max_evolutions 17; {}", chain(2))));
    assert!(may_go_on(&format!("max_evolutions 16; {}", chain(2))));
    // Who puts the chart into the loop once more lets it begin anew.
    let forced = |step: &str| {
        let above = format!(
            "partial Above {{ initial step T1; step T2 {{ force Own {{{step}}}; }} T1 -[c]-> T2 -[!c]-> T1; }}"
        );
        let alone = chain(4).replace("S3 -[!b]", "S3 -[!b && n >= 4]");
        format!("{above} partial Own {{ {alone} }}")
    };
    assert!(!may_go_on(&forced("S1")));
    assert!(may_go_on(&forced("S2")));
}

/// A proof counts where the search ends before its bound: partial grafcets that begin each other anew may take longer.
#[test]
fn a_search_that_ends_may_be_too_long() {
    let may_go_on = |text: &str| {
        let model = model(text);
        assert!(is_certain(&model), "{text}");
        Facts::of(&model).searches(&model).may_go_on
    };
    let chart = |times: usize, waits: &str| {
        let one = |time: usize| {
            let from = if time == 0 { "M0 -[a]->".to_owned() } else { format!("M{} -[{waits}]->", 2 * time) };
            let (forces, waiting) = (2 * time + 1, 2 * time + 2);
            format!("step M{forces} {{ force Below {{T1}}; }} step M{waiting}; {from} M{forces} -[true]-> M{waiting};")
        };
        let above = (0..times).map(one).collect::<Vec<_>>().concat();
        let below = "initial step T1; step T2; step T3; step T4; step T5; step T6; step T7; step T8; step T9;";
        let chain = "T1 -[a || b]-> T2 -[true]-> T3 -[true]-> T4 -[true]-> T5 -[true]-> T6 -[true]-> T7 -[true]-> T8 -[true]-> T9 -[rising(b)]-> T1;";
        format!("partial Above {{ initial step M0; {above} }} partial Below {{ {below} {chain} }}")
    };
    // With n times above: 2n + 1 + 9 steps give 4n + 22 evolutions, of which each time takes ten.
    assert!(!may_go_on(&chart(2, "T9.X")));
    assert!(may_go_on(&chart(5, "T9.X")));
    // Without the wait all goes on at once.
    assert!(!may_go_on(&chart(5, "true")));

    // Five tokens go one after the other through the same steps, each when the one before is at the end.
    let tokens = |wait: &str| {
        let one = |at: usize| format!("step B{at}; B{at} -[{wait} && !B{}.X]-> T0;", at - 1);
        let (waiting, steps) =
            ((1..5).map(one).collect::<Vec<_>>().concat(), "step T0; step T1; step T2; step T3; step T4; step T5;");
        let ways = "Start -[a]-> (B0, B1, B2, B3, B4); B0 -[a]-> T0 -[a]-> T1 -[a]-> T2 -[a]-> T3 -[a]-> T4 -[a]-> T5 -[a]-> ();";
        format!("initial step Start; step B0; {waiting} {steps} {ways}")
    };
    assert!(may_go_on(&tokens("T5.X")));
    // A stop leaves both branches, and enters its step once.
    let stop = "initial step Start; step A; step B; Start -[a]-> (A, B); (A, B) -[!a]-> Start; any -[b && !a]-> Start;";
    let stop = model(stop);
    assert!(stability(&stop).is_at_once());

    // Who resets a count lets its circle turn anew.
    let reset = |times: usize, reset: &str| {
        let turns = "initial step S1; step S2; step S3 { P1 n = n + 1; } S1 -[a]-> S2 -[b && n < 2]-> S3 -[true]-> S2;";
        let one = |time: usize| format!("step X{time} {{ {reset} }} X{} -[S2.X && n >= 2]-> X{time};", time - 1);
        let other = (1..=times).map(one).collect::<Vec<_>>().concat();
        format!("var n: u8 = 0; var m: u8 = 0; partial Own {{ {turns} }} partial Other {{ initial step X0; {other} }}")
    };
    assert!(!may_go_on(&reset(2, "P1 m = 0;")));
    assert!(!may_go_on(&reset(5, "P1 m = 0;")));
    assert!(may_go_on(&reset(5, "P1 n = 0;")));
    assert!(may_go_on(&reset(5, "P0 n = 0;")));
    assert!(may_go_on(&reset(5, "").replace("n >= 2]", "n >= 2 => n = 0]")));
    // And whoever is begun anew resets it each time.
    let ends = |force: &str| {
        let one = |time: usize| {
            let (from, at, to) = (2 * time, 2 * time + 1, 2 * time + 2);
            format!("step M{at} {{ {force} }} step M{to}; M{from} -[a]-> M{at} -[true]-> M{to};")
        };
        let above = (0..4).map(one).collect::<Vec<_>>().concat();
        let model = model(&format!("{} partial Above {{ initial step M0; {above} }}", reset(1, "P1 n = 0;")));
        Facts::of(&model).all_end(&model)
    };
    assert!(ends(""));
    assert!(!ends("force Other {X0};"));
}

/// A sequence has no second evolution after a step that nothing can leave in the cycle in which it is entered.
#[test]
fn a_search_ends_with_a_step_that_nothing_leaves_at_once() {
    let ends = |text: &str| {
        let model = model(text);
        let stability = stability(&model);
        let ends = stability.ends();
        ends.steps().iter().map(|step| model.steps[*step].name.to_string()).collect::<Vec<_>>()
    };
    let ring = |last: &str| format!("initial step S1; step S2; step S3; S1 -[a]-> S2 -[b]-> S3 -[{last}]-> S1;");
    assert_eq!(ends(&ring("c")), [""; 0]);
    assert_eq!(ends(&ring("c && !b")), ["S3"]);
    assert_eq!(ends(&ring("c && !a")), ["S1"]);
    // A time begins with the step; one of zero has elapsed at once (A35).
    assert_eq!(ends(&ring("c && 5s/S3")), ["S3"]);
    assert_eq!(ends(&ring("c && S3.T >= 1ms")), ["S3"]);
    assert_eq!(ends(&ring("c && 0s/S3")), [""; 0]);
    assert_eq!(ends(&ring("c || 5s/S3")), [""; 0]);
    assert_eq!(ends(&ring("!(5s/S3)")), [""; 0]);
    // The second evolution sees no edge of an input (A2), but may see one of a step.
    assert_eq!(ends(&ring("rising(c)")), ["S3"]);
    assert_eq!(ends(&ring("rising(S3.X)")), [""; 0]);
    // Several ways in and out: each pair of them counts.
    let ways = |last: &str| format!("{} S3 -[{last}]-> S2;", ring("5s/S3"));
    assert_eq!(ends(&ways("rising(c)")), ["S3"]);
    assert_eq!(ends(&ways("c")), [""; 0]);
    // Nothing leaves the last step; it can be left and entered at once, which changes nothing (A4g).
    assert_eq!(ends("initial step S1; step S2; S1 -[a]-> S2;"), ["S2"]);
    let back = |done: &str| format!("var n: u8 = 0; initial step S1; step S2; S1 -[a]-> S2; S2 -[5s/S2{done}]-> S2;");
    assert_eq!(ends(&back("")), ["S2"]);
    // But what is done on clearing is done again.
    assert_eq!(ends(&back(" => n = n.wrapping_add(1)")), [""; 0]);
    let always = |text: &str| stability(&model(text)).ends().always();
    assert!(always("initial step S1; step S2; S1 -[a && 2s/S1]-> S2 -[rising(b)]-> S1;"));
    assert!(!always("initial step S1; step S2; S1 -[a && 2s/S1]-> S2 -[b]-> S1;"));
    // Beside others, what follows is not known.
    assert_eq!(ends("initial step S1; initial step S2; step S3; S1 -[5s/S1]-> S3 -[5s/S3]-> S1;"), [""; 0]);
}

/// Where the circles do not tell, all inputs are tried from all situations that can be reached.
#[test]
fn what_the_circles_do_not_tell_is_tried() {
    let settles = |text: &str, work| {
        let model = model(text);
        explore::settles(&model, &Facts::of(&model), work)
    };
    let tried = |text: &str| {
        assert!(!is_certain(&model(text)), "{text}");
        settles(text, 10_000)
    };
    // Each of the two goes round only while the other one does, which takes `a` and `!a`.
    let pair = |there: &str, back: &str| {
        format!(
            "partial Ram {{ initial step Open; step Shut; Open -[Feeder::Placed.X]-> Shut -[Feeder::Rest.X]-> Open; }} \
             partial Feeder {{ initial step Rest; step Placed; \
             Rest -[({there}) && Ram::Open.X]-> Placed -[({back}) && Ram::Shut.X]-> Rest; }}"
        )
    };
    assert!(tried(&pair("a", "!a")));
    assert!(!tried(&pair("a", "b")));
    // A time begins anew with its step; one of zero has elapsed at once (A35).
    assert!(tried(&pair("a || 5s/Rest", "!a")));
    assert!(!tried(&pair("a || 0s/Rest", "!a")));
    // In all situations, one of the steps would chase the other; in those that can be reached, they never meet.
    let ring = "initial step S1; step S2; step S3; step S4; S2 -[S4.X]-> S3 -[S4.X]-> S2; S1 -[a]-> S2;";
    assert!(tried(&format!("{ring} S1 -[!a]-> S4;")));
    assert!(!tried(&format!("{ring} S1 -[a && b]-> S4;")));
    // What is not known at each moment of a cycle tells nothing.
    let counted = |bound: &str| {
        format!("output n: u8 = 0; initial step S1; step S2 {{ P1 n = n % 9 + 1; }} S1 -[a {bound}]-> S2 -[a]-> S1;")
    };
    assert!(!tried(&counted("&& n < 3")));
    // The bound is the chart's own, and so is the effort.
    let long = "max_evolutions 1; initial step S1; step S2; step S3; S1 -[a]-> S2 -[S2.X && b]-> S3 -[!a]-> S1;";
    assert!(!settles(long, 10_000));
    assert!(!settles(&pair("a", "!a"), 10));
}
