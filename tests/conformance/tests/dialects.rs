//! Where the dialects agree: the last paragraph of the page of decisions.

use std::collections::BTreeSet;

use grafcet_conformance::oracle::Interpreted;
use grafcet_conformance::reader::Kind;
use grafcet_conformance::{Subject, chart, random, reader};

/// A chart with exclusive branches and one evolution per set of inputs, with N, S, R, P1 and P0 alone, shows the same steps and
/// outputs in both dialects.
#[test]
fn the_same_chart_behaves_alike_in_both_dialects() {
    let mut visited = BTreeSet::new();
    for seed in 0..120 {
        let [sfc, grafcet] = [false, true].map(|grafcet| random::agree::chart(seed, grafcet, 150));
        let models = [&sfc.chart, &grafcet.chart].map(|text| chart::resolve(text).expect(text));
        let [mut one, mut other] = models.each_ref().map(|model| Interpreted::new(model).expect("understood"));
        for line in reader::read(&format!("{}---\n{}", sfc.chart, sfc.timeline)).expect("a timeline").lines {
            let Kind::Cycle { inputs, now, .. } = &line.kind else { panic!("only cycles") };
            let [one, other] =
                [one.cycle(inputs, *now), other.cycle(inputs, *now)].map(|shown| shown.expect("a cycle"));
            assert_eq!(one, other, "seed {seed}, line {}: {}\n{}", line.number, line.text(), sfc.chart);
            visited.extend(one.steps.iter().map(|step| (seed, step.clone())));
        }
    }
    assert!(visited.len() > 600, "the charts hardly move: {} steps seen", visited.len());
}
