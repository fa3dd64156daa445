//! What generated code binds ends with an underscore: a local or a parameter that is called like a constant, a static, or a variant that
//! a `use` brings in is a pattern of that item, whatever hygiene says. `tests/hostile/names/src/in_the_way` asks rustc the same.

mod charts;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};
use syn::visit_mut::{self, VisitMut};

/// Folders with charts of every kind.
const FOLDERS: &[&str] = &[
    "tests/conformance",
    "tests/good",
    "tests/golden/shapes",
    "tests/hostile/lint/src",
    "tests/hostile/names/src",
    "tests/hostile/names/src/in_the_way",
    "examples/charts",
];

#[test]
fn what_generated_code_binds_is_called_like_no_item() {
    let mut count = 0;
    for folder in FOLDERS {
        for file in fs::read_dir(folder).expect("a folder of charts") {
            let file = file.expect("a file").path();
            for chart in charts_in(&file) {
                let mut bindings = Bindings { of_user: words(chart.clone()), file: &file };
                // Where a chart has mistakes, there are stubs.
                let mut expansion = syn::parse2(charts::expand(chart)).expect("an expansion is a list of items");
                bindings.visit_file_mut(&mut expansion);
                count += 1;
            }
        }
    }
    assert!(count > 300, "the charts are not where this test looks for them: {count}");
}

/// Of two charts with one name rustc complains of each item, in their order: first of what the user has named.
#[test]
fn the_first_item_is_the_chart() {
    let chart = "sfc Motor { input on: bool; initial step Off; step On; Off -[on]-> On -[!on]-> Off; }";
    let expansion: syn::File = syn::parse2(charts::expand(chart.parse().expect("a chart"))).expect("a list of items");
    assert!(matches!(expansion.items.first(), Some(syn::Item::Struct(first)) if first.ident == "Motor"));
}

fn charts_in(file: &Path) -> Vec<TokenStream> {
    let extension = file.extension().and_then(|extension| extension.to_str());
    let text = || fs::read_to_string(file).expect("a file of charts");
    match extension {
        Some("rs") => charts::charts(&text()),
        // After the chart stands its timeline.
        Some("chart") => vec![text().split("\n---").next().unwrap_or_default().parse().expect("a chart")],
        _ => Vec::new(),
    }
}

/// The words of a chart: what is called like one of them is the user's own name, or meets it at most.
fn words(chart: TokenStream) -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    for token in chart {
        match token {
            TokenTree::Ident(name) => _ = words.insert(name.to_string()),
            TokenTree::Group(group) => words.append(&mut self::words(group.stream())),
            _ => {}
        }
    }
    if words.contains("modes") {
        words.extend(["manual", "semi_automatic", "paused", "push"].map(str::to_owned));
    }
    words
}

struct Bindings<'f> {
    of_user: BTreeSet<String>,
    file: &'f Path,
}

impl VisitMut for Bindings<'_> {
    fn visit_pat_ident_mut(&mut self, pattern: &mut syn::PatIdent) {
        let name = pattern.ident.to_string();
        let is_ours = name.ends_with('_') || name == "VARIANT";
        assert!(is_ours || self.of_user.contains(&name), "{}: `{name}`", self.file.display());
        visit_mut::visit_pat_ident_mut(self, pattern);
    }

    /// For documentation alone, in which no body is looked at.
    fn visit_fn_arg_mut(&mut self, parameter: &mut syn::FnArg) {
        let is_shown = |attribute: &syn::Attribute| match &attribute.meta {
            syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "doc",
            _ => false,
        };
        if !matches!(parameter, syn::FnArg::Typed(typed) if typed.attrs.iter().any(is_shown)) {
            visit_mut::visit_fn_arg_mut(self, parameter);
        }
    }

    /// The parameters of a function without a body are no patterns.
    fn visit_trait_item_fn_mut(&mut self, _: &mut syn::TraitItemFn) {}
}
