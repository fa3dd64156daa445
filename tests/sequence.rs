//! A sequence that is long enough to be a table: each step ends on its own input, or on the negation of one.

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
        assert!(chart.is_active(named((step + 1) % 24)), "behind S{step}");
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
