//! What is computed of bits and of times: worked out by hand, in each flavour.

mod common;

#[path = "machine/mod.rs"]
mod machine;

use common::model;
use grafcet_exchange::st::{Flavour, Form, Options, Order, structured_text};
use machine::{Dialect, Machine, Value};

const FLAVOURS: [(Flavour, Dialect); 3] =
    [(Flavour::Iec, Dialect::Iec), (Flavour::Codesys, Dialect::Codesys), (Flavour::Tia, Dialect::Tia)];

fn program(chart: &str, flavour: Flavour) -> String {
    let options = Options { form: Form::FlipFlops, flavour, ..Options::default() };
    structured_text(&model(chart), &options).expect("a translation").text
}

/// What these outputs show after a scan, for each flavour.
fn shown(chart: &str, inputs: &[(&str, Value)], names: &[&str]) -> Vec<i128> {
    let mut all = FLAVOURS.map(|(flavour, dialect)| {
        let text = program(chart, flavour);
        let mut machine = Machine::of(&text, dialect).unwrap_or_else(|error| panic!("{error}\n{text}"));
        for (name, value) in inputs {
            machine.set(name, *value).expect("an input");
        }
        machine.scan().unwrap_or_else(|error| panic!("{error}\n{text}"));
        names.iter().map(|name| machine.get(name).expect("a variable").number()).collect::<Vec<_>>()
    });
    assert!(all[0] == all[1] && all[0] == all[2], "{all:?}");
    std::mem::take(&mut all[0])
}

const BITS: &str = "sfc Bits { input n, m: u16; input k: i8; output a, b, c, up, down: u16; output d, e: i8; output odd, rest, low: bool;
    var mask: u16 = 1 << 4 | 3;
    initial step Run { a = n & mask; b = (n | m) + 1; c = !n ^ 0xf; d = k & -2; e = k << 1; up = n << 3; down = n >> m;
        odd if n & 1 == 1; rest if n & m != 0; low if n & 7 < 3; P1 mask = mask | 0x100; }
    step Other; Run -[n & m == 0xffff]-> Other -[n == 0]-> Run; }";

/// Numbers become strings of bits for as long as an operator needs them; what is shifted out is lost, and a sign is a bit.
#[test]
fn bits_of_integers() {
    let names = ["a", "b", "c", "d", "e", "up", "down", "odd", "rest", "low", "mask"];
    let of = |n, m, k| shown(BITS, &[("n", Value::Int(n)), ("m", Value::Int(m)), ("k", Value::Int(k))], &names);
    // `mask` is 0x13 at the beginning; actions in their order, so `a` sees what P1 has made of it: 0x113.
    assert_eq!(of(0xf1f1, 2, -3), [0x111, 0xf1f4, 0x0e01, -4, -6, 0x8f88, 0x3c7c, 1, 0, 1, 0x113]);
    assert_eq!(of(6, 2, 127), [2, 7, 0xfff6, 126, -2, 48, 1, 0, 1, 0, 0x113]);
    assert_eq!(of(0, 15, -128), [0, 16, 0xfff0, -128, 0, 0, 0, 0, 0, 1, 0x113]);
}

