//! What is found out about conditions: by hand for each kind of atom, and at random beside all valuations.

mod valuations;

use grafcet_compiler::analysis::{Answer, Concurrency, Condition, Logic};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;

/// Declarations and steps that the conditions below may use.
const CHART: &str = "
    input a, b, c: bool;
    input level, other: u16;
    input small: i8;
    input temp, tepid, warm: f32;
    input lo, hi: u8;
    input reading, other_reading: Reading;
    input pair: (u8, u8);
    input letter: char;
    input word: &'static str;
    input far: &'static u16;
    input pressure: f64;
    input mode: Mode;
    var count: u16 = 0;
    param low, high: u16 = 3;
    param soak: time = 5s;
    initial step Idle;
    step Fill;
    step Drain;
    macro step Clamp {
        entry step Close;
        exit step Open;
        Close -[a]-> Open;
    }
    Idle -[a]-> Fill -[b]-> Drain -[c]-> Clamp -[true]-> Idle;
    initial step Left;
    step Right;
    Left -[a]-> Right -[b]-> Left;
";

/// A chart whose last transitions have these conditions.
fn chart(conditions: &[&str]) -> Model {
    let branches: Vec<String> = conditions.iter().map(|text| format!("Idle -[{text}]-> Fill;")).collect();
    let branches = branches.join("\n");
    let text = format!("grafcet C {{ {CHART} {branches} }}");
    let mut sink = Sink::new();
    let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    let messages: Vec<String> = sink.finish().into_iter().flat_map(|d| d.notes).map(|(_, text)| text).collect();
    assert_eq!(messages, [""; 0], "{conditions:?}");
    model
}

/// Asks about conditions, where `never` is assumed never to hold.
fn ask<T>(conditions: &[&str], never: &[&str], question: impl Fn(&Logic<'_>, &[Condition]) -> T) -> T {
    let all: Vec<&str> = conditions.iter().chain(never).copied().collect();
    let model = chart(&all);
    let concurrency = Concurrency::of(&model);
    let mut trees: Vec<_> = model.transitions.values().rev().take(all.len()).map(|t| &t.condition.tree).collect();
    trees.reverse();
    let (trees, never) = trees.split_at(conditions.len());
    let logic = Logic::within(&model, &concurrency, never);
    let read: Vec<_> = trees.iter().map(|tree| logic.condition(tree)).collect();
    question(&logic, &read)
}

fn never(condition: &str) -> bool {
    ask(&[condition], &[], |logic, all| logic.never(&all[0]))
}

fn always(condition: &str) -> bool {
    ask(&[condition], &[], |logic, all| logic.always(&all[0]))
}

fn exclusive(a: &str, b: &str) -> bool {
    ask(&[a, b], &[], |logic, all| logic.exclusive(&all[0], &all[1]))
}

fn witness(conditions: &[&str]) -> Answer {
    ask(conditions, &[], |logic, all| logic.together(&all.iter().map(|c| (c, true)).collect::<Vec<_>>(), &[]))
}

fn certain(conditions: &[&str]) -> bool {
    let answer = |logic: &Logic<'_>, all: &[Condition]| {
        logic.certainly_together(&all.iter().map(|c| (c, true)).collect::<Vec<_>>(), &[])
    };
    matches!(ask(conditions, &[], answer), Answer::Witness(_))
}

#[test]
fn booleans() {
    for condition in ["a && !a", "false", "(a || b) && !a && !b", "a ^ a", "a == !a", "(a & b) != (b & a)"] {
        assert!(never(condition), "{condition}");
        assert!(always(&format!("!({condition})")), "{condition}");
    }
    for condition in ["a", "a && b", "a ^ b", "a == b", "a || !b"] {
        assert!(!never(condition) && !always(condition), "{condition}");
    }
    // Chains of `^` are no matter of trying everything.
    let chain = "a ^ b ^ c ^ a ^ b ^ c ^ a ^ b ^ c ^ a ^ b ^ c";
    assert!(never(chain));
}

