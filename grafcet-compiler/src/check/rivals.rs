//! Conflicts of two, of which several belong together: each pair is told once.

use super::targets;
use crate::diagnostic::{Mark, Rule, Severity, Sink};
use crate::list::List;
use crate::model::{Dialect, LevelAttr, Model, Name};
use crate::sorted::{Map, Set, sort};

/// More rivals are counted, not named.
const NAMED: usize = 4;

/// The pairs that break one rule, by the numbers of those who take part; the smaller number first.
pub(super) struct Rivals {
    rule: &'static Rule,
    dialect: Dialect,
    denied: Vec<(usize, usize)>,
    warned: Vec<(usize, usize)>,
}

impl Rivals {
    pub(super) fn new(rule: &'static Rule, dialect: Dialect) -> Self {
        Self { rule, dialect, denied: Vec::new(), warned: Vec::new() }
    }

    /// `scopes` are as in [`Sink::rule`].
    pub(super) fn add(&mut self, first: usize, second: usize, scopes: &[&[LevelAttr]]) {
        let pairs = match self.rule.severity_in(self.dialect, scopes) {
            Severity::Deny => &mut self.denied,
            Severity::Warn => &mut self.warned,
            Severity::Allow => return,
        };
        pairs.push((first, second));
    }

    /// An error is marked at each of them, with all its rivals; a warning at the later one of a pair. `note` tells of one, given
    /// its rivals.
    pub(super) fn report(mut self, sink: &mut Sink, note: impl Fn(usize, &[usize]) -> (Mark, String)) {
        self.denied.extend_from_within(..);
        let half = self.denied.len() / 2;
        self.denied[half..].iter_mut().for_each(|(a, b)| std::mem::swap(a, b));
        let denied = by_first(self.denied);
        let mut told: Set<usize> = Set::new();
        for (one, _) in &denied {
            if told.contains(one) {
                continue;
            }
            // All that hang together.
            let (mut group, mut at) = (Set::from([*one]), vec![*one]);
            while let Some(next) = at.pop() {
                at.extend(denied.get(&next).into_iter().flatten().filter(|other| group.insert(**other)));
            }
            let notes = group.iter().filter_map(|one| Some(note(*one, denied.get(one)?))).list();
            sink.broken(self.rule, Severity::Deny, notes);
            told.extend(group);
        }
        for (later, others) in &by_first(self.warned.into_iter().map(|(first, second)| (second, first)).list()) {
            sink.broken(self.rule, Severity::Warn, vec![note(*later, others)]);
        }
    }
}

/// The second ones of each first one, each once and in order.
fn by_first(mut pairs: Vec<(usize, usize)>) -> Map<usize, Vec<usize>> {
    sort(&mut pairs);
    pairs.dedup();
    let mut all: Map<usize, Vec<usize>> = Map::new();
    for (first, second) in pairs {
        all.or_default(first).push(second);
    }
    all
}

/// How it is said that conditions exclude each other which ask for the variants of an enum.
pub(super) fn list_them(model: &Model, name: Name) -> String {
    let (word, ident) = match name {
        Name::Input(id) => ("input", &model.inputs[id].name),
        Name::Output(id) => ("output", &model.outputs[id].name),
        Name::Var(id) => ("var", &model.vars[id].name),
        Name::Param(id) => ("param", &model.params[id].name),
    };
    let ty = targets::text_of(model.ty(name));
    format!("; if the variants of `{ident}` keep them apart, list them: `{word} {ident}: {ty} in {{…}};`")
}

/// `a`, `a and b`, `a, b and c`, `a, b, c, d and 3 more`.
pub(super) fn listed(all: &[String]) -> String {
    let (named, rest) = all.split_at(all.len().min(NAMED));
    match (named, rest.len()) {
        ([one], 0) => one.clone(),
        ([first @ .., last], 0) => format!("{} and {last}", first.join(", ")),
        (_, more) => format!("{} and {more} more", named.join(", ")),
    }
}
