//! Any tokens into the compiler: no panic, no hang, and what comes out is Rust, the same each time.
//!
//! ```sh
//! cargo xtask fuzz compile 600
//! ```
//!
//! Without a sanitizer: the compiler has no `unsafe`, and it is three times as fast.

#![no_main]

use grafcet_compiler::compile;
use libfuzzer_sys::fuzz_target;
use quote::quote;

#[path = "../../grafcet-compiler/tests/parse/generator/mod.rs"]
mod generator;

fuzz_target!(|bytes: &[u8]| {
    let tokens = generator::tokens(bytes);
    let out = compile(&quote!(::grafcet), tokens.clone());
    if let Err(error) = syn::parse2::<syn::File>(out.clone()) {
        panic!("{error}\n{tokens}\n{out}");
    }
    let again = compile(&quote!(::grafcet), tokens.clone());
    assert_eq!(out.to_string(), again.to_string(), "{tokens}");
    drop((tokens, out, again));
    // Otherwise every text ever parsed stays in memory, for its line numbers.
    proc_macro2::extra::invalidate_current_thread_spans();
});
