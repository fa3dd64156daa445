//! How near two words are to each other, for "did you mean".

/// How many slips of the pen lead from one word to the other: a letter too many, a letter missing, another letter, or two
/// neighbours in the wrong order.
pub(crate) fn slips(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    // In row `i` at `j`: from the first `i` letters of one word to the first `j` of the other.
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let other = usize::from(a[i - 1] != b[j - 1]);
            let mut least = (rows[i - 1][j - 1] + other).min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::slips;

    #[test]
    fn each_slip_counts_once() {
        for (a, b, expected) in [
            ("", "", 0),
            ("", "sfc", 3),
            ("sfc", "", 3),
            ("motor", "motor", 0),
            ("motor", "moter", 1),
            ("motor", "mottor", 1),
            ("motor", "moto", 1),
            ("motor", "omtor", 1),
            ("motor", "omtro", 2),
            ("über", "uber", 1),
            ("kitten", "sitting", 3),
            // What was turned round is not changed again: otherwise it would be 2.
            ("ca", "abc", 3),
        ] {
            assert_eq!((slips(a, b), slips(b, a)), (expected, expected), "{a}, {b}");
        }
    }
}
