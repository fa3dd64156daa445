//! What the compiler says about charts with mistakes, word by word, and that charts nearly the same compile.
//!
//! A folder a group of rules, a file a rule, with the whole message beside it; `<rule>.neighbour.rs` is the chart next to
//! it that is right. `notation`, `types`, `levels` and `whole` are about the compiler rather than a rule.

use std::path::PathBuf;
use std::{fs, io};

#[test]
fn messages_and_neighbours() -> io::Result<()> {
    let cases = trybuild::TestCases::new();
    for file in files()? {
        if file.to_string_lossy().ends_with(".neighbour.rs") {
            cases.pass(file);
        } else {
            cases.compile_fail(file);
        }
    }
    Ok(())
}

/// All charts, in an order that does not depend on the machine.
fn files() -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for group in fs::read_dir("tests/ui")? {
        for file in fs::read_dir(group?.path())? {
            files.push(file?.path());
        }
    }
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    assert!(files.len() > 30, "the charts are not where this test looks for them");
    Ok(files)
}
