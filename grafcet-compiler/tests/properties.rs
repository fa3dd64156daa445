//! `never`, `always`, `home`: proved, violated by the shortest way, or undecided with a reason.

use std::fmt::Write as _;

use grafcet_compiler::diagnostic::{Diagnostic, Sink};
use grafcet_compiler::{check, model, parse};

/// What is said about a chart.
fn diagnostics(chart: &str) -> Vec<Diagnostic> {
    let mut sink = Sink::new();
    let tokens = chart.parse().expect("tokens");
    if let Some(chart) = parse::chart(tokens, &mut sink) {
        let model = model::resolve(&chart, &mut sink);
        check::drawing(&model, &mut sink);
        if !sink.has_errors() {
            check::evolution(&model, &mut sink);
        }
    }
    sink.finish()
}

/// `rule: first message` of everything that is said.
fn said(chart: &str) -> Vec<String> {
    let text = |one: Diagnostic| format!("{}: {}", one.rule.map_or("notation", |rule| rule.name), one.notes[0].1);
    diagnostics(chart).into_iter().map(text).collect()
}

/// The chart is right.
fn holds(chart: &str) {
    assert_eq!(said(chart), Vec::<String>::new(), "{chart}");
}

/// The only thing that is wrong with the chart; returned are the lines of its message behind the first.
fn fails(chart: &str, rule: &str, word: &str) -> Vec<String> {
    let said = said(chart);
    let [one] = &said[..] else { panic!("{chart}: {said:#?}") };
    assert!(one.starts_with(&format!("{rule}: ")) && one.contains(word), "{chart}: {one}");
    one.lines().skip(1).map(str::to_owned).collect()
}

/// `never` and `always` in a chart of two steps.
fn motor(property: &str) -> String {
    format!(
        "sfc Motor {{ input on, off, hot: bool; output relay, green, red: bool; \
         initial step Off {{ N red; }} step On {{ N relay; N green if !hot; }} \
         Off -[on && !hot]-> On -[off || hot]-> Off; {property} }}"
    )
}

#[test]
fn what_holds() {
    for property in [
        "never red && relay;",
        "never Off.X && On.X;",
        "always Off.X || On.X;",
        "always relay => On.X;",
        "always red == Off.X;",
        "always green => !hot && On.X;",
        "always red != relay;",
        "never relay && hot;",
        "home Off;",
        "home On;",
        "never !(relay || red);",
    ] {
        holds(&motor(property));
    }
}

#[test]
fn what_does_not() {
    let table = fails(&motor("never relay && off;"), "property_violated", "at the end of cycle 2 `relay && off` holds");
    assert_eq!(
        table,
        [
            "cycle | inputs        | cleared  | active",
            "1     | any           | -        | Off",
            "2     | on, !hot, off | Off → On | On"
        ]
    );
    let table = fails(
        &motor("always relay => green && !off;"),
        "property_violated",
        "`relay` holds and `green && !off` does not",
    );
    assert_eq!(table.len(), 3);
    let table =
        fails(&motor("always !red;"), "property_violated", "at the end of the first cycle `!red` does not hold");
    assert_eq!(table, ["cycle | inputs | cleared | active", "1     | any    | -       | Off"]);
    let all = diagnostics(&motor("never relay; home Off; never red;"));
    assert_eq!(all.len(), 2);
}

/// In a `grafcet` the first cycle evaluates conditions, and transient situations are not seen.
#[test]
fn grafcet() {
    let chart = |property: &str| {
        format!(
            "grafcet Line {{ input a, b: bool; output q, r: bool; initial step One {{ q; }} step Two {{ S r; }} step Three {{ R r; }} \
             One -[a]-> Two -[b]-> Three -[!a]-> One; {property} }}"
        )
    };
    let table = fails(&chart("never Two.X;"), "property_violated", "at the end of the first cycle `Two.X` holds");
    assert_eq!(table[1], "1     | a, !b  | One → Two | Two");
    holds(&chart("never Two.X && b;"));
    holds(&chart("always r == Two.X;"));
    holds(&chart("never q && r;"));
    holds(&chart("home One;"));
    let table = fails(&chart("never Three.X && r || One.X && !b && !a;"), "property_violated", "first cycle");
    assert_eq!(table[1], "1     | !a, !b | -       | One");
}

