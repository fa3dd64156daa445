//! Rust that is not looked into, in what is proved: what the program around a chart says may break a property, and the way says what that is.

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_compiler::program::counted;
use grafcet_prove::circuit::Circuit;
use grafcet_prove::replay::Shown;
use grafcet_prove::task::{Invariant, Task};
use grafcet_prove::{Limit, Verdict, certificate, decide, decide_live, table, words};
use grafcet_sim::interp::Value;

fn read(text: &str) -> Model {
    let mut sink = Sink::new();
    let tokens = text.parse().expect("tokens");
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink)).expect("a chart");
    let broken: Vec<String> =
        sink.finish().iter().filter(|one| one.rule.is_none()).map(|one| format!("{one:?}")).collect();
    assert!(broken.is_empty(), "it is understood: {broken:?}");
    model
}

fn verdicts(text: &str) -> Vec<Verdict> {
    let model = read(text);
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let verdict = |property: usize| {
        let limit = Limit::none();
        if let Some(bad) = circuit.bad.iter().find(|bad| bad.property == property) {
            return decide(&program, &circuit, *bad, &limit);
        }
        let live = circuit.live.iter().find(|live| live.property == property).expect("it is modelled");
        decide_live(&program, &circuit, *live, &limit)
    };
    (0..model.properties.len()).map(|property| verdict(property).expect("no internal error")).collect()
}

fn broken(verdict: &Verdict) -> &[Shown] {
    match verdict {
        Verdict::Violated(way) | Verdict::Endless { way, .. } => way,
        other => panic!("{other:?}"),
    }
}

fn is_proved(verdict: &Verdict) -> bool {
    matches!(verdict, Verdict::Proved(_))
}

fn undecided(verdict: &Verdict) -> &str {
    match verdict {
        Verdict::Undecided(why) => why,
        other => panic!("{other:?}"),
    }
}

/// A tank that asks its program whether a level can be, and up to where it fills.
const TANK: &str = "
    input level: u16; input go: bool;
    output pump, valve: bool;
    initial step Rest; step Fill { pump; } step Hot { valve; }
    Rest -[go && plausible(level)]-> Fill -[level > limit(3)]-> Hot -[!go]-> Rest;";

#[test]
fn what_the_program_says_stands_in_the_way() {
    let text = format!("sfc Tank {{ {TANK} never pump && level > 500; never Hot.X && Fill.X; Fill leads_to Hot; }}");
    let found = verdicts(&text);
    let way = broken(&found[0]);
    assert_eq!(way.len(), 2);
    assert_eq!(way[1].told, [("plausible(level)".to_owned(), Value::Bool(true))]);
    let shown = table(&read(&text), way);
    assert!(shown.contains(", go, plausible(level) |"), "{shown}");
    assert!(shown.ends_with("if the program ever comes to these values of `plausible(level)`\n"), "{shown}");
    assert!(is_proved(&found[1]));
    // The limit may always be above the level.
    let last = broken(&found[2]).last().expect("cycles");
    let limit = last.told.iter().find(|(text, _)| text == "limit(3)").expect("it is asked for");
    let (Value::Int(limit), Value::Int(level)) = (limit.1, last.inputs[0]) else { panic!("{last:?}") };
    assert!(level <= limit);
}

/// What stands beside an integer is one of its type, so that nothing is above the greatest one.
#[test]
fn a_value_has_the_type_of_what_it_is_compared_with() {
    let found = verdicts(
        "sfc C { input x: u8; output q: bool; var n: u8 = 0;
         initial step A; step B { q; P1 n = scale(x); }
         A -[x > offset()]-> B -[x <= offset()]-> A;
         never q && n == 255; always n <= 255; never B.X && x == 0 && A.X; }",
    );
    let way = broken(&found[0]);
    assert_eq!(way[1].told, [("offset()".to_owned(), Value::Int(0)), ("scale(x)".to_owned(), Value::Int(255))]);
    assert!(is_proved(&found[1]) && is_proved(&found[2]));
    let found = verdicts(
        "sfc C { input x: u8; initial step A; step B; A -[x == 0 && x > offset()]-> B -[x == 1]-> A; never B.X; }",
    );
    assert!(is_proved(&found[0]));
}

