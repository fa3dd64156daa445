//! The playground: the compiler and the simulation as WebAssembly, and the page around them, in one folder.

mod licences;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{Result, capture, find, run as run_command};
use crate::firmware;
use crate::project::{self, Program, cargo, root};
use crate::toolchain::BareMetal;

const TARGET: &str = "wasm32-unknown-unknown";
const PAGE: &str = "grafcet-web/page";
const BIND: &str = "grafcet-web/bind";
const TOOL: Program = Program::Binary("cargo-grafcet");

/// Builds it into `target/web`.
///
/// # Errors
/// A tool is missing, or something does not build.
pub(crate) fn run() -> Result {
    let built = Built::all()?;
    println!("web: {} ({})", built.page.display(), sizes(&built.page)?);
    Ok(())
}

/// Builds it and tests what was built.
///
/// # Errors
/// As of [`run`], or a test fails.
pub(crate) fn test() -> Result {
    // First, so that it does not wait for what else CI builds in that folder later.
    Program::build(&[TOOL, Program::Example("gallery"), Program::Example("manual"), Program::Example("timelines")])?;
    let built = Built::all()?;
    let timelines = built.folder.join("timelines.json");
    write_example("timelines", &root().join("tests/conformance"), &timelines)?;
    run_command(node("test/corpus.mjs")?.arg(&built.glue).arg(&timelines))?;
    run_command(node("test/forms.mjs")?.arg(&built.glue).arg(built.folder.join("gallery.json")).arg(TOOL.file()))?;
    run_command(node("test/manual.mjs")?.args([&built.page, &built.glue, &built.folder.join("manual.json")]))?;
    run_command(node("test/page.mjs")?.arg(&built.page).arg(built.folder.join("screenshots")))?;
    live()
}

/// The live view of `cargo grafcet watch`: of the cell on the emulated board, and of a tank there that is steered.
///
/// # Errors
/// A tool is missing, something does not build, or the page shows anything else than what happened.
pub(crate) fn live() -> Result {
    packages()?;
    Program::build(&[TOOL])?;
    let tool = TOOL.file();
    let emulator = firmware::recorder()?;
    let mut command = node("test/live.mjs")?;
    command.arg(&tool).args(["examples/charts/cell.rs", "tests/examples/cell.expected"].map(|file| root().join(file)));
    let pictures = project::target("wasm").join("screenshots");
    run_command(command.arg(&pictures).arg(emulator.get_program()).args(emulator.get_args()))?;
    let emulator = firmware::steered()?;
    let mut command = node("test/steer.mjs")?;
    command.arg(tool).arg(root().join("examples/firmware/src/bin/steered.rs")).arg(pictures);
    run_command(command.arg(emulator.get_program()).args(emulator.get_args()))
}

/// Builds it and serves it on this machine.
///
/// # Errors
/// As of [`run`].
pub(crate) fn show() -> Result {
    let built = Built::all()?;
    run_command(node("test/show.mjs")?.arg(&built.page))
}

/// What is built, one out of the other.
struct Built {
    folder: PathBuf,
    /// The module with its JavaScript.
    glue: PathBuf,
    page: PathBuf,
}

impl Built {
    fn all() -> Result<Self> {
        same_version()?;
        let folder = project::target("wasm");
        let (glue, gallery, page) = (folder.join("glue"), folder.join("gallery.json"), project::target("web"));
        bind(&module(&folder)?, &glue)?;
        write_example("gallery", &root(), &gallery)?;
        let manual = folder.join("manual.json");
        write_example("manual", &root(), &manual)?;
        let crates = folder.join("crates.txt");
        write(&crates, &licences::of_crates("grafcet-web", TARGET)?)?;
        packages()?;
        project::remove(&page)?;
        run_command(node("build.mjs")?.args([&glue, &gallery, &manual, &crates, &page]))?;
        Ok(Self { folder, glue, page })
    }
}

