//! Charts as Petri nets: what clears in one evolution fires in the net, one after the other, and then each place has a token whose step is active.

use std::collections::BTreeMap;
use std::path::Path;

use grafcet_compiler::model::{Id, Model};
use grafcet_exchange::pnml::pnml;
use grafcet_sim::Chart;
use grafcet_sim::interp::{Evolution, Interpreter};
use roxmltree::{Document, Node};

use crate::drawn::{names, rust_files, timeline};
use crate::reader::{Kind, Line};
use crate::{CYCLES, chart, play, random, reader, seeds};

/// Arcs by transition, in the order of the file: places that lose a token, and places that get one.
struct Net {
    tokens: Vec<u32>,
    transitions: Vec<(Vec<usize>, Vec<usize>)>,
}

impl Net {
    fn of(text: &str) -> Self {
        let document = Document::parse(text).expect("XML");
        let named = |name: &'static str| {
            let nodes: Vec<Node<'_, '_>> =
                document.descendants().filter(|node| node.is_element() && node.tag_name().name() == name).collect();
            nodes
        };
        let ids = |name| {
            let all = named(name);
            all.iter().map(|node| node.attribute("id").expect("an id").to_owned()).zip(0..).collect::<BTreeMap<_, _>>()
        };
        let is_marking = |node: &Node<'_, '_>| node.is_element() && node.tag_name().name() == "initialMarking";
        let tokens =
            named("place").into_iter().map(|place| u32::from(place.descendants().any(|node| is_marking(&node))));
        let (places, numbers) = (ids("place"), ids("transition"));
        let mut transitions = vec![(Vec::new(), Vec::new()); numbers.len()];
        for arc in named("arc") {
            let end = |name| arc.attribute(name).expect("an end");
            match (places.get(end("source")), numbers.get(end("target"))) {
                (Some(place), Some(transition)) => transitions[*transition].0.push(*place),
                _ => transitions[numbers[end("source")]].1.push(places[end("target")]),
            }
        }
        Self { tokens: tokens.collect(), transitions }
    }

    /// What clears at once fires one after the other.
    fn fire(&mut self, evolution: &Evolution) -> Result<(), String> {
        let mut left: Vec<usize> = evolution.cleared.iter().map(|id| id.index()).collect();
        while !left.is_empty() {
            let enabled = |number: &usize| self.transitions[*number].0.iter().all(|place| self.tokens[*place] > 0);
            let Some(at) = left.iter().position(enabled) else {
                return Err(format!("transitions {left:?} clear, and do not fire"));
            };
            let (from, to) = &self.transitions[left.remove(at)];
            for place in from {
                self.tokens[*place] -= 1;
            }
            for place in to {
                self.tokens[*place] += 1;
            }
        }
        let active = |place| u32::from(evolution.after.iter().any(|step| step.index() == place));
        let expected: Vec<u32> = (0..self.tokens.len()).map(active).collect();
        if self.tokens == expected { Ok(()) } else { Err(format!("tokens {:?}, steps {expected:?}", self.tokens)) }
    }
}

/// How many transitions cleared; none where there is no net, or nothing to be compared.
fn compare(model: &Model, lines: &[Line]) -> Result<Option<usize>, String> {
    let Ok(text) = pnml(model) else { return Ok(None) };
    let Ok(mut oracle) = Interpreter::new(model) else { return Ok(None) };
    let (mut net, mut cleared) = (Net::of(&text), 0);
    for line in lines {
        match &line.kind {
            Kind::Init => {
                _ = oracle.init();
                net = Net::of(&text);
            }
            Kind::Cycle { inputs, now, .. } => {
                let Ok(cycle) = oracle.cycle(&play::values(model, inputs), *now) else { break };
                for evolution in cycle.done() {
                    net.fire(evolution)
                        .map_err(|error| format!("line {}, {}: {error}\n{text}", line.number, line.text()))?;
                    cleared += evolution.cleared.len();
                }
            }
            // By hand a chart comes where no transition leads.
            Kind::Force { .. } => break,
            Kind::Params(_) | Kind::Shows(_) | Kind::Wakes(_) | Kind::Refuses(_) => {}
        }
    }
    Ok(Some(cleared))
}

#[test]
fn nets_of_random_charts() {
    let (wanted, first) = seeds(60);
    for grafcet in [false, true] {
        let (mut nets, mut cleared, mut refused) = (0, 0, 0);
        let mut seed = first;
        while nets < wanted {
            let made = random::chart(seed, grafcet, CYCLES);
            seed += 1;
            let Ok(model) = chart::resolve(&made.chart) else { continue };
            let lines = reader::read(&format!("{}\n---\n{}", made.chart, made.timeline)).expect("a timeline").lines;
            match compare(&model, &lines) {
                Ok(Some(count)) => (nets, cleared) = (nets + 1, cleared + count),
                Ok(None) => refused += 1,
                Err(error) => panic!("seed {}: {error}\n{}", seed - 1, made.chart),
            }
        }
        println!("{}: {nets} nets, {cleared} cleared, {refused} refused", if grafcet { "grafcet" } else { "sfc" });
        assert!(cleared > 20 * nets, "{cleared}");
    }
}

/// The charts of the examples, and those that people draw.
#[test]
fn nets_of_charts_that_people_draw() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut nets, mut refused) = (0, Vec::new());
    for file in ["examples/charts", "tests/good"].iter().flat_map(|folder| rust_files(&root.join(folder))) {
        let text = std::fs::read_to_string(&file).expect("a file of the project");
        for name in names(&text) {
            let Ok(chart) = Chart::in_file(&text, &name) else { continue };
            match compare(chart.model(), &timeline(chart.model(), nets + 1)) {
                Ok(Some(_)) => nets += 1,
                Ok(None) => {
                    let why = pnml(chart.model()).err().into_iter().flatten().map(|refused| refused.message);
                    refused.push((name, why.collect::<Vec<_>>()));
                }
                Err(error) => panic!("{}, {name}: {error}", file.display()),
            }
        }
    }
    println!("{nets} nets; refused: {refused:#?}");
    assert!(nets > 55, "{nets}");
}
