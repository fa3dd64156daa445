//! The words of an expression, as it was written by this crate.

/// What stands in an expression.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Word<'t> {
    /// A variable, or a word of the language.
    Name(&'t str),
    /// The name of what is called.
    Called(&'t str),
    /// In front of `:=`, or after a point.
    Part(&'t str),
    /// An operator between two values.
    Operator(&'t str),
    /// Numbers, times, signs and blanks.
    Other(&'t str),
}

impl<'t> Word<'t> {
    /// As it stands there.
    pub(super) fn text(&self) -> &'t str {
        match self {
            Self::Name(text) | Self::Called(text) | Self::Part(text) | Self::Operator(text) | Self::Other(text) => text,
        }
    }
}

/// All of it, in its order.
pub(super) fn words(text: &str) -> Vec<Word<'_>> {
    let (mut all, mut at) = (Vec::new(), 0);
    // After a value a `-` is an operator.
    let mut value = false;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let length = if first.is_ascii_digit() {
            number(rest)
        } else if is_part(first) {
            // `T#1m30s` is one word.
            rest.find(|c: char| !is_part(c) && c != '#').unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (word, after) = rest.split_at(length);
        all.push(match first {
            _ if word.contains('#') || first.is_ascii_digit() => Word::Other(word),
            _ if is_part(first) && (text[..at].ends_with('.') || after.trim_start().starts_with(":=")) => {
                Word::Part(word)
            }
            _ if word == "MOD" => Word::Operator(word),
            // A word of the language can stand in front of a parenthesis, too, with a blank.
            _ if is_part(first) && after.starts_with('(') => Word::Called(word),
            _ if is_part(first) => Word::Name(word),
            '+' | '*' | '/' => Word::Operator(word),
            '-' if value => Word::Operator(word),
            _ => Word::Other(word),
        });
        if first != ' ' {
            value = (is_part(first) && !["NOT", "AND", "OR", "XOR", "MOD"].contains(&word)) || first == ')';
        }
        at += length;
    }
    all
}

/// The length of the number or time at the beginning: `2.5E-3` is one word.
fn number(text: &str) -> usize {
    let bytes = text.as_bytes();
    let is_of_it = |at: usize| match bytes[at] {
        b'.' => bytes.get(at + 1).is_some_and(u8::is_ascii_digit),
        b'+' | b'-' => bytes[at - 1] == b'E' && text[..at].contains('.'),
        other => other.is_ascii_alphanumeric() || matches!(other, b'_' | b'#'),
    };
    (0..bytes.len()).find(|at| !is_of_it(*at)).unwrap_or(bytes.len())
}

#[cfg(test)]
mod tests {
    use super::Word::{self, Called, Name, Operator, Part};
    use super::words;

    #[test]
    fn words_of_expressions() {
        let named = |text| -> Vec<Word<'_>> {
            words(text).into_iter().filter(|word| !matches!(word, Word::Other(_))).collect()
        };
        assert_eq!(
            named("T_Heat(IN := StepNo = 10, PT := T#1h30m)"),
            [Called("T_Heat"), Part("IN"), Name("StepNo"), Part("PT")]
        );
        assert_eq!(named("NOT (T_a.ET >= T#5s)"), [Name("NOT"), Name("T_a"), Part("ET")]);
        assert_eq!(named("-3 - n MOD 2"), [Operator("-"), Name("n"), Operator("MOD")]);
        assert_eq!(named("x - 2.5E-3 * 1.0E+3-4.0"), [Name("x"), Operator("-"), Operator("*"), Operator("-")]);
        assert_eq!(named("n > -3 AND -n < 2"), [Name("n"), Name("AND"), Name("n")]);
        assert_eq!(
            named("valid(level := (a + 1)) OR b"),
            [Called("valid"), Part("level"), Name("a"), Operator("+"), Name("OR"), Name("b")]
        );
    }
}
