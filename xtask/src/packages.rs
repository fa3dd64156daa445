//! What is published: the packages in their order, sets of features, the oldest dependencies that the manifests allow.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{SystemTime, UNIX_EPOCH};

use serde_json::Value;

use crate::command::{Result, capture, run as run_command};
use crate::project::{self, cargo, remove, root};

/// All that is checked here.
///
/// # Errors
/// As [`pack`], [`features`] and [`oldest`].
pub(crate) fn run() -> Result {
    pack()?;
    features()?;
    oldest()
}

/// Packs all crates in the order of their dependencies and builds each from its package, as for publishing.
///
/// # Errors
/// A package lacks something, or does not build from what is in it.
pub(crate) fn pack() -> Result {
    let packages = published()?;
    // One folder for all, so that what several use is built once, and another one in each run: cargo unpacks a package into its
    // home under the folder's path and the package's version, and what it finds there from an earlier run it takes for this one.
    let packed = project::target("packages");
    remove(&packed)?;
    let folder = packed.join(this_run()?);
    // What is tried is the working tree; cargo asks for a clean one where it publishes indeed.
    let mut command = cargo(&["package", "--locked", "--quiet", "--allow-dirty", "--target-dir"]);
    // Nobody runs it: without debug information a library and the macro that uses it are the same build.
    command.arg(&folder).env("CARGO_PROFILE_DEV_DEBUG", "0");
    run_command(command.args(packages.iter().flat_map(|package| ["--package", &package.name])))?;
    // Cargo packs without them, too.
    let wanted = ["LICENSE-APACHE", "LICENSE-MIT", "README.md"];
    for package in packages {
        let files = capture(&mut cargo(&["package", "--package", &package.name, "--list", "--allow-dirty"]))?;
        if let Some(missing) = wanted.iter().find(|file| !files.lines().any(|line| line == **file)) {
            return Err(format!("the package of {} has no {missing}", package.name));
        }
    }
    Ok(())
}

/// A name that no earlier run has had.
fn this_run() -> Result<String> {
    let now =
        SystemTime::now().duration_since(UNIX_EPOCH).map_err(|error| format!("the clock is before 1970: {error}"))?;
    Ok(now.as_nanos().to_string())
}

/// Checks every crate that is published with sets of its features: none, each alone, all but each, and all.
///
/// # Errors
/// One of the sets does not build without warnings.
pub(crate) fn features() -> Result {
    // What stands behind one feature and lacks another does not build with it alone; what stands behind two, not with all but the
    // third.
    check_with(|set, all| set.len() <= 1 || set.len() + 1 >= all)
}

/// The same with all sets.
///
/// # Errors
/// As [`features`].
pub(crate) fn all_features() -> Result {
    check_with(|_, _| true)
}

/// `wanted` is told a set, and how many features there are.
fn check_with(wanted: impl Fn(&[&str], usize) -> bool) -> Result {
    for package in published()? {
        let sets = sets(&package.features).into_iter().filter(|set| wanted(set, package.features.len()));
        // Two sets that turn on the same are one.
        let different: BTreeSet<Vec<&str>> = sets.map(|set| turned_on(&package.features, set)).collect();
        for set in different.iter().map(|set| set.join(",")) {
            println!("features: {} with {}", package.name, if set.is_empty() { "none" } else { &set });
            let check = ["clippy", "--locked", "--quiet", "--lib", "--no-default-features", "--package", &package.name];
            // In a folder of its own, so that it need not wait for another build.
            let folder = project::target("features");
            let mut command = cargo(&check);
            command.args(["--features", &set, "--target-dir"]).arg(folder).args(["--", "-D", "warnings"]);
            run_command(&mut command)?;
        }
    }
    Ok(())
}

/// Checks the crates that are published with the oldest versions of their dependencies that their manifests allow.
///
/// # Errors
/// A manifest allows a version that lacks what is used.
pub(crate) fn oldest() -> Result {
    let folder = project::target("oldest");
    copy_into(&folder)?;
    // The option is not stable, and changes nothing but the lock file.
    let update = ["update", "--quiet", "-Z", "direct-minimal-versions"];
    run_command(cargo(&update).current_dir(&folder).env("RUSTC_BOOTSTRAP", "1"))?;
    for package in published()? {
        let check =
            ["check", "--quiet", "--locked", "--lib", "--all-features", "--package", &package.name, "--target-dir"];
        run_command(cargo(&check).arg(project::target("oldest-build")).current_dir(&folder))?;
    }
    Ok(())
}

/// The files of the project, those that are not committed yet included.
fn copy_into(folder: &Path) -> Result {
    let failed = |what: &Path, error| format!("{}: {error}", what.display());
    remove(folder)?;
    let list = ["ls-files", "-z", "--cached", "--others", "--exclude-standard"];
    let files = capture(Command::new("git").args(list).current_dir(root()))?;
    // A file that is deleted and not committed is listed, too.
    for file in files.split('\0').filter(|file| root().join(file).is_file()) {
        let copy = folder.join(file);
        if let Some(parent) = copy.parent() {
            fs::create_dir_all(parent).map_err(|error| failed(parent, error))?;
        }
        fs::copy(root().join(file), &copy).map_err(|error| failed(&copy, error))?;
    }
    Ok(())
}

/// A crate that is published.
pub(crate) struct Package {
    pub(crate) name: String,
    /// A program can link it: it is no macro.
    pub(crate) is_library: bool,
    /// Each with those that it turns on in the same crate.
    features: BTreeMap<String, Vec<String>>,
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
    Some(Package { name, is_library, features })
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
        let crate_ = package(&json!({ "name": "a", "publish": null, "features": features, "targets": targets }));
        assert!(crate_.is_some_and(|crate_| crate_.name == "a"
            && crate_.features["std"] == ["b"]
            && crate_.features.len() == 2
            && crate_.is_library));
        assert!(package(&json!({ "name": "b", "publish": [], "features": {}, "targets": targets })).is_none());
        let macros = json!([{ "kind": ["proc-macro"] }]);
        let crate_ = package(&json!({ "name": "c", "publish": null, "features": {}, "targets": macros }));
        assert!(crate_.is_some_and(|crate_| !crate_.is_library));
    }
}
