//! The corpus as a crate of its own, with the macro and nothing else: a fault costs one build of the compiler, not all of the
//! conformance tests. The modules are those that the corpus test has, written once by the sound compiler.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use super::{LIMIT, bounded, read, write};
use crate::command::{Result, capture};
use crate::project::{cargo, root};

/// The crate, and what can stand in it.
pub(super) struct Quick {
    folder: PathBuf,
    modules: PathBuf,
    names: Vec<String>,
}

/// What came out of some charts.
pub(super) enum Outcome {
    Sound,
    /// The charts that differ from their timelines, or what else went wrong.
    Fails(String),
}

impl Quick {
    /// `tree` is where faults are planted.
    pub(super) fn new(folder: &Path, tree: &Path) -> Result<Self> {
        let build = ["test", "--no-run", "--package", "grafcet-conformance", "--test", "corpus"];
        let mut command = cargo(&build);
        command.args(["--message-format", "json"]).stderr(Stdio::null());
        let told = capture(&mut command)?;
        let of_tests =
            told.lines().find(|line| line.contains("build-script-executed") && line.contains("/tests/conformance#"));
        let out = of_tests.and_then(|line| line.split("\"out_dir\":\"").nth(1)?.split('"').next());
        let modules = PathBuf::from(out.ok_or("cargo does not say where the modules of the corpus are")?);
        let mut names = Vec::new();
        for entry in fs::read_dir(&modules).map_err(|error| format!("{}: {error}", modules.display()))? {
            let path = entry.map_err(|error| error.to_string())?.path();
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let chart = root().join(format!("tests/conformance/{}.chart", name.trim_end_matches("_flags")));
            if name != "corpus" && chart.is_file() {
                names.push(name);
            }
        }
        names.sort();
        let folder = folder.join("quick");
        fs::create_dir_all(folder.join("src")).map_err(|error| format!("{}: {error}", folder.display()))?;
        let manifest = format!(
            "[package]\nname = \"grafcet-quick-corpus\"\nedition = \"2024\"\n\n[workspace]\n\n[lib]\nname = \"grafcet_conformance\"\n\n\
             [dependencies]\ngrafcet = {{ path = '{}' }}\n",
            tree.display()
        );
        write(&folder.join("Cargo.toml"), &manifest)?;
        write(&folder.join("Cargo.lock"), &read(&root().join("Cargo.lock"))?)?;
        let module = |name: &str, file: &str| {
            let path = root().join("tests/conformance").join(file);
            format!("#[path = r\"{}\"]\npub mod {name};\n", path.display())
        };
        let mut lib = "#![allow(warnings)]\n".to_owned();
        for (name, file) in [("generated", "src/generated.rs"), ("play", "src/play.rs"), ("reader", "reader.rs")] {
            lib.push_str(&module(name, file));
        }
        lib.push_str(&module("subject", "src/subject.rs"));
        lib.push_str("pub use subject::{Entry, Rest, Shown, Subject, Values};\n");
        write(&folder.join("src/lib.rs"), &lib)?;
        Ok(Self { folder, modules, names })
    }

    /// Plays the charts whose names begin like this.
    pub(super) fn play(&self, begin: &str) -> Result<Outcome> {
        let (mut modules, mut entries) = (String::new(), String::new());
        let chosen: Vec<&String> = self.names.iter().filter(|name| name.starts_with(begin)).collect();
        if chosen.is_empty() {
            return Err(format!("no chart of the corpus begins with {begin}"));
        }
        for name in chosen {
            let chart = root().join(format!("tests/conformance/{}.chart", name.trim_end_matches("_flags")));
            let module = self.modules.join(format!("{name}.rs"));
            _ = writeln!(modules, "#[path = r\"{}\"]\nmod {name};", module.display());
            let subject = format!("|| Box::new({name}::Compiled::default())");
            let text = format!("include_str!(r\"{}\")", chart.display());
            _ = writeln!(entries, "Entry {{ name: \"{name}\", text: {text}, subject: {subject} }},");
        }
        write(
            &self.folder.join("src/main.rs"),
            &format!("{HEAD}{modules}const ALL: &[Entry] = &[\n{entries}];\n{MAIN}"),
        )?;
        let target = self.folder.join("target");
        let mut build = cargo(&["build", "--quiet"]);
        build.current_dir(&self.folder).env("CARGO_TARGET_DIR", &target).env("CARGO_INCREMENTAL", "0");
        build.env("CARGO_PROFILE_DEV_DEBUG", "0");
        let told = build.output().map_err(|error| format!("cargo: {error}"))?;
        if !told.status.success() {
            // A fault that rustc finds in what is generated is found; one that does not compile itself is none.
            let text = String::from_utf8_lossy(&told.stderr).into_owned();
            let own = text.contains("could not compile `grafcet-quick-corpus`");
            return if own { Ok(Outcome::Fails("rustc, in what is generated".to_owned())) } else { Err(text) };
        }
        let mut run = bounded(target.join("debug/grafcet-quick-corpus"), LIMIT);
        let played = run.output().map_err(|error| format!("timeout: {error}"))?;
        let differ = String::from_utf8_lossy(&played.stdout).split_whitespace().collect::<Vec<_>>().join(", ");
        Ok(match (played.status.code(), differ.is_empty()) {
            (Some(0), true) => Outcome::Sound,
            (Some(124), _) => Outcome::Fails("a search that does not end".to_owned()),
            (_, false) => Outcome::Fails(differ),
            _ => Outcome::Fails("a panic".to_owned()),
        })
    }
}

const HEAD: &str = "#![allow(warnings)]\nuse grafcet_conformance::{Entry, play, reader};\n";

const MAIN: &str = "fn main() {
    for entry in ALL {
        let case = reader::read(entry.text).expect(entry.name);
        if play::against_the_file(&mut *(entry.subject)(), &case.lines).is_err() {
            println!(\"{}\", entry.name);
        }
    }
}
";
