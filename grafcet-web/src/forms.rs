//! A chart in other notations: what the macro makes of it, and what `cargo grafcet export` writes.

use grafcet_compiler::diagnostic::Severity;
use grafcet_compiler::model::Model;
use grafcet_compiler::{Wanted, compile, diagnose};
use grafcet_exchange::sfc::{Exported, textual};
use grafcet_exchange::st::{Form as St, Options, structured_text};
use grafcet_exchange::{Refused, plcopen, pnml};
use grafcet_prove::export::{NoCircuit, Notation};
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
    /// The cycle as a circuit, as the prover has it.
    Aiger,
    /// The same in another notation.
    Btor2,
}

impl Form {
    /// `rust`, `case`, `flip-flops`, `sfc`, `plcopen`, `pnml`, `aiger`, `btor2`
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "rust" => Self::Rust,
            "case" => Self::Case,
            "flip-flops" => Self::FlipFlops,
            "sfc" => Self::Sfc,
            "plcopen" => Self::PlcOpen,
            "pnml" => Self::Pnml,
            "aiger" => Self::Aiger,
            "btor2" => Self::Btor2,
            _ => return None,
        })
    }

    /// How a file in it ends, as of `cargo grafcet export`.
    fn ending(self) -> &'static str {
        match self {
            Self::Rust => "rs",
            Self::Case | Self::FlipFlops | Self::Sfc => "st",
            Self::PlcOpen => "xml",
            Self::Pnml => "pnml",
            Self::Aiger => "aag",
            Self::Btor2 => "btor2",
        }
    }
}

/// So many gates and no more: a person waits for the text, and a browser shows it. `cargo grafcet export` has no such bound.
const GATES: usize = 200_000;

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
    let whole = match form {
        Form::Rust => return named(rust(&written), &written, form),
        Form::Aiger | Form::Btor2 => written.with_plants(),
        _ => written.drawn(),
    };
    let Some(model) = whole else { return refused("this is no chart yet") };
    let done = match form {
        Form::Case => st(&model, St::Case),
        Form::FlipFlops => st(&model, St::FlipFlops),
        Form::Sfc => textual(&model).map(|done| exported(&done)),
        Form::PlcOpen => plcopen::plcopen(&model, plcopen::Options::default()).map(|done| exported(&done)),
        Form::Rust | Form::Pnml => pnml::pnml(&model).map(|text| json!({ "text": text, "notes": [] })),
        Form::Aiger => circuit(&model, Notation::Aiger),
        Form::Btor2 => circuit(&model, Notation::Btor2),
    };
    done.map_or_else(
        |all| json!({ "refused": all.iter().map(|one| why(one, &Places::of(text))).collect::<Vec<_>>() }),
        |done| named(done, &written, form),
    )
}

/// With the name of the file that holds it.
fn named(mut done: Value, written: &Written, form: Form) -> Value {
    done["file"] = format!("{}.{}", written.name, form.ending()).into();
    done
}

fn circuit(model: &Model, notation: Notation) -> Result<Value, Vec<Refused>> {
    let text = grafcet_prove::export::text(model, notation, Some(GATES)).map_err(|none| {
        let more =
            if none == NoCircuit::TooLarge { " for this page; `cargo grafcet export` writes larger ones" } else { "" };
        vec![Refused { mark: None, message: format!("{none}{more}") }]
    })?;
    Ok(json!({ "text": text, "notes": [] }))
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
