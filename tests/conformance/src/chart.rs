//! From the text of a chart to its model, by the compiler's own way.

use grafcet_compiler::diagnostic::{Diagnostic, Severity, Sink};
use grafcet_compiler::model::Model;
use grafcet_compiler::{Wanted, diagnose, model, parse};
use proc_macro2::TokenStream;

/// The model of a chart that the macro compiles, with fragments as they are meant.
///
/// # Errors
/// What the compiler says about the chart.
pub fn resolve(text: &str) -> Result<Model, String> {
    let tokens: TokenStream = super::fragments::plain(text).parse().map_err(|error| format!("tokens: {error}"))?;
    let said = diagnose(tokens, Wanted::default());
    let errors: Vec<String> = said.iter().filter(|one| one.severity == Severity::Deny).map(shown).collect();
    if !errors.is_empty() {
        return Err(errors.join("\n  "));
    }
    // What the macro accepts resolves without a mistake; names of conditions are written out here, so that the interpreter does not
    // lean on how the compiler does it.
    let text = super::fragments::written_out(&super::fragments::plain(text));
    let tokens: TokenStream = text.parse().map_err(|error| format!("tokens: {error}"))?;
    let mut sink = Sink::new();
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink));
    _ = sink.finish();
    model.ok_or_else(|| "no chart".to_owned())
}

/// What a mistake says at its first mark, with the name of its rule.
fn shown(one: &Diagnostic) -> String {
    let message = one.notes.first().map_or("refused", |(_, message)| message);
    one.rule.map_or_else(|| message.to_owned(), |rule| format!("{message} [grafcet::{}]", rule.name))
}

/// The messages in generated code: it is the only way to see exactly what the macro refuses.
#[must_use]
pub fn errors(generated: &str) -> Vec<String> {
    let parts = generated.split("compile_error").skip(1);
    parts.map(|part| part.split('"').nth(1).unwrap_or("refused").to_owned()).collect()
}