#[test]
fn numbers() {
    for condition in [
        "level < 0",
        "level > 65535",
        "level >= 70000u32",
        "small < -128",
        "level < 3 && level > 5",
        "level > 2 && level < 3",
        "level == 3 && level == 4",
        "3 > level && 5 < level",
        "level + 1 < 3 && level + 1 > 3",
        "level == 2 + 3 && level != 5",
        "7 < 3",
        "-small > 5 && -small < 5",
        "5s < 3s",
    ] {
        assert!(never(condition), "{condition}");
    }
    for condition in ["level >= 0", "level < 10 || level >= 10", "level != 3 || level == 3", "small > -129", "1 < 2"] {
        assert!(always(condition), "{condition}");
    }
    for condition in ["level > 5 && other < 3", "level >= 3 && level <= 3", "small < 0", "level < low", "low > 0"] {
        assert!(!never(condition) && !always(condition), "{condition}");
    }
    // Params are not constants, but two comparisons of the same two values are related.
    assert!(exclusive("level < low", "level >= low") && exclusive("low > level", "!(level < low)"));
    assert!(!exclusive("level < low", "level > high") && !exclusive("level < 3", "level > low"));
    assert!(always("level <= low || level > low"));
}

#[test]
fn floats() {
    assert!(exclusive("temp < 10.0", "temp >= 10.0") && exclusive("temp < -0.5", "temp > 1e-3"));
    assert!(exclusive("pressure <= 1.5", "1.5 < pressure") && never("temp > 3.0 && temp < 2.5"));
    // There may be no number at all.
    assert!(!always("temp < 10.0 || temp >= 10.0") && always("temp < 10.0 || !(temp < 10.0)"));
    assert!(!never("temp != 10.0 && !(temp < 10.0) && !(temp > 10.0)"));
    assert!(!never("temp >= 0.0 && temp <= -0.0"));
}

#[test]
fn steps_and_times() {
    // `Idle`, `Fill`, `Drain` and the expansion of `Clamp` exclude each other, and so do `Left` and `Right`.
    assert!(never("Idle.X && Fill.X") && !never("Idle.X && Right.X") && !never("Idle.X || Right.X"));
    assert!(exclusive("Clamp.X", "Fill.X") && exclusive("Close.X", "Open.X"));
    assert!(never("Open.X && !Clamp.X") && never("Clamp.X && !Open.X && !Close.X") && !never("Clamp.X && !Open.X"));
    assert!(always("Idle.X || Fill.X || Drain.X || Clamp.X || Left.X || Right.X"));
    assert!(!always("Idle.X || Fill.X || Drain.X"));
    assert!(exclusive("5s/Fill", "Fill.T < 5s") && exclusive("5s/Fill", "!Fill.X") && exclusive("5s/Fill", "Drain.X"));
    assert!(!exclusive("5s/Fill", "Fill.T > 3s") && never("Fill.T > 0s && Drain.T > 0s"));
    assert!(exclusive("soak/Fill", "Fill.T < soak") && exclusive("soak/Fill", "soak > Fill.T"));
    assert!(always("Fill.T >= 0s") && never("Clamp.T > 1s && !Clamp.X"));
}

#[test]
fn edges_and_delays() {
    assert!(never("rising(a) && !a") && never("falling(a) && a") && exclusive("rising(a)", "falling(a)"));
    assert!(never("falling(a && !a)") && never("rising(level > 5 || level <= 5)") && !never("falling(a && b)"));
    assert!(exclusive("rising(level > 5)", "level < 3") && exclusive("rising(a)", "rising(!a)"));
    assert!(
        !exclusive("rising(a)", "rising(b)") && !exclusive("rising(a)", "a") && !exclusive("rising(a)", "falling(b)")
    );
    assert!(never("3s/a && !a") && !never("3s/a/1s && !a") && never("5s/a && !(3s/a)") && !never("3s/a && !(5s/a)"));
    assert!(never("5s/(a && b) && !b"));
}