/// Stored outputs are followed from cycle to cycle.
#[test]
fn stored_outputs() {
    let chart = |property: &str| {
        format!(
            "sfc Door {{ input open, shut: bool; output light, lock: bool; initial step Wait; step Opening {{ S light; P1 lock = false; }} \
             step Shutting {{ P1 lock = open; }} step Shut {{ R light; }} \
             Wait -[open]-> Opening -[shut]-> Shutting -[true]-> Shut -[true]-> Wait; {property} }}"
        )
    };
    holds(&chart("always Opening.X || Shutting.X => light;"));
    holds(&chart("never Wait.X && light;"));
    holds(&chart("never Opening.X && lock;"));
    let table = fails(&chart("never Wait.X && lock;"), "property_violated", "cycle 5");
    assert_eq!(table.len(), 6);
    assert!(table[3].starts_with("3     | open, shut "), "{table:#?}");
}

#[test]
fn assumptions_make_it_hold() {
    let chart = |assumption: &str| {
        format!(
            "grafcet Hoist {{ input up, down: bool; output raise, lower: bool; initial step Wait; step Raise {{ raise; }} step Lower {{ lower; }} \
             #[allow(grafcet::overlapping_branches, grafcet::unsafe_step)] Wait -[up]-> Raise -[!up]-> Wait -[down]-> Lower -[!down]-> Wait; \
             {assumption} never raise && lower; never up && down && Wait.X; }}"
        )
    };
    let all = said(&chart("#[allow(grafcet::unsafe_step)]"));
    assert!(all.iter().any(|one| one.starts_with("property_violated")), "{all:?}");
    holds(&chart("assume never up && down;"));
}

/// Times count as unknown.
#[test]
fn times() {
    let chart = |property: &str| {
        format!(
            "sfc Oven {{ input start, door: bool; output lamp, fan, horn, heat: bool; initial step Idle {{ D 5s horn; }} \
             step Bake {{ L 10s heat; N lamp if 2s/Bake; SD 3s fan; }} step Cool {{ R fan; }} \
             Idle -[start]-> Bake -[30s/Bake]-> Cool -[door && 5s/Cool]-> Idle; {property} }}"
        )
    };
    holds(&chart("never lamp && Idle.X;"));
    holds(&chart("home Idle;"));
    let table = fails(&chart("never Cool.X;"), "property_violated", "cycle 3");
    assert_eq!(table[3], "3     | Bake.T >= 30s | Bake → Cool | Cool");
    fails(&chart("always Bake.X => lamp;"), "property_violated", "cycle 2");
}

/// Qualifiers with times: while they act, an output may be on or off.
#[test]
fn timed_outputs() {
    let chart = |property: &str| {
        format!(
            "sfc Oven {{ input start, door: bool; output heat, horn, fan, lamp, bell: bool; \
             initial step Idle {{ D 5s horn; R lamp; R bell; }} step Bake {{ L 10s heat; SD 3s fan; DS 3s lamp; SL 3s bell; }} \
             step Cool {{ R fan; }} \
             Idle -[start]-> Bake -[30s/Bake]-> Cool -[door && 5s/Cool]-> Idle; {property} }}"
        )
    };
    for property in [
        "never heat && Idle.X;",
        "never heat && Cool.X;",
        "always horn => Idle.X;",
        "never fan && Cool.X;",
        "never fan && Idle.X;",
        "never lamp && Idle.X;",
        "never bell && Idle.X;",
    ] {
        holds(&chart(property));
    }
    for (property, cycle) in [
        ("never heat;", "cycle 2"),
        ("always Bake.X => heat;", "cycle 2"),
        ("never horn;", "the first cycle"),
        ("never fan && heat;", "cycle 2"),
        ("never lamp && Cool.X;", "cycle 3"),
        ("never bell && Cool.X;", "cycle 3"),
        ("always Cool.X => lamp || bell;", "cycle 3"),
    ] {
        fails(&chart(property), "property_violated", cycle);
    }
}

#[test]
fn hierarchy() {
    let chart = |property: &str| {
        format!(
            "grafcet Cell {{ input estop, start, full: bool; output belt, lamp: bool; \
             partial Safety {{ initial step Ready; step Stopped {{ force Production {{}}; lamp; }} step Restart {{ force Production {{INIT}}; }} \
             Ready -[estop]-> Stopped -[!estop]-> Restart -[true]-> Ready; }} \
             partial Production {{ initial step Idle; step Feed {{ belt; }} enclosing step Auto {{ partial Inner {{ linked step Count; }} }} \
             Idle -[start]-> Feed -[full]-> Auto -[!full]-> Idle; }} {property} }}"
        )
    };
    holds(&chart("never Stopped.X && belt;"));
    holds(&chart("always Count.X == Auto.X;"));
    holds(&chart("home (Ready, Idle);"));
    holds(&chart("home Stopped;"));
    fails(&chart("home (Stopped, Idle);"), "not_home", "is never reached");
    fails(&chart("never Production::Auto.X && full;"), "property_violated", "first cycle");
}

