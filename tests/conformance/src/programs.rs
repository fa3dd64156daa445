//! `cargo xtask conformance --program`: the programs of random charts, naive and after passes, beside the interpreter, without rustc.

use std::collections::BTreeMap;
use std::fmt;
use std::num::NonZero;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use grafcet_compiler::model::Model;
use grafcet_compiler::program::passes::Pass;

use crate::program::{Outcome, compare, program, rests, sleeps};
use crate::reader::Line;
use crate::simpler::simpler;
use crate::{chart, random, reader};

const USAGE: &str = "\
conformance --program [--charts N] [--cycles N] [--seed N] [--number N] [--dialect sfc|grafcet]

  --charts   charts that the compiler accepts, of each dialect (default 2500)
  --cycles   cycles of each (default 200)
  --seed     which charts (default 1)
  --number   begins with the chart of this number, as the report gives it";

/// How many differences are shown.
const SHOWN: u64 = 5;

/// Compares the charts that the words of a command line ask for.
///
/// # Errors
/// A chart differs, or a word is none of ours.
pub fn run(words: &[String]) -> Result<(), String> {
    let mut options = BTreeMap::from([("--charts", 2500), ("--cycles", 200), ("--seed", 1)]);
    let (mut dialects, mut number) = (vec![false, true], None);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        let value = words.next().ok_or(USAGE)?;
        if word == "--dialect" {
            dialects = vec![value == "grafcet"];
            continue;
        }
        let count = value.parse::<u64>().map_err(|error| format!("{word} {value}: {error}"))?;
        if word == "--number" {
            number = Some(count);
        } else {
            *options.get_mut(&**word).ok_or(USAGE)? = count;
        }
    }
    let first = number.unwrap_or(options["--seed"].wrapping_mul(100_000));
    let mut differing = 0;
    for grafcet in dialects {
        differing += dialect(grafcet, first, &options)?;
    }
    if differing == 0 { Ok(()) } else { Err(format!("{differing} charts differ")) }
}

fn dialect(grafcet: bool, first: u64, options: &BTreeMap<&str, u64>) -> Result<usize, String> {
    let name = if grafcet { "grafcet" } else { "sfc" };
    let (start, cycles) = (Instant::now(), usize::try_from(options["--cycles"]).unwrap_or(usize::MAX));
    let next = Next {
        number: AtomicU64::new(first),
        accepted: AtomicU64::new(0),
        charts: options["--charts"],
        shown: AtomicU64::new(0),
    };
    let threads = std::thread::available_parallelism().map_or(1, NonZero::get);
    let work = || play(grafcet, &next, cycles);
    let parts: Vec<Result<Part, String>> = std::thread::scope(|scope| {
        let all: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        all.into_iter().map(|one| one.join().unwrap_or_else(|_| Err("a thread panicked".to_owned()))).collect()
    });
    let mut sum = Part::default();
    for part in parts {
        let part = part?;
        sum.charts += part.charts;
        sum.stopped += part.stopped;
        sum.differing += part.differing;
    }
    let Part { charts, stopped, differing } = sum;
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{name}: {charts} charts x {cycles} cycles, {differing} differ; {stopped} stopped by arithmetic; {seconds:.0} s"
    );
    Ok(differing)
}

/// Which chart comes next, for all threads.
struct Next {
    number: AtomicU64,
    accepted: AtomicU64,
    charts: u64,
    /// How many differences have been shown.
    shown: AtomicU64,
}

/// What one thread has done.
#[derive(Default)]
struct Part {
    charts: u64,
    stopped: u64,
    differing: usize,
}

