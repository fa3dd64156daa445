//! Every shape that the code of an evolution can have, by a small chart: the Rust of its cycle stands beside it, for people to read.
//!
//! `cargo xtask bless` records it anew. A shape that no chart here has, and a chart of the project with a shape that is not here,
//! are errors.

mod charts;

use std::fs;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::plan::{Form, Plan, Search};
use grafcet_compiler::{check, model, parse};
use proc_macro2::TokenStream;

/// The files of `tests/golden/shapes`, and what each of them shows.
const SHAPES: &[(&str, Form, Search)] = &[
    ("program_sfc", Form::Program, Search::None),
    ("program_timed", Form::Program, Search::None),
    ("program_long", Form::Program, Search::None),
    ("program_once", Form::Program, Search::None),
    ("program_ends", Form::Program, Search::None),
    ("program_circle", Form::Program, Search::None),
    ("program_bounded", Form::Program, Search::None),
    ("program_counter", Form::Program, Search::None),
    ("program_turns", Form::Program, Search::None),
    ("program_kinds", Form::Program, Search::None),
    ("program_branches", Form::Program, Search::None),
    ("program_branches_timed", Form::Program, Search::None),
    ("program_search", Form::Program, Search::None),
    ("program_hierarchy", Form::Program, Search::None),
    ("program_forced_sfc", Form::Program, Search::None),
    ("program_forced_grafcet", Form::Program, Search::None),
    ("program_forced_branches", Form::Program, Search::None),
    ("program_fork", Form::Program, Search::None),
    ("program_synchronised", Form::Program, Search::None),
    ("in_place_sfc", Form::InPlace, Search::None),
    ("flags_sfc", Form::Flags, Search::None),
    ("compared_sfc", Form::Compared, Search::None),
    ("in_place_ends", Form::InPlace, Search::Ends),
    ("flags_ends", Form::Flags, Search::Ends),
    ("flags_bounded", Form::Flags, Search::Bounded),
    ("compared_ends", Form::Compared, Search::Ends),
    ("compared_bounded", Form::Compared, Search::Bounded),
];

#[test]
fn each_shape_has_a_chart() {
    for (name, form, search) in SHAPES {
        let chart = chart(name);
        assert_eq!(shape(chart.clone()), Ok((*form, *search)), "{name}");
        compare(&format!("tests/golden/shapes/{name}.rs"), &cycle(chart));
    }
}

/// The passes would take seconds for it: each join has all other branches looked at once more.
#[test]
fn long_charts_with_branches_take_no_passes() {
    let shaped = |blocks: usize| {
        let block = |block: usize| {
            let next = (block + 1) % blocks;
            let own = if block == 0 { String::new() } else { format!("step S{block};") };
            format!(
                "{own} step A{block}; step B{block}; S{block} -[go]-> (A{block}, B{block}); (A{block}, B{block}) -[!go]-> S{next};"
            )
        };
        let blocks: Vec<String> = (0..blocks).map(block).collect();
        let text = format!("sfc Blocks {{ input go: bool; initial step S0; {} }}", blocks.join(" "));
        shape(text.parse().expect("tokens"))
    };
    assert_eq!(shaped(8), Ok((Form::Program, Search::None)));
    assert_eq!(shaped(300), Ok((Form::InPlace, Search::None)));
}

/// A program that is long for its chart is taken all the same where it is no longer than without looking anything up by state, and not where it is longer.
#[test]
fn what_is_no_longer_by_state_is_a_program() {
    let shaped = |file: &str, name: &str| {
        let rust = fs::read_to_string(format!("tests/good/{file}.rs")).expect("a file of charts");
        let mut charts = charts::charts(&rust).into_iter();
        shape(charts.find(|chart| chart.to_string().contains(name)).expect("the chart")).map(|(form, _)| form)
    };
    assert_eq!(shaped("operating_modes", "ModalPress"), Ok(Form::Program));
    assert_eq!(shaped("packaging_line", "PackagingLine"), Ok(Form::Program));
    assert_eq!(shaped("buffer", "grafcet Buffer"), Ok(Form::Program));
    assert_eq!(shaped("selections_of_rust", "grafcet Float"), Ok(Form::Compared));
}

#[test]
fn the_charts_of_the_project_have_no_other_shape() {
    for folder in ["examples/charts", "tests/good"] {
        for entry in fs::read_dir(folder).expect("a folder of charts") {
            let file = entry.expect("an entry").path();
            if file.extension().is_none_or(|extension| extension != "rs") {
                continue;
            }
            let rust = fs::read_to_string(&file).expect("a file of charts");
            for chart in charts::charts(&rust) {
                let Ok(shape) = shape(chart) else { continue };
                assert!(is_shown(shape), "{}: {shape:?} has no chart in tests/golden/shapes", file.display());
            }
        }
    }
}

fn is_shown(shape: (Form, Search)) -> bool {
    SHAPES.iter().any(|(_, form, search)| shape == (*form, *search))
}

fn chart(name: &str) -> TokenStream {
    let path = format!("tests/golden/shapes/{name}.chart");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    text.parse().unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// What is wrong, where the chart has mistakes.
fn shape(chart: TokenStream) -> Result<(Form, Search), Vec<String>> {
    let mut sink = Sink::new();
    let shape = parse::chart(chart, &mut sink).map(|chart| {
        let model = model::resolve(&chart, &mut sink);
        let facts = Facts::of(&model);
        let races = check::evolution(&model, &facts, None, &mut sink);
        let shape = Plan::of(&model, &facts, &races, false).shape;
        (shape.form, shape.search)
    });
    let wrong = sink.has_errors();
    let messages = sink.finish().into_iter().flat_map(|diagnostic| diagnostic.notes).map(|(_, text)| text);
    shape.filter(|_| !wrong).ok_or_else(|| messages.collect())
}

/// `cycle` and `force`, and what they call.
fn cycle(chart: TokenStream) -> String {
    let mut file: syn::File = syn::parse2(charts::expand(chart)).expect("an expansion is a list of items");
    file.items.retain_mut(|item| {
        let syn::Item::Impl(item) = item else { return false };
        item.items.retain(|inner| match inner {
            syn::ImplItem::Fn(function) => {
                ["cycle", "__evolve", "force"].contains(&function.sig.ident.to_string().as_str())
            }
            _ => false,
        });
        item.trait_.is_none() && !item.items.is_empty()
    });
    let rust = prettyplease::unparse(&file).replace("::grafcet::__private::", "");
    format!(
        "// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.\n\n{rust}"
    )
}

/// Compares with the file, or writes it where `BLESS=1` is set.
fn compare(path: &str, now: &str) {
    if std::env::var_os("BLESS").is_some_and(|bless| bless == "1") {
        return fs::write(path, now).unwrap_or_else(|error| panic!("{path}: {error}"));
    }
    let recorded = fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}; run `cargo xtask bless`"));
    assert!(recorded == now, "{path} has changed. If that is meant, run `cargo xtask bless`. It is now\n{now}");
}
