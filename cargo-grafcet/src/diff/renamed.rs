//! Which names are the same thing under another name: what is said of them is the same.

use super::words::{ACTION, TRANSITION, Words};

/// Renames in `old` what has another name in `new`, and says what that was: old and new names.
pub(crate) fn renamed(old: &mut Words, new: &Words) -> Vec<(String, String)> {
    // All that is said of it is the same; else its transitions are, or what is done in it.
    const ALIKE: [fn(&str) -> bool; 3] = [|_| true, |kind| kind == TRANSITION, |kind| kind == ACTION];
    let mut all = Vec::new();
    for counts in ALIKE {
        // What is found makes more known of its neighbours.
        loop {
            let found = pairs(old, new, counts);
            if found.is_empty() {
                break;
            }
            for (from, to) in &found {
                old.rename(from, to);
            }
            all.extend(found);
        }
    }
    all
}

/// Names that only one of them has, and of which the same is said; where several are alike, in their order.
fn pairs(old: &Words, new: &Words, counts: fn(&str) -> bool) -> Vec<(String, String)> {
    let (there, here) = (old.names(), new.names());
    let gone: Vec<&str> = there.iter().copied().filter(|name| !here.contains(name)).collect();
    let fresh: Vec<&str> = here.iter().copied().filter(|name| !there.contains(name)).collect();
    if gone.is_empty() || fresh.is_empty() {
        return Vec::new();
    }
    let (gone, fresh) = (said(old, &gone, counts), said(new, &fresh, counts));
    let mut pairs = Vec::new();
    for (place, (_, said)) in gone.iter().enumerate() {
        if said.is_empty() || gone[..place].iter().any(|(_, other)| other == said) {
            continue;
        }
        let of = |all: &[(String, Said)]| -> Vec<String> {
            all.iter().filter(|(_, other)| other == said).map(|(name, _)| name.clone()).collect()
        };
        let (from, to) = (of(&gone), of(&fresh));
        if from.len() == to.len() {
            pairs.extend(from.into_iter().zip(to));
        }
    }
    pairs
}

/// What is said of a name, line by line; it is `#` there, and all others that are not on both sides are `_`.
type Said = Vec<Vec<String>>;

fn said(words: &Words, names: &[&str], counts: fn(&str) -> bool) -> Vec<(String, Said)> {
    let facts = words.facts();
    let of = |name: &str| -> Said {
        let about = facts.iter().filter(|fact| counts(fact[0]) && fact[1..].contains(&name));
        let masked = about.map(|fact| {
            let mask = |word: &&str| match *word {
                word if word == name => "#".to_owned(),
                word if names.contains(&word) => "_".to_owned(),
                word => word.to_owned(),
            };
            fact.iter().map(mask).collect()
        });
        let mut masked: Said = masked.collect();
        masked.sort();
        masked
    };
    names.iter().map(|name| ((*name).to_owned(), of(name))).collect()
}
