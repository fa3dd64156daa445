//! Words, numbers and signs of IEC 61131-3, with their places.

use super::Wrong;
use super::source::Span;

#[derive(Clone, PartialEq, Debug)]
pub(super) enum Token {
    /// A keyword, a name, or an address as `%IX0.0`.
    Word(String),
    Int(i128),
    /// As it is written, without underscores.
    Real(String),
    /// In nanoseconds.
    Time(u64),
    Text(String),
    Sign(&'static str),
}

/// `(* … *)`, or `/* … */` since the third edition of the standard: what stands after its beginning, its beginning and its end.
fn block_comment(text: &str) -> Option<(&str, &'static str, &'static str)> {
    let pairs = [("(*", "*)"), ("/*", "*/")];
    pairs.into_iter().find_map(|(open, close)| text.strip_prefix(open).map(|inside| (inside, open, close)))
}

/// How long a comment is that may have others in it, as the third edition lets them; none where they do not all end: before it, the first end was that of
/// the whole.
fn nested(inside: &str, open: &str, close: &str) -> Option<usize> {
    let (mut depth, mut at) = (1, 0);
    while let Some(next) = inside[at..].find(['(', '*', '/']) {
        at += next;
        let rest = &inside[at..];
        if rest.starts_with(close) {
            depth -= 1;
            if depth == 0 {
                return Some(at);
            }
            at += 2;
        } else if rest.starts_with(open) {
            depth += 1;
            at += 2;
        } else {
            at += 1;
        }
    }
    None
}

/// Tokens with their places, and comments with theirs.
pub(super) struct Lexed {
    pub(super) tokens: Vec<(Token, Span)>,
    pub(super) comments: Vec<(String, Span)>,
}

/// Two letters first.
const SIGNS: [&str; 28] = [
    ":=", "=>", "<>", "!=", "==", "<=", ">=", "..", "**", ":", ";", ",", "(", ")", "[", "]", ".", "=", "<", ">", "+",
    "-", "*", "/", "&", "#", "^", "@",
];

/// `offset` is where the text begins in its file.
pub(super) fn lex(text: &str, offset: usize) -> Result<Lexed, Wrong> {
    let mut lexer = Lexer { text, at: 0, offset, done: Lexed { tokens: Vec::new(), comments: Vec::new() } };
    while lexer.skip()? {
        let start = lexer.at;
        let token = lexer.token()?;
        lexer.done.tokens.push((token, offset + start..offset + lexer.at));
    }
    Ok(lexer.done)
}

struct Lexer<'t> {
    text: &'t str,
    at: usize,
    offset: usize,
    done: Lexed,
}

