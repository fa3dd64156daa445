//! From a chart that was found to the compiler's model of it.

use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::{parse, plant};
use proc_macro2::TokenStream;

use crate::find::Found;
use crate::report::human;
use crate::{check, complain};

/// The model of a chart that can be drawn, without its plants; rules that it breaks leave the drawing as it is. None where there is no such thing, as
/// is said.
pub(crate) fn drawn(chart: &Found) -> Option<Model> {
    whole(chart, alone)
}

/// The same with its plants, and with what its properties say of them.
pub(crate) fn with_plants(chart: &Found) -> Option<Model> {
    whole(chart, plant::model)
}

/// The same with its plants, of a chart that does what it should; what is wrong is said. What it claims is for those to decide who get the model.
pub(crate) fn sound(chart: &Found) -> Option<Model> {
    let said = check::messages_of(chart, None);
    let wrong = said.iter().filter(|message| message.is_error() && !message.said.is_about_a_claim());
    let wrong = wrong.map(|message| complain(&human::shown(message))).count();
    if wrong > 0 { None } else { with_plants(chart) }
}

/// The model of a chart that does what it should, without its plants; what is wrong is said. What it claims of itself may be open or broken.
pub(crate) fn accepted(chart: &Found) -> Option<Model> {
    if complaints(chart) { None } else { drawn(chart) }
}

fn alone(tokens: TokenStream, sink: &mut Sink) -> Option<Model> {
    parse::chart(tokens, sink).map(|chart| model::resolve(&chart, sink))
}

fn whole(chart: &Found, resolve: fn(TokenStream, &mut Sink) -> Option<Model>) -> Option<Model> {
    let mut sink = Sink::new();
    let model = resolve(chart.tokens.clone(), &mut sink);
    let said = sink.finish();
    let whole = model.filter(|model| !model.incomplete && said.iter().all(|one| one.rule.is_some()));
    if whole.is_none() {
        complaints(chart);
    }
    whole
}

/// Shows the errors of a chart, and says whether one is about more than what the chart claims.
fn complaints(chart: &Found) -> bool {
    let mut more = false;
    for message in check::messages_of(chart, None).iter().filter(|message| message.is_error()) {
        complain(&human::shown(message));
        more |= !message.said.is_about_a_claim();
    }
    more
}
