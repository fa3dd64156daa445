//! What is drawn can be read: no text, box or bar covers another, in any chart there is and in many that there might be.

#[path = "../../../tests/conformance/src/random/mod.rs"]
#[allow(unreachable_pub, dead_code, clippy::format_collect, reason = "public in the package grafcet-conformance")]
mod random;

#[path = "../charts/mod.rs"]
mod charts;
mod words;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use grafcet_draw::{Drawing, Frame, Heading, Shape};
use proc_macro2::TokenStream;

#[test]
fn nothing_covers_another_in_the_charts_of_the_project() {
    let mut said = String::new();
    let mut drawn = 0;
    charts::all(|name, chart| {
        drawn += 1;
        for problem in problems(&grafcet_draw::layout(chart, &())) {
            let _ = writeln!(said, "{name}: {problem}");
        }
    });
    assert!(drawn > 150, "only {drawn} charts");
    assert!(said.is_empty(), "\n{said}");
}

#[test]
fn nothing_covers_another_in_random_charts() {
    let mut said = String::new();
    let mut drawn = 0;
    // The last has a convergence whose arc leads back from one of its sources, and down from the other.
    for seed in (0..400).chain([9_051_100_094]) {
        let chart = random::chart(seed, seed % 2 == 0, 0).chart;
        let Some(drawing) = chart.parse().ok().and_then(drawing) else { continue };
        drawn += 1;
        for problem in problems(&drawing) {
            let _ = writeln!(said, "seed {seed}: {problem}");
        }
    }
    assert!(drawn >= 200, "only {drawn} charts");
    assert!(said.is_empty(), "\n{said}");
}

/// The check itself: a drawing with each fault is caught.
#[test]
fn what_covers_another_is_seen() {
    let text = |x, y| Shape::Text { at: (x, y), text: "text".to_owned(), half: false };
    let frame = |x, y| Shape::Frame { at: (x, y), size: (6, 3), kind: Frame::Action };
    let faulty = [
        vec![text(0, 0), text(3, 0)],
        vec![text(0, 0), Shape::Line { from: (2, 0), to: (2, 4), double: false }],
        vec![text(0, 0), Shape::Bar { at: (5, 0) }],
        vec![frame(0, 0), frame(3, 1)],
        vec![frame(0, 0), text(3, 1)],
        vec![frame(0, 0), Shape::Line { from: (0, 1), to: (9, 1), double: false }],
        vec![text(-1, 0)],
    ];
    for shapes in faulty {
        let drawing = Drawing { width: 20, height: 10, shapes, ..Drawing::default() };
        assert!(!problems(&drawing).is_empty(), "{drawing:?}");
    }
    let shapes = vec![frame(0, 0), frame(0, 2), text(1, 1), Shape::Line { from: (5, 1), to: (9, 1), double: false }];
    assert!(problems(&Drawing { width: 20, height: 10, shapes, ..Drawing::default() }).is_empty());
}

/// `None` where the chart has mistakes.
fn drawing(chart: TokenStream) -> Option<Drawing> {
    charts::with(chart, |chart| grafcet_draw::layout(chart, &()))
}

type Square = (i32, i32);

/// What can be seen in a square, by who put it there.
#[derive(Default)]
struct Seen {
    /// Texts, bars, arrows and marks: each alone in its square, but for the line that a bar or an arrow stands on.
    solid: Vec<String>,
    lines: usize,
    /// The edge of a frame.
    edges: usize,
}

/// Everything that cannot be read.
fn problems(drawing: &Drawing) -> Vec<String> {
    let mut squares: BTreeMap<Square, Seen> = BTreeMap::new();
    let mut problems = Vec::new();
    for shape in &drawing.shapes {
        for (square, what) in covered(shape) {
            let seen = squares.entry(square).or_default();
            match what {
                What::Solid(name) => seen.solid.push(name),
                What::Line => seen.lines += 1,
                What::Edge => seen.edges += 1,
            }
            if square.0 < 0 || square.1 < 0 || square.0 >= drawing.width || square.1 >= drawing.height {
                problems.push(format!("{shape:?} is not on the paper"));
            }
        }
    }
    for (square, seen) in &squares {
        let on_line = |name: &String| ["bar", "arrow", "dot"].contains(&name.as_str());
        match &seen.solid[..] {
            [] => {}
            [one] if (seen.lines == 0 || on_line(one)) && seen.edges == 0 => {}
            _ => problems.push(format!("{:?} and {} lines in {square:?}", seen.solid, seen.lines + seen.edges)),
        }
    }
    problems.extend(frames(drawing));
    problems
}

