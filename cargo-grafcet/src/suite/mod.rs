//! `cargo grafcet tests`
//!
//! - `goals`: what is to be shown
//! - `choices`: what a cycle may be given
//! - `search`: the way to the next goal
//! - `plan`: sequences that show all
//! - `proof`: the prover, asked for what is left
//! - `program`: what somebody has to write for a Rust test of a chart that asks its program
//! - `write`: these as scripts, Rust and a page

mod choices;
mod goals;
mod plan;
mod program;
mod proof;
mod search;
mod write;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args as Arguments;
use grafcet_sim::{Beside, Chart};
use serde_json::json;

use crate::args::Charts;
use crate::find::{self, Found};
use crate::model::drawn;
use crate::time::duration;
use crate::{Failure, Outcome, check, complain, replay, say, simulate};
use goals::Goal;
use plan::Plan;
use search::Search;

/// Write a test suite out of a chart: as few cycles as show all of it
///
/// Sequences of cycles in which every transition clears, and in which each, its steps being active, does not clear once. What is expected of each cycle is what the chart does:
/// somebody has to confirm that it is what is meant. The sequences are found by trying: in each cycle the values that conditions can tell apart; a solver is asked for what is left.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet tests --chart Motor                      as scripts, to the output
  cargo grafcet tests --chart Motor --out scripts --pairs
  cargo grafcet tests --chart Motor --rust src/motor_tests.rs --path super
  cargo grafcet tests --chart Motor --protocol motor.md  a page to tick off at the machine

Exit code 1 says that something is not shown, or that a transition never clears; it is listed with the reason. That a transition never waits, which is proved, is no fault.")]
pub(crate) struct Tests {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// Each pair of transitions one after the other, too
    #[arg(long)]
    pub(crate) pairs: bool,
    /// Write the scripts to NAME-1.script and so on in this folder
    #[arg(long, value_name = "FOLDER")]
    pub(crate) out: Option<PathBuf>,
    /// Write a Rust file with a test for each sequence
    #[arg(long, value_name = "FILE")]
    pub(crate) rust: Option<PathBuf>,
    /// Where the Rust file finds the chart's types
    #[arg(long, value_name = "PATH", default_value = "super", requires = "rust")]
    pub(crate) path: String,
    /// Write a page (Markdown) to tick off at the machine
    #[arg(long, value_name = "FILE")]
    pub(crate) protocol: Option<PathBuf>,
    /// The time from one cycle to the next where the chart waits for none, in ticks of its clock; else a tenth of a second
    #[arg(long, value_name = "TICKS", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) step: Option<u32>,
    /// So many cycles are tried on the way to each goal
    #[arg(long, value_name = "CYCLES", default_value_t = 20_000)]
    pub(crate) effort: usize,
    /// So long a solver is asked for what was not found: for a way, or a proof that there is none; `0s` asks it nothing
    #[arg(long, value_name = "TIME", default_value = "20s", value_parser = duration)]
    pub(crate) limit: Duration,
    /// One JSON object
    #[arg(long)]
    pub(crate) json: bool,
}

pub(crate) fn run(options: &Tests) -> Result<Outcome, Failure> {
    let found = find::one(&options.charts)?;
    let Some(chart) = replay::chart(&found) else { return Ok(Outcome::Wrong) };
    for block in chart.blocks() {
        complain(&format!("note: `{block}` is Rust that is not simulated: it writes nothing"));
    }
    let beside = Beside::of(&chart);
    let step = options.step.unwrap_or_else(|| simulate::step(&chart));
    let plan = Search::new(&beside, options.pairs, step, options.effort).and_then(|search| {
        let mut plan = Plan::of(&search, options.effort)?;
        let known = explain(&mut plan.open, &chart, &found);
        let asked: BTreeSet<Goal> = plan.open.keys().filter(|goal| !known.contains(goal)).copied().collect();
        if !asked.is_empty() {
            plan.told(&search, proof::ask(drawn(&found), &beside, &asked, options.limit))?;
        }
        Ok(plan)
    });
    let plan = match plan {
        Ok(plan) => plan,
        Err(error) => {
            complain(&format!("error: {} cannot be simulated: {error}", found.name));
            return Ok(Outcome::Wrong);
        }
    };
    let scripts = write::scripts(&plan, &beside);
    if let Some(folder) = &options.out {
        fs::create_dir_all(folder).map_err(|error| Failure::file(folder, &error))?;
        for (number, script) in scripts.iter().enumerate() {
            let name = format!("{}-{}.script", chart.names().chart.to_lowercase(), number + 1);
            write(&folder.join(name), script)?;
        }
    }
    if let Some(file) = &options.protocol {
        write(file, &write::protocol(&plan, &beside))?;
    }
    if let Some(file) = &options.rust {
        match write::rust(&plan, &beside, &options.path) {
            Ok(text) => {
                write(file, &text)?;
                if beside.signals().len() > beside.inputs() {
                    let stub = program::STUB;
                    complain(&format!(
                        "note: the chart asks its program: `{stub}` in {} has to be written by you; until then its tests fail",
                        file.display()
                    ));
                }
            }
            Err(why) => return Err(Failure::Said(format!("there is no Rust test of {}: {why}", found.name))),
        }
    }
    if options.json {
        say(&format!("{}\n", object(&plan, &chart, &scripts)))?;
    } else {
        if options.out.is_none() && options.protocol.is_none() && options.rust.is_none() {
            say(&scripts.iter().fold(String::new(), |all, script| all + script + "\n"))?;
        }
        say(&summary(&plan, &chart))?;
    }
    let is_dead = plan.never.iter().any(|goal| !matches!(goal, Goal::Waited(_)));
    Ok(Outcome::wrong_if(is_dead || !plan.open.is_empty()))
}

