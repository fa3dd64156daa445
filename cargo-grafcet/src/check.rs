//! `cargo grafcet check`

use std::rc::Rc;

use grafcet_compiler::analysis::Prover;
use grafcet_compiler::{Wanted, diagnose};

use crate::args::{Check, Format};
use crate::find::{self, Found};
use crate::report::{Message, human, json, sarif};
use crate::{Failure, Outcome, rerun, say};

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
