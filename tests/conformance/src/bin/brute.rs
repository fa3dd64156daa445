//! `cargo xtask brute`: what the checker says about thousands of small random charts, beside a naive exploration.

use std::collections::BTreeMap;
use std::process::ExitCode;

use grafcet_conformance::brute::compare::Difference;
use grafcet_conformance::brute::run::{Kind, Outcome, number, smallest};

const USAGE: &str = "\
brute [--charts N] [--first N] [--cycles N] [--shrink N]

  --charts  charts of each kind: both dialects, without times and with them (default 2000)
  --first   the number of the first (default 0)
  --cycles  the most cycles of brute force for one chart (default 20000)
  --shrink  how many differing charts of a kind are made smaller (default 3)";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let mut options = BTreeMap::from([("--charts", 2000), ("--first", 0), ("--cycles", 20_000), ("--shrink", 3)]);
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let option = options.get_mut(&*word).ok_or(USAGE)?;
        let value = words.next().ok_or(USAGE)?;
        *option = value.parse::<u64>().map_err(|error| format!("{word} {value}: {error}"))?;
    }
    let mut differing = 0;
    for timed in [false, true] {
        for grafcet in [false, true] {
            let cycles = usize::try_from(options["--cycles"]).unwrap_or(usize::MAX);
            differing += charts(Kind { grafcet, timed, cycles }, &options)?;
        }
    }
    if differing == 0 { Ok(()) } else { Err(format!("{differing} charts differ")) }
}

fn charts(kind: Kind, options: &BTreeMap<&str, u64>) -> Result<usize, String> {
    let name =
        format!("{}{}", if kind.grafcet { "grafcet" } else { "sfc" }, if kind.timed { " with times" } else { "" });
    let (mut compared, mut exact, mut large, mut differing) = (0, 0, 0, 0);
    let (mut claims, mut nested) = ([0; 3], [0; 2]);
    let (mut refused, mut kinds) = (BTreeMap::<String, usize>::new(), BTreeMap::<String, usize>::new());
    for index in options["--first"]..options["--first"] + options["--charts"] {
        let (text, outcome) = number(index, kind)?;
        match outcome {
            Outcome::Refused(rule) => *refused.entry(rule).or_default() += 1,
            Outcome::Large => large += 1,
            Outcome::Compared(comparison) => {
                compared += 1;
                exact += usize::from(comparison.exact);
                claims.iter_mut().zip(comparison.claims).for_each(|(all, own)| *all += own);
                nested.iter_mut().zip(comparison.nested).for_each(|(all, own)| *all += own);
                if let Some(first) = comparison.differences.first() {
                    differing += 1;
                    let count = kinds.entry(first.kind.clone()).or_default();
                    *count += 1;
                    if *count <= usize::try_from(options["--shrink"]).unwrap_or(usize::MAX) {
                        report(&name, index, &text, first, kind.cycles);
                    }
                }
            }
        }
    }
    println!("{name}: {compared} compared, {exact} of them exactly, {differing} differ, {large} too large");
    let [proved, broken, undecided] = claims;
    println!("  properties: {proved} proved, {broken} broken, {undecided} undecided");
    let [home, told] = nested;
    println!("  by the structure: {home} ways back proved, all told of {told} charts");
    for (kind, count) in kinds {
        println!("  {count:6}  {kind}");
    }
    for (rule, count) in refused {
        println!("  {count:6}  refused by {rule}");
    }
    Ok(differing)
}

fn report(name: &str, index: u64, text: &str, difference: &Difference, cycles: usize) {
    let (text, difference) = smallest(text, difference, cycles);
    let shown = text.lines().filter(|line| !line.starts_with("#!")).collect::<Vec<_>>().join("\n");
    println!("\n{name} {index}: {}: {}\n{shown}\n", difference.kind, difference.text);
}
