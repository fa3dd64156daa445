//! The charts of the project.

use std::fs;
use std::path::{Path, PathBuf};

use grafcet_compiler::describe::with_description;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::{model, parse};
use grafcet_core::description::Description;
use proc_macro2::{TokenStream, TokenTree};

/// All of them: of the examples, the good ones and the corpus.
pub(crate) fn all(mut f: impl FnMut(&str, &Description<'_>)) {
    let mut each = |file: &Path, chart: TokenStream| {
        let name = file.display().to_string();
        let known = with(chart, |chart| f(&name, chart));
        assert!(known.is_some(), "{name} cannot be read");
    };
    for folder in ["../examples/charts", "../tests/good"] {
        for file in files(folder, "rs") {
            let rust = fs::read_to_string(&file).expect("a file of charts");
            for chart in calls(&rust) {
                each(&file, chart);
            }
        }
    }
    for file in files("../tests/conformance", "chart") {
        let text = fs::read_to_string(&file).expect("a chart of the corpus");
        each(&file, text.split("\n---").next().unwrap_or_default().parse().expect("tokens"));
    }
}

/// `None` where the chart has mistakes.
pub(crate) fn with<R>(chart: TokenStream, f: impl FnOnce(&Description<'_>) -> R) -> Option<R> {
    let mut sink = Sink::new();
    let model = parse::chart(chart, &mut sink).map(|chart| model::resolve(&chart, &mut sink));
    let model = model.filter(|_| !sink.has_errors());
    drop(sink.finish());
    model.map(|model| with_description(&model, f))
}

fn files(folder: &str, extension: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(folder).expect("a folder of charts");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.retain(|file| file.extension().is_some_and(|found| found == extension));
    files.sort();
    files
}

/// What stands in each `grafcet! { … }` of a file.
fn calls(rust: &str) -> Vec<TokenStream> {
    let tokens: Vec<_> = rust.parse::<TokenStream>().expect("a piece of Rust").into_iter().collect();
    let call = |window: &[TokenTree]| match window {
        [TokenTree::Ident(name), TokenTree::Punct(bang), TokenTree::Group(chart)]
            if name == "grafcet" && bang.as_char() == '!' =>
        {
            Some(chart.stream())
        }
        _ => None,
    };
    tokens.windows(3).filter_map(call).collect()
}
