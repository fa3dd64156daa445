//! `naive! { sfc Motor { … } }` is what `grafcet::grafcet!` would be if its cycle were printed from a program; `optimised!`
//! the same after all passes.

use grafcet_compiler::program::naive as lowered;
use grafcet_compiler::program::passes::{Pass, optimise};
use grafcet_compiler::{Lower, compile_program};
use proc_macro::TokenStream;

/// A chart by its naive program.
#[proc_macro]
pub fn naive(chart: TokenStream) -> TokenStream {
    expand(chart, lowered)
}

/// A chart by its program after all passes.
#[proc_macro]
pub fn optimised(chart: TokenStream) -> TokenStream {
    expand(chart, |model, facts| {
        let mut program = lowered(model, facts)?;
        optimise(&mut program, &Pass::ALL);
        Ok(program)
    })
}

fn expand(chart: TokenStream, lower: Lower) -> TokenStream {
    let root = "::grafcet".parse::<TokenStream>().unwrap_or_default();
    compile_program(&root.into(), chart.into(), lower).into()
}
