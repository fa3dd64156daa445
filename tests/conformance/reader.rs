//! Reads the files of this folder; the format is described in README.md. Shared by every runner, so it knows neither the
//! interpreter nor the generated code.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// One file: a chart and its timeline.
#[derive(Clone, Debug)]
pub struct Case {
    /// The text of the chart, as it would stand inside `grafcet! { … }`.
    pub chart: String,
    /// The timeline.
    pub lines: Vec<Line>,
}

/// One line of a timeline.
#[derive(Clone, Debug)]
pub struct Line {
    /// Its number in the file, from 1.
    pub number: usize,
    /// What it says.
    pub kind: Kind,
}

impl Line {
    /// What is done in the line, without what is expected.
    #[must_use]
    #[allow(dead_code, reason = "not every runner prints lines")]
    pub fn text(&self) -> String {
        let named = |values: &BTreeMap<String, i128>| {
            values.iter().map(|(name, value)| format!("{name}={value} ")).collect::<Vec<_>>().concat()
        };
        match &self.kind {
            Kind::Cycle { inputs, now, .. } => format!("{}@{now}", named(inputs)),
            Kind::Force { asked, inputs, now, .. } => format!("{asked} {}@{now}", named(inputs)),
            Kind::Refuses(asked) => format!("refuses {asked}"),
            Kind::Shows(_) => "shows".to_owned(),
            Kind::Init => "init".to_owned(),
            Kind::Params(changed) => format!("params {}", named(changed)),
            Kind::Wakes(deadline) => format!("wakes {deadline:?}"),
        }
    }
}

/// What a line asks for.
#[derive(Clone, Debug)]
pub enum Kind {
    /// One cycle at the time `now`; inputs that are not named are false or zero.
    Cycle {
        /// By name.
        inputs: BTreeMap<String, i128>,
        /// In the unit of the chart's clock.
        now: u32,
        /// What it has to show.
        expected: Expected,
    },
    /// A cycle that leads into a situation by hand.
    Force {
        /// Which one.
        asked: Asked,
        /// By name.
        inputs: BTreeMap<String, i128>,
        /// In the unit of the chart's clock.
        now: u32,
        /// What it has to show.
        expected: Expected,
    },
    /// A situation that the chart does not let itself be put into; nothing happens.
    Refuses(Asked),
    /// What the chart shows without a cycle, calls excepted.
    Shows(Expected),
    /// The classic *Init*.
    Init,
    /// Parameters that change; the others keep their values.
    Params(BTreeMap<String, i128>),
    /// What `next_deadline` says now.
    Wakes(Option<u32>),
}

/// A situation that is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Asked {
    /// By the names of its steps.
    Steps(BTreeSet<String>),
    /// The steps of situations that the timeline has shown before, by their numbers; which these are is known while it is played.
    Seen(Vec<usize>),
}

impl fmt::Display for Asked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list: Vec<String> = match self {
            Self::Steps(steps) => steps.iter().cloned().collect(),
            Self::Seen(seen) => seen.iter().map(|number| format!("~{number}")).collect(),
        };
        write!(f, "force({})", list.join(","))
    }
}

impl Asked {
    /// `Fill,Heat`, `~3,~12`
    fn read(list: &str) -> Result<Self, String> {
        let words = || list.split(',').filter(|word| !word.is_empty());
        if !list.contains('~') {
            return Ok(Self::Steps(words().map(str::to_owned).collect()));
        }
        let number = |word: &str| {
            let number = word.strip_prefix('~').and_then(|number| number.parse().ok());
            number.ok_or_else(|| format!("`{word}` is no number of a situation"))
        };
        Ok(Self::Seen(words().map(number).collect::<Result<_, _>>()?))
    }

    /// The steps, and whether the chart has been in them.
    #[must_use]
    #[allow(dead_code, reason = "the board knows all steps by name")]
    pub fn steps(&self, seen: &[BTreeSet<String>]) -> (BTreeSet<String>, bool) {
        match self {
            Self::Steps(steps) => (steps.clone(), false),
            Self::Seen(numbers) => {
                let chosen = numbers.iter().filter_map(|number| seen.get(number % seen.len().max(1)));
                (chosen.flatten().cloned().collect(), numbers.len() == 1)
            }
        }
    }
}

