//! How far one word is from another.

use proc_macro2::Ident;

use crate::list::List;
use crate::raw::plain;

/// The name that was meant, where one is near enough. `S5` is not a slip of the pen for `S1`.
pub(crate) fn nearest<'n>(name: &Ident, candidates: &[&'n Ident]) -> Option<&'n Ident> {
    let plain = |name: &Ident| plain(name).to_lowercase();
    let lower = plain(name);
    // Half of a name is nearer than it looks by its letters.
    let begun = |candidate: &&&Ident| {
        let other = plain(candidate);
        lower.chars().count() >= 4
            && other.strip_prefix(&lower).is_some_and(|rest| rest.starts_with(char::is_alphabetic))
    };
    let mut beginning = candidates.iter().filter(begun);
    let only = beginning.next().filter(|_| beginning.next().is_none());
    let letters = |name: &str| name.chars().filter(|c| !c.is_numeric()).collect::<String>();
    let (own, mut best) = (lower.chars().list(), None);
    for candidate in candidates {
        let other = plain(candidate);
        let chars = other.chars().list();
        // Only what is nearer than the best so far is looked at more closely: a chart with many wrong names has many others to compare them with.
        let limit =
            best.map_or(chars.len() / 3, |(distance, _): (usize, _)| (distance.max(1) - 1).min(chars.len() / 3));
        if best.is_some_and(|(distance, _)| distance == 0) {
            break;
        }
        let Some(distance) = within(&own, &chars, limit) else { continue };
        if other == lower || letters(&other) != letters(&lower) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate).or(only).copied()
}

/// How far two words are from each other, if that is no more than a limit.
fn within(one: &[char], other: &[char], limit: usize) -> Option<usize> {
    if one.len().abs_diff(other.len()) > limit {
        return None;
    }
    let width = other.len() + 1;
    // Row by row, from the first letters of one word to the first letters of the other: two rows and the one that is made.
    let mut rows = [vec![0; width], (0..width).list(), vec![0; width]];
    for i in 1..=one.len() {
        rows[2][0] = i;
        let mut least = i;
        for j in 1..width {
            let changed = rows[1][j - 1] + usize::from(one[i - 1] != other[j - 1]);
            let mut nearest = changed.min(rows[1][j] + 1).min(rows[2][j - 1] + 1);
            if i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1] {
                nearest = nearest.min(rows[0][j - 2] + 1);
            }
            rows[2][j] = nearest;
            least = least.min(nearest);
        }
        rows.rotate_left(1);
        // Nothing after two rows is nearer than what is in one of them.
        if least > limit + 1 {
            return None;
        }
    }
    Some(rows[1][width - 1]).filter(|distance| *distance <= limit)
}

/// How many letters have to be added, left out, changed or swapped with their neighbour.
pub(crate) fn distance(one: &str, other: &str) -> usize {
    let (one, other) = (one.chars().list(), other.chars().list());
    within(&one, &other, usize::MAX - 1).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use proc_macro2::{Ident, Span};

    use super::{distance, nearest, within};

    #[test]
    fn letters_added_left_out_changed_and_swapped() {
        let far = |one, other| {
            assert_eq!(distance(one, other), distance(other, one), "{one} {other}");
            distance(one, other)
        };
        assert_eq!((far("", ""), far("", "step"), far("step", "step")), (0, 4, 0));
        assert_eq!((far("step", "stp"), far("step", "stop"), far("step", "setp")), (1, 1, 1));
        assert_eq!((far("ca", "abc"), far("äb", "bä"), far("input", "output")), (3, 1, 3));
    }

    #[test]
    fn as_far_as_a_limit() {
        let far = |one: &str, other: &str, limit| {
            within(&one.chars().collect::<Vec<_>>(), &other.chars().collect::<Vec<_>>(), limit)
        };
        assert_eq!((far("input", "output", 3), far("input", "output", 2)), (Some(3), None));
        assert_eq!((far("setp", "step", 1), far("setp", "step", 0), far("a", "level", 2)), (Some(1), None, None));
        assert_eq!((far("abcdef", "badcfe", 3), far("abcdef", "badcfe", 2)), (Some(3), None));
    }

    #[test]
    fn the_first_of_the_nearest() {
        let ident = |name: &str| Ident::new(name, Span::call_site());
        let all = ["level_1", "levels", "lever", "level", "S1"].map(ident);
        let all: Vec<_> = all.iter().collect();
        let near = |name| nearest(&ident(name), &all).map(ToString::to_string);
        assert_eq!(near("Level").as_deref(), Some("level"));
        assert_eq!(near("levelz").as_deref(), Some("levels"));
        assert_eq!((near("S5"), near("pump")), (None, None));
    }
}
