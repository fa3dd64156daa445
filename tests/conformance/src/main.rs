//! `cargo xtask conformance`: random charts, compiled through the macro, beside the interpreter.
#![allow(clippy::format_collect, reason = "texts of a few lines; clearer than a loop that writes")]

mod options;
mod project;
mod shrink;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::ExitCode;

use grafcet_conformance::{chart, random};
use options::Options;
use project::{Case, Project};

/// Charts that are compiled together: many enough that cargo's own time does not count, few enough to see something soon.
const BATCH: usize = 100;

fn main() -> ExitCode {
    let result = Options::read(std::env::args().skip(1)).and_then(|options| run(&options));
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let project = Project::new(options.folder.as_deref())?;
    let mut differences = 0;
    for grafcet in &options.dialects {
        differences += dialect(*grafcet, options, &project)?;
    }
    match differences {
        0 => Ok(()),
        _ => Err(format!("{differences} charts differ")),
    }
}

fn dialect(grafcet: bool, options: &Options, project: &Project) -> Result<usize, String> {
    let name = if grafcet { "grafcet" } else { "sfc" };
    let (mut number, mut accepted, mut differing) = (options.first(), 0, 0);
    let (mut features, mut refused) = (Counts::new(), Counts::new());
    while accepted < options.charts {
        let mut batch = Vec::new();
        while batch.len() < BATCH.min(options.charts - accepted) {
            let made = random::chart(number, grafcet, options.cycles);
            if options.with.as_ref().is_some_and(|with| made.features.iter().all(|feature| !feature.contains(&**with)))
            {
                number += 1;
                continue;
            }
            match chart::resolve(&made.chart) {
                Ok(_) => {
                    made.features.iter().for_each(|feature| *features.entry((*feature).to_owned()).or_default() += 1);
                    let name = format!("{}{number}", &name[..1]);
                    batch.push(Case { name, chart: made.chart, timeline: made.timeline });
                }
                Err(message) => {
                    let rule = message.split("grafcet::").nth(1).and_then(|rest| rest.split(']').next());
                    *refused.entry(rule.unwrap_or("notation").to_owned()).or_default() += 1;
                }
            }
            number += 1;
        }
        accepted += batch.len();
        differing += play(project, &batch, options)?;
        println!("{name}: {accepted} charts x {} cycles, {differing} differ", options.cycles);
    }
    table(name, accepted, &refused, &features);
    Ok(differing)
}

fn play(project: &Project, batch: &[Case], options: &Options) -> Result<usize, String> {
    let outcomes = project.play(batch)?;
    let differing: Vec<_> = outcomes.iter().filter(|outcome| outcome.kind != "same").collect();
    for (index, outcome) in differing.iter().enumerate() {
        println!("{}: {}\n{}", outcome.name, outcome.kind, outcome.text);
        let case = batch.iter().find(|case| case.name == outcome.name).ok_or("an outcome of no chart")?;
        if index < options.shrink {
            let (smallest, outcome) = shrink::smallest(project, case, outcome)?;
            println!("smallest found:\n{}\n{}\n", smallest.chart, outcome.text);
        }
    }
    Ok(differing.len())
}

/// How many charts had something.
type Counts = BTreeMap<String, usize>;

/// How many charts had what of the language, and by which rules others were refused.
fn table(dialect: &str, accepted: usize, refused: &Counts, features: &Counts) {
    let sum: usize = refused.values().sum();
    let mut text = format!("{dialect}: {accepted} charts, {sum} more refused by the compiler, first because of\n");
    for (rule, count) in refused {
        _ = writeln!(text, "  {count:6}  {rule}");
    }
    text.push_str("of those accepted with\n");
    for (feature, count) in features {
        _ = writeln!(text, "  {count:6}  {feature}");
    }
    print!("{text}");
}
