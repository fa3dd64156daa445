//! The command line.

use std::path::PathBuf;

use grafcet_conformance::random::Rng;

const USAGE: &str = "\
conformance [--charts N] [--cycles N] [--seed N] [--dialect sfc|grafcet] [--with WORDS] [--number N] [--shrink N]
            [--least N] [--recorded N] [--soak N [--seconds N]]
            [--folder PATH] [--printed]
conformance --program …: their programs, without rustc

  --charts   charts of each dialect (default 150)
  --cycles   cycles of each chart (default 500)
  --seed     which charts (default 1)
  --with     only charts with something that the table below a report names so
  --number   begins with the chart of this number, as the report gives it after `s` or `g`
  --shrink   of how many differing charts in a hundred the smallest form is looked for (default 1)
  --least    it is an error if fewer charts of a small kind are compared, or half as many of what large charts have (default 0)
  --recorded one chart in N also loses its power at random moments, is recorded and replayed, and runs a little longer (default 8; 0 for none)
  --soak     each chart runs for so many cycles, on stretches of them beside the interpreter, in place of all else
  --seconds  and not longer than this (default 60)
  --folder   where the crates are written and built (default: in the target folder)
  --printed  the Rust that is printed from the charts' programs; the corpus, too";

/// What is asked for.
pub(crate) struct Options {
    pub(crate) charts: usize,
    pub(crate) cycles: usize,
    seed: u64,
    pub(crate) with: Option<String>,
    number: Option<u64>,
    pub(crate) shrink: usize,
    pub(crate) least: usize,
    recorded: u64,
    soak: Option<u64>,
    seconds: u64,
    /// Whether `grafcet`.
    pub(crate) dialects: Vec<bool>,
    pub(crate) folder: Option<PathBuf>,
    pub(crate) printed: bool,
}

impl Options {
    /// Reads the words of the command line.
    ///
    /// # Errors
    /// The usage, where a word is not understood.
    pub(crate) fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self {
            charts: 150,
            cycles: 500,
            seed: 1,
            with: None,
            number: None,
            shrink: 1,
            least: 0,
            recorded: 8,
            soak: None,
            seconds: 60,
            dialects: vec![false, true],
            folder: None,
            printed: false,
        };
        while let Some(word) = words.next() {
            if word == "--printed" {
                options.printed = true;
                continue;
            }
            let value = words.next().ok_or(USAGE)?;
            let number = || value.parse::<u64>().map_err(|error| format!("{word} {value}: {error}"));
            let count = || value.parse::<usize>().map_err(|error| format!("{word} {value}: {error}"));
            match &*word {
                "--charts" => options.charts = count()?,
                "--cycles" => options.cycles = count()?,
                "--seed" => options.seed = number()?,
                "--with" => options.with = Some(value),
                "--number" => options.number = Some(number()?),
                "--shrink" => options.shrink = count()?,
                "--least" => options.least = count()?,
                "--soak" => options.soak = Some(number()?),
                "--seconds" => options.seconds = number()?,
                "--recorded" => options.recorded = number()?,
                "--dialect" => {
                    options.dialects = match &*value {
                        "sfc" => vec![false],
                        "grafcet" => vec![true],
                        _ => return Err(USAGE.to_owned()),
                    }
                }
                "--folder" => options.folder = Some(PathBuf::from(value)),
                _ => return Err(USAGE.to_owned()),
            }
        }
        Ok(options)
    }

    /// Whether the chart of this number is also recorded: every kind of chart has its turn. Only the macro makes what a
    /// recorder needs: what is printed from a program has nothing of it.
    pub(crate) fn is_recorded(&self, number: u64) -> bool {
        let drawn = || self.recorded > 0 && Rng::new(number).number() % self.recorded == 0;
        !self.printed && (self.soak.is_some() || drawn())
    }

    /// For how many cycles or seconds each chart runs.
    pub(crate) fn soak(&self) -> Option<[u64; 2]> {
        self.soak.map(|cycles| [cycles, self.seconds])
    }

    /// The number of the first chart: seeds do not overlap below a hundred thousand charts.
    pub(crate) fn first(&self) -> u64 {
        self.number.unwrap_or(self.seed.wrapping_mul(100_000))
    }
}
