//! Where things stand: the main sequence is straight, and what is active first stands on top.

use std::fmt::Write as _;

use grafcet_core::description::Description;

use crate::net::{End, Seen};
use crate::parts::Parts;
use crate::random::Rng;
use crate::{charts, made, random, svg};

fn seen(chart: &Description<'_>) -> Seen {
    svg::seen(Parts::of(&grafcet_draw::svg(chart, &())))
}

/// Boxes that lines connect, through bars and double lines.
fn connected(seen: &Seen) -> Vec<Vec<usize>> {
    // What hangs on a line, with what is on the other side of it.
    let same = |end: &End| match end {
        End::Top(id) | End::Bottom(id) => Some((0, *id)),
        End::Over(id) | End::Under(id) => Some((1, *id)),
        End::OnDouble(id) | End::BelowDouble(id) => Some((2, *id)),
        End::To(_) | End::From(_) | End::Any(_) => None,
    };
    let mut groups: Vec<Vec<(u8, usize)>> = Vec::new();
    for piece in &seen.pieces {
        let mut group: Vec<(u8, usize)> = piece.ends.iter().filter_map(same).collect();
        let (joined, apart): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|other| other.iter().any(|end| group.contains(end)));
        group.extend(joined.into_iter().flatten());
        groups = apart;
        groups.push(group);
    }
    let boxes = |group: Vec<(u8, usize)>| group.into_iter().filter(|end| end.0 == 0).map(|end| end.1).collect();
    groups.into_iter().map(boxes).collect()
}

/// Nets in which a step stands above all initial ones.
fn covered(chart: &Description<'_>) -> Vec<String> {
    let seen = seen(chart);
    let mut said = Vec::new();
    for net in connected(&seen) {
        let first = net.iter().filter(|id| seen.boxes[**id].initial).map(|id| seen.boxes[*id].at.1).min();
        let above = net.iter().filter(|id| first.is_some_and(|first| seen.boxes[**id].at.1 < first));
        said.extend(above.map(|id| format!("{} stands above the initial step", seen.boxes[*id].name)));
    }
    said
}

#[test]
fn initial_steps_are_on_top() {
    let mut said = Vec::new();
    crate::drawn(|name, chart| said.push((name.to_owned(), covered(chart))));
    for seed in crate::seeds(0..400) {
        let chart = random::chart(seed, seed % 2 == 0, 0).chart;
        let read =
            chart.parse().ok().and_then(|chart| charts::with(chart, |chart| (format!("seed {seed}"), covered(chart))));
        said.extend(read);
        made::net(seed, |chart| said.push((format!("made {seed}"), covered(chart))));
    }
    crate::none(said);
}

/// A sequence with ways aside, which are written before it or after it, of steps that are declared in any order.
fn aside(seed: u64) -> String {
    let mut rng = Rng::new(seed);
    let count = rng.between(4, 9);
    let mut steps: Vec<String> = (0..count).map(|n| format!("step M{n};")).collect();
    steps[0].insert_str(0, "initial ");
    let mut arcs: Vec<String> = (0..count).map(|n| format!("M{n} -[a{n}]-> M{};", (n + 1) % count)).collect();
    let fault = rng.chance(50);
    if fault {
        steps.push("step Fault;".to_owned());
        arcs.push("Fault -[reset]-> M0;".to_owned());
        arcs.extend((0..count).map(|n| format!("M{n} -[fault{n}]-> Fault;")));
    }
    // Mostly short enough that the sequence is the longest way.
    for n in 0..count - 3 {
        match rng.below(5) {
            0 => arcs.push(format!("M{n} -[abort{n}]-> M0;")),
            1 => arcs.push(format!("M{n} -[skip{n}]-> M{};", n + 2)),
            2 => {
                steps.push(format!("step Side{n};"));
                arcs.push(format!("M{n} -[side{n}]-> Side{n} -[back{n}]-> M{};", rng.below(n + 1)));
            }
            _ => {}
        }
    }
    for _ in 0..30 {
        let (one, other) = (rng.below(arcs.len()), rng.below(arcs.len()));
        arcs.swap(one, other);
        let (one, other) = (rng.below(steps.len()), rng.below(steps.len()));
        steps.swap(one, other);
    }
    let mut inputs = String::new();
    let text = arcs.join(" ");
    for name in text.split(['[', ']']).skip(1).step_by(2) {
        let _ = write!(inputs, "input {name}: bool; ");
    }
    let dialect = if seed % 2 == 0 { "sfc" } else { "grafcet" };
    format!("{dialect} Aside {{ {inputs} {} {text} }}", steps.join(" "))
}

/// The longest ways from the initial step that pass no step twice: not over a step to which one goes from three places on the
/// way, as that for faults, which is no part of it. Where branches skip steps and others lead back, that need not be the way
/// in the order of the names.
fn longest<'c>(chart: &Description<'c>) -> Vec<Vec<&'c str>> {
    let mut ways: Vec<Vec<&str>> = Vec::new();
    let first = (0..chart.steps.len()).find(|step| chart.steps[*step].initial).expect("an initial step");
    let mut open = vec![vec![first]];
    while let Some(way) = open.pop() {
        let names: Vec<&str> = way.iter().map(|step| chart.steps[*step].name).collect();
        let most = ways.first().map_or(0, Vec::len);
        if names.len() > most {
            ways.clear();
        }
        if names.len() >= most {
            ways.push(names);
        }
        let last = way[way.len() - 1];
        let leads = |from: usize, to: usize| chart.transitions.iter().any(|t| t.sources == [from] && t.targets == [to]);
        for next in chart.transitions.iter().filter(|t| t.sources == [last]).flat_map(|t| t.targets) {
            let from = way.iter().filter(|step| leads(**step, *next)).count();
            if !way.contains(next) && from < 3 {
                open.push([&way[..], &[*next]].concat());
            }
        }
    }
    ways
}

#[test]
fn the_main_sequence_is_straight() {
    let mut said = Vec::new();
    for seed in crate::seeds(0..300) {
        let text = aside(seed);
        let bent = charts::with(text.parse().expect("tokens"), |chart| {
            let seen = seen(chart);
            let at = |name: &&str| seen.boxes.iter().find(|b| b.name == **name).map(|b| b.at);
            let straight = |way: &Vec<&str>| {
                let places: Vec<Option<(i32, i32)>> = way.iter().map(at).collect();
                places
                    .windows(2)
                    .all(|pair| pair[0].zip(pair[1]).is_some_and(|((x, y), (next, below))| x == next && y < below))
            };
            let ways = longest(chart);
            if ways.iter().any(straight) { Vec::new() } else { vec![format!("{ways:?} in {text}")] }
        });
        said.push((format!("aside {seed}"), bent.expect("a chart")));
    }
    crate::none(said);
}
