//! The Rust that is printed from programs, naive and after all passes, for people to read, and when these programs ask for the next cycle.
//!
//! That it compiles and behaves, `cargo xtask conformance --printed` shows.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use grafcet_compiler::program::naive;
use grafcet_compiler::program::passes::{Pass, optimise};
use grafcet_compiler::{Lower, compile_program};
use grafcet_conformance::program::rests;
use grafcet_conformance::{chart, reader};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

#[path = "../../charts/mod.rs"]
#[allow(dead_code, unreachable_pub, reason = "its other half is for expansions")]
mod charts;

const NAIVE: Lower = naive;

const OPTIMISED: Lower = |model, facts| {
    let mut program = NAIVE(model, facts)?;
    optimise(&mut program, &Pass::ALL);
    Ok(program)
};

/// Each file of the corpus, naive and after all passes: a cycle is asked for at once where there is something to do, and nowhere else.
#[test]
fn programs_rest_where_nothing_is_left_to_do() {
    let (mut played, mut failures) = (0, String::new());
    for entry in fs::read_dir(env!("CARGO_MANIFEST_DIR")).expect("the corpus is there") {
        let path = entry.expect("a folder entry").path();
        if path.extension().is_none_or(|extension| extension != "chart") {
            continue;
        }
        let case = reader::read(&fs::read_to_string(&path).expect("a file")).expect("a chart and a timeline");
        let model = chart::resolve(&case.chart).expect("a chart");
        for passes in [&[][..], &Pass::ALL] {
            match rests(&model, &case.lines, passes) {
                Ok(()) => played += 1,
                Err(error) => _ = writeln!(failures, "{} {passes:?}: {error}", path.display()),
            }
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
    assert!(played > 380, "only {played} are played");
}

/// `cargo xtask bless` records them anew.
#[test]
fn printed_programs_are_as_recorded() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = |name: &str| root.join(format!("tests/golden/program/{name}.rs"));
    for name in ["branch_on_result", "line24v", "motor", "recipe", "tickless"] {
        let rust = fs::read_to_string(root.join(format!("examples/charts/{name}.rs"))).expect("an example");
        for (folder, lower) in [("", NAIVE), ("optimised/", OPTIMISED)] {
            let text: String = charts::charts(&rust).into_iter().map(|chart| printed(chart, lower)).collect();
            recorded(&file(&format!("{folder}{name}")), &text);
        }
    }
    let flags = "sfc Pair { input b1, b2: bool; output q: bool; encoding flags; initial step S1; step S2 { q; } S1 -[b1]-> S2 -[b2]-> S1; }";
    recorded(&file("flags"), &printed(flags.parse().expect("a chart"), NAIVE));
}

/// The chart's struct, what `new` writes, `cycle` and `next_deadline`.
fn printed(chart: TokenStream, lower: Lower) -> String {
    let mut file: syn::File = syn::parse2(compile_program(&quote!(::grafcet), chart, lower)).expect("items");
    let shown = |one: &syn::ImplItem, names: &[&str]| match one {
        syn::ImplItem::Fn(function) => names.iter().any(|name| function.sig.ident == name),
        _ => false,
    };
    let cycle = file.items.iter().find_map(|item| match item {
        syn::Item::Impl(item) => item.items.iter().any(|one| shown(one, &["cycle"])).then(|| item.self_ty.clone()),
        _ => None,
    });
    let name = cycle.to_token_stream().to_string();
    file.items.retain_mut(|item| match item {
        syn::Item::Struct(item) => {
            item.attrs.clear();
            item.ident == name
        }
        syn::Item::Impl(item) if item.trait_.is_none() && item.self_ty.to_token_stream().to_string() == name => {
            item.items.retain(|one| shown(one, &["new", "with_params", "cycle", "next_deadline"]));
            for one in &mut item.items {
                if let syn::ImplItem::Fn(function) = one {
                    function.attrs.clear();
                }
            }
            !item.items.is_empty()
        }
        _ => false,
    });
    prettyplease::unparse(&file).replace("::grafcet::__private::", "").replace("core::primitive::", "")
}

fn recorded(path: &PathBuf, now: &str) {
    let now = format!(
        "// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.\n\n{now}"
    );
    if std::env::var_os("BLESS").is_some_and(|bless| bless == "1") {
        return fs::write(path, now).expect("the folder is there");
    }
    let before = fs::read_to_string(path).unwrap_or_default();
    let different = before.lines().zip(now.lines()).find(|(before, now)| before != now);
    assert!(before == now, "{}: {different:?}\nIf that is meant, run `cargo xtask bless`", path.display());
}
