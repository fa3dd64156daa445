//! What is odd: layouts of files, signs, sizes, outputs that cannot be written.

mod common;

use std::fs::{self, File};
use std::process::{Command, Stdio};

use common::{MANIFEST, folder, tool};
use serde_json::Value;

const GOOD: &str = "sfc Mo { input on: bool; output q: bool; initial step A; step B { q; } A -[on]-> B -[!on]-> A; }";
const BAD: &str = "sfc Mo { input on: bool; output q: bool; initial step A; step B { q; } A -[on]-> B -[!onn]-> A; }";

/// What is wrong is where the file has it, whatever its lines end with, and whatever stands before and in them.
#[test]
fn places_in_odd_files() {
    let files = [
        ("crlf.rs", format!("use grafcet::grafcet;\r\n\r\ngrafcet! {{\r\n  {}\r\n}}\r\n", BAD.replace("; ", ";\r\n"))),
        ("mark.rs", format!("\u{feff}grafcet! {{ {BAD} }}\n")),
        ("shell.rs", format!("#!/usr/bin/env run\ngrafcet! {{ {BAD} }}\n")),
        (
            "größe ü.rs",
            format!("// Größe 🚧\ngrafcet! {{ {} }}\n", BAD.replace("step B", "step Ö").replace("-> B", "-> Ö")),
        ),
        ("alone.rs", BAD.to_owned()),
    ];
    for (name, text) in &files {
        let folder = folder(&[(name, text)]);
        let done = tool(folder.path(), &["check", name, "--json"]);
        assert_eq!(done.code, Some(1), "{name}: {done:?}");
        let said: Value = serde_json::from_str(done.out.trim_end()).expect(name);
        let place = &said["notes"][0];
        let number = |at: &Value| usize::try_from(at.as_u64().expect("a number")).expect("small");
        let (from, to) = (number(&place["bytes"][0]), number(&place["bytes"][1]));
        assert_eq!(text.get(from..to), Some("onn"), "{name}: {said}");
        // Columns count characters, without the mark.
        let (line, column) = (number(&place["start"]["line"]), number(&place["start"]["column"]));
        let line = text.trim_start_matches('\u{feff}').lines().nth(line - 1).expect("a line");
        let rest: String = line.chars().skip(column - 1).take(3).collect();
        assert_eq!(rest, "onn", "{name}: {said}");
        let done = tool(folder.path(), &["check", name]);
        assert!(done.out.contains(&format!("--> {name}:")) && done.out.contains("^^^"), "{name}: {done:?}");
    }
}

