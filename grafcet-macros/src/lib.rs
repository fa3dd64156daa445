//! The procedural macro after `grafcet::grafcet!`; use it through the crate `grafcet`.

use proc_macro2::{TokenStream, TokenTree};

/// Compiles one chart. The first token is a group with the path of the facade crate, put there by `grafcet::grafcet!`.
#[proc_macro]
#[doc(hidden)]
pub fn chart(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let mut tokens = TokenStream::from(input).into_iter();
    let root = match tokens.next() {
        Some(TokenTree::Group(path)) => path.stream(),
        _ => TokenStream::new(),
    };
    #[cfg(feature = "prove")]
    let prover: Option<&grafcet_compiler::analysis::Prover> = Some(&grafcet_prove::rule);
    #[cfg(not(feature = "prove"))]
    let prover = None;
    let wanted = grafcet_compiler::Wanted { recorded: cfg!(feature = "record"), prover };
    grafcet_compiler::compile_with(&root, tokens.collect(), wanted).into()
}
