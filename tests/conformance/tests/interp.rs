//! The interpreter's own contract: errors instead of panics, declared types, parameters, repeatability.

use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_sim::interp::{Cycle, Error, Interpreter, Real, Value};

fn model(chart: &str) -> Model {
    let mut sink = Sink::new();
    let chart = parse::chart(chart.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    let messages = sink.finish();
    assert!(messages.is_empty(), "{messages:?}");
    model
}

/// One cycle of `P1 n = <expression>` with `n` of the given type and one integer input `x` of the same type.
fn assign(ty: &str, expression: &str, x: i128) -> Result<Value, Error> {
    let chart = format!(
        "grafcet C {{ input x: {ty}; output n: {ty}; initial step A {{ P1 n = {expression}; }} step B; A -[false]-> B; }}"
    );
    let model = model(&chart);
    let cycle = Interpreter::new(&model)?.cycle(&[Value::Int(x)], 0)?;
    Ok(cycle.outputs[0])
}

#[test]
fn arithmetic_has_the_width_of_the_declared_type() {
    assert_eq!(assign("u8", "x + 1", 254), Ok(Value::Int(255)));
    assert!(matches!(assign("u8", "x + 1", 255), Err(Error::Overflow(_))));
    assert!(matches!(assign("u8", "x - 1", 0), Err(Error::Overflow(_))));
    assert!(matches!(assign("i8", "-x", -128), Err(Error::Overflow(_))));
    assert!(matches!(assign("i8", "x / -1", -128), Err(Error::Overflow(_))));
    assert!(matches!(assign("i16", "x % -1", -32768), Err(Error::Overflow(_))));
    assert!(matches!(assign("u8", "300", 0), Err(Error::Overflow(_))));
    assert_eq!(assign("u128", "x * 2", i128::MAX / 2), Ok(Value::Int(i128::MAX - 1)));
    // An intermediate result counts as well: Rust would panic at the product.
    assert!(matches!(assign("u8", "x * 2 / 2", 200), Err(Error::Overflow(_))));
}

#[test]
fn floats_are_those_of_rust() {
    let real = |value: f64| Value::Real(Real(value));
    let assign = |ty: &str, expression: &str, x: f64| -> Result<Value, Error> {
        let chart = format!(
            "grafcet C {{ input x: {ty}; output n: {ty}; initial step A {{ P1 n = {expression}; }} step B; A -[false]-> B; }}"
        );
        let model = model(&chart);
        let cycle = Interpreter::new(&model)?.cycle(&[real(x)], 0)?;
        Ok(cycle.outputs[0])
    };
    assert_eq!(assign("f32", "x * 3.0 + 0.1", 0.7), Ok(real(f64::from(0.7_f32 * 3.0 + 0.1))));
    assert_eq!(assign("f64", "x * 3.0 + 0.1", 0.7), Ok(real(0.7 * 3.0 + 0.1)));
    assert_eq!(assign("f64", "-x % 2.5 / 0.0", 7.0), Ok(real(f64::NEG_INFINITY)));
    let close =
        "sfc C { input t: f32; output q: bool; initial step A { q if t == 0.1 && t < 1e3; } step B; A -[false]-> B; }";
    let model = model(close);
    let mut machine = Interpreter::new(&model).expect("understood");
    assert_eq!(machine.cycle(&[real(0.1)], 0).map(|c| c.outputs), Ok(vec![Value::Bool(true)]), "0.1 is an f32 there");
}

#[test]
fn methods_of_integers_are_those_of_rust() {
    assert_eq!(assign("u16", "x.abs_diff(500)", 497), Ok(Value::Int(3)));
    assert_eq!(assign("u8", "x.wrapping_add(10)", 250), Ok(Value::Int(4)));
    assert_eq!(assign("i8", "x.wrapping_sub(10)", -125), Ok(Value::Int(121)));
    assert_eq!(assign("u8", "x.saturating_sub(10)", 3), Ok(Value::Int(0)));
    assert_eq!(assign("i8", "x.saturating_mul(10)", -100), Ok(Value::Int(-128)));
    assert_eq!(assign("u8", "x.clamp(10, 20).max(12).min(18)", 200), Ok(Value::Int(18)));
    assert!(matches!(assign("i8", "x.abs()", -128), Err(Error::Overflow(_))));
    assert_eq!(assign("i16", "x.rem_euclid(7)", -1), Ok(Value::Int(6)));
    assert_eq!(assign("i16", "x.div_euclid(0)", -1), Err(Error::DivisionByZero));
    assert_eq!(assign("u8", "x.pow(2)", 15), Ok(Value::Int(225)));
    assert!(matches!(assign("u8", "x.pow(2)", 16), Err(Error::Overflow(_))));
    assert_eq!(assign("i32", "x as u8 as i8 as i32", 0x1_ff), Ok(Value::Int(-1)));
}

#[test]
fn division_by_zero_is_an_error() {
    assert_eq!(assign("u8", "10 / x", 0), Err(Error::DivisionByZero));
    assert_eq!(assign("u8", "10 % x", 0), Err(Error::DivisionByZero));
    assert_eq!(assign("u8", "10 % x", 4), Ok(Value::Int(2)));
}

#[test]
fn bits_are_those_of_rust() {
    assert_eq!(assign("u8", "!x", 0b0000_1111), Ok(Value::Int(0b1111_0000)));
    assert_eq!(assign("i8", "!x", 0), Ok(Value::Int(-1)));
    assert_eq!(assign("u8", "x << 4", 0xff), Ok(Value::Int(0xf0)));
    assert_eq!(assign("i8", "x << 1", 64), Ok(Value::Int(-128)));
    assert_eq!(assign("i8", "x >> 1", -3), Ok(Value::Int(-2)));
    assert!(matches!(assign("u8", "x << 8", 1), Err(Error::Overflow(_))));
    assert_eq!(assign("u8", "x & 6 | 8 ^ 1", 3), Ok(Value::Int(3 & 6 | 8 ^ 1)));
}

#[test]
fn and_or_are_lazy() {
    let model = model(
        "sfc C { input d: u8; output q: bool; initial step A { q if d != 0 && 10 / d > 2; } step B; A -[false]-> B; }",
    );
    let mut machine = Interpreter::new(&model).expect("understood");
    assert_eq!(machine.cycle(&[Value::Int(0)], 0).map(|c| c.outputs), Ok(vec![Value::Bool(false)]));
    assert_eq!(machine.cycle(&[Value::Int(2)], 0).map(|c| c.outputs), Ok(vec![Value::Bool(true)]));
}

#[test]
fn unknown_rust_is_not_guessed() {
    let opaque = model("sfc C { input x: u8; initial step A; step B; A -[x.is_power_of_two()]-> B -[true]-> A; }");
    let mut machine = Interpreter::new(&opaque).expect("understood so far");
    assert!(machine.cycle(&[Value::Int(1)], 0).is_ok(), "the first cycle evaluates no transition");
    assert!(matches!(machine.cycle(&[Value::Int(1)], 0), Err(Error::NotUnderstood(_))));

    let block =
        model("sfc C { var n: u8 = 0; initial step A { P1 { for _ in 0..3 { n += 1; } } } step B; A -[n > 9]-> B; }");
    assert!(matches!(Interpreter::new(&block).map(|mut m| m.cycle(&[], 0)), Ok(Err(Error::NotUnderstood(_)))));

    let default = model("sfc C { input x: Mode; initial step A; step B; A -[x == Mode::Auto]-> B -[true]-> A; }");
    let mut machine = Interpreter::new(&default).expect("understood so far");
    assert!(machine.cycle(&[Value::Unknown], 0).is_ok());
    assert!(matches!(machine.cycle(&[Value::Unknown], 0), Err(Error::NotUnderstood(_))));
}

#[test]
fn inputs_and_parameters_must_fit_their_declarations() {
    let model = model(
        "sfc C { input x: u8; param p: time = 5s; output q: bool; initial step A { q if x > 0 && p/A; } step B; A -[false]-> B; }",
    );
    let mut machine = Interpreter::new(&model).expect("understood");
    assert_eq!(machine.params(), [Value::Ticks(5000)]);
    assert_eq!(machine.cycle(&[], 0), Err(Error::Count { expected: 1, found: 0 }));
    assert!(matches!(machine.cycle(&[Value::Int(256)], 0), Err(Error::Overflow(_))));
    assert!(matches!(machine.cycle(&[Value::Bool(true)], 0), Err(Error::Type(_))));
    assert!(matches!(machine.set_params(&[Value::Int(1)]), Err(Error::Type(_))));
    assert_eq!(machine.set_params(&[Value::Ticks(0)]), Ok(()));
    assert_eq!(machine.cycle(&[Value::Int(1)], 0).map(|c| c.outputs), Ok(vec![Value::Bool(true)]));
}

#[test]
fn what_depends_on_itself_is_refused() {
    let circle =
        model("grafcet C { var a, b: bool; initial step A { a if b; b if a; } step B; A -[a]-> B -[true]-> A; }");
    assert_eq!(Interpreter::new(&circle).err(), Some(Error::Circle("a".to_owned())));
    let forcing = model(
        "grafcet C { partial Up { initial step A { force Down {}; } step A2; A -[true]-> A2 -[true]-> A; }
                     partial Down { initial step B { force Up {}; } step B2; B -[true]-> B2 -[true]-> B; } }",
    );
    assert!(matches!(Interpreter::new(&forcing).err(), Some(Error::Circle(_))));
}

