//! Fragments of macros keep together what belongs together: what runs is what the chart's checks have seen.

use grafcet::grafcet;

/// Expressions from outside, where operators stand beside them.
macro_rules! beside {
    ($dialect:ident $name:ident, $b:expr, $e:expr, $f:expr, $pattern:pat, $ty:ty, $time:expr, $literal:literal) => {
        grafcet! {
            /// Operators beside fragments.
            pub $dialect $name {
                #![allow(grafcet::undriven_output, grafcet::unused_variable, grafcet::vacuous_assumption)]
                input estop, door, go: bool;
                input n: $ty;
                output motor, lamp, bell, late: bool;
                output level, listed, negative: $ty = 0;
                var turns, blocked: $ty = 0;
                action report(value: $ty);

                assume never !$b && $f;
                never motor && door && estop;
                always motor => !$f;

                initial step Off { late if $time/Off; lamp if !$b; }
                step On {
                    motor if !$b;
                    bell if go && $b;
                    P1 turns = 3 * $e;
                    P1 { blocked = if !$b { 2 * $e } else { -$e }; }
                    P1 report($e * 2);
                }
                step Listed {
                    level = $e - $e;
                    listed = [$e, 2 * $e].iter().map(|x| 2 * $e + x).sum();
                    negative = $literal.pow(2);
                }

                Off -[go && !$b]-> On;
                On -[go && matches!(2 * $e, $pattern) && !rising($b)]-> Listed;
                Listed -[go as $ty < 1 && 3 * $e == 30]-> Off;
            }
        }
    };
}

// Names as inputs of the chart, from outside of the macro.
beside!(sfc Sfc, estop || door, n + 10, door && !door, 1 | 28, i16, 5s, -7i16);
beside!(grafcet Grafcet, estop || door, n + 10, door && !door, 1 | 28, i16, 5s, -7i16);

/// Fragments in fragments.
macro_rules! inner {
    ($($condition:expr),+; $block:block $statement:stmt; $vis:vis, $(#[$meta:meta])+ $path:path) => {
        grafcet! {
            $(#[$meta])+
            $vis sfc Nested {
                input a, b, c: bool;
                output q, r: bool;
                output part: $path;
                var n: u8 = 0;
                initial step A { $(N q if !$condition && c;)+ P1 $block P1 { $statement; n += 1; } part = $path::B; }
                step B { r; }
                A -[$(!$condition)&&+]-> B -[n > 2]-> A;
            }
        }
    };
}

macro_rules! outer {
    ($x:expr, $y:expr) => {
        inner! {
            $x && $y, !$x && $y; { n = 1; } n *= 2; pub, #[doc = "A chart."] #[allow(clippy::nonminimal_bool)] Part
        }
    };
}

/// What a path leads to.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub enum Part {
    /// One.
    #[default]
    A,
    /// Another.
    B,
}

outer!(a || b, b || c);

/// Runs a chart with the values that its expressions have.
#[cfg(test)]
macro_rules! check {
    ($name:ident, $inputs:ident, $actions:ident, $step:ident) => {
        /// What was reported last.
        struct Last(i16);

        impl $actions for Last {
            fn report(&mut self, _: grafcet::Phase, value: i16) {
                self.0 = value;
            }
        }

        let (mut chart, mut last) = ($name::new(), Last(0));
        let idle = $inputs::default();
        assert!(chart.cycle(&idle, 0, &mut last).lamp);
        // A door that is open and an emergency stop.
        for shut in [$inputs { door: true, ..idle }, $inputs { estop: true, ..idle }] {
            assert!(!chart.cycle(&shut, 0, &mut last).lamp);
            let q = chart.cycle(&$inputs { go: true, ..shut }, 0, &mut last);
            assert!(!q.motor && !q.late && chart.situation() == $step::Off);
        }
        assert!(chart.cycle(&idle, 5000, &mut last).late);
        let q = chart.cycle(&$inputs { go: true, ..idle }, 0, &mut last);
        assert!(q.motor && !q.bell && chart.situation() == $step::On);
        assert_eq!(last.0, 20);
        let q = chart.cycle(&$inputs { door: true, n: 4, ..idle }, 0, &mut last);
        assert!(!q.motor && !q.bell);
        let q = chart.cycle(&$inputs { go: true, door: true, n: 4, ..idle }, 0, &mut last);
        assert_eq!((chart.situation(), q.level, q.listed, q.negative), ($step::Listed, 0, 98, 49));
        let _ = chart.cycle(&$inputs { n: 1, ..idle }, 0, &mut last);
        assert_eq!(chart.situation(), $step::Listed);
        let _ = chart.cycle(&idle, 0, &mut last);
        assert_eq!(chart.situation(), $step::Off);
    };
}

#[test]
fn what_runs_is_what_was_checked() {
    {
        check!(Sfc, SfcInputs, SfcActions, SfcStep);
    }
    {
        check!(Grafcet, GrafcetInputs, GrafcetActions, GrafcetStep);
    }
}

#[test]
fn the_chart_shows_what_runs() {
    let shown = |chart: &grafcet::description::Description<'_>| {
        let conditions = chart.transitions.iter().map(|t| t.condition.to_owned());
        let actions =
            chart.steps.iter().flat_map(|step| step.actions).map(|a| format!("{} if {}", a.text, a.condition));
        conditions.chain(actions).collect::<Vec<_>>()
    };
    let sfc = shown(&Sfc::CHART);
    for text in [
        "go && !(estop || door)",
        "lamp if !(estop || door)",
        "turns = 3 * (n + 10) if ",
        "report((n + 10) * 2) if ",
        "late if 5s/Off",
    ] {
        assert!(sfc.iter().any(|shown| shown == text), "{text}: {sfc:?}");
    }
}

#[test]
fn fragments_in_fragments() {
    let mut chart = Nested::new();
    let inputs = |a, b, c| NestedInputs { a, b, c };
    // !((a || b) && (b || c)) && c
    assert!(chart.cycle(&inputs(false, false, true)).q);
    assert!(chart.cycle(&inputs(true, false, true)).q);
    assert_eq!(chart.situation(), NestedStep::A);
    // Neither `$x && $y` nor `!$x && $y`: a alone.
    let q = chart.cycle(&inputs(true, false, false));
    assert_eq!((chart.situation(), q.part), (NestedStep::B, Part::A));
}