fn play(grafcet: bool, next: &Next, cycles: usize) -> Result<Part, String> {
    let mut part = Part::default();
    loop {
        let number = next.number.fetch_add(1, Ordering::Relaxed);
        if next.accepted.load(Ordering::Relaxed) >= next.charts {
            return Ok(part);
        }
        let made = random::chart(number, grafcet, cycles);
        let Ok(model) = chart::resolve(&made.chart) else { continue };
        if next.accepted.fetch_add(1, Ordering::Relaxed) >= next.charts {
            return Ok(part);
        }
        part.charts += 1;
        let lines = reader::read(&format!("{}---\n{}", made.chart, made.timeline))?.lines;
        match differs(&model, &lines, number) {
            Ok(whole) => part.stopped += u64::from(!whole),
            // At once: a long run may not come to its end.
            Err(error) => {
                part.differing += 1;
                if next.shown.fetch_add(1, Ordering::Relaxed) < SHOWN {
                    println!("{number}: {error}\n{}", made.chart);
                    println!("{number}: {}", error.smallest(&made.chart, &lines));
                }
            }
        }
    }
}

/// Each chart after all passes or all but one, one in five as it is. Whether the whole timeline was understood.
fn differs(model: &Model, lines: &[Line], number: u64) -> Result<bool, Difference> {
    let mut passes = Pass::ALL.to_vec();
    if let Some(left_out) = Pass::ALL.get(usize::try_from(number / 3).unwrap_or(0) % (Pass::ALL.len() + 1)) {
        passes.retain(|pass| pass != left_out);
    }
    if number % 5 == 0 {
        passes.clear();
    }
    let mut whole = true;
    for method in Method::ALL {
        if method.is_asked(number) {
            match method.plays(model, lines, &passes) {
                Ok(understood) => whole &= understood,
                Err(error) => return Err(Difference { passes, method, error }),
            }
        }
    }
    Ok(whole)
}

/// How a program is compared with the interpreter.
#[derive(Clone, Copy, Debug)]
enum Method {
    Cycles,
    /// Of a chart by time one in eight, with cycles only where it asks for them.
    Asleep,
    /// One in eight, with what it says of when it wants the next cycle.
    AtRest,
}

impl Method {
    const ALL: [Self; 3] = [Self::Cycles, Self::Asleep, Self::AtRest];

    fn is_asked(self, number: u64) -> bool {
        match self {
            Self::Cycles => true,
            Self::Asleep => (number / 32) % 8 == 0,
            Self::AtRest => (number / 32) % 8 == 1,
        }
    }

    fn plays(self, model: &Model, lines: &[Line], passes: &[Pass]) -> Result<bool, String> {
        match self {
            Self::Cycles => Ok(matches!(compare(model, lines, passes)?, Outcome::Same)),
            Self::Asleep => sleeps(model, &lines[..lines.len().min(40)], passes).map(|()| true),
            Self::AtRest => rests(model, &lines[..lines.len().min(60)], passes).map(|()| true),
        }
    }
}

/// A program that does something else than the interpreter.
struct Difference {
    passes: Vec<Pass>,
    method: Method,
    error: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}, after the passes {:?}: {}", self.method, self.passes, self.error)
    }
}

impl Difference {
    /// A chart that has a program, and one that does something else.
    fn persists(&self, model: &Model, lines: &[Line], passes: &[Pass]) -> Option<String> {
        program(model, passes).ok()?;
        self.method.plays(model, lines, passes).err()
    }

    /// With the chart, from which all is left out without which it still differs in this method, and the passes.
    fn smallest(mut self, chart: &str, lines: &[Line]) -> String {
        let mut chart = chart.to_owned();
        while let Some((simpler, error)) = simpler(&chart).into_iter().find_map(|text| {
            let model = chart::resolve(&text).ok().filter(|_| text.len() < chart.len())?;
            let error = self.persists(&model, lines, &self.passes)?;
            Some((text, error))
        }) {
            (chart, self.error) = (simpler, error);
        }
        let Ok(model) = chart::resolve(&chart) else { return self.error };
        for pass in Pass::ALL {
            let fewer: Vec<Pass> = self.passes.iter().copied().filter(|kept| *kept != pass).collect();
            if let Some(error) = self.persists(&model, lines, &fewer) {
                (self.passes, self.error) = (fewer, error);
            }
        }
        format!("{self}\n{chart}")
    }
}
