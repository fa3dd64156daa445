//! Well-formed random charts: the same seed is the same chart on every machine.
//!
//! Made are a chart's text and a timeline. Most are what the compiler accepts; the others are thrown away by whoever asks.

mod actions;
pub mod agree;
mod expr;
mod hierarchy;
mod names;
mod rng;
mod small;
mod structure;
mod timed;
mod timeline;
mod write;

use std::collections::{BTreeMap, BTreeSet};

use self::names::Names;
pub use self::rng::Rng;

/// A chart and what happens to it.
pub struct Random {
    /// What would stand inside `grafcet! { … }`.
    pub chart: String,
    /// One line for each event, as in the corpus, with nothing expected.
    pub timeline: String,
    /// What of the language is in it.
    pub features: BTreeSet<&'static str>,
}

/// Makes a chart of a dialect from a seed, with a timeline of so many cycles.
#[must_use]
pub fn chart(seed: u64, grafcet: bool, cycles: usize) -> Random {
    if seed % 16 == 15 {
        return agree::chart(seed, grafcet, cycles);
    }
    if grafcet && seed % 8 == 3 {
        return hierarchy::chart(seed, cycles);
    }
    if seed % 4 == 2 {
        return small::chart(seed, grafcet, cycles);
    }
    if seed % 8 == 5 {
        return timed::chart(seed, grafcet, cycles);
    }
    let mut generator = Gen {
        rng: Rng::new(seed),
        grafcet,
        names: Names::default(),
        steps: Vec::new(),
        count: 0,
        crowded: false,
        fragments: false,
        writers: BTreeMap::new(),
        features: BTreeSet::new(),
    };
    generator.crowded = generator.rng.chance(30);
    generator.fragments = generator.rng.chance(25);
    generator.declare();
    let parts = generator.structure();
    let chart = generator.write(&parts);
    let timeline = generator.timeline(cycles);
    Random { chart, timeline, features: generator.features }
}

/// The state of the making.
struct Gen {
    rng: Rng,
    grafcet: bool,
    names: Names,
    /// All steps and macro-steps with the partial grafcet they stand in.
    steps: Vec<(Option<String>, String)>,
    /// How many names of steps and partial grafcets have been given.
    count: usize,
    /// Several actions write a place; where they race, the compiler refuses the chart.
    crowded: bool,
    /// Parts of it come from fragments of `macro_rules!`.
    fragments: bool,
    /// How many stored actions of a `grafcet` write a place.
    writers: BTreeMap<String, usize>,
    features: BTreeSet<&'static str>,
}

impl Gen {
    fn note(&mut self, feature: &'static str) {
        self.features.insert(feature);
    }

    /// The text itself, or a fragment that holds it: `e` an expression, `t` a type, `l` a literal, `b` a block.
    fn fragment(&mut self, kind: char, text: String) -> String {
        if self.is_fragment(kind) { format!("frag_{kind}!({text})") } else { text }
    }

    /// An expression that is a whole: in parentheses, or a fragment.
    fn whole(&mut self, mut text: String) -> String {
        text.insert_str(0, if self.is_fragment('e') { "frag_e!(" } else { "(" });
        text.push(')');
        text
    }

    fn is_fragment(&mut self, kind: char) -> bool {
        let is = self.fragments && self.rng.chance(30);
        if is {
            self.note(match kind {
                'e' => "fragment: expression",
                't' => "fragment: type",
                'l' => "fragment: literal",
                _ => "fragment: block",
            });
        }
        is
    }

    /// Whether one more stored action may write a place: two that could do it in one evolution are a mistake (A7).
    fn may_write(&mut self, name: &str, most: usize) -> bool {
        let count = self.writers.entry(name.to_owned()).or_default();
        *count += 1;
        !self.grafcet || *count <= most + 2 * usize::from(self.crowded)
    }
}
