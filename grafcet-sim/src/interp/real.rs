//! Floats and names, values that the arithmetic of integers knows nothing of.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::fmt;

/// A float. Unlike those of Rust two of them are equal where their bits are, so that states can be compared.
#[derive(Clone, Copy, Debug)]
pub struct Real(pub f64);

impl PartialEq for Real {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Real {}

impl PartialOrd for Real {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Real {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl Real {
    /// As a value of `f32` or `f64`.
    #[allow(clippy::cast_possible_truncation, reason = "what `f32` does")]
    pub(super) fn rounded(self, single: Option<bool>) -> Self {
        if single == Some(true) { Self(f64::from(self.0 as f32)) } else { self }
    }
}

/// A value of a type of the program that the chart knows by name alone: `Mode::Auto` without its type.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Symbol(&'static str);

thread_local! {
    /// Each name is kept once and for ever: there are as many as a program has variants.
    static KNOWN: RefCell<BTreeSet<&'static str>> = const { RefCell::new(BTreeSet::new()) };
}

impl Symbol {
    /// The variant of this path; the type in front of it does not matter.
    #[must_use]
    pub fn of(path: &str) -> Self {
        let name = path.rsplit("::").next().unwrap_or(path).trim();
        KNOWN.with_borrow_mut(|known| {
            if let Some(same) = known.get(name) {
                return Self(same);
            }
            let kept: &'static str = Box::leak(name.to_owned().into_boxed_str());
            known.insert(kept);
            Self(kept)
        })
    }

    /// The path of a variant, `Mode::Auto`, and no constant such as `u16::MAX`.
    pub(super) fn of_path(text: &str) -> Option<Self> {
        let (ty, variant) = text.rsplit_once("::")?;
        let ty = ty.rsplit("::").next()?;
        let is_word = |word: &str| word.chars().all(|c| c.is_alphanumeric() || c == '_');
        let begins = |word: &str| word.chars().next().is_some_and(char::is_uppercase);
        let constant = variant.len() > 1 && !variant.chars().any(char::is_lowercase);
        (is_word(ty) && is_word(variant) && begins(ty) && begins(variant) && !constant).then(|| Self::of(variant))
    }

    /// The name.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.0
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}
