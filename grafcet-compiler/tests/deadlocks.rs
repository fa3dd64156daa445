//! What takes what others need: a deadlock where all wait for each other, a convergence that waits forever where a branch left.

mod judged;

use judged::rules;

/// Two sequences that need two tools.
fn tools(second: &str) -> String {
    format!(
        "sfc Tools {{
            input go, a, b: bool;
            output drill, mill: bool;
            initial step Start;
            step Tool; step Jig;
            step A0; step A1; step A2 {{ drill; }}
            step B0; step B1; step B2 {{ mill; }}
            Start -[go]-> (Tool, Jig, A0, B0);
            (A0, Tool) -[a]-> A1;
            (A1, Jig) -[a]-> A2 -[!a]-> (A0, Tool, Jig);
            {second}
        }}"
    )
}

#[test]
fn two_sequences_that_take_two_tools_in_opposite_order() {
    let chart = tools("(B0, Jig) -[b]-> B1; (B1, Tool) -[b]-> B2 -[!b]-> (B0, Tool, Jig);");
    assert_eq!(rules(&chart), ["deadlock"]);
}

#[test]
fn a_tool_that_is_never_given_back() {
    let chart = tools("(B0, Tool) -[b]-> B1; (B1, Jig) -[b]-> B2 -[!b]-> (B0, Tool);");
    assert_eq!(rules(&chart), ["deadlock"]);
}

#[test]
fn tools_that_are_taken_in_the_same_order() {
    let chart = tools("(B0, Tool) -[b]-> B1; (B1, Jig) -[b]-> B2 -[!b]-> (B0, Tool, Jig);");
    assert_eq!(rules(&chart), [""; 0]);
}

#[test]
fn a_branch_that_leaves_is_no_deadlock() {
    let chart = "sfc Left {
        input go, a, b, bad: bool;
        output q: bool;
        initial step Start;
        step A1 { q; } step A2; step B1; step B2; step End;
        Start -[go]-> (A1, B1);
        A1 -[a && !bad]-> A2;
        A1 -[bad]-> End;
        B1 -[b]-> B2;
        (A2, B2) -[true]-> End -[!go]-> Start;
    }";
    let said = rules(chart);
    assert!(!said.is_empty() && !said.contains(&"deadlock".to_owned()), "{said:?}");
}

/// The convergence is never enabled, and what comes there waits.
#[test]
fn a_convergence_of_alternatives_is_never_enabled() {
    let chart = "sfc Alternatives {
        input go, a: bool;
        output q: bool;
        initial step Start;
        step A { q; } step B;
        Start -[go && a]-> A;
        Start -[go && !a]-> B;
        (A, B) -[!go]-> Start;
    }";
    assert_eq!(rules(chart), ["stuck_join"]);
}
