//! The charts of the examples, and those that people draw: each that has a translation, with inputs at random.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use grafcet_compiler::model::{Model, Ty};
use grafcet_exchange::st::{Flavour, Form, Options, structured_text};
use grafcet_sim::Chart;

use crate::FLAVOURS;
use crate::play;
use crate::random::Rng;
use crate::reader::{Expected, Kind, Line};

#[test]
fn charts_of_the_examples() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut compared = BTreeMap::<&str, Vec<String>>::new();
    let mut files: Vec<PathBuf> =
        ["examples/charts", "tests/good"].iter().flat_map(|folder| rust_files(&root.join(folder))).collect();
    files.sort();
    for file in files {
        let text = fs::read_to_string(&file).expect("a file of the project");
        for name in names(&text) {
            let Ok(chart) = Chart::in_file(&text, &name) else { continue };
            for form in [Form::Case, Form::FlipFlops] {
                let lines = timeline(chart.model(), compared.len() as u64 + 1);
                for (flavour, dialect) in FLAVOURS {
                    let options = Options { form, flavour, ..Options::default() };
                    let Ok(program) = structured_text(chart.model(), &options) else { continue };
                    match play::compare(chart.model(), (form, None), (&program, dialect), &lines) {
                        Ok(0) => {}
                        Ok(_) if flavour != Flavour::Iec => {}
                        Ok(_) => compared
                            .entry(if form == Form::Case { "CASE" } else { "flip-flops" })
                            .or_default()
                            .push(name.clone()),
                        Err(error) => {
                            panic!("{}, {name}, {form:?}, {flavour:?}: {error}\n{}", file.display(), program.text)
                        }
                    }
                }
            }
        }
    }
    println!("{compared:#?}");
    for name in ["Motor", "Line24V"] {
        assert!(
            compared["CASE"].iter().chain(&compared["flip-flops"]).filter(|other| *other == name).count() == 2,
            "{name}: {compared:?}"
        );
    }
    assert!(compared["CASE"].len() >= 24 && compared["flip-flops"].len() >= 58, "{compared:?}");
}

pub(crate) fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of the project").flatten().map(|entry| entry.path());
    entries.filter(|file| file.extension().is_some_and(|end| end == "rs")).collect()
}

/// After `sfc` or `grafcet`, in front of a brace.
pub(crate) fn names(text: &str) -> Vec<String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let headers = words.windows(3).filter(|words| ["sfc", "grafcet"].contains(&words[0]) && words[2] == "{");
    headers.map(|words| words[1].to_owned()).collect()
}

/// Few inputs change at a time.
pub(crate) fn timeline(model: &Model, seed: u64) -> Vec<Line> {
    let (mut rng, mut now, mut inputs) = (Rng::new(seed), 0, BTreeMap::new());
    let mut lines = Vec::new();
    for number in 1..=400 {
        now += *rng.pick(&[1, 10, 100, 1_000, 5_000]);
        for input in model.inputs.values() {
            if !rng.chance(15) {
                continue;
            }
            let value = match &input.ty {
                Ty::Bool(_) => rng.below(2),
                _ => rng.below(100),
            };
            let value = i128::try_from(value).unwrap_or(0);
            inputs.insert(input.name.to_string().trim_start_matches("r#").to_owned(), value);
        }
        let expected = Expected { steps: BTreeSet::new(), stable: true, outputs: BTreeMap::new(), calls: Vec::new() };
        let kind = if number % 150 == 149 { Kind::Init } else { Kind::Cycle { inputs: inputs.clone(), now, expected } };
        lines.push(Line { number, kind });
    }
    lines
}
