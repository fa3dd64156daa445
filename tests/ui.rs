//! What the compiler says about charts with mistakes, word by word.
//!
//! A folder a group of rules, a file a rule, with the whole message beside it; `<rule>.neighbour.rs` is the chart next to
//! it that is right (see `neighbours.rs`). `notation`, `types`, `levels` and `whole` are about the compiler rather than a
//! rule. `cargo xtask bless` records the messages anew.

use std::{fs, io};

#[test]
fn messages() -> io::Result<()> {
    let cases = trybuild::TestCases::new();
    let mut count = 0;
    for group in fs::read_dir("tests/ui")? {
        for file in fs::read_dir(group?.path())? {
            let file = file?.path();
            let name = file.to_string_lossy();
            if name.ends_with(".rs") && !name.ends_with(".neighbour.rs") {
                cases.compile_fail(&file);
                count += 1;
            }
        }
    }
    assert!(count > 40, "the charts are not where this test looks for them");
    Ok(())
}

/// What is underlined is a name, a condition, a keyword: never a chart from end to end, also in what rustc says of generated code.
#[test]
fn no_message_underlines_a_whole_chart() -> io::Result<()> {
    let mut count = 0;
    for group in fs::read_dir("tests/ui")? {
        for file in fs::read_dir(group?.path())? {
            let file = file?.path();
            if file.extension().is_none_or(|extension| extension != "stderr") {
                continue;
            }
            let text = fs::read_to_string(&file)?;
            for line in text.lines() {
                // `12 | / grafcet! {`: what is underlined begins here and ends on another line.
                let begins = line.split_once(" | ").is_some_and(|(_, code)| {
                    code.trim_start().strip_prefix('/').is_some_and(|code| code.trim_start().starts_with("grafcet!"))
                });
                assert!(!begins, "{}: {line}", file.display());
            }
            count += 1;
        }
    }
    assert!(count > 40, "the messages are not where this test looks for them");
    Ok(())
}
