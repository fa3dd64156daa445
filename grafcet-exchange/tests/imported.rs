//! The files of `tests/imported`, which stands beside the root's tests: what is made of them is what is kept there, which rustc compiles and
//! `tests/imported.rs` there runs.

use std::fs;
use std::path::PathBuf;

use grafcet_exchange::import::{Imported, import};

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/imported")
}

fn imported(name: &str) -> Imported {
    let text = fs::read_to_string(folder().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    import(&text, name).unwrap_or_else(|wrong| panic!("{name}: {wrong:?}"))
}

/// `cargo xtask bless` records them anew.
#[test]
fn what_is_made_is_what_is_kept() {
    let mut names: Vec<String> = fs::read_dir(folder())
        .expect("a folder")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|ending| ending != "rs"))
        .filter_map(|path| Some(path.file_name()?.to_str()?.to_owned()))
        .collect();
    names.sort();
    assert_eq!(
        names,
        ["blocks.st", "crane.xml", "tank.st", "words.st"],
        "each one is a module of tests/imported.rs, too"
    );
    for name in names {
        let done = imported(&name);
        let kept = folder().join(&name).with_extension("rs");
        if std::env::var_os("BLESS").is_some() {
            fs::write(&kept, &done.rust).expect("written");
        }
        assert_eq!(fs::read_to_string(&kept).unwrap_or_default(), done.rust, "{name}");
    }
}

fn notes(name: &str) -> Vec<String> {
    imported(name).charts.into_iter().flat_map(|chart| chart.notes).map(|note| note.message).collect()
}

/// What a person has to look at, of each file.
#[test]
fn what_is_said() {
    let soak = "`Soak` is called in some steps alone: here its time begins with them";
    assert_eq!(notes("blocks.st")[0], soak);
    assert!(notes("words.st").is_empty());
    assert_eq!(
        notes("crane.xml"),
        [
            "`SuckTimer` is called in some steps alone: here its time begins with them",
            "nothing that is translated writes `SFCInit`: it is an input",
            "left out: the action `Forgotten`, which belongs to no step",
            "left out: that the step `Suck` takes T#1S at least: say so in what leaves it",
        ]
    );
}