fn write(file: &Path, text: &str) -> Result<(), Failure> {
    fs::write(file, text).map_err(|error| Failure::file(file, &error))
}

/// What the compiler knows better than the search; these need not be asked any more.
fn explain(open: &mut BTreeMap<Goal, String>, chart: &Chart, found: &Found) -> BTreeSet<Goal> {
    let mut known = BTreeSet::new();
    if open.is_empty() {
        return known;
    }
    let model = chart.model();
    let drawn: Vec<_> = model.drawn_transitions().map(|(_, one)| one).collect();
    let is_proof = |rule: &str| ["unreachable_step", "dead_transition", "never_true"].contains(&rule);
    let mut messages = check::messages_of(found, None);
    messages.retain(|message| message.said.rule.is_some_and(|rule| is_proof(rule.name)));
    for (goal, why) in open {
        match goal {
            Goal::Cleared(one) | Goal::Waited(one) => {
                let bytes =
                    |mark: grafcet_compiler::diagnostic::Mark| mark.start.byte_range().start..mark.end.byte_range().end;
                let all = bytes(drawn[*one].mark);
                let about = messages.iter().filter_map(|message| message.said.notes.first());
                let about = about.filter(|(mark, _)| all.contains(&bytes(*mark).start));
                if let Some((_, said)) = about.into_iter().next() {
                    *why = format!("the compiler says: {}", said.lines().next().unwrap_or_default());
                    known.insert(*goal);
                }
            }
            Goal::Pair(..) => {}
        }
    }
    known
}

fn counts(plan: &Plan<'_>, of: fn(&Goal) -> bool) -> (usize, usize) {
    let all = plan.goals.iter().filter(|goal| of(goal)).count();
    let open = plan.open.keys().chain(&plan.never).filter(|goal| of(goal)).count();
    (all - open, all)
}

fn summary(plan: &Plan<'_>, chart: &Chart) -> String {
    let names = chart.names();
    let plural = |count: usize, word: &str| if count == 1 { format!("1 {word}") } else { format!("{count} {word}s") };
    let (sequences, cycles) = (plural(plan.sequences.len(), "sequence"), plural(plan.cycles(), "cycle"));
    let (cleared, all) = counts(plan, |goal| matches!(goal, Goal::Cleared(_)));
    let (waited, others) = counts(plan, |goal| matches!(goal, Goal::Waited(_)));
    let mut text = format!(
        "{}: {sequences}, {cycles}: {cleared} of {all} transitions clear, {waited} of {others} do not although their steps are active",
        names.chart
    );
    let (pairs, all) = counts(plan, |goal| matches!(goal, Goal::Pair(..)));
    if all > 0 {
        text = format!("{text}, {pairs} of {all} pairs");
    }
    text.push('\n');
    text = plan.open.iter().fold(text, |all, (goal, why)| all + &format!("  not shown: {}: {why}\n", goal.text(names)));
    plan.never.iter().fold(text, |all, goal| all + &format!("  cannot be, as is proved: {}\n", goal.text(names)))
}

fn object(plan: &Plan<'_>, chart: &Chart, scripts: &[String]) -> serde_json::Value {
    let names = chart.names();
    let count = |(shown, all): (usize, usize)| json!({ "shown": shown, "all": all });
    let open = plan.open.iter().map(|(goal, why)| json!({ "goal": goal.text(names), "why": why }));
    json!({
        "chart": names.chart,
        "cycles": plan.cycles(),
        "scripts": scripts,
        "cleared": count(counts(plan, |goal| matches!(goal, Goal::Cleared(_)))),
        "waited": count(counts(plan, |goal| matches!(goal, Goal::Waited(_)))),
        "pairs": count(counts(plan, |goal| matches!(goal, Goal::Pair(..)))),
        "open": open.collect::<Vec<_>>(),
        "never": plan.never.iter().map(|goal| goal.text(names)).collect::<Vec<_>>(),
    })
}
