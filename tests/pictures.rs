//! What charts look like: the pictures of all charts of the examples and of `tests/good` are drawn anew and compared.
//!
//! And what a program finds of a chart, `CHART`, is the description from which they are drawn.
//!
//! `cargo xtask bless` records the pictures; look at those that change: [tests/pictures/README.md](pictures/README.md) shows all.

mod charts;

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use grafcet_compiler::describe::with_description;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::{model, parse};
use proc_macro2::TokenStream;

/// Where the charts are.
const FOLDERS: [&str; 2] = ["examples/charts", "tests/good"];

/// Where their pictures are recorded, and a page with all of them.
const PICTURES: &str = "tests/pictures";

/// Those that the pages show.
const SHOWN: [&str; 5] = ["motor", "line24v", "cell", "press", "stop_anywhere"];

/// Those that are recorded as text, too, with their Mermaid diagram.
const TEXTS: [&str; 11] = [
    "motor",
    "line24v",
    "cell",
    "recipe",
    "branch_on_result",
    "jumps",
    "nested",
    "hierarchy",
    "qualifiers_grafcet",
    "stop_anywhere",
    "stop_anywhere_2",
];

#[test]
fn pictures_are_as_recorded() {
    let mut page = "# The charts of the examples and tests, drawn\n\nRecorded by `cargo xtask bless`.\n".to_owned();
    let mut recorded = BTreeSet::from(["README.md".to_owned()]);
    let mut texts = Vec::new();
    for (file, name, chart) in all() {
        let drawn = with_chart(&name, chart, |chart| {
            if TEXTS.contains(&&*name) {
                compare(&format!("tests/golden/{name}.txt"), &text(chart));
                texts.push(name.clone());
            }
            grafcet_draw::svg(chart, &()) + "\n"
        });
        compare(&format!("{PICTURES}/{name}.svg"), &drawn);
        if SHOWN.contains(&&*name) {
            compare(&format!("docs/pictures/{name}.svg"), &drawn);
        }
        let _ = write!(page, "\n## {name}\n\nOf [{file}](../../{file}):\n\n![{name}]({name}.svg)\n");
        recorded.insert(format!("{name}.svg"));
    }
    compare(&format!("{PICTURES}/README.md"), &page);
    assert_eq!(texts.len(), TEXTS.len(), "{texts:?}");
    let entries = fs::read_dir(PICTURES).expect("the recorded pictures");
    let there: BTreeSet<_> = entries.map(|entry| entry.expect("a file").file_name().to_string_lossy().into()).collect();
    assert_eq!(there, recorded, "a picture of no chart");
}

/// The file, a name and the tokens of every chart: it is called by its file, the second one of a file with a number.
fn all() -> Vec<(String, String, TokenStream)> {
    let mut all = Vec::new();
    for folder in FOLDERS {
        let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{folder}: {error}"));
        let mut files: Vec<_> = entries.map(|entry| entry.expect("a file").path()).collect();
        files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
        files.sort();
        for file in files {
            let rust = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            let stem = file.file_stem().expect("a name").to_string_lossy();
            let path = file.to_string_lossy().replace('\\', "/");
            for (number, chart) in charts::charts(&rust).into_iter().enumerate() {
                let name = if number == 0 { stem.to_string() } else { format!("{stem}_{}", number + 1) };
                all.push((path.clone(), name, chart));
            }
        }
    }
    assert!(all.len() > 50, "{} charts", all.len());
    all
}

