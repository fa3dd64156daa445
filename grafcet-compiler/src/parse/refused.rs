//! Names that are keywords of Rust. Their declaration is refused, and nothing more is said where they are read.

use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::TokenStreamExt;

use super::input::Turns;
use super::{Input, words};

/// The keywords that the call declares as names. `call` is an input of it.
pub(super) fn keywords(call: &Input) -> Vec<String> {
    let mut keywords = Vec::new();
    for mut input in call.everywhere() {
        let Some(item) = input.word().filter(|_| words::item_begins(&input)) else { continue };
        input.bump();
        let (mut names, mut turns) = (Vec::new(), Turns::default());
        while turns.more(&input) {
            names.extend(input.word().filter(|name| is_keyword(name)));
            input.bump();
            input.eat(",");
            if input.word().is_none() {
                break;
            }
        }
        // Without a type it may be anything: `output as u8`.
        let declares = match item {
            "input" | "output" | "var" | "param" => input.at(":"),
            "let" | "step" | "action" => true,
            _ => false,
        };
        if declares {
            keywords.extend(names.into_iter().map(str::to_owned));
        }
    }
    keywords
}

/// Whether a name can be it where it is written raw alone.
fn is_keyword(word: &str) -> bool {
    !["self", "Self", "super", "crate", "_"].contains(&word) && syn::parse_str::<Ident>(word).is_err()
}

/// A piece of Rust with these keywords written raw; `None` where none of them stands in it.
pub(super) fn raw(piece: TokenStream, keywords: &[String]) -> Option<TokenStream> {
    let (mut tokens, mut changed) = (TokenStream::new(), false);
    for tree in piece {
        tokens.append(match tree {
            TokenTree::Ident(name) if keywords.iter().any(|keyword| name == keyword) => {
                changed = true;
                Ident::new_raw(&name.to_string(), name.span()).into()
            }
            TokenTree::Group(group) => match raw(group.stream(), keywords) {
                Some(inside) => {
                    changed = true;
                    let mut rebuilt = Group::new(group.delimiter(), inside);
                    rebuilt.set_span(group.span());
                    TokenTree::from(rebuilt)
                }
                None => group.into(),
            },
            tree => tree,
        });
    }
    changed.then_some(tokens)
}
