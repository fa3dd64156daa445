//! Charts about words that stand for more than one transition or expression: `let`, `any`, the variants of an enum.

use super::Sketch;

/// Named conditions, one used by the next, at transitions, after `if`, in edges, delays, arguments and values.
pub(super) fn named(sketch: &mut Sketch) {
    sketch.declare("output s: bool;\nvar n: u8 = 0;\noutput m: u8;\naction f(x: bool);");
    let first = ["a || rising(b)", "rising(a) && !c", "falling(b)", "a && !b", "B.X && b", "A.T >= 2ms", "n > 1"];
    let first = sketch.word(&first);
    let second = ["w0 && c", "!w0", "rising(w0)", "falling(w0) || c", "w0 || 2ms/B", "(2ms/w0/3ms)", "w0 != rising(c)"];
    let second = sketch.word(&second);
    let third = ["w1 || rising(c)", "!w1 && w0", "rising(w1) || a", "w0 ^ w1", "(3ms/w1)", "3ms/C && !w0", "t/A || w1"];
    let third = sketch.word(&third);
    // Without edges: conditions of continuous actions have none (IEC 60848).
    let fourth = ["a && !b", "n > 1 || c", "A.T >= 2ms", "B.X && b", "(2ms/c)", "blink(2ms/1ms, B) || 3ms/C"];
    let fourth = sketch.word(&fourth);
    let fifth = ["!w3", "w3 && c", "w3 || 2ms/B", "(2ms/w3/3ms)", "w3 ^ a"];
    let fifth = sketch.word(&fifth);
    sketch.declare(&format!("let w0 = {first};\nlet w1 = {second};\nlet w2 = {third};"));
    sketch.declare(&format!("let w3 = {fourth};\nlet w4 = {fifth};"));
    let levels: &[&str] = if sketch.grafcet { &["w3", "w4"] } else { &["w0", "w1", "w2", "w4"] };
    for (name, output) in [("A", "q0"), ("B", "q1"), ("C", "q2")] {
        let word = sketch.word(levels);
        let shown = match sketch.rng.below(4) {
            0 => format!("N {output} if !{word};"),
            1 => format!("D 2ms {output} if {word};"),
            _ => format!("N {output} if {word};"),
        };
        let mut lines = vec![shown];
        let (word, level) = (sketch.word(&WORDS), sketch.word(levels));
        let more = match (name, sketch.rng.below(3)) {
            ("A", _) => format!("N f({level});"),
            ("B", 0) if sketch.grafcet => format!("on rising({word}) n = (n + 1) % 4;"),
            ("B", _) => "P1 n = (n + 1) % 4;".to_owned(),
            (_, 0) => format!("s = {level};"),
            (_, 1) => format!("P0 {{ if {word} {{ m = n; }} else {{ m = 9; }} }}"),
            _ => format!("N s if {level} && b;"),
        };
        lines.push(more);
        sketch.step(name, &lines);
    }
    for (from, to) in [("A", "B"), ("B", "C"), ("C", "A")] {
        let word = sketch.word(&WORDS);
        let condition = match sketch.rng.below(7) {
            0 => format!("rising({word})"),
            1 => format!("{word} && rising(a)"),
            2 => format!("!{word}"),
            3 => format!("{word} && 1ms/{from}"),
            4 => format!("(2ms/{word})"),
            _ => word.to_owned(),
        };
        sketch.arrow(from, &condition, to);
        if from == "A" && sketch.rng.chance(30) {
            sketch.arrow(from, "else", "C");
        }
    }
}

/// The names of conditions.
const WORDS: [&str; 5] = ["w0", "w1", "w2", "w3", "w4"];

