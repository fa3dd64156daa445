//! The pages of the manual with the charts in them, as JSON: `cargo run -p grafcet-web --example manual -- ROOT`.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use grafcet_web::gallery::{Block, blocks};
use serde_json::{Value, json};

fn main() -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(std::env::args().nth(1).ok_or("usage: manual ROOT")?);
    let mut files = vec!["README.md".to_owned()];
    for folder in ["docs", "docs/decisions"] {
        files.extend(of_folder(&root, folder)?);
    }
    let pages = files.into_iter().map(|file| page(&root, &file)).collect::<Result<Vec<_>, _>>()?;
    println!("{}", Value::from(pages));
    Ok(())
}

/// The pages of a folder, by their names from the root.
fn of_folder(root: &Path, folder: &str) -> Result<Vec<String>, std::io::Error> {
    let mut files = Vec::new();
    for entry in fs::read_dir(root.join(folder))? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if Path::new(&name).extension().is_some_and(|end| end == "md") {
            files.push(format!("{folder}/{name}"));
        }
    }
    files.sort();
    Ok(files)
}

/// Its text, and the charts of each block of Rust that a reader sees.
fn page(root: &Path, file: &str) -> Result<Value, Box<dyn Error>> {
    let text = fs::read_to_string(root.join(file)).map_err(|error| format!("{file}: {error}"))?;
    let found = blocks(&text).map_err(|error| format!("{file}: {error}"))?;
    let blocks: Vec<Value> = found.iter().filter(|block| !block.seen.is_empty()).map(entry).collect();
    Ok(json!({ "file": file, "text": text, "blocks": blocks }))
}

fn entry(block: &Block) -> Value {
    let chart = |place: &usize| json!({ "name": block.charts[*place].name, "text": block.charts[*place].text });
    json!({ "text": block.text, "fails": block.fails, "charts": block.seen.iter().map(chart).collect::<Vec<_>>() })
}