/// In one cycle two calls may come to two values: an interpreter is told one.
#[test]
fn two_values_in_one_cycle_are_not_shown() {
    let chart = |pure: &str| {
        verdicts(&format!(
            "grafcet C {{ {pure} initial step A; step B; step D; A -[ready()]-> B -[!ready()]-> D -[ready()]-> A; never D.X && A.X; never D.X; }}"
        ))
    };
    let found = chart("");
    assert!(is_proved(&found[0]));
    // In one cycle as far as `B`, in the next one on.
    assert_eq!(broken(&found[1]).len(), 2);
    let found = verdicts(
        "grafcet C { initial step A; step B; step D; A -[ready()]-> B -[!ready()]-> D; var n: bool; A -> D; never B.X && n; }",
    );
    assert!(is_proved(&found[0]));
    let alone = "grafcet C { input go: bool; initial step A; step B; step D; A -[go && ready()]-> B; A -[!go]-> D; B -[!ready()]-> D; D -[go]-> A; never D.X && go; }";
    let found = verdicts(alone);
    let why = undecided(&found[0]);
    assert!(why.contains("`ready()` has two values in one cycle") && why.contains("assume pure"), "{why}");
}

/// A constant is any value, but one.
#[test]
fn constants_stay_what_they_are() {
    let found = verdicts(
        "sfc C { input part, full: bool; output q: bool; var n: u8 = 0;
         initial step A; step B { P1 n = n + 1; } step D { q; P1 n = 0; }
         A -[part && n < MOST]-> B -[!part]-> A; A -[n >= MOST]-> D -[full]-> A;
         never n > MOST; always n <= limits::MOST; never q && n > 0; never B.X && MOST == 0; never A.X && part && MOST > 3; }",
    );
    assert!(is_proved(&found[0]) && is_proved(&found[2]) && is_proved(&found[3]));
    assert!(broken(&found[1]).iter().any(|shown| shown.told.iter().any(|(text, _)| text == "limits::MOST")));
    let told = &broken(&found[4])[0].told;
    assert!(matches!(told[..], [(ref text, Value::Int(4..=255))] if text == "MOST"), "{told:?}");
}

/// What is computed of the same values is the same.
#[test]
fn what_is_pure_has_one_value_for_each() {
    let found = verdicts(
        "sfc C { input x: u8; assume pure near; initial step A; step B; step D; A -[near(x) && x == 3]-> B -[!near(x) && x == 3]-> D -[x == 0]-> A;
         never D.X; never B.X; }",
    );
    assert!(undecided(&found[0]).contains("near"), "{:?}", found[0]);
    assert_eq!(broken(&found[1]).len(), 2);
    let chart = |assumed: &str| {
        verdicts(&format!(
            "sfc C {{ input x: u8; assume pure near; {assumed} initial step A; step B; A -[near(x)]-> B -[true]-> A; never B.X && x > 3; }}"
        ))
    };
    assert_eq!(broken(&chart("")[0]).len(), 2);
    assert!(is_proved(&chart("assume never near(x) && x > 3;")[0]));
}

#[test]
fn limits_of_types_are_known() {
    let found = verdicts(
        "sfc C { input x: u16; input go: bool; var n: u16 = 0; initial step A; step B { P1 n = u16::MAX - x; }
         A -[go && x < u16::MAX && x > u16::MIN + 7]-> B -[!go]-> A; never n == u16::MAX; never n > 65526; never B.X && x == 0 && go && u8::BITS == 7; }",
    );
    assert!(found.iter().take(1).all(is_proved), "{:?}", found[0]);
    assert_eq!(broken(&found[1]).len(), 2);
    assert!(is_proved(&found[2]));
}

/// Of all numbers of eight bits.
#[test]
fn euclidean_division_and_powers_are_exact() {
    let found = verdicts(
        "sfc C { input x, y: i8; assume never y == 0 || x == -128 && y == -1; var q, r: i8 = 0; var p: i32 = 0; initial step A;
         step B { P1 q = x.div_euclid(y); P1 r = x.rem_euclid(y); P1 p = i32::from(x).pow(3); }
         A -[true]-> B -[true]-> A;
         always B.X => i32::from(q) * i32::from(y) + i32::from(r) == i32::from(x);
         always B.X => r >= 0 && i32::from(r) < i32::from(y).abs();
         always B.X => p == i32::from(x) * i32::from(x) * i32::from(x);
         never B.X && q == -3 && x == -7 && y == 3; never B.X && x.count_ones() > 8; }",
    );
    assert!(found[..3].iter().all(is_proved), "{found:?}");
    assert_eq!(broken(&found[3]).len(), 2);
    // That is a method of Rust's own, and no answer of the program's.
    assert!(undecided(&found[4]).contains("count_ones"), "{:?}", found[4]);
}

