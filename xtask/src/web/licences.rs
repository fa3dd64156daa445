//! The licences of the crates that are in the playground's WebAssembly.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Stdio;

use serde_json::Value;

use crate::command::{Result, capture};
use crate::project::cargo;

/// The licence of each crate that is in `root` for this target and not of this workspace, one after the other.
///
/// # Errors
/// Cargo does not tell, or a file cannot be read.
pub(super) fn of_crates(root: &str, target: &str) -> Result<String> {
    // The tree has the crates of this one with its features, and without what builds and tests them; where they lie, the metadata tell.
    let tree = ["tree", "--locked", "--edges", "normal,no-proc-macro", "--prefix", "none", "--format", "{p}"];
    let tree = capture(cargo(&tree).args(["--package", root, "--target", target]).stdout(Stdio::piped()))?;
    let metadata = ["metadata", "--locked", "--format-version", "1"];
    let metadata = capture(cargo(&metadata).stdout(Stdio::piped()))?;
    let metadata: Value = serde_json::from_str(&metadata).map_err(|error| format!("cargo metadata: {error}"))?;
    let packages: Vec<&Value> = metadata["packages"].as_array().into_iter().flatten().collect();
    let mut all = String::new();
    for (name, version) in crates(&tree) {
        let found = packages.iter().find(|one| one["name"] == name && one["version"] == version);
        let package = found.ok_or_else(|| format!("cargo metadata does not tell of {name} {version}"))?;
        // What has no source is ours.
        if package["source"].is_null() {
            continue;
        }
        let word = |field: &str| package[field].as_str().unwrap_or_default();
        // Writing to a string cannot fail.
        _ = writeln!(all, "{name} {version} ({})\n", word("license"));
        for text in texts(Path::new(word("manifest_path")))? {
            _ = writeln!(all, "{}\n", text.trim_end());
        }
        _ = writeln!(all, "{}\n", "-".repeat(72));
    }
    Ok(all)
}

/// Names and versions: `syn v3.0.9`, once each.
fn crates(tree: &str) -> BTreeSet<(&str, &str)> {
    let named = tree.lines().filter_map(|line| {
        let (name, rest) = line.split_once(" v")?;
        Some((name, rest.split(' ').next()?))
    });
    named.collect()
}

/// The files beside a manifest that hold a licence, in their order.
fn texts(manifest: &Path) -> Result<Vec<String>> {
    let folder = manifest.parent().unwrap_or(manifest);
    let failed = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
    let entries = fs::read_dir(folder).map_err(|error| failed(folder, error))?;
    let is_licence = |path: &Path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        ["LICENSE", "LICENCE", "COPYING", "UNLICENSE"].iter().any(|word| name.starts_with(word)) && path.is_file()
    };
    let mut files: Vec<_> = entries.flatten().map(|entry| entry.path()).filter(|path| is_licence(path)).collect();
    files.sort();
    files.iter().map(|path| fs::read_to_string(path).map_err(|error| failed(path, error))).collect()
}

#[cfg(test)]
mod tests {
    use super::{crates, of_crates};

    #[test]
    fn a_crate_is_there_once() {
        let tree = "page v0.1.0 (/home/page)\nsyn v3.0.9\nquote v1.0.47\nsyn v3.0.9 (*)\n";
        let found: Vec<_> = crates(tree).into_iter().collect();
        assert_eq!(found, [("page", "0.1.0"), ("quote", "1.0.47"), ("syn", "3.0.9")]);
    }

    #[test]
    fn what_is_in_the_page_and_nothing_else() {
        let text = of_crates("grafcet-web", "wasm32-unknown-unknown").expect("cargo tells");
        for name in ["\nsyn ", "\nwasm-bindgen ", "\nserde_json "] {
            assert!(text.contains(name), "{name}");
        }
        // A macro, what an optional feature asks for, what is ours.
        for name in ["\nserde_derive ", "\ndefmt ", "\ngrafcet-"] {
            assert!(!text.contains(name), "{name}");
        }
    }
}
