//! Names that Rust binds inside blocks and conditions: each as long as its scope, whatever the chart declares under that name;
//! and calls that read what they are called on.
#![allow(clippy::shadow_unrelated)]
#![allow(
    clippy::assign_op_pattern,
    clippy::trivially_copy_pass_by_ref,
    clippy::redundant_locals,
    clippy::clone_on_copy,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "what a user may write is read, not what one should"
)]

use grafcet::grafcet;

/// Something that a chart cannot look into.
#[derive(Clone, Copy, Default, PartialEq)]
pub enum Mode {
    #[default]
    /// Nothing.
    Off,
    /// So much.
    Level(u16),
}

grafcet! {
    grafcet Scopes {
        #![allow(grafcet::write_race)]
        input x: u16;
        input list: [u16; 4];
        input mode: Mode;
        output q: u16 = 7;
        output any, above: bool;
        var seen: u16 = 0;
        var sum: u16 = 0;

        initial step A {
            any if list.iter().any(|x| *x > 3);
            P0 { let x = 5; let mut q = x; q += 1; seen = q; }
        }
        step B {
            above if match mode { Mode::Level(x) => x > 10, Mode::Off => false };
            // `q` is the output in step C alone.
            P0 { { let q = x; sum += q; } if let Some(q) = list.iter().max() { seen = *q; } sum += x; }
        }
        step C {
            q = 9;
            P0 {
                #[allow(non_upper_case_globals)]
                const q: u16 = 100;
                fn x(seen: u16) -> u16 { seen + 1 }
                let Mode::Level(level) = mode else { unreachable!() };
                for x in list { sum += x; }
                seen = q + x(level);
            }
        }
        A -[x > 1]-> B -[matches!(mode, Mode::Level(x) if x > 10)]-> C;
        C -[if let Mode::Level(x) = mode && x > 20 { x > 30 } else { x == 99 }]-> A;
    }
}

#[test]
fn names_of_rust_live_as_long_as_their_scopes() {
    let mut chart = Scopes::new();
    let inputs = ScopesInputs { x: 0, list: [0, 4, 0, 0], mode: Mode::Off };
    let outputs = chart.cycle(&inputs);
    assert!(outputs.any && outputs.q == 7);
    let outputs = chart.cycle(&ScopesInputs { x: 2, ..inputs });
    assert!(chart.is_active(ScopesStep::B) && !outputs.above && outputs.q == 7);
    chart.cycle(&ScopesInputs { x: 2, mode: Mode::Level(11), ..inputs });
    assert!(chart.is_active(ScopesStep::C));
    let outputs = chart.cycle(&ScopesInputs { x: 2, mode: Mode::Level(29), ..inputs });
    assert!(chart.is_active(ScopesStep::C) && outputs.q == 9);
    let outputs = chart.cycle(&ScopesInputs { x: 99, mode: Mode::Level(5), ..inputs });
    assert!(chart.is_active(ScopesStep::B) && outputs.q == 7, "the `x` after `else` is the input");
}

grafcet! {
    sfc Shadowed {
        input go: bool;
        input x: u16;
        output q: u16 = 1;
        output r: u16 = 1;
        var before: u16 = 0;

        initial step A { P1 { q = q + x; } }
        // The output up to the `let`, something else after it and inside, the output again after the block.
        step B {
            P1 {
                q += 10;
                if go { let mut q = x; q += 1; r = q; }
                q += 10;
                let mut q = 500;
                q += 1;
                before = q;
            }
        }
        A -[go]-> B -[!go]-> A;
    }
}

#[test]
fn a_let_hides_an_output_from_there_on() {
    let mut chart = Shadowed::new();
    let outputs = chart.cycle(&ShadowedInputs { go: false, x: 3 });
    assert_eq!((outputs.q, outputs.r), (4, 1));
    let outputs = chart.cycle(&ShadowedInputs { go: true, x: 3 });
    assert_eq!((outputs.q, outputs.r), (24, 4));
}

