//! What `assume never …;` does to every rule: alarms that the plant excludes go, faults that it makes certain come.

mod judged;

use judged::diagnostics;

/// The rules that a chart breaks, each once, by name; of a mistake of notation the message.
fn said(chart: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for diagnostic in diagnostics(chart) {
        let text = diagnostic.rule.map_or_else(|| diagnostic.notes[0].1.clone(), |rule| rule.name.to_owned());
        if !all.contains(&text) {
            all.push(text);
        }
    }
    all.sort();
    all
}

/// A chart says `without` as it stands, and `with` under an assumption.
fn changes(dialect: &str, body: &str, assumption: &str, without: &[&str], with: &[&str]) {
    let chart = |assumption: &str| format!("{dialect} C {{ {body} {assumption} }}");
    assert_eq!(said(&chart("")), without, "without: {body}");
    assert_eq!(said(&chart(&format!("assume never {assumption};"))), with, "never {assumption}: {body}");
}

#[test]
fn conditions() {
    let inputs = "input a, b: bool; initial step Start; step Two; Two -[!a && !b]-> Start;";
    changes("sfc", &format!("{inputs} Start -[a && b]-> Two;"), "a && b", &[], &["never_true"]);
    changes("sfc", &format!("{inputs} Start -[a || b]-> Two;"), "!a && !b", &[], &["always_true", "never_true"]);
    // Both may come in one cycle, but not from both to none.
    changes("sfc", &format!("{inputs} Start -[rising(a) && rising(b)]-> Two;"), "a && b", &[], &["never_true"]);
    changes("sfc", &format!("{inputs} Start -[falling(a) && falling(b)]-> Two;"), "a && b", &[], &["never_true"]);
    changes("sfc", &format!("{inputs} Start -[falling(a) && rising(b)]-> Two;"), "a && b", &[], &[]);
    let numbers = "input level: u16; input full: bool; initial step Start; step Two; Two -[!full]-> Start;";
    changes("sfc", &format!("{numbers} Start -[full && level < 5]-> Two;"), "full && level < 10", &[], &["never_true"]);
    let source =
        "input a, b: bool; initial step Start; step Two; Start -[a]-> Two -[b]-> Start; () -[b && rising(a)]-> Start;";
    let allow = "#![allow(grafcet::unsafe_step, grafcet::overlapping_branches)]";
    changes("grafcet", &format!("{allow} {source}"), "a && b", &[], &["never_true"]);
}

#[test]
fn branches() {
    let branches = "input a, b: bool; initial step Start; step Two; step Three; Start -[a]-> Two; Start -[b]-> Three; Two -[!a]-> Start; Three -[!b]-> Start;";
    changes("grafcet", branches, "a && b", &["overlapping_branches", "unsafe_step"], &[]);
    changes("sfc", branches, "b && !a", &[], &["shadowed_branch"]);
    let edges = "input a, b: bool; initial step Start; step Two; step Three; \
        Start -[falling(a)]-> Two; Start -[falling(b)]-> Three; Two -[rising(a)]-> Start; Three -[rising(b)]-> Start;";
    changes("grafcet", edges, "a && b", &["overlapping_branches", "unsafe_step"], &[]);
}

#[test]
fn circles() {
    let circle = "#![warn(grafcet::possible_instability)] input a, b: bool; initial step Start; step Two; Start -[a]-> Two -[b]-> Start;";
    changes("grafcet", circle, "a && b", &["possible_instability"], &[]);
    // Where `a` and `b` are always on together, the circle turns whenever it is entered.
    changes("grafcet", circle, "a != b", &["possible_instability"], &["unstable"]);
    // Each of two partial grafcets goes round only while the other one does.
    let pair = |back: &str| {
        format!(
            "#![warn(grafcet::possible_instability)] input part, front, back, open, shut: bool; \
             partial Ram {{ initial step Open; step Closing; step Shut; step Opening; \
             Open -[Feeder::Placed.X]-> Closing -[shut]-> Shut -[Feeder::Rest.X]-> Opening -[open]-> Open; }} \
             partial Feeder {{ initial step Rest; step Forward; step Placed; step Backward; \
             Rest -[part && Ram::Open.X]-> Forward -[front]-> Placed -[Ram::Shut.X]-> Backward -[{back}]-> Rest; }}"
        )
    };
    changes("grafcet", &pair("back"), "front && back", &["possible_instability"], &[]);
    changes("grafcet", &pair("back && !front"), "open && shut", &[], &[]);
}

