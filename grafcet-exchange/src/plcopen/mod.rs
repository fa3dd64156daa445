//! PLCopen XML, which CODESYS, Beremiz and others open: the chart as a drawing of SFC, in the version TC6 2.01 of PLCopen or as IEC 61131-10 has it.
//!
//! - `place`: where steps and transitions stand, which `grafcet-draw` finds
//! - `network`: what lies between them: divergences, convergences, jumps, and who is connected with whom
//! - `tc6`, `part10`: the file around the chart and its elements, as the edition writes them
//! - `xml`: elements as text

mod network;
mod part10;
mod place;
mod tc6;
mod xml;

use grafcet_compiler::model::Model;

use crate::Refused;
use crate::sfc::{Exported, build, classic};
use crate::st::syntax::{Stub, statements};
use network::{Back, network};

/// The same chart gives the same file, so it says no time of its own.
const DATE: &str = "2000-01-01T00:00:00";

/// Which XML it is.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Edition {
    /// TC6 2.01 of PLCopen, which most tools read.
    #[default]
    Tc6,
    /// The first edition of IEC 61131-10. It knows no jumps, so that lines lead back.
    Iec61131Part10,
}

/// What kind of drawing is wanted.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Options {
    /// What is done in each scan stands at a step of its own that is always active, in a network beside the chart; else the initial step sets it. Beremiz
    /// declares an action after the first step that has it, and there the other steps that it asks for are not known yet. CODESYS has one initial step.
    pub scan_step: bool,
    /// Which XML it is.
    pub edition: Edition,
}

/// A chart as a project of PLCopen XML with one program.
///
/// # Errors
/// What [`crate::sfc::textual`] refuses.
pub fn plcopen(model: &Model, options: Options) -> Result<Exported, Vec<Refused>> {
    let mut chart = build(model)?;
    if options.scan_step {
        chart.with_scan_step();
    }
    let places = place::places(model, &chart);
    let project = match options.edition {
        Edition::Tc6 => tc6::project(&chart, &network(&chart, &places, Back::Jumps)),
        Edition::Iec61131Part10 => part10::project(&chart, &network(&chart, &places, Back::Lines)),
    };
    let text = format!("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{}", project.text());
    Ok(chart.exported(text))
}

/// What an action does, in structured text.
fn body(action: &crate::sfc::Action) -> String {
    let mut body = String::new();
    statements(&mut body, 0, &action.body);
    body.trim_end().to_owned()
}

/// The body of a function or a function block that a person has to write.
fn to_be_written(stub: &Stub) -> String {
    let nothing = match stub.ty.as_deref() {
        Some("BOOL") => format!("{} := FALSE;", stub.name),
        Some(_) => format!("{} := 0;", stub.name),
        None => ";".to_owned(),
    };
    classic(&format!("// TO BE WRITTEN, in Rust: {}\n{nothing}", stub.rust)).trim_end().to_owned()
}