#[test]
fn bits_as_they_are_written() {
    let text = program(BITS, Flavour::Iec);
    for line in [
        "mask : UINT := 19;",
        "a := WORD_TO_UINT(UINT_TO_WORD(n) AND UINT_TO_WORD(mask));",
        "b := WORD_TO_UINT(UINT_TO_WORD(n) OR UINT_TO_WORD(m)) + 1;",
        "c := WORD_TO_UINT(NOT UINT_TO_WORD(n) XOR 16#F);",
        "d := BYTE_TO_SINT(SINT_TO_BYTE(k) AND 16#FE);",
        "up := WORD_TO_UINT(SHL(UINT_TO_WORD(n), 3));",
        "odd := SR_Run AND (UINT_TO_WORD(n) AND 16#1) = 16#1;",
        "low := SR_Run AND WORD_TO_UINT(UINT_TO_WORD(n) AND 16#7) < 3;",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    let tia = program(BITS, Flavour::Tia);
    assert!(tia.contains("#down := WORD_TO_UINT(SHR(IN := UINT_TO_WORD(#n), N := #m));"), "{tia}");
    let codesys = program(BITS, Flavour::Codesys);
    assert!(codesys.contains("b := TO_UINT(WORD_TO_UINT(UINT_TO_WORD(n) OR UINT_TO_WORD(m)) + 1);"), "{codesys}");
}

/// Differences end at zero, sums at the longest time; what is known is computed here.
#[test]
fn times_that_are_computed() {
    let chart = "sfc Wait { input p, q: time; output less, more, sum, known, ahead: bool; output rest: time;
        initial step Run { rest = p - q; less if p - q < 2s; more if q + 1s > p; sum if p + q >= 596h; known if p < 1h + 30m - 1s; ahead if Run.T + p > q - Run.T; }
        step Other; Run -[p + q < 1s]-> Other -[p > q]-> Run; }";
    let names = ["rest", "less", "more", "sum", "known", "ahead"];
    let of = |p, q| shown(chart, &[("p", Value::Time(p)), ("q", Value::Time(q))], &names);
    assert_eq!(of(5_000, 3_000), [2_000, 0, 0, 0, 1, 1]);
    assert_eq!(of(3_000, 5_000), [0, 1, 1, 0, 1, 0]);
    assert_eq!(of(5_399_000, 5_397_001), [1_999, 1, 0, 0, 0, 1]);
    // 300 hours and 300 hours end at 596 hours and a half.
    assert_eq!(of(1_080_000_000, 1_080_000_000), [0, 1, 1, 1, 0, 0]);
    let text = program(chart, Flavour::Iec);
    for part in [
        "rest := MAX(p, q) - q;",
        "MIN(q, T#24d20h31m22s647ms) + T#1s > p",
        "p < T#1h29m59s",
        "MIN(T_Run.ET, T#24d20h31m23s647ms - p) + p > MAX(q, T_Run.ET) - T_Run.ET",
        "// Sums of times end at the longest time",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

/// In the scan in which a step is left its time is still that which it had reached (A34), and yet it is no longer active.
#[test]
fn the_time_of_a_step_that_is_left() {
    let chart = "sfc Left { input go: bool; output since, elapsed: bool; initial step A;
        step B { since if A.T >= 2s; elapsed if 2s/A; } A -[go && 2s/A]-> B -[!go]-> A; }";
    let options = Options { form: Form::FlipFlops, ..Options::default() };
    let text = structured_text(&model(chart), &options).expect("a translation").text;
    let mut machine = Machine::new(&text).expect("understood");
    let mut scan = |now, go| {
        machine.now = now;
        machine.set("go", Value::Bool(go)).expect("an input");
        machine.scan().expect("a scan");
        ["since", "elapsed"].map(|name| machine.get(name).expect("a variable").number())
    };
    assert_eq!(
        [(0, false), (1_999, true), (2_000, true), (2_100, true), (2_200, false)].map(|(now, go)| scan(now, go)),
        [[0, 0], [0, 0], [1, 0], [0, 0], [0, 0]],
        "{text}"
    );
    // A CASE has begun that time anew.
    for order in [Order::ActFirst, Order::EvolveFirst] {
        let options = Options { order: Some(order), ..Options::default() };
        let refused = structured_text(&model(chart), &options).expect_err("a time that is gone");
        assert!(refused[0].message.starts_with("the time that another step had reached"), "{refused:?}");
    }
}

/// A transition to its own step does nothing in a CASE, but those after it wait for it.
#[test]
fn a_loop_comes_first() {
    let chart = "sfc Loop { #![allow(grafcet::overlapping_branches)] input a, b: bool; output q: bool; initial step A; step B { q; }
        A -[a]-> A; A -[b]-> B -[!b]-> A; B -[a]-> B; }";
    for order in [Order::ActFirst, Order::EvolveFirst] {
        let options = Options { order: Some(order), ..Options::default() };
        let text = structured_text(&model(chart), &options).expect("a translation").text;
        let mut machine = Machine::new(&text).expect("understood");
        let mut scan = |a, b| {
            machine.set("a", Value::Bool(a)).expect("an input");
            machine.set("b", Value::Bool(b)).expect("an input");
            machine.scan().expect("a scan");
            machine.get("StepNo").expect("a step").number()
        };
        let shown = [(false, false), (true, true), (true, true), (false, true), (true, true), (true, false)];
        assert_eq!(shown.map(|(a, b)| scan(a, b)), [10, 10, 10, 20, 20, 10], "{text}");
    }
}

/// What runs under qualifiers with a time, a pulse or a memory: once in each scan in which its action control drives it, and once more after that.
#[test]
fn what_runs_for_a_time() {
    let chart = "sfc Runs { input go: bool; output nl, nd, ns, nsl, nsd, nds, np: u8; initial step A;
        step B { L 2s nl = (nl + 1) % 100; D 1s nd = (nd + 1) % 100; S { ns = (ns + 1) % 100; } SL 2s nsl = (nsl + 1) % 100;
            SD 1s nsd = (nsd + 1) % 100; DS 1s nds = (nds + 1) % 100; P np = (np + 1) % 100; }
        A -[go]-> B -[!go]-> A; }";
    let names = ["nl", "nd", "ns", "nsl", "nsd", "nds", "np"];
    let expected = [
        (0, false, [0, 0, 0, 0, 0, 0, 0]),
        (1_000, true, [1, 0, 1, 1, 0, 0, 1]),
        // The pulse is over: its final scan.
        (1_500, true, [2, 0, 2, 2, 0, 0, 2]),
        (2_000, true, [3, 1, 3, 3, 1, 1, 2]),
        // The times of L and SL are over: a final scan of each.
        (3_000, true, [4, 2, 4, 4, 2, 2, 2]),
        // Left: the final scan of D.
        (3_500, false, [4, 3, 5, 4, 3, 3, 2]),
        (4_000, false, [4, 3, 6, 4, 4, 4, 2]),
        (5_000, true, [5, 3, 7, 4, 5, 5, 3]),
        (5_500, false, [6, 3, 8, 4, 6, 6, 4]),
    ];
    for (flavour, dialect) in FLAVOURS {
        let text = program(chart, flavour);
        let mut machine = Machine::of(&text, dialect).expect("understood");
        for (now, go, shown) in expected {
            machine.now = now;
            machine.set("go", Value::Bool(go)).expect("an input");
            machine.scan().expect("a scan");
            let found = names.map(|name| machine.get(name).expect("a variable").number());
            assert_eq!(found, shown, "at {now}\n{text}");
        }
    }
}

