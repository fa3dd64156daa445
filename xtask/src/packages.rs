//! What is published: the packages, built with the oldest dependencies that their manifests allow, and sets of features.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
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
    let check = ["check", "--quiet", "--locked", "--lib", "--bins", "--all-features", "--target-dir"];
    // Nobody runs it. A macro is built for the library that uses it; checked by itself, too, all that it is made of would be checked once
    // more.
    let mut command = cargo(&check);
    command.arg(project::target("oldest")).current_dir(&unpacked).env("CARGO_PROFILE_DEV_DEBUG", "0");
    let checked = packages.iter().filter(|package| package.is_library);
    run_command(command.args(checked.flat_map(|package| ["--package", &package.name])))?;
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

/// Checks every crate that is published with sets of its features: none, each alone, and all but each; with all of them [`pack`] checks
/// it. Of the features those count that the crate's own code names: what others turn on is another crate's. And the examples as
/// `cargo run --example` builds them, with no more than they ask for.
///
/// # Errors
/// One of the sets does not build without warnings.
pub(crate) fn features() -> Result {
    let cargo = |subcommand| {
        let mut command = cargo(&[subcommand, "--locked", "--quiet", "--target-dir"]);
        command.arg(project::target("features")).env("RUSTFLAGS", "-D warnings").env("CARGO_PROFILE_DEV_DEBUG", "0");
        // Nobody runs it: the solver need not be fast.
        for name in ["batsat", "grafcet-prove"] {
            command.arg("--config").arg(format!("profile.dev.package.{name}.opt-level=0"));
        }
        command
    };
    let packages = published()?;
    for package in &packages {
        let named = package.named()?;
        let features = package.features.iter().filter(|(name, _)| named.contains(name.as_str()));
        let features: BTreeMap<String, Vec<String>> = features.map(|(name, on)| (name.clone(), on.clone())).collect();
        // What stands behind one feature and lacks another does not build with it alone; what stands behind two, not with all but the
        // third. Lints are looked for with all features, in CI's step `clippy`, and with all sets by [`all_features`].
        each_set(
            package,
            &features,
            |set| set.len() <= 1 || set.len() + 1 == features.len(),
            |set| {
                // What a macro is made of cargo builds for it: where it is built here, too, and not only checked, it is the same build.
                let is_built = package.name == MACROS || set.is_empty() && BUILT.contains(&&*package.name);
                cargo(if is_built { "build" } else { "check" })
            },
        )?;
    }
    println!("features: the examples");
    run_command(cargo("check").args(["--package", "grafcet-examples", "--examples"]))
}

/// The macro.
const MACROS: &str = "grafcet-macros";

/// What it is made of without features, and what is quickly built of that.
const BUILT: [&str; 4] = ["grafcet-core", "grafcet-draw", "grafcet-compiler", "grafcet-exchange"];

/// All sets of all features, with lints.
///
/// # Errors
/// As [`features`].
pub(crate) fn all_features() -> Result {
    for package in published()? {
        let clippy = |_: &[&str]| {
            let mut command = cargo(&["clippy", "--locked", "--quiet", "--target-dir"]);
            command.arg(project::target("features-all"));
            command
        };
        each_set(&package, &package.features, |_| true, clippy)?;
    }
    Ok(())
}

/// Runs this command with the sets of these features that are wanted. `clippy` is told to deny warnings, others have been.
fn each_set(
    package: &Package,
    features: &BTreeMap<String, Vec<String>>,
    wanted: impl Fn(&[&str]) -> bool,
    command: impl Fn(&[&str]) -> Command,
) -> Result {
    let sets = sets(features).into_iter().filter(|set| wanted(set));
    // Two sets that turn on the same are one.
    let different: BTreeSet<Vec<&str>> = sets.map(|set| turned_on(&package.features, set)).collect();
    for set in different {
        let mut command = command(&set);
        let set = set.join(",");
        println!("features: {} with {}", package.name, if set.is_empty() { "none" } else { &set });
        command.args(["--lib", "--no-default-features", "--package", &package.name, "--features", &set]);
        if command.get_args().next().is_some_and(|subcommand| subcommand == "clippy") {
            command.args(["--", "-D", "warnings"]);
        }
        run_command(&mut command)?;
    }
    Ok(())
}

