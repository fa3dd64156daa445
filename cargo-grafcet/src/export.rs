//! `cargo grafcet export`

use clap::{Args as Arguments, Subcommand, ValueEnum};
use grafcet_compiler::model::Model;
use grafcet_exchange::plcopen::{self, plcopen};
use grafcet_exchange::sfc::{Exported, textual};
use grafcet_exchange::st::{Flavour, Form, Options, Order, structured_text};
use grafcet_exchange::{Refused, pnml};
use grafcet_prove::export::{self as circuits, Notation};
use serde_json::json;

use crate::args::{Charts, Target};
use crate::find::{self, Found};
use crate::model::{accepted, sound};
use crate::report::{human, json as object};
use crate::{Failure, Outcome, complain, output, say};

/// Write charts in other notations
#[derive(Subcommand, Debug)]
pub(crate) enum Export {
    St(StructuredText),
    Sfc(Sfc),
    Plcopen(Plcopen),
    Pnml(Pnml),
    Aiger(Aiger),
    Btor2(Btor2),
}

/// What becomes of a translation.
#[derive(Arguments, Debug)]
pub(crate) struct Written {
    #[command(flatten)]
    pub(crate) target: Target,
    /// One JSON object a chart: its translation, what is to be written by you, and what has none, with its place
    #[arg(long, conflicts_with_all = ["output", "out"])]
    pub(crate) json: bool,
}

/// PNML: a chart as a Petri net, for tools that look at these
///
/// A place for each step and a transition for each transition; conditions become names. Forcing orders and enclosing steps are none of a net.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export pnml --chart Cell -o cell.pnml

Exit code 1 says that a chart has errors or is no net.")]
pub(crate) struct Pnml {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) result: Written,
}

/// AIGER: the cycle of a chart as a circuit with its properties, for checkers of hardware
///
/// As text (`aag`). With plants, and with what is assumed; `cargo grafcet prove --aiger FILE` writes the binary form, too.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export aiger --chart Motor -o motor.aag

Exit code 1 says that a chart has errors or no circuit.")]
pub(crate) struct Aiger {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) result: Written,
}

/// BTOR2: the cycle of a chart as a circuit with its properties, for checkers of hardware
///
/// With plants, and with what is assumed.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export btor2 --chart Motor -o motor.btor2

Exit code 1 says that a chart has errors or no circuit.")]
pub(crate) struct Btor2 {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) result: Written,
}

/// SFC of IEC 61131-3 in its textual form: a program with steps, transitions and actions
///
/// For `sfc` charts, whose meaning is that of the standard: one evolution a scan, then the actions. What has no translation is an error at its place, and nothing is written.
/// Rust functions and code actions become declared functions and function blocks that you have to write; they are listed.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export sfc --chart Motor
  cargo grafcet export sfc --chart Motor -o motor.st
  cargo grafcet export sfc --out sfc            all charts of the crate as sfc/NAME.st

Exit code 1 says that a chart has errors or no translation.")]
pub(crate) struct Sfc {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) result: Written,
}

/// PLCopen XML: the chart as a drawing of SFC, for CODESYS, Beremiz and others
///
/// For `sfc` charts, as `export sfc`. Steps and transitions stand where `draw` puts them; what leads back is a jump, or a line in the edition of IEC 61131-10,
/// which has no jumps.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export plcopen --chart Motor -o motor.xml
  cargo grafcet export plcopen --chart Motor -o motor.xml --scan-step       for Beremiz
  cargo grafcet export plcopen --chart Motor -o motor.xml --edition iec61131-10
  cargo grafcet export plcopen --out plcopen    all charts of the crate as plcopen/NAME.xml

Exit code 1 says that a chart has errors or no translation.")]
pub(crate) struct Plcopen {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) result: Written,
    /// Let a step of its own, beside the chart, do what is done in each scan: Beremiz needs that, CODESYS has one initial step
    #[arg(long)]
    pub(crate) scan_step: bool,
    /// Which XML: TC6 2.01 of PLCopen, which most tools read; or IEC 61131-10
    #[arg(long, value_enum, default_value_t, value_name = "EDITION")]
    pub(crate) edition: PlcopenEdition,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum PlcopenEdition {
    #[default]
    Tc6,
    #[value(name = "iec61131-10")]
    Iec61131Part10,
}

/// Structured text (IEC 61131-3): a function block
///
/// The header of the program says in which points it differs from the chart. What has no translation is an error at its place, and nothing is written. Rust
/// functions and code actions become declared functions and function blocks that you have to write; they are listed.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export st --chart Motor
  cargo grafcet export st --chart Motor --form flip-flops -o motor.st
  cargo grafcet export st --chart Motor --order evolve-first
  cargo grafcet export st --chart Motor --for tia -o motor.scl
  cargo grafcet export st --out st              all charts of the crate as st/NAME.st

