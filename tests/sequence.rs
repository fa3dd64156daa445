//! Sequences that are long enough for tables: which condition a step ends on, and what is after it.

use grafcet::grafcet;

/// The same ring of 24 steps in a dialect.
macro_rules! ring {
    ($dialect:ident $name:ident) => {
        grafcet! {
            $dialect $name {
                input a, b, c: bool;
                output odd, last: bool;
                initial step S0;
                step S1 { odd; }
                step S3 { odd; }
                step S23 { odd; last; }
                S0 -[a]-> S1 -[!a]-> S2 -[b]-> S3 -[!b]-> S4 -[a]-> S5 -[!a]-> S6 -[b]-> S7 -[!b]-> S8;
                S8 -[a]-> S9 -[!a]-> S10 -[b]-> S11 -[!b]-> S12 -[a]-> S13 -[!a]-> S14 -[b]-> S15 -[!b]-> S16;
                S16 -[a]-> S17 -[!a]-> S18 -[b]-> S19 -[!b]-> S20 -[a]-> S21 -[!a]-> S22 -[!c]-> S23 -[c]-> S0;
                step S2; step S4; step S5; step S6; step S7; step S8; step S9; step S10; step S11; step S12; step S13;
                step S14; step S15; step S16; step S17; step S18; step S19; step S20; step S21; step S22;
            }
        }
    };
}

ring! { sfc Scanned }
ring! { grafcet Searched }

/// The inputs that take a step to the next one, and none further.
fn inputs(step: usize) -> (bool, bool, bool) {
    match step {
        22 => (false, false, false),
        23 => (false, false, true),
        _ => [(true, false, true), (false, false, true), (false, true, true), (false, false, true)][step % 4],
    }
}

#[test]
fn every_step_of_an_sfc_waits_for_its_own_input() {
    let mut chart = Scanned::new();
    let steps = <Scanned as grafcet::Chart>::STEPS;
    let named = |i: usize| *steps.iter().find(|step| format!("{step:?}") == format!("S{i}")).unwrap();
    chart.cycle(&ScannedInputs { a: true, b: true, c: true });
    assert!(chart.is_active(named(0)), "the first cycle evaluates no transition");
    for step in (0..24).chain(0..24) {
        let (a, b, c) = inputs(step);
        // The opposite of what the step waits for leaves it active.
        let outputs = chart.cycle(&ScannedInputs { a: !a, b: !b, c: !c });
        assert!(chart.is_active(named(step)), "S{step}");
        assert_eq!((outputs.odd, outputs.last), (matches!(step, 1 | 3 | 23), step == 23));
        chart.cycle(&ScannedInputs { a, b, c });
        assert!(chart.is_active(named((step + 1) % 24)), "after S{step}");
    }
}

#[test]
fn a_search_goes_on_as_far_as_the_inputs_allow() {
    let mut chart = Searched::new();
    chart.cycle(&SearchedInputs { a: true, b: false, c: true });
    assert!(chart.is_active(SearchedStep::S1) && chart.is_stable());
    chart.cycle(&SearchedInputs { a: false, b: true, c: true });
    assert!(chart.is_active(SearchedStep::S3), "through S2");
    chart.cycle(&SearchedInputs { a: true, b: false, c: true });
    assert!(chart.is_active(SearchedStep::S5), "through S4");
    let outputs = chart.cycle(&SearchedInputs { a: false, b: false, c: false });
    assert!(chart.is_active(SearchedStep::S6) && chart.is_stable() && !outputs.odd);
}

/// A sequence of which some steps do not end like others: on a condition of their own, at once, on one of two ways, never.
macro_rules! winding {
    ($($dialect:ident $name:ident { $($setting:tt)* })*) => {
        $(grafcet! {
            $dialect $name {
                $($setting)*
                input a, b, c: bool;
                output odd, last: bool;
                initial step S0;
                step S1 { odd; }
                step S3 { odd; }
                final step S25 { last; odd; }
                S0 -[a]-> S1 -[!a]-> S2 -[b]-> S3 -[!b]-> S4 -[a]-> S5 -[!a]-> S6 -[b]-> S7 -[!b]-> S8;
                S8 -[a && b && c]-> S9 -[true]-> S10 -[b]-> S11 -[!b]-> S12 -[a]-> S13 -[!a]-> S14 -[b]-> S15 -[!b]-> S16;
                S16 -[a && !b]-> S17 -[!a]-> S18 -[b]-> S19 -[!b]-> S20 -[a]-> S21 -[!a]-> S22 -[b]-> S23 -[!b]-> S24;
                S16 -[b]-> S20;
                S12 -[b && !a]-> S12;
                S24 -[c]-> S25;
                S24 -[a && !c]-> S0;
                step S2; step S4; step S5; step S6; step S7; step S8; step S9; step S10; step S11; step S12; step S13;
                step S14; step S15; step S16; step S17; step S18; step S19; step S20; step S21; step S22; step S23; step S24;
            }
        })*
    };
}