fn with_chart<R>(name: &str, chart: TokenStream, draw: impl FnOnce(&grafcet::description::Description<'_>) -> R) -> R {
    let mut sink = Sink::new();
    let chart = parse::chart(chart, &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    assert!(!sink.has_errors(), "{name}");
    drop(sink.finish());
    with_description(&model, draw)
}

/// Drawing and Mermaid text in one file.
fn text(chart: &grafcet::description::Description<'_>) -> String {
    format!("{}\n{}", grafcet_draw::text(chart, &()), grafcet_draw::mermaid(chart))
}

grafcet::grafcet! {
    grafcet Twins {
        input go, left, right: bool;
        output a, b: bool;
        initial step Wait;
        step Left { a; }
        step Right { b; }
        Wait -[go]-> (Left, Right) -[left && right]-> Wait;
    }
}

/// Parallel branches: two steps are marked, in text and SVG.
#[test]
fn active_steps_are_marked() {
    let mut twins = Twins::new();
    let none = TwinsInputs::default();
    twins.cycle(&none);
    let marks = |twins: &Twins| -> Vec<String> {
        let svg = grafcet_draw::svg(&Twins::CHART, &twins.situation());
        let text = grafcet_draw::text(&Twins::CHART, &twins.situation());
        assert_eq!(svg.matches("<circle").count(), text.matches('●').count());
        text.lines()
            .flat_map(|line| line.split('│'))
            .filter_map(|cell| cell.strip_prefix('●'))
            .map(|cell| cell.trim_end_matches(|c: char| !c.is_alphabetic()).to_owned())
            .collect()
    };
    assert_eq!(grafcet_draw::text(&Twins::CHART, &twins.situation()).matches("║●Wait").count(), 1);
    assert_eq!(marks(&twins), Vec::<String>::new(), "the frame of an initial step is double");
    twins.cycle(&TwinsInputs { go: true, ..none });
    assert_eq!(marks(&twins), ["Left  ├─┤ a", "Right ├─┤ b"]);
    assert_eq!(grafcet_draw::text(&Twins::CHART, &()).matches('●').count(), 0);
}

/// A chart that is too large to be drawn has a small overview.
#[test]
fn large_charts_have_an_overview() {
    let (mut steps, mut arcs) = (String::new(), String::new());
    for n in 1..1000 {
        let _ = write!(steps, "step S{n}; ");
        let _ = write!(arcs, "-[a]-> S{n} ");
    }
    let chart = format!("sfc Large {{ input a: bool; initial step S0; {steps} S0 {arcs} -[a]-> S0; }}");
    let code = charts::expand(chart.parse().expect("tokens")).to_string();
    assert!(code.contains("1000 steps, 1000 transitions"));
    let picture = code.split("<svg").nth(1).and_then(|rest| rest.split("</svg>").next()).expect("a picture");
    assert!(picture.len() < 2000, "{} bytes", picture.len());
}

/// Compares with the file, or writes it where `BLESS=1` is set.
fn compare(path: &str, now: &str) {
    if std::env::var_os("BLESS").is_some_and(|bless| bless == "1") {
        let folder = Path::new(path).parent().expect("a folder");
        return fs::create_dir_all(folder)
            .and_then(|()| fs::write(path, now))
            .unwrap_or_else(|error| panic!("{path}: {error}"));
    }
    let recorded = fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}; run `cargo xtask bless`"));
    assert_eq!(recorded, now, "{path} is another picture; if that is meant, run `cargo xtask bless`");
}

/// Compiles a chart, and compares the description that a program finds with that of the model.
macro_rules! described {
    ($test:ident, $chart:ident, { $($source:tt)* }) => {
        #[test]
        fn $test() {
            grafcet::grafcet! { $($source)* }
            let source = stringify!($($source)*).parse().expect("tokens");
            with_chart(stringify!($chart), source, |chart| assert_eq!($chart::CHART, *chart));
        }
    };
}

described!(a_program_finds_all_of_a_grafcet, Everything, {
    /// A machine.
    grafcet Everything {
        input go, done, stop, ack: bool;
        output a, b, c, d: bool;
        var count: u8 = 0;
        /// Somebody wants it.
        let wanted = go && !stop;

        /// Who may.
        partial Modes {
            initial step Off { force Help {*}; }
            step On within 10s { c; }
            step Held { force Work {*}; force Help { Rest }; }
            Off -[begin: wanted]-> On -[stop]-> Off;
            On -[done && !stop]-> Held -[ack]-> Off;
        }
        partial Work {
            initial step Idle;
            step Count within 5s { N a if done; on rising(go) { b = true; } on falling(go) { b = false; } }
            /// In two strokes.
            macro step Stroke {
                entry step Lower { a; }
                exit step Raise { a; c; }
                Lower -[done]-> Raise;
            }
            step Stopped { P1 { d = true; } P0 { d = false; } }
            Idle -[go => count = 0]-> Count -[done && count < 9 => count = count + 1]-> Stroke -[!done]-> Idle;
            any except (Idle, Stopped) -[out: stop => count = 9]-> Stopped -[ack => count = 1]-> Idle;
        }
        partial Help {
            initial step Rest;
            step Blink { c if blink(1s); }
            Rest -[2s/Rest]-> Blink -[3s/Blink]-> Rest;
        }
    }
});

described!(a_program_finds_all_of_an_sfc, Plain, {
    sfc Plain {
        input go, done: bool;
        output a, b: bool;
        initial step Rest;
        step Left { L 5s a; }
        step Right { S b; }
        Rest -[go]-> (Left, Right);
        (Left, Right) -[done]-> Rest;
        final step End { R b; }
        Rest -[!go && done]-> End;
    }
});

#[path = "good/packaging_line.rs"]
mod packaging_line;

/// Its numbers take more than a byte.
#[test]
fn a_program_finds_all_of_a_long_chart() {
    let rust = fs::read_to_string("tests/good/packaging_line.rs").expect("the file");
    let chart = charts::charts(&rust).into_iter().next().expect("the chart");
    with_chart("packaging_line", chart, |chart| assert_eq!(packaging_line::PackagingLine::CHART, *chart));
}