#[test]
fn other_rust_is_equal_to_its_own_text() {
    assert!(
        never("level.abs() > 3 && level.abs() < 2")
            && !never("f(level) && !f(level)")
            && !exclusive("f(level)", "!g(level)")
            && !exclusive("f(level)", "f(other)")
    );
    assert!(!exclusive("mode == Mode::AUTO", "mode == Mode::HAND"));
    // What looks like a variant may be anything, where the chart does not list them.
    assert!(!exclusive("mode == Mode::Auto", "mode == Mode::Hand"));
    assert!(exclusive("mode == Mode::Auto", "!(mode == Mode::Auto)"));
    assert!(exclusive("level < MAX", "level >= MAX"));
    // What nobody knows is no reason to say that two conditions hold together.
    assert!(!certain(&["mode == Mode::Auto", "mode == Mode::Hand"]) && !certain(&["f(level)", "a"]));
    assert!(certain(&["a || f(level)", "a || g(level)"]) && !certain(&["a != f(level)", "a"]));
    assert!(!certain(&["level < low", "level > high"]) && certain(&["level < low", "a"]));
    assert!(!certain(&["level + 1 < 3", "level > 7"]) && certain(&["level < 3", "other > 7"]));
}

#[test]
fn two_values_lie_between_their_constants_and_limits() {
    for condition in [
        "level < 1 && level > other",
        "level < low && low < other && other < level",
        "level < other && other == 0",
        "level == other && level > 3 && other < 3",
        "level > other && other > low && level == low",
        "level < low && low < high && high <= 1",
        "other > level && level == 65535",
        "level <= other && level >= other && level != other",
        "Fill.T > soak && soak > 5s && Fill.T <= 5s",
        "Fill.T > soak && !Fill.X",
        "Fill.T == soak && soak > 0s && !Fill.X",
        "level < level",
        "level % 4 > 3",
        "(level & 7) == 9 || level / 1000 > 65 || small % 3 < -2",
        "temp > tepid && tepid > 3.0 && temp < 2.0",
        "rising(level < other) && other <= level",
    ] {
        assert!(never(condition), "{condition}");
        assert!(always(&format!("!({condition})")), "{condition}");
    }
    for condition in [
        "level < 2 && level > other",
        "level < low && low < high && high <= 2",
        "level < other && level != 0 && other != 2",
        "Fill.T > soak && soak > 5s",
        "temp > tepid && tepid > 1.0 && temp < 2.0",
        // There may be no number at all.
        "!(temp < tepid) && !(temp >= tepid)",
        "!(temp < tepid) && !(temp >= tepid) && tepid < 3.0",
    ] {
        assert!(!never(condition) && !always(condition), "{condition}");
        assert!(certain(&[condition]) || condition.contains("low") || condition.contains("soak"), "{condition}");
    }
    assert!(never("!(temp < tepid) && !(temp >= tepid) && tepid < 3.0 && temp > 1.0"));
    assert!(never("!(temp < tepid) && !(temp >= tepid) && tepid < 3.0 && temp < warm"));
    let text = |conditions: &[&str]| match witness(conditions) {
        Answer::Witness(text) => text,
        other => panic!("{conditions:?}: {other:?}"),
    };
    assert_eq!(text(&["level < 9 && level > other", "other > 2"]), "level = 4, level > other, other = 3");
    assert!(ask(&["hi == 0"], &["lo >= hi"], |logic, all| logic.never(&all[0])));
}

