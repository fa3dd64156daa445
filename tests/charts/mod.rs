//! The charts in a piece of Rust, for tests that ask the compiler without rustc.

use proc_macro2::{TokenStream, TokenTree};

/// What stands in each `grafcet! { … }` of a file.
pub(crate) fn charts(rust: &str) -> Vec<TokenStream> {
    let tokens: Vec<_> = rust.parse::<TokenStream>().expect("a piece of Rust").into_iter().collect();
    let calls = tokens.windows(3).filter_map(|window| match window {
        [TokenTree::Ident(name), TokenTree::Punct(bang), TokenTree::Group(chart)]
            if name == "grafcet" && bang.as_char() == '!' =>
        {
            Some(chart.stream())
        }
        _ => None,
    });
    calls.collect()
}

/// What the macro makes of a chart.
pub(crate) fn expand(chart: TokenStream) -> TokenStream {
    grafcet_compiler::compile(&"::grafcet".parse().expect("a path"), chart)
}