Exit code 1 says that a chart has errors or no translation.")]
pub(crate) struct StructuredText {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) result: Written,
    /// A CASE for the active step, or a flip-flop for each step
    #[arg(long, value_enum, default_value_t, value_name = "FORM")]
    pub(crate) form: StForm,
    /// What comes first in a scan: a CASE acts first where nothing is said, flip-flops always evolve first
    #[arg(long, value_enum, value_name = "ORDER")]
    pub(crate) order: Option<StOrder>,
    /// For which tool: as the standard has it; for CODESYS 3.5; for TIA Portal, as an external source (SCL)
    #[arg(long = "for", value_enum, default_value_t, value_name = "TOOL")]
    pub(crate) tool: StFor,
    /// The number of the first step of a CASE
    #[arg(long, default_value_t = 10, value_name = "NUMBER")]
    pub(crate) first: u32,
    /// How far the number of the next step is from it
    #[arg(long, default_value_t = 10, value_name = "NUMBER", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) by: u32,
    /// The variable with the number of the active step
    #[arg(long, default_value = "StepNo", value_name = "NAME")]
    pub(crate) step: String,
    /// The input that puts the chart back into its initial situation
    #[arg(long, default_value = "Init", value_name = "NAME")]
    pub(crate) init: String,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum StForm {
    #[default]
    Case,
    FlipFlops,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum StOrder {
    ActFirst,
    EvolveFirst,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) enum StFor {
    #[default]
    Iec,
    Codesys,
    Tia,
}

pub(crate) fn run(options: &Export) -> Result<Outcome, Failure> {
    match options {
        Export::St(options) => st(options),
        Export::Sfc(options) => {
            each(&options.charts, &options.result, "st", |model| textual(model).map(Translation::from))
        }
        Export::Plcopen(options) => {
            let edition = match options.edition {
                PlcopenEdition::Tc6 => plcopen::Edition::Tc6,
                PlcopenEdition::Iec61131Part10 => plcopen::Edition::Iec61131Part10,
            };
            let wanted = plcopen::Options { scan_step: options.scan_step, edition };
            each(&options.charts, &options.result, "xml", |model| plcopen(model, wanted).map(Translation::from))
        }
        Export::Pnml(options) => each(&options.charts, &options.result, "pnml", |model| {
            pnml::pnml(model).map(|text| Translation { text, to_write: Vec::new() })
        }),
        Export::Aiger(options) => {
            each_of(&options.charts, &options.result, "aag", sound, |model| circuit(model, Notation::Aiger))
        }
        Export::Btor2(options) => {
            each_of(&options.charts, &options.result, "btor2", sound, |model| circuit(model, Notation::Btor2))
        }
    }
}

/// The cycle as a circuit.
fn circuit(model: &Model, notation: Notation) -> Result<Translation, Vec<Refused>> {
    let done = circuits::text(model, notation, None);
    let text = done.map_err(|why| vec![Refused { mark: None, message: why.to_string() }])?;
    Ok(Translation { text, to_write: Vec::new() })
}

fn st(options: &StructuredText) -> Result<Outcome, Failure> {
    let wanted = Options {
        form: match options.form {
            StForm::Case => Form::Case,
            StForm::FlipFlops => Form::FlipFlops,
        },
        order: options.order.map(|order| match order {
            StOrder::ActFirst => Order::ActFirst,
            StOrder::EvolveFirst => Order::EvolveFirst,
        }),
        flavour: match options.tool {
            StFor::Iec => Flavour::Iec,
            StFor::Codesys => Flavour::Codesys,
            StFor::Tia => Flavour::Tia,
        },
        numbers: (options.first, options.by),
        step: options.step.clone(),
        init: options.init.clone(),
    };
    // By which TIA Portal knows what it is.
    let ending = if options.tool == StFor::Tia { "scl" } else { "st" };
    each(&options.charts, &options.result, ending, |model| {
        structured_text(model, &wanted).map(|done| Translation { text: done.text, to_write: done.to_write })
    })
}

/// A chart in another notation.
struct Translation {
    text: String,
    /// What the user has to write there: its name, and what it is in Rust.
    to_write: Vec<(String, String)>,
}

impl From<Exported> for Translation {
    fn from(done: Exported) -> Self {
        Self { text: done.text, to_write: done.to_write }
    }
}

fn each(
    charts: &Charts,
    result: &Written,
    ending: &str,
    export: impl Fn(&Model) -> Result<Translation, Vec<Refused>>,
) -> Result<Outcome, Failure> {
    each_of(charts, result, ending, accepted, export)
}

/// `model` is what is seen of a chart; none where it has mistakes, which are said.
fn each_of(
    charts: &Charts,
    result: &Written,
    ending: &str,
    model: fn(&Found) -> Option<Model>,
    export: impl Fn(&Model) -> Result<Translation, Vec<Refused>>,
) -> Result<Outcome, Failure> {
    let charts = find::charts(charts)?;
    if result.json {
        return objects(&charts, model, export);
    }
    output::each(&charts, &result.target, ending, |chart| {
        let Some(model) = model(chart) else { return Ok(None) };
        Ok(match export(&model) {
            Err(refused) => no(chart, &refused),
            Ok(done) => {
                for (name, rust) in &done.to_write {
                    complain(&format!("note: to be written by you: {name}, in Rust `{rust}`"));
                }
                Some(done.text)
            }
        })
    })
}

/// One object a chart; the errors of one that does not compile are said beside it.
fn objects(
    charts: &[Found],
    model: fn(&Found) -> Option<Model>,
    export: impl Fn(&Model) -> Result<Translation, Vec<Refused>>,
) -> Result<Outcome, Failure> {
    let mut wrong = false;
    for chart in charts {
        let done = model(chart).map_or(Err(Vec::new()), |model| export(&model));
        wrong |= done.is_err();
        let (text, to_write, refused) = match done {
            Ok(done) => (Some(done.text), done.to_write, Vec::new()),
            Err(refused) => (None, Vec::new(), refused),
        };
        let to_write = to_write.iter().map(|(name, rust)| json!({ "name": name, "rust": rust }));
        let object = json!({
            "chart": chart.name,
            "file": chart.source.path.display().to_string(),
            "text": text,
            "to_write": to_write.collect::<Vec<_>>(),
            "refused": refused.iter().map(|one| object::refused(chart, one)).collect::<Vec<_>>(),
        });
        say(&format!("{object}\n"))?;
    }
    Ok(Outcome::wrong_if(wrong))
}

/// Says why there is no translation.
fn no(chart: &Found, refused: &[Refused]) -> Option<String> {
    for one in refused {
        complain(&human::refused(chart, one));
    }
    None
}
