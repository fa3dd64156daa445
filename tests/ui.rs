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