/// A crate that is published.
pub(crate) struct Package {
    pub(crate) name: String,
    version: String,
    /// The folder of its code.
    sources: PathBuf,
    /// A program can link it: it is no macro.
    pub(crate) is_library: bool,
    /// Each with those that it turns on in the same crate.
    features: BTreeMap<String, Vec<String>>,
}

impl Package {
    /// The features that stand in its code, as in `#[cfg(feature = "record")]`.
    fn named(&self) -> Result<BTreeSet<String>> {
        let mut names = BTreeSet::new();
        let mut folders = vec![self.sources.clone()];
        while let Some(folder) = folders.pop() {
            let failed = |error| format!("{}: {error}", folder.display());
            for entry in fs::read_dir(&folder).map_err(failed)? {
                let path = entry.map_err(failed)?.path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
                    let after = text.split("feature = \"").skip(1);
                    names.extend(after.filter_map(|after| after.split('"').next()).map(str::to_owned));
                }
            }
        }
        Ok(names)
    }

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
    let sources = Path::new(package["manifest_path"].as_str()?).with_file_name("src");
    Some(Package { name, version, sources, is_library, features })
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

    use super::{package, published, sets, turned_on, workspace};

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
    fn features_count_where_the_code_names_them() {
        let packages = published().expect("cargo tells");
        let named = |name: &str| {
            let package = packages.iter().find(|package| package.name == name).expect("it is published");
            package.named().expect("its code").into_iter().collect::<Vec<_>>().join(",")
        };
        // The others the facade hands on.
        assert_eq!(named("grafcet"), "record,std");
        assert_eq!(named("grafcet-macros"), "prove,record");
        // In folders below, too.
        assert!(named("grafcet-core").contains("steer,wire"), "{}", named("grafcet-core"));
    }

    #[test]
    fn packages_depend_on_each_other_as_they_are_packed() {
        let manifest = json!({ "name": "a", "version": "0.1.0", "manifest_path": "/a/Cargo.toml", "publish": null, "features": {}, "targets": [] });
        let crate_ = package(&manifest).expect("a package");
        let expected = "[workspace]\nresolver = \"3\"\nmembers = [\n    \"a-0.1.0\",\n]\n\n[patch.crates-io]\na = { path = \"a-0.1.0\" }\n";
        assert_eq!(workspace(&[crate_]), expected);
    }

    #[test]
    fn what_is_not_published_is_left_out() {
        let features = json!({ "default": [], "std": ["dep:d", "d/std", "b"], "b": [], "_host": [] });
        let targets = json!([{ "kind": ["test"] }, { "kind": ["lib"] }]);
        let crate_ = package(
            &json!({ "name": "a", "version": "0.1.0", "manifest_path": "/a/Cargo.toml", "publish": null, "features": features, "targets": targets }),
        );
        assert!(crate_.is_some_and(|crate_| crate_.name == "a"
            && crate_.features["std"] == ["b"]
            && crate_.features.len() == 2
            && crate_.is_library));
        assert!(
            package(&json!({ "name": "b", "version": "0.1.0", "manifest_path": "/a/Cargo.toml", "publish": [], "features": {}, "targets": targets }))
                .is_none()
        );
        let macros = json!([{ "kind": ["proc-macro"] }]);
        let crate_ = package(
            &json!({ "name": "c", "version": "0.1.0", "manifest_path": "/a/Cargo.toml", "publish": null, "features": {}, "targets": macros }),
        );
        assert!(crate_.is_some_and(|crate_| !crate_.is_library));
    }
}
