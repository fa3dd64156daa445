//! Writes a module for each chart of the corpus, and hands the board's memory map to the linker.

// These files, and not the crate that they belong to: with the interpreter and the prover that crate would take longer to build than all
// else here, and ask for a compiler of charts that no other image needs.
#[path = "../src/board.rs"]
#[allow(unreachable_pub, reason = "public in the library")]
mod board;
#[path = "../src/chart.rs"]
#[allow(dead_code, unreachable_pub, reason = "the library uses the rest")]
mod chart;
#[path = "../src/emit.rs"]
#[allow(dead_code, unreachable_pub, reason = "the library uses the rest")]
mod emit;
#[path = "../src/fragments.rs"]
#[allow(dead_code, unreachable_pub, reason = "the library uses the rest")]
mod fragments;
#[path = "../reader.rs"]
#[allow(dead_code, unreachable_pub, reason = "the library uses the rest")]
mod reader;
#[path = "../src/subject.rs"]
#[allow(dead_code, unused_imports, unreachable_pub, reason = "the library uses the rest")]
mod subject;

use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

use subject::Values;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::var("CARGO_MANIFEST_DIR")?;
    println!("cargo::rerun-if-changed=memory.x");
    println!("cargo::rustc-link-search={folder}");
    println!("cargo::rustc-link-arg-bins=-Tlink.x");

    let corpus = Path::new(&folder).join("..");
    println!("cargo::rerun-if-changed={}", corpus.display());
    let mut files: Vec<_> =
        fs::read_dir(&corpus)?.collect::<Result<Vec<_>, _>>()?.iter().map(fs::DirEntry::path).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "chart"));
    files.sort();
    let (first, second) = files.split_at(files.len().div_ceil(2));
    write("first_half", first)?;
    write("second_half", second)
}

/// The modules of some charts, and a list of them.
fn write(half: &str, files: &[PathBuf]) -> Result<(), Box<dyn Error>> {
    let (mut modules, mut list) = (String::new(), String::new());
    for path in files {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let module = board::module(&fs::read_to_string(path)?);
        let module = module.map_err(|error| format!("{name}: {error}"))?;
        writeln!(modules, "mod {name} {{\n{module}}}")?;
        writeln!(list, "    (\"{name}\", {name}::play),")?;
    }
    let code = format!("{modules}\npub(crate) const ALL: &[crate::run::Chart] = &[\n{list}];\n");
    fs::write(Path::new(&env::var("OUT_DIR")?).join(format!("{half}.rs")), code)?;
    Ok(())
}
