//! A number that tells charts apart, for whoever stores what a chart did and reads it later.

use crate::list::List;
use crate::plant::chart_of;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// The fingerprint of a chart: it follows from its tokens, but for comments and the plants of its call. Blanks and line ends do not matter.
#[must_use]
pub fn of(chart: &TokenStream) -> u32 {
    let mut hash = Hash::new();
    hash.tokens(chart_of(chart));
    hash.finish()
}

/// FNV-1a of 64 bits, both halves of which make the number.
pub(crate) struct Hash(u64);

impl Hash {
    pub(crate) const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// A word, so that two of them are not one.
    pub(crate) fn word(&mut self, word: &str) {
        for byte in word.bytes().chain([0]) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    pub(crate) fn finish(&self) -> u32 {
        let half = |number: u64| u32::try_from(number & u64::from(u32::MAX)).unwrap_or(0);
        half(self.0) ^ half(self.0 >> 32)
    }

    /// Word by word. What a macro passes on in a group without delimiters is what it would be without the group.
    pub(crate) fn tokens(&mut self, tokens: TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        while let Some(token) = tokens.next() {
            match token {
                TokenTree::Punct(punct) if punct.as_char() == '#' && tokens.peek().is_some_and(is_doc) => {
                    tokens.next();
                }
                TokenTree::Punct(punct) => self.word(punct.as_char().encode_utf8(&mut [0; 4])),
                TokenTree::Ident(name) => self.word(&name.to_string()),
                TokenTree::Literal(literal) => self.word(&literal.to_string()),
                TokenTree::Group(group) => {
                    let (open, close) = match group.delimiter() {
                        Delimiter::Parenthesis => ("(", ")"),
                        Delimiter::Brace => ("{", "}"),
                        Delimiter::Bracket => ("[", "]"),
                        Delimiter::None => {
                            self.tokens(group.stream());
                            continue;
                        }
                    };
                    self.word(open);
                    self.tokens(group.stream());
                    self.word(close);
                }
            }
        }
    }
}

/// Tokens without a path, wherever it stands in them: how a program calls a crate says nothing about a chart.
pub(crate) fn without(tokens: TokenStream, path: &[TokenTree]) -> TokenStream {
    let same = |(one, other): (&TokenTree, &TokenTree)| one.to_string() == other.to_string();
    let mut rest = &tokens.into_iter().list()[..];
    let mut kept = TokenStream::new();
    while let Some((first, after)) = rest.split_first() {
        if !path.is_empty() && rest.len() >= path.len() && rest.iter().zip(path).all(same) {
            rest = &rest[path.len()..];
            continue;
        }
        kept.extend([match first {
            TokenTree::Group(group) => Group::new(group.delimiter(), without(group.stream(), path)).into(),
            other => other.clone(),
        }]);
        rest = after;
    }
    kept
}

/// `[doc = "…"]`, which is what a comment of documentation is.
fn is_doc(token: &TokenTree) -> bool {
    let TokenTree::Group(group) = token else { return false };
    let first = group.stream().into_iter().next();
    group.delimiter() == Delimiter::Bracket && matches!(first, Some(TokenTree::Ident(name)) if name == "doc")
}

#[cfg(test)]
mod tests {
    use super::of;

    fn fingerprint(source: &str) -> u32 {
        of(&source.parse().expect("tokens"))
    }

    #[test]
    fn plants_do_not_matter() {
        let chart = "sfc A { input x: bool; output y: bool; initial step B { y; } step C; B -[x]-> C -[!x]-> B; }";
        let plant = "plant P { input y: bool; output x: bool; initial step D; step E1 { x; } D -[y]-> E1 -[!y]-> D; }";
        assert_eq!(fingerprint(chart), fingerprint(&format!("{chart} {plant}")));
        assert_eq!(fingerprint(chart), fingerprint(&format!("{chart} #[cfg(test)] pub {plant}")));
    }

    #[test]
    fn blanks_and_comments_do_not_matter() {
        let one = fingerprint("sfc A { step B { N c; } }");
        assert_eq!(one, fingerprint("/// A chart.\nsfc A{step B\n{ /* here */ N c ;}}"));
        assert_eq!(one, fingerprint("#[doc = \"A chart.\"] sfc A { step B { N c; } }"));
    }

    #[test]
    fn everything_else_does() {
        let charts =
            ["a b", "ab", "a, b", "(a b)", "[a b]", "{a b}", "a (b)", "b a", "#[allow(x)] a b", "a b 1", "a b 2"];
        let mut found = charts.map(fingerprint);
        found.sort_unstable();
        assert!(found.windows(2).all(|pair| pair[0] != pair[1]));
    }
}
