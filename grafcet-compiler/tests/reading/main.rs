//! A picture says what the chart is: from lines, boxes and bars alone the net is read back, by the rules of drawing of IEC 60848,
//! and is the one of the description.
//!
//! What reads shares nothing with what draws.

#[path = "../../../tests/conformance/src/random/mod.rs"]
#[allow(unreachable_pub, dead_code, clippy::format_collect, reason = "public in the package grafcet-conformance")]
mod random;

#[path = "../charts/mod.rs"]
mod charts;

mod characters;
mod made;
mod net;
mod order;
mod parts;
mod svg;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use grafcet_core::description::{Any, Description, Dialect};

use net::{Net, Read};
use parts::Parts;

/// The net of a description, as it should be read.
fn expected(chart: &Description<'_>) -> Net {
    let title = |partial: usize, expansion: Option<usize>| {
        if let Some(id) = expansion {
            return format!("macro step {}", chart.macros[id].name);
        }
        let Some(partial) = chart.partials.get(partial) else { return String::new() };
        partial
            .enclosed_by
            .map_or(partial.name.to_owned(), |step| format!("{} ▸ {}", chart.steps[step].name, partial.name))
    };
    let mut steps: Vec<_> = chart
        .steps
        .iter()
        .map(|step| (step.name.to_owned(), step.initial, title(step.partial, step.expansion)))
        .chain(chart.macros.iter().map(|m| {
            let entry = &chart.steps[m.entry];
            (m.name.to_owned(), entry.initial, title(entry.partial, m.outer))
        }))
        .collect();
    steps.sort();
    let names = |steps: &[usize]| {
        let mut names: Vec<String> = steps.iter().map(|step| chart.steps[*step].name.to_owned()).collect();
        names.sort();
        names
    };
    let mut transitions: Vec<Read> = chart
        .transitions
        .iter()
        .map(|t| Read {
            sources: names(t.sources),
            any: t.any.map(any).unwrap_or_default(),
            targets: names(t.targets),
            name: t.name.to_owned(),
            text: text(t.condition, t.clearing),
        })
        .collect();
    transitions.sort();
    // Where branches have an order it is that of the source.
    let mut ranks = BTreeMap::new();
    for (id, step) in chart.steps.iter().enumerate().filter(|_| chart.dialect == Dialect::Sfc) {
        let branches = chart.transitions.iter().filter(|t| t.sources.contains(&id));
        let texts: Vec<String> = branches.map(|t| text(t.condition, t.clearing)).collect();
        if texts.len() > 1 {
            ranks.insert(step.name.to_owned(), texts);
        }
    }
    let mut legend = String::new();
    for named in chart.lets {
        legend.extend([named.name, "=", named.text, named.doc]);
    }
    Net { steps, transitions, ranks, legend: legend.replace(' ', ""), faults: Vec::new() }
}

/// `anyexcept(A,B)`
fn any(any: Any<'_>) -> String {
    match any.except {
        [] => "any".to_owned(),
        [one] => format!("anyexcept{one}"),
        several => format!("anyexcept({})", several.join(",")),
    }
}

fn text(condition: &str, clearing: &[&str]) -> String {
    let mut text = condition.to_owned();
    for done in clearing {
        // What is assigned a value is written as in the standards.
        let assignment = done.split_once(" = ").filter(|(to, _)| to.chars().all(|c| c.is_alphanumeric() || c == '_'));
        match assignment {
            Some((to, "true")) => text.extend(["⇒", to, ":=1"]),
            Some((to, "false")) => text.extend(["⇒", to, ":=0"]),
            Some((to, value)) => text.extend(["⇒", to, ":=", value]),
            None => text.extend(["⇒", *done]),
        }
    }
    text.replace(char::is_whitespace, "")
}

