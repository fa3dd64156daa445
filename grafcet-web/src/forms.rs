//! A chart in other notations: what the macro makes of it, and what `cargo grafcet export` writes.

use grafcet_compiler::diagnostic::Severity;
use grafcet_compiler::model::Model;
use grafcet_compiler::{Wanted, compile, diagnose};
use grafcet_exchange::sfc::{Exported, textual};
use grafcet_exchange::st::{Form as St, Options, structured_text};
use grafcet_exchange::{Refused, plcopen, pnml};
use quote::quote;
use serde_json::{Value, json};

use crate::text::{Places, Written};

/// A notation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// What the macro expands to.
    Rust,
    /// Structured text, one `CASE` over the active step.
    Case,
    /// Structured text, a flip-flop for each step.
    FlipFlops,
    /// SFC of IEC 61131-3 as text.
    Sfc,
    /// SFC as a drawing, for tools that read it.
    PlcOpen,
    /// A Petri net.
    Pnml,
}

impl Form {
    /// `rust`, `case`, `flip-flops`, `sfc`, `plcopen`, `pnml`
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "rust" => Self::Rust,
            "case" => Self::Case,
            "flip-flops" => Self::FlipFlops,
            "sfc" => Self::Sfc,
            "plcopen" => Self::PlcOpen,
            "pnml" => Self::Pnml,
            _ => return None,
        })
    }
}

/// The text, and what is to be known beside it; or why there is none, with places.
pub(crate) fn translate(text: &str, form: Form) -> Value {
    let written = match Written::find(text) {
        Ok(written) => written,
        Err(unread) => return refused(unread.why),
    };
    let said = diagnose(written.tokens.clone(), Wanted::default());
    let wrong = said.iter().filter(|one| one.severity == Severity::Deny && !one.is_about_a_claim()).count();
    if wrong > 0 {
        let count = if wrong == 1 { "an error".to_owned() } else { format!("{wrong} errors") };
        return refused(&format!("the chart has {count}: mend that first"));
    }
    if form == Form::Rust {
        return rust(&written);
    }
    let Some(model) = written.drawn() else { return refused("this is no chart yet") };
    let done = match form {
        Form::Case => st(&model, St::Case),
        Form::FlipFlops => st(&model, St::FlipFlops),
        Form::Sfc => textual(&model).map(|done| exported(&done)),
        Form::PlcOpen => plcopen::plcopen(&model, plcopen::Options::default()).map(|done| exported(&done)),
        Form::Rust | Form::Pnml => pnml::pnml(&model).map(|text| json!({ "text": text, "notes": [] })),
    };
    done.unwrap_or_else(
        |all| json!({ "refused": all.iter().map(|one| why(one, &Places::of(text))).collect::<Vec<_>>() }),
    )
}

fn rust(written: &Written) -> Value {
    let tokens = compile(&quote!(::grafcet), written.tokens.clone());
    match syn::parse2::<syn::File>(tokens.clone()) {
        Ok(file) => json!({ "text": prettyplease::unparse(&file), "notes": [] }),
        // Never seen; the tokens tell all the same.
        Err(_) => json!({ "text": tokens.to_string(), "notes": [] }),
    }
}

fn st(model: &Model, form: St) -> Result<Value, Vec<Refused>> {
    let done = structured_text(model, &Options { form, ..Options::default() })?;
    Ok(json!({ "text": done.text, "notes": to_write(&done.to_write) }))
}

fn exported(done: &Exported) -> Value {
    json!({ "text": done.text, "notes": to_write(&done.to_write) })
}

fn to_write(all: &[(String, String)]) -> Vec<String> {
    all.iter().map(|(name, rust)| format!("to be written by you: `{name}`, in Rust `{rust}`")).collect()
}

fn refused(why: &str) -> Value {
    json!({ "refused": [{ "text": why, "from": null, "to": null }] })
}

fn why(one: &Refused, places: &Places<'_>) -> Value {
    let at = one.mark.and_then(|mark| places.mark(mark));
    json!({ "text": one.message, "from": at.as_ref().map(|at| at.start), "to": at.map(|at| at.end) })
}
