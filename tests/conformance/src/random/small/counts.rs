//! Charts whose loops count how often they turn, within one search for stability: some end by the count alone, some go on.

use super::Sketch;

/// A loop of two to four steps on the way through a chain that is long enough for the bound to let it turn. What counts, what is asked, and
/// what else writes the count is drawn.
pub(super) fn loops(sketch: &mut Sketch) {
    let start = sketch.word(&["0", "1", "250"]);
    sketch.declare(&format!("var n: u32 = {start};\nvar m: u32 = 0;"));
    let (inner, rest) = (sketch.rng.between(2, 4), sketch.rng.between(6, 12));
    let names = |letter: char, of: usize| (0..of).map(|at| format!("{letter}{at}")).collect::<Vec<_>>();
    let (looped, rest) = (names('L', inner), names('R', rest));
    let counting = sketch.rng.below(inner);
    // The initial step stands first.
    for (at, name) in rest.iter().chain(&looped).enumerate() {
        let at = at.checked_sub(rest.len());
        let mut lines = vec![format!("q{};", at.unwrap_or_default() % 3)];
        if at == Some(counting) || at.is_some() && sketch.rng.chance(10) {
            lines.push(grow(sketch));
        } else if sketch.rng.chance(if at.is_some() { 4 } else { 30 }) {
            lines.push(other(sketch));
        }
        if sketch.rng.chance(15) {
            lines.push("P1 m = m + 1;".to_owned());
        }
        sketch.step(name, &lines);
    }
    wire(sketch, &looped, &rest);
}

/// The chain through the loop and back, and the ways out of it.
fn wire(sketch: &mut Sketch, looped: &[String], rest: &[String]) {
    let inner = looped.len();
    let back = sketch.rng.below(inner);
    let limit = sketch.word(&["n < 2", "n < 3", "n <= 2", "m < 2", "!(n >= 3)", "2 > n", "n != 3", "n < 3 || m < 2"]);
    let mut asked = Vec::new();
    for at in 0..inner {
        let plain = sketch.word(&["a", "true", "b", "!c", "a || c"]);
        let condition = if at == back { format!("{plain} && ({limit})") } else { plain.to_owned() };
        sketch.arrow(&looped[at], &condition, &looped[(at + 1) % inner]);
        asked.push(condition);
    }
    for (at, name) in rest.iter().enumerate() {
        let plain = sketch.word(&["a", "rising(b)", "!a", "c && !a", "2ms/R0", "a && !b", "b"]);
        match rest.get(at + 1) {
            Some(next) if at > 0 => sketch.arrow(name, plain, next),
            Some(next) => {
                sketch.arrow(name, plain, &looped[0]);
                sketch.arrow(name, &format!("!({plain}) && rising(c)"), next);
            }
            None => sketch.arrow(name, plain, &rest[0]),
        }
    }
    if sketch.rng.chance(10) {
        // Left and entered at once, and never at rest.
        let (at, condition) = (sketch.rng.below(rest.len()), sketch.word(&["rising(b)", "c && !a && !b", "2ms/R0"]));
        sketch.arrow(&rest[at], &format!("{condition} => m = (m + 1) % 50"), &rest[at]);
    }
    let mut leave = |sketch: &mut Sketch, from: usize, condition: &str, to: &str| {
        // Two that clear together are two tokens, which most charts of this kind cannot do with.
        let condition =
            if sketch.rng.chance(95) { format!("{condition} && !({})", asked[from]) } else { condition.to_owned() };
        sketch.arrow(&looped[from], &condition, to);
        asked[from] = format!("{} || {condition}", asked[from]);
    };
    let out = sketch.word(&["n >= 3", "n >= 2 && a", "!b", "!a && c", "n == 3"]);
    let from = if sketch.rng.chance(70) { back } else { sketch.rng.below(inner) };
    leave(sketch, from, out, &rest[1]);
    // A shorter or a longer way round, with the count or past it.
    if inner > 2 && sketch.rng.chance(40) {
        let (from, to) = (sketch.rng.below(inner), sketch.rng.below(inner));
        let condition = sketch.word(&["a && c", "n < 2", "!b", "b && n < 4", "m < 3"]);
        leave(sketch, from, condition, &looped[to]);
    }
    if sketch.rng.chance(40) {
        let more = sketch.word(&["b && !a", "m >= 2 && !(n < 3)", "rising(a)"]);
        let from = sketch.rng.below(inner);
        leave(sketch, from, more, &rest[2]);
    }
}

fn grow(sketch: &mut Sketch) -> String {
    sketch
        .word(&[
            "P1 n = n + 1;",
            "P1 n = 1 + n;",
            "P1 { n = n + 1; m = n; }",
            "P1 n = n + 2;",
            "P1 n = n + 200;",
            "P1 n = n + 1 if !c;",
            "P1 n = n + 1;",
        ])
        .to_owned()
}

fn other(sketch: &mut Sketch) -> String {
    sketch
        .word(&[
            "P1 n = 0;",
            "P0 n = 0;",
            "P1 n = n + 1;",
            "P1 n = 0;",
            "on rising(c) n = 0;",
            "on rising(L0.X) n = 0;",
        ])
        .to_owned()
}
