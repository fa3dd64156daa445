//! `cargo grafcet check`

use std::rc::Rc;

use clap::{Args as Arguments, ValueEnum};
use grafcet_compiler::analysis::Prover;
use grafcet_compiler::{Wanted, diagnose};

use crate::args::Charts;
use crate::find::{self, Found};
use crate::report::{Message, human, json, sarif};
use crate::{Failure, Outcome, rerun, say};

/// Say what the compiler says about charts: rules and properties
///
/// It finds every `grafcet!` of a crate and shows its mistakes, warnings and properties that do not hold at their places in the file, as the
/// build does, and it builds nothing. What `rustc` alone can know, as the types of your functions, only the build tells.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet check                          the crate in this folder
  cargo grafcet check src/press.rs --chart Press
  cargo grafcet check --watch                  beside the editor
  cargo grafcet check --format sarif > charts.sarif    for code scanning in CI

Exit code 1 says that a chart has errors, with --deny-warnings also that it has warnings.")]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// For people, one JSON object a message, or SARIF 2.1.0
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    pub(crate) format: Format,
    /// The same as --format json
    #[arg(long, conflicts_with_all = ["format", "sarif"])]
    pub(crate) json: bool,
    /// The same as --format sarif
    #[arg(long, conflicts_with = "format")]
    pub(crate) sarif: bool,
    /// Exit code 1 for warnings, too
    #[arg(long)]
    pub(crate) deny_warnings: bool,
    /// Check again whenever one of the files has changed, until Ctrl-C
    #[arg(long, conflicts_with_all = ["format", "json", "sarif"])]
    pub(crate) watch: bool,
    /// Let a solver decide the properties that the checker leaves open, as the feature `prove` of the crate `grafcet` does
    #[arg(long)]
    pub(crate) prove: bool,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum Format {
    #[default]
    Human,
    Json,
    Sarif,
}

pub(crate) fn run(options: &Check) -> Result<Outcome, Failure> {
    if options.watch { rerun::run(&options.charts, || once(options)) } else { once(options) }
}

fn once(options: &Check) -> Result<Outcome, Failure> {
    let format = match (options.json, options.sarif) {
        (true, _) => Format::Json,
        (_, true) => Format::Sarif,
        _ => options.format,
    };
    let charts = find::charts(&options.charts)?;
    let prover: Option<&Prover> = if options.prove { Some(&grafcet_prove::rule) } else { None };
    let mut messages = Vec::new();
    for chart in &charts {
        let said = messages.len();
        messages.extend(messages_of(chart, prover));
        // A chart that takes long holds back nothing of those before it.
        for message in &messages[said..] {
            match format {
                Format::Human => say(&format!("{}\n", human::shown(message)))?,
                Format::Json => say(&format!("{}\n", json::object(message)))?,
                Format::Sarif => {}
            }
        }
    }
    match format {
        Format::Human => say(&summary(charts.len(), &messages))?,
        Format::Json => {}
        Format::Sarif => say(&format!("{:#}\n", sarif::log(&messages)))?,
    }
    Ok(Outcome::wrong_if(messages.iter().any(|message| message.is_error() || options.deny_warnings)))
}

/// What the compiler says of a chart and its plants.
pub(crate) fn messages_of(chart: &Found, prover: Option<&Prover>) -> Vec<Message> {
    let said = diagnose(chart.tokens.clone(), Wanted { recorded: false, prover });
    let message =
        |said| Message { source: Rc::clone(&chart.source), chart: chart.name.clone(), call: chart.call, said };
    said.into_iter().map(message).collect()
}

/// `3 charts: 1 error, 2 warnings`
fn summary(charts: usize, messages: &[Message]) -> String {
    let errors = messages.iter().filter(|message| message.is_error()).count();
    let counted = |count: usize, word: &str| match count {
        1 => format!("1 {word}"),
        _ => format!("{count} {word}s"),
    };
    let mut found = Vec::new();
    for (count, word) in [(errors, "error"), (messages.len() - errors, "warning")] {
        if count > 0 {
            found.push(counted(count, word));
        }
    }
    let found = if found.is_empty() { "nothing to say".to_owned() } else { found.join(", ") };
    format!("{}: {found}\n", counted(charts, "chart"))
}