#[test]
fn home() {
    let chart = |body: &str| {
        format!(
            "#[allow(grafcet::unused_input)] sfc C {{ input a, b, c: bool; initial step One; step Two; step Three; step Four; step Five; {body} }}"
        )
    };
    // From Four there is no way back: Two is entered on `b`, so that there is no edge.
    let lost = "One -[b]-> Three; Three -[c]-> Two; Four -[b]-> Two; Two -[rising(b)]-> Five; Five -[b]-> One; Two -[true]-> Four;";
    fails(
        &chart(&format!("{lost} home One;")),
        "not_home",
        "from `Two`, reached so, there is no way back to exactly `One`",
    );
    holds(&chart(&format!("{} home One;", lost.replace("Four -[b]", "Four -[a]"))));
    let all = diagnostics(
        "sfc C { input a, b: bool; initial step A; step B; step C; A -[a]-> B -[!a]-> A; B -[b]-> C -[a]-> C; home A; }",
    );
    let notes: Vec<_> = all.iter().flat_map(|one| &one.notes).map(|(_, text)| &text[..]).collect();
    assert!(notes[0].starts_with("from `C`, reached so, there is no way back to exactly `A`"), "{notes:?}");
    assert!(notes[1].starts_with("once this transition has cleared"), "{notes:?}");
    let parallel = "sfc C { input a, b: bool; initial step A; step B; step E; A -[a]-> (B, E); (B, E) -[b]-> A;";
    holds(&format!("{parallel} home (B, E); home (E, B); home A; }}"));
    fails(&format!("{parallel} home B; }}"), "not_home", "is never reached");
}

/// What is not followed proves nothing, neither way.
#[test]
fn unfollowed() {
    let count = |property: &str, back: &str| {
        format!(
            "sfc Count {{ input go: bool; output full: bool; var n: u8; initial step Idle {{ P1 n = 0; }} \
             step Add {{ P1 n = n + 1; }} step Wait; step Full {{ N full; }} \
             Idle -[go]-> Add -[!go]-> Wait; Wait -[n >= 3]-> Full; Wait -[n < 3 && go]-> {back}; Full -[!go]-> Idle; {property} }}"
        )
    };
    // Whether three is ever reached is not followed.
    let said = fails(&count("home Idle;", "Add"), "property_undecided", "depends on `n`");
    assert!(said.is_empty());
    // Whatever the count is, there is a way back.
    holds(&count("home Idle;", "Idle"));
    holds(&count("always full => Full.X;", "Add"));
    fails(&count("never full;", "Add"), "property_undecided", "depends on `n`");
    let opaque = |property: &str| {
        format!(
            "sfc C {{ input x, y: u8; initial step A; step B; A -[near(x) && y > 3]-> B -[y < 2]-> A; {property} }}"
        )
    };
    fails(&opaque("never B.X;"), "property_violated", "cycle 2");
    holds(&opaque("home A;"));
    fails(&opaque("never B.X && near(y);"), "property_undecided", "depends on");
    let allowed = "#[allow(grafcet::property_undecided)] never full;";
    holds(&count(allowed, "Add"));
}

/// Comparisons of one float with literals are related to each other.
#[test]
fn floats() {
    let chart = |ty: &str, property: &str| {
        format!(
            "sfc Heater {{ input temp: {ty}; output heat: bool; initial step Cold {{ N heat; }} step Warm; \
             Cold -[temp > 80.5]-> Warm -[temp <= 60.1]-> Cold; {property} }}"
        )
    };
    for ty in ["f32", "f64"] {
        holds(&chart(ty, "home Cold;"));
        holds(&chart(ty, "never Warm.X && temp < 60.1 && temp > 60.2;"));
        let table = fails(&chart(ty, "never Warm.X && temp < 90.0;"), "property_violated", "cycle 2");
        assert!(table[2].contains("temp > 80.5, temp < 90 "), "{table:#?}");
        let table = fails(&chart(ty, "never Cold.X && temp == 60.1;"), "property_violated", "the first cycle");
        assert!(table[1].contains("temp == 60.1"), "{table:#?}");
    }
}

