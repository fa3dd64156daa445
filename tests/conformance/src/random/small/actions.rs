//! Charts about what actions read and write.

use super::Sketch;

/// Stored actions, and conditions that test what they wrote: in the very evolution, in the next one, in another branch.
pub(super) fn places(sketch: &mut Sketch) {
    sketch.declare("output s: bool;\nvar r: bool = false;\nvar n: u8 = 0;\noutput m: u8;");
    // A place is written on activation or on deactivation: one step is left in the evolution that enters the next (A7).
    let leaves = [("r", sketch.rng.chance(40)), ("n", sketch.rng.chance(40)), ("m", sketch.rng.chance(40))];
    let count = sketch.rng.between(3, 5);
    let parallel = count == 5 && sketch.rng.chance(50);
    let names: Vec<String> = (0..count).map(|index| format!("S{index}")).collect();
    for (index, name) in names.iter().enumerate() {
        let mut lines = vec![format!("N q{};", index % 3)];
        // What a condition reads in a `grafcet` is stored: the first step stores all of it.
        if index == 0 && sketch.grafcet {
            lines.extend(["S s;".to_owned(), at_once("P1 m = n;", leaves)]);
        }
        // Beside it, S1 writes alone: two stored actions of one evolution must not write one place (A7).
        let alone = !(sketch.grafcet && parallel && index == 2);
        for _ in 0..usize::from(alone) * sketch.rng.between(1, 2) {
            let line = match sketch.rng.below(10) {
                0 | 1 => "S s;",
                2 => "R s;",
                3 => "P1 r = !r;",
                4 => "P1 r = a;",
                5 => "P0 r = b || s;",
                6 => "P1 n = (n + 1) % 4;",
                7 => "P0 n = (n + 3) % 5;",
                8 => "P1 m = n;",
                _ => "P0 m = (n + 1) % 7;",
            };
            let place = |line: &str| line.split(' ').nth(1).map(|place| place.trim_end_matches(';').to_owned());
            let line = if sketch.grafcet { at_once(line, leaves) } else { line.to_owned() };
            if lines.iter().all(|other| place(other) != place(&line)) {
                lines.push(line);
            }
        }
        sketch.step(name, &lines);
    }
    for (index, name) in names.iter().enumerate() {
        let condition = tested(sketch);
        let next = &names[(index + 1) % count];
        match (parallel, index) {
            // S1 and S2 are beside each other.
            (true, 0) => sketch.arrow(name, &condition, "(S1, S2)"),
            (true, 1) => sketch.arrow("(S1, S2)", &condition, "S3"),
            (true, 2) => {}
            _ if sketch.rng.chance(25) => {
                sketch.arrow(name, &format!("!c && {condition}"), next);
                let back = sketch.rng.pick(&names).clone();
                let jump = if parallel { names[3].clone() } else { back };
                let other = sketch.word(&["c", "c", "else"]);
                sketch.arrow(name, other, &jump);
            }
            _ => sketch.arrow(name, &condition, next),
        }
    }
}

/// The line at the moment at which its place is written.
fn at_once(line: &str, leaves: [(&str, bool); 3]) -> String {
    let (qualifier, rest) = line.split_once(' ').unwrap_or((line, ""));
    match leaves.iter().find(|(place, _)| qualifier.starts_with('P') && rest.starts_with(place)) {
        Some((_, leaves)) => format!("P{} {rest}", usize::from(!leaves)),
        None => line.to_owned(),
    }
}

fn tested(sketch: &mut Sketch) -> String {
    let condition = sketch.word(&[
        "s",
        "!s",
        "r",
        "!r",
        "n > 1",
        "n == 0",
        "rising(s)",
        "falling(r)",
        "rising(n > 2)",
        "s && a",
        "r || b",
        "m < 3",
    ]);
    match sketch.rng.below(5) {
        0 => format!("{condition} && a"),
        1 => format!("({condition}) || rising(b)"),
        2 => format!("({condition}) ^ a"),
        _ => condition.to_owned(),
    }
}

