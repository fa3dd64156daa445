//! Writes two modules for each chart of the corpus, one with `encoding flags;`, so that `cargo test` compiles all of them
//! through the macro.
#![allow(clippy::format_collect, reason = "texts of a few lines; clearer than a loop that writes")]

use std::error::Error;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::{env, fs};

#[path = "src/chart.rs"]
#[allow(dead_code, unreachable_pub, reason = "the library uses the rest")]
mod chart;
#[path = "src/emit.rs"]
#[allow(unreachable_pub, reason = "public in the library")]
mod emit;
#[path = "src/fragments.rs"]
#[allow(unreachable_pub, reason = "public in the library")]
mod fragments;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::var("CARGO_MANIFEST_DIR")?;
    println!("cargo::rerun-if-changed={folder}");
    let mut files = Vec::new();
    for entry in fs::read_dir(&folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "chart") {
            files.push(path);
        }
    }
    files.sort();
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let (mut modules, mut list) = (String::new(), String::new());
    for path in &files {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let text = fs::read_to_string(path)?;
        let (chart, _) = text.split_once("\n---\n").ok_or_else(|| format!("{name}: no line `---`"))?;
        let end = chart.rfind('}').ok_or_else(|| format!("{name}: no end of the chart"))?;
        let flags = format!("{}encoding flags;\n{}", &chart[..end], &chart[end..]);
        for (name, chart) in [(name.to_string(), chart), (format!("{name}_flags"), &flags)] {
            let module = out.join(format!("{name}.rs"));
            fs::write(&module, emit::module(chart, emit::MACRO).map_err(|error| format!("{name}: {error}"))?)?;
            writeln!(modules, "#[path = r\"{}\"] mod {name};", module.display())?;
            let subject = format!("|| Box::new({name}::Compiled::default())");
            let file = format!("include_str!(r\"{}\")", path.display());
            writeln!(list, "    Entry {{ name: \"{name}\", text: {file}, subject: {subject} }},")?;
        }
    }
    let code = format!("{modules}\n/// The corpus.\nconst CORPUS: &[Entry] = &[\n{list}];\n");
    fs::write(out.join("corpus.rs"), code)?;
    Ok(())
}
