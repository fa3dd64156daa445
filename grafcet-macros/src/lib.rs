//! The procedural macro behind `grafcet::grafcet!`; use it through the crate `grafcet`.

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
    let compile = if cfg!(feature = "record") { grafcet_compiler::compile_recorded } else { grafcet_compiler::compile };
    compile(&root, tokens.collect()).into()
}
