//! The charts of the examples and of `tests/good` on paper.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use grafcet_compiler::describe::with_description;
use grafcet_draw::pages::{Page, Side, pages};
use grafcet_draw::{Frame, Shape, Thing};

use super::date;
use crate::find;
use crate::model::drawn;

#[test]
fn days_of_the_calendar() {
    // Leap days, a century without one and one with, and ends of years.
    for (days, expected) in [
        (0, "1970-01-01"),
        (58, "1970-02-28"),
        (59, "1970-03-01"),
        (364, "1970-12-31"),
        (365, "1971-01-01"),
        (789, "1972-02-29"),
        (11_016, "2000-02-29"),
        (11_017, "2000-03-01"),
        (47_540, "2100-02-28"),
        (47_541, "2100-03-01"),
    ] {
        assert_eq!(date(days), expected);
    }
}

/// A4 upright and across with small letters, and a small page, which cuts nearly everything.
const ROOMS: [(i32, i32); 3] = [(108, 81), (162, 54), (60, 30)];

#[test]
fn every_chart_is_whole_on_its_pages() {
    let (mut charts, mut connectors) = (0, 0);
    for folder in ["examples/charts", "tests/good"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder);
        let mut files: Vec<_> = fs::read_dir(&folder).expect("charts").flatten().map(|entry| entry.path()).collect();
        files.sort();
        for file in files.iter().filter(|file| file.extension().is_some_and(|end| end == "rs")) {
            let text = fs::read_to_string(file).expect("a file");
            for chart in find::of_text(file, &text).unwrap_or_default() {
                let Some(model) = drawn(&chart) else { continue };
                charts += 1;
                for room in ROOMS {
                    connectors += with_description(&model, |description| {
                        let all = pages(description, &(), room);
                        let what = format!("{} in {room:?}", chart.name);
                        let macros = description.macros.len();
                        each_is_on_one_page(
                            &all,
                            description.steps.len(),
                            macros,
                            description.transitions.len(),
                            &what,
                        );
                        nothing_is_lost(&all, &pages(description, &(), (room.0, 1_000_000)), &what);
                        for page in all.iter().filter(|_| room != ROOMS[2]) {
                            let drawing = &page.drawing;
                            assert!(
                                drawing.width <= room.0 && drawing.height <= room.1,
                                "{what}: {} {}",
                                drawing.width,
                                drawing.height
                            );
                        }
                        partners(&all, &what)
                    });
                }
            }
        }
    }
    assert!(charts > 60 && connectors > 200, "{charts} charts, {connectors} connectors");
}

fn each_is_on_one_page(all: &[Page], steps: usize, macros: usize, transitions: usize, what: &str) {
    let mut seen = BTreeMap::new();
    for site in all.iter().flat_map(|page| &page.drawing.sites) {
        let key = match site.of {
            Thing::Step(id) => (0, id),
            Thing::Macro(id) => (1, id),
            Thing::Transition(id) => (2, id),
        };
        *seen.entry(key).or_insert(0) += 1;
    }
    for (kind, count) in [steps, macros, transitions].into_iter().enumerate() {
        for id in 0..count {
            assert_eq!(seen.get(&(kind, id)), Some(&1), "{what}: {kind} {id}");
        }
    }
}

/// What a cut could lose: texts, boxes and bars are those of the chart on one endless page, and so are the lines, but for one square more where one is
/// broken: each half goes on into the room of its connector.
fn nothing_is_lost(all: &[Page], endless: &[Page], what: &str) {
    let sorted = |pages: &[Page]| {
        let shapes = pages.iter().flat_map(|page| &page.drawing.shapes);
        let mut kept: Vec<String> = shapes.filter_map(kept).collect();
        kept.sort();
        kept
    };
    assert_eq!(sorted(all), sorted(endless), "{what}");
    let framed =
        |page: &Page| page.drawing.shapes.iter().any(|shape| matches!(shape, Shape::Frame { kind: Frame::Sheet, .. }));
    // What is left of a frame around a net is lines, too.
    if !endless.iter().any(framed) {
        let connectors = |pages: &[Page]| pages.iter().map(|page| page.connectors.len()).sum::<usize>();
        let broken = |pages: &[Page]| i32::try_from(connectors(pages) / 2).expect("a number");
        let more = broken(all) - broken(endless);
        assert_eq!(length(all), length(endless) + more, "{what}");
    }
}

/// A shape that no cut changes, without its place.
fn kept(shape: &Shape) -> Option<String> {
    match shape {
        Shape::Line { .. } | Shape::Frame { kind: Frame::Sheet, .. } => None,
        Shape::Frame { size, kind, .. } => Some(format!("{size:?} {kind:?}")),
        Shape::Text { text, .. } => Some(format!("text {text}")),
        Shape::Arrow { to, .. } => Some(format!("{to:?}")),
        Shape::Bar { .. } => Some("bar".to_owned()),
        Shape::Dot { .. } => Some("dot".to_owned()),
        Shape::Mark { .. } => Some("mark".to_owned()),
        Shape::Changed { size, change, .. } => Some(format!("{size:?} {change:?}")),
    }
}

fn length(pages: &[Page]) -> i32 {
    let shapes = pages.iter().flat_map(|page| &page.drawing.shapes);
    let lengths = shapes.map(|shape| match shape {
        Shape::Line { from, to, .. } => to.0 - from.0 + to.1 - from.1,
        _ => 0,
    });
    lengths.sum()
}

/// Each connector has one partner, on the page that it names and at the opposite side of a piece; how many there are.
fn partners(all: &[Page], what: &str) -> usize {
    let mut found: BTreeMap<usize, Vec<(usize, usize, Side)>> = BTreeMap::new();
    for (number, page) in (1..).zip(all) {
        for one in &page.connectors {
            found.entry(one.number).or_default().push((number, one.page, one.side));
            let (x, y) = one.at;
            assert!((0..page.drawing.width).contains(&x) && (0..page.drawing.height).contains(&y), "{what}: {one:?}");
            let ends = |from: (i32, i32), to: (i32, i32)| match one.side {
                Side::Top => from == (x, y + 1),
                Side::Bottom => to == (x, y - 1),
                Side::Left => from == (x + 1, y),
                Side::Right => to == (x - 1, y),
            };
            let has_line = page
                .drawing
                .shapes
                .iter()
                .any(|shape| matches!(shape, Shape::Line { from, to, .. } if ends(*from, *to)));
            assert!(has_line, "{what}: no line at {one:?}");
        }
    }
    for (number, both) in &found {
        let [(here, to, side), (there, back, other)] = both[..] else { panic!("{what}: connector {number}: {both:?}") };
        assert_eq!((to, back), (there, here), "{what}: connector {number}");
        let opposite = matches!((side, other), (Side::Bottom, Side::Top) | (Side::Right, Side::Left));
        assert!(opposite, "{what}: connector {number}: {side:?} and {other:?}");
    }
    found.len()
}
