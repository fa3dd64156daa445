//! Alarms that need values: with a prover the macro says them where they happen, and not where they do not.

use grafcet_compiler::analysis::Prover;
use grafcet_compiler::{Wanted, compile_with};
use quote::quote;

/// What the macro makes of a chart without a prover, and with one.
fn both(text: &str) -> [String; 2] {
    let root = quote!(::grafcet);
    let prover: &Prover = &grafcet_prove::rule;
    [None, Some(prover)].map(|prover| {
        compile_with(&root, text.parse().expect("tokens"), Wanted { prover, ..Wanted::default() }).to_string()
    })
}

/// Two numbers that change together; a lamp is set where the first is so, and reset where the second is.
fn lamps(first: &str, second: &str) -> String {
    format!(
        "grafcet Lamps {{
            input a, b: bool;
            output lamp: bool;
            var n: u8 = 0;
            var m: u8 = 0;
            partial Count {{
                initial step Zero;
                step First {{ P1 n = 1; P1 m = 2; }}
                step Second {{ P1 n = 2; P1 m = 1; }}
                Zero -[rising(a)]-> First -[rising(a)]-> Second -[rising(a)]-> Zero;
            }}
            partial One {{ initial step A; step B {{ S lamp; }} A -[{first}]-> B -[!b]-> A; }}
            partial Two {{ initial step X; step Y {{ R lamp; }} X -[{second}]-> Y -[!b]-> X; }}
        }}"
    )
}

#[test]
fn a_race_that_values_exclude() {
    let [without, with] = both(&lamps("n == 1 && b", "m == 1 && b"));
    assert!(without.contains("[grafcet::write_race]"), "{without}");
    assert!(!with.contains("grafcet::"), "{with}");
}

#[test]
fn a_race_that_values_lead_to() {
    // Both of the first, and before the first part there is nothing: both numbers are zero.
    for (first, second) in [("n == 1 && b", "m == 2 && b"), ("n < 2 && b", "m < 1 && b")] {
        let said = both(&lamps(first, second));
        assert!(said.iter().all(|said| said.contains("[grafcet::write_race]")), "{first}, {second}");
    }
}

/// Both begin in steps that write: that is no evolution, and no prover is asked.
#[test]
fn a_race_at_the_beginning() {
    let chart = lamps("n == 1 && b", "m == 1 && b");
    let chart = chart
        .replace("initial step A;", "initial step A { S lamp; }")
        .replace("initial step X;", "initial step X { R lamp; }");
    let said = both(&chart);
    assert!(said.iter().all(|said| said.contains("[grafcet::write_race]")));
}

/// A circle that turns without end once it is entered, where a count comes to `limit`, as it never does beyond two.
fn circle(limit: u8) -> String {
    format!(
        "grafcet Circle {{
            input a: bool;
            output left, right: bool;
            var n: u8 = 0;
            partial Count {{ initial step Zero; step First {{ P1 n = (n + 1) % 3; }} Zero -[rising(a)]-> First -[!a]-> Zero; }}
            partial Turn {{
                initial step A {{ left; }}
                step B {{ right; }}
                step G;
                A -[n == {limit}]-> B -[true]-> G -[true]-> B;
            }}
        }}"
    )
}

#[test]
fn a_circle_that_values_stop() {
    let [without, with] = both(&circle(3));
    assert!(without.contains("[grafcet::unstable]"), "{without}");
    assert!(!with.contains("[grafcet::unstable]"), "{with}");
    let said = both(&circle(2));
    assert!(said.iter().all(|said| said.contains("[grafcet::unstable]")), "it turns");
}
