//! `any -[stop]-> Stopped;`: what the checker makes of a transition from every step.

mod judged;

use std::fmt::Write;

use judged::rules;

fn sequence(dialect: &str, rest: &str) -> Vec<String> {
    rules(&format!(
        "{dialect} Machine {{
            input start, done, stop, ack: bool;
            output motor, lamp: bool;
            initial step Idle;
            step Run {{ motor; }}
            step Back {{ motor; }}
            step Stopped {{ lamp; }}
            Idle -[start && !stop]-> Run -[done]-> Back -[!done]-> Idle;
            {rest}
        }}"
    ))
}

fn branches(dialect: &str, rest: &str) -> Vec<String> {
    rules(&format!(
        "{dialect} Machine {{
            input start, a, b, stop, ack: bool;
            output left, right, lamp: bool;
            initial step Idle;
            step A1 {{ left; }} step A2;
            step B1 {{ right; }} step B2;
            step Stopped {{ lamp; }}
            Idle -[start && !stop]-> (A1, B1);
            A1 -[a]-> A2; B1 -[b]-> B2;
            (A2, B2) -[!start]-> Idle;
            {rest}
        }}"
    ))
}

const DIALECTS: [&str; 2] = ["sfc", "grafcet"];

#[test]
fn a_good_chart_gets_no_word() {
    for dialect in DIALECTS {
        let end = "any -[stop]-> Stopped -[!stop && ack]-> Idle; home Idle;";
        assert_eq!(sequence(dialect, end), Vec::<String>::new(), "{dialect}");
        let proof = "never lamp && (left || right); never Stopped.X && A1.X; never Stopped.X && B2.X;";
        assert_eq!(branches(dialect, &format!("{end} {proof}")), Vec::<String>::new(), "{dialect}");
        let two = "any except Stopped -[stop]-> Stopped -[!stop && ack]-> Idle;";
        assert_eq!(branches(dialect, two), Vec::<String>::new(), "{dialect}");
    }
}

#[test]
fn what_any_proves_and_does_not() {
    for dialect in DIALECTS {
        let end = "any -[stop]-> Stopped -[!stop && ack]-> Idle;";
        // In the cycle that sees `stop` nothing else clears.
        assert_eq!(branches(dialect, &format!("{end} never stop && A2.X;")), Vec::<String>::new(), "{dialect}");
        assert_eq!(branches(dialect, &format!("{end} never lamp;")), ["property_violated"], "{dialect}");
        // Left out, it runs on.
        let end = "any except Run -[stop]-> Stopped -[!stop && ack]-> Idle;";
        assert_eq!(sequence(dialect, &format!("{end} never stop && Run.X;")), ["property_violated"], "{dialect}");
        let end = "any -[stop]-> Stopped -[!stop && ack]-> Idle;";
        assert_eq!(sequence(dialect, &format!("{end} never stop && Run.X;")), Vec::<String>::new(), "{dialect}");
    }
}

#[test]
fn the_way_back_is_missing() {
    for dialect in DIALECTS {
        assert_eq!(sequence(dialect, "any -[stop || ack]-> Stopped; home Idle;"), ["deadlock"], "{dialect}");
        assert_eq!(branches(dialect, "any -[stop || ack]-> Stopped;"), ["deadlock"], "{dialect}");
    }
}

#[test]
fn it_turns_for_ever_where_it_holds_on() {
    assert_eq!(sequence("grafcet", "any -[stop || ack]-> Stopped -[stop || ack]-> Idle;"), ["unstable"]);
    assert_eq!(branches("grafcet", "any -[stop || ack]-> Stopped -[stop || ack]-> Idle;"), ["unstable"]);
    assert_eq!(sequence("sfc", "any -[stop || ack]-> Stopped -[stop || ack]-> Idle;"), Vec::<String>::new());
}

#[test]
fn it_comes_before_all_others() {
    for dialect in DIALECTS {
        let end = "any -[stop]-> Stopped -[!stop && ack]-> Idle;";
        let dead = format!("Run -[stop && ack]-> Idle; {end}");
        assert_eq!(sequence(dialect, &dead), ["shadowed_branch"], "{dialect}");
        let second = format!("{end} any except Stopped -[stop && done]-> Idle;");
        assert_eq!(sequence(dialect, &second), ["shadowed_branch"], "{dialect}");
        let left_out = "Run -[stop && ack && !done]-> Idle; any except Run -[stop]-> Stopped -[!stop && ack]-> Idle;";
        assert_eq!(sequence(dialect, left_out), Vec::<String>::new(), "{dialect}");
        let never = "any -[stop && !stop]-> Stopped; Stopped -[ack]-> Idle;";
        let said = sequence(dialect, never);
        assert!(said.contains(&"never_true".to_owned()), "{dialect}: {said:?}");
        let dead = "any -[Stopped.X]-> Stopped; Run -[stop && !done]-> Stopped -[!stop && ack]-> Idle;";
        assert_eq!(sequence(dialect, dead), ["dead_transition"], "{dialect}");
    }
}