enum What {
    Solid(String),
    Line,
    Edge,
}

fn covered(shape: &Shape) -> Vec<(Square, What)> {
    let row = |x: i32, y: i32, count: i32| (x..x + count).map(move |x| (x, y));
    match shape {
        Shape::Line { from, to, .. } => {
            let squares = (from.0..=to.0).flat_map(|x| (from.1..=to.1).map(move |y| (x, y)));
            squares.map(|square| (square, What::Line)).collect()
        }
        Shape::Bar { at } => row(at.0 - 2, at.1, 5).map(|square| (square, What::Solid("bar".to_owned()))).collect(),
        Shape::Arrow { at, .. } => vec![(*at, What::Solid("arrow".to_owned()))],
        Shape::Dot { at } => vec![(*at, What::Solid("dot".to_owned()))],
        Shape::Mark { at } => vec![(*at, What::Solid("mark".to_owned()))],
        // It lies beneath what has changed.
        Shape::Changed { .. } => Vec::new(),
        Shape::Text { at, text, half } => {
            let count = i32::try_from(text.chars().count()).unwrap_or(i32::MAX) + i32::from(*half);
            row(at.0, at.1, count).map(|square| (square, What::Solid(text.clone()))).collect()
        }
        Shape::Frame { at, size, .. } => {
            let (right, below) = (at.0 + size.0 - 1, at.1 + size.1 - 1);
            let rows = row(at.0, at.1, size.0).chain(row(at.0, below, size.0));
            let sides = (at.1 + 1..below).flat_map(|y| [(at.0, y), (right, y)]);
            rows.chain(sides).map(|square| (square, What::Edge)).collect()
        }
    }
}

/// Frames stand apart, inside a sheet, or share an edge; and no line goes through one but the one after a qualifier.
fn frames(drawing: &Drawing) -> Vec<String> {
    let mut problems = Vec::new();
    let frames = drawing.shapes.iter().filter_map(|shape| match shape {
        Shape::Frame { at, size, kind } => Some((*at, (at.0 + size.0 - 1, at.1 + size.1 - 1), *kind)),
        _ => None,
    });
    let frames = frames.collect::<Vec<_>>();
    for (number, (from, to, kind)) in frames.iter().enumerate() {
        for (other_from, other_to, other) in &frames[number + 1..] {
            let apart = to.0 <= other_from.0 || other_to.0 <= from.0 || to.1 <= other_from.1 || other_to.1 <= from.1;
            let inside = *kind == Frame::Sheet
                && *other != Frame::Sheet
                && from.0 < other_from.0
                && from.1 < other_from.1
                && other_to.0 < to.0
                && other_to.1 < to.1;
            if !apart && !inside {
                problems.push(format!("frames at {from:?} and {other_from:?}"));
            }
        }
        for shape in &drawing.shapes {
            let Shape::Line { from: start, to: end, .. } = shape else { continue };
            let through = start.0 < to.0 && end.0 > from.0 && start.1 < to.1 && end.1 > from.1;
            // It begins and ends at the edges of actions that stand on each other.
            let edges = |y: i32| frames.iter().any(|f| f.2 == Frame::Action && (f.0.1 == y || f.1.1 == y));
            let whole = start.0 == end.0 && start.1 <= from.1 && end.1 >= to.1;
            let cell = *kind == Frame::Action && whole && edges(start.1) && edges(end.1);
            if through && !cell && *kind != Frame::Sheet {
                problems.push(format!("{shape:?} goes through the frame at {from:?}"));
            }
        }
    }
    problems
}

