//! What the code of a cycle looks like, by small charts: the Rust of each stands beside it, for people to read.
//!
//! `cargo xtask bless` records it anew. A chart without its Rust, and Rust without a chart, are errors.

#[allow(dead_code, reason = "its other half is for files of charts")]
mod charts;

use std::fs;

use proc_macro2::TokenStream;

#[test]
fn each_shape_is_as_recorded() {
    let files = |extension: &str| {
        let mut names = Vec::new();
        for entry in fs::read_dir("tests/golden/shapes").expect("a folder of charts") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|found| found == extension) {
                names.push(path.file_stem().expect("a name").to_string_lossy().into_owned());
            }
        }
        names.sort();
        names
    };
    let charts = files("chart");
    for name in &charts {
        compare(&format!("tests/golden/shapes/{name}.rs"), &cycle(chart(name)));
    }
    assert_eq!(charts, files("rs"));
    assert!(charts.len() > 20, "{charts:?}");
}

fn chart(name: &str) -> TokenStream {
    let path = format!("tests/golden/shapes/{name}.chart");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    text.parse().unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// `cycle` and `force`, and what takes the state of a region from its bits.
fn cycle(chart: TokenStream) -> String {
    let mut file: syn::File = syn::parse2(charts::expand(chart)).expect("an expansion is a list of items");
    file.items.retain_mut(|item| {
        let syn::Item::Impl(item) = item else { return false };
        item.items.retain(|inner| match inner {
            syn::ImplItem::Fn(function) => {
                let name = function.sig.ident.to_string();
                ["cycle", "force"].contains(&name.as_str()) || name.ends_with('_')
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
