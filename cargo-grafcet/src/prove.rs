//! `cargo grafcet prove`

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Args as Arguments;
use grafcet_compiler::analysis::Facts;
use grafcet_compiler::model::{Claim, Model, StepId};
use grafcet_compiler::program::{Encoding, Program, counted};
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Limit, Verdict, decide, decide_home, decide_live, export, table, vacuous, words};
use serde_json::{Value, json};

use crate::args::Charts;
use crate::find::{self, Found};
use crate::model::with_plants;
use crate::{Failure, Outcome, complain, say};

/// Prove or refute what charts claim
///
/// Each property is proved for all inputs and all times, or broken by a way of cycles, which is shown.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet prove --chart Crossing
  cargo grafcet prove --chart Crossing --why     what holds in every situation, from which each proof follows
  cargo grafcet prove --chart Crossing --aiger crossing.aig

Exit code 1 says that a property is broken, undecided, or not modelled.")]
pub(crate) struct Prove {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// The longest time for each property
    #[arg(long, default_value_t = 10, value_name = "SECONDS")]
    pub(crate) seconds: u64,
    /// What holds in every situation, from which each proof follows
    #[arg(long)]
    pub(crate) why: bool,
    /// Write the circuit of the one chart as AIGER, as text where the name ends with .aag
    #[arg(long, value_name = "FILE")]
    pub(crate) aiger: Option<PathBuf>,
    /// Write the circuit of the one chart as BTOR2
    #[arg(long, value_name = "FILE")]
    pub(crate) btor2: Option<PathBuf>,
    /// One JSON object a property
    #[arg(long)]
    pub(crate) json: bool,
}

pub(crate) fn run(options: &Prove) -> Result<Outcome, Failure> {
    let charts = find::charts(&options.charts)?;
    if (options.aiger.is_some() || options.btor2.is_some()) && charts.len() != 1 {
        return Err(Failure::Said(format!(
            "{} charts, and one goes to a file: {}",
            charts.len(),
            find::one_of(&charts)
        )));
    }
    let (mut wrong, mut asked) = (false, 0);
    for chart in &charts {
        let Some(model) = with_plants(chart) else {
            wrong = true;
            continue;
        };
        asked += model.properties.len();
        wrong |= !one(chart, &model, options)?;
    }
    if asked == 0 && !options.json {
        complain(
            "note: there is no property: `always`, `never`, `home`, `leads_to` and `before` say what a chart claims",
        );
    }
    Ok(Outcome::wrong_if(wrong))
}

/// Whether everything that the chart claims is proved.
fn one(chart: &Found, model: &Model, options: &Prove) -> Result<bool, Failure> {
    let refused = |why: String| Failure::Said(format!("{} has no circuit: {why}", chart.name));
    let program = counted(model, &Facts::of(model), Encoding::Regions).map_err(|error| refused(error.to_string()))?;
    let circuit = Circuit::of(&program).map_err(|error| refused(error.to_string()))?;
    write(&program, &circuit, options)?;
    let mut proved = true;
    for (index, property) in model.properties.iter().enumerate() {
        let text = match &property.claim {
            Claim::Home(steps, _) => home(model, steps),
            _ => text(property.mark, chart),
        };
        let (limit, start) = (Limit::time(Duration::from_secs(options.seconds)), Instant::now());
        let bad = circuit.bad.iter().find(|bad| bad.property == index);
        let live = circuit.live.iter().find(|live| live.property == index);
        let home = circuit.homes.iter().find(|home| home.property == index);
        let verdict = match (bad, live, home) {
            (Some(bad), ..) => decide(&program, &circuit, *bad, &limit),
            (_, Some(live), _) => decide_live(&program, &circuit, *live, &limit),
            (.., Some(home)) => decide_home(&program, &circuit, home, &limit),
            (None, None, None) => {
                let refused = circuit.refused.iter().find(|(property, _)| *property == index);
                proved = false;
                let lines = refused.map(|(_, refused)| refused.to_string()).into_iter().collect();
                let said = Said { verdict: "not modelled", cycles: None, lines };
                show(chart, &text, &said, start, options)?;
                continue;
            }
        };
        let verdict = verdict.map_err(|error| refused(error.to_string()))?;
        proved &= matches!(verdict, Verdict::Proved(_));
        let mut said = said(&program, &circuit, &verdict, options.why);
        if matches!(verdict, Verdict::Proved(_)) {
            let limit = Limit::time(Duration::from_secs(options.seconds));
            let nothing = vacuous(&circuit, index, &limit).map_err(|error| refused(error.to_string()))?;
            if let (Some(_), Some(trigger)) = (nothing, property.claim.trigger()) {
                said.lines.insert(0, format!("but it says nothing: at the end of no cycle `{}` holds", trigger.text));
            }
        }
        show(chart, &text, &said, start, options)?;
    }
    Ok(proved)
}