winding! {
    sfc Wound {}
    sfc SmallWound { optimize size; }
    grafcet Unwound {}
    grafcet SmallUnwound { optimize size; }
}

/// The steps that inputs lead to one after the other, from S0.
const WAY: [((bool, bool, bool), usize); 30] = [
    ((true, false, false), 1),
    ((false, false, false), 2),
    ((false, true, false), 3),
    ((false, false, false), 4),
    ((true, false, false), 5),
    ((false, false, false), 6),
    ((false, true, false), 7),
    ((false, false, false), 8),
    ((true, true, false), 8),
    ((true, true, true), 9),
    ((false, false, false), 10),
    ((false, true, false), 11),
    ((false, false, false), 12),
    ((true, false, false), 13),
    ((false, false, false), 14),
    ((false, true, false), 15),
    ((false, false, false), 16),
    ((false, true, false), 20),
    ((true, false, false), 21),
    ((false, false, false), 22),
    ((false, true, false), 23),
    ((false, false, false), 24),
    ((true, false, false), 0),
    ((false, true, true), 0),
    ((true, false, false), 1),
    ((false, false, false), 2),
    ((false, true, false), 3),
    ((false, false, false), 4),
    ((true, false, false), 5),
    ((true, false, false), 5),
];

#[test]
fn steps_that_end_on_conditions_of_their_own() {
    macro_rules! follow {
        ($name:ident $inputs:ident) => {{
            let mut chart = $name::new();
            chart.cycle(&$inputs { a: false, b: false, c: false });
            for ((a, b, c), step) in WAY {
                let outputs = chart.cycle(&$inputs { a, b, c });
                let active = <$name as grafcet::Chart>::STEPS.iter().find(|step| chart.is_active(**step)).unwrap();
                assert_eq!(format!("{active:?}"), format!("S{step}"), "{}", stringify!($name));
                assert_eq!((outputs.odd, outputs.last), (matches!(step, 1 | 3), false));
            }
        }};
    }
    follow! { Wound WoundInputs }
    follow! { SmallWound SmallWoundInputs }
}

#[test]
fn a_search_through_steps_that_end_on_conditions_of_their_own() {
    macro_rules! follow {
        ($name:ident $inputs:ident) => {{
            let mut chart = $name::new();
            let mut reach = |a, b, c| {
                let outputs = chart.cycle(&$inputs { a, b, c });
                assert!(chart.is_stable());
                let active = <$name as grafcet::Chart>::STEPS.iter().find(|step| chart.is_active(**step)).unwrap();
                (format!("{active:?}"), outputs.odd, outputs.last)
            };
            let mut at = |a, b, c, step: &str, odd, last| {
                assert_eq!(reach(a, b, c), (step.to_owned(), odd, last), "{}", stringify!($name));
            };
            at(true, false, false, "S1", true, false);
            at(false, true, false, "S3", true, false);
            at(false, false, false, "S4", false, false);
            at(true, false, false, "S5", false, false);
            at(false, true, false, "S7", false, false);
            at(true, false, true, "S8", false, false);
            // Through S9, which waits for nothing.
            at(true, true, true, "S11", false, false);
            at(true, false, false, "S13", false, false);
            at(false, true, false, "S15", false, false);
            at(false, false, false, "S16", false, false);
            at(true, true, false, "S21", false, false);
            at(false, true, false, "S23", false, false);
            // For good.
            at(false, false, true, "S25", true, true);
            at(true, true, true, "S25", true, true);
        }};
    }
    follow! { Unwound UnwoundInputs }
    follow! { SmallUnwound SmallUnwoundInputs }
}