impl<'t> Lexer<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn wrong(&self, start: usize, message: impl Into<String>) -> Wrong {
        let end = self.rest().chars().next().map_or(self.at, |letter| self.at + letter.len_utf8());
        Wrong { at: self.offset + start..self.offset + end, message: message.into() }
    }

    /// Blanks and comments; false at the end.
    fn skip(&mut self) -> Result<bool, Wrong> {
        loop {
            self.at += self.rest().len()
                - self.rest().trim_start_matches(|letter: char| letter.is_whitespace() || letter == '\u{feff}').len();
            let start = self.at;
            let rest = self.rest();
            let (inside, end) = if let Some(line) = rest.strip_prefix("//") {
                let length = line.find('\n').unwrap_or(line.len());
                (&line[..length], start + 2 + length)
            } else if let Some((inside, open, close)) = block_comment(rest) {
                let Some(length) = nested(inside, open, close).or_else(|| inside.find(close)) else {
                    return Err(self.wrong(start, format!("this comment has no end `{close}`")));
                };
                (&inside[..length], start + 2 + length + 2)
            } else if rest.starts_with('{') {
                // A pragma says nothing to people; Beremiz has code of C between two braces.
                let end = if rest.starts_with("{{") { "}}" } else { "}" };
                let Some(length) = rest.find(end) else {
                    return Err(self.wrong(start, format!("this pragma has no end `{end}`")));
                };
                self.at = start + length + end.len();
                continue;
            } else {
                return Ok(!rest.is_empty());
            };
            self.done.comments.push((inside.trim().to_owned(), self.offset + start..self.offset + end));
            self.at = end;
        }
    }

    fn token(&mut self) -> Result<Token, Wrong> {
        let first = self.rest().chars().next().unwrap_or_default();
        if first.is_alphabetic() || first == '_' || first == '%' {
            return self.word();
        }
        if first.is_ascii_digit() {
            return self.number();
        }
        if first == '\'' || first == '"' {
            let start = self.at;
            let Some(length) = self.rest()[1..].find(first) else {
                return Err(self.wrong(start, "this text has no end"));
            };
            let inside = self.rest()[1..=length].to_owned();
            self.at += length + 2;
            return Ok(Token::Text(inside));
        }
        match SIGNS.into_iter().find(|sign| self.rest().starts_with(sign)) {
            Some(sign) => {
                self.at += sign.len();
                Ok(Token::Sign(sign))
            }
            None => Err(self.wrong(self.at, format!("`{first}` is no sign of IEC 61131-3"))),
        }
    }

    fn taken(&mut self, is: impl Fn(char) -> bool) -> &'t str {
        let length = self.rest().find(|letter| !is(letter)).unwrap_or(self.rest().len());
        let taken = &self.rest()[..length];
        self.at += length;
        taken
    }

    fn word(&mut self) -> Result<Token, Wrong> {
        let start = self.at;
        if self.rest().starts_with('%') {
            let address = self.taken(|letter| letter.is_alphanumeric() || "%.*".contains(letter));
            return Ok(Token::Word(address.to_owned()));
        }
        let word = self.taken(|letter| letter.is_alphanumeric() || letter == '_').to_owned();
        if !self.rest().starts_with('#') {
            return Ok(Token::Word(word));
        }
        self.at += 1;
        if ["t", "time", "lt", "ltime"].contains(&&*word.to_lowercase()) {
            let minus = self.rest().starts_with('-');
            let text = self.taken(|letter| letter.is_ascii_alphanumeric() || "._".contains(letter));
            return match nanos(text) {
                Some(time) if !minus => Ok(Token::Time(time)),
                _ => Err(self.wrong(start, "this is no time that can be waited for, as `T#1m30s`")),
            };
        }
        // `INT#5`, `BOOL#TRUE`: the type follows from what it stands beside. Not so with the value of an enum, `Mode#Auto`.
        match self.rest().chars().next() {
            Some(next) if next.is_ascii_digit() => self.number(),
            Some('-') => {
                self.at += 1;
                match self.number()? {
                    Token::Int(value) => Ok(Token::Int(-value)),
                    Token::Real(value) => Ok(Token::Real(format!("-{value}"))),
                    _ => Err(self.wrong(start, "this is no number")),
                }
            }
            Some(next) if next.is_alphabetic() && word.eq_ignore_ascii_case("bool") => self.word(),
            Some(next) if next.is_alphabetic() || next == '_' => {
                let value = self.taken(|letter| letter.is_alphanumeric() || letter == '_');
                Ok(Token::Word(format!("{word}#{value}")))
            }
            _ => Err(self.wrong(start, format!("after `{word}#` stands no value"))),
        }
    }

    fn number(&mut self) -> Result<Token, Wrong> {
        let start = self.at;
        let digits = self.taken(|letter| letter.is_ascii_digit() || letter == '_').replace('_', "");
        if self.rest().starts_with('#') {
            self.at += 1;
            let value = self.taken(|letter| letter.is_ascii_alphanumeric() || letter == '_').replace('_', "");
            let radix = digits.parse().ok().filter(|radix| [2, 8, 16].contains(radix));
            let value = radix.and_then(|radix| i128::from_str_radix(&value, radix).ok());
            return value.map(Token::Int).ok_or_else(|| self.wrong(start, "this is no number"));
        }
        let is_real =
            self.rest().starts_with('.') && self.rest()[1..].starts_with(|letter: char| letter.is_ascii_digit());
        if is_real {
            self.at += 1;
            let mut real =
                format!("{digits}.{}", self.taken(|letter| letter.is_ascii_digit() || letter == '_').replace('_', ""));
            if self.rest().starts_with(['e', 'E']) {
                real.push_str(self.taken(|letter| letter.is_ascii_digit() || "eE+-".contains(letter)));
            }
            return Ok(Token::Real(real));
        }
        digits.parse().map(Token::Int).map_err(|_| self.wrong(start, "this number is too large"))
    }
}