/// A delay begins anew with a step that is entered anew: what it drives has its final scan then.
#[test]
fn a_delay_of_a_step_that_is_entered_anew() {
    let chart = "sfc Again { input go: bool; output n: u8; initial step A; step B { D 1s n = (n + 1) % 100; } A -[go]-> B; B -[go]-> B; B -[5s/B]-> A; }";
    let mut machine = Machine::new(&program(chart, Flavour::Iec)).expect("understood");
    let mut scan = |now, go| {
        machine.now = now;
        machine.set("go", Value::Bool(go)).expect("an input");
        machine.scan().expect("a scan");
        machine.get("n").expect("a variable").number()
    };
    let times = [
        (0, false),
        (100, true),
        (1_100, false),
        (1_200, false),
        (1_300, true),
        (1_400, false),
        (2_300, false),
        (2_400, true),
    ];
    assert_eq!(times.map(|(now, go)| scan(now, go)), [0, 0, 1, 2, 3, 3, 4, 5]);
}

/// The final scan of what ends with its step comes before what the next step does on activation (A29).
#[test]
fn a_final_scan_by_leaving() {
    let chart = "sfc Last { input go: bool; output seen: u8; action beep(n: u8); var x: u8 = 0; initial step A { P1 seen = x; P1 x = 0; }
        step B { L 5s { x = x % 99 + 1; } D 1s beep(x); } A -[go]-> B -[!go]-> A; }";
    let mut machine = Machine::new(&program(chart, Flavour::Iec)).expect("understood");
    let mut scan = |now, go| {
        machine.now = now;
        machine.set("go", Value::Bool(go)).expect("an input");
        machine.scan().expect("a scan");
        let calls: Vec<i128> =
            machine.calls.iter().flat_map(|call| call.arguments.iter().map(|one| one.number())).collect();
        (machine.get("seen").expect("a variable").number(), machine.get("x").expect("a variable").number(), calls)
    };
    assert_eq!(scan(0, false), (0, 0, vec![]));
    assert_eq!(scan(100, true), (0, 1, vec![]));
    // First, repeated and, before `x` is zero again, for the last time.
    assert_eq!(scan(1_100, true), (0, 2, vec![0, 2]));
    assert_eq!(scan(1_200, true), (0, 3, vec![1, 3]));
    assert_eq!(scan(1_300, false), (4, 0, vec![2, 4]));
    assert_eq!(scan(1_400, true), (4, 1, vec![]));
    assert_eq!(scan(1_500, false), (2, 0, vec![]));
}

const FUNCTIONS: &str = "sfc Functions { input n, m: u16; input k: i8; input fast: bool; output a, b, c, d: u16; output e: i8; output less, small: bool;
    initial step Run { a = n.min(m) + 1; b = n.max(5); c = n.clamp(2, 9); d = if fast && n > 3 { n - 1 } else { m }; e = k.min(-2);
        less if n.min(m) < 4; small if (if fast { n } else { m }) < 4; }
    step Other; Run -[n == 9]-> Other -[n == 0]-> Run; }";

/// What Rust has methods for, and a choice of two values.
#[test]
fn functions_of_the_standard() {
    let names = ["a", "b", "c", "d", "e", "less", "small"];
    let of = |n, m, k, fast| {
        let inputs = [("n", Value::Int(n)), ("m", Value::Int(m)), ("k", Value::Int(k)), ("fast", Value::Bool(fast))];
        shown(FUNCTIONS, &inputs, &names)
    };
    assert_eq!(of(4, 7, 5, true), [5, 5, 4, 3, -2, 0, 0]);
    assert_eq!(of(40, 3, -7, false), [4, 40, 9, 3, -7, 1, 1]);
    assert_eq!(of(1, 8, -2, true), [2, 5, 2, 8, -2, 1, 1]);
    let text = program(FUNCTIONS, Flavour::Iec);
    for line in [
        "a := MIN(n, m) + 1;",
        "c := MIN(MAX(n, 2), 9);",
        "d := SEL(fast AND n > 3, m, n - 1);",
        "less := SR_Run AND MIN(n, m) < 4;",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    assert!(program(FUNCTIONS, Flavour::Tia).contains("#d := SEL(G := #fast AND #n > 3, IN0 := #m, IN1 := #n - 1);"));
}
