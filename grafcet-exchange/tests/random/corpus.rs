//! The charts whose timelines were worked out by hand (`tests/conformance`), as far as structured text can say them: decisions that random charts seldom
//! meet, as two orders on one partial grafcet.

use std::fs;
use std::path::Path;

use grafcet_exchange::st::{Form, Options, Order, structured_text};

use crate::{FLAVOURS, chart, play, reader};

/// The forms, and how many of the charts have a translation at least.
const FORMS: [(Form, Option<Order>, usize); 3] =
    [(Form::Case, None, 20), (Form::Case, Some(Order::EvolveFirst), 20), (Form::FlipFlops, None, 190)];

#[test]
fn charts_worked_out_by_hand() {
    let (mut played, mut differing) = ([0; FORMS.len()], Vec::new());
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/conformance")).expect("the corpus") {
        let path = entry.expect("a folder entry").path();
        if path.extension().is_none_or(|extension| extension != "chart") {
            continue;
        }
        let case = reader::read(&fs::read_to_string(&path).expect("a file")).expect("a chart and a timeline");
        let model = chart::resolve(&case.chart).expect("a chart");
        for ((form, order, _), played) in FORMS.into_iter().zip(&mut played) {
            let (flavour, dialect) = FLAVOURS[*played % FLAVOURS.len()];
            let options = Options { form, order, flavour, ..Options::default() };
            let Ok(program) = structured_text(&model, &options) else { continue };
            match play::compare(&model, (form, order), (&program, dialect), &case.lines) {
                Ok(0) => {}
                Ok(_) => *played += 1,
                Err(difference) => differing.push(format!("{} {form:?} {order:?}: {difference}", path.display())),
            }
        }
    }
    assert!(differing.is_empty(), "{differing:#?}");
    assert!(FORMS.iter().zip(played).all(|(form, played)| played >= form.2), "only {played:?} are played");
}
