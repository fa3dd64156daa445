//! Charts with one clock, or with several that must not be taken for each other.

use super::Sketch;

/// Two steps that wait for what is left of a time, in all the ways to ask for it.
pub(super) fn compared(sketch: &mut Sketch) {
    let lines = [asked(sketch, "A", "q0"), asked(sketch, "B", "q1")];
    sketch.step("A", &lines[..1]);
    sketch.step("B", &lines[1..]);
    for (from, to) in [("A", "B"), ("B", "A")] {
        let time = compares(sketch, from);
        let condition = match sketch.rng.below(6) {
            0 => format!("a && {time}"),
            1 => format!("{time} || c"),
            2 => format!("rising({time})"),
            3 => sketch.word(&["a", "rising(b)", "!a"]).to_owned(),
            _ => time,
        };
        sketch.arrow(from, &condition, to);
    }
}

/// An action that depends on a time, or on nothing.
fn asked(sketch: &mut Sketch, step: &str, output: &str) -> String {
    let condition = compares(sketch, step);
    match sketch.rng.below(5) {
        0 => format!("N {output};"),
        1 => format!("N {output} if b && {condition};"),
        _ => format!("N {output} if {condition};"),
    }
}

fn compares(sketch: &mut Sketch, step: &str) -> String {
    let time = sketch.time();
    match sketch.rng.below(9) {
        0..=2 => format!("{step}.T > {time}"),
        3 => format!("{time} < {step}.T"),
        4 => format!("!({step}.T <= {time})"),
        5 => format!("{step}.T >= {time}"),
        6 => format!("{step}.T == {time}"),
        7 => format!("{step}.T != {time}"),
        _ => format!("({time}/{step})"),
    }
}

/// A step that is left and entered at once, beside branches that ask how long it has been active.
pub(super) fn beside(sketch: &mut Sketch) {
    let times = [(); 5].map(|()| sketch.time());
    let action = match sketch.rng.below(4) {
        0 => format!("N q0 if {}/A;", times[0]),
        1 => format!("D {} q0;", times[0]),
        2 => format!("N q0 if A.T > {};", times[0]),
        _ => format!("L {} q0;", times[0]),
    };
    let again = sketch.word(&["rising(c)", "c && A.T > 1ms", "falling(c)", "rising(c) && !b"]);
    let mut lines = vec![action];
    if sketch.rng.chance(50) {
        sketch.declare("var n: u8 = 0;\noutput m: u8;");
        lines.push("P1 n = (n + 1) % 50;".to_owned());
        lines.push("P0 m = n;".to_owned());
    }
    sketch.step("A", &lines);
    sketch.step("B", &["N q1;".to_owned()]);
    sketch.step("C", &["N q2;".to_owned()]);
    let first = sketch.rng.chance(50);
    if first {
        sketch.arrow("A", again, "A");
    }
    sketch.arrow("A", &format!("a && {}/A", times[1]), "B");
    let other = format!("!a && {}/A", times[2]);
    let other = if first { *sketch.rng.pick(&[&*other, &*other, "else"]) } else { &other };
    sketch.arrow("A", other, "C");
    if !first {
        sketch.arrow("A", again, "A");
    }
    sketch.arrow("B", &format!("{}/B", times[3]), "A");
    sketch.arrow("C", &format!("C.T > {} || b", times[4]), "A");
}

/// Branches beside each other, whose times need more than two bytes in one and fewer in another.
pub(super) fn long(sketch: &mut Sketch) {
    const TIMES: [&str; 10] =
        ["65534ms", "65535ms", "65535ms", "65536ms", "65537ms", "70s", "131071ms", "131072ms", "131073ms", "200s"];
    let long = [(); 3].map(|()| sketch.word(&TIMES));
    let short = [(); 2].map(|()| sketch.time());
    sketch.step("A0", &[]);
    for (step, time) in [("A1", long[0]), ("A2", short[0]), ("B1", long[1]), ("B2", long[2]), ("E", short[1])] {
        let output = sketch.word(&["q0", "q1", "q2"]);
        let line = match sketch.rng.below(5) {
            0 => format!("N {output} if {step}.T > {time};"),
            1 => format!("L {time} {output};"),
            2 => format!("D {time} {output};"),
            _ => format!("N {output};"),
        };
        sketch.step(step, &[line]);
    }
    let start = sketch.word(&["a", "true", "1ms/A0", "b || c"]);
    sketch.arrow("A0", start, "(A1, B1)");
    for (from, to, time) in [("A1", "A2", long[0]), ("B1", "B2", long[1])] {
        let condition = match sketch.rng.below(5) {
            0 | 1 => format!("{time}/{from}"),
            2 => format!("{from}.T > {time}"),
            3 => format!("b && {from}.T >= {time}"),
            _ => format!("{time}/{from} || (c && 3ms/{from})"),
        };
        sketch.arrow(from, &condition, to);
    }
    let end = sketch.word(&["true", "!a", "2ms/A2", "65536ms/B2"]);
    sketch.arrow("(A2, B2)", end, "E");
    sketch.arrow("E", &format!("{}/E", short[1]), "A0");
}

