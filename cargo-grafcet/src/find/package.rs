//! The crates that are meant, as `cargo metadata` tells.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::Failure;
use crate::args::Charts;

/// The first files of all targets of the crates that are meant, each once.
pub(super) struct Targets {
    pub(super) files: Vec<PathBuf>,
    /// `the crate motor`, for messages.
    pub(super) names: String,
}

/// Asks cargo.
pub(super) fn targets(options: &Charts) -> Result<Targets, Failure> {
    let metadata = metadata(options.manifest_path.as_deref(), Stdio::inherit())?;
    let packages: Vec<&Value> = list(&metadata["packages"]).collect();
    let meant = meant(options, &metadata, &packages)?;
    let mut files: Vec<PathBuf> = Vec::new();
    for target in meant.iter().flat_map(|package| list(&package["targets"])) {
        if let Some(file) = target["src_path"].as_str().map(PathBuf::from).filter(|file| !files.contains(file)) {
            files.push(file);
        }
    }
    let names: Vec<&str> = meant.iter().filter_map(|package| package["name"].as_str()).collect();
    let word = if names.len() == 1 { "the crate" } else { "the crates" };
    Ok(Targets { files, names: format!("{word} {}", names.join(", ")) })
}

/// As cargo chooses: by name, all of the workspace, the crate of this folder, or what the workspace's root says.
fn meant<'m>(options: &Charts, metadata: &'m Value, packages: &[&'m Value]) -> Result<Vec<&'m Value>, Failure> {
    if options.workspace {
        return Ok(packages.to_vec());
    }
    let mut named = Vec::new();
    for name in &options.package {
        let found = packages.iter().find(|package| package["name"] == **name);
        named.push(*found.ok_or_else(|| Failure::Said(format!("there is no crate `{name}` in the workspace")))?);
    }
    if !named.is_empty() {
        return Ok(named);
    }
    let root = metadata["workspace_root"].as_str().map(Path::new);
    let here = match &options.manifest_path {
        Some(manifest) => manifest.canonicalize().map_err(|error| Failure::file(manifest, &error))?,
        None => std::env::current_dir().ok().and_then(|here| nearest(&here)).unwrap_or_default(),
    };
    let is_here = |package: &&&Value| {
        let manifest = package["manifest_path"].as_str().map(Path::new);
        manifest.is_some_and(|manifest| manifest.canonicalize().is_ok_and(|manifest| manifest == here))
    };
    let is_root =
        here.parent().map(Path::canonicalize).and_then(Result::ok) == root.and_then(|root| root.canonicalize().ok());
    match packages.iter().find(is_here) {
        Some(package) if !is_root => Ok(vec![*package]),
        _ => {
            let members: Vec<&Value> = list(&metadata["workspace_default_members"]).collect();
            Ok(packages.iter().copied().filter(|package| members.contains(&&package["id"])).collect())
        }
    }
}

/// The version of the crate in whose folder a file lies; none where it lies in none, or cargo does not tell.
#[cfg(feature = "print")]
pub(super) fn version(file: &Path) -> Option<String> {
    let manifest = nearest(file.canonicalize().ok()?.parent()?)?;
    let metadata = metadata(Some(&manifest), Stdio::null()).ok()?;
    let is_it = |package: &&Value| {
        let path = package["manifest_path"].as_str().map(Path::new);
        path.is_some_and(|path| path.canonicalize().is_ok_and(|path| path == manifest))
    };
    list(&metadata["packages"]).find(is_it)?["version"].as_str().map(str::to_owned)
}

/// The manifest in this folder or above it.
fn nearest(folder: &Path) -> Option<PathBuf> {
    let manifests = folder.ancestors().map(|folder| folder.join("Cargo.toml"));
    manifests.into_iter().find(|manifest| manifest.is_file())?.canonicalize().ok()
}

fn metadata(manifest: Option<&Path>, errors: Stdio) -> Result<Value, Failure> {
    // Cargo tells its plugins which cargo has called them.
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["metadata", "--no-deps", "--format-version", "1"]).stderr(errors);
    if let Some(manifest) = manifest {
        command.arg("--manifest-path").arg(manifest);
    }
    let output = command.output().map_err(|error| Failure::Said(format!("cargo cannot be run: {error}")))?;
    if !output.status.success() {
        return Err(Failure::Said(
            "`cargo metadata` does not tell what belongs to the crate; a file can be named instead".to_owned(),
        ));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| Failure::Said(format!("`cargo metadata`: {error}")))
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}
