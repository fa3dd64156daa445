//! `cargo xtask prove`: what a chart claims, proved or refuted, and random charts beside brute force and beside `abc`.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use grafcet_compiler::analysis::{Facts, Question};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::Model;
use grafcet_compiler::plant;
use grafcet_compiler::program::{Program, counted};
use grafcet_conformance::prove::differs;
use grafcet_prove::circuit::Circuit;
use grafcet_prove::task::Invariant;
use grafcet_prove::{Limit, Verdict, decide, decide_home, decide_live, export, is_so, table, vacuous, words};
use proc_macro2::{TokenStream, TokenTree};

mod random;

const USAGE: &str = "\
Usage: cargo xtask prove FILE [--why] [--seconds N] [--aiger FILE] [--btor2 FILE] [--abc]
       cargo xtask prove --random N [--first N] [--cycles N] [--seconds N] [--kind KIND]
              [--jobs N] [--show] [--abc]

  FILE       a chart, a file of Rust with calls of `grafcet!`, or a chart of the corpus
  --why      what holds in every situation, from which each proof follows
  --seconds  for each property (default 10, of random charts 20)
  --aiger    writes the circuit with its properties, as text where the name ends with .aag
  --btor2    the same as BTOR2

  --random   small random charts, so many of each kind, beside a naive exploration
  --kind     of these, those of one kind alone: plain, remembering, times, plants, of one dialect with `sfc ` or `grafcet ` in front
  --jobs     at a time (default: as many as there are processors)
  --show     how long each chart takes, and the text of those with a property that is left undecided
  --first    the number of the first (default 1)
  --cycles   the most cycles of the exploration (default 20000)
  --abc      beside `berkeley-abc`";

/// What is asked for.
struct Options {
    why: bool,
    time: Option<Duration>,
    aiger: Option<String>,
    btor2: Option<String>,
    random: Option<u64>,
    first: u64,
    cycles: usize,
    kind: Option<String>,
    show: bool,
    jobs: Option<usize>,
    abc: bool,
}

fn main() -> ExitCode {
    match run() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// Whether everything is proved.
fn run() -> Result<bool, String> {
    let mut file = None;
    let mut options = Options {
        why: false,
        time: None,
        aiger: None,
        btor2: None,
        random: None,
        first: 1,
        cycles: 20_000,
        kind: None,
        show: false,
        jobs: None,
        abc: false,
    };
    let mut rest = std::env::args().skip(1);
    while let Some(word) = rest.next() {
        match word.as_str() {
            "--why" => options.why = true,
            "--seconds" => {
                let seconds = rest.next().ok_or(USAGE)?;
                let seconds = seconds.parse().map_err(|error| format!("{seconds}: {error}"))?;
                options.time = Some(Duration::from_secs(seconds));
            }
            "--aiger" => options.aiger = Some(rest.next().ok_or(USAGE)?),
            "--btor2" => options.btor2 = Some(rest.next().ok_or(USAGE)?),
            "--random" => options.random = Some(count(rest.next())?),
            "--first" => options.first = count(rest.next())?,
            "--cycles" => options.cycles = usize::try_from(count(rest.next())?).unwrap_or(usize::MAX),
            "--kind" => options.kind = Some(rest.next().ok_or(USAGE)?),
            "--jobs" => options.jobs = Some(usize::try_from(count(rest.next())?).unwrap_or(1)),
            "--show" => options.show = true,
            "--abc" => options.abc = true,
            _ if file.is_none() && !word.starts_with("--") => file = Some(word),
            _ => return Err(USAGE.to_owned()),
        }
    }
    if let Some(charts) = options.random {
        return random::all(charts, &options);
    }
    let file = file.ok_or(USAGE)?;
    let text = std::fs::read_to_string(&file).map_err(|error| format!("{file}: {error}"))?;
    let text = text.split("\n---\n").next().unwrap_or(&text);
    let tokens: TokenStream = text.parse().map_err(|error| format!("{file}: {error}"))?;
    let (mut proved, mut charts) = (true, 0);
    for chart in charts_in(tokens) {
        charts += 1;
        proved &= one(chart, &options)?;
    }
    if charts == 0 { Err(format!("{file}: there is no chart")) } else { Ok(proved) }
}

fn count(word: Option<String>) -> Result<u64, String> {
    let word = word.ok_or(USAGE)?;
    word.parse().map_err(|error| format!("{word}: {error}"))
}

/// The arguments of `grafcet!`, or all of it where there is no such call.
fn charts_in(tokens: TokenStream) -> Vec<TokenStream> {
    let mut found = Vec::new();
    calls(tokens.clone(), &mut found);
    if found.is_empty() { vec![tokens] } else { found }
}

fn calls(tokens: TokenStream, found: &mut Vec<TokenStream>) {
    let all: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, tree) in all.iter().enumerate() {
        let TokenTree::Group(group) = tree else { continue };
        let called = match index.checked_sub(2).map(|at| (&all[at], &all[at + 1])) {
            Some((TokenTree::Ident(name), TokenTree::Punct(mark))) => name == "grafcet" && mark.as_char() == '!',
            _ => false,
        };
        if called { found.push(group.stream()) } else { calls(group.stream(), found) }
    }
}

