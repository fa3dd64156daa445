//! `cargo grafcet export`

use grafcet_compiler::model::Model;
use grafcet_exchange::plcopen::{self, plcopen};
use grafcet_exchange::sfc::{Exported, textual};
use grafcet_exchange::st::{Form, Options, structured_text};
use grafcet_exchange::{Refused, pnml};

use crate::args::{Charts, Export, Pnml, StForm, StructuredText, Target};
use crate::find::{self, Found};
use crate::model::accepted;
use crate::report::human;
use crate::{Failure, Outcome, complain, output};

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
