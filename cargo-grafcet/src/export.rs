//! `cargo grafcet export`

use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::Model;
use grafcet_compiler::plant;
use grafcet_exchange::st::{Form, Options, structured_text};

use crate::args::{Export, StForm, StructuredText};
use crate::find::{self, Found};
use crate::report::{Message, human};
use crate::{Failure, Outcome, check, complain, output};

pub(crate) fn run(options: &Export) -> Result<Outcome, Failure> {
    match options {
        Export::St(options) => st(options),
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
            Ok(done) => {
                for (name, rust) in &done.to_write {
                    complain(&format!("note: to be written by you: {name}, in Rust `{rust}`"));
                }
                Ok(Some(done.text))
            }
            Err(refused) => {
                for one in &refused {
                    complain(&human::refused(chart, one));
                }
                Ok(None)
            }
        }
    })
}

/// The model of a chart in which nothing is wrong; what is wrong is said.
pub(crate) fn accepted(chart: &Found) -> Option<Model> {
    let messages = check::messages_of(chart, None);
    let mut wrong = false;
    for message in messages.iter().filter(|message| Message::is_error(message)) {
        complain(&human::shown(message));
        wrong = true;
    }
    if wrong {
        return None;
    }
    // It has been said.
    let mut sink = Sink::new();
    let model = plant::model(chart.tokens.clone(), &mut sink);
    _ = sink.finish();
    model
}