#[test]
fn several_targets_in_branches() {
    for dialect in DIALECTS {
        let reset = "any except (Idle, Stopped) -[stop]-> (A1, B1); Idle -[ack && !start]-> Stopped -[!ack]-> Idle;";
        assert_eq!(branches(dialect, reset), Vec::<String>::new(), "{dialect}");
    }
}

#[test]
fn beside_else() {
    for dialect in DIALECTS {
        let end = "any -[stop]-> Stopped -[!stop && ack]-> Idle; Stopped -[else]-> Stopped;";
        let said = sequence(dialect, end);
        assert!(!said.contains(&"error".to_owned()), "{said:?}");
    }
}

#[test]
fn mistakes() {
    for chart in [
        "any -[stop]-> (Idle, Run, Back, Stopped);",
        "any except (Idle, Run, Back) -[stop]-> Stopped;",
        "any except () -[stop]-> Stopped;",
        "any -[else]-> Stopped;",
        "any -[blink(1s)]-> Stopped;",
        "any, Idle -[stop]-> Stopped;",
    ] {
        for dialect in DIALECTS {
            assert_eq!(sequence(dialect, chart), ["error"], "{dialect}: {chart}");
        }
    }
    assert_eq!(sequence("sfc", "any except Rum -[stop || ack]-> Stopped;"), ["unknown_step"]);
    assert_eq!(sequence("sfc", "Stopped -[stop]-> any;"), ["unknown_step"]);
    assert!(sequence("sfc", "any -[stop]-> ();").contains(&"sink_transition".to_owned()));
    assert_eq!(sequence("sfc", "any -> Stopped;"), ["steps_without_transition"]);
    assert!(sequence("sfc", "any -[stop]->;").contains(&"sink_transition".to_owned()));
}

/// A long chart is checked and expanded quickly.
#[test]
fn a_thousand_steps() {
    for dialect in DIALECTS {
        let mut chart =
            format!("{dialect} Long {{ input x, y, stop: bool; output q: bool; initial step S0; step End {{ q; }}");
        for step in 1..1000 {
            _ = write!(chart, "step S{step};");
        }
        chart += "any -[stop]-> End -[!stop && x]-> S0; S0";
        for step in 1..1000 {
            _ = write!(chart, " -[{}]-> S{step}", if step % 2 == 0 { "x && !y" } else { "y && !x" });
        }
        chart += " -[x && !y]-> S0; }";
        let begin = std::time::Instant::now();
        assert_eq!(rules(&chart), Vec::<String>::new(), "{dialect}");
        println!("{dialect}: {:?}", begin.elapsed());
    }
}

/// Each `any` leaves all steps but its own targets: one that comes later clears from those of an earlier one.
#[test]
fn one_that_comes_later_clears_from_the_targets_of_an_earlier_one() {
    let chart = |dialect: &str, rest: &str| {
        rules(&format!(
            "{dialect} Several {{ input a, b: bool; output q: bool; initial step A; step B {{ q; }} step E; {rest} }}"
        ))
    };
    let none = Vec::<String>::new();
    let back = "A -[rising(b)]-> A; E -[rising(b)]-> A;";
    assert_eq!(chart("grafcet", &format!("any -[rising(a)]-> E; any -[rising(a)]-> B; {back}")), none);
    let back = "A -[b]-> B; B -[b]-> A; E -[!a]-> A;";
    assert_eq!(chart("sfc", &format!("any -[a]-> E; any -[a && b]-> B; {back}")), none);
    assert_eq!(chart("sfc", &format!("any except B -[a]-> E; any -[a && b]-> B; {back}")), none);
    // Not where the earlier one leaves all that it does.
    assert_eq!(chart("sfc", &format!("any -[a]-> E; any except E -[a && b]-> B; {back}")), ["shadowed_branch"]);
    let back = "A -[rising(b)]-> B; B -[rising(b)]-> A; E -[rising(b)]-> A;";
    let shadowed = "any -[rising(a)]-> E; any except E -[rising(a) && b]-> B;";
    assert_eq!(chart("grafcet", &format!("{shadowed} {back}")), ["shadowed_branch"]);
}

/// A step that nothing but a stop leaves is touched by it, if it begins as active.
#[test]
fn it_leaves_a_step_that_nothing_else_touches() {
    for dialect in DIALECTS {
        let chart = |initial: &str, other: &str| {
            rules(&format!(
                "{dialect} Boots {{ input go, stop, back: bool; output q: bool; {initial} step Boot {{ q; }} {other} step Stopped; \
                 step Run {{ q; }} any -[stop]-> Stopped; Stopped -[go && !stop]-> Run -[back && !stop]-> Stopped; }}"
            ))
        };
        assert_eq!(chart("initial", ""), Vec::<String>::new(), "{dialect}");
        assert_eq!(chart("", "initial"), ["isolated_step"], "{dialect}");
    }
}