/// Everything in which a picture of a chart is read differently.
fn differences(chart: &Description<'_>, read: Net) -> Vec<String> {
    let mut said = read.faults;
    let expected = expected(chart);
    let outside = |name: &String, exit: bool| {
        let found = chart.macros.iter().find(|m| m.name == name);
        found.map_or(name.clone(), |m| chart.steps[if exit { m.exit } else { m.entry }].name.to_owned())
    };
    let mut transitions = read.transitions;
    for read in &mut transitions {
        read.sources = read.sources.iter().map(|name| outside(name, true)).collect();
        read.targets = read.targets.iter().map(|name| outside(name, false)).collect();
        read.sources.sort();
        read.targets.sort();
    }
    if expected.steps != read.steps {
        said.push(format!("the steps {:?} are read as {:?}", expected.steps, read.steps));
    }
    if !read.legend.contains('…') && expected.legend != read.legend {
        said.push(format!("the names `{}` are read as `{}`", expected.legend, read.legend));
    }
    let alike = |(wanted, read): (&String, &String)| match read.split_once('…') {
        Some((begin, _)) => wanted.starts_with(begin),
        None => wanted == read,
    };
    let ranked = |(step, wanted): (&String, &Vec<String>)| {
        read.ranks.get(step).is_some_and(|read| read.len() == wanted.len() && wanted.iter().zip(read).all(alike))
    };
    if expected.ranks.len() != read.ranks.len() || !expected.ranks.iter().all(ranked) {
        said.push(format!("the order of branches {:?} is read as {:?}", expected.ranks, read.ranks));
    }
    for wanted in expected.transitions {
        let same = |read: &Read| {
            let text = read.text.split('…').next().unwrap_or_default();
            let texts =
                if read.text.contains('…') { wanted.text.starts_with(text) } else { wanted.text == read.text };
            let any = match read.any.split_once('…') {
                Some((begin, _)) => wanted.any.starts_with(begin),
                None => wanted.any == read.any,
            };
            any && read.sources == wanted.sources && read.targets == wanted.targets && read.name == wanted.name && texts
        };
        match transitions.iter().position(same) {
            Some(found) => drop(transitions.remove(found)),
            None => said.push(format!("{wanted:?} cannot be read")),
        }
    }
    said.extend(transitions.iter().map(|read| format!("{read:?} is read")));
    said
}

