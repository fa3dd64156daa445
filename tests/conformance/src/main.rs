//! `cargo xtask conformance`: random charts, compiled through the macro, beside the interpreter.
#![allow(clippy::format_collect, reason = "texts of a few lines; clearer than a loop that writes")]

mod corpus;
mod options;
mod project;
mod shrink;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::process::ExitCode;

use grafcet_conformance::{chart, emit, fragments, programs, random};
use options::Options;
use project::{Case, Outcome, PRINTED, Project};

/// Charts that are compiled together: many enough that cargo's own time does not count, few enough to see something soon.
const BATCH: usize = 100;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let result = match words.split_first() {
        Some((first, rest)) if first == "--program" => programs::run(rest),
        _ => Options::read(words.into_iter()).and_then(|options| run(&options)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let project = Project::new(options.folder.as_deref(), options.soak())?;
    let mut differences = if options.printed { corpus(&project)? } else { 0 };
    for grafcet in &options.dialects {
        differences += dialect(*grafcet, options, &project)?;
    }
    match differences {
        0 => Ok(()),
        _ => Err(format!("{differences} charts differ")),
    }
}

/// The charts of the corpus, naive with bits and after all passes with regions; `cargo test` has them as the macro makes them.
fn corpus(project: &Project) -> Result<usize, String> {
    let mut cases = Vec::new();
    for (name, text) in corpus::files()? {
        let (chart, timeline) = text.split_once("---\n").ok_or_else(|| format!("{name}: no line `---`"))?;
        if chart.contains("forceable;") {
            continue;
        }
        let end = chart.rfind('}').ok_or_else(|| format!("{name}: no end of the chart"))?;
        let flags = format!("{}encoding flags;\n{}", &chart[..end], &chart[end..]);
        let [naive, optimised] = PRINTED;
        for (name, chart, by) in [(format!("{name}_flags"), flags, naive), (name, chart.to_owned(), optimised)] {
            cases.push(Case { name, chart, timeline: timeline.to_owned(), by, recorded: false });
        }
    }
    let outcomes = project.play(&cases)?;
    let differing: Vec<_> = outcomes.iter().filter(|outcome| outcome.kind != "same").collect();
    for outcome in &differing {
        println!("{}: {}\n{}", outcome.name, outcome.kind, outcome.text);
    }
    println!("corpus: {} charts, {} differ", cases.len(), differing.len());
    Ok(differing.len())
}

fn dialect(grafcet: bool, options: &Options, project: &Project) -> Result<usize, String> {
    let name = if grafcet { "grafcet" } else { "sfc" };
    let (mut number, mut accepted, mut differing) = (options.first(), 0, 0);
    let mut counts = Counts::default();
    while accepted < options.charts {
        let mut batch = Vec::new();
        while batch.len() < BATCH.min(options.charts - accepted) {
            let made = random::chart(number, grafcet, options.cycles);
            // What is printed from a program cannot be forced.
            if options.printed && made.features.contains("forceable") {
                number += 1;
                continue;
            }
            if options.with.as_ref().is_some_and(|with| made.features.iter().all(|feature| !feature.contains(&**with)))
            {
                number += 1;
                continue;
            }
            made.features.iter().for_each(|kind| counts.kinds.entry(kind).or_default()[DRAWN] += 1);
            match chart::resolve(&made.chart) {
                Ok(_) => {
                    made.features.iter().for_each(|kind| counts.kinds.entry(kind).or_default()[ACCEPTED] += 1);
                    let name = format!("{}{number}", &name[..1]);
                    let by = if options.printed { PRINTED[batch.len() % 2] } else { emit::MACRO };
                    // What a record shows of a cycle by hand is the state after it.
                    let forced = made.features.contains("forceable") && options.soak().is_none();
                    let recorded = options.is_recorded(number) && !forced;
                    // The source has to be the compiled chart's, token by token: its fragments are written out.
                    let chart = if options.soak().is_some() { fragments::plain(&made.chart) } else { made.chart };
                    let case = Case { name, chart, timeline: made.timeline, by, recorded };
                    counts.recorded += usize::from(recorded);
                    batch.push((case, made.features));
                }
                Err(message) => {
                    let rule = message.split("grafcet::").nth(1).and_then(|rest| rest.split(']').next());
                    *counts.refused.entry(rule.unwrap_or("notation").to_owned()).or_default() += 1;
                }
            }
            number += 1;
        }
        accepted += batch.len();
        differing += play(project, &batch, options, &mut counts)?;
        match (options.soak(), counts.soaked) {
            (Some(_), [cycles, beside, compared, ticks, taken_over, followed]) => println!(
                "{name}: {accepted} charts, {cycles} cycles, the interpreter beside {beside} of them, of which it has run {compared} and the others were repetitions; \
                 it has taken over a state {taken_over} times, and followed {followed} charts all along as their states do not tell all; \
                 the clocks have wrapped around {} times, {differing} differ",
                ticks >> 32
            ),
            _ => println!("{name}: {accepted} charts x {} cycles, {differing} differ", options.cycles),
        }
    }
    if counts.recorded > 0 && options.soak().is_none() {
        let [all, untold] = counts.traces;
        println!(
            "{name}: {} of them recorded and restored; from the source {all} traces, of which {untold} leave out cycles after a state that does not tell all",
            counts.recorded
        );
    }
    counts.print(name, accepted);
    counts.check(name, grafcet, options.least)?;
    Ok(differing)
}

/// A chart, and what of the language is in it.
type Drawn = (Case, BTreeSet<&'static str>);

fn play(project: &Project, batch: &[Drawn], options: &Options, counts: &mut Counts) -> Result<usize, String> {
    let cases: Vec<Case> = batch.iter().map(|(case, _)| case.clone()).collect();
    let outcomes = project.play(&cases)?;
    for (case, features) in batch {
        let compared = |outcome: &&Outcome| outcome.name == case.name && !["rustc", "broken"].contains(&&*outcome.kind);
        if outcomes.iter().any(|outcome| compared(&outcome)) {
            for kind in features {
                counts.kinds.entry(kind).or_default()[COMPARED] += 1;
            }
        }
    }
    let soaked = outcomes.iter().filter(|outcome| outcome.kind == "soaked");
    soaked.for_each(|outcome| add(&mut counts.soaked, &outcome.text));
    let same = outcomes.iter().filter(|outcome| outcome.kind == "same");
    same.for_each(|outcome| add(&mut counts.traces, &outcome.text));
    let differing: Vec<_> = outcomes.iter().filter(|outcome| !["same", "soaked"].contains(&&*outcome.kind)).collect();
    for (index, outcome) in differing.iter().enumerate() {
        println!("{}: {}\n{}", outcome.name, outcome.kind, outcome.text);
        let case = cases.iter().find(|case| case.name == outcome.name).ok_or("an outcome of no chart")?;
        if index < options.shrink {
            let (smallest, outcome) = shrink::smallest(project, case, outcome)?;
            println!("smallest found:\n{}\n{}\n", smallest.chart, outcome.text);
        }
    }
    Ok(differing.len())
}

const DRAWN: usize = 0;
const ACCEPTED: usize = 1;
const COMPARED: usize = 2;

/// How many charts had what of the language, and by which rules others were refused.
#[derive(Default)]
struct Counts {
    /// Drawn, accepted by the compiler, compared with the interpreter.
    kinds: BTreeMap<&'static str, [usize; 3]>,
    refused: BTreeMap<String, usize>,
    recorded: usize,
    /// What has run for a long time, as [`Done::line`](grafcet_conformance::recorded::Done::line) tells it.
    soaked: [u64; 6],
    /// Traces from sources, and those of them with cycles that are not shown.
    traces: [u64; 2],
}

/// Adds the numbers of a line.
fn add(sums: &mut [u64], line: &str) {
    let numbers = line.split_whitespace().filter_map(|word| word.parse::<u64>().ok());
    sums.iter_mut().zip(numbers).for_each(|(sum, number)| *sum += number);
}

impl Counts {
    fn print(&self, dialect: &str, accepted: usize) {
        let sum: usize = self.refused.values().sum();
        let mut text = format!("{dialect}: {accepted} charts, {sum} more refused by the compiler, first because of\n");
        for (rule, count) in &self.refused {
            _ = writeln!(text, "  {count:6}  {rule}");
        }
        text.push_str("   drawn accepted compared\n");
        for (kind, [drawn, accepted, compared]) in &self.kinds {
            _ = writeln!(text, "  {drawn:6}   {accepted:6}   {compared:6}  {kind}");
        }
        print!("{text}");
    }

    /// Of each small kind so many charts are compared, of what large charts have half as many.
    fn check(&self, dialect: &str, grafcet: bool, least: usize) -> Result<(), String> {
        let compared = |kind: &&str| self.kinds.get(kind).map_or(0, |counts| counts[COMPARED]);
        let rare: Vec<String> = random::kinds(grafcet)
            .filter(|kind| compared(kind) < if kind.starts_with("small") { least } else { least / 2 })
            .map(|kind| format!("{kind} ({})", compared(&kind)))
            .collect();
        match rare[..] {
            [] => Ok(()),
            _ => Err(format!("{dialect}: too few charts were compared of: {}", rare.join(", "))),
        }
    }
}
