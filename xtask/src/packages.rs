//! What is published: the packages, built with the oldest dependencies that their manifests allow, and sets of features.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::command::{Result, capture, run as run_command};
use crate::project::{self, cargo, remove};

/// All that is checked here.
///
/// # Errors
/// As [`pack`] and [`features`].
pub(crate) fn run() -> Result {
    pack()?;
    features()
}

/// The same with all sets of features.
///
/// # Errors
/// As [`run`].
pub(crate) fn all() -> Result {
    pack()?;
    all_features()
}

/// Packs all crates as for publishing, and checks what is in the packages with the oldest versions of their dependencies that their manifests
/// allow. It is one check of two things: a package that lacks a file does not build with any versions, and those of the lock file are tried
/// by all other steps. Cargo's own check of packages builds each crate once more for each that depends on it.
///
/// # Errors
/// A package lacks something, does not build from what is in it, or its manifest allows a version that lacks what is used.
pub(crate) fn pack() -> Result {
    let packages = published()?;
    let folder = project::target("packages");
    remove(&folder)?;
    // What is tried is the working tree; cargo asks for a clean one where it publishes indeed.
    let mut command = cargo(&["package", "--no-verify", "--locked", "--quiet", "--allow-dirty", "--target-dir"]);
    run_command(command.arg(&folder).args(packages.iter().flat_map(|package| ["--package", &package.name])))?;
    let unpacked = folder.join("unpacked");
    for package in &packages {
        unpack(package, &folder.join("package"), &unpacked)?;
    }
    write(&unpacked.join("Cargo.toml"), &workspace(&packages))?;
    // The option is not stable, and changes nothing but the lock file.
    let update = ["update", "--quiet", "-Z", "direct-minimal-versions"];
    run_command(cargo(&update).current_dir(&unpacked).env("RUSTC_BOOTSTRAP", "1"))?;
    let check = ["check", "--quiet", "--locked", "--workspace", "--lib", "--bins", "--all-features", "--target-dir"];
    // Nobody runs it.
    let mut command = cargo(&check);
    run_command(command.arg(project::target("oldest")).current_dir(&unpacked).env("CARGO_PROFILE_DEV_DEBUG", "0"))?;
    println!("packages: {} build from what is in them, with the oldest dependencies they allow", packages.len());
    Ok(())
}

/// Unpacks a package, and looks whether it has what cargo packs without, too.
fn unpack(package: &Package, packed: &Path, to: &Path) -> Result {
    fs::create_dir_all(to).map_err(|error| format!("{}: {error}", to.display()))?;
    let file = packed.join(format!("{}.crate", package.folder()));
    run_command(Command::new("tar").arg("--extract").arg("--file").arg(file).arg("--directory").arg(to))?;
    for wanted in ["LICENSE-APACHE", "LICENSE-MIT", "README.md"] {
        if !to.join(package.folder()).join(wanted).is_file() {
            return Err(format!("the package of {} has no {wanted}", package.name));
        }
    }
    Ok(())
}

/// The packages as a workspace, in which each depends on the others as they are packed, and not on what a registry has of their name.
fn workspace(packages: &[Package]) -> String {
    let (mut members, mut patches) = (String::new(), String::new());
    for package in packages {
        let (name, folder) = (&package.name, package.folder());
        // Writing to a string cannot fail.
        _ = writeln!(members, "    \"{folder}\",");
        _ = writeln!(patches, "{name} = {{ path = \"{folder}\" }}");
    }
    format!("[workspace]\nresolver = \"3\"\nmembers = [\n{members}]\n\n[patch.crates-io]\n{patches}")
}

fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

/// Checks every crate that is published with sets of its features: none, each alone, all but each, and all; and the examples as
/// `cargo run --example` builds them, with no more than they ask for.
///
/// # Errors
/// One of the sets does not build without warnings.
pub(crate) fn features() -> Result {
    // What stands behind one feature and lacks another does not build with it alone; what stands behind two, not with all but the
    // third. Lints are looked for with all features, in CI's step `clippy`, and with all sets by [`all_features`].
    let check = |arguments: &[&str]| {
        let mut command = cargo(&["check", "--locked", "--quiet", "--target-dir"]);
        command.arg(project::target("features")).env("RUSTFLAGS", "-D warnings").env("CARGO_PROFILE_DEV_DEBUG", "0");
        run_command(command.args(arguments))
    };
    each_set(|set, all| set.len() <= 1 || set.len() + 1 >= all, check)?;
    println!("features: the examples");
    check(&["--package", "grafcet-examples", "--examples"])
}

/// All sets, with lints.
///
/// # Errors
/// As [`features`].
pub(crate) fn all_features() -> Result {
    each_set(
        |_, _| true,
        |arguments| {
            let mut command = cargo(&["clippy", "--locked", "--quiet", "--target-dir"]);
            run_command(command.arg(project::target("features")).args(arguments).args(["--", "-D", "warnings"]))
        },
    )
}

/// `wanted` is told a set, and how many features there are; `check` the words that tell cargo of package and features.
fn each_set(wanted: impl Fn(&[&str], usize) -> bool, check: impl Fn(&[&str]) -> Result) -> Result {
    for package in published()? {
        let sets = sets(&package.features).into_iter().filter(|set| wanted(set, package.features.len()));
        // Two sets that turn on the same are one.
        let different: BTreeSet<Vec<&str>> = sets.map(|set| turned_on(&package.features, set)).collect();
        for set in different.iter().map(|set| set.join(",")) {
            println!("features: {} with {}", package.name, if set.is_empty() { "none" } else { &set });
            check(&["--lib", "--no-default-features", "--package", &package.name, "--features", &set])?;
        }
    }
    Ok(())
}