fn write(program: &Program<'_>, circuit: &Circuit, options: &Prove) -> Result<(), Failure> {
    let to = |file: &Path, bytes: Vec<u8>| fs::write(file, bytes).map_err(|error| Failure::file(file, &error));
    if let Some(file) = &options.aiger {
        let as_text = file.extension().is_some_and(|extension| extension == "aag");
        let bytes =
            if as_text { export::aiger_text(program, circuit).into_bytes() } else { export::aiger(program, circuit) };
        to(file, bytes)?;
    }
    if let Some(file) = &options.btor2 {
        to(file, export::btor2(program, circuit).into_bytes())?;
    }
    Ok(())
}

/// A verdict in words.
struct Said {
    verdict: &'static str,
    /// After so many cycles it is broken.
    cycles: Option<usize>,
    lines: Vec<String>,
}

fn said(program: &Program<'_>, circuit: &Circuit, verdict: &Verdict, why: bool) -> Said {
    let lines = |text: String| text.lines().map(str::to_owned).collect();
    match verdict {
        Verdict::Proved(proof) => {
            let mut all = Vec::new();
            if why {
                all.extend(words::ways(&proof.ways));
                all.extend(words::clocks(program, &proof.clocks));
                all.extend(proof.known.iter().cloned());
                all.extend(words::lines(program, proof.beside.as_deref().unwrap_or(circuit), &proof.invariant));
            }
            Said { verdict: "proved", cycles: None, lines: all }
        }
        Verdict::Violated(way) => {
            Said { verdict: "broken", cycles: Some(way.len()), lines: lines(table(program.model, way)) }
        }
        Verdict::Endless { way, again } => {
            let mut all = vec![format!("the cycles {} to {} come again and again", again + 1, way.len())];
            all.extend(table(program.model, way).lines().map(str::to_owned));
            Said { verdict: "broken", cycles: Some(way.len()), lines: all }
        }
        Verdict::Undecided(why) => Said { verdict: "undecided", cycles: None, lines: vec![why.clone()] },
    }
}

fn show(chart: &Found, property: &str, said: &Said, start: Instant, options: &Prove) -> Result<(), Failure> {
    if options.json {
        let mut object: Value =
            json!({ "chart": chart.name, "property": property, "verdict": said.verdict, "lines": said.lines });
        object["seconds"] = start.elapsed().as_secs_f64().into();
        if let Some(cycles) = said.cycles {
            object["cycles"] = cycles.into();
        }
        return say(&format!("{object}\n"));
    }
    let cycles = said.cycles.map_or_else(String::new, |cycles| format!(" in cycle {cycles}"));
    let lines: String = said.lines.iter().fold(String::new(), |all, line| all + "    " + line.trim_end() + "\n");
    say(&format!("{}: {}{cycles}: {property}\n{lines}", chart.name, said.verdict))
}

/// The mark of one ends with the last step, in front of the parenthesis.
fn home(model: &Model, steps: &[StepId]) -> String {
    let names: Vec<String> = steps.iter().map(|step| model.steps[*step].name.to_string()).collect();
    if names.len() == 1 { format!("home {}", names.concat()) } else { format!("home ({})", names.join(", ")) }
}

/// As it stands in the source, on one line.
fn text(mark: grafcet_compiler::diagnostic::Mark, chart: &Found) -> String {
    let bytes = mark.start.byte_range().start..mark.end.byte_range().end;
    let words = chart.source.text.get(bytes).unwrap_or_default().split_whitespace();
    words.collect::<Vec<_>>().join(" ")
}
