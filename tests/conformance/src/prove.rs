//! What the prover says about small random charts, beside a naive exploration of them, and beside `abc`.

use std::process::Command;
use std::time::Duration;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::model::Model;
use grafcet_compiler::program::{Program, counted};
use grafcet_prove::circuit::{Bad, Circuit, Live};
use grafcet_prove::{Limit, Verdict, by_evolutions, decide, decide_home, decide_live, export, vacuous};

use crate::brute::claims::broken;
use crate::brute::graph::Graph;
use crate::brute::responses;
use crate::brute::{make, memories, resolve};

/// So many steps of the solver for a proof from evolution to evolution.
const WORK: u64 = 20_000;

/// What is compared.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// The dialect.
    pub grafcet: bool,
    /// With times, of which brute force sees some behaviour only.
    pub timed: bool,
    /// With properties over several cycles.
    pub several: bool,
    /// `abc` is asked, too.
    pub abc: bool,
}

/// How far is looked.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// The most cycles of brute force.
    pub cycles: usize,
    /// For each property.
    pub time: Duration,
}

/// How many properties came out how.
#[derive(Clone, Default, Debug)]
pub struct Counts {
    /// Charts with properties.
    pub charts: usize,
    /// Of these, charts with a param in a range.
    pub params: usize,
    /// Of properties.
    pub proved: usize,
    /// Of properties.
    pub broken: usize,
    /// Of `home`: where there is always a way back, and where there is not.
    pub homes: (usize, usize),
    /// Of those that are proved: also from evolution to evolution.
    pub by_evolutions: usize,
    /// Properties that say nothing.
    pub vacuous: usize,
    /// The charts of these properties, and why.
    pub undecided: Vec<(u64, String)>,
    /// Charts without a circuit.
    pub refused: usize,
    /// Of brute force, of charts with plants.
    pub states: usize,
    /// Answers of `abc` that were compared.
    pub asked: usize,
}

impl Counts {
    /// All properties of which something was said.
    #[must_use]
    pub fn properties(&self) -> usize {
        self.proved + self.broken + self.homes.0 + self.homes.1 + self.undecided.len()
    }

    /// What others found, too.
    pub fn add(&mut self, other: Self) {
        self.charts += other.charts;
        self.params += other.params;
        self.proved += other.proved;
        self.broken += other.broken;
        self.homes.0 += other.homes.0;
        self.homes.1 += other.homes.1;
        self.vacuous += other.vacuous;
        self.by_evolutions += other.by_evolutions;
        self.undecided.extend(other.undecided);
        self.refused += other.refused;
        self.states += other.states;
        self.asked += other.asked;
    }
}

/// The chart of a number.
#[must_use]
pub fn text(number: u64, kind: Kind) -> String {
    let text = make::counting(number, kind.grafcet, kind.timed);
    if !kind.several {
        return text;
    }
    make::with_modes(&make::by_recipe(&make::of_several_cycles(&text, number, kind.timed), number), number)
}

/// Compares the chart of a number; false where there is nothing to compare.
///
/// # Errors
/// A difference, with the chart.
pub fn number(number: u64, kind: Kind, bounds: Bounds, counts: &mut Counts) -> Result<bool, String> {
    let text = text(number, kind);
    let Ok(model) = resolve(&text) else { return Ok(false) };
    let judged = resolve(&make::with_param(&text))?;
    if model.properties.is_empty() {
        return Ok(false);
    }
    let Some(graph) = Graph::of(&model, bounds.cycles).map_err(|error| format!("{error}\n{text}"))? else {
        return Ok(false);
    };
    counts.params += usize::from(!judged.params.is_empty());
    compare((&model, &judged), &graph, (kind, bounds.time), number, counts)
        .map_err(|error| format!("{number}: {error}\n{text}"))?;
    Ok(true)
}

