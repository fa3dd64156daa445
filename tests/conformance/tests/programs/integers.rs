//! What a comparison of integers tells of the next one: what need not be asked again, and what has to be.

use std::fmt::Write as _;

use grafcet_compiler::program::passes::Pass;
use grafcet_conformance::program::{Outcome, compare, program as optimised};
use grafcet_conformance::reader;

use super::passes::{drawn, storm};
use super::read;

const OPERATORS: [&str; 6] = ["<", "<=", ">", ">=", "==", "!="];

/// A step is left by `first`, or else by `second`, or else by both turned round; a counter goes round from 0 to 5 beside them.
fn chart(dialect: &str, first: &str, second: &str) -> String {
    format!(
        "{dialect} Numbers {{ input a, b, c: bool; output p, q, r: bool; output n, m: i8 = 0; initial step A; step B {{ p; }} step C {{ q; }} \
         step E {{ r; }} step F {{ p; q; }} A -[a && {first}]-> B; A -[a && !({first}) && {second}]-> C; \
         A -[a && !({second}) && !({first})]-> E; A -[!a && b]-> F; \
         B -[!a => n = (n + 1) % 6]-> A; C -[!a => n = (n + 1) % 6, m = (m + 2) % 5]-> A; E -[!a => n = (n + 1) % 6]-> A; \
         F -[c => n = (n + 1) % 6, m = (m + 1) % 5]-> A; }}"
    )
}

fn plays(first: &str, second: &str) {
    for dialect in ["sfc", "grafcet"] {
        // An `sfc` has no actions on clearing.
        let text = chart(dialect, first, second);
        let text = if dialect == "sfc" { acting(&text) } else { text };
        let model = read(&text);
        for lines in [storm(&["a", "b", "c"], 120), drawn(&[("a", false), ("b", false), ("c", false)], 200)] {
            let lines = reader::read(&lines).expect("a timeline").lines;
            assert!(matches!(compare(&model, &lines, &Pass::ALL), Ok(Outcome::Same)), "{text}");
        }
    }
}

/// The same with the counting in the steps.
fn acting(chart: &str) -> String {
    let mut text = chart.to_owned();
    for clearing in
        [" => n = (n + 1) % 6, m = (m + 2) % 5", " => n = (n + 1) % 6, m = (m + 1) % 5", " => n = (n + 1) % 6"]
    {
        text = text.replace(clearing, "");
    }
    text.replace("initial step A;", "initial step A { P1 n = (n + 1) % 6; P0 m = (m + 2) % 5; }")
}

/// Each operator after each, with the same literal and with its neighbours on both sides.
#[test]
fn comparisons_with_literals() {
    for first in OPERATORS {
        for second in OPERATORS {
            for literal in [2, 3, 4] {
                plays(&format!("n {first} 3"), &format!("n {second} {literal}"));
            }
        }
    }
    plays("3 > n", "n >= 3");
    plays("3 > n", "n > 3");
    plays("n > -1", "n <= -1");
}

#[test]
fn comparisons_with_each_other() {
    for first in OPERATORS {
        for second in OPERATORS {
            plays(&format!("n {first} m"), &format!("n {second} m"));
        }
        for second in OPERATORS {
            plays(&format!("n {first} m"), &format!("m {second} n"));
        }
    }
}

/// Whether a program asks for the opposite of what it has asked.
fn asks_again(text: &str) -> bool {
    let mut cycle = String::new();
    _ = write!(cycle, "{}", optimised(&read(text), &Pass::ALL).expect("a program"));
    cycle.contains("n >= ")
}

/// Two that say the opposite are asked as one; of a float they need not be opposites.
#[test]
fn opposites_are_asked_once() {
    let chart = |ty: &str, four: &str| {
        format!(
            "grafcet Opposites {{ input go: bool; input n, m: {ty}; output p, q: bool; initial step A; step B {{ p; }} step C {{ q; }} \
             A -[go && n < {four}]-> B; A -[go && n >= {four}]-> C; B -[!go && m > n]-> A; B -[!go && n >= m]-> C; C -[!go]-> A; }}"
        )
    };
    assert!(!asks_again(&chart("u8", "4")));
    assert!(asks_again(&chart("f32", "4.0")));
}
