//! Why nothing moves.

use grafcet_sim::{Chart, Simulation, Value, Wait, Why};

/// What is said after these cycles, each with its time and inputs.
fn said(source: &str, cycles: &[(u32, &[(&str, Value)])]) -> String {
    let chart = Chart::parse(source).unwrap_or_else(|refused| panic!("{refused}"));
    let mut run = Simulation::new(&chart).expect("understood");
    for (now, inputs) in cycles {
        run.cycle(*now, inputs).expect("understood");
    }
    run.blocked().to_string()
}

/// A chart of one transition with this condition.
fn waits(condition: &str, cycles: &[(u32, &[(&str, Value)])]) -> String {
    let source = format!(
        "sfc C {{ input a, b, c: bool; input level: u8; initial step A; step B; A -[{condition}]-> B -[true]-> A; }}"
    );
    let text = said(&source, cycles);
    text.strip_prefix("`A → B` waits for ").map(str::to_owned).unwrap_or(text)
}

const START: (u32, &[(&str, Value)]) = (0, &[]);

#[test]
fn parts_that_are_false() {
    assert_eq!(waits("a", &[START]), "`a` (false)");
    assert_eq!(waits("a && b", &[START]), "`a` (false); `b` (false)");
    assert_eq!(waits("a && b", &[(0, &[("a", true.into())])]), "`b` (false)");
    assert_eq!(waits("(a || b && c) && level < 3", &[START]), "`a` (false) or (`b` (false); `c` (false))");
    assert_eq!(
        waits("!(a || b)", &[(0, &[("a", true.into()), ("b", true.into())])]),
        "`!a` (a = true); `!b` (b = true)"
    );
    assert_eq!(
        waits("!(a && b)", &[(0, &[("a", true.into()), ("b", true.into())])]),
        "`!a` (a = true) or `!b` (b = true)"
    );
    assert_eq!(waits("level > 10", &[(0, &[("level", 3_u8.into())])]), "`level > 10` (level = 3)");
    assert_eq!(waits("level != 0 && 10 / level > 7", &[START]), "`level != 0` (level = 0)", "no division by zero");
    assert_eq!(waits("false", &[START]), "`false` (never)");
    assert_eq!(waits("a", &[(0, &[("a", true.into())])]), "`A → B` clears in the next cycle");
}

#[test]
fn how_long_still() {
    let cycles: &[(u32, &[(&str, Value)])] = &[START, (1500, &[])];
    assert_eq!(waits("4s/A", cycles), "2.5 s of `4s/A` still to go");
    assert_eq!(waits("a && 4s/A", cycles), "`a` (false); 2.5 s of `4s/A` still to go");
    assert_eq!(waits("A.T > 4s", cycles), "2.501 s of `A.T > 4s` still to go");
    assert_eq!(waits("!(1s/A)", cycles), "`!1s/A` (the time is over)");
    assert_eq!(waits("4s/B", cycles), "`4s/B` (B is not active)");
    let held: &[(u32, &[(&str, Value)])] = &[(0, &[("a", true.into())]), (1000, &[])];
    assert_eq!(waits("3s/a", held), "2 s of `3s/a` still to go");
    assert_eq!(waits("3s/a", cycles), "`3s/a` (a is false)");
}

#[test]
fn edges() {
    let up: &[(u32, &[(&str, Value)])] = &[(0, &[("a", true.into())])];
    assert_eq!(waits("rising(a)", &[START]), "`rising(a)` (a is false)");
    assert_eq!(waits("rising(a)", up), "`rising(a)` (a is true)");
}

#[test]
fn what_is_frozen_says_by_whom() {
    let source = "grafcet C { input stop: bool;
        partial Safety { initial step Ready; step Stopped { force Work {*}; } Ready -[stop]-> Stopped -[!stop]-> Ready; }
        partial Work { initial step Run; step Rest; Run -[stop]-> Rest -[true]-> Run; } }";
    let text = said(source, &[START, (1, &[("stop", true.into())])]);
    assert_eq!(
        text,
        "`Stopped → Ready` waits for `!stop` (stop = true)\n`Run → Rest` is frozen: `Stopped` forces its partial grafcet"
    );
}

#[test]
fn before_and_beside() {
    assert_eq!(waits("a", &[]), "the next cycle is the first");
    let end = "sfc C { initial step A; final step B; A -[true]-> B; }";
    assert_eq!(said(end, &[START, START]), "no transition is enabled");
}

#[test]
fn parts_are_data() {
    let chart = Chart::parse("sfc C { input a, b: bool; initial step A; step B; A -[a && 2s/A]-> B -[b]-> A; }")
        .expect("a chart");
    let mut run = Simulation::new(&chart).expect("understood");
    let cycle = run.cycle(0, &[]).expect("understood");
    let Why::Waits(Wait::All(parts)) = &cycle.blocked.waiting[0].why else { panic!("{:?}", cycle.blocked) };
    let [Wait::Part(a), Wait::Part(time)] = &parts[..] else { panic!("{parts:?}") };
    assert_eq!((a.text.as_str(), &a.values[..], a.left), ("a", &[("a".to_owned(), Value::Bool(false))][..], None));
    assert_eq!((time.text.as_str(), time.left), ("2s/A", Some(2000)));
}

/// What an operating mode holds back says so, and none of its inputs is a part of the condition.
#[test]
fn what_a_mode_holds_back() {
    let in_mode = |inputs: &[(&str, Value)]| {
        let source = "sfc C { modes; input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; A -[!a]-> B; }";
        said(source, &[(0, inputs)])
    };
    let (on, both) = (|name| (name, Value::Bool(true)), |one: &str, other: &str| format!("{one}\n{other}"));
    let (first, second) = ("`A → B` waits for `a` (false)", "`A → B` clears in the next cycle");
    assert_eq!(in_mode(&[]), both(first, second));
    let (first, second) =
        ("`A → B` is held back: paused; it also waits for `a` (false)", "`A → B` is held back: paused");
    assert_eq!(in_mode(&[on("paused")]), both(first, second));
    // Paused goes before manual, manual before semi-automatic.
    assert_eq!(in_mode(&[on("paused"), on("manual"), on("semi_automatic")]), both(first, second));
    let (first, second) = (
        "`A → B` waits for `a` (false), and then for the push button (semi-automatic)",
        "`A → B` is held back: semi-automatic, until `push`",
    );
    assert_eq!(in_mode(&[on("semi_automatic")]), both(first, second));
    let (first, second) =
        ("`A → B` is held back: manual, until `push`", "`A → B` is held back: manual, and `A → B` goes first");
    assert_eq!(in_mode(&[on("manual")]), both(first, second));
    assert_eq!(in_mode(&[on("manual"), on("semi_automatic"), on("a")]), both(first, second));
    // An `any` works in every mode.
    let source = "sfc C { modes; input a, stop: bool; initial step A; step B; step Safe;
        A -[a]-> B -[!a]-> A; any -[stop]-> Safe -[a]-> A; }";
    let text = said(source, &[(0, &[on("paused")])]);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 2, "{text}");
    assert!(lines.contains(&"`A → B` is held back: paused; it also waits for `a` (false)"), "{text}");
    assert!(lines.iter().any(|line| line.ends_with("waits for `stop` (false)")), "{text}");
}
