//! Writes a module for each chart of the corpus, and hands the board's memory map to the linker.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

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
    let (mut modules, mut list) = (String::new(), String::new());
    for path in &files {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let module = grafcet_conformance::board::module(&fs::read_to_string(path)?);
        let module = module.map_err(|error| format!("{name}: {error}"))?;
        writeln!(modules, "mod {name} {{\n{module}}}")?;
        writeln!(list, "    (\"{name}\", {name}::play),")?;
    }
    let code = format!("{modules}\npub(crate) const ALL: &[(&str, fn() -> Result<(), u32>)] = &[\n{list}];\n");
    fs::write(Path::new(&env::var("OUT_DIR")?).join("corpus.rs"), code)?;
    Ok(())
}