/// Variables that change within a cycle of a `grafcet` in ways that are not followed.
#[test]
fn unfollowed_within_a_cycle() {
    let chart = |property: &str| {
        format!(
            "grafcet C {{ input go: bool; var n: u8; initial step A; step B {{ P1 n = n + 1; }} step C; step Zero {{ P1 n = 0; }} \
             A -[n == 0]-> B -[n != 0]-> C; C -[go]-> Zero; Zero -[!go]-> A; {property} }}"
        )
    };
    let undecided = said(&chart("never C.X;"));
    assert!(undecided.iter().any(|one| one.starts_with("property_undecided")), "{undecided:?}");
}

/// Eight partial grafcets that have nothing to do with each other: too many situations to look at.
#[test]
fn budget() {
    let mut chart = String::from("grafcet Wide { input a, b, c, d: bool; output q: bool; ");
    for index in 0..8 {
        let steps: Vec<String> = (0..8).map(|step| format!("S{index}{step}")).collect();
        _ = write!(chart, "partial Part{index} {{ initial step {} {{ q; }} ", steps[0]);
        for step in &steps[1..] {
            _ = write!(chart, "step {step}; ");
        }
        let chain: Vec<String> = steps
            .iter()
            .enumerate()
            .map(|(at, step)| {
                format!("{step} -[{}]-> ", ["a", "!b", "c", "!d", "!a", "b", "!c", "d"][(at + index) % 8])
            })
            .collect();
        _ = write!(chart, "{}{}; }} ", chain.concat(), steps[0]);
    }
    // The steps of one partial grafcet exclude each other, whatever the others do.
    holds(&format!("{chart} budget 20; never S00.X && S03.X || S41.X && S47.X; }}"));
    let message = said(&format!("{chart} budget 20; always q; }}"));
    assert!(message[0].contains("the budget ran out after") && message[0].contains("`budget 100_000;`"), "{message:?}");
}

#[test]
fn contents() {
    let chart = |property: &str| {
        format!(
            "grafcet C {{ input a: bool; input level: u8; output q: bool; output speed: u8; var v: bool; \
             initial step A {{ q; speed = level; }} macro step M {{ entry step E; exit step F {{ S v; }} E -[a]-> F; }} step B {{ R v; }} \
             A -[rising(a)]-> M -[!a && v]-> B -[a]-> A; {property} }}"
        )
    };
    holds(&chart("never M.X && A.X; always level > 5 && A.X => q; never F.X && E.X; always true;"));
    for (property, word) in [
        ("never speed > 3;", "`speed`"),
        ("never v && A.X;", "`v` is a variable"),
        ("never rising(a) && B.X;", "an edge takes two"),
        ("never 5s/A;", "this is a time"),
        ("always A.T < 5s;", "this is a time"),
        ("never 5s/a;", "this is a time"),
        ("always a => w;", "unknown_name"),
        ("home Nowhere;", "unknown_step"),
        ("home M;", "is a macro-step"),
        ("home (B, B);", "repeated_step"),
        ("home a;", "unknown_step"),
        ("never A && a;", "`A` is a step"),
    ] {
        let said = said(&chart(property));
        assert!(matches!(&said[..], [one] if one.contains(word)), "{property}: {said:?}");
    }
    let inside =
        "grafcet C { input a: bool; partial Part { initial step A; step B; A -[a]-> B -[!a]-> A; never B.X; } }";
    assert!(said(inside)[0].contains("stands directly in it"), "{:?}", said(inside));
}

/// What only a property reads is used.
#[test]
fn usage() {
    holds("sfc C { input a, b: bool; initial step A; step B; A -[a]-> B -[!a]-> A; always b || !b; }");
}

/// A long chart overflows no stack, and the budget ends what takes too long.
#[test]
fn long() {
    for dialect in ["sfc", "grafcet"] {
        let mut chart = format!("{dialect} Long {{ input a: bool; output q: bool; initial step Step0 {{ q; }} ");
        for step in 1..3_000 {
            _ = write!(chart, "step Step{step} {{ q if !a; }} ");
        }
        for step in 0..3_000 {
            _ = write!(chart, "Step{step} -[{}a]-> ", if step % 2 == 0 { "" } else { "!" });
        }
        let said = said(&format!("{chart} Step0; never q && Step1.X && a; always q || a; }}"));
        let undecided = |one: &String| one.starts_with("property_undecided") && one.contains("budget");
        assert!(said.iter().all(undecided), "{said:?}");
    }
}

