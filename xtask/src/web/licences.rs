//! The licences of the crates that are in the playground's WebAssembly.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Stdio;

use serde_json::Value;

use crate::command::{Result, capture};
use crate::project::cargo;

/// The licence of each crate that is not of this workspace, one after the other.
///
/// # Errors
/// Cargo does not tell, or a file cannot be read.
pub(super) fn of_crates(root: &str, target: &str) -> Result<String> {
    let metadata = ["metadata", "--locked", "--format-version", "1", "--filter-platform", target];
    let text = capture(cargo(&metadata).stdout(Stdio::piped()))?;
    let metadata: Value = serde_json::from_str(&text).map_err(|error| format!("cargo metadata: {error}"))?;
    let packages = by_id(&metadata["packages"]);
    let mut all = String::new();
    for id in needed(root, &packages, &by_id(&metadata["resolve"]["nodes"])) {
        let package = packages.get(id).copied().unwrap_or(&Value::Null);
        // What has no source is ours.
        if package["source"].is_null() {
            continue;
        }
        let word = |field: &str| package[field].as_str().unwrap_or_default();
        // Writing to a string cannot fail.
        _ = writeln!(all, "{} {} ({})\n", word("name"), word("version"), word("license"));
        for text in texts(Path::new(word("manifest_path")))? {
            _ = writeln!(all, "{}\n", text.trim_end());
        }
        _ = writeln!(all, "{}\n", "-".repeat(72));
    }
    Ok(all)
}

fn by_id(list: &Value) -> BTreeMap<&str, &Value> {
    let all = list.as_array().into_iter().flatten();
    all.filter_map(|one| Some((one["id"].as_str()?, one))).collect()
}

/// The crate of this name and all that it is made of: neither what tests it nor what builds it.
fn needed<'m>(
    root: &str,
    packages: &BTreeMap<&'m str, &Value>,
    nodes: &BTreeMap<&'m str, &'m Value>,
) -> BTreeSet<&'m str> {
    let mut open: Vec<&str> = packages.iter().filter(|(_, one)| one["name"] == root).map(|(id, _)| *id).collect();
    let mut found = BTreeSet::new();
    while let Some(id) = open.pop() {
        if !found.insert(id) {
            continue;
        }
        let dependencies = nodes.get(id).and_then(|node| node["deps"].as_array()).into_iter().flatten();
        let normal = dependencies.filter(|one| {
            one["dep_kinds"].as_array().is_some_and(|kinds| kinds.iter().any(|kind| kind["kind"].is_null()))
        });
        open.extend(normal.filter_map(|one| one["pkg"].as_str()));
    }
    found
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
    use serde_json::json;

    use super::{by_id, needed};

    #[test]
    fn what_tests_and_builds_a_crate_is_not_in_it() {
        let packages = json!([{ "id": "a", "name": "page" }, { "id": "b", "name": "b" }, { "id": "c", "name": "c" }]);
        let kind = |kind| json!([{ "kind": kind }]);
        let nodes = json!([
            { "id": "a", "deps": [{ "pkg": "b", "dep_kinds": kind(None::<&str>) }, { "pkg": "c", "dep_kinds": kind(Some("dev")) }] },
            { "id": "b", "deps": [{ "pkg": "a", "dep_kinds": kind(None) }, { "pkg": "c", "dep_kinds": kind(Some("build")) }] },
            { "id": "c", "deps": [] },
        ]);
        let found: Vec<&str> = needed("page", &by_id(&packages), &by_id(&nodes)).into_iter().collect();
        assert_eq!(found, ["a", "b"]);
    }
}
