//! `cargo grafcet prove`

mod nothing;
mod progress;
mod with;

use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::time::{Duration, Instant};

use clap::Args as Arguments;
use grafcet_compiler::analysis::Facts;
use grafcet_compiler::model::{Claim, Model, StepId};
use grafcet_compiler::program::{Program, counted};
use grafcet_prove::checker::{Told, Trouble, decide_by};
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Internal, Limit, Verdict, decide, decide_home, decide_live, export, table, vacuous, words};
use serde_json::{Value, json};

use crate::args::Charts;
use crate::find::{self, Found};
use crate::model::with_plants;
use crate::time::duration;
use crate::{Failure, Outcome, complain, say};
use progress::Progress;
use with::Checker;

/// Prove or refute what charts claim
///
/// Each property is proved for all inputs and all times, or broken by a way of cycles, which is shown.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet prove --chart Crossing
  cargo grafcet prove --chart Crossing --why     what holds in every situation, from which each proof follows
  cargo grafcet prove --chart Crossing --limit 5min
  cargo grafcet prove --chart Crossing --aiger crossing.aig
  cargo grafcet prove --with 'aigbmc -m 100'     a checker that reads AIGER and writes witnesses
  cargo grafcet prove --with 'btormc {btor2}'    the same with BTOR2
  cargo grafcet prove --with 'berkeley-abc -c \"read {aig}; pdr; write_cex -a {witness}\"'

Exit code 1 says that a property is broken, undecided, or not modelled; 2 that a checker says what is not so, or nothing that is understood.")]
pub(crate) struct Prove {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// The longest time for each property, as `60s`, `500ms`, `5min` or `1h`
    #[arg(long, default_value = "10s", value_name = "TIME", value_parser = duration)]
    pub(crate) limit: Duration,
    /// What holds in every situation, from which each proof follows
    #[arg(long)]
    pub(crate) why: bool,
    /// Let this command decide: it finds a circuit with one bad state in the file `{aig}` (AIGER, binary; after the other words, if none is named), `{aag}` (as text)
    /// or `{btor2}`, and writes a witness of AIGER or BTOR2 to its output or to the file `{witness}`. A counterexample counts if the chart breaks the property on it
    #[arg(long, value_name = "COMMAND", conflicts_with = "why")]
    pub(crate) with: Option<String>,
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
    let checker = options.with.as_deref().map(Checker::new).transpose()?;
    let (mut wrong, mut asked) = (false, 0);
    for chart in &charts {
        let Some(model) = with_plants(chart) else {
            wrong = true;
            continue;
        };
        asked += model.properties.len();
        wrong |= !one(chart, &model, options, checker.as_ref())?;
    }
    if asked == 0 && !options.json {
        complain(
            "note: there is no property: `always`, `never`, `home`, `leads_to` and `before` say what a chart claims",
        );
    }
    Ok(Outcome::wrong_if(wrong))
}

/// Whether everything that the chart claims is proved.
fn one(chart: &Found, model: &Model, options: &Prove, checker: Option<&Checker>) -> Result<bool, Failure> {
    let refused = |why: String| Failure::Said(format!("{} has no circuit: {why}", chart.name));
    let program = counted(model, &Facts::of(model)).map_err(|error| refused(error.to_string()))?;
    let circuit = Circuit::of(&program).map_err(|error| refused(error.to_string()))?;
    write(&program, &circuit, options)?;
    let asked = Asked { chart, program: &program, circuit: &circuit, options, checker };
    let mut proved = true;
    for index in 0..model.properties.len() {
        let start = Instant::now();
        let text = asked.text(index);
        let said = asked.property(index, &text)?;
        proved &= said.verdict == PROVED;
        show(chart, &text, &said, start, options)?;
    }
    let start = Instant::now();
    let internal = |error: Internal| Failure::Said(format!("{}: {error}", chart.name));
    for (text, said) in asked.says_nothing().map_err(internal)? {
        show(chart, &text, &said, start, options)?;
    }
    Ok(proved)
}

const PROVED: &str = "proved";

/// What a chart is asked.
struct Asked<'a> {
    chart: &'a Found,
    program: &'a Program<'a>,
    circuit: &'a Circuit,
    options: &'a Prove,
    checker: Option<&'a Checker>,
}

