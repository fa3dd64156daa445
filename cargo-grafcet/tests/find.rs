//! Which charts are found.

mod common;

use common::{MANIFEST, folder, tool};

/// A chart of this name without mistakes.
fn chart(name: &str) -> String {
    format!("grafcet::grafcet! {{ sfc {name} {{ input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; }} }}\n")
}

/// The names of the charts that are drawn.
fn drawn(folder: &std::path::Path, arguments: &[&str]) -> Vec<String> {
    let done = tool(folder, &[&["draw", "--format", "mermaid", "--out", "out"], arguments].concat());
    assert_eq!(done.code, Some(0), "{done:?}");
    let names = done.out.lines().map(|line| line.trim_start_matches("out/").trim_end_matches(".mmd").to_owned());
    names.collect()
}

#[test]
fn every_chart_of_a_crate() {
    let main = format!(
        "mod plain; #[path = \"elsewhere/other.rs\"] mod named; mod inline {{ mod deep; #[path = \"at.rs\"] mod path; }}
         #[cfg(windows)] mod never;
         {} fn f() {{ {} }} macro_rules! m {{ () => {{ {} }} }} fn main() {{}}",
        chart("Top"),
        chart("InFunction"),
        chart("InMacroRules"),
    );
    let mut files = vec![MANIFEST, ("src/main.rs", main.as_str())];
    let texts = [
        ("src/plain.rs", format!("mod below; {}", chart("Plain"))),
        ("src/plain/below/mod.rs", format!("mod last; {}", chart("Below"))),
        ("src/plain/below/last.rs", chart("Last")),
        ("src/elsewhere/other.rs", format!("mod beside; {}", chart("Other"))),
        ("src/elsewhere/beside.rs", chart("Beside")),
        ("src/inline/deep.rs", chart("Deep")),
        ("src/inline/at.rs", chart("At")),
        ("src/unused.rs", chart("Unused")),
        ("tests/works.rs", format!("#[path = \"../src/plain/below/last.rs\"] mod last; {}", chart("InTest"))),
        ("examples/shows.rs", chart("InExample")),
    ];
    files.extend(texts.iter().map(|(name, text)| (*name, text.as_str())));
    let folder = folder(&files);
    let mut names = drawn(folder.path(), &[]);
    names.sort();
    let expected =
        ["At", "Below", "Beside", "Deep", "InExample", "InFunction", "InTest", "Last", "Other", "Plain", "Top"];
    assert_eq!(names, expected);
    assert_eq!(drawn(folder.path(), &["--chart", "Deep", "--chart", "Top"]), ["Top", "Deep"]);
    // From a folder below, and from elsewhere.
    let below = folder.path().join("src");
    assert_eq!(tool(&below, &["check"]).out, "11 charts: nothing to say\n");
    assert_eq!(tool(&below, &["check", "--manifest-path", "../Cargo.toml", "--chart", "At"]).code, Some(0));
}

#[test]
fn the_crates_of_a_workspace() {
    let files = [
        (
            "Cargo.toml",
            "[workspace]\nmembers = [\"a\", \"b\", \"c\"]\ndefault-members = [\"a\", \"b\"]\nresolver = \"3\"\n"
                .to_owned(),
        ),
        ("a/Cargo.toml", "[package]\nname = \"a\"\nedition = \"2024\"\n".to_owned()),
        ("b/Cargo.toml", "[package]\nname = \"b\"\nedition = \"2024\"\n".to_owned()),
        ("c/Cargo.toml", "[package]\nname = \"c\"\nedition = \"2024\"\n".to_owned()),
        ("a/src/lib.rs", chart("InA")),
        ("b/src/lib.rs", chart("InB")),
        ("c/src/lib.rs", "fn nothing() {}".to_owned()),
    ];
    let files: Vec<(&str, &str)> = files.iter().map(|(name, text)| (*name, text.as_str())).collect();
    let folder = folder(&files);
    assert_eq!(drawn(folder.path(), &[]), ["InA", "InB"]);
    assert_eq!(drawn(folder.path(), &["--workspace"]), ["InA", "InB"]);
    assert_eq!(drawn(folder.path(), &["-p", "b"]), ["InB"]);
    assert_eq!(drawn(&folder.path().join("a"), &[]), ["InA"]);
    let done = tool(folder.path(), &["check", "-p", "c"]);
    assert_eq!((done.code, done.err.as_str()), (Some(2), "error: there is no `grafcet!` in the crate c\n"));
    let done = tool(folder.path(), &["check", "-p", "d"]);
    assert_eq!((done.code, done.err.as_str()), (Some(2), "error: there is no crate `d` in the workspace\n"));
}

#[test]
fn a_file_with_a_chart_alone() {
    let alone = "/// One.\npub sfc Alone { input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; }\n";
    let folder = folder(&[("one.grafcet", alone), ("none.rs", "fn main() {}"), ("bad.rs", "fn main() { \"")]);
    assert_eq!(drawn(folder.path(), &["one.grafcet", "none.rs"]), ["Alone"]);
    let done = tool(folder.path(), &["check", "none.rs"]);
    assert_eq!((done.code, done.err.as_str()), (Some(2), "error: there is no `grafcet!` in none.rs, and no chart\n"));
    let done = tool(folder.path(), &["check", "bad.rs"]);
    assert_eq!(done.code, Some(2));
    assert!(done.err.contains("--> bad.rs:1:13"), "{}", done.err);
    let done = tool(folder.path(), &["check", "gone.rs"]);
    assert_eq!(done.code, Some(2));
    assert!(done.err.starts_with("error: gone.rs: "), "{}", done.err);
}

#[test]
fn what_is_not_there() {
    let main = format!("mod gone;\n{}{}", chart("Press"), chart("Drill"));
    let folder = folder(&[MANIFEST, ("src/main.rs", &main)]);
    let done = tool(folder.path(), &["check"]);
    assert_eq!(done.code, Some(2));
    for part in ["src/main.rs:1:5", "there is no file for this module: `src/gone.rs` or `src/gone/mod.rs`"] {
        assert!(done.err.contains(part), "{part}: {}", done.err);
    }
    let sentence = |arguments: &[&str]| tool(folder.path(), &[&["draw", "src/main.rs"], arguments].concat()).err;
    assert_eq!(sentence(&["--chart", "press"]), "error: there is no chart `press`, but `Press`\n");
    let choice = "say which one: --chart Press, --chart Drill";
    assert_eq!(sentence(&["--chart", "Saw"]), format!("error: there is no chart `Saw`; {choice}\n"));
    assert_eq!(
        sentence(&[]),
        format!("error: 2 charts, and one goes to one output: {choice}; or --out FOLDER for all\n")
    );
}