/// The charts of the project that are drawn step by step.
fn drawn(mut f: impl FnMut(&str, &Description<'_>)) {
    charts::all(|name, chart| {
        if !grafcet_draw::is_large(chart) {
            f(name, chart);
        }
    });
}

/// Those of a test, or those that `SEEDS=3000..9000` asks for.
fn seeds(usual: std::ops::Range<u64>) -> std::ops::Range<u64> {
    let asked = std::env::var("SEEDS").ok().and_then(|asked| {
        let (from, to) = asked.split_once("..")?;
        Some(from.parse().ok()?..to.parse().ok()?)
    });
    asked.unwrap_or(usual)
}

fn told(chart: &Description<'_>) -> Vec<String> {
    differences(chart, net::net(&svg::seen(Parts::of(&grafcet_draw::svg(chart, &())))))
}

/// The same of the drawing in characters, but for the frames around nets and names, and what initial macro-steps look like.
fn told_of_text(chart: &Description<'_>) -> Vec<String> {
    let mut seen = svg::seen(characters::parts(&grafcet_draw::text(chart, &())));
    seen.pieces.retain(|piece| !piece.ends.is_empty());
    let mut read = net::net(&seen);
    let expected = expected(chart);
    (read.steps, read.legend) = (expected.steps, expected.legend);
    differences(chart, read)
}

#[test]
fn text_is_read_back() {
    let mut said = Vec::new();
    drawn(|name, chart| said.push((name.to_owned(), told_of_text(chart))));
    for seed in seeds(0..300) {
        made::net(seed, |chart| said.push((format!("made {seed}"), told_of_text(chart))));
    }
    none(said);
}

/// Fails with what was read differently, the first few charts of it.
fn none(said: Vec<(String, Vec<String>)>) {
    let wrong: Vec<_> = said.into_iter().filter(|(_, said)| !said.is_empty()).collect();
    let mut shown = format!("{} charts are read differently\n", wrong.len());
    for (name, said) in wrong.iter().take(12) {
        let _ = writeln!(shown, "{name}:\n    {}", said.join("\n    "));
    }
    assert!(wrong.is_empty(), "\n{shown}");
}

#[test]
fn charts_of_the_project_are_read_back() {
    let mut said = Vec::new();
    drawn(|name, chart| said.push((name.to_owned(), told(chart))));
    assert!(said.len() > 180, "only {} charts", said.len());
    none(said);
}

#[test]
fn random_charts_are_read_back() {
    let mut said = Vec::new();
    // Some have mistakes, or pieces that only a macro can make.
    for seed in seeds(0..2000) {
        let chart = random::chart(seed, seed % 2 == 0, 0).chart;
        let Ok(chart) = chart.parse() else { continue };
        said.extend(charts::with(chart, |chart| (format!("seed {seed}"), told(chart))));
        if said.len() == 1000 {
            break;
        }
    }
    assert!(said.len() == 1000 || std::env::var_os("SEEDS").is_some(), "only {} charts", said.len());
    none(said);
}

/// Nets that no one would draw: any transitions between any steps.
#[test]
fn any_nets_are_read_back() {
    let mut said = Vec::new();
    for seed in seeds(0..1000) {
        made::net(seed, |chart| said.push((format!("made {seed}"), told(chart))));
    }
    none(said);
}

/// The check itself: what is left out of a picture, or looks connected, is read as something else.
#[test]
fn what_is_drawn_wrongly_is_seen() {
    let (mut dots, mut gaps, mut numbers, mut anys) = (0, 0, 0, 0);
    for seed in 0..150 {
        made::net(seed, |chart| {
            let svg = grafcet_draw::svg(chart, &());
            let wrong = |svg: &str| !differences(chart, net::net(&svg::seen(Parts::of(svg)))).is_empty();
            let without = |begin: &str| {
                let mut parts = svg.split(begin);
                let first = parts.next().unwrap_or_default().to_owned();
                parts.fold(first, |all, part| all + part.split_once("/>").map_or("", |(_, after)| after))
            };
            if svg.contains("<circle") {
                dots += 1;
                assert!(wrong(&without("<circle")), "{seed}: without dots");
            }
            // A vertical line that passes through a gap, and the gap closed.
            let closed = closed(&svg);
            if closed != svg {
                gaps += 1;
                assert!(wrong(&closed), "{seed}: without gaps");
            }
            if chart.dialect == Dialect::Sfc && svg.contains(">1</text>") {
                numbers += 1;
                assert!(wrong(&svg.replacen(">1</text>", ">7</text>", 1)), "{seed}: another number");
            }
            if svg.contains(">any") {
                anys += 1;
                assert!(wrong(&svg.replacen(">any", ">all", 1)), "{seed}: other words above a transition");
                assert!(wrong(&svg.replacen(">any</text>", ">any except A</text>", 1)) || !svg.contains(">any</text>"));
            }
            if svg.contains(">go = ") && !svg.contains('…') {
                assert!(wrong(&svg.replacen(">go = ", ">go = !", 1)), "{seed}: another meaning of a name");
            }
            if svg.contains("l4 9h-8z") {
                assert!(wrong(&svg.replace("l4 9h-8z", "l4 -9h-8z")), "{seed}: arrows turned");
            }
        });
    }
    let found = format!("{dots} with dots, {gaps} with gaps, {numbers} with numbers, {anys} with `any`");
    assert!([dots, gaps, numbers, anys].iter().all(|count| *count > 10), "{found}");
}

/// Double lines without their gaps of ten pixels: what begins so far after the end of another in the same row goes on.
fn closed(svg: &str) -> String {
    let level = |piece: &str| -> Option<[i32; 3]> {
        let (x, rest) = piece.split_once(' ')?;
        let (y, end) = rest.split_once('H')?;
        let end = end.trim_end_matches(|c: char| !c.is_ascii_digit());
        Some([x.parse().ok()?, y.parse().ok()?, end.split('"').next()?.parse().ok()?])
    };
    let ends: Vec<[i32; 2]> = svg.split('M').filter_map(level).map(|[_, y, end]| [end, y]).collect();
    let pieces = svg.split('M').map(|piece| match level(piece) {
        Some([x, y, _]) if ends.contains(&[x - 10, y]) => {
            format!("{}{}", x - 10, &piece[piece.find(' ').unwrap_or(0)..])
        }
        _ => piece.to_owned(),
    });
    pieces.collect::<Vec<_>>().join("M")
}