/// `1m30s`, `1.5s`, `500ms`
fn nanos(text: &str) -> Option<u64> {
    const UNITS: [(&str, f64); 7] =
        [("ms", 1e6), ("us", 1e3), ("ns", 1.0), ("d", 86_400e9), ("h", 3_600e9), ("m", 60e9), ("s", 1e9)];
    let lower = text.to_lowercase().replace('_', "");
    let (mut rest, mut all) = (&*lower, 0.0);
    while !rest.is_empty() {
        let length = rest.find(|letter: char| letter.is_ascii_alphabetic())?;
        let number: f64 = rest[..length].parse().ok()?;
        let (unit, size) = UNITS.into_iter().find(|(unit, _)| rest[length..].starts_with(unit))?;
        all += number * size;
        rest = &rest[length + unit.len()..];
    }
    // More than two hundred years are no time that a chart can wait.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is in the range")]
    (!lower.is_empty() && (0.0..6e18).contains(&all)).then(|| all.round() as u64)
}

#[cfg(test)]
mod tests {
    use super::{Token, lex, nanos};

    #[test]
    fn times() {
        assert_eq!(nanos("1m30s"), Some(90_000_000_000));
        assert_eq!(nanos("1.5S"), Some(1_500_000_000));
        assert_eq!(nanos("1d_2h"), Some(93_600_000_000_000));
        assert_eq!([nanos(""), nanos("5"), nanos("5x"), nanos("s")], [None; 4]);
    }

    #[test]
    fn tokens_of_all_kinds() {
        let lexed = lex("x1 := 16#1F + INT#3; // so\n(* and *) a.T >= T#2s AND %IX0.1", 0)
            .unwrap_or_else(|wrong| panic!("{wrong}"));
        let tokens: Vec<Token> = lexed.tokens.into_iter().map(|(token, _)| token).collect();
        let word = |text: &str| Token::Word(text.to_owned());
        let expected = [
            word("x1"),
            Token::Sign(":="),
            Token::Int(31),
            Token::Sign("+"),
            Token::Int(3),
            Token::Sign(";"),
            word("a"),
            Token::Sign("."),
            word("T"),
            Token::Sign(">="),
            Token::Time(2_000_000_000),
            word("AND"),
            word("%IX0.1"),
        ];
        assert_eq!(tokens, expected);
        let comments: Vec<&str> = lexed.comments.iter().map(|(text, _)| &**text).collect();
        assert_eq!(comments, ["so", "and"]);
    }

    /// Within each other where each has its end; of the second edition, where one does not, the first end counts.
    #[test]
    fn comments_within_comments() {
        for (text, expected) in [
            ("(* a (* b *) c *) x", &["a (* b *) c"][..]),
            ("(* a (* b *) x (* c *) y", &["a (* b", "c"]),
            ("/* a (* b */ x // c */", &["a (* b", "c */"]),
            ("/* a /* b */ c */ x (*) y *)", &["a /* b */ c", ") y"]),
        ] {
            let lexed = lex(text, 0).expect("tokens");
            let comments: Vec<&str> = lexed.comments.iter().map(|(text, _)| &**text).collect();
            assert_eq!(comments, expected, "{text}");
        }
        assert!(lex("x /* y", 0).is_err_and(|wrong| wrong.message == "this comment has no end `*/`"));
    }
}
