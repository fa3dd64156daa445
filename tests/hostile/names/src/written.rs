//! Rust in conditions and blocks where its grammar has corners: structs after operators, functions as values, assignments
//! to several places; and steps named with their partial grafcet.

use grafcet::grafcet;

/// A condition of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// Above it is too much.
    pub max: u16,
}

impl core::ops::Not for Limit {
    type Output = bool;

    fn not(self) -> bool {
        self.max > 5
    }
}

impl Limit {
    /// Whether it is kept.
    #[must_use]
    pub fn keeps(self, level: u16) -> bool {
        level <= self.max
    }
}

/// A function as a value.
pub type Rule = fn(u16) -> bool;

fn high(level: u16) -> bool {
    level > 10
}

grafcet! {
    /// Structs after operators, functions that are called, places that are swapped.
    pub sfc Written {
        #![allow(grafcet::always_true)]
        input level: u16;
        input go: bool;
        output first: u16 = 1;
        output second: u16 = 2;
        output low, late: bool;
        var pair: [u16; 2] = [3, 4];
        var rest: u16 = 0;
        param rule: Rule = self::high;
        param same: fn(u16) -> u16 = core::convert::identity;

        initial step Idle { low if Limit { max: 3 }.keeps(level); }
        step Swap {
            P1 { (first, second) = (second, first); }
            P1 { [_, rest] = pair; (pair[0], ..) = (rest, 0, 0); }
            P1 { if go { (first, _) = (first + rest, 0); } }
        }
        step Wait { late if !Limit { max: 7 } && rest + pair[0] > 0; }

        Idle -[!Limit { max: 9 } && rule(level)]-> Swap;
        Swap -[!Limit { max: 9 }]-> Wait -[same(level) == 0]-> Idle;
    }
}

grafcet! {
    /// The time of a step in another partial grafcet.
    pub grafcet Apart {
        input go: bool;
        output early, late, gone: bool;
        partial One { initial step Rest; step Work; Rest -[go]-> Work -[!go]-> Rest; }
        partial Other {
            initial step Watch { early if 5s/One::Work; late if 5s/(One::Work)/2s; }
            step Told { gone; }
            Watch -[8s/One::Work]-> Told -[!One::Work.X]-> Watch;
        }
    }
}

#[test]
fn structs_functions_and_several_places() {
    let mut chart = Written::new();
    let cycle = |chart: &mut Written, level, go| chart.cycle(&WrittenInputs { level, go });
    assert!(cycle(&mut chart, 3, false).low);
    assert!(!cycle(&mut chart, 4, false).low);
    let q = cycle(&mut chart, 11, false);
    assert_eq!((q.first, q.second, chart.situation()), (2, 1, WrittenStep::Swap));
    assert!(cycle(&mut chart, 11, false).late);
    let _ = cycle(&mut chart, 0, false);
    // What a block reads of an output is what the cycle before returned, 2, also after a block that has written it.
    let q = cycle(&mut chart, 11, true);
    assert_eq!((q.first, q.second, chart.situation()), (6, 2, WrittenStep::Swap));
}

#[test]
fn times_of_steps_of_other_partial_grafcets() {
    let mut chart = Apart::new();
    let cycle = |chart: &mut Apart, go, time| chart.cycle(&ApartInputs { go }, time);
    let _ = cycle(&mut chart, false, 0);
    let _ = cycle(&mut chart, true, 1_000);
    assert!(!cycle(&mut chart, true, 5_999).early);
    let q = cycle(&mut chart, true, 6_000);
    assert!(q.early);
    assert!(!cycle(&mut chart, true, 8_999).gone);
    assert!(cycle(&mut chart, true, 9_000).gone);
}
