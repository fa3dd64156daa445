//! What `draw` writes.

mod common;

use std::fs;

use common::{folder, tool};

const CHARTS: &str = "
grafcet! { sfc Lamp { input on: bool; output lit: bool; initial step Off; step Lit { lit; } Off -[on]-> Lit -[!on]-> Off; } }
mod other { grafcet! { grafcet lamp { input on: bool; output lit: bool; initial step Off; step Lit { lit; } Off -[on]-> Lit -[!on]-> Off; } } }
grafcet! { sfc Open { input a: bool; initial step A; A -[a]-> Nowhere -[!a]-> A; } }
";

#[test]
fn to_the_output_and_to_files() {
    let folder = folder(&[("lamp.rs", CHARTS)]);
    let draw = |arguments: &[&str]| tool(folder.path(), &[&["draw", "lamp.rs"], arguments].concat());
    let text = draw(&["--chart", "Lamp"]).out;
    assert!(text.contains("║ Off ║") && text.contains("│ Lit ├─┤ N │ lit │"), "{text}");
    assert_eq!(draw(&["--chart", "Lamp", "--width", "40"]).out, text);
    assert_ne!(draw(&["--chart", "Lamp", "--active", "Lit"]).out, text);
    assert_eq!(draw(&["--chart", "Lamp", "--format", "mermaid"]).out.lines().next(), Some("flowchart TD"));
    assert!(draw(&["--chart", "Lamp", "--format", "svg"]).out.starts_with("<svg"));
    // The end of the name tells the kind.
    for (file, begin) in [("a.svg", "<svg"), ("a.mmd", "flowchart"), ("a.txt", " ")] {
        let done = draw(&["--chart", "Lamp", "-o", file]);
        assert_eq!((done.code, done.out.as_str()), (Some(0), ""));
        let written = fs::read_to_string(folder.path().join(file)).unwrap_or_default();
        assert!(written.starts_with(begin), "{file}: {written}");
    }
    let done = draw(&["--chart", "Lamp", "--active", "Lot"]);
    assert_eq!((done.code, done.err.as_str()), (Some(2), "error: the chart Lamp has no step `Lot`\n"));
}

#[test]
fn all_to_a_folder() {
    let folder = folder(&[("lamp.rs", CHARTS)]);
    let done = tool(folder.path(), &["draw", "lamp.rs", "--out", "drawn/all"]);
    // A chart that cannot be drawn says why, and the others are drawn.
    assert_eq!(done.code, Some(1));
    let lines: Vec<&str> = done.out.lines().collect();
    assert_eq!(lines, ["drawn/all/Lamp.svg", "drawn/all/lamp-2.svg"]);
    let first = done.err.lines().next().unwrap_or_default();
    assert!(first.starts_with("error") && first.contains("`Nowhere`"), "{first}");
    let mut files: Vec<_> = fs::read_dir(folder.path().join("drawn/all"))
        .into_iter()
        .flatten()
        .flatten()
        .map(|file| file.file_name())
        .collect();
    files.sort();
    assert_eq!(files, ["Lamp.svg", "lamp-2.svg"]);
}