#[test]
fn evolution() {
    let lost = "input a, b: bool; initial step Start; step Two; step Three; Start -[a]-> Two -[!a]-> Start; Two -[b]-> Three -[a && b]-> Start;";
    changes("sfc", lost, "a && b", &[], &["never_true", "shadowed_branch"]);
    let lost = "input a, b: bool; initial step Start; step Two; Start -[a]-> Two -[a || b]-> Start; step Three; Two -[!a]-> Three -[b]-> Start;";
    changes("sfc", lost, "b && !a", &[], &[]);
    // Without `a` there is no `b`.
    let gone = "input a, b: bool; var v: bool; initial step Start { P1 v = false; } step Two { P1 v = a; } step Three; \
        Start -[b]-> Two -[v]-> Start; Two -[!v]-> Three -[true]-> Start;";
    changes("sfc", gone, "b && !a", &[], &["dead_transition"]);
    let stuck = "input a, b: bool; initial step Start; step Left; step Right; step Extra; Start -[a]-> (Left, Right); (Left, Right) -[!a]-> Start; Left -[a && b]-> Extra -[!b]-> Start;";
    changes("sfc", stuck, "a && b", &["unsafe_step"], &["never_true"]);
}

#[test]
fn actions() {
    let both = "input a, b: bool; output speed: u8; initial step Start; step Two { speed = 1; } step Three { speed = 2; } \
        Start -[rising(a)]-> Two; Start -[rising(b)]-> Three; Two -[!a]-> Start; Three -[!b]-> Start;";
    let faults = ["conflicting_values", "overlapping_branches", "unsafe_step"];
    changes("grafcet", both, "a && b", &faults, &[]);
    let race = "input a, b: bool; output q: bool; initial step Start; step Two { S q; } step Three { R q; } \
        Start -[rising(a)]-> Two; Start -[rising(b)]-> Three; Two -[!a]-> Start; Three -[!b]-> Start;";
    changes("grafcet", race, "a && b", &["overlapping_branches", "unsafe_step", "write_race"], &[]);
}

#[test]
fn nothing_left() {
    let chart = |assumptions: &str| {
        format!(
            "sfc C {{ {assumptions} input a, b: bool; initial step Start; step Two; Start -[a]-> Two -[b]-> Start; }}"
        )
    };
    let all = diagnostics(&chart("assume never a; assume never !b; assume never !a && b;"));
    assert_eq!(all.len(), 3);
    assert!(all.iter().all(|one| one.rule.is_none() && one.notes[0].1.contains("these 3 assumptions")), "{all:?}");
    let all = diagnostics(&chart("assume never a && b; assume never a || !a;"));
    assert!(matches!(&all[..], [one] if one.notes[0].1.contains("nothing is left")), "{all:?}");
    assert_eq!(said(&chart("assume never a && b;")), Vec::<String>::new());
}

#[test]
fn what_they_are_about() {
    let chart = |assumption: &str| {
        format!(
            "grafcet C {{ input a, b: bool; input level: u8; input age: time; output q: bool; var v: bool; param p: bool; \
             initial step Start {{ q; }} step Two {{ S v; }} step Three {{ R v; }} \
             Start -[rising(a) && p && level > 5]-> Two -[b && age > 5s]-> Three -[!v]-> Start; {assumption} }}"
        )
    };
    for right in [
        "assume never a && b;",
        "assume never level > 90 && !a;",
        "assume never near(level) || age > 9s;",
        "assume never p && b;",
    ] {
        assert_eq!(said(&chart(right)), Vec::<String>::new(), "{right}");
    }
    let wrong = [
        ("Start.X && a", "this is a step"),
        ("rising(a)", "an edge takes two"),
        ("q && a", "`q` is an output"),
        ("v && a", "`v` is a variable"),
        ("5s/Start", "this is a time"),
        ("Start.T > 5s", "this is a time"),
        ("5s/a", "this is a time"),
        ("near(level, q)", "`q` is an output"),
        ("none && a", "unknown_name"),
        ("Nowhere.X", "unknown_step"),
    ];
    for (condition, message) in wrong {
        let said = said(&chart(&format!("assume never {condition};")));
        assert!(matches!(&said[..], [one] if one.contains(message)), "{condition}: {said:?}");
    }
    let inside =
        "grafcet C { input a: bool; partial P { initial step A; step B; A -[a]-> B -[!a]-> A; assume never a; } }";
    assert!(said(inside)[0].contains("stands directly in it"), "{:?}", said(inside));
}

/// Names that only an assumption reads are used.
#[test]
fn usage() {
    let chart = "sfc C { input a, b: bool; initial step A; step B; A -[a]-> B -[!a]-> A; assume never a && b; }";
    assert_eq!(said(chart), Vec::<String>::new());
}

/// What is explored is bounded by what the chart says.
#[test]
fn budget() {
    let chart =
        |budget: &str| format!("sfc C {{ input a: bool; {budget} initial step A; step B; A -[a]-> B -[!a]-> A; }}");
    assert_eq!(said(&chart("budget 1_000_000;")), Vec::<String>::new());
    assert!(said(&chart("budget 0;"))[0].contains("budget of 0"));
    assert!(said(&chart("budget 99999999999999999999;"))[0].contains("cannot be counted"));
    assert_eq!(said(&chart("budget 5; budget 6;")).len(), 2);
}