/// A crate that is published.
pub(crate) struct Package {
    pub(crate) name: String,
    version: String,
    /// A program can link it: it is no macro.
    pub(crate) is_library: bool,
    /// Each with those that it turns on in the same crate.
    features: BTreeMap<String, Vec<String>>,
}

impl Package {
    /// The folder that it is packed as.
    fn folder(&self) -> String {
        format!("{}-{}", self.name, self.version)
    }
}

/// All of them.
///
/// # Errors
/// Cargo does not tell.
pub(crate) fn published() -> Result<Vec<Package>> {
    let metadata = ["metadata", "--no-deps", "--locked", "--format-version", "1"];
    let text = capture(cargo(&metadata).stdout(Stdio::piped()))?;
    let metadata: Value = serde_json::from_str(&text).map_err(|error| format!("cargo metadata: {error}"))?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata names no packages")?;
    let packages: Vec<Package> = packages.iter().filter_map(package).collect();
    if packages.is_empty() { Err("no crate is published".to_owned()) } else { Ok(packages) }
}

/// The package, where it may be published: `publish` is then null, not an empty list.
fn package(package: &Value) -> Option<Package> {
    let name = package["name"].as_str().filter(|_| package["publish"].is_null())?.to_owned();
    // What begins with `_` is between the crates of the project.
    let named = |(name, _): &(&String, &Value)| *name != "default" && !name.starts_with('_');
    let implied = |turned_on: &Value| {
        let turned_on = turned_on.as_array().into_iter().flatten().filter_map(Value::as_str);
        turned_on.filter(|name| !name.contains([':', '/'])).map(str::to_owned).collect()
    };
    let features = package["features"].as_object()?.iter().filter(named);
    let features = features.map(|(name, turned_on)| (name.clone(), implied(turned_on))).collect();
    let kinds = package["targets"].as_array()?.iter().filter_map(|target| target["kind"].as_array()).flatten();
    let is_library = kinds.into_iter().any(|kind| kind == "lib");
    let version = package["version"].as_str()?.to_owned();
    Some(Package { name, version, is_library, features })
}

/// The set with the features that those in it turn on, sorted.
fn turned_on<'f>(features: &'f BTreeMap<String, Vec<String>>, mut set: Vec<&'f str>) -> Vec<&'f str> {
    let mut at = 0;
    while let Some(feature) = set.get(at) {
        let more = features.get(*feature).into_iter().flatten().map(String::as_str);
        let more: Vec<&str> = more.filter(|name| !set.contains(name)).collect();
        set.extend(more);
        at += 1;
    }
    set.sort_unstable();
    set
}

/// All sets of these features.
fn sets(features: &BTreeMap<String, Vec<String>>) -> Vec<Vec<&str>> {
    let mut sets = vec![Vec::new()];
    for feature in features.keys() {
        let with = |set: &Vec<_>| [&set[..], &[feature.as_str()]].concat();
        let more: Vec<_> = sets.iter().map(with).collect();
        sets.extend(more);
    }
    sets
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use serde_json::json;

    use super::{package, sets, turned_on};

    #[test]
    fn sets_of_features() {
        let joined: Vec<String> = sets(&features()).iter().map(|set| set.join(",")).collect();
        assert_eq!(joined, ["", "a", "b", "a,b", "c", "a,c", "b,c", "a,b,c"]);
    }

    /// `c` turns on `b`, and that `a`.
    fn features() -> BTreeMap<String, Vec<String>> {
        let features = [("a", &[][..]), ("b", &["a"]), ("c", &["b"])];
        features.map(|(name, on)| (name.to_owned(), on.iter().map(|on| (*on).to_owned()).collect())).into()
    }

    #[test]
    fn a_feature_turns_on_others() {
        let features = features();
        let on = |set: &[&'static str]| turned_on(&features, set.to_vec()).join(",");
        assert_eq!([on(&[]), on(&["a"]), on(&["c"]), on(&["c", "a"])], ["", "a", "a,b,c", "a,b,c"]);
    }

    #[test]
    fn what_is_not_published_is_left_out() {
        let features = json!({ "default": [], "std": ["dep:d", "d/std", "b"], "b": [], "_host": [] });
        let targets = json!([{ "kind": ["test"] }, { "kind": ["lib"] }]);
        let crate_ = package(
            &json!({ "name": "a", "version": "0.1.0", "publish": null, "features": features, "targets": targets }),
        );
        assert!(crate_.is_some_and(|crate_| crate_.name == "a"
            && crate_.features["std"] == ["b"]
            && crate_.features.len() == 2
            && crate_.is_library));
        assert!(
            package(&json!({ "name": "b", "version": "0.1.0", "publish": [], "features": {}, "targets": targets }))
                .is_none()
        );
        let macros = json!([{ "kind": ["proc-macro"] }]);
        let crate_ =
            package(&json!({ "name": "c", "version": "0.1.0", "publish": null, "features": {}, "targets": macros }));
        assert!(crate_.is_some_and(|crate_| !crate_.is_library));
    }
}