/// The compiler and the simulation as WebAssembly.
fn module(folder: &Path) -> Result<PathBuf> {
    let compiler = BareMetal::find(TARGET)?;
    println!("web: {}, {}", compiler.describe(), compiler.version()?);
    // A module to load it is here alone: on the host, where the examples ask the runtime for `defmt`, no linker makes one, as the names of
    // that crate's symbols are no names to it.
    let mut command = compiler.cargo_with("rustc", TARGET, "std,panic_abort");
    command
        .args(["--quiet", "--locked", "--profile", "web", "--package", "grafcet-web", "--lib"])
        .args(["--crate-type", "cdylib", "--target-dir"])
        .arg(folder);
    run_command(&mut command)?;
    Ok(folder.join(TARGET).join("web/grafcet_web.wasm"))
}

/// The JavaScript beside it.
fn bind(module: &Path, glue: &Path) -> Result {
    let manifest = root().join(BIND).join("Cargo.toml");
    let mut command = cargo(&["run", "--quiet", "--locked", "--manifest-path"]);
    command.arg(manifest).arg("--target-dir").arg(project::target("bind")).arg("--").args([module, glue]);
    run_command(&mut command)
}

/// What an example of the crate prints about a folder.
fn write_example(name: &'static str, folder: &Path, file: &Path) -> Result {
    write(file, &capture(Program::Example(name).command()?.arg(folder))?)
}

fn write(file: &Path, text: &str) -> Result {
    fs::write(file, text).map_err(|error| format!("{}: {error}", file.display()))
}

/// The packages of the page, as its lock file has them.
fn packages() -> Result {
    let page = root().join(PAGE);
    let time = |path: &str| fs::metadata(page.join(path)).and_then(|data| data.modified()).ok();
    if time("node_modules/.package-lock.json") > time("package-lock.json") {
        return Ok(());
    }
    run_command(
        Command::new(of_node("npm")?).args(["ci", "--no-audit", "--no-fund", "--ignore-scripts"]).current_dir(page),
    )
}

fn node(script: &str) -> Result<Command> {
    let mut command = Command::new(of_node("node")?);
    command.arg(script).current_dir(root().join(PAGE));
    Ok(command)
}

/// A program of Node.js.
fn of_node(name: &str) -> Result<PathBuf> {
    find(name).ok_or_else(|| format!("{name} is not in the PATH; install Node.js 20 or newer, which brings npm along"))
}

/// The two parts of wasm-bindgen understand each other only where they are of one version.
fn same_version() -> Result {
    let version = |file: &str, package: &str| {
        let path = root().join(file);
        let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let found = locked(&text, package).map(str::to_owned);
        found.ok_or_else(|| format!("{} has no {package}", path.display()))
    };
    let library = version("Cargo.lock", "wasm-bindgen")?;
    let program = version(&format!("{BIND}/Cargo.lock"), "wasm-bindgen-cli-support")?;
    if library == program {
        return Ok(());
    }
    Err(format!(
        "the module is built with wasm-bindgen {library}, and {BIND} with {program}: write `={library}` into {BIND}/Cargo.toml"
    ))
}

/// The version of a package in a lock file.
fn locked<'t>(lock: &'t str, package: &str) -> Option<&'t str> {
    let (_, after) = lock.split_once(&format!("name = \"{package}\"\nversion = \""))?;
    after.split_once('"').map(|(version, _)| version)
}

/// How much a visitor loads.
fn sizes(page: &Path) -> Result<String> {
    let size = |file: &str| {
        let path = page.join(file);
        let data = fs::metadata(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        Ok::<_, String>(format!("{file} {} KB", data.len() / 1000))
    };
    Ok([size("grafcet_bg.wasm")?, size("main.js")?].join(", "))
}

#[cfg(test)]
mod tests {
    use super::{locked, same_version};

    #[test]
    fn a_version_is_found_in_a_lock_file() {
        let lock =
            "[[package]]\nname = \"a-b\"\nversion = \"0.1.0\"\n\n[[package]]\nname = \"a\"\nversion = \"0.2.7\"\n";
        assert_eq!((locked(lock, "a"), locked(lock, "b")), (Some("0.2.7"), None));
    }

    #[test]
    fn both_parts_of_wasm_bindgen_are_of_one_version() {
        assert_eq!(same_version(), Ok(()));
    }
}
