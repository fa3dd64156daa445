//! Charts that other macros write, from what they are given.

use grafcet::{Phase, grafcet};

/// Parts of a chart of every kind of fragment.
macro_rules! parts {
    (
        $(#[$meta:meta])* $vis:vis $name:ident, $input:ident: $ty:ty, $outputs:tt, $step:ident, $value:expr, $condition:expr,
        $text:literal, $time:tt, $block:block, $back:tt
    ) => {
        grafcet! {
            $(#[$meta])*
            $vis sfc $name {
                #![allow(grafcet::undriven_output)]
                input $input: $ty;
                input stop: bool;
                output $outputs: bool;
                output level: $ty = 0;
                output text: &'static str = $text;
                var count: $ty = $value;
                param limit: $ty = $value;
                action report(value: $ty);

                initial step Idle { N report($value); }
                step $step { N $outputs; level = $value; D $time $outputs; P1 $block P1 count = $input; }

                $step -[stop && $step.T > 3s && $condition && limit > count]-> Idle;
                Idle -[$input > $value]-> $step -[$back]-> Idle;
                $step -[$condition]-> Idle;
            }
        }
    };
}

/// Read by a condition that comes from outside.
const ENOUGH: u16 = 9;

parts! {
    /// A chart in parts.
    pub Parts, sensor: u16, motor, Running, 3, ENOUGH > 10, "text", 2s, { let twice = ENOUGH * 2; let _ = twice; }, (stop)
}

/// Visibility, types, times, edges and steps from outside.
macro_rules! timed {
    ($vis:vis $name:ident($ty:ty) $time:literal $edge:expr; $($step:ident [$output:ident]),+; $last:ident) => {
        grafcet! {
            /// A timed chart.
            $vis grafcet $name {
                #![allow(grafcet::dead_transition)]
                input button: $ty;
                $(output $output: $ty;)+
                #[allow(grafcet::unused_variable)]
                var pressed: $ty = false;
                initial step $last { pressed; }
                $(step $step { $output; D $time pressed; })+
                $last $(-[$edge && $time/$last]-> $step)+ -[$edge]-> $last;
            }
        }
    };
}

timed! { Timed(bool) 2s rising(button); Waiting [lamp], r#loop [r#in]; Last }

/// A sequence of any length.
macro_rules! sequence {
    ($name:ident: $first:ident $(-[$input:ident]-> $step:ident)*) => {
        grafcet! {
            /// A sequence.
            pub grafcet $name {
                #![allow(grafcet::deadlock)]
                $(input $input: bool;)*
                initial step $first;
                $(step $step;)*
                $first $(-[rising($input)]-> $step)*;
            }
        }
    };
}

sequence! { Sequence: A -[a]-> B -[b]-> C -[c]-> E }

/// A chart as it stands.
macro_rules! whole {
    ($($tokens:tt)*) => {
        grafcet! { $($tokens)* }
    };
}

whole! {
    /// Twice passed on.
    pub grafcet Whole {
        input x: bool;
        output lamp: bool;
        initial step A;
        step B { lamp; }
        A -[x]-> B -[5s/B]-> A;
    }
}

/// Inputs that the macro names are apart from those it is given, and here they are the same.
macro_rules! mixed {
    ($value:ident) => {
        grafcet! {
            /// Names from both sides.
            pub sfc Mixed {
                input value, $value: bool;
                output first: bool;
                initial step A { first; }
                step B;
                A -[value && !$value]-> B -[$value]-> A;
            }
        }
    };
}

mixed!(inputs);

/// Carries out no action.
#[derive(Clone, Copy, Debug)]
pub struct Silent;

impl PartsActions for Silent {
    fn report(&mut self, _: Phase, _: u16) {}
}

#[test]
fn runs() {
    let mut parts = Parts::new();
    parts.cycle(&PartsInputs::default(), 0, &mut Silent);
    let q = parts.cycle(&PartsInputs { sensor: 4, stop: false }, 1, &mut Silent);
    assert_eq!((q.level, q.motor, q.text), (3, true, "text"));
    let mut sequence = Sequence::new();
    sequence.cycle(&SequenceInputs::default());
    sequence.cycle(&SequenceInputs { a: true, ..Default::default() });
    assert_eq!(sequence.situation(), SequenceStep::B);
    let mut timed = Timed::new();
    timed.cycle(&TimedInputs { button: false }, 0);
    timed.cycle(&TimedInputs { button: true }, 2000);
    assert_eq!(timed.situation(), TimedStep::Waiting);
    assert!(Whole::new().cycle(&WholeInputs { x: true }, 0).lamp);
    assert!(Mixed::new().cycle(&MixedInputs::default()).first);
}

/// A place with a field that is called like an input.
struct Place {
    sensor: u16,
}

impl Place {
    const fn is_near(&self) -> bool {
        self.sensor < 10
    }
}

/// The input comes from inside, a struct expression that reads it from outside.
macro_rules! declared {
    ($vis:vis $name:ident: $condition:expr) => {
        grafcet! {
            /// A chart that asks about places.
            $vis sfc $name {
                input sensor: u16;
                output far: bool;
                initial step Near;
                step Far { far; }
                Near -[$condition]-> Far -[Place { sensor }.is_near()]-> Near;
            }
        }
    };
}

declared! { pub Places: !Place { sensor }.is_near() }

#[test]
fn fields_take_the_values_of_their_names() {
    let mut places = Places::new();
    let mut far = |sensor| places.cycle(&PlacesInputs { sensor }).far;
    assert!([3, 12, 12, 3, 3].map(&mut far) == [false, true, true, false, false]);
}
