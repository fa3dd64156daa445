//! A30: a search that does not come to rest stops at its bound; the evolution that shows it leaves nothing behind. Where it changes
//! few fields it is taken back, else tried on a copy.

use grafcet::{Chart as _, grafcet};

/// Two branches, the second of which looks at the first; `$late` is when it goes on by itself. In the last braces stand further
/// branches, whose first and last steps stand in parentheses.
macro_rules! chart {
    ($name:ident: $late:expr, $then:expr, { $($lamp:tt)* } ($($starts:ident)*) ($($ends:ident)*) { $($rest:tt)* }) => {
        grafcet! {
            grafcet $name {
                #![allow(grafcet::set_without_reset)]
                max_evolutions 1;
                input start, a, b, c: bool;
                output lamp: bool;

                initial step Idle;
                step A1;
                step A2;
                step B1;
                step B2 { $($lamp)* }
                step B3;

                Idle -[start]-> (A1, B1 $(, $starts)*);
                A1 -[a]-> A2;
                B1 -[A2.X && b || c && $late]-> B2 -[!c && $then]-> B3;
                (A2, B3 $(, $ends)*) -[start]-> Idle;
                $($rest)*
            }
        }
    };
}

chart! { Timed: 5ms/B1, 1ms/B2, { lamp; } () () {} }
chart! { Stored: true, true, { S lamp; } () () {} }
chart! {
    Many: 5ms/B1, 1ms/B2, { S lamp; } (C1 D1) (C2 D2) {
        step C1; step C2; step D1; step D2; C1 -[a && !b]-> C2; D1 -[b && !a]-> D2;
    }
}

/// In one cycle `A1` is left, after which `b` would let `B1` go in the same search; the next cycle comes without it, but with
/// what lets `B1` go by itself.
macro_rules! leaves_nothing {
    ($chart:ident, $inputs:ident, $step:ident) => {{
        let mut chart = $chart::new();
        let cycle = |chart: &mut $chart, [start, a, b, c]: [bool; 4], now: u32| {
            chart.scan(&$inputs { start, a, b, c }, now.into(), &mut ())
        };
        cycle(&mut chart, [false; 4], 0);
        cycle(&mut chart, [true, false, false, false], 0);
        assert!(chart.is_stable() && chart.is_active($step::B1));

        let outputs = cycle(&mut chart, [false, true, true, false], 4);
        assert!(!chart.is_stable(), "the search would go on");
        assert!(chart.is_active($step::A2) && chart.is_active($step::B1) && !chart.is_active($step::B2));
        assert!(!outputs.lamp, "`B2` was never active");

        let outputs = cycle(&mut chart, [false, false, false, true], 5);
        assert!(chart.is_stable() && chart.is_active($step::B2), "`B1` has been active all the time");
        assert!(outputs.lamp);

        // What is stable after as many evolutions as the bound allows is stable.
        let mut chart = $chart::new();
        cycle(&mut chart, [false; 4], 0);
        cycle(&mut chart, [true, false, false, false], 0);
        cycle(&mut chart, [false, true, false, false], 1);
        assert!(chart.is_stable() && chart.is_active($step::A2) && chart.is_active($step::B1));
    }};
}

#[test]
fn a30_what_comes_after_the_bound_leaves_nothing_behind() {
    leaves_nothing!(Timed, TimedInputs, TimedStep);
    leaves_nothing!(Stored, StoredInputs, StoredStep);
    leaves_nothing!(Many, ManyInputs, ManyStep);
}