trait Bump {
    fn bump(&mut self, by: u16);
}

impl Bump for u16 {
    fn bump(&mut self, by: u16) {
        *self += by;
    }
}

/// A type with methods that nobody knows.
#[derive(Clone, Copy, Default, PartialEq)]
pub struct Totals {
    parts: [u16; 2],
}

impl Totals {
    const NONE: Self = Self { parts: [0, 0] };

    fn all(&self) -> u16 {
        self.parts.iter().sum()
    }
}

grafcet! {
    sfc Calls {
        input a: bool;
        output c: u16 = 3;
        output level: i16 = -5;
        output gain: f32 = 2.0;
        output list: [u16; 3] = [1, 2, 3];
        output soak: time = 20ms;
        output first: Option<u16> = Some(4);
        output totals: Totals = Totals::NONE;
        var n: u16 = 0;
        var m: i32 = 0;

        // Assigned while a step is active; the blocks only read them, so that nothing is mixed.
        initial step A {
            c = 3; level = -5; gain = 2.0; list = [1, 2, 3]; soak = 20ms; first = Some(4); totals = Totals { parts: [6, 7] };
        }
        step B {
            P1 { n = c.wrapping_add(1).max(c.pow(2)) + c.saturating_sub(5) + c.clone(); m = i32::from(level.abs()); }
            P1 { m = i32::from(list[1].min(list.len() as u16)) + i32::from(list.iter().sum::<u16>()) + soak.get() as i32; }
            P0 { n = first.map_or(0, |c| c + 1) + (gain.to_bits() >> 30) as u16; let totals = totals; m += i32::from(totals.all()); }
        }
        A -[a && n < 200 && m < 200]-> B -[!a]-> A;
    }
}

#[test]
fn methods_of_known_types_read() {
    let mut chart = Calls::new();
    chart.cycle(&CallsInputs { a: false });
    chart.cycle(&CallsInputs { a: true });
    assert!(chart.is_active(CallsStep::B));
    let outputs = chart.cycle(&CallsInputs { a: false });
    assert_eq!((outputs.c, outputs.level), (3, -5));
}

grafcet! {
    sfc Parts {
        input a: bool;
        output list: [u16; 3] = [1, 2, 3];
        output other: u16 = 0;
        output sum: u16;

        initial step A { P0 { if a { list[1].bump(5); } } }
        step B { P0 { if a { let third = &mut list[2]; *third += 1; } } }
        step C { sum = list[0] + list[1] + list[2]; P1 { if a { other.bump(2); } } }
        A -[true]-> B -[true]-> C -[true]-> A;
    }
}

#[test]
fn a_part_that_is_written_in_another_way_is_written() {
    let mut chart = Parts::new();
    for _ in 0..3 {
        chart.cycle(&PartsInputs { a: true });
    }
    assert!(chart.is_active(PartsStep::C));
    let outputs = chart.cycle(&PartsInputs { a: true });
    assert_eq!(outputs.list, [1, 7, 4]);
    assert_eq!(outputs.other, 2);
}

/// Declares a local that is called as its caller says.
macro_rules! count {
    ($name:ident) => {
        let mut $name: u16 = 1;
    };
}

grafcet! {
    sfc Declared {
        input go: bool;
        input x: u16;
        output q: u16 = 0;

        initial step Idle;
        // What the macro declares hides the input.
        step Count { P1 { count!(x); x += 4; q = x; } }
        Idle -[go]-> Count -[x > 1]-> Idle;
    }
}

#[test]
fn a_macro_may_declare_what_a_block_writes() {
    let mut chart = Declared::new();
    let mut cycle = |go| chart.cycle(&DeclaredInputs { go, x: 0 }).q;
    assert_eq!([cycle(false), cycle(true), cycle(true)], [0, 5, 5]);
}
