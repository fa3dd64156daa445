//! Charts of which the compiler has nothing to say.

use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::Model;
use grafcet_compiler::plant;

pub(crate) fn model(chart: &str) -> Model {
    let tokens = chart.parse().unwrap_or_else(|error| panic!("{chart}: {error}"));
    let mut sink = Sink::new();
    let model = plant::model(tokens, &mut sink);
    let said = sink.finish();
    assert!(said.is_empty(), "{said:?}");
    model.expect("a chart")
}