/// Several `any` over branches beside each other, with all that leaving a step does.
pub(super) fn any(sketch: &mut Sketch) {
    sketch.declare("var n: u8 = 0;\nvar k: u8 = 0;\noutput m: u8;\naction f(x: u8);\naction g();");
    let timed = sketch.time();
    let lines = [
        sketch.word(&["N q0;", "P0 n = (n + 1) % 9;", "N f(n);", "P0 f(n);"]).to_owned(),
        format!("{} {timed} q1;", sketch.word(&["L", "D"])),
        sketch.word(&["N q2 if U.T > 2ms;", "N g();", "P1 m = n;", "P0 g();"]).to_owned(),
    ];
    let extra = sketch.word(&["N f(k);", "P0 k = (k + 1) % 9;", "N q0 if c;"]).to_owned();
    let macro_step = sketch.grafcet && sketch.rng.chance(25);
    sketch.step("A", &[]);
    sketch.step("B", &lines[..1]);
    sketch.step("C", &lines[1..2]);
    sketch.step("U", &lines[2..]);
    sketch.step("V", &[extra]);
    if macro_step {
        sketch.steps.push_str("macro step W {\nentry step K {\nN q0;\n}\nexit step H;\nK -[a]-> H;\n}\n");
    } else {
        sketch.step("W", &[]);
    }
    for index in 0..sketch.rng.between(1, 3) {
        let except = sketch.word(&["", "", "", " except A", " except W", " except (B, U)", " except (A, V)"]);
        // An `sfc` has no sink transitions.
        let targets = ["A", "A", "W", "W", "(C, U)", "(B, V)", "V", "()"];
        let target = sketch.word(&targets[..targets.len() - usize::from(!sketch.grafcet)]);
        // Each is another transition, also where it leaves and enters the same.
        let conditions = [
            ["c", "rising(c)", "falling(a)"],
            ["rising(b) && !c", "c && 3ms/C", "5ms/U"],
            ["B.X && c", "!a && b && c", "t/V || rising(c)"],
        ];
        let condition = sketch.word(&conditions[index]);
        let clearing = if sketch.grafcet { sketch.word(&["", "", " => m = (m + 1) % 9", " => f(n), g()"]) } else { "" };
        sketch.arrow(&format!("any{except}"), &format!("{condition}{clearing}"), target);
    }
    let parallel = sketch.rng.chance(70);
    let go = sketch.word(&["a", "rising(a)", "a && !c", "b"]);
    let (left, right, join) = (branch(sketch, "B"), branch(sketch, "C"), branch(sketch, "V"));
    if parallel {
        sketch.arrow("A", go, "(B, C)");
        sketch.arrow("B", &left, "U");
        sketch.arrow("C", &right, "V");
        sketch.arrow("(U, V)", &join, "W");
    } else {
        sketch.arrow("A", go, "B");
        sketch.arrow("B", &left, "C");
        sketch.arrow("B", "else", "U");
        sketch.arrow("C", &right, "V");
        sketch.arrow("U", "rising(b)", "V");
        sketch.arrow("V", &join, "W");
    }
    sketch.arrow("W", "!b", "A");
    // Where nothing may be active, something has to begin again.
    if sketch.grafcet {
        sketch.arrow("()", "rising(b) && !A.X && !B.X && !C.X && !U.X && !V.X && !W.X", "A");
    }
}

fn branch(sketch: &mut Sketch, from: &str) -> String {
    match sketch.rng.below(5) {
        0 => format!("2ms/{from}"),
        1 => format!("{from}.T > 3ms || b"),
        2 => "rising(b)".to_owned(),
        3 => "a || b".to_owned(),
        _ => "b".to_owned(),
    }
}

/// An input of an enum, compared and matched.
pub(super) fn modes(sketch: &mut Sketch) {
    sketch.declare("input mode: Mode in {Off, Auto, Manual};\noutput m: u8;\naction f(x: bool);");
    // Conditions of continuous actions have no edges in a `grafcet` (IEC 60848).
    let edges = !sketch.grafcet;
    let lines = [asked(sketch, edges), asked(sketch, edges), asked(sketch, true)];
    sketch.step("A", &[format!("N q0 if {};", lines[0])]);
    sketch.step("B", &[format!("N f({});", lines[1]), "N q1;".to_owned()]);
    sketch.step("C", &[format!("P0 {{ if {} {{ m = 1; }} else {{ m = 2; }} }}", lines[2])]);
    let parallel = sketch.rng.chance(30);
    if parallel {
        sketch.arrow("A", "mode == Mode::Auto", "(B, C)");
        sketch.arrow("(B, C)", "mode == Mode::Off || 7ms/B", "A");
    } else {
        let to_b = asked(sketch, true);
        sketch.arrow("A", &to_b, "B");
        let last = asked(sketch, true);
        let other = if sketch.rng.chance(50) { "else".to_owned() } else { format!("!({to_b}) && {last}") };
        sketch.arrow("A", &other, "C");
        let back = asked(sketch, true);
        sketch.arrow("B", &format!("rising({back})"), "A");
        let back = asked(sketch, true);
        sketch.arrow("C", &format!("({back}) && (b || 3ms/C)"), "A");
    }
    if sketch.rng.chance(40) {
        let stop = asked(sketch, true);
        sketch.arrow("any", &format!("rising({stop})"), "A");
    }
}

fn asked(sketch: &mut Sketch, edges: bool) -> String {
    let conditions = [
        "mode == Mode::Auto",
        "mode != Mode::Off",
        "Mode::Manual == mode",
        "matches!(mode, Mode::Auto | Mode::Manual)",
        "!matches!(mode, Mode::Manual)",
        "(2ms/(mode == Mode::Auto)/3ms)",
        "rising(mode == Mode::Manual)",
        "falling(mode != Mode::Auto)",
    ];
    let condition = sketch.word(&conditions[..if edges { 8 } else { 6 }]);
    match sketch.rng.below(4) {
        0 => format!("{condition} && a"),
        1 if edges => format!("({condition}) || rising(c)"),
        _ => condition.to_owned(),
    }
}
