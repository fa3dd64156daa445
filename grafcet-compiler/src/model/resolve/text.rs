//! The user's tokens as one line of text, spaced as a person would write them.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::ToTokens;

/// `on && !over_temp`
pub(in crate::model) fn of(tokens: impl ToTokens) -> String {
    let mut text = String::new();
    write(tokens.into_token_stream(), &mut text, true);
    text
}

/// Whether `-` after `text` is a sign and no operator: `-1`, `(-1`, `n < -1`.
fn is_operand_next(text: &str, tight: bool) -> bool {
    match text.trim_end().chars().last() {
        None | Some('(' | '[' | '{' | ',' | '.' | '/') => true,
        // The second one of `&&` stands right after the first.
        Some(last) => !tight && "=<>&|+-*%^".contains(last),
    }
}

/// Whether `!` between `text` and a group calls a macro: `matches!(…)`, and not `if !(…)`.
fn is_macro(text: &str, tight: bool, next: Option<&TokenTree>) -> bool {
    let word = text.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
    let is_keyword = ["as", "else", "if", "in", "match", "move", "return", "while"].contains(&word);
    !tight && !word.is_empty() && !is_keyword && matches!(next, Some(TokenTree::Group(_)))
}

fn write(tokens: TokenStream, text: &mut String, mut tight: bool) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(tree) = tokens.next() {
        match tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{ ", " }"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                // A call or an index: `f(x)`, `m!(x)`, `a[0]`.
                let called = group.delimiter() != Delimiter::Brace
                    && text.ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | '!' | ')' | ']'));
                if !tight && !called {
                    text.push(' ');
                }
                text.push_str(open);
                write(group.stream(), text, true);
                text.push_str(close);
                tight = false;
            }
            TokenTree::Punct(punct) => {
                let c = punct.as_char();
                let prefix = matches!(c, '-' | '*' | '&') && is_operand_next(text, tight);
                let sticks =
                    matches!(c, '.' | ',' | ';' | '?' | ':') || c == '!' && is_macro(text, tight, tokens.peek());
                if !tight && !sticks {
                    text.push(' ');
                }
                text.push(c);
                tight = prefix || punct.spacing() == Spacing::Joint || matches!(c, '.' | '!' | ':' | '\'' | '#' | '/');
                // `5s/Heat` reads better without blanks, any other operator with them.
                if c == '/' {
                    let trimmed = text.trim_end_matches(" /").len();
                    if trimmed < text.len() {
                        text.truncate(trimmed);
                        text.push('/');
                    }
                }
            }
            other => {
                if !tight {
                    text.push(' ');
                }
                text.push_str(&other.to_string());
                tight = false;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::of;
    use proc_macro2::TokenStream;

    #[test]
    fn as_a_person_writes_it() {
        for text in [
            "matches!(mode, Mode::Auto | Mode::Manual) && !matches!(n, 7)",
            "if !(a && !b) { n > 2 } else { !(n > 2) }",
            "n != -1 && !near(n - 1) && all![a, b]",
        ] {
            assert_eq!(of(text.parse::<TokenStream>().expect("tokens")), text);
        }
    }
}
