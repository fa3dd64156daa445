//! What charts look like: the pictures of the pages, and reference pictures as text, are drawn anew and compared.
//!
//! `cargo xtask bless` records them; look at those that change.

mod charts;

use std::fmt::Write as _;
use std::fs;

use grafcet_compiler::describe::with_description;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::{model, parse};

/// Charts, and what their pictures are called.
const FILES: &[(&str, &[&str])] = &[
    ("examples/charts/motor.rs", &["motor"]),
    ("examples/charts/line24v.rs", &["line24v"]),
    ("examples/charts/cell.rs", &["cell"]),
    ("examples/charts/recipe.rs", &["recipe"]),
    ("examples/charts/branch_on_result.rs", &["branch_on_result"]),
    ("tests/good/jumps.rs", &["jumps"]),
    ("tests/good/nested.rs", &["nested"]),
    ("tests/good/hierarchy.rs", &["hierarchy"]),
    ("tests/good/qualifiers_grafcet.rs", &["qualifiers_grafcet"]),
];

/// Those that the pages show.
const SHOWN: [&str; 3] = ["motor", "line24v", "cell"];

#[test]
fn pictures_are_as_recorded() {
    for (file, names) in FILES {
        let rust = fs::read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        let charts = charts::charts(&rust);
        assert_eq!(charts.len(), names.len(), "the charts of {file}");
        for (chart, name) in charts.into_iter().zip(*names) {
            let mut sink = Sink::new();
            let chart = parse::chart(chart, &mut sink).expect("a chart");
            let model = model::resolve(&chart, &mut sink);
            assert!(!sink.has_errors(), "{name}");
            drop(sink.finish());
            let drawn =
                |svg| with_description(&model, |chart| if svg { grafcet_draw::svg(chart, &()) } else { text(chart) });
            compare(&format!("tests/golden/{name}.txt"), &drawn(false));
            if SHOWN.contains(name) {
                compare(&format!("docs/pictures/{name}.svg"), &(drawn(true) + "\n"));
            }
        }
    }
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
        return fs::write(path, now).unwrap_or_else(|error| panic!("{path}: {error}"));
    }
    let recorded = fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}; run `cargo xtask bless`"));
    assert_eq!(recorded, now, "{path} is another picture; if that is meant, run `cargo xtask bless`");
}
