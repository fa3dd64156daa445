//! `home`: from everywhere there is a way back.

use std::fmt::Write as _;

use crate::judged::{diagnostics, names, said};
use crate::{beside, fails, holds};

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
    let said = crate::judged::said(&beside(writes, reads, "home U; home V;"));
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

/// The runs of one cycle part in the middle: what one of them takes for granted of a call another one does not.
#[test]
fn what_a_run_takes_for_granted_is_its_own() {
    let chart = |home: &str| {
        format!(
            "grafcet Chart {{ input go, up, back: bool; input level: u16;
             initial step Idle; step Wait; step Fill; step Full;
             Idle -[go]-> Wait; Wait -[!up]-> Fill; Fill -[rising(back)]-> Idle;
             Fill -[!rising(back) && near(level)]-> Full; Full -[rising(back)]-> Idle; home {home}; }}"
        )
    };
    assert_eq!(names(&chart("Wait")), [] as [&str; 0]);
    assert_eq!(names(&chart("Full")), ["property_undecided"]);
}
