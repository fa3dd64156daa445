//! The random charts themselves: of every kind enough are accepted, and the interpreter understands them.

use std::collections::BTreeMap;

use grafcet_conformance::oracle::Interpreted;
use grafcet_conformance::reader::Kind;
use grafcet_conformance::{Subject, chart, random, reader};

/// A kind of which the compiler refuses most charts compares nothing.
#[test]
fn every_kind_of_chart_is_accepted_and_understood() {
    let mut kinds = BTreeMap::<&str, [usize; 2]>::new();
    let mut refusals = BTreeMap::new();
    for (seed, grafcet) in (0..208).flat_map(|seed| [(seed, false), (seed, true)]) {
        let made = random::chart(seed, grafcet, 60);
        let model = chart::resolve(&made.chart);
        for feature in &made.features {
            kinds.entry(feature).or_default()[usize::from(model.is_ok())] += 1;
        }
        let model = match model {
            Ok(model) => model,
            Err(error) => {
                let why = error.lines().next().unwrap_or_default();
                made.features.iter().for_each(|feature| _ = refusals.entry(*feature).or_insert_with(|| why.to_owned()));
                continue;
            }
        };
        let mut machine = Interpreted::new(&model).expect("understood");
        for line in reader::read(&format!("{}---\n{}", made.chart, made.timeline)).expect("a timeline").lines {
            let played = match &line.kind {
                Kind::Cycle { inputs, now, .. } => machine.cycle(inputs, *now).map(drop),
                Kind::Params(changed) => machine.set_params(changed),
                _ => Ok(()),
            };
            assert_eq!(played, Ok(()), "seed {seed}, line {}: {}\n{}", line.number, line.text(), made.chart);
        }
    }
    for grafcet in [false, true] {
        let never: Vec<&str> = random::kinds(grafcet).filter(|kind| !kinds.contains_key(kind)).collect();
        assert!(never.is_empty(), "never drawn: {never:?}");
    }
    // Small charts are drawn so that they are right.
    let small =
        kinds.iter().filter(|(kind, [refused, accepted])| kind.starts_with("small") && accepted < &(3 * refused));
    let small: Vec<_> = small.map(|(kind, counts)| (kind, counts, refusals.get(kind))).collect();
    assert!(small.is_empty(), "refused and accepted, and why: {small:#?}");
    let rare = kinds.iter().filter(|(_, [refused, accepted])| *refused > 3 * accepted);
    let rare: Vec<_> = rare.map(|(kind, counts)| (kind, counts, refusals.get(kind))).collect();
    assert!(rare.is_empty(), "refused and accepted, and why: {rare:#?}");
}
