//! Types of one's own as inputs, outputs, variables and params: what has the traits that a chart needs goes.
#![deny(warnings)]

use grafcet::grafcet;

/// Nothing but what a chart needs.
#[derive(Clone, Copy, Default)]
struct Plain(u16);

/// Without a default.
#[derive(Clone, Copy, PartialEq)]
struct Stated(u16);

grafcet! {
    sfc Values {
        input a: Plain;
        input long: [bool; 40];
        input pairs: [(Plain, u8); 33];
        output b: Plain;
        output c: Stated = Stated(7);
        var d: Plain = Plain(1);
        param e: Stated = Stated(2);
        initial step A { b = d; P1 d = Plain(d.0 + e.0); }
        step B { c = Stated(9); }
        A -[a.0 > 2 && long[39] && pairs[32].0.0 == 0]-> B -[a.0 < 2]-> A;
    }
}

#[test]
fn charts_of_such_types_are_values() {
    let mut inputs = ValuesInputs::default();
    assert!(!inputs.long[39] && inputs.pairs[32].1 == 0);
    let mut chart = Values::with_params(ValuesParams { e: Stated(5) });
    let before = chart;
    assert_eq!(chart.cycle(&inputs).b.0, 6);
    inputs.a = Plain(3);
    inputs.long[39] = true;
    let copy = inputs;
    assert_eq!(chart.cycle(&copy).c.0, 9);
    assert!(chart.is_active(ValuesStep::B) && !before.is_active(ValuesStep::B));
    assert_eq!(ValuesOutputs::default().c.0, 7);
}

/// Types of one's own that are called as those of IEC 61131-3.
#[expect(clippy::upper_case_acronyms, reason = "they are called so there")]
mod plc {
    pub(crate) type INT = i8;
}

grafcet! {
    grafcet Named {
        input level: plc::INT;
        output q: bool;
        initial step A;
        step B { q; }
        A -[level > 5]-> B -[level < 5]-> A;
    }
}

#[test]
fn a_path_is_a_type_of_ones_own() {
    assert!(Named::new().cycle(&NamedInputs { level: 6 }).q);
}
