//! What the code of a cycle looks like, by small charts: the Rust of each stands beside it, for people to read.
//!
//! `cargo xtask bless` records it anew. A chart without its Rust, and Rust without a chart, are errors. The pseudo-code beside it, and which shapes have no
//! chart, is for `tests/conformance/tests/programs/shapes.rs`: the printer of pseudo-code is a feature that no build of a user has.

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

/// `cycle`, `force` and `next_deadline`, what takes the state of a region from its bits, and the private types of the state.
fn cycle(chart: TokenStream) -> String {
    let expanded = charts::expand(chart);
    if let Some((_, refused)) = expanded.to_string().split_once("compile_error ! ") {
        panic!("a chart is refused: {}", refused.split(" }").next().unwrap_or_default());
    }
    let mut file: syn::File = syn::parse2(expanded).expect("an expansion is a list of items");
    file.items.retain_mut(|item| match item {
        syn::Item::Enum(item) => {
            plain(&mut item.attrs);
            is_private(&item.ident)
        }
        syn::Item::Struct(item) => {
            plain(&mut item.attrs);
            is_private(&item.ident)
        }
        syn::Item::Impl(item) if item.trait_.is_none() => {
            let of = match &*item.self_ty {
                syn::Type::Path(of) => of.path.segments.last().map(|last| &last.ident),
                _ => None,
            };
            if !of.is_some_and(is_private) {
                item.items
                    .retain(|inner| matches!(inner, syn::ImplItem::Fn(function) if is_shown(&function.sig.ident)));
            }
            !item.items.is_empty()
        }
        _ => false,
    });
    let rust = prettyplease::unparse(&file).replace("::grafcet::__private::", "");
    format!(
        "// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.\n\n{rust}"
    )
}

fn is_shown(function: &syn::Ident) -> bool {
    let name = function.to_string();
    ["cycle", "force", "next_deadline"].contains(&name.as_str()) || name.ends_with('_')
}

/// Whether a type holds the chart's state, which nobody outside names.
fn is_private(name: &syn::Ident) -> bool {
    name.to_string().starts_with("__")
}

/// Of the attributes that alone which says how a value is stored.
fn plain(attrs: &mut Vec<syn::Attribute>) {
    attrs.retain(|attr| attr.path().is_ident("repr"));
}

/// Compares with the file, or writes it where `BLESS=1` is set.
fn compare(path: &str, now: &str) {
    if std::env::var_os("BLESS").is_some_and(|bless| bless == "1") {
        return fs::write(path, now).unwrap_or_else(|error| panic!("{path}: {error}"));
    }
    let recorded = fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}; run `cargo xtask bless`"));
    assert!(recorded == now, "{path} has changed. If that is meant, run `cargo xtask bless`. It is now\n{now}");
}
