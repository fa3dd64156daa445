//! From the text of a chart to its model, by the compiler's own way.

use grafcet_compiler::model::Model;
use grafcet_compiler::{check, compile, diagnostic::Sink, model, parse};
use proc_macro2::TokenStream;
use quote::quote;

/// The model of a chart that the macro compiles.
///
/// # Errors
/// What the compiler says about the chart.
pub fn resolve(text: &str) -> Result<Model, String> {
    let tokens: TokenStream = text.parse().map_err(|error| format!("tokens: {error}"))?;
    let mut sink = Sink::new();
    let model = parse::chart(tokens, &mut sink).map(|chart| {
        let model = model::resolve(&chart, &mut sink);
        check::drawing(&model, &mut sink);
        if !sink.has_errors() {
            check::not_yet(&chart, &mut sink);
            check::whole(&model, &mut sink);
        }
        model
    });
    let refused = sink.has_errors();
    let notes: Vec<String> = sink.finish().iter().flat_map(|d| &d.notes).map(|(_, text)| text.clone()).collect();
    match model {
        Some(model) if !refused => Ok(model),
        _ => Err(notes.join("\n  ")),
    }
}

/// Whether the macro compiles a chart: what it generates is no error message.
///
/// # Errors
/// The messages.
pub fn accepts(text: &str) -> Result<(), String> {
    let tokens: TokenStream = text.parse().map_err(|error| format!("tokens: {error}"))?;
    let generated = compile(&quote!(::grafcet), tokens).to_string();
    match generated.contains("compile_error") {
        true => Err(resolve(text).err().unwrap_or_else(|| "refused by the macro".to_owned())),
        false => Ok(()),
    }
}