/// What a cycle has to show. Values are numbers; `true` is 1, times are in ticks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expected {
    /// The names of the active steps.
    pub steps: BTreeSet<String>,
    /// Whether the search of a `grafcet` ended in a stable situation.
    pub stable: bool,
    /// The outputs that are not false or zero.
    pub outputs: BTreeMap<String, i128>,
    /// The calls in their order, as `first heat(80)`.
    pub calls: Vec<String>,
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for step in &self.steps {
            write!(f, "{step} ")?;
        }
        f.write_str(if self.stable { "| " } else { "!unstable | " })?;
        for (name, value) in &self.outputs {
            write!(f, "{name}={value} ")?;
        }
        write!(f, "| {}", self.calls.join("; "))
    }
}

/// Reads a file.
///
/// # Errors
/// The number of the line that is not understood, and why.
pub fn read(text: &str) -> Result<Case, String> {
    let (chart, timeline) = text.split_once("\n---\n").ok_or("no line `---` between chart and timeline")?;
    let above = chart.lines().count() + 1;
    let mut lines = Vec::new();
    let mut now = 0;
    for (index, line) in timeline.lines().enumerate() {
        let number = above + index + 1;
        let line = line.split('#').next().unwrap_or_default().trim();
        if !line.is_empty() {
            let kind = kind(line, &mut now).map_err(|error| format!("line {number}: {error}"))?;
            lines.push(Line { number, kind });
        }
    }
    if lines.is_empty() {
        return Err("the timeline is empty".to_owned());
    }
    Ok(Case { chart: chart.to_owned(), lines })
}

fn kind(line: &str, now: &mut u32) -> Result<Kind, String> {
    let columns: Vec<&str> = line.split('|').map(str::trim).collect();
    if let [directive] = columns[..] {
        let mut words = directive.split_whitespace();
        return match words.next() {
            Some("init") => Ok(Kind::Init),
            Some("params") => Ok(Kind::Params(values(words)?)),
            Some("wakes") => match words.next() {
                Some("-") => Ok(Kind::Wakes(None)),
                time => {
                    let number = time.and_then(|time| time.strip_prefix('@')?.parse().ok());
                    Ok(Kind::Wakes(Some(number.ok_or_else(|| format!("`{directive}`: `wakes @20` or `wakes -`"))?)))
                }
            },
            Some("refuses") => {
                let asked = words.next().and_then(|word| word.strip_prefix("force(")?.strip_suffix(')'));
                Ok(Kind::Refuses(Asked::read(asked.ok_or_else(|| format!("`{directive}`: `refuses force(A,B)`"))?)?))
            }
            _ => Err(format!("`{directive}` is neither a cycle nor `init`, `params`, `wakes` nor `refuses`")),
        };
    }
    let (steps, outputs, calls) = match columns[1..] {
        [steps, outputs] => (steps, outputs, ""),
        [steps, outputs, calls] => (steps, outputs, calls),
        _ => return Err("a cycle is `inputs | steps | outputs` or `inputs | steps | outputs | calls`".to_owned()),
    };
    let expected = Expected {
        steps: steps.split_whitespace().filter(|s| *s != "-" && *s != "!unstable").map(str::to_owned).collect(),
        stable: !steps.split_whitespace().any(|word| word == "!unstable"),
        outputs: values(outputs.split_whitespace())?,
        calls: calls.split(';').map(str::trim).filter(|c| !c.is_empty()).map(str::to_owned).collect(),
    };
    if columns[0] == "shows" {
        return Ok(Kind::Shows(expected));
    }
    let (forced, words): (Vec<&str>, Vec<&str>) =
        columns[0].split_whitespace().partition(|word| word.starts_with("force("));
    let (times, inputs): (Vec<&str>, Vec<&str>) = words.into_iter().partition(|word| word.starts_with('@'));
    if let Some(time) = times.first() {
        *now = time[1..].parse().map_err(|error| format!("`{time}`: {error}"))?;
    }
    let inputs = values(inputs.into_iter())?;
    let Some(forced) = forced.first() else { return Ok(Kind::Cycle { inputs, now: *now, expected }) };
    let list = forced["force(".len()..].strip_suffix(')').ok_or_else(|| format!("`{forced}`: `force(A,B)`"))?;
    Ok(Kind::Force { asked: Asked::read(list)?, inputs, now: *now, expected })
}

/// `on level=5`; `-` stands for nothing. What is zero is as good as not named.
fn values<'t>(words: impl Iterator<Item = &'t str>) -> Result<BTreeMap<String, i128>, String> {
    let mut values = BTreeMap::new();
    for word in words.filter(|word| *word != "-") {
        let (name, value) = word.split_once('=').unwrap_or((word, "1"));
        let value = value.parse::<i128>().map_err(|error| format!("`{word}`: {error}"))?;
        if values.insert(name.to_owned(), value).is_some() {
            return Err(format!("`{name}` stands twice"));
        }
    }
    Ok(values)
}
