//! Charts about what actions read and write.

use super::Sketch;

/// Stored actions, and conditions that test what they wrote: in the very evolution, in the next one, in another branch.
pub(super) fn places(sketch: &mut Sketch) {
    sketch.declare("output s: bool;\nvar r: bool = false;\nvar n: u8 = 0;\noutput m: u8;");
    let count = sketch.rng.between(3, 5);
    let names: Vec<String> = (0..count).map(|index| format!("S{index}")).collect();
    for (index, name) in names.iter().enumerate() {
        let mut lines = vec![format!("N q{};", index % 3)];
        for _ in 0..sketch.rng.between(1, 2) {
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
            if lines.iter().all(|other| place(other) != place(line)) {
                lines.push(line.to_owned());
            }
        }
        sketch.step(name, &lines);
    }
    let parallel = count == 5 && sketch.rng.chance(50);
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