fn one(chart: TokenStream, options: &Options) -> Result<bool, String> {
    let mut sink = Sink::new();
    let model = plant::model(chart, &mut sink);
    let messages = sink.finish();
    let broken = messages.iter().filter(|message| message.rule.is_none()).flat_map(|message| &message.notes).next();
    if let Some((_, message)) = broken {
        return Err(message.clone());
    }
    let Some(model) = model.filter(|model| !model.incomplete) else {
        return Err("the chart is not complete".to_owned());
    };
    let program = counted(&model, &Facts::of(&model)).map_err(|refused| refused.to_string())?;
    let circuit = Circuit::of(&program).map_err(|refused| format!("{}: not modelled: {refused}", model.name))?;
    println!("{}: {} latches, {} gates", model.name, circuit.latches.len(), circuit.aig.len());
    if let Some(file) = &options.aiger {
        let bytes = if std::path::Path::new(file).extension().is_some_and(|extension| extension == "aag") {
            export::aiger_text(&program, &circuit).into_bytes()
        } else {
            export::aiger(&program, &circuit)
        };
        std::fs::write(file, bytes).map_err(|error| format!("{file}: {error}"))?;
    }
    if let Some(file) = &options.btor2 {
        std::fs::write(file, export::btor2(&program, &circuit)).map_err(|error| format!("{file}: {error}"))?;
    }
    let nothing = assumed(&program, &circuit, options)?;
    let mut proved = circuit.refused.is_empty();
    for (property, refused) in &circuit.refused {
        println!("  not modelled: {}: {refused}", written(&model, *property));
    }
    for property in 0..model.properties.len() {
        let (start, limit) = (Instant::now(), Limit::time(options.time.unwrap_or(Duration::from_secs(10))));
        let bad = circuit.bad.iter().find(|bad| bad.property == property);
        let live = circuit.live.iter().find(|live| live.property == property);
        let home = circuit.homes.iter().find(|home| home.property == property);
        let verdict = match (bad, live, home) {
            (Some(bad), ..) => decide(&program, &circuit, *bad, &limit),
            (_, Some(live), _) => decide_live(&program, &circuit, *live, &limit),
            (.., Some(home)) => decide_home(&program, &circuit, home, &limit),
            (None, None, None) => continue,
        };
        let verdict = verdict.map_err(|error| error.to_string())?;
        if let (true, Some(bad)) = (options.abc, bad) {
            if let Some(difference) = differs(&program, &circuit, *bad, &verdict)? {
                return Err(format!("{}: {difference}", written(&model, property)));
            }
        }
        say(&program, &circuit, property, &verdict, (start.elapsed(), options.why));
        let is_proved = matches!(verdict, Verdict::Proved(_));
        proved &= is_proved;
        if is_proved && !nothing {
            let limit = Limit::time(options.time.unwrap_or(Duration::from_secs(10)));
            let proof = vacuous(&circuit, property, &limit).map_err(|error| error.to_string())?;
            if let (Some(proof), Some(trigger)) = (proof, model.properties[property].claim.trigger()) {
                println!("    but it says nothing: at the end of no cycle `{}` holds", trigger.text);
                why(&program, &circuit, &proof, options);
            }
        }
    }
    Ok(proved)
}