#[test]
fn qualifiers_without_a_target_in_the_dialect_are_refused() {
    let bare = model("sfc C { output q: bool; initial step A { P1 q; } step B; A -[true]-> B -[true]-> A; }");
    assert!(matches!(Interpreter::new(&bare).err(), Some(Error::WrongTarget(_))));
    let sd = model("grafcet C { output q: bool; initial step A { SD 5s q; } step B; A -[true]-> B -[true]-> A; }");
    assert!(matches!(Interpreter::new(&sd).err(), Some(Error::WrongTarget(_))));
}

#[test]
fn init_gives_the_same_run_again() {
    let model = model(
        "grafcet C { input x: bool; output n: u8; output q: bool; action note(n: u8);
           initial step A { P1 n = n + 1; N note(n); } step B { q if 3ms/(x && B.X)/2ms; on rising(x) n = n + 2; }
           A -[x]-> B -[!x && 4ms/B]-> A; }",
    );
    let run = |machine: &mut Interpreter<'_>, start: u32| -> Vec<Cycle> {
        let input = |i: u32| [Value::Bool(i % 7 > 2 || i % 5 > 3)];
        (0..60).map(|i| machine.cycle(&input(i), start.wrapping_add(i)).expect("understood")).collect()
    };
    let mut machine = Interpreter::new(&model).expect("understood");
    let before = (machine.situation().clone(), machine.outputs().to_vec());
    let first = run(&mut machine, 5);
    assert!(first.iter().any(|cycle| cycle.outputs[1] == Value::Bool(true)), "the run shows something");
    machine.init().expect("understood");
    assert_eq!((machine.situation().clone(), machine.outputs().to_vec()), before);
    assert_eq!(run(&mut machine, u32::MAX - 20), first, "the origin of time does not matter");
}
