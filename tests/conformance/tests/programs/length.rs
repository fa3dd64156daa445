//! How long the passes take for long charts.

use std::fmt::Write as _;
use std::fs;
use std::sync::LazyLock;
use std::time::Instant;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::program::passes::{Pass, optimise};
use grafcet_compiler::program::{Statement, naive};
use grafcet_conformance::program::program as optimised;

use super::read;

/// What this thread has had of a processor: what else the machine does counts for the clock on the wall, and not here. Where the system does not tell, that
/// clock.
fn processor_seconds() -> f64 {
    static BEGIN: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| BEGIN.elapsed().as_secs_f64(), |nanoseconds| nanoseconds / 1e9)
}

/// Each state is looked at with what concerns it, and not with all statements: four times the steps take about four times as long,
/// and not sixteen times.
#[test]
fn a_long_chart_takes_time_by_its_length() {
    let seconds = |steps: usize| {
        let mut text = "sfc Long { input a: bool; output p, q, r: bool; ".to_owned();
        for step in 0..steps {
            let initial = if step == 0 { "initial " } else { "" };
            let action = ["N p", "S q", "R q", "L 5ms r"][step % 4];
            let condition = if step % 2 == 0 { "a".to_owned() } else { format!("5ms/S{step}") };
            _ = write!(
                text,
                "{initial}step S{step} {{ {action}; }} S{step} -[{condition}]-> S{}; ",
                (step + 1) % steps
            );
        }
        let model = read(&format!("{text}}}"));
        let facts = Facts::of(&model);
        let mut best = f64::INFINITY;
        for _ in 0..5 {
            let mut program = naive(&model, &facts).expect("a program");
            let start = processor_seconds();
            optimise(&mut program, &Pass::ALL);
            best = best.min(processor_seconds() - start);
            let is_match = |statement: &&Statement<'_>| matches!(statement, Statement::Match(..));
            assert_eq!(program.cycle.iter().filter(is_match).count(), 2, "it is no match");
        }
        best
    };
    let (quarter, whole) = (seconds(250), seconds(1000));
    println!("250 steps: {quarter:.3} s, 1,000 steps: {whole:.3} s");
    assert!(whole < 12.0 * quarter, "250 steps take {quarter:.3} s, 1,000 steps {whole:.3} s");
}

/// Each condition of a selection that is taken apart has all after it looked at once more, and so has each of those: of thirty branches no build would see the end.
#[test]
fn long_selections_are_not_taken_apart_again_and_again() {
    let selection = |priority: bool| {
        let (mut inputs, mut branches) = (String::new(), String::new());
        for branch in 0..30 {
            let mut before = String::new();
            for other in (0..branch).filter(|_| priority) {
                _ = write!(before, " && !key{other}");
            }
            _ = write!(inputs, "key{branch}, ready{branch}, ");
            _ = write!(branches, "step B{branch}; A -[key{branch} && ready{branch}{before}]-> B{branch} -[done]-> A; ");
        }
        format!("sfc Keys {{ input {inputs} done: bool; initial step A; {branches} }}")
    };
    for chart in [selection(false), selection(true)] {
        let model = read(&chart);
        let start = Instant::now();
        let program = optimised(&model, &Pass::ALL).expect("a program");
        assert!(!program.cycle.is_empty());
        assert!(start.elapsed().as_secs() < 30, "it took {:?}", start.elapsed());
    }
}