fn arrows(drawing: &Drawing, heading: Heading) -> usize {
    drawing.shapes.iter().filter(|shape| matches!(shape, Shape::Arrow { to, .. } if *to == heading)).count()
}

/// A hundred steps stand in columns, each of which a screen can show; where one ends, both ends of the line name each other.
#[test]
fn long_sequences_are_folded() {
    let (mut steps, mut arcs) = (String::new(), String::new());
    for n in 1..100 {
        let _ = write!(steps, "step S{n} {{ N q; }}");
        let _ = write!(arcs, "-[a && !b]-> S{n} ");
    }
    let chart =
        format!("sfc Long {{ input a, b: bool; output q: bool; initial step S0; {steps} S0 {arcs} -[a]-> S0; }}");
    let drawing = drawing(chart.parse().expect("tokens")).expect("a drawing");
    assert_eq!(problems(&drawing), Vec::<String>::new());
    assert!(drawing.width <= 110 && drawing.height <= 200, "{} x {}", drawing.width, drawing.height);
    let texts: Vec<&str> = drawing
        .shapes
        .iter()
        .filter_map(|shape| if let Shape::Text { text, .. } = shape { Some(text.as_str()) } else { None })
        .collect();
    let columns = arrows(&drawing, Heading::Down);
    assert!((8..=12).contains(&columns), "{columns} columns");
    assert_eq!(arrows(&drawing, Heading::Left), columns);
    let shown = |n: usize| texts.iter().filter(|text| **text == format!("S{n}")).count();
    // A step in its frame, and a name at both ends of each line that is broken.
    assert!((0..100).all(|n| shown(n) >= 1));
    assert_eq!((0..100).map(shown).sum::<usize>(), 100 + 2 * columns);
}

/// Branches side by side stand closely where there are many.
#[test]
fn many_branches_are_drawn_densely() {
    let chart = |count: usize| {
        let (mut steps, mut last, mut first) = (String::new(), Vec::new(), Vec::new());
        for n in 0..count {
            let _ = write!(steps, "step A{n} {{ N motor; }} step B{n}; A{n} -[sensor_reached && !done]-> B{n};");
            first.push(format!("A{n}"));
            last.push(format!("B{n}"));
        }
        let (first, last) = (first.join(", "), last.join(", "));
        let chart = format!(
            "sfc Wide {{ input sensor_reached, done: bool; output motor: bool; initial step Wait; {steps}
             Wait -[true]-> ({first}); ({last}) -[done]-> Wait; }}"
        );
        drawing(chart.parse().expect("tokens")).expect("a drawing")
    };
    let (few, many) = (chart(3), chart(30));
    assert_eq!(problems(&many), Vec::<String>::new());
    assert!(many.width < few.width * 7, "{} squares, {} for three branches", many.width, few.width);
}

/// A description can be made by hand, and then says what it likes.
#[test]
fn a_wrong_description_is_drawn_somehow() {
    use grafcet_core::description::{Description, Dialect, Let, MacroStep, Partial, Step, Transition};
    let chart = Description {
        name: "Wrong",
        dialect: Dialect::Grafcet,
        partials: &[Partial::new("").enclosed_by(7)],
        macros: &[MacroStep::new("M", 9, 0).inside(0), MacroStep::new("", 1, 1).inside(5)],
        steps: &[Step::new("A", 4, &[], &[]).inside(0), Step::new("", 0, &[], &[""]).inside(9).initial().linked()],
        transitions: &[
            Transition::new("", &[0, 0, 8], &[1, 1, 0], "", &[""]),
            Transition::new("t", &[], &[], "x\ny", &[]),
            Transition::new("", &[1], &[1], "a", &[]),
            Transition::new("", &[0], &[1], "b", &[]).from_any(&[7], &["", "C"]),
            Transition::new("", &[], &[], "c", &[]).from_any(&[], &[]),
        ],
        lets: &[Let::new("", ""), Let::new("x\ny", "a\nb").documented("\n")],
    };
    assert!(!grafcet_draw::text(&chart, &()).is_empty());
    assert!(!grafcet_draw::svg(&chart, &()).contains('\n'));
    assert!(grafcet_draw::mermaid(&chart).starts_with("flowchart"));
}
