//! The conformance corpus, charts and timelines, as JSON: `cargo run -p grafcet-web --example timelines -- FOLDER`.

#[allow(dead_code, unreachable_pub, clippy::format_collect, reason = "shared with those that compile charts")]
#[path = "../../tests/conformance/src/fragments.rs"]
mod fragments;
#[allow(dead_code, unreachable_pub, reason = "shared by all runners")]
#[path = "../../tests/conformance/reader.rs"]
mod reader;

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use reader::{Asked, Expected, Kind};
use serde_json::{Value, json};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("usage: timelines FOLDER")?);
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<_, std::io::Error>>()?;
    files.retain(|file| file.extension().is_some_and(|end| end == "chart"));
    files.sort();
    let mut cases = Vec::new();
    for file in files {
        let case = reader::read(&fs::read_to_string(&file)?).map_err(|error| format!("{}: {error}", file.display()))?;
        let lines = case.lines.iter().map(|line| json!({ "number": line.number, "does": does(&line.kind) }));
        cases.push(json!({
            "name": file.file_stem().unwrap_or_default().to_string_lossy(),
            "chart": fragments::plain(&case.chart),
            "lines": lines.collect::<Vec<_>>(),
        }));
    }
    println!("{}", Value::Array(cases));
    Ok(())
}

fn does(kind: &Kind) -> Value {
    match kind {
        Kind::Cycle { inputs, now, expected } => {
            json!({ "is": "cycle", "inputs": inputs, "now": now, "expected": shown(expected) })
        }
        Kind::Force { asked: Asked::Steps(steps), inputs, now, expected } => {
            json!({ "is": "force", "steps": steps, "inputs": inputs, "now": now, "expected": shown(expected) })
        }
        Kind::Force { .. } => unreachable!("random timelines alone name situations by number"),
        Kind::Shows(expected) => json!({ "is": "shows", "expected": shown(expected) }),
        Kind::Init => json!({ "is": "init" }),
        Kind::Params(params) => json!({ "is": "params", "params": params }),
        // How long one may sleep, and which situations the compiled chart takes, a simulation does not say.
        Kind::Refuses(_) | Kind::Wakes(_) => json!({ "is": "nothing" }),
    }
}

fn shown(expected: &Expected) -> Value {
    json!({ "steps": expected.steps, "stable": expected.stable, "outputs": expected.outputs, "calls": expected.calls })
}
