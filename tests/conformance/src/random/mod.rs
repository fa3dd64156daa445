//! Well-formed random charts: the same seed is the same chart on every machine.
//!
//! Made are a chart's text and a timeline. Most are what the compiler accepts; the others are thrown away by whoever asks.

mod actions;
pub mod agree;
mod clock;
mod expr;
mod forced;
mod hierarchy;
mod inside;
mod modes;
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
    let made = made(seed, grafcet, cycles);
    // A chart of both dialects is compared with itself.
    if seed % 16 == 15 {
        return made;
    }
    let made = if seed % 6 == 1 { forced::by_hand(made, seed) } else { made };
    if seed % 7 == 2 { modes::held(made, seed) } else { made }
}

fn made(seed: u64, grafcet: bool, cycles: usize) -> Random {
    if seed % 16 == 15 {
        return agree::chart(seed, grafcet, cycles);
    }
    if grafcet && seed % 8 == 3 {
        return hierarchy::chart(seed, cycles);
    }
    if let Some(turn) = small_turn(seed) {
        return small::chart(seed, turn, grafcet, cycles);
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
        of_one: false,
        real: BTreeSet::new(),
        late: BTreeMap::new(),
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

/// Three in eight are small, each kind in its turn.
fn small_turn(seed: u64) -> Option<u64> {
    let place = [2, 4, 6].iter().position(|place| seed % 8 == *place)?;
    Some(seed / 8 * 3 + place as u64)
}

/// What has to be compared in a dialect, by name: all kinds of small charts, and of the large ones the words of the language that
/// are not in every second chart.
pub fn kinds(grafcet: bool) -> impl Iterator<Item = &'static str> {
    const BOTH: [&str; 22] = [
        "AND-convergence into AND-divergence",
        "AND-convergence with alternatives",
        "any",
        "any beside parallel branches",
        "blink",
        "blink of its own step",
        "chart of both dialects",
        "else",
        "encoding flags",
        "enum read",
        "forceable",
        "forceable with flags",
        "late",
        "modes",
        "modes and forceable",
        "modes beside any",
        "modes beside else",
        "named condition read",
        "named condition with a delay",
        "named condition with an edge",
        "sequence by inputs that hold together",
        "sequence by time",
    ];
    const GRAFCET: [&str; 9] = [
        "enclosing or macro-step inside another",
        "force {*}",
        "force {INIT}",
        "force {S}",
        "force {}",
        "machine of partial grafcets",
        "modes of a partial grafcet",
        "source transition",
        "variable of a macro-step",
    ];
    const SFC: [&str; 4] = ["DS", "SD", "SL", "P"];
    let own: &[&str] = if grafcet { &GRAFCET } else { &SFC };
    small::KINDS.iter().map(|kind| kind.name).chain(BOTH).chain(own.iter().copied())
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
    /// What is written belongs to one step, since whose activation something may blink.
    of_one: bool,
    /// The names of all steps but macro-steps.
    real: BTreeSet<String>,
    /// Those of them that have a time, which a condition asks for.
    late: BTreeMap<String, String>,
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