#[test]
fn types_of_the_user_compare_as_they_like() {
    for (a, b) in [
        ("reading < 3", "reading >= 3"),
        ("reading < other_reading", "reading >= other_reading"),
        ("reading < 3", "3 < reading"),
        ("reading == 3", "reading != 3"),
        ("mode == Mode::AUTO", "mode != Mode::AUTO"),
        ("pair.level < 3", "pair.level >= 3"),
        ("reading + 1 < 3", "reading + 1 > 3"),
    ] {
        assert!(!exclusive(a, b), "{a}, {b}");
        assert!(!always(&format!("{a} || {b}")), "{a}, {b}");
        assert!(!never(&format!("!({a}) && !({b})")), "{a}, {b}");
        assert!(exclusive(a, &format!("!({a})")), "{a}");
    }
    // References to primitive types, characters and text have the order of their types.
    assert!(exclusive("letter < 'c'", "letter >= 'c'") && exclusive("word == \"on\"", "word != \"on\""));
    assert!(exclusive("far < &LIMIT", "far >= &LIMIT"));
}

#[test]
fn disjunctions_and_assumptions() {
    let implies = |conditions: &[&str], never: &[&str]| {
        ask(conditions, never, |logic, all| logic.implies(&all[0], &all[1..].iter().collect::<Vec<_>>()))
    };
    assert!(implies(&["level > 3", "level < 7", "level >= 5"], &[]));
    assert!(!implies(&["level > 3", "level < 7", "level > 7"], &[]));
    assert!(implies(&["a && b", "c", "a"], &[]) && !implies(&["a", "a && b", "c"], &[]));
    assert!(implies(&["a", "a && b", "a && !b"], &[]) && !implies(&["a"], &[]) && implies(&["a && !a"], &[]));
    assert!(implies(&["a", "b"], &["a && !b"]) && !implies(&["a", "b"], &["a && c"]));
    // An assumption brings in another one.
    assert!(implies(&["a"], &["a && b", "a && !b"]) && implies(&["a", "b"], &["a && !c", "c && !b"]));
}

#[test]
fn witnesses_read_like_the_chart() {
    let text = |conditions: &[&str]| match witness(conditions) {
        Answer::Witness(text) => text,
        other => panic!("{conditions:?}: {other:?}"),
    };
    assert_eq!(text(&["a", "level > 6"]), "a = true, level = 7");
    assert_eq!(text(&["!b && a", "level < 10 && level != 0"]), "b = false, a = true, level = 1");
    assert_eq!(text(&["5s/Fill", "a"]), "Fill.T = 5s, a = true");
    assert_eq!(text(&["rising(a)", "small < -2"]), "rising(a) = true, small = -3");
    assert_eq!(text(&["level < low", "soak/Fill"]), "level < low, Fill.T == soak");
    assert_eq!(text(&["f(level)", "3s/a/1s"]), "f(level) = true, 3s/a/1s = true");
    assert_eq!(text(&["temp > 1.5", "temp < 2.5 && temp >= 2.0"]), "temp = 2");
    assert_eq!(text(&["true", "1 < 2"]), "");
}

/// The budget grows with the chart: all of its conditions are decided.
#[test]
fn long_charts() {
    let mut texts: Vec<String> = (0..3000).map(|i| format!("level > {} && a || other < {i} && !b", i % 50)).collect();
    texts.push("a && !(a || b)".to_owned());
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    ask(&texts, &[], |logic, all| {
        let (last, others) = all.split_last().expect("conditions");
        assert!(others.iter().all(|condition| !logic.never(condition) && !logic.always(condition)));
        assert!(logic.never(last));
    });
    let texts: Vec<String> = (0..150).map(|i| format!("level >= {} && level < {}", 3 * i, 3 * i + 3)).collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    ask(&texts, &[], |logic, all| {
        let pair = |i: usize| all[..i].iter().all(|other| logic.exclusive(other, &all[i]));
        assert!((0..all.len()).all(pair));
        let covered: Vec<&Condition> = all[1..].iter().collect();
        assert!(!logic.implies(&all[0], &covered) && logic.implies(&all[7], &all.iter().collect::<Vec<_>>()));
    });
}
