//! `cargo grafcet export`

use grafcet_exchange::st::{Form, Options, structured_text};
use grafcet_exchange::{Refused, pnml};

use crate::args::{Export, Pnml, StForm, StructuredText};
use crate::find::{self, Found};
use crate::model::accepted;
use crate::report::human;
use crate::{Failure, Outcome, complain, output};

pub(crate) fn run(options: &Export) -> Result<Outcome, Failure> {
    match options {
        Export::St(options) => st(options),
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
                for (name, rust) in &done.to_write {
                    complain(&format!("note: to be written by you: {name}, in Rust `{rust}`"));
                }
                Ok(Some(done.text))
            }
        }
    })
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
