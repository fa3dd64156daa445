//! Circuits beside the programs they are made of: the corpus and random charts.

use std::fs;

use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::{model, parse};
use grafcet_conformance::circuit::{Outcome, compare};
use grafcet_conformance::{chart, fragments, random, reader};

#[test]
fn every_circuit_of_the_corpus_does_what_its_program_does() {
    let (mut same, mut refused) = (0, Vec::new());
    for entry in fs::read_dir(env!("CARGO_MANIFEST_DIR")).expect("the corpus is there") {
        let path = entry.expect("a folder entry").path();
        if path.extension().is_none_or(|extension| extension != "chart") {
            continue;
        }
        let case = reader::read(&fs::read_to_string(&path).expect("a file")).expect("a chart and a timeline");
        let mut sink = Sink::new();
        let tokens = fragments::plain(&case.chart).parse().expect("tokens");
        let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink)).expect("a chart");
        _ = sink.finish();
        match compare(&model, &case.lines) {
            Ok(Outcome::Same(_)) => same += 1,
            Ok(Outcome::Refused) => refused.push(path.clone()),
            Err(error) => panic!("{}: {error}", path.display()),
        }
    }
    assert!(same > 200 && refused.len() * 20 < same, "{same} the same, refused {refused:?}");
}

#[test]
fn random_circuits_do_what_their_programs_do() {
    let (mut cycles, mut refused, mut charts) = (0, 0, 0);
    for number in 410_000..410_040 {
        let grafcet = number % 2 == 0;
        let made = random::chart(number, grafcet, 60);
        let Ok(model) = chart::resolve(&made.chart) else { continue };
        let lines = reader::read(&format!("{}---\n{}", made.chart, made.timeline)).expect("a timeline").lines;
        charts += 1;
        match compare(&model, &lines) {
            Ok(Outcome::Same(count)) => cycles += count,
            Ok(Outcome::Refused) => refused += 1,
            Err(error) => panic!("{number}: {error}\n{}", made.chart),
        }
    }
    assert!(
        charts > 20 && refused * 10 < charts && cycles > 800,
        "{charts} charts, {refused} refused, {cycles} cycles"
    );
}
