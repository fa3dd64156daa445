//! The charts of the repository that the page opens, as JSON: `cargo run -p grafcet-web --example gallery -- ROOT`.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use grafcet_web::gallery::{Shown, of_markdown, of_rust};
use serde_json::{Value, json};

fn main() -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(std::env::args().nth(1).ok_or("usage: gallery ROOT")?);
    let recipes = of_markdown(&fs::read_to_string(root.join("docs/cookbook.md"))?)?;
    let recipes: Vec<Value> = recipes.iter().map(|(task, shown)| entry(shown, Some(task))).collect();
    let shelves = [
        ("Examples", of_folder(&root.join("examples/charts"))?),
        ("Cookbook", recipes),
        ("Machines", of_folder(&root.join("tests/good"))?),
    ];
    let shelves = shelves.map(|(title, charts)| json!({ "title": title, "charts": charts }));
    println!("{}", Value::from(shelves.to_vec()));
    Ok(())
}

fn of_folder(folder: &Path) -> Result<Vec<Value>, Box<dyn Error>> {
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<_, std::io::Error>>()?;
    files.retain(|file| file.extension().is_some_and(|end| end == "rs"));
    files.sort();
    let mut charts = Vec::new();
    for file in files {
        let found = of_rust(&fs::read_to_string(&file)?).map_err(|error| format!("{}: {error}", file.display()))?;
        charts.extend(found.iter().map(|shown| entry(shown, None)));
    }
    Ok(charts)
}

/// What a chart is about: its task, and the first paragraph of its documentation.
fn entry(shown: &Shown, task: Option<&String>) -> Value {
    let docs = shown.text.lines().skip_while(|line| !line.starts_with("/// "));
    let doc: Vec<&str> = docs.map_while(|line| line.strip_prefix("/// ")).collect();
    let doc = doc.join(" ");
    let about: Vec<&str> =
        task.map(String::as_str).into_iter().chain([doc.as_str()]).filter(|text| !text.is_empty()).collect();
    json!({ "name": shown.name, "about": about.join(": "), "text": shown.text })
}