/// Compares properties with edges and delays, in a chart without times; false where there is nothing to compare.
///
/// # Errors
/// A difference, with the chart.
pub fn remembering(number: u64, grafcet: bool, bounds: Bounds, counts: &mut Counts) -> Result<bool, String> {
    let (plain, text, overs) = make::remembering(number, grafcet);
    let (Ok(model), Ok(judged)) = (resolve(&plain), resolve(&text)) else { return Ok(false) };
    let Some(graph) = Graph::of(&model, bounds.cycles).map_err(|error| format!("{error}\n{plain}"))? else {
        return Ok(false);
    };
    let program = counted(&judged, &Facts::of(&judged)).map_err(|refused| refused.to_string())?;
    counts.charts += 1;
    let Ok(circuit) = Circuit::of(&program) else {
        counts.refused += 1;
        return Ok(true);
    };
    for (property, over) in overs.into_iter().enumerate() {
        let Some(bad) = circuit.bad.iter().find(|bad| bad.property == property) else {
            counts.undecided.push((number, format!("property {property}: not modelled")));
            continue;
        };
        let shortest = memories::broken(&model, &graph, &model.properties[property].claim, over)?;
        let verdict = decide(&program, &circuit, *bad, &Limit::time(bounds.time))
            .map_err(|error| format!("{number}: {error}\n{text}"))?;
        let same = match &verdict {
            Verdict::Undecided(why) => {
                counts.undecided.push((number, format!("property {property}: {why}")));
                true
            }
            Verdict::Proved(_) => {
                counts.proved += 1;
                shortest.is_none()
            }
            Verdict::Endless { .. } => false,
            Verdict::Violated(way) => {
                counts.broken += 1;
                shortest == Some(way.len())
            }
        };
        if !same {
            return Err(format!("{number}: property {property}: {verdict:?}, by brute force {shortest:?}\n{text}"));
        }
    }
    Ok(true)
}

/// The first model is that of brute force, which has inputs for params.
fn compare(
    (model, judged): (&Model, &Model),
    graph: &Graph,
    (kind, time): (Kind, Duration),
    number: u64,
    counts: &mut Counts,
) -> Result<(), String> {
    let program = counted(judged, &Facts::of(judged)).map_err(|refused| refused.to_string())?;
    counts.charts += 1;
    let Ok(circuit) = Circuit::of(&program) else {
        counts.refused += 1;
        return Ok(());
    };
    let depths = graph.depths();
    for bad in &circuit.bad {
        let shortest = broken(model, graph, &depths, &model.properties[bad.property])?;
        let verdict = decide(&program, &circuit, *bad, &Limit::time(time)).map_err(|error| error.to_string())?;
        let wrong = match &verdict {
            Verdict::Undecided(why) => {
                counts.undecided.push((number, format!("property {}: {why}", bad.property)));
                false
            }
            Verdict::Proved(_) => {
                counts.proved += 1;
                shortest.is_some()
            }
            Verdict::Endless { .. } => true,
            Verdict::Violated(way) => {
                counts.broken += 1;
                // With times brute force sees some behaviour only.
                let longer = shortest.is_some_and(|shortest| way.len() > shortest);
                longer || !kind.timed && shortest != Some(way.len())
            }
        };
        if wrong {
            return Err(format!("property {}: {verdict:?}, by brute force {shortest:?}", bad.property));
        }
        let by_evolutions =
            by_evolutions(&program, bad.property, &Limit::work(WORK)).map_err(|error| error.to_string())?;
        if by_evolutions.is_some() {
            counts.by_evolutions += 1;
            if let Some(shortest) = shortest {
                return Err(format!("property {}: proved by evolutions, broken in cycle {shortest}", bad.property));
            }
        }
        if kind.abc {
            counts.asked += 1;
            if let Some(difference) = differs(&program, &circuit, *bad, &verdict)? {
                return Err(format!("property {}: {difference}", bad.property));
            }
        }
    }
    for (property, _) in &circuit.triggers {
        let proof = vacuous(&circuit, *property, &Limit::time(time));
        let never = proof.map_err(|error| error.to_string())?.is_some();
        counts.vacuous += usize::from(never);
        let Some(trigger) = model.properties[*property].claim.trigger() else { continue };
        let happens = graph.can_hold(model, &trigger.tree)?;
        if never && happens {
            return Err(format!("property {property} says something by brute force"));
        }
        // Nothing is said where it is not found in time.
        if !never && !happens && !kind.timed {
            counts.undecided.push((number, format!("property {property}: whether it says something")));
        }
    }
    for home in &circuit.homes {
        let shortest = broken(model, graph, &depths, &model.properties[home.property])?;
        let verdict = decide_home(&program, &circuit, home, &Limit::time(time)).map_err(|error| error.to_string())?;
        let wrong = match &verdict {
            Verdict::Undecided(why) => {
                counts.undecided.push((number, format!("property {}: {why}", home.property)));
                false
            }
            Verdict::Proved(_) => {
                counts.homes.0 += 1;
                // With times brute force sees some ways only, so that it may miss one home.
                shortest.is_some() && !kind.timed
            }
            Verdict::Endless { .. } => true,
            Verdict::Violated(way) => {
                counts.homes.1 += 1;
                shortest.is_some_and(|shortest| way.len() < shortest) && !kind.timed || shortest.is_none()
            }
        };
        if wrong {
            return Err(format!("property {}: {verdict:?}, by brute force {shortest:?}", home.property));
        }
    }
    for live in &circuit.live {
        eventually(model, graph, (&program, &circuit), *live, (kind, time, number), counts)?;
    }
    Ok(())
}

