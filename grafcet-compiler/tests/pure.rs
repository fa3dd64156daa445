//! What Rust can do to a proof: calls with state, comparisons of types of the user.

mod judged;

/// The names of the rules that a chart breaks.
fn said(chart: &str) -> Vec<&'static str> {
    let mut rules = judged::names(chart);
    rules.dedup();
    rules
}

/// Two outputs after two conditions.
fn two(head: &str, first: &str, second: &str) -> String {
    format!(
        "sfc C {{ {head} input level, other: i16; input flags: [u8; 4]; input mode: Mode; output q, r: bool; \
         initial step A {{ N q if {first}; N r if {second}; }} step B; \
         A -[level > 3]-> B -[other < 3 && flags[0] == 1 && matches!(mode, Mode::Auto)]-> A; never q && r; }}"
    )
}

#[test]
fn two_calls_may_give_two_values() {
    for call in [
        "toggle()",
        "gate(level)",
        "mode.is_auto()",
        "crate::io::PIN.is_high()",
        "unsafe { TOGGLE }",
        "{ let x = next(); x > 3 }",
        "look!(level)",
        "flags.iter().any(|flag| odd(*flag))",
        "level.abs() > limit()",
        "Mode::of(level)",
    ] {
        let chart = two("", call, &format!("!({call})"));
        assert_eq!(said(&chart), ["property_undecided"], "{chart}");
    }
}

#[test]
fn what_has_one_value() {
    for call in [
        "level.abs() > 3",
        "level.wrapping_add(other).count_ones() > 3",
        "matches!(mode, Mode::Auto | Mode::Manual)",
        "flags[1] > 3",
        "flags.iter().any(|flag| *flag > 3)",
        "flags.len() > 3 && (level as u8) < 4",
        "{ let x = level; x > 3 }",
        "const { limit() > 3 }",
        "Some(level) == None",
        "i32::from(level) > 3",
        "core::cmp::max(level, other) > 3",
        "(A.T.get() > 3) == (level > 3)",
    ] {
        let chart = two("", call, &format!("!({call})"));
        assert_eq!(said(&chart), [""; 0], "{chart}");
    }
    // The result of a known method is a number.
    assert_eq!(said(&two("", "level.abs() > 3", "level.abs() <= 3")), [""; 0]);
    assert_eq!(said(&two("", "flags[1] > 3", "flags[1] <= 3")), [""; 0]);
    assert_eq!(said(&two("", "(level as f32) > 3.0", "(level as f32) <= 3.0")), ["property_undecided"]);
}

#[test]
fn what_the_chart_says_is_pure() {
    let charts = [
        ("assume pure toggle;", "toggle()"),
        ("assume pure io::gate, other_one; ", "io::gate(level) && other_one(other)"),
        ("assume pure is_auto;", "mode.is_auto()"),
        ("assume pure look!;", "look!(level)"),
    ];
    for (head, call) in charts {
        let chart = two(head, call, &format!("!({call})"));
        assert_eq!(said(&chart), [""; 0], "{chart}");
    }
    assert_eq!(said(&two("assume pure toggel;", "toggle()", "!toggle()")), ["unknown_name"]);
    assert_eq!(said(&two("assume pure gate;", "io::gate(1)", "!io::gate(1)")), ["unknown_name"]);
}

#[test]
fn types_of_the_user_have_no_order() {
    let chart = |properties: &str| {
        format!(
            "sfc C {{ input reading: Reading; output low, high: bool; initial step A {{ N low if reading < 3; \
             N high if reading >= 3; }} step B; A -[reading == 4]-> B -[reading != 4]-> A; {properties} }}"
        )
    };
    assert_eq!(said(&chart("never low && high;")), ["property_undecided"]);
    assert_eq!(said(&chart("always A.X => low || high;")), ["property_undecided"]);
    assert_eq!(said(&chart("never A.X && B.X;")), [""; 0]);
    let numbers = chart("never low && high; always A.X => low || high;").replace("Reading", "u8");
    assert_eq!(said(&numbers), [""; 0]);
}

/// In each evolution of a search a call is evaluated anew.
#[test]
fn a_search_that_calls() {
    let chart =
        |head: &str| format!("grafcet C {{ {head} initial step A; step B; A -[toggle()]-> B -[toggle()]-> A; }}");
    assert_eq!(said(&chart("")), [""; 0]);
    assert_eq!(said(&chart("assume pure toggle;")), ["unstable"]);
}
