//! What the fuzzer does for minutes, done for a moment with a fixed seed.

use grafcet_compiler::compile;
use quote::quote;

use crate::generator;

/// A linear congruential generator: the same bytes on every machine.
struct Random(u64);

impl Random {
    fn bytes(&mut self) -> Vec<u8> {
        let length = self.next() % 400;
        (0..length).map(|_| self.next().to_le_bytes()[0]).collect()
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }
}

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
