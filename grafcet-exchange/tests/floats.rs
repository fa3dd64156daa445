//! Floats in exported programs: as the interpreter of the chart has them, bit by bit.

mod common;

#[path = "machine/mod.rs"]
mod machine;

use common::model;
use grafcet_exchange::import::import;
use grafcet_exchange::plcopen::{Edition, plcopen};
use grafcet_exchange::sfc::textual;
use grafcet_exchange::st::{Flavour, Form, Options, Order, structured_text};
use grafcet_sim::{Chart, Simulation};
use machine::{Dialect, Machine, Real, Value};

const OVEN: &str = "Oven { input start: bool; input level: f32; input rate: f64; param high: f32 = 60.5;
    output heat, warm: bool; output power: f64 = -1.5e-1; var sum: f32 = 0.1f32; var worst: f64;
    initial step Wait { P1 power = 0.0; }
    step Fill { heat; P1 sum = sum * 0.5 + level / 4.0 - 0.3; }
    step Soak { warm if level < 40.25; P1 power = rate * 1.1 + worst; }
    step Cool { P1 worst = -rate - 2.; }
    Wait -[start && level < high - 2.5]-> Fill -[level >= high || sum > 2.5e1]-> Soak -[!start || level * 0.5 <= 10.0]-> Cool;
    Fill -[!start && sum == sum || start && level < 55.0 && rising(level * 2.0 > 30.5)]-> Wait; Cool -[rate / 3.0 != worst && level - high < 0.0]-> Wait; }";

const FLAVOURS: [(Flavour, Dialect); 3] =
    [(Flavour::Iec, Dialect::Iec), (Flavour::Codesys, Dialect::Codesys), (Flavour::Tia, Dialect::Tia)];

/// A few hundred scans with inputs at random, in each form and for each tool.
#[test]
fn floats_are_computed_as_in_rust() {
    for (dialect, form, order) in [
        ("sfc", Form::FlipFlops, None),
        ("sfc", Form::Case, Some(Order::EvolveFirst)),
        ("grafcet", Form::FlipFlops, None),
    ] {
        let text = format!("{dialect} {OVEN}");
        for (flavour, language) in FLAVOURS {
            let options = Options { form, order, flavour, ..Options::default() };
            let program = structured_text(&model(&text), &options).unwrap_or_else(|refused| panic!("{refused:?}"));
            let mut machine =
                Machine::of(&program.text, language).unwrap_or_else(|why| panic!("{why}: {}", program.text));
            let chart = Chart::parse(&text).unwrap_or_else(|error| panic!("{error}"));
            let mut oracle = Simulation::new(&chart).expect("understood");
            let (mut seed, mut entered) = (7_u32, std::collections::BTreeSet::new());
            for cycle in 0..200_u32 {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let start = seed >> 28 > 4;
                let level = f64::from(f32::from(u16::try_from(seed >> 8 & 0x3ff).expect("ten bits")) * 0.1);
                let rate = f64::from(seed >> 18 & 0xff) / 7.0;
                let float = grafcet_sim::Value::Float;
                let inputs = [("start", start.into()), ("level", float(level)), ("rate", float(rate))];
                oracle.cycle(cycle * 10, &inputs).expect("a cycle");
                machine.now = u64::from(cycle) * 10;
                machine.set("start", Value::Bool(start)).expect("an input");
                machine.set("level", Value::Real(Real::new(level, Some(true)))).expect("an input");
                machine.set("rate", Value::Real(Real::new(rate, Some(false)))).expect("an input");
                // As many scans as a search of the chart can have evolutions.
                for _ in 0..if dialect == "sfc" { 1 } else { 40 } {
                    machine.scan().unwrap_or_else(|why| panic!("{why}: {}", program.text));
                }
                for name in ["heat", "warm", "power", "sum", "worst"] {
                    let wanted = oracle.output(name).or_else(|| oracle.variable(name));
                    let is = match machine.get(name).expect("a variable") {
                        Value::Bool(is) => is.into(),
                        Value::Real(real) => float(real.number()),
                        other => panic!("{other:?}"),
                    };
                    assert_eq!(
                        Some(is),
                        wanted,
                        "{dialect} {form:?} {flavour:?}, cycle {cycle}: {name}\n{}",
                        program.text
                    );
                }
                entered.extend(oracle.steps());
            }
            assert_eq!(entered.len(), 4, "every step was active");
        }
    }
}

/// What has no operator there is a function to be written, or refused.
#[test]
fn functions_and_remainders() {
    let of = |condition: &str| {
        let chart =
            format!("sfc C {{ input x, y: f32; initial step A; step B; A -[{condition}]-> B -[x < 0.0]-> A; }}");
        structured_text(&model(&chart), &Options { form: Form::FlipFlops, ..Options::default() })
    };
    let text = of("calibrated(x) > y").expect("a translation").text;
    for line in ["FUNCTION calibrated : REAL", "x : REAL;", "calibrated := 0.0;"] {
        assert!(text.lines().any(|other| other.trim() == line), "{line}\n{text}");
    }
    for (condition, why) in [
        (
            "x % 2.0 > 1.0",
            "`%` on floats has no translation into structured text; write it as a function of the program",
        ),
        ("1.0 / x > 2.0", "a division by what may be zero has no translation"),
        ("1.0 / 0.0 > x", "a division by what may be zero has no translation"),
    ] {
        let refused = of(condition).expect_err(condition);
        assert!(refused[0].to_string().contains(why), "{condition}: {refused:?}");
    }
}

/// By way of SFC as text and of both editions of the XML they are the same again.
#[test]
fn there_and_back() {
    let chart = model(&format!("sfc {OVEN}"));
    let mut texts = vec![textual(&chart).expect("a translation").text];
    for edition in [Edition::Tc6, Edition::Iec61131Part10] {
        let options = grafcet_exchange::plcopen::Options { edition, ..Default::default() };
        texts.push(plcopen(&chart, options).expect("a translation").text);
    }
    for text in texts {
        let back = import(&text, "there").expect("a chart").rust;
        for part in ["level: f32", "rate: f64", "power = rate * 1.1 + worst", "level < high - 2.5", "sum > 2.5E1"] {
            assert!(back.contains(part), "{part}\n{back}\n{text}");
        }
    }
}
