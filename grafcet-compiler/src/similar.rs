//! How far one word is from another.

use proc_macro2::Ident;

use crate::list::List;

/// The name that was meant, where one is near enough. `S5` is not a slip of the pen for `S1`.
pub(crate) fn nearest<'n>(name: &Ident, candidates: &[&'n Ident]) -> Option<&'n Ident> {
    let plain = |name: &Ident| name.to_string().trim_start_matches("r#").to_lowercase();
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
    candidates
        .iter()
        .map(|candidate| (plain(candidate), candidate))
        .filter(|(other, _)| *other == lower || letters(other) != letters(&lower))
        .map(|(other, candidate)| (distance(&lower, &other), other.chars().count(), candidate))
        .filter(|(distance, length, _)| *distance <= length / 3)
        .min_by_key(|(distance, ..)| *distance)
        .map(|(.., candidate)| candidate)
        .or(only)
        .copied()
}

/// How many letters have to be added, left out, changed or swapped with their neighbour.
pub(crate) fn distance(one: &str, other: &str) -> usize {
    let (one, other) = (one.chars().list(), other.chars().list());
    // Row by row, from the first letters of one word to the first letters of the other.
    let mut table = vec![vec![0; other.len() + 1]; one.len() + 1];
    for i in 0..=one.len() {
        for j in 0..=other.len() {
            if i == 0 || j == 0 {
                table[i][j] = i + j;
                continue;
            }
            let changed = table[i - 1][j - 1] + usize::from(one[i - 1] != other[j - 1]);
            let mut nearest = changed.min(table[i - 1][j] + 1).min(table[i][j - 1] + 1);
            if i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1] {
                nearest = nearest.min(table[i - 2][j - 2] + 1);
            }
            table[i][j] = nearest;
        }
    }
    table[one.len()][other.len()]
}

#[cfg(test)]
mod tests {
    use super::distance;

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
}