/// The time of an active step only grows: who has to do something in time can be too late.
#[test]
fn in_time() {
    let both = |steps: &str| {
        ["sfc", "grafcet"].map(|dialect| {
            format!(
                "#[allow(grafcet::unused_input)] {dialect} C {{ input a, b, c: bool; initial step O; {steps} home O; }}"
            )
        })
    };
    let late = |steps: &str, word: &str| {
        for chart in both(steps) {
            fails(&chart, "not_home", word);
        }
    };
    let kept = |steps: &str| both(steps).iter().for_each(|chart| holds(chart));
    late(
        "step A; O -[a]-> A -[b && A.T < 5s]-> O;",
        "who waits in `A` until `A.T >= 5s` has no way back to exactly `O`",
    );
    late("step A; O -[a]-> A -[b && !(5s/A)]-> O;", "until `A.T >= 5s`");
    late("step A; step B; O -[a]-> A -[b]-> B -[c && A.X || B.T == 5s]-> O;", "until `B.T >= 5001ms`");
    // Whoever is late has another way, or begins anew.
    kept("step A; step B; O -[a]-> A -[b && A.T < 5s]-> O; A -[A.T >= 5s]-> B -[b]-> O;");
    kept("step A; step B; O -[a]-> A -[b && A.T < 5s]-> O; A -[!b && c]-> B -[a && B.T >= 2s]-> A;");
    // Nobody has to wait here, but the next cycle can come late.
    late("step A; step B; O -[a]-> A -[b && A.T < 5s]-> O; A -[!b && A.T < 5s]-> B -[b]-> O;", "until `A.T >= 5s`");
    // The time of another step, which goes on.
    late(
        "step A; step B; step C; step E; O -[a]-> (A, B); B -[c && A.T < 5s]-> C; B -[!c && b]-> E -[!b]-> B; (A, C) -[b]-> O;",
        "until `A.T >= 5s`",
    );
}

/// A property is not broken by a time that falls back.
#[test]
fn times_that_pass() {
    let chart = |property: &str| {
        format!(
            "sfc C {{ input a: bool; output late, quick: bool; initial step O {{ R late; }} \
             step A {{ S late if A.T >= 5s; N quick if A.T < 5s; }} O -[a]-> A -[a]-> O; {property} }}"
        )
    };
    holds(&chart("never late && quick;"));
    let table = fails(&chart("never late && A.X;"), "property_violated", "cycle 3");
    assert_eq!(table[3], "3     | !a, A.T >= 5s | -       | A");
}

/// Two partial grafcets: what is asked of the first has nothing to do with the second.
fn beside(first: &str, second: &str, rest: &str) -> String {
    format!(
        "grafcet C {{ #![allow(grafcet::unused_input, grafcet::undriven_output, grafcet::unused_variable)] \
         input a, b, c, d, e: bool; input level: u16; input text: Text; output q, r, s: bool; var n: u16 = 0; \
         partial One {{ {first} }} partial Two {{ {second} }} {rest} }}"
    )
}

#[test]
fn home_speaks_of_the_partial_grafcets_that_hold_its_steps() {
    let (first, second) =
        ("initial step A; step B; A -[a]-> B -[!a]-> A;", "initial step U; step V; U -[rising(c)]-> V -[d]-> U;");
    for rest in ["home A;", "home U;", "home (A, U);", "home (B, V);", "home V;"] {
        holds(&beside(first, second, rest));
    }
    // The second never comes back, which is nothing to the first.
    let once = "initial step U; final step V; U -[c]-> V;";
    holds(&beside(first, once, "home A;"));
    fails(&beside(first, once, "home (A, U);"), "not_home", "exactly `(A, U)` in `One` and `Two`");
    let lost = "initial step A; step B; final step E; A -[a]-> B -[!a]-> A; B -[c && a]-> E;";
    let table = fails(
        &beside(lost, second, "home A;"),
        "not_home",
        "from `E`, reached so, there is no way back to exactly `A` in `One`",
    );
    assert_eq!(table.last().map(String::as_str), Some("1     | a, c   | A → B, B → E | E"));
    // Parallel branches: exactly these in their partial grafcet.
    let parallel = "initial step A; step B; step E; A -[a]-> (B, E) -[!a]-> A;";
    holds(&beside(parallel, second, "home (B, E);"));
    fails(&beside(parallel, second, "home B;"), "not_home", "exactly `B` in `One` is never reached");
}