/// Of two values the condition takes one, and evaluates no other.
#[test]
fn one_of_two_values_is_computed() {
    let found = verdicts(
        "sfc C { input x: u8; input go: bool; var n: u8 = 0; var m: Mode in {Idle, Busy, Done} = Mode::Idle; initial step A;
         step B { P1 n = if x > 250 { 250 } else if x > 9 { x } else { x + 1 }; P1 m = if go { Mode::Busy } else { Mode::Done }; }
         A -[if go { x > 3 } else { x > 7 }]-> B -[x == 0]-> A;
         never n > 250; never B.X && n == 9; never n == 5; never B.X && m == Mode::Idle; never m == Mode::Done && n < 9 && n > 0; never m == Mode::Busy; }",
    );
    assert!(is_proved(&found[0]) && is_proved(&found[3]), "{found:?}");
    assert_eq!([1, 2, 5].map(|one| broken(&found[one]).len()), [2, 2, 2]);
    assert!(is_proved(&found[4]), "{:?}", found[4]);
    assert!(broken(&found[1]).iter().all(|shown| shown.told.is_empty()));
}

/// A place in one list is another variant in the other.
#[test]
fn an_enum_that_is_listed_in_two_orders_has_no_circuit() {
    let chart = |list: &str| {
        format!(
            "sfc C {{ input e: Mode in {{Off, Auto}}; assume never e == Mode::Off; var m: Mode in {{{list}}} = Mode::Off; initial step A; step B {{ P1 m = e; }}
             A -[true]-> B -[true]-> A; never B.X && m != Mode::Auto; }}"
        )
    };
    assert!(is_proved(&verdicts(&chart("Off, Auto"))[0]));
    let model = read(&chart("Auto, Off"));
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let refused = Circuit::of(&program).expect_err("a place would be two variants");
    assert_eq!(refused.0, "the variants of `Mode`, which are listed in two orders");
}

/// What the interpreter computes and the circuit does not is no reason to disagree.
#[test]
fn what_only_the_interpreter_computes_is_left_open() {
    let found = verdicts(
        "sfc C { input x: i32; input y: u32; initial step A; step B; A -[x.pow(y) == 9]-> B -[x == 0]-> A; never B.X && y == 0; }",
    );
    assert!(undecided(&found[0]).contains("pow"), "{:?}", found[0]);
}

/// By induction over one cycle and over two, and the checker refuses less.
#[test]
fn a_property_may_follow_from_itself() {
    let model = read(
        "sfc C { input part, full: bool; var n: u16 = 0; initial step A; step B { P1 n = n + 1; } step D { P1 n = 0; }
         A -[part && n < MOST]-> B -[!part]-> A; A -[n >= MOST]-> D -[full]-> A; never n > MOST; }",
    );
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let Ok(Verdict::Proved(proof)) = decide(&program, &circuit, circuit.bad[0], &Limit::none()) else {
        panic!("it is proved")
    };
    assert_eq!((proof.invariant.excluded.len(), proof.invariant.depth), (0, 1));
    assert!(words::lines(&program, &circuit, &proof.invariant)[0].contains("follows from itself"));

    let counter = read(
        "sfc C { input go: bool; var n: u8 = 0; initial step A; step B { P1 n = (n + 1) % 5; } A -[go]-> B -[!go]-> A; never n == 7; never n == 3; }",
    );
    let program = counted(&counter, &Facts::of(&counter)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let fault = |property: usize, depth: usize| {
        let task = Task::new(&circuit, circuit.bad[property].possible);
        certificate::fault(&task, &Invariant { excluded: Vec::new(), depth }, &Limit::none()).expect("no limit")
    };
    // From any state of the latches on, `n` may be 7; after a cycle without, it is not.
    assert!(fault(0, 0).is_some_and(|what| what.contains("bad can happen in it")));
    assert_eq!(fault(0, 1), None);
    assert!(fault(1, 1).is_some_and(|what| what.contains("follow from itself")));
    assert!(fault(1, 9).is_some_and(|what| what.contains("in cycle")));
}
