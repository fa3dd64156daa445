//! Charts whose operands come from fragments of `macro_rules!`: whatever stands around one, it is a whole.

use super::Sketch;

/// Conditions, values, arguments and blocks.
pub(super) fn operands(sketch: &mut Sketch) {
    sketch.declare("var n: frag_t!(i16) = 0;\noutput m: i16;\noutput w: frag_t!(bool);\naction f(x: i16);");
    let arguments = [(); 3].map(|()| number(sketch));
    let conditions = [(); 4].map(|()| condition(sketch, 2));
    let block = format!("frag_b!({{ n = {} % 50; }})", number(sketch));
    sketch.step("A", &[format!("N q0 if {};", conditions[0]), format!("P1 n = {} % 50;", arguments[0])]);
    sketch.step("B", &[format!("N f({});", arguments[1]), format!("P0 m = {};", arguments[2]), "N q1;".to_owned()]);
    let last = sketch.word(&["P1 w = frag_e!(a || b) && c;", "P1 w = !frag_e!(n > 3);", "N q2 if frag_e!(2ms/C) ^ a;"]);
    // Written from one step alone in a `grafcet` (A7).
    let also = if sketch.grafcet { String::new() } else { format!("P1 {block}") };
    let mut lines = vec![last.to_owned()];
    lines.extend((!also.is_empty()).then_some(also));
    sketch.step("C", &lines);
    for (index, (from, to)) in [("A", "B"), ("B", "C"), ("C", "A")].into_iter().enumerate() {
        let condition = match sketch.rng.below(4) {
            0 => format!("rising({})", conditions[index + 1]),
            1 => format!("{} || frag_l!(3ms)/{from}", conditions[index + 1]),
            _ => conditions[index + 1].clone(),
        };
        sketch.arrow(from, &condition, to);
    }
}

fn condition(sketch: &mut Sketch, depth: usize) -> String {
    if depth == 0 {
        return sketch.word(&["a", "b", "c", "!a", "n > 2", "A.X", "B.T > 2ms", "frag_e!(n == 0)"]).to_owned();
    }
    let (left, right) = (condition(sketch, depth - 1), condition(sketch, depth - 1));
    let fragment = format!("frag_e!({left} {} {right})", sketch.word(&["&&", "||", "||", "^", "!="]).trim());
    let fragment = if fragment.contains(" ^ ") || fragment.contains(" != ") {
        // Rust does not chain comparisons, and `^` binds closer than they do.
        format!("frag_e!(({left}) != ({right}))")
    } else {
        fragment
    };
    match sketch.rng.below(5) {
        0 => format!("!{fragment}"),
        1 => format!("a && {fragment}"),
        2 => format!("{fragment} && b"),
        3 => format!("!{fragment} || c"),
        _ => fragment,
    }
}

fn number(sketch: &mut Sketch) -> String {
    let inner =
        sketch.word(&["frag_e!(n + 1)", "frag_e!(n - 2)", "frag_e!(frag_l!(3) + n)", "frag_e!(n % 5)", "frag_l!(4)"]);
    match sketch.rng.below(5) {
        0 => format!("3 * {inner}"),
        1 => format!("{inner} * 2"),
        2 => format!("9 - {inner}"),
        3 => format!("{inner} % 7"),
        _ => inner.to_owned(),
    }
}
