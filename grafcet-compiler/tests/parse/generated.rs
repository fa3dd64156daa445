//! What the fuzzer does for minutes, done for a moment with a fixed seed.

use grafcet_compiler::compile;
use quote::quote;

use crate::generator;
use crate::random::Random;

/// No token stream makes the compiler panic, and what comes out can be parsed by rustc.
#[test]
fn whatever_comes_in_rust_comes_out() {
    let mut random = Random(24);
    let mut accepted = 0;
    for _ in 0..2000 {
        let bytes = random.bytes();
        let tokens = generator::tokens(&bytes);
        let text = tokens.to_string();
        let out = compile(&quote!(::grafcet), tokens);
        if let Err(error) = syn::parse2::<syn::File>(out.clone()) {
            panic!("{error}\n{text}\n{out}");
        }
        accepted += usize::from(!out.to_string().contains("compile_error"));
        drop(out);
        // Otherwise every text parsed so far stays in memory, for its line numbers.
        proc_macro2::extra::invalidate_current_thread_spans();
    }
    assert!(accepted > 20, "only {accepted} charts were right: the generator makes too much noise");
}