/// Says what nothing follows from, and whether the assumptions leave nothing at all.
fn assumed(program: &Program<'_>, circuit: &Circuit, options: &Options) -> Result<bool, String> {
    let model = program.model;
    for question in Question::of_assumptions(model) {
        let limit = Limit::time(options.time.unwrap_or(Duration::from_secs(10)));
        let Some(proof) = is_so(circuit, question, &limit).map_err(|error| error.to_string())? else { continue };
        match question {
            Question::NoCycle => {
                println!("  no cycle comes to its end, so that every property holds: correct the assumptions");
            }
            Question::NeverComes(number) => {
                println!("  assumed to come again and again, and never so: {}", model.often[number].text);
            }
            Question::SaysNothing(number) => println!("  assumption {number} of what comes in order excludes nothing"),
            Question::StandsStill(number) => {
                println!("  the plant {} stays where it begins", model.plants.list[number].model.name);
            }
            _ => continue,
        }
        why(program, circuit, &proof, options);
        if question == Question::NoCycle {
            return Ok(true);
        }
    }
    Ok(false)
}

fn why(program: &Program<'_>, circuit: &Circuit, invariant: &Invariant, options: &Options) {
    if options.why {
        for line in words::lines(program, circuit, invariant) {
            println!("      {line}");
        }
    }
}

fn say(program: &Program<'_>, circuit: &Circuit, property: usize, verdict: &Verdict, (time, why): (Duration, bool)) {
    let (seconds, text) = (time.as_secs_f64(), written(program.model, property));
    match verdict {
        Verdict::Proved(proof) => {
            println!("  proved in {seconds:.2} s: {text}");
            if why {
                let circuit = proof.beside.as_deref().unwrap_or(circuit);
                for line in words::ways(&proof.ways) {
                    println!("    {line}");
                }
                for line in words::clocks(program, &proof.clocks).iter().chain(&proof.known) {
                    println!("    {line}");
                }
                for line in words::lines(program, circuit, &proof.invariant) {
                    println!("    {line}");
                }
            }
        }
        Verdict::Violated(way) => {
            println!("  broken in {seconds:.2} s, in cycle {}: {text}", way.len());
            print!("{}", indented(&table(program.model, way)));
        }
        Verdict::Endless { way, again } => {
            let (first, last) = (again + 1, way.len());
            println!("  broken in {seconds:.2} s, where the cycles {first} to {last} come again and again: {text}");
            print!("{}", indented(&table(program.model, way)));
        }
        Verdict::Undecided(why) => println!("  undecided in {seconds:.2} s: {text}: {why}"),
    }
}

fn written(model: &Model, property: usize) -> String {
    use grafcet_compiler::model::Claim;
    match &model.properties[property].claim {
        Claim::Never(condition) => format!("never {}", condition.text),
        Claim::Always { premise: None, condition } => format!("always {}", condition.text),
        Claim::Always { premise: Some(premise), condition } => format!("always {} => {}", premise.text, condition.text),
        Claim::Home(steps, _) => {
            let names: Vec<String> = steps.iter().map(|step| model.steps[*step].name.to_string()).collect();
            if names.len() == 1 { format!("home {}", names.concat()) } else { format!("home ({})", names.join(", ")) }
        }
        Claim::LeadsTo { from, to, within } => {
            let within = within.map_or_else(String::new, |ticks| format!(" within {ticks} ticks"));
            format!("{} leads_to {}{within}", from.text, to.text)
        }
        Claim::Before { first, then } => format!("{} before {}", first.text, then.text),
    }
}

fn indented(text: &str) -> String {
    let mut all = String::new();
    for line in text.lines() {
        all += "    ";
        all += line;
        all.push('\n');
    }
    all
}