/// Edges of step variables, of inputs and of both, in the actions of steps that are entered and left.
pub(super) fn edges(sketch: &mut Sketch) {
    sketch.declare("var n: u8 = 0;\noutput m: u8;\noutput v: u8;");
    let parallel = sketch.rng.chance(40);
    for (index, name) in ["A", "B", "C"].into_iter().enumerate() {
        if sketch.grafcet && index > 0 {
            // Stored actions write from one step alone: two that could do it in one evolution are a mistake (A7).
            let condition = sketch.word(&["a", "b", "B.X", "2ms/C"]);
            sketch.step(name, &[format!("N q{index} if {condition};")]);
            continue;
        }
        let lines = [acts(sketch, 0), acts(sketch, 1), acts(sketch, 2)];
        let count = sketch.rng.between(1, 3);
        sketch.step(name, &lines[..count]);
    }
    let go = sketch.word(&["a", "rising(a)", "true", "!b"]);
    let on = sketch.word(&["b", "rising(b)", "rising(A.X)", "falling(A.X) || c", "true"]);
    // In a `grafcet` the circle comes to rest by an edge of an input.
    let backs = ["falling(b)", "rising(c)", "c", "rising(C.X)", "!a"];
    let back = sketch.word(&backs[..if sketch.grafcet { 2 } else { 5 }]);
    if parallel {
        sketch.arrow("A", go, "(B, C)");
        sketch.arrow("(B, C)", back, "A");
    } else {
        sketch.arrow("A", go, "B");
        sketch.arrow("B", on, "C");
        sketch.arrow("C", back, "A");
        if sketch.rng.chance(40) {
            sketch.arrow("B", "rising(c)", "B");
        }
    }
}

fn acts(sketch: &mut Sketch, place: usize) -> String {
    let edge = sketch.word(&[
        "rising(A.X)",
        "rising(B.X)",
        "falling(B.X)",
        "rising(C.X)",
        "falling(A.X)",
        "rising(a)",
        "rising(B.X && a)",
        "falling(A.X || b)",
        "rising(B.T > 2ms)",
    ]);
    if sketch.grafcet {
        // Conditions of continuous actions have no edges (IEC 60848).
        return match place {
            0 => format!("on {edge} n = (n + 1) % 50;"),
            1 => "P1 m = n;".to_owned(),
            _ => format!("on {edge} && c v = n;"),
        };
    }
    match (place, sketch.rng.below(3)) {
        (0, _) => format!("N q0 if {edge};"),
        (1, 0) => format!("P1 n = (n + 1) % 50 if {edge};"),
        (1, 1) => format!("P1 {{ if {edge} {{ n = (n + 1) % 50; }} }}"),
        (1, _) => format!("N {{ if {edge} {{ n = (n + 1) % 50; }} }}"),
        (_, 0) => format!("N v = 3 if {edge};"),
        (_, 1) => "P0 m = n;".to_owned(),
        _ => format!("D 2ms q1 if {edge} || a;"),
    }
}

/// One call for several steps under all qualifiers, each with an argument of its own.
pub(super) fn calls(sketch: &mut Sketch) {
    sketch.declare("action f(x: u8);\nvar n: u8 = 0;");
    let parallel = sketch.rng.chance(40);
    let mut number = 0;
    for name in ["A", "B", "C", "E"] {
        let mut lines = Vec::new();
        for _ in 0..sketch.rng.between(0, 2) {
            number += 1;
            let time = sketch.time();
            let argument = if sketch.rng.chance(20) { "n".to_owned() } else { number.to_string() };
            let kinds = if sketch.grafcet { 4 } else { 16 };
            let qualifier = match sketch.rng.below(kinds) {
                0..=3 => "N".to_owned(),
                4 | 5 => "S".to_owned(),
                6 | 7 => "R".to_owned(),
                8 => "P1".to_owned(),
                9 => "P0".to_owned(),
                10 => "P".to_owned(),
                11 => format!("L {time}"),
                12 => format!("D {time}"),
                13 => format!("SD {time}"),
                14 => format!("DS {time}"),
                _ => format!("SL {time}"),
            };
            let condition = sketch.word(&["", "", " if a", " if !c"]);
            lines.push(format!("{qualifier} f({argument}){condition};"));
        }
        // B and C may be entered at once.
        if sketch.rng.chance(30) && !(sketch.grafcet && parallel && name == "C") {
            lines.push("P1 n = (n + 1) % 50;".to_owned());
        }
        sketch.step(name, &lines);
    }
    let conditions = [(); 4].map(|()| sketch.word(&["a", "b", "!a", "rising(c)", "3ms/A", "2ms/B", "true", "c"]));
    if parallel {
        sketch.arrow("A", conditions[0], "(B, C)");
        sketch.arrow("(B, C)", conditions[1], "E");
        sketch.arrow("B", "rising(b)", "B");
    } else {
        sketch.arrow("A", conditions[0], "B");
        sketch.arrow("B", conditions[1], "C");
        sketch.arrow("C", conditions[2], "E");
        sketch.arrow("A", "rising(b)", "A");
    }
    let rest = sketch.word(&["rising(a)", "3ms/E", "falling(c) && b"]);
    sketch.arrow("E", if sketch.grafcet { rest } else { conditions[3] }, "A");
}
