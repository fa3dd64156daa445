//! What an editor finds in a chart: the code for rust-analyzer mentions names at the tokens at which the user wrote them.

use grafcet_compiler::compile;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::quote;

/// Marked with `^` below them are the names that the rest of the code does not mention there.
const CHART: &str = "\
grafcet Press {
    input a: bool;
    output b, c: bool; action beep();
    initial step Wait { beep(); }
    #                   ^^^^
    step Down { b; } step Up { S c if a; R c; }
    #           ^                ^    ^    ^
    Wait -[a]-> (Down, Up) -[Down.X && !a]-> Wait;
    ^^^^   ^     ^^^^  ^^    ^^^^       ^    ^^^^
}";

/// The same of macro-steps, partial grafcets and variables; what is declared for them carries the tokens of the
/// declarations, types included.
const HIERARCHY: &str = "\
grafcet Plant {
    input a: bool; output b: bool;
    var busy: bool; var count: u16 = 0;
    #   ^^^^  ^^^^      ^^^^^  ^^^
    initial step Wait { R busy; P1 count = count + 1; force Station {INIT}; }
    #                     ^^^^     ^^^^^   ^^^^^            ^^^^^^^
    macro step Clamp { entry step In { S busy; } exit step Out; In -[a]-> Out; }
    #          ^^^^^                     ^^^^                   ^^   ^    ^^^
    Wait -[a]-> Clamp -[Station::Ready.X]-> Wait;
    ^^^^   ^    ^^^^^   ^^^^^^^  ^^^^^      ^^^^
    partial Station { initial step Ready { b; } step Off; Ready -[a]-> Off -[!a && Clamp.X]-> Ready; }
    #       ^^^^^^^                        ^              ^^^^^   ^    ^^^    ^    ^^^^^      ^^^^^
}";

/// Named conditions, where they are declared and used, also by each other and in macros; a local name is another.
const NAMES: &str = "\
sfc Feed {
    input a, b: bool; output q: bool; var n: u8 = 0;
    #                                     ^  ^^
    let go = a || rising(b); let both = go && matches!(n, 1 if go);
    #   ^^   ^           ^       ^^^^   ^^             ^       ^^
    initial step Off;
    step On { N q if go; P1 { let go = n; n = go; } }
    #           ^    ^^                ^  ^
    Off -[go]-> On -[!both && !go]-> Off;
    ^^^   ^^    ^^    ^^^^     ^^    ^^^
}";

/// The lines of the chart alone, and the marked words with their line and column.
fn read(text: &str) -> (String, Vec<(String, usize, usize)>) {
    let (mut chart, mut marked) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let is_mark = line.contains(['#', '^']);
        if !is_mark {
            chart.push(line);
            continue;
        }
        let above = chart.last().expect("a line above the marks");
        for (blank, _) in line.match_indices(" ^") {
            let column = blank + 1;
            let length = line[column..].chars().take_while(|c| *c == '^').count();
            marked.push((above[column..column + length].to_owned(), chart.len(), column));
        }
    }
    (chart.join("\n"), marked)
}

fn idents(tokens: TokenStream, to: &mut Vec<Ident>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => idents(group.stream(), to),
            TokenTree::Ident(ident) => to.push(ident),
            _ => {}
        }
    }
}

/// What the function for editors mentions, in source order.
fn mentioned(chart: &str) -> Vec<(String, usize, usize)> {
    // Not called as the keyword is, at which the code of ours stands.
    let code = compile(&quote!(::facade), chart.parse().expect("tokens"));
    let mut all = Vec::new();
    idents(code, &mut all);
    let start = all.iter().position(|ident| ident == "rust_analyzer").expect("the code for editors");
    let place = |ident: &Ident| (ident.to_string(), ident.span().start().line, ident.span().start().column);
    let chart = all[start..].iter().filter(|ident| ident.span().source_text().is_some_and(|text| **ident == *text));
    let mut found: Vec<_> = chart.map(place).collect();
    found.sort_by_key(|(_, line, column)| (*line, *column));
    found
}

#[test]
fn names_are_mentioned_where_they_stand() {
    for text in [CHART, HIERARCHY, NAMES] {
        let (chart, marked) = read(text);
        assert_eq!(mentioned(&chart), marked);
    }
}

/// A chart with a mistake has them, too.
#[test]
fn names_are_mentioned_in_a_chart_with_a_mistake() {
    for text in [CHART, HIERARCHY, NAMES] {
        let (chart, marked) = read(text);
        let wrong = chart.replace("[a]", "[x]").replace("= n;", "= x;");
        let lines: Vec<&str> = wrong.lines().collect();
        let there = marked.into_iter().filter(|(name, line, column)| lines[line - 1][*column..].starts_with(name));
        assert_eq!(mentioned(&wrong), there.collect::<Vec<_>>());
    }
}