#[test]
fn files_that_are_none() {
    let folder = folder(&[
        ("empty.rs", ""),
        ("text.rs", "that is no chart"),
        ("open.rs", "grafcet! { sfc A {"),
        ("sub/x.txt", ""),
    ]);
    fs::write(folder.path().join("wide.rs"), b"\xff\xfeg\0r\0").expect("a file");
    for (name, said) in [
        ("empty.rs", "error: there is no `grafcet!` in empty.rs, and no chart\n"),
        ("text.rs", "error: there is no `grafcet!` in text.rs, and no chart\n"),
        ("none.rs", "error: none.rs: No such file or directory (os error 2)\n"),
        ("sub", "error: sub: Is a directory (os error 21)\n"),
        ("wide.rs", "error: wide.rs: stream did not contain valid UTF-8\n"),
    ] {
        for command in ["check", "draw", "tests", "prove"] {
            let done = tool(folder.path(), &[command, name]);
            assert_eq!((done.code, done.out.as_str(), done.err.as_str()), (Some(2), "", said), "{command}");
        }
    }
    let done = tool(folder.path(), &["check", "open.rs"]);
    assert!(done.code == Some(2) && done.err.contains("--> open.rs:1:18"), "{done:?}");
    // No crate here or above.
    let done = tool(folder.path(), &["check"]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(done.err.ends_with("does not tell what belongs to the crate; a file can be named instead\n"), "{done:?}");
}

/// Modules within modules, of other paths, of tests and in functions; what stands in comments and strings is none.
#[test]
fn charts_wherever_they_are() {
    let chart = |name: &str| format!("grafcet::grafcet! {{ {} }}", GOOD.replace("Mo", name));
    let lib = format!(
        "mod deep; mod inline {{ mod more {{ {} }} }} #[cfg(test)] mod tests {{ {} }} #[path = \"elsewhere/odd.rs\"] mod odd;
        #[cfg(any())] mod missing; fn f() {{ {} mod inner {{ {} }} }}",
        chart("Inline"), chart("Test"), chart("Function"), chart("Inner"),
    );
    let deeper =
        format!("{} /* {} */ // {}\nconst S: &str = r#\"{}\"#;", chart("Deeper"), chart("X"), chart("Y"), chart("Z"));
    let files = [
        MANIFEST,
        ("src/lib.rs", &lib),
        ("src/elsewhere/odd.rs", &chart("Odd")),
        ("src/deep/mod.rs", &format!("pub mod deeper; {}", chart("Deep"))),
        ("src/deep/deeper.rs", &deeper),
    ];
    let folder = folder(&files);
    let done = tool(folder.path(), &["draw", "--out", "out"]);
    assert_eq!(done.code, Some(0), "{done:?}");
    let mut found: Vec<&str> = done.out.lines().collect();
    found.sort_unstable();
    let names = ["Deep", "Deeper", "Function", "Inline", "Inner", "Odd", "Test"].map(|name| format!("out/{name}.svg"));
    assert_eq!(found, names);
    fs::remove_file(folder.path().join("src/elsewhere/odd.rs")).expect("a file");
    let done = tool(folder.path(), &["check"]);
    assert!(done.code == Some(2) && done.err.contains("--> src/lib.rs:1:"), "{done:?}");
}

/// Who stops reading is no error; a full disk, and a file where a folder should be, is one.
#[test]
fn outputs_that_take_nothing() {
    let old = GOOD.replace("!on", "!on || on");
    let folder = folder(&[("m.rs", GOOD), ("old.rs", &old), ("taken", "")]);
    let commands = [
        "check m.rs --sarif",
        "draw m.rs",
        "draw m.rs --format pdf",
        "diff old.rs m.rs --draw",
        "export st m.rs",
        "export plcopen m.rs",
        "tests m.rs",
        "--help",
    ];
    for command in commands {
        let run = |out: Stdio| {
            let mut tool = Command::new(env!("CARGO_BIN_EXE_cargo-grafcet"));
            tool.arg("grafcet").args(command.split(' ')).current_dir(folder.path()).stdout(out).stderr(Stdio::piped());
            tool.output().expect("the tool runs")
        };
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let done = run(writer.into());
        assert!(done.status.code().is_some_and(|code| code < 2) && done.stderr.is_empty(), "{command}: {done:?}");
        if command != "--help" && cfg!(target_os = "linux") {
            let done = run(File::options().write(true).open("/dev/full").expect("a full device").into());
            assert_eq!(done.status.code(), Some(2), "{command}: {done:?}");
            let said = String::from_utf8_lossy(&done.stderr).into_owned();
            assert!(said.starts_with("error: the output cannot be written: "), "{command}: {said}");
        }
    }
    for command in [
        "draw m.rs --out taken",
        "draw m.rs -o taken/m.svg",
        "tests m.rs --out taken",
        "export st m.rs -o taken/m.st",
        "diff old.rs m.rs -o taken/m.svg",
        "tests m.rs --protocol taken/m.md",
    ] {
        let done = tool(folder.path(), &command.split(' ').collect::<Vec<_>>());
        assert!(done.code == Some(2) && done.err.starts_with("error: taken"), "{command}: {done:?}");
    }
}

/// A thousand steps: nothing takes minutes, and no stack is too small.
#[test]
fn a_large_chart() {
    let steps: Vec<String> = (1..1_000).map(|step| format!("step S{step} {{ q; }} ")).collect();
    let chain: Vec<String> =
        (1..1_000).map(|step| format!(" -[{}a]-> S{step}", if step % 2 == 0 { "!" } else { "" })).collect();
    let (steps, chain) = (steps.concat(), chain.concat());
    let chart = format!("sfc Big {{ input a: bool; output q: bool; initial step S0; {steps} S0{chain} -[!a]-> S0; }}");
    let folder = folder(&[
        ("big.rs", &chart),
        ("old.rs", &chart.replace("step S7 { q; }", "step S7;").replace("S123 ", "Far ")),
    ]);
    for command in ["draw big.rs", "export st big.rs", "export pnml big.rs", "export sfc big.rs"] {
        let done = tool(folder.path(), &command.split(' ').collect::<Vec<_>>());
        assert_eq!((done.code, done.err.as_str()), (Some(0), ""), "{command}");
    }
    let done = tool(folder.path(), &["diff", "old.rs", "big.rs"]);
    let said = "Big: 2 changes\n  the step `Far` is now called `S123`\n  the step `S7` also does `N q`\n";
    assert_eq!((done.code, done.out.as_str()), (Some(1), said));
}

/// Each command says how it is called, by an example, and what its exit codes mean where they are more than those of all.
#[test]
fn help_of_each_command() {
    let folder = folder(&[]);
    let mut asked = vec![Vec::new()];
    let mut commands = 0;
    while let Some(words) = asked.pop() {
        let done = tool(folder.path(), &[&words[..], &["--help"]].concat());
        assert_eq!((done.code, done.err.as_str()), (Some(0), ""), "{words:?}");
        let below = done
            .out
            .split_once("\nCommands:\n")
            .map(|(_, rest)| rest.split("\n\n").next().unwrap_or_default().to_owned());
        let below: Vec<String> = below
            .iter()
            .flat_map(|list| list.lines())
            .filter_map(|line| {
                let name = line.strip_prefix("  ")?.split(' ').next()?;
                (!name.is_empty() && name != "help").then(|| name.to_owned())
            })
            .collect();
        if below.is_empty() {
            commands += 1;
            let call = format!("  cargo grafcet {}", words.join(" "));
            assert!(done.out.contains("Examples:\n") && done.out.contains(&call), "{words:?}: {}", done.out);
            assert!(done.out.contains("Exit code"), "{words:?}: {}", done.out);
        }
        for name in below {
            let name: &'static str = name.leak();
            asked.push([&words[..], &[name]].concat());
        }
        assert!(!done.out.contains('\u{1b}'), "no colours where there is no terminal");
    }
    assert!(commands >= 13, "{commands}");
}
