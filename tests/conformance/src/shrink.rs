//! The smallest form of a chart that still differs: lines, blocks and operands are left out as long as it does.
//!
//! All candidates of a round are compiled together, so that a round costs one build.

use std::collections::BTreeSet;

use grafcet_conformance::chart;
use grafcet_conformance::simpler::simpler;

use crate::project::{Case, Outcome, Project};

/// More rounds than these have never been needed.
const ROUNDS: usize = 25;

/// Candidates of a round.
const CANDIDATES: usize = 120;

/// The smallest chart found with a difference of the same kind, and that difference.
///
/// # Errors
/// A build fails for another reason than the charts.
pub(crate) fn smallest(project: &Project, case: &Case, outcome: &Outcome) -> Result<(Case, Outcome), String> {
    let (mut best, mut seen) = ((case.clone(), outcome.clone()), outcome.clone());
    // What was left out alone with success is left out together next.
    let mut together: Vec<String> = Vec::new();
    let mut tried = BTreeSet::new();
    for _ in 0..ROUNDS {
        let mut charts = Vec::new();
        for text in std::mem::take(&mut together).into_iter().chain(simpler(&best.0.chart)) {
            let shorter = text.len() < best.0.chart.len() && tried.insert(text.clone());
            if shorter && chart::resolve(&text).is_ok() {
                charts.push(text);
            }
            if charts.len() == CANDIDATES {
                break;
            }
        }
        if charts.is_empty() {
            break;
        }
        let candidate = |(index, chart): (usize, &String)| Case {
            name: format!("candidate{index}"),
            chart: chart.clone(),
            timeline: case.timeline.clone(),
            by: case.by,
            recorded: case.recorded,
        };
        let candidates: Vec<Case> = charts.iter().enumerate().map(candidate).collect();
        let outcomes = project.play(&candidates)?;
        let same = |case: &Case| outcomes.iter().find(|o| o.name == case.name && o.kind == seen.kind).cloned();
        let mut good: Vec<(Case, Outcome)> =
            candidates.into_iter().filter_map(|case| same(&case).map(|outcome| (case, outcome))).collect();
        good.sort_by_key(|(case, _)| case.chart.len());
        let texts: Vec<&str> = good.iter().map(|(case, _)| &*case.chart).collect();
        together = unions(&best.0.chart, &texts);
        if let Some(found) = good.into_iter().next() {
            seen = found.1.clone();
            best = found;
        } else if together.is_empty() && charts.len() < CANDIDATES {
            break;
        }
    }
    Ok(best)
}

/// What several simpler charts leave out, left out together: all of it, half of it, a quarter of it.
fn unions(whole: &str, simpler: &[&str]) -> Vec<String> {
    let lines: Vec<&str> = whole.lines().collect();
    let gone = |text: &&&str| {
        let left: Vec<&str> = text.lines().collect();
        let mut rest = left.iter().peekable();
        let mut gone = BTreeSet::new();
        for (index, line) in lines.iter().enumerate() {
            if rest.peek() == Some(&line) {
                rest.next();
            } else {
                gone.insert(index);
            }
        }
        // Otherwise a line was changed, not left out.
        rest.peek().is_none().then_some(gone)
    };
    let gone: Vec<BTreeSet<usize>> = simpler.iter().filter_map(|text| gone(&text)).collect();
    let mut unions = Vec::new();
    let mut size = gone.len();
    while size > 1 {
        for chunk in gone.chunks(size) {
            let without: BTreeSet<usize> = chunk.iter().flatten().copied().collect();
            let kept = lines.iter().enumerate().filter(|(index, _)| !without.contains(index));
            unions.push(kept.map(|(_, line)| format!("{line}\n")).collect());
        }
        size /= 2;
    }
    unions
}
