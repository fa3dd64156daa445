//! What is said about the properties that stand in a chart, beside what happens in it: no wrong proof, no wrong counterexample,
//! and none that is longer than it must be.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Claim, Model, Property, StepId};

use super::compare::{Comparison, Difference};
use super::graph::Graph;
use super::responses::{self, Broken};

/// The rules about properties.
pub(super) const RULES: &[&str] = &["property_violated", "property_undecided", "not_home", "vacuous_property"];

/// What is said about a property.
enum Said {
    Proved,
    Undecided(String),
    /// After so many cycles.
    Broken(usize),
}

impl Said {
    fn number(&self) -> usize {
        match self {
            Self::Proved => 0,
            Self::Broken(_) => 1,
            Self::Undecided(_) => 2,
        }
    }
}

/// Adds what is said wrongly.
pub(super) fn check(model: &Model, graph: &Graph, text: &str, comparison: &mut Comparison) -> Result<(), String> {
    let depths = graph.depths();
    // A search without end costs more than a chart as people draw it.
    let large = graph.states.len() > 50 || graph.cycles().any(|(_, edge)| !edge.stable);
    for (index, property) in model.properties.iter().enumerate() {
        let (line, alone) = alone(text, index);
        let naive = broken(model, graph, &depths, property)?;
        let home = matches!(property.claim, Claim::Home(..));
        // With times brute force sees some behaviour only: what it sees does happen, but there may be other ways home.
        let timed = model.uses_time();
        let other_ways = home && timed && !Graph::is_whole(model);
        let (said, says_nothing) = said(&alone);
        comparison.claims[said.number()] += 1;
        if let Some(kind) = vacuity(model, graph, property, (says_nothing, comparison.exact && !timed))? {
            let text = format!("{line} is said to say nothing: {says_nothing}");
            comparison.differences.push(Difference { kind: format!("property: {kind}"), text });
        }
        let kind = match (&said, naive) {
            (Said::Proved, Some(_)) if !other_ways => "wrong proof",
            (Said::Broken(_), None) if !timed => "wrong counterexample",
            (Said::Broken(length), Some(shortest)) if *length > shortest && !(home && timed) => "not the shortest",
            (Said::Broken(length), Some(shortest)) if *length < shortest && !timed => "too short",
            // The budget is for charts as people draw them.
            (Said::Undecided(why), _) if comparison.exact && !(why.contains("budget") && large) => "undecided",
            _ => continue,
        };
        let what = match said {
            Said::Proved => "proved".to_owned(),
            Said::Undecided(why) => why,
            Said::Broken(length) => format!("broken in cycle {length}"),
        };
        let text = format!("{line} {what}, by brute force {naive:?}");
        comparison.differences.push(Difference { kind: format!("property: {kind}"), text });
    }
    Ok(())
}

/// What is wrong with whether a property is said to say nothing; `exact` where it has to be found, too.
fn vacuity(
    model: &Model,
    graph: &Graph,
    property: &Property,
    said: (bool, bool),
) -> Result<Option<&'static str>, String> {
    let Some(trigger) = property.claim.trigger() else { return Ok(None) };
    let happens = graph.can_hold(model, &trigger.tree)?;
    Ok(match said {
        (true, _) if happens => Some("not vacuous"),
        (false, true) if !happens => Some("vacuous"),
        _ => None,
    })
}

/// The chart with one of its properties only, and that one.
fn alone(text: &str, index: usize) -> (String, String) {
    let is_property = |line: &&str| ["never ", "always ", "home "].iter().any(|word| line.starts_with(word));
    let properties: Vec<&str> = text.lines().filter(is_property).collect();
    let (mut number, mut alone) = (0, String::new());
    for line in text.lines() {
        let keep = !is_property(&line) || number == index;
        number += usize::from(is_property(&line));
        if keep {
            alone.push_str(line);
            alone.push('\n');
        }
    }
    (properties.get(index).copied().unwrap_or_default().to_owned(), alone)
}

/// What is said, and whether that the property says nothing.
fn said(chart: &str) -> (Said, bool) {
    let (_, diagnostics) = super::look(chart);
    let rule = |name: &'static str| diagnostics.iter().find(move |one| one.rule.is_some_and(|rule| rule.name == name));
    let message = |name: &'static str| rule(name).and_then(|one| one.notes.first()).map(|(_, message)| message.clone());
    let says_nothing = rule("vacuous_property").is_some();
    if let Some(why) = message("property_undecided") {
        return (Said::Undecided(why), says_nothing);
    }
    let said = match message("property_violated").or_else(|| message("not_home")) {
        Some(message) => Said::Broken(length(&message)),
        None => Said::Proved,
    };
    (said, says_nothing)
}

/// The number of the last cycle in a table.
fn length(message: &str) -> usize {
    let last = message.lines().last().and_then(|line| line.split(" |").next());
    last.and_then(|number| number.trim().parse().ok()).unwrap_or(usize::MAX)
}

/// After how many cycles a property can be broken first.
pub(crate) fn broken(
    model: &Model,
    graph: &Graph,
    depths: &BTreeMap<usize, usize>,
    property: &Property,
) -> Result<Option<usize>, String> {
    let mut shortest: Option<usize> = None;
    let mut note = |depth: usize| shortest = Some(shortest.map_or(depth, |known| known.min(depth)));
    match &property.claim {
        Claim::Home(home, _) => {
            let misses = graph.misses(model, &home.iter().copied().collect::<std::collections::BTreeSet<StepId>>());
            let lost = misses.iter().enumerate().skip(1).filter(|(_, missed)| **missed);
            lost.for_each(|(state, _)| note(depths[&state]));
        }
        claim @ (Claim::LeadsTo { .. } | Claim::Before { .. }) => {
            if let Some(Broken::In(depth)) = responses::broken(model, graph, claim)? {
                note(depth);
            }
        }
        claim => {
            let violation = claim.violation().ok_or("a property without a meaning")?;
            for (from, edge) in graph.cycles() {
                if graph.holds(model, edge, &violation)? {
                    note(depths[&from] + 1);
                }
            }
        }
    }
    Ok(shortest)
}