/// Whether something always comes.
fn eventually(
    model: &Model,
    graph: &Graph,
    (program, circuit): (&Program<'_>, &Circuit),
    live: Live,
    (kind, time, number): (Kind, Duration, u64),
    counts: &mut Counts,
) -> Result<(), String> {
    let verdict = decide_live(program, circuit, live, &Limit::time(time)).map_err(|error| error.to_string())?;
    let endless = responses::broken(model, graph, &model.properties[live.property].claim)?.is_some();
    let wrong = match &verdict {
        Verdict::Undecided(why) => {
            counts.undecided.push((number, format!("property {}: {why}", live.property)));
            false
        }
        Verdict::Proved(_) => {
            counts.proved += 1;
            endless
        }
        Verdict::Endless { .. } => {
            counts.broken += 1;
            // With times brute force sees some behaviour only.
            !endless && !kind.timed
        }
        Verdict::Violated(_) => true,
    };
    if wrong { Err(format!("property {}: {verdict:?}, by brute force {endless}", live.property)) } else { Ok(()) }
}

/// What `abc` says otherwise, by `pdr` and, of what is broken, by `bmc3`. What it does not decide within a minute is printed and counts as no
/// difference.
///
/// # Errors
/// `abc` cannot be run.
pub fn differs(
    program: &Program<'_>,
    circuit: &Circuit,
    bad: Bad,
    verdict: &Verdict,
) -> Result<Option<String>, String> {
    let mut alone = circuit.clone();
    alone.bad = vec![Bad { possible: bad.certain, ..bad }];
    let file = std::env::temp_dir().join(format!("grafcet-prove-{}.aig", std::process::id()));
    std::fs::write(&file, export::aiger(program, &alone)).map_err(|error| error.to_string())?;
    let ask = |method: &str| abc(&format!("&read {}; &put; fold; {method}", file.display()));
    let said = ask("pdr -T 60")?;
    let gives_up = said.contains("UNDECIDED");
    if gives_up {
        println!("property {}: abc does not decide it within a minute", bad.property);
    }
    let difference = match verdict {
        Verdict::Undecided(_) | Verdict::Endless { .. } => None,
        Verdict::Proved(_) if gives_up || said.contains("Property proved") || said.contains("UNSATISFIABLE") => None,
        Verdict::Proved(_) => Some(format!("proved, abc: {said}")),
        Verdict::Violated(way) => {
            let frames = ask(&format!("bmc3 -F {}", way.len() + 1))?;
            let last = format!("in frame {}", way.len() - 1);
            let same = (gives_up || said.contains("was asserted"))
                && frames.contains("was asserted")
                && frames.contains(&last);
            (!same).then(|| format!("broken in cycle {}, abc: {said} {frames}", way.len()))
        }
    };
    Ok(difference)
}

fn abc(commands: &str) -> Result<String, String> {
    let output = Command::new("berkeley-abc").args(["-c", commands]).output();
    let output = output.map_err(|error| format!("berkeley-abc (apt-get install berkeley-abc): {error}"))?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
