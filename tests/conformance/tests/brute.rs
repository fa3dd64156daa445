//! The checker against brute force, on a few hundred small random charts; `cargo xtask brute` takes thousands.

use grafcet_conformance::brute::run::{Kind, Outcome, number};

/// Each chart of a kind, and all differences at once. So many of them have to be compared exactly, so that the test is one.
fn agree(kind: Kind, exactly: usize) {
    let (mut differences, mut exact) = (String::new(), 0);
    for index in 0..120 {
        let (text, outcome) = number(index, kind).expect("a chart that the interpreter understands");
        let Outcome::Compared(comparison) = outcome else { continue };
        exact += usize::from(comparison.exact);
        for difference in comparison.differences {
            differences.push_str(&format!("chart {index}: {}: {}\n{text}\n", difference.kind, difference.text));
        }
    }
    assert!(differences.is_empty(), "{differences}\n`cargo xtask brute` makes them smaller");
    assert!(exact >= exactly, "only {exact} charts were compared exactly");
}

const FAST: usize = 1500;

#[test]
fn sfc() {
    agree(Kind { grafcet: false, timed: false, cycles: FAST }, 80);
}

#[test]
fn grafcet() {
    agree(Kind { grafcet: true, timed: false, cycles: FAST }, 60);
}

#[test]
fn sfc_with_times() {
    agree(Kind { grafcet: false, timed: true, cycles: FAST }, 0);
}

#[test]
fn grafcet_with_times() {
    agree(Kind { grafcet: true, timed: true, cycles: FAST }, 0);
}
