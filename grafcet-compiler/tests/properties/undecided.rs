//! What is not followed and what is too much proves nothing, neither way; and only what a property asks for decides about it.

use std::fmt::Write as _;
use std::fs;
use std::sync::LazyLock;
use std::time::Instant;

use crate::judged::said;
use crate::{beside, fails, holds};

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

/// Nobody knows whether Rust that is not looked into can hold at all.
#[test]
fn rust_that_is_not_looked_into_leads_nowhere() {
    let back = |condition: &str| {
        let pure = if condition.contains("near") { "assume pure near;" } else { "" };
        format!(
            "sfc C {{ #![allow(grafcet::unused_input)] {pure} input go: bool; input x: u8; input s: Sensor; input o: Option<u8>; \
             initial step A; step B; A -[go]-> B; B -[{condition}]-> A; home A; }}"
        )
    };
    for condition in [
        "near(x)",
        "!near(x)",
        "near(s.level) && go",
        "far(x)",
        "rising(near(x))",
        "s.level(3) > 3",
        "o.unwrap_or(3) > 4",
    ] {
        fails(&back(condition), "property_undecided", "depends on");
    }
    // A part of an input can be anything, and where each value leads on nobody has to know which.
    for condition in
        ["s.level > 3", "matches!(s, Sensor::Dry)", "o.is_some()", "s == Sensor::DRY", "x > LIMIT", "near(x) || go"]
    {
        holds(&back(condition));
    }
    holds(&back("near(x)").replace("home A;", "B -[!near(x)]-> A; home A;"));
    // A counterexample may rely on it, but not on arithmetic that is not computed.
    let there = |condition: &str| {
        let chart = back("go").replace("A -[go]-> B;", &format!("A -[{condition}]-> B;"));
        chart.replace("home A;", "never B.X;")
    };
    fails(&there("far(x)"), "property_violated", "cycle 2");
    fails(&there("x.ilog2() > 20"), "property_undecided", "depends on");
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
    let said = crate::judged::said(one);
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

/// What was known of a variable before an action wrote it, which is not looked into, is not known after it: in the search that leaves A where `n` is 0, C is entered
/// as well as E.
#[test]
fn what_an_action_has_changed_is_not_known_any_more() {
    holds(
        "grafcet C { input a: bool; var n: u8; initial step A; step B { P1 n = next(n); } step C; step E; \
         A -[n == 0 && a]-> B; B -[n != 0]-> C; B -[n == 0]-> E; C -[!a]-> A; E -[!a]-> A; }",
    );
}

/// Seconds that a check of six branches takes, with so many properties of which two at most are decided.
fn seconds(properties: usize) -> f64 {
    let (branches, steps) = (6, 6);
    let mut chart =
        "sfc Many { input start, a0, a1, a2, a3, a4, a5, a6, a7, a8, a9: bool; output q: bool; initial step I; "
            .to_owned();
    let heads: Vec<String> = (0..branches).map(|branch| format!("B{branch}_0")).collect();
    let ends: Vec<String> = (0..branches).map(|branch| format!("B{branch}_{}", steps - 1)).collect();
    for branch in 0..branches {
        for step in 0..steps {
            _ = write!(chart, "step B{branch}_{step} {{ {} q; }} ", ["S", "R", "N"][step % 3]);
            if step + 1 < steps {
                let (on, off) = ((branch * 2 + step) % 10, (branch + 3 * step + 1) % 10);
                _ = write!(chart, "B{branch}_{step} -[a{on} && !a{off}]-> B{branch}_{}; ", step + 1);
            }
        }
    }
    _ = write!(chart, "I -[start]-> ({}); ({}) -[!start]-> I; ", heads.join(", "), ends.join(", "));
    for property in 0..properties {
        let (one, other, third) = (property % 6, (property + 1) % 6, (property + 2) % 6);
        let (first, last) = (property / 6, (property / 6 + 3) % 6);
        _ = write!(chart, "never q && B{one}_{first}.X && B{other}_{last}.X && B{third}_{last}.X && start; ");
    }
    let before = processor_seconds();
    let said = said(&format!("{chart} }}"));
    let seconds = processor_seconds() - before;
    let open = said.iter().filter(|one| one.starts_with("property_undecided: ")).count();
    assert!(open + 2 >= properties, "{said:#?}");
    seconds
}

/// What this thread has had of a processor; where the system does not tell, the clock on the wall.
fn processor_seconds() -> f64 {
    static BEGIN: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| BEGIN.elapsed().as_secs_f64(), |nanoseconds| nanoseconds / 1e9)
}

/// From some questions on that stay open, each halves what the next one may take.
#[test]
fn many_open_properties_take_little_more_than_some() {
    let (some, many) = (seconds(6), seconds(30));
    assert!(many < 2.0 * some, "{many:.2} s for 30, {some:.2} s for 6");
}

/// A chain of variables that are each made of the one before, twice: written out they would be as long as the second power of their number.
#[test]
fn variables_made_of_each_other() {
    let chart = |count: usize| {
        let names: Vec<String> = (0..count).map(|at| format!("x{at}")).collect();
        let one = |at: usize| format!("x{at} if x{} && c || !x{} && b; ", at - 1, at - 1);
        let made: String = (1..count).map(one).collect();
        let ways = format!("A -[rising(a) && x{}]-> B -[rising(a)]-> A; never B.X && !b && !c;", count - 1);
        format!(
            "grafcet C {{ input a, b, c: bool; output q: bool; var {}: bool; initial step A {{ q; x0 if b; {made} }} step B; {ways} }}",
            names.join(", ")
        )
    };
    fails(&chart(5), "property_violated", "cycle");
    let message = said(&chart(40));
    assert!(message[0].starts_with("property_undecided"), "{message:?}");
}
