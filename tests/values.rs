//! Types of one's own as inputs, outputs, variables and params: what has the traits that a chart needs goes.
#![deny(warnings)]

use grafcet::{OutOfRange, grafcet};

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

#[allow(non_camel_case_types)]
type onoff = bool;

grafcet! {
    /// What is only shown needs no initial value, also where its type is an alias.
    sfc Alias {
        input go: bool;
        output lamp, late, horn: onoff;
        initial step Off;
        step On { lamp; D 5s late; L 2s horn; }
        Off -[go]-> On -[!go]-> Off;
    }
}

grafcet! {
    grafcet AliasedSearch {
        input go: bool;
        output lamp: onoff;
        initial step Off;
        step On { lamp if go; }
        Off -[go]-> On -[!go]-> Off;
    }
}

#[test]
fn an_alias_of_a_boolean_is_one() {
    let (mut chart, mut search) = (Alias::new(), AliasedSearch::new());
    let inputs = AliasInputs { go: true };
    chart.cycle(&inputs, 0_u32);
    let outputs = chart.cycle(&inputs, 1_u32);
    assert!(outputs.lamp && !outputs.late && outputs.horn);
    let outputs = chart.cycle(&inputs, 5_001_u32);
    assert!(outputs.lamp && outputs.late && !outputs.horn);
    assert!(search.cycle(&AliasedSearchInputs { go: true }).lamp);
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

const MOST: i16 = 6;

grafcet! {
    sfc Ranged {
        input go: bool;
        output speed: i16;
        param rpm: i16 in -5..10 = MOST;
        param soak: time in 1s..=10s = 2s;
        param free: bool = true;
        assume never go && rpm == 0;
        initial step A { speed = rpm; }
        step B { speed = 100; }
        A -[go && free]-> B -[soak/B]-> A;
        always A.X || !A.X && rpm < 10 && soak >= 1s;
    }
}

#[test]
fn a_recipe_outside_of_its_ranges_is_refused() {
    let recipe = RangedParams::new();
    let mut chart = Ranged::new();
    for rpm in [-5, 0, 9] {
        assert_eq!(chart.set_params(RangedParams { rpm, ..recipe }), Ok(()));
        assert_eq!(chart.cycle(&RangedInputs::default(), 0).speed, rpm);
        assert_eq!(chart.assumptions_hold(&RangedInputs { go: true }), rpm != 0);
    }
    for rpm in [i16::MIN, -6, 10, i16::MAX] {
        let refused = OutOfRange { param: "rpm", range: "-5..10" };
        assert_eq!(chart.set_params(RangedParams { rpm, ..recipe }), Err(refused));
        assert_eq!(Ranged::with_params(RangedParams { rpm, ..recipe }).map(|_| ()), Err(refused));
        assert_eq!(refused.to_string(), "`rpm` is not in `-5..10`");
        assert_eq!(chart.params().rpm, 9, "the old recipe stays");
    }
    for (millis, is_in) in [(0, false), (999, false), (1000, true), (10_000, true), (10_001, false), (u32::MAX, false)]
    {
        let soak = grafcet::Ticks::new(millis);
        assert_eq!(chart.set_params(RangedParams { soak, ..recipe }).is_ok(), is_in, "{millis}");
    }
    assert_eq!(chart.set_params(RangedParams { rpm: 7, ..recipe }), Ok(()));
    chart.init();
    assert_eq!(chart.params().rpm, 7, "init keeps the recipe");
    let slow: Result<Ranged, OutOfRange> =
        const { Ranged::with_params(RangedParams { rpm: 1, ..RangedParams::new() }) };
    assert_eq!(slow.map(|mut slow| slow.cycle(&RangedInputs::default(), 0).speed), Ok(1));
}
