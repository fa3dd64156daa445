//! `cargo grafcet export`

use clap::{Args as Arguments, Subcommand, ValueEnum};
use grafcet_compiler::model::Model;
use grafcet_exchange::plcopen::{self, plcopen};
use grafcet_exchange::sfc::{Exported, textual};
use grafcet_exchange::st::{Form, Options, structured_text};
use grafcet_exchange::{Refused, pnml};

use crate::args::{Charts, Target};
use crate::find::{self, Found};
use crate::model::accepted;
use crate::report::human;
use crate::{Failure, Outcome, complain, output};

/// Write charts in other notations
#[derive(Subcommand, Debug)]
pub(crate) enum Export {
    St(StructuredText),
    Sfc(Sfc),
    Plcopen(Plcopen),
    Pnml(Pnml),
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
    pub(crate) target: Target,
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
    pub(crate) target: Target,
}

/// PLCopen XML (TC6 2.01): the chart as a drawing of SFC, for CODESYS, Beremiz and others
///
/// For `sfc` charts, as `export sfc`. Steps and transitions stand where `draw` puts them; what leads back is a jump.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet export plcopen --chart Motor -o motor.xml
  cargo grafcet export plcopen --chart Motor -o motor.xml --scan-step       for Beremiz
  cargo grafcet export plcopen --out plcopen    all charts of the crate as plcopen/NAME.xml

Exit code 1 says that a chart has errors or no translation.")]
pub(crate) struct Plcopen {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) target: Target,
    /// Let a step of its own, beside the chart, do what is done in each scan: Beremiz needs that, CODESYS has one initial step
    #[arg(long)]
    pub(crate) scan_step: bool,
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
  cargo grafcet export st --out st              all charts of the crate as st/NAME.st

Exit code 1 says that a chart has errors or no translation.")]
pub(crate) struct StructuredText {
    #[command(flatten)]
    pub(crate) charts: Charts,
    #[command(flatten)]
    pub(crate) target: Target,
    /// One CASE for the active step, which acts and then evolves; or a flip-flop for each step, which evolves and then acts
    #[arg(long, value_enum, default_value_t, value_name = "FORM")]
    pub(crate) form: StForm,
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

pub(crate) fn run(options: &Export) -> Result<Outcome, Failure> {
    match options {
        Export::St(options) => st(options),
        Export::Sfc(options) => sfc(&options.charts, &options.target, "st", textual),
        Export::Plcopen(options) => {
            let wanted = plcopen::Options { scan_step: options.scan_step };
            sfc(&options.charts, &options.target, "xml", |model| plcopen(model, wanted))
        }
        Export::Pnml(options) => pnml(options),
    }
}

fn st(options: &StructuredText) -> Result<Outcome, Failure> {
    let charts = find::charts(&options.charts)?;
    let wanted = Options {
        form: match options.form {
            StForm::Case => Form::Case,
            StForm::FlipFlops => Form::FlipFlops,
        },
        numbers: (options.first, options.by),
        step: options.step.clone(),
        init: options.init.clone(),
    };
    output::each(&charts, &options.target, "st", |chart| {
        let Some(model) = accepted(chart) else { return Ok(None) };
        match structured_text(&model, &wanted) {
            Err(refused) => Ok(no(chart, &refused)),
            Ok(done) => {
                to_write(&done.to_write);
                Ok(Some(done.text))
            }
        }
    })
}

fn sfc(
    charts: &Charts,
    target: &Target,
    ending: &str,
    export: impl Fn(&Model) -> Result<Exported, Vec<Refused>>,
) -> Result<Outcome, Failure> {
    let charts = find::charts(charts)?;
    output::each(&charts, target, ending, |chart| {
        let Some(model) = accepted(chart) else { return Ok(None) };
        let done = export(&model);
        Ok(done.map_or_else(
            |refused| no(chart, &refused),
            |done| {
                to_write(&done.to_write);
                Some(done.text)
            },
        ))
    })
}

fn to_write(stubs: &[(String, String)]) {
    for (name, rust) in stubs {
        complain(&format!("note: to be written by you: {name}, in Rust `{rust}`"));
    }
}

fn pnml(options: &Pnml) -> Result<Outcome, Failure> {
    let charts = find::charts(&options.charts)?;
    output::each(&charts, &options.target, "pnml", |chart| {
        let Some(model) = accepted(chart) else { return Ok(None) };
        Ok(pnml::pnml(&model).map_or_else(|refused| no(chart, &refused), Some))
    })
}

/// Says why there is no translation.
fn no(chart: &Found, refused: &[Refused]) -> Option<String> {
    for one in refused {
        complain(&human::refused(chart, one));
    }
    None
}
