//! What `cargo grafcet import` has made of the files in `tests/imported`: rustc takes it, and it does what the files say.
//! `grafcet-exchange/tests/imported.rs` sees to it that it is what is made of them.

#![allow(
    dead_code,
    deprecated,
    unreachable_pub,
    reason = "an imported chart is for whoever takes the file, warnings and all"
)]
#![allow(clippy::pedantic, reason = "nobody has gone over it")]
#![allow(
    clippy::assign_op_pattern,
    clippy::enum_variant_names,
    clippy::manual_clamp,
    clippy::nonminimal_bool,
    clippy::needless_bool,
    reason = "as it stands in the files"
)]

#[rustfmt::skip]
#[path = "imported/blocks.rs"]
mod blocks;
#[rustfmt::skip]
#[path = "imported/crane.rs"]
mod crane;
#[rustfmt::skip]
#[path = "imported/tank.rs"]
mod tank;
#[rustfmt::skip]
#[path = "imported/words.rs"]
mod words;

use blocks::{Blocks, BlocksInputs, BlocksStep};
use crane::{Crane, CraneInputs, CraneStep, EMode as CraneMode};
use words::{Colour, EMode, Words, WordsInputs, WordsStep};

/// Enums, `CASE`, loops and functions, with numbers worked out by hand.
#[test]
fn words_of_structured_text() {
    let mut chart = Words::new();
    let inputs = WordsInputs { mode: EMode::EAuto, go: true, n: 1, fast: 3, w: 0x8001 };
    let none = WordsInputs { mode: EMode::EOff, go: false, n: 0, fast: 0, w: 0 };
    assert_eq!((chart.cycle(&none).state, EMode::EHand as i32), (EMode::EOff, 5));
    assert_eq!(chart.cycle(&none).col, Colour::Green);
    let q = chart.cycle(&inputs);
    assert!(chart.is_active(WordsStep::Cases) && q.lamp);
    assert_eq!((q.state, q.col, q.out), (EMode::EHand, Colour::Dark, 3));
    // 1 + 2 + 3 + 4, then 10 and 6 of 10, 8, 6, 4, then doubled three times; 3 and one more, one less than three, ten more up to 31.
    let q = chart.cycle(&inputs);
    assert!(chart.is_active(WordsStep::Loops) && !q.lamp && q.q);
    assert_eq!((q.sum, q.out), (210 * 8, 31));
    // n is neither above three nor one where `go` asks for it.
    chart.cycle(&WordsInputs { n: 2, ..inputs });
    assert!(chart.is_active(WordsStep::Loops));
    let four = WordsInputs { n: 4, go: false, ..inputs };
    let q = chart.cycle(&four);
    assert!(chart.is_active(WordsStep::Functions) && q.q);
    assert_eq!((q.out, q.sum), (4 + 4 + 7, 4_000));
    assert_eq!(q.bits, 0x0010 | (0x0008 ^ (0x0003 & 0x7FFE)));
    chart.cycle(&WordsInputs { w: 0x0008, ..four });
    assert!(chart.is_active(WordsStep::Functions));
    chart.cycle(&four);
    assert!(chart.is_active(WordsStep::Init));
}

/// The other arms of `CASE`.
#[test]
fn arms() {
    for (n, out) in [(1, 3), (2, 5), (4, 5), (7, 5), (8, 9), (3, 9), (-1, 0)] {
        let mut chart = Words::new();
        let inputs = WordsInputs { mode: EMode::EAuto, go: true, n, fast: 0, w: 0 };
        chart.cycle(&inputs);
        assert_eq!(chart.cycle(&inputs).out, out, "{n}");
    }
}

/// Counters count edges up to their ends, latches keep, timers begin with their steps.
#[test]
fn standard_function_blocks() {
    let mut chart = Blocks::new();
    let none = BlocksInputs::default();
    let part = BlocksInputs { part: true, ..none };
    let q = chart.cycle(&none, 0);
    assert!(q.empty && !q.full && !q.q);
    let q = chart.cycle(&part, 0);
    assert!(q.q && q.tail && !q.full);
    assert_eq!((q.count, q.level), (1, 1));
    let q = chart.cycle(&part, 100);
    assert_eq!((q.count, q.level), (1, 1));
    let q = chart.cycle(&none, 200);
    assert!(q.q && q.tail);
    let q = chart.cycle(&part, 300);
    assert!(q.full && (q.count, q.level) == (2, 2));
    let q = chart.cycle(&BlocksInputs { stop: true, ..none }, 400);
    assert!(!q.q && !q.full && q.tail && (q.count, q.level) == (0, 3));
    assert!(!chart.cycle(&none, 1_400).tail);
    chart.cycle(&part, 1_500);
    chart.cycle(&BlocksInputs { go: true, ..none }, 1_600);
    assert!(chart.is_active(BlocksStep::Wait));
    assert!(!chart.cycle(&none, 4_599).done);
    chart.cycle(&none, 4_600);
    assert!(chart.is_active(BlocksStep::Rest));
    // It was set back: the time of the second step is its own.
    chart.cycle(&none, 7_599);
    assert!(chart.is_active(BlocksStep::Rest));
}

/// Actions that belong to steps of CODESYS themselves: on entry, while active, on exit.
#[test]
fn a_drawing_of_codesys() {
    let mut chart = Crane::new();
    let none = CraneInputs::default();
    chart.cycle(&none, 0);
    let q = chart.cycle(&CraneInputs { start: true, ..none }, 0);
    assert!(chart.is_active(CraneStep::CraneLower) && q.crane_lower && !q.vacuum);
    assert!(chart.late_steps().next().is_none());
    chart.cycle(&none, 5_000);
    assert!(chart.late_steps().eq([CraneStep::CraneLower]));
    let q = chart.cycle(&CraneInputs { crane_down: true, sucked: true, ..none }, 5_000);
    assert!(chart.is_active(CraneStep::Suck) && q.crane_lower && q.vacuum);
    chart.cycle(&CraneInputs { sucked: true, ..none }, 5_499);
    assert!(chart.is_active(CraneStep::Suck));
    let q = chart.cycle(&CraneInputs { sucked: true, ..none }, 5_500);
    assert!(chart.is_active(CraneStep::CraneLift) && !q.crane_lower);
    chart.cycle(&CraneInputs { crane_up: true, ..none }, 6_000);
    // The mode was switched off when the first step was left.
    chart.cycle(&CraneInputs { start: true, ..none }, 6_000);
    assert!(chart.is_active(CraneStep::Init));
    _ = CraneMode::Off;
}

/// Whoever imports the file has a function to write; up to there the chart runs.
#[test]
fn a_stub() {
    let mut chart = tank::Tank::new();
    let q = chart.cycle(&tank::TankInputs::default(), 0);
    assert!(!q.inlet && chart.is_active(tank::TankStep::WaitStart));
}
