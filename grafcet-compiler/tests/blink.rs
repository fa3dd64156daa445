//! What the checker makes of `blink`: true or false as long as its step is active, and related to nothing but itself.

mod judged;

use judged::rules;

fn lamps(first: &str, second: &str, rest: &str) -> Vec<String> {
    rules(&format!(
        "grafcet Lamps {{
            input a: bool;
            output first, second: bool;
            initial step A {{ first if {first}; second if {second}; }}
            step B;
            A -[a]-> B -[!a]-> A;
            {rest}
        }}"
    ))
}

#[test]
fn a_blink_excludes_its_own_contrary() {
    let proved = lamps("blink(500ms)", "!blink(500ms)", "never first && second;");
    assert!(proved.is_empty(), "{proved:?}");
    let proved = lamps("blink(500ms)", "blink(500ms)", "always first => A.X; never B.X && first;");
    assert!(proved.is_empty(), "{proved:?}");
    assert_eq!(lamps("blink(500ms)", "blink(500ms)", "never first;"), ["property_violated"]);
}

#[test]
fn other_periods_are_unrelated() {
    assert_eq!(lamps("blink(500ms)", "!blink(700ms)", "never first && second;"), ["property_violated"]);
    assert_eq!(lamps("blink(500ms)", "blink(500ms, B)", "never A.X && second;"), Vec::<String>::new());
}

#[test]
fn what_waits_for_a_blink_goes_on() {
    let chart = |condition: &str| {
        rules(&format!(
            "sfc Wait {{
                output q: bool;
                initial step A {{ q; }}
                step B;
                A -[{condition}]-> B -[1s/B]-> A;
                home A;
            }}"
        ))
    };
    for condition in ["blink(1s)", "!blink(1s)", "falling(blink(1s))", "blink(1s) && !blink(300ms/700ms)"] {
        assert!(chart(condition).is_empty(), "{condition}: {:?}", chart(condition));
    }
    assert!(chart("blink(1s) && !blink(1s)").contains(&"never_true".to_owned()));
    assert_eq!(chart("blink(1s, B)"), ["dead_transition"]);
}

/// A step that has just been entered is in the first part of its period.
#[test]
fn a_search_ends_where_a_step_is_entered_anew() {
    let chart = |first: &str, second: &str| {
        rules(&format!(
            "grafcet Turns {{
                input x: bool;
                output q: bool;
                initial step A {{ q; }}
                step B;
                A -[{first}]-> B -[{second}]-> A;
            }}"
        ))
    };
    assert!(chart("!blink(1s)", "x").is_empty(), "{:?}", chart("!blink(1s)", "x"));
    assert!(chart("x && !blink(1s)", "blink(1s)").is_empty());
    assert_eq!(chart("x && blink(1s)", "blink(1s)"), ["unstable"]);
}

#[test]
fn branches_by_the_two_parts_exclude_each_other() {
    let chart = |second: &str| {
        rules(&format!(
            "grafcet Branches {{
                input x: bool;
                output q: bool;
                initial step A {{ q; }}
                step B;
                step C;
                A -[x && blink(1s)]-> B -[!x]-> A;
                A -[x && {second}]-> C -[!x]-> A;
            }}"
        ))
    };
    assert!(chart("!blink(1s)").is_empty());
    assert_eq!(chart("blink(3s)"), Vec::<String>::new());
}