impl Asked<'_> {
    fn text(&self, index: usize) -> String {
        let property = &self.program.model.properties[index];
        match &property.claim {
            Claim::Home(steps, _) => home(self.program.model, steps),
            _ => text(property.mark, self.chart),
        }
    }

    fn limit(&self, progress: Option<&Rc<Progress>>) -> Limit {
        let limit = Limit::time(self.options.limit);
        match progress.cloned() {
            Some(progress) => limit.watched(move |at| progress.at(at)),
            None => limit,
        }
    }

    fn property(&self, index: usize, text: &str) -> Result<Said, Failure> {
        let internal = |error: Internal| Failure::Said(format!("{}: {text}: {error}", self.chart.name));
        let progress = Progress::new(format!("{}: {text}", self.chart.name)).map(Rc::new);
        let limit = self.limit(progress.as_ref());
        if let Some(checker) = self.checker
            && let Some(told) = self.told(checker, (index, text), &limit, progress.as_deref())?
        {
            return self.with_what_says_nothing(told, index, &limit).map_err(internal);
        }
        let bad = self.circuit.bad.iter().find(|bad| bad.property == index);
        let live = self.circuit.live.iter().find(|live| live.property == index);
        let home = self.circuit.homes.iter().find(|home| home.property == index);
        let verdict = match (bad, live, home) {
            (Some(bad), ..) => decide(self.program, self.circuit, *bad, &limit),
            (_, Some(live), _) => decide_live(self.program, self.circuit, *live, &limit),
            (.., Some(home)) => decide_home(self.program, self.circuit, home, &limit),
            (None, None, None) => {
                let refused = self.circuit.refused.iter().find(|(property, _)| *property == index);
                let lines = refused.map(|(_, refused)| refused.to_string()).into_iter().collect();
                return Ok(Said { lines, ..Said::of("not modelled") });
            }
        };
        let mut said = said(self.program, self.circuit, &verdict.map_err(internal)?, self.options.why);
        if self.checker.is_some() {
            said.lines.insert(0, "decided here: a way home is nothing that checkers of circuits are asked".to_owned());
        }
        self.with_what_says_nothing(said, index, &self.limit(progress.as_ref())).map_err(internal)
    }

    /// What another checker says; none where there is nothing to ask it.
    fn told(
        &self,
        checker: &Checker,
        (index, text): (usize, &str),
        limit: &Limit,
        progress: Option<&Progress>,
    ) -> Result<Option<Said>, Failure> {
        let until = Instant::now().checked_add(self.options.limit);
        let until = until.ok_or_else(|| Failure::Said("--limit is longer than can be waited".to_owned()))?;
        let told =
            decide_by(self.program, self.circuit, index, limit, &mut |question| checker.ask(question, until, progress));
        let by = Some(checker.command.clone());
        match told {
            Ok(None) => Ok(None),
            Ok(Some(Told::Holds)) => {
                let lines = vec![format!("by the word of `{}`, without a certificate", with::name(&checker.command))];
                Ok(Some(Said { by, lines, ..Said::of(PROVED) }))
            }
            Ok(Some(Told::Found(verdict))) => {
                Ok(Some(Said { by, ..said(self.program, self.circuit, &verdict, false) }))
            }
            Err(Trouble::Asked(failure)) => Err(failure),
            Err(Trouble::Wrong(what)) => Err(Failure::Said(format!(
                "{}: {text}: what `{}` says is not so: {what}",
                self.chart.name, checker.command
            ))),
            Err(Trouble::Internal(internal)) => Err(Failure::Said(format!("{}: {text}: {internal}", self.chart.name))),
        }
    }

    /// A proof, with what is true of no cycle.
    fn with_what_says_nothing(&self, mut said: Said, index: usize, limit: &Limit) -> Result<Said, Internal> {
        if said.verdict == PROVED {
            let nothing = vacuous(self.circuit, index, limit)?;
            if let (Some(_), Some(trigger)) = (nothing, self.program.model.properties[index].claim.trigger()) {
                said.lines.insert(0, format!("but it says nothing: at the end of no cycle `{}` holds", trigger.text));
            }
        }
        Ok(said)
    }
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
    /// Who says so, if it is another checker.
    by: Option<String>,
    /// After so many cycles it is broken.
    cycles: Option<usize>,
    lines: Vec<String>,
}

impl Said {
    fn of(verdict: &'static str) -> Self {
        Self { verdict, by: None, cycles: None, lines: Vec::new() }
    }
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
            Said { lines: all, ..Said::of(PROVED) }
        }
        Verdict::Violated(way) => {
            Said { cycles: Some(way.len()), lines: lines(table(program.model, way)), ..Said::of("broken") }
        }
        Verdict::Endless { way, again } => {
            let mut all = vec![format!("the cycles {} to {} come again and again", again + 1, way.len())];
            all.extend(table(program.model, way).lines().map(str::to_owned));
            Said { cycles: Some(way.len()), lines: all, ..Said::of("broken") }
        }
        Verdict::Undecided(why) => Said { lines: vec![why.clone()], ..Said::of("undecided") },
    }
}

fn show(chart: &Found, property: &str, said: &Said, start: Instant, options: &Prove) -> Result<(), Failure> {
    if options.json {
        let mut object: Value =
            json!({ "chart": chart.name, "property": property, "verdict": said.verdict, "lines": said.lines });
        object["seconds"] = start.elapsed().as_secs_f64().into();
        if let Some(by) = &said.by {
            object["by"] = by.as_str().into();
        }
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
