//! Messages about what other notations write come only where a chart is wrong: what looks alike and is right stays without a word.

use grafcet_compiler::compile;
use quote::quote;

/// The messages about a chart.
fn messages(lines: &str) -> Vec<String> {
    let chart = format!(
        "sfc Habits {{ input a, b: bool; input n, m: u8; output q: bool; output v: u8; action note(x: u8, y: bool);
         initial step S1 {{ q; v = n; }} step Heat {{ v = m; note(n, a && b); }} {lines} }}"
    );
    let code = compile(&quote!(::grafcet), chart.parse().expect("tokens")).to_string();
    let texts = code.match_indices("compile_error ! {").chain(code.match_indices("compile_error ! ("));
    let mut found: Vec<_> = texts.map(|(at, _)| code[at..].chars().take(160).collect()).collect();
    found.extend(code.match_indices("deprecated (").map(|(at, _)| code[at..].chars().take(200).collect::<String>()));
    found
}

#[test]
fn what_is_right_stays_without_a_word() {
    for lines in [
        // Numbers and times may have names.
        "let none = 0; let one = 1; S1 -[n == none && a]-> Heat -[n == one && m > 0]-> S1;",
        "let limit = 5s; S1 -[a]-> Heat -[Heat.T >= limit && m > n]-> S1;",
        "let sum = n + m; let odd = !n + !m; S1 -[sum > 3 && a]-> Heat -[odd == 3]-> S1;",
        // Constants of the program.
        "S1 -[n == X1 && a]-> Heat -[n != XHeat]-> S1;",
        "S1 -[n == S2 && a]-> Heat -[LIMITS[0] < n]-> S1;",
        "S1 -[a & b]-> Heat -[(a | b) ^ a && n + m > 3 && n * m > 0]-> S1;",
    ] {
        assert_eq!(messages(lines), Vec::<String>::new(), "{lines}");
    }
}

#[test]
fn what_is_wrong_is_told() {
    for (lines, told) in [
        ("S1 -[a && 0]-> Heat -[n > m]-> S1;", "`0` is a number; write `false`"),
        ("S1 -[5s]-> Heat -[n > m]-> S1;", "`5s/S1` holds"),
        ("S1 -[!XHeat]-> Heat -[n > m]-> S1;", "`Heat.X`"),
        ("S1 -[(n == 3) + (m == 4)]-> Heat -[n > m]-> S1;", "`||`"),
        ("let go: u8 = 3; S1 -[n == go]-> Heat -[n > m]-> S1;", "`var go: u8"),
        ("S1 -[a]-> any; step any; any -[b]-> Heat;", "choose another name"),
    ] {
        let found = messages(lines);
        assert!(found.iter().any(|message| message.contains(told)), "{lines}: {found:#?}");
        assert!(!found.iter().any(|message| message.contains("no transition touches")), "{lines}: {found:#?}");
    }
}
