//! The page of the tool: its commands, run one after the other in a folder of its own, show what stands there.

mod common;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use common::{MANIFEST, folder, tool};

#[test]
fn commands_of_the_page_show_what_stands_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let file = root.join("docs/tool.md");
    let page = fs::read_to_string(&file).expect("the page");
    let folder = folder(&[MANIFEST]);
    let copy = |from: &str, to: &str| fs::copy(root.join(from), folder.path().join(to)).expect("a file of the project");
    copy("tests/record/tests/cell_stopped.record", "cell.record");
    copy("examples/charts/cell.rs", "cell.rs");
    let (mut commands, mut shown) = (Vec::new(), String::new());
    let mut blocks = page.split("```");
    while let Some(text) = blocks.next() {
        shown += text;
        let Some(block) = blocks.next() else { break };
        let (language, body) = block.split_once('\n').expect("a block");
        shown += "```";
        if language == "console" {
            _ = write!(shown, "console\n{}", run(folder.path(), body, &mut commands));
        } else {
            write(folder.path(), language, body);
            shown += block;
        }
        shown += "```";
    }
    for command in [
        "check",
        "draw",
        "diff",
        "export st",
        "export sfc",
        "export plcopen",
        "export pnml",
        "export aiger",
        "export btor2",
        "import",
        "simulate",
        "replay",
        "coverage",
        "tests",
        "prove",
    ] {
        assert!(commands.iter().any(|one| one.starts_with(command)), "no example of {command}");
    }
    // `cargo xtask bless` records it anew.
    if std::env::var_os("BLESS").is_some() {
        fs::write(&file, &shown).expect("the page");
    }
    for (number, (expected, found)) in page.lines().zip(shown.lines()).enumerate() {
        assert_eq!(expected, found, "line {}", number + 1);
    }
    assert_eq!(page.lines().count(), shown.lines().count());
}

/// The commands of a block with what they show.
fn run(folder: &Path, body: &str, commands: &mut Vec<String>) -> String {
    let mut shown = String::new();
    for line in body.lines().filter_map(|line| line.strip_prefix("$ cargo grafcet ")) {
        let (command, code) = line.strip_suffix("; echo $?").map_or((line, false), |command| (command, true));
        let words = shlex::split(command).expect("words of a shell");
        let done = tool(folder, &words.iter().map(String::as_str).collect::<Vec<_>>());
        commands.push(command.to_owned());
        assert!(code || done.code == Some(0), "{command}: {done:?}");
        _ = write!(shown, "$ cargo grafcet {line}\n{}{}", done.out, done.err);
        if code {
            _ = writeln!(shown, "{}", done.code.expect("an exit code"));
        }
    }
    shown.lines().fold(String::new(), |all, line| all + line.trim_end() + "\n")
}

/// A block that is a file: Rust, or what begins with the file's name.
fn write(folder: &Path, language: &str, body: &str) {
    let first = body.lines().next().unwrap_or_default();
    let name = first.strip_prefix("// ").or_else(|| first.strip_prefix("# ")).filter(|name| !name.contains(' '));
    let name = match (language, name) {
        ("rust", None) => "src/main.rs",
        ("rust" | "rust,compile_fail" | "text", Some(name)) => name,
        _ => return,
    };
    // Lines that rustdoc hides.
    let hidden = |line: &&str| language == "text" || !line.starts_with("# ");
    let text = body.lines().filter(hidden).fold(String::new(), |all, line| all + line + "\n");
    let file = folder.join(name);
    fs::create_dir_all(file.parent().expect("a folder")).and_then(|()| fs::write(file, text)).expect("a file");
}
