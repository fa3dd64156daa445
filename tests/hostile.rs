//! Charts in surroundings where careless generated code breaks: the crates in `tests/hostile`, each of which says what is
//! unusual about it. They are crates of their own because lints, names and dependencies belong to a whole crate.

use std::path::Path;
use std::process::{Command, Output};

/// Runs cargo in the folder of these crates.
fn cargo(arguments: &[&str]) -> (Output, String) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/hostile");
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).args(["--quiet", "--locked"]).arg("--manifest-path").arg(folder.join("Cargo.toml"));
    // Beside the folder of the build that started this test, which may hold its lock.
    command.arg("--target-dir").arg(Path::new(env!("CARGO_TARGET_TMPDIR")).join("hostile"));
    // Flags for this project are not for those.
    command.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    let output = command.output().expect("cargo starts");
    let text = String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
    let text = text.into_owned();
    (output, text)
}

/// Clippy, so that denied lints are looked for, then the tests of the crates.
#[test]
fn charts_compile_and_run_in_hostile_surroundings() {
    let all = |command: &str| {
        let (output, text) = cargo(&[command, "--workspace", "--all-targets"]);
        assert!(output.status.success(), "cargo {command} in tests/hostile:\n{text}");
        text
    };
    all("clippy");
    let tested = all("test");
    let ran = tested.lines().filter(|line| line.starts_with("test result: ok.") && !line.contains(" 0 passed"));
    assert_eq!(ran.count(), 7, "all crates but the facade have tests:\n{tested}");
}

#[test]
fn mistakes_have_their_messages_in_the_first_edition_too() {
    let (output, text) = cargo(&["check", "--package", "hostile-edition2015", "--features", "mistakes"]);
    assert!(!output.status.success());
    for message in ["no name `onn` is declared", "no step is called `B`"] {
        assert!(text.contains(message), "{text}");
    }
    assert!(!text.contains("E0433"), "{text}");
}
