//! `cargo grafcet coverage`

use std::fs;

use grafcet_sim::{Coverage, script_of};
use serde_json::{Value, json};

use crate::args;
use crate::simulate::session::Session;
use crate::{Failure, Outcome, complain, find, replay, say};

pub(crate) fn run(options: &args::Coverage) -> Result<Outcome, Failure> {
    let found = find::one(&options.charts)?;
    let Some(chart) = replay::chart(&found) else { return Ok(Outcome::Wrong) };
    let mut covered = Coverage::of(&chart);
    for file in &options.script {
        let wrong = |error: &dyn std::fmt::Display| Failure::Said(format!("{}: {error}", file.display()));
        let text = fs::read_to_string(file).map_err(|error| Failure::file(file, &error))?;
        let mut session = Session::new(&chart, 1).map_err(|error| wrong(&error))?;
        for scripted in &script_of(session.signals(), &text).map_err(|error| wrong(&error))? {
            session.play(scripted).map_err(|error| wrong(&error))?;
        }
        covered.add(&session.simulation().coverage());
    }
    for file in &options.record {
        match replay::of_record(&chart, file, false)? {
            Ok(trace) => covered.add(&trace.coverage),
            Err(message) => {
                complain(&message);
                return Ok(Outcome::Wrong);
            }
        }
    }
    if let Some(file) = &options.lcov {
        let source = found.source.path.display().to_string();
        fs::write(file, covered.lcov(&source)).map_err(|error| Failure::file(file, &error))?;
    }
    let missing: Vec<String> = covered.missing().iter().map(ToString::to_string).collect();
    let is_excepted = |line: &&String| options.except.iter().any(|words| line.starts_with(words));
    let open: Vec<&String> = missing.iter().filter(|line| !is_excepted(line)).collect();
    if options.json {
        say(&format!("{}\n", object(&covered, &open)))?;
    } else {
        say(&covered.to_string())?;
    }
    Ok(Outcome::wrong_if(!open.is_empty()))
}

fn object(covered: &Coverage, open: &[&String]) -> Value {
    let count =
        |times: &[u64]| json!({ "covered": times.iter().filter(|times| **times > 0).count(), "all": times.len() });
    json!({ "steps": count(covered.entered()), "transitions": count(&covered.cleared()), "missing": open })
}