/// A delay, whose times may be exchanged while it runs.
pub(super) fn delay(sketch: &mut Sketch) {
    let times = [(); 4].map(|()| sketch.time());
    let of = sketch.word(&["a", "a && b", "A.X", "B.X && a", "!a", "a || c"]);
    let of = if of.contains([' ', '!']) { format!("({of})") } else { of.to_owned() };
    let delay = match sketch.rng.below(4) {
        0 => format!("({}/{of})", times[0]),
        _ => format!("({}/{of}/{})", times[0], times[1]),
    };
    let other = match sketch.rng.below(10) {
        0 | 1 => format!("({}/b/{})", times[2], times[3]),
        2 => format!("({}/({}/b))", times[2], times[3]),
        // Longer than readings of the clock can be compared.
        3 => format!("(2200000s/b/{})", times[3]),
        _ => "b".to_owned(),
    };
    let shown = match sketch.rng.below(3) {
        0 => format!("N q0 if {delay};"),
        1 => format!("N q0 if !{delay};"),
        _ => "N q0;".to_owned(),
    };
    sketch.step("A", std::slice::from_ref(&shown));
    sketch.step("B", &[shown.replace("q0", "q1")]);
    let go = match sketch.rng.below(4) {
        0 => delay,
        1 => format!("rising({delay})"),
        2 => format!("c && !{delay}"),
        _ => "c".to_owned(),
    };
    sketch.arrow("A", &go, "B");
    let back = match sketch.rng.below(3) {
        0 => format!("falling({other})"),
        1 => format!("rising({other})"),
        _ => "rising(c)".to_owned(),
    };
    sketch.arrow("B", &back, "A");
}

/// The timers of actions: alone, shared by two steps, and with times that are exchanged.
pub(super) fn action(sketch: &mut Sketch) {
    let qualifiers: &[&str] = if sketch.grafcet { &["L", "D"] } else { &["L", "D", "SD", "DS", "SL"] };
    let one = *sketch.rng.pick(qualifiers);
    let other = if sketch.rng.chance(60) { one } else { *sketch.rng.pick(qualifiers) };
    let times = [(); 3].map(|()| sketch.time());
    sketch.step("A", &[format!("{one} {} q0;", times[0])]);
    let second = match sketch.rng.below(4) {
        0 => "N q1;".to_owned(),
        1 => format!("{other} {} q1;", times[1]),
        _ => format!("{other} {} q0;", times[1]),
    };
    sketch.step("B", &[second]);
    // In a `grafcet` R is for what is stored, and L and D are not.
    let last = if sketch.grafcet { "N q2;" } else { "R q0;" };
    sketch.step("C", &[last.to_owned()]);
    let again = sketch.rng.chance(40);
    if again {
        sketch.arrow("A", "rising(b)", "A");
    }
    sketch.arrow("A", "a", "B");
    let onwards = format!("{}/B", times[2]);
    let onwards = *sketch.rng.pick(&["!a", "c", &onwards]);
    sketch.arrow("B", onwards, "C");
    let back = sketch.word(&["b", "rising(a)", "!c"]);
    sketch.arrow("C", back, "A");
}

/// What is true and false in turn since its step was entered, beside another clock or alone.
pub(super) fn blinking(sketch: &mut Sketch) {
    let blinks = [(); 4].map(|()| sketch.word(&["3ms", "1ms", "5ms", "2ms/4ms", "7ms/1ms", "4ms/4ms"]));
    sketch.step("A", &[format!("N q0 if blink({});", blinks[0])]);
    let other = match sketch.rng.below(4) {
        0 => format!("N q1 if !blink({}) && a;", blinks[1]),
        1 => format!("N q1 if blink({}, A) || blink({});", blinks[1], blinks[2]),
        2 => format!("N q1 if B.T > {} && blink({});", sketch.time(), blinks[1]),
        _ => "N q1;".to_owned(),
    };
    sketch.step("B", &[other]);
    let parallel = sketch.rng.chance(40);
    if parallel {
        sketch.step("C", &[format!("N q2 if blink({}, B) ^ blink({});", blinks[2], blinks[3])]);
    }
    let go = match sketch.rng.below(5) {
        0 => format!("a && blink({})", blinks[3]),
        1 => format!("rising(a) && !blink({})", blinks[3]),
        2 => format!("{}/A", sketch.time()),
        _ => "a".to_owned(),
    };
    let back = sketch.word(&["b", "rising(b)", "12ms/B", "!a"]);
    if parallel {
        sketch.arrow("A", &go, "(B, C)");
        sketch.arrow("(B, C)", back, "A");
    } else {
        sketch.arrow("A", &go, "B");
        sketch.arrow("B", back, "A");
    }
    if sketch.rng.chance(40) {
        sketch.arrow("A", "rising(c)", "A");
    }
}