#[test]
fn home_within_what_is_commanded() {
    // What commands the partial grafcet, or what it waits for, decides about it.
    let slave = "initial step U; step V; U -[c]-> V -[!c]-> U;";
    let stops = "initial step A; final step B { force Two {V}; } A -[a]-> B;";
    fails(&beside(stops, slave, "home U;"), "not_home", "exactly `U` in `Two`");
    let frees = "initial step A; step B { force Two {V}; } A -[a]-> B -[!a]-> A;";
    holds(&beside(frees, slave, "home U;"));
    // Else the deadlock says it.
    let waits = "#[allow(grafcet::deadlock)] initial step U; step V; U -[A.X]-> V -[B.X]-> U;";
    let said = said(&beside("initial step A; final step B; A -[a]-> B;", waits, "home V;"));
    assert!(said.iter().any(|one| one.starts_with("not_home") && one.contains("exactly `V` in `Two`")), "{said:#?}");
    let chart = "grafcet C { input a, b, c: bool; initial step Off; enclosing step Auto { partial In { linked step I; \
        step J; I -[b]-> J -[c]-> I; } } Off -[a]-> Auto -[!a]-> Off; home Off; home I; home Auto; home (Auto, J); }";
    holds(chart);
    // A variable that the other one writes.
    let writes = "initial step A { P1 n = 1; } step B; A -[a]-> B -[!a]-> A;";
    let reads = "initial step U; step V; U -[n > 3]-> V -[d]-> U;";
    let said = self::said(&beside(writes, reads, "home U; home V;"));
    assert!(
        said.iter().any(|one| one.contains("it depends on `n`") && one.starts_with("property_undecided")),
        "{said:#?}"
    );
}

#[test]
fn home_beside_much() {
    // Thirty partial grafcets have more situations than anybody explores.
    let mut rest = String::new();
    for number in 0..30 {
        let _ = write!(
            rest,
            "partial Q{number} {{ initial step A{number}; step B{number}; A{number} -[rising(level > {number})]-> B{number} -[rising(b)]-> A{number}; }} "
        );
    }
    let (first, second) =
        ("initial step A; step B; A -[a]-> B -[!a]-> A;", "initial step U; step V; U -[c]-> V -[!c]-> U;");
    holds(&beside(first, second, &format!("{rest} home A; home (B, U); home A17;")));
    let table = fails(&beside(first, second, &format!("{rest} never B.X && a && b;")), "property_violated", "");
    assert_eq!(table.last().map(|line| line.ends_with("| B")), Some(true), "{table:#?}");
}

#[test]
fn what_is_not_touched_does_not_decide() {
    let flash = "initial step U; step V { q if text.is_odd(n); } U -[c]-> V { P1 n = n + 1; } V -[d]-> U;"
        .replace(" { P1 n = n + 1; } V", "");
    let first = "initial step A; step B { r; } A -[a]-> B -[!a]-> A;";
    let chart = beside(first, &flash, "home A; never q && s; never r && A.X;");
    let said = said(&chart);
    assert!(!said.iter().any(|one| one.contains("property_undecided") && !one.contains("text")), "{said:#?}");
    let one = "sfc C { input on, off: bool; output q, r: bool; initial step A; step B { N q if foo(B.T, off); N r; } \
        A -[on]-> B -[off]-> A; home A; never r && A.X; never q && r; }";
    let said = self::said(one);
    assert_eq!(said.len(), 1, "{said:#?}");
    assert!(said[0].contains("property_undecided") && said[0].contains("`foo(B.T, off)`"), "{said:#?}");
}

#[test]
fn too_many_inputs() {
    let names: Vec<String> = (0..24).map(|number| format!("i{number}")).collect();
    let any: Vec<String> = names.chunks(2).map(|pair| format!("({} ^ {})", pair[0], pair[1])).collect();
    let chart = |condition: &str, property: &str| {
        format!(
            "sfc C {{ input {}: bool; output q: bool; initial step A; step B {{ N q; }} step E; A -[{condition}]-> B; \
             A -[!i0 && i1]-> E; B -[i0]-> A; E -[i1]-> A; {property} }}",
            names.join(", ")
        )
    };
    let said = said(&chart(&any.join(" ^ "), "never q && E.X; never q && i2 && i3; home A;"));
    let undecided: Vec<&String> = said.iter().filter(|one| one.starts_with("property_undecided")).collect();
    assert!(undecided.iter().all(|one| one.contains("asks for 24 inputs, `i0`, `i1`")), "{said:#?}");
    assert!(!undecided.is_empty(), "{said:#?}");
}
