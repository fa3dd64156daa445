//! What `import` writes and says, and by which exit code.

mod common;

use std::fs;

use common::{folder, tool};

const LAMP: &str = "PROGRAM LAMP
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT lit : BOOL; END_VAR
INITIAL_STEP Dark: END_STEP
TRANSITION FROM Dark TO Bright := go; END_TRANSITION
STEP Bright: lit(N); END_STEP
TRANSITION FROM Bright TO Dark := NOT go; END_TRANSITION
END_PROGRAM
";

#[test]
fn a_chart_that_the_tool_takes() {
    let folder = folder(&[("lamp.st", LAMP)]);
    let done = tool(folder.path(), &["import", "lamp.st", "-o", "lamp.rs"]);
    assert_eq!((done.code, &*done.out, &*done.err), (Some(0), "", ""));
    let checked = tool(folder.path(), &["check", "lamp.rs"]);
    assert_eq!((checked.code, &*checked.out), (Some(0), "1 chart: nothing to say\n"), "{checked:?}");
    let back = tool(folder.path(), &["export", "sfc", "lamp.rs"]);
    assert!(back.out.contains("TRANSITION FROM Bright TO Dark\n  := NOT go;\nEND_TRANSITION"), "{back:?}");
}

#[test]
fn what_is_no_chart_is_shown_at_its_place() {
    let broken = LAMP.replace("TO Bright := go;", "TO Bright go;");
    let folder =
        folder(&[("broken.st", &broken), ("deep/broken.xml", "<project>\n  <pou>\n</project>"), ("plain.st", "")]);
    let done = tool(folder.path(), &["import", "broken.st"]);
    let expected = "error: expected `:=`, found `go`\n --> broken.st:5:32\n  |\n5 | TRANSITION FROM Dark TO Bright go; END_TRANSITION\n  |                                ^^\n";
    assert_eq!((done.code, &*done.out, &*done.err), (Some(2), "", expected));
    let done = tool(folder.path(), &["import", "deep/broken.xml"]);
    let lines: Vec<&str> = done.err.lines().collect();
    assert_eq!((done.code, &*done.out), (Some(2), ""));
    assert!(lines[0].starts_with("error: this is no XML:"), "{lines:?}");
    assert_eq!(lines[1], " --> deep/broken.xml:3:1");
    let done = tool(folder.path(), &["import", "plain.st"]);
    assert_eq!(
        (done.code, done.err.lines().next()),
        (Some(2), Some("error: there is no program in this file: no step"))
    );
    let done = tool(folder.path(), &["import", "missing.st"]);
    assert!(done.code == Some(2) && done.err.contains("missing.st: "), "{done:?}");
}

/// What the compiler refuses is counted, and what was left out said at its line; JSON has both.
#[test]
fn what_is_to_be_looked_at() {
    let text = LAMP.replace("lit(N);", "lit(N); gone(N);").replace("FROM Bright TO Dark", "FROM Bright TO Bright");
    let folder = folder(&[("lamp.st", &text)]);
    let done = tool(folder.path(), &["import", "lamp.st", "-o", "lamp.rs"]);
    assert_eq!(done.code, Some(1));
    let lines: Vec<&str> = done.err.lines().collect();
    assert_eq!(
        lines[..2],
        ["warning: `gone` is neither an action nor a boolean of this program: left out", " --> lamp.st:6:22"]
    );
    let done = tool(folder.path(), &["import", "lamp.st", "--json"]);
    let object: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(object["charts"][0]["name"], "Lamp");
    assert_eq!(object["charts"][0]["notes"][0]["line"], 6);
    assert_eq!(object["charts"][0]["renamed"][0]["there"], "LAMP");
    assert_eq!(object["rust"].as_str(), fs::read_to_string(folder.path().join("lamp.rs")).ok().as_deref());
}

/// A file in another encoding is said to be one.
#[test]
fn a_file_that_is_no_text() {
    let folder = folder(&[]);
    fs::write(folder.path().join("latin.st"), b"PROGRAM P (* gr\xf6\xdfe *)").expect("a file");
    let done = tool(folder.path(), &["import", "latin.st"]);
    assert!(done.code == Some(2) && done.err.starts_with("error: latin.st:"), "{done:?}");
}
