//! What the fuzzer does for minutes, done for a moment with a fixed seed, and what it has kept.

use std::fs;
use std::path::Path;

use grafcet_compiler::compile;
use quote::quote;

use crate::generator;
use crate::random::Random;

/// What comes out, which rustc can parse.
fn compiled(bytes: &[u8]) -> String {
    let tokens = generator::tokens(bytes);
    let text = tokens.to_string();
    let out = compile(&quote!(::grafcet), tokens);
    if let Err(error) = syn::parse2::<syn::File>(out.clone()) {
        panic!("{error}\n{text}\n{out}");
    }
    let rust = out.to_string();
    drop(out);
    // Otherwise every text parsed so far stays in memory, for its line numbers.
    proc_macro2::extra::invalidate_current_thread_spans();
    rust
}

/// No token stream makes the compiler panic.
#[test]
fn whatever_comes_in_rust_comes_out() {
    let mut random = Random(24);
    let accepted = (0..2000).filter(|_| !compiled(&random.bytes()).contains("compile_error")).count();
    assert!(accepted > 20, "only {accepted} charts were right: the generator makes too much noise");
}

/// Neither does what the fuzzer has kept.
#[test]
fn the_corpus_of_the_fuzzer_finds_nothing() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus/compile");
    let files = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut asked = 0;
    for file in files {
        let bytes = fs::read(file.expect("a file").path()).expect("a file");
        assert_eq!(compiled(&bytes), compiled(&bytes), "the same each time");
        asked += 1;
    }
    assert!(asked > 10, "{asked} files");
}
