//! Charts about values that are assigned in every cycle: which of them let the sleeper sleep.

use super::{Sketch, counts};

/// Variables that follow inputs, steps, times and each other, and what asks for them; some of a `grafcet` count how often loops turn.
pub(super) fn assigned(sketch: &mut Sketch) {
    if sketch.grafcet && sketch.rng.chance(40) {
        return counts::loops(sketch);
    }
    sketch.declare("var flash, late: bool = false;\nvar n, m: u8 = 0;\nvar w: time = 2ms;\noutput v: u8;");
    for (index, name) in ["A", "B", "C"].into_iter().enumerate() {
        let mut lines = vec![format!("N q{index} if {};", asked(sketch, name))];
        if sketch.grafcet {
            // Stored actions write from one step alone: two that could do it in one evolution are a mistake (A7).
            let event = sketch.word(&["rising(a)", "rising(2ms/!c/3ms)", "rising(A.T > 3ms)", "falling(b) && c"]);
            let more = match index {
                0 => format!("on {event} n = (n + 1) % 9;"),
                1 => format!("on {event} w = B.T;"),
                _ => format!("flash if {};", sketch.word(&["3ms/a/2ms", "a && !b", "4ms/C", "C.T < w"])),
            };
            lines.push(more);
        } else {
            for _ in 0..sketch.rng.between(1, 2) {
                lines.push(run(sketch, name));
            }
        }
        sketch.step(name, &lines);
    }
    let conditions = [("A", "a"), ("B", "rising(b)"), ("C", "c")].map(|(step, plain)| match sketch.rng.below(3) {
        0 => asked(sketch, step),
        _ => plain.to_owned(),
    });
    if sketch.rng.chance(40) {
        sketch.arrow("A", &conditions[0], "(B, C)");
        sketch.arrow("(B, C)", &conditions[1], "A");
    } else {
        sketch.arrow("A", &conditions[0], "B");
        sketch.arrow("B", &conditions[1], "C");
        sketch.arrow("C", &conditions[2], "A");
    }
}

fn asked(sketch: &mut Sketch, step: &str) -> String {
    let time = sketch.time();
    match sketch.rng.below(9) {
        0 => "flash".to_owned(),
        1 if !sketch.grafcet => "late && !c".to_owned(),
        2 => "n > 3 || a".to_owned(),
        3 => format!("{step}.T > {time}"),
        4 => format!("{time} <= {step}.T && !b"),
        5 => format!("{step}.T + 1ms > {time}"),
        6 => format!("{step}.T > w"),
        7 if !sketch.grafcet => "v > 2 && a".to_owned(),
        _ => format!("{time}/{step}"),
    }
}

/// An assignment that runs as long as something lets it.
fn run(sketch: &mut Sketch, step: &str) -> String {
    let (time, other) = (sketch.time(), sketch.word(&["1ms", "2ms", "4ms"]));
    match sketch.rng.below(13) {
        0 => format!("N flash = {time}/!flash/{other};"),
        1 => "N flash = a && !b;".to_owned(),
        2 => format!("N late = {step}.T > {time};"),
        3 => format!("N late = flash || {time}/{step};"),
        4 => format!("N late = blink({other}, {step});"),
        5 => "N n = (n + 1) % 9 if b;".to_owned(),
        6 => "N n = m;".to_owned(),
        7 => format!("{} {time} m = (n + 3) % 7;", sketch.word(&["L", "D", "SD", "DS", "SL"])),
        8 => format!("{} m = (m + 2) % 5;", sketch.word(&["P", "P1", "P0", "S"])),
        9 => "N m = n if !c;".to_owned(),
        10 => "N { m = n; }".to_owned(),
        11 => format!("N w = {step}.T;"),
        _ => format!("L {time} v = n;"),
    }
}
