//! Exported programs of random charts, run beside the interpreter of the model.
//!
//! - `flags`, `sfc`: each scan shows what a cycle shows: steps, outputs, variables, calls
//! - `case`, `sfc`: the number of the step is that of the cycle; what the step does shows one scan later (`shifted`)
//! - `case` that evolves first, `sfc`: each scan shows what a cycle shows
//! - `grafcet`: both are run with the same inputs at the same time until nothing changes; then the program shows what the chart shows, and has called what
//!   it has called. With flip-flops a cycle in which nothing evolves is one scan, which shows what the cycle shows

#[path = "../../../tests/conformance/src/chart.rs"]
#[allow(dead_code, unreachable_pub, reason = "a part of another test's crate")]
mod chart;
mod corpus;
mod drawn;
#[path = "../../../tests/conformance/src/fragments.rs"]
#[allow(dead_code, unreachable_pub, clippy::format_collect, reason = "a part of another test's crate")]
mod fragments;
#[path = "../machine/mod.rs"]
mod machine;
mod net;
mod play;
#[path = "../../../tests/conformance/src/random/mod.rs"]
#[allow(dead_code, unreachable_pub, clippy::format_collect, reason = "a part of another test's crate")]
mod random;
#[path = "../../../tests/conformance/reader.rs"]
#[allow(dead_code, unreachable_pub, reason = "a part of another test's crate")]
mod reader;
mod reasons;
mod round;
mod shifted;

use std::collections::BTreeMap;

use grafcet_compiler::analysis::combinational;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::{check, parse};
use grafcet_exchange::st::{Flavour, Form, Options, Order, structured_text};
use machine::Dialect;

/// So many charts of each dialect and form.
const CHARTS: usize = 200;

/// As each tool takes a program, and by which grammar it is read here.
pub(crate) const FLAVOURS: [(Flavour, Dialect); 3] =
    [(Flavour::Iec, Dialect::Iec), (Flavour::Codesys, Dialect::Codesys), (Flavour::Tia, Dialect::Tia)];

pub(crate) const CYCLES: usize = 120;

/// Whether it is a `grafcet`, and as what it is written.
pub(crate) const FORMS: [(bool, Form, Option<Order>); 6] = [
    (false, Form::Case, None),
    (true, Form::Case, None),
    (false, Form::Case, Some(Order::EvolveFirst)),
    (true, Form::Case, Some(Order::EvolveFirst)),
    (false, Form::FlipFlops, None),
    (true, Form::FlipFlops, None),
];

#[test]
fn case_sfc() {
    compare(false, Form::Case, None);
}

#[test]
fn case_grafcet() {
    compare(true, Form::Case, None);
}

#[test]
fn case_evolving_sfc() {
    compare(false, Form::Case, Some(Order::EvolveFirst));
}

#[test]
fn case_evolving_grafcet() {
    compare(true, Form::Case, Some(Order::EvolveFirst));
}

#[test]
fn flip_flops_sfc() {
    compare(false, Form::FlipFlops, None);
}

#[test]
fn flip_flops_grafcet() {
    compare(true, Form::FlipFlops, None);
}

/// A chart whose drawing is in order.
pub(crate) fn resolved(text: &str) -> Option<Model> {
    let text = fragments::written_out(&fragments::plain(text));
    let mut sink = Sink::new();
    let model = parse::chart(text.parse().ok()?, &mut sink).map(|chart| model::resolve(&chart, &mut sink));
    if let Some(model) = &model {
        check::drawing(model, &mut sink);
    }
    let wrong = sink.has_errors();
    _ = sink.finish();
    model.filter(|model| !wrong && !model.incomplete)
}

/// How many charts, and the seed of the first.
pub(crate) fn seeds(charts: usize) -> (usize, u64) {
    let told = |name: &str| std::env::var(name).ok();
    (
        told("ST_CHARTS").and_then(|charts| charts.parse().ok()).unwrap_or(charts),
        told("ST_SEED").and_then(|seed| seed.parse().ok()).unwrap_or(1),
    )
}

fn compare(grafcet: bool, form: Form, order: Option<Order>) {
    let (wanted, first) = seeds(CHARTS);
    let (mut done, mut cycles, mut structure, mut differing) = (0, 0, [0; 6], Vec::new());
    let mut refusals = BTreeMap::<String, usize>::new();
    let mut seed = first;
    while done < wanted {
        let made = random::chart(seed, grafcet, CYCLES);
        seed += 1;
        assert!(seed - first < 400_000, "only {done} charts have a translation: {refusals:#?}");
        // Most have none: whether the compiler accepts the chart, which takes longer, is asked of the others.
        let Some(model) = resolved(&made.chart) else { continue };
        let options = Options { form, order, ..Options::default() };
        if let Err(refused) = structured_text(&model, &options) {
            let first = refused.first().map(ToString::to_string).unwrap_or_default();
            *refusals.entry(reasons::without_names(&first)).or_default() += 1;
            continue;
        }
        let Ok(model) = chart::resolve(&made.chart) else { continue };
        // By turns as each tool takes it.
        let (flavour, dialect) = FLAVOURS[done % FLAVOURS.len()];
        let program = structured_text(&model, &Options { flavour, ..options }).expect("it had a translation");
        let lines = reader::read(&format!("{}\n---\n{}", made.chart, made.timeline)).expect("a timeline").lines;
        match play::compare(&model, (form, order), (&program, dialect), &lines) {
            Ok(0) => {}
            Ok(compared) => {
                done += 1;
                cycles += compared;
                for (count, has) in structure.iter_mut().zip(structure_of(&model)) {
                    *count += usize::from(has);
                }
            }
            Err(difference) => {
                done += 1;
                differing.push(format!("seed {}: {difference}\n{}\n{}", seed - 1, made.chart, program.text));
            }
        }
    }
    println!(
        "{form:?}, {order:?}, {}: {done} charts of {}, {cycles} cycles, {structure:?} with source or sink transitions, several partial grafcets, enclosing steps, forcing orders, `any` beside parallel branches, variables that follow the situation, {} differ; refused: {refusals:#?}",
        if grafcet { "grafcet" } else { "sfc" },
        seed - first,
        differing.len()
    );
    if grafcet && form == Form::FlipFlops {
        // Most charts with a variable that follows the situation have something else that has no translation.
        let enough = structure[..5].iter().all(|count| *count > 3);
        assert!(done < CHARTS || enough, "{structure:?}: too few of one kind");
    } else if form == Form::FlipFlops {
        assert!(done < CHARTS || structure[4] > 3, "{structure:?}: too few with `any` beside parallel branches");
        structure[4] = 0;
        assert!(structure == [0; 6], "{structure:?}: an `sfc` has no others");
    } else {
        assert!(structure == [0; 6], "{structure:?}: the form has no such charts");
    }
    let seeds: Vec<&str> = differing.iter().filter_map(|one: &String| one.lines().next()).collect();
    assert!(differing.is_empty(), "{} of {done} differ: {seeds:#?}; the first: {}", differing.len(), differing[0]);
}

/// What the form of flip-flops alone can say of a `grafcet`.
fn structure_of(model: &Model) -> [bool; 6] {
    let is_loose = |one: &model::Transition| one.sources.is_empty() || one.targets.is_empty();
    let forks = |one: &model::Transition| one.targets.len() > 1;
    [
        model.transitions.values().any(is_loose),
        model.partials.len() > 1,
        model.steps.values().any(|step| !step.encloses.is_empty()),
        !model.forces.is_empty(),
        !model.anys.is_empty() && model.transitions.values().any(forks),
        !combinational::in_order(model).is_empty(),
    ]
}
