//! `write_race`: two stored actions race only if both can run in the same evolution.

mod judged;

/// What is said about a `grafcet` with these inputs, outputs and variables.
fn said(items: &str) -> Vec<String> {
    let chart = format!(
        "grafcet C {{ #![allow(grafcet::unused_input, grafcet::unused_variable)] \
         input a, b, c, d, p, r: bool; output q: bool; var n: u8 = 0; var f: bool; var g: bool; {items} }}"
    );
    judged::said(&chart)
}

/// Nothing races.
fn fine(items: &str) {
    let said = said(items);
    let about = |one: &String| one.starts_with("write_race") || one.starts_with("notation");
    assert!(!said.iter().any(about), "{items}: {said:#?}");
}

/// Among what is said is a race.
fn race(items: &str) {
    let said = said(items);
    assert!(said.iter().any(|one| one.starts_with("write_race")), "{items}: {said:#?}");
}

/// A partial grafcet inside of a step, which `around` leaves and enters.
fn enclosed(inside: &str, around: &str) -> String {
    format!(
        "initial step Off; enclosing step Auto {{ partial In {{ {inside} }} }} Off -[a]-> Auto -[!a]-> Off; {around}"
    )
}

#[test]
fn steps_of_an_enclosure() {
    // Of a sequence one step is active when the enclosing step is left.
    fine(&enclosed("linked step A { P0 n = 1; } step B { P0 n = 2; } A -[b]-> B -[c]-> A;", ""));
    fine(&enclosed("linked step A { P1 n = 1; } step B { P1 n = 2; P0 n = 3; } A -[b]-> B;", ""));
    // Parallel branches are left together.
    race(&enclosed("linked step I; step A { P0 n = 1; } step B { P0 n = 2; } I -[b]-> (A, B); (A, B) -[c]-> I;", ""));
    // Two enclosures of one step are left and entered together.
    race(
        "initial step Off; enclosing step Auto { partial I { linked step A { P0 n = 1; } step B; A -[b]-> B -[!b]-> A; } \
         partial J { linked step U { P0 n = 2; } step V; U -[c]-> V -[!c]-> U; } } Off -[a]-> Auto -[!a]-> Off;",
    );
    // What waits for a step of the other one is not left with it.
    fine(
        "initial step Off; enclosing step Auto { partial I { linked step A { P0 n = 1; } step B; A -[b]-> B; } \
         partial J { linked step U; step V { P0 n = 2; } U -[B.X]-> V; } } Off -[a]-> Auto -[!a]-> Off;",
    );
}

#[test]
fn an_enclosing_step_that_is_left_and_entered_at_once() {
    // `Auto` stays active where both clear, so that its enclosure goes on beside what leaves it.
    let around = |back: &str| {
        format!(
            "initial enclosing step Auto {{ partial In {{ initial linked step A; step B {{ P1 n = 1; }} A -[b]-> B -[!b]-> A; }} }} \
             initial step Other; step Out {{ P1 n = 2; }} Auto -[a]-> Out -[!a]-> Auto; {back}"
        )
    };
    race(&around("Other -[c]-> Auto;"));
    // Without the other way back it is left, and its enclosure with it.
    fine(&around("Other -[c]-> Other;"));
}

#[test]
fn self_loops_of_the_enclosing_step() {
    // It keeps the enclosure as it is (A4g).
    let inside = "linked step A { P1 n = 1; P0 n = 2; } step B { P1 n = 3; } A -[b]-> B -[c]-> A;";
    let inside_apart = inside.replace("P0 n = 2; ", "");
    race(&enclosed(inside, "Auto -[p && a]-> Auto;"));
    fine(&enclosed(&inside_apart, "Auto -[p && a]-> Auto;"));
    fine(&enclosed(
        &inside_apart.replace("[b]", "[b && !p]").replace("[c]", "[c && !p]"),
        "Auto -[a && p => n = 3]-> Auto;",
    ));
    // Also where the step is left at the same time, as it is entered again at once.
    fine(
        &enclosed("linked step A { P0 n = 1; } step B; A -[b]-> B;", "Auto -[p => n = 3]-> Auto;")
            .replace("[b]", "[b && !p]"),
    );
    // The loop keeps the enclosure as it is, so that its transitions clear beside it.
    race(&enclosed("linked step A; step B { P1 n = 2; } A -[b]-> B;", "Auto -[a && rising(p) => n = 3]-> Auto;"));
}

#[test]
fn forced() {
    let forced = |inside: &str| {
        format!(
            "partial Top {{ initial step Run; step Stop {{ force Low {{}}; }} Run -[a]-> Stop -[!a]-> Run; }} partial Low {{ {inside} }}"
        )
    };
    fine(&forced("initial step A { P0 n = 1; } step B { P0 n = 2; } A -[b]-> B -[c]-> A;"));
    race(&forced("initial step I; step A { P0 n = 1; } step B { P0 n = 2; } I -[b]-> (A, B); (A, B) -[c]-> I;"));
}

#[test]
fn requests_that_are_consumed() {
    // The transition clears in the evolution after the edge, in which there is none any more (A2).
    fine("initial step A { on rising(p) f = true; } step B { P1 f = false; } A -[f]-> B -[b]-> A;");
    fine("initial step A { on rising(p) f = true; } step B { P1 f = false; } A -[f && true]-> B -[rising(b)]-> A;");
    // The request waits for an input, so that another one comes when it is consumed.
    race("initial step A { on rising(p) f = true; } step B { P1 f = false; } A -[f && a]-> B -[b]-> A;");
    // Set before, and the edge in the cycle that consumes it.
    race("initial step A { on rising(p) f = true; } step B { P1 f = false; } A -[a]-> B -[!a]-> A;");
    // A flag that says which of two is to act.
    fine(
        "initial step A { P1 f = true; } step B; step C { P1 n = 1; } step D { P1 n = 2; } step E { P0 f = false; } step F; \
         step W; W -[f]-> C -[true]-> E; W -[!f]-> D -[true]-> F; A -[a]-> B -[b]-> W; E -[c]-> A; F -[c]-> A;",
    );
}

#[test]
fn flags_exclude() {
    // Which branch of the second grafcet may act is what the first has stored.
    let chart = |second: &str| {
        format!(
            "partial One {{ initial step A; step B {{ P1 f = true; }} step C {{ P1 n = 1; P0 f = false; }} \
             A -[a]-> B -[b]-> C -[c]-> A; }} \
             partial Two {{ initial step U; step V {{ P1 n = 2; }} U -[{second}]-> V -[!d]-> U; }}"
        )
    };
    fine(&chart("d && !f"));
    race(&chart("d"));
    race(&chart("d && f"));
}
