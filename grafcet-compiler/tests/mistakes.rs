//! Faults that people make, put into charts of the size that people draw: each is found, under its rule, at the right
//! tokens, and nothing else is said. Near misses, which are no faults, are among them.
//!
//! `mistakes/good` holds the charts. In the lists beside it a fault is `# name : chart`, then `= rule @ marked ¦ marked ; …`
//! (or `= none`), then what is replaced (`-`) by what (`+`); in `alone.txt` and `malformed.txt` a chart of its own follows.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use proc_macro2::{LineColumn, TokenStream, TokenTree};

/// What a rule marks.
type Marks = Vec<(String, String)>;

/// Follow from faults of other kinds; how they are told is tested elsewhere.
const OF_EVOLUTION: &[&str] = &["unsafe_step", "unreachable_step", "dead_transition", "stuck_join", "deadlock"];

fn folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/mistakes"))
}

fn read(name: &str) -> String {
    fs::read_to_string(folder().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The text between two places.
fn between(text: &str, from: LineColumn, to: LineColumn) -> String {
    let line = |(number, line): (usize, &str)| {
        let chars: Vec<char> = line.chars().collect();
        let start = if number + 1 == from.line { from.column } else { 0 };
        let end = if number + 1 == to.line { to.column } else { chars.len() };
        let inside = (from.line..=to.line).contains(&(number + 1));
        inside.then(|| chars[start..end].iter().collect::<String>().trim().to_owned())
    };
    text.lines().enumerate().filter_map(line).collect::<Vec<_>>().join(" ")
}

/// The literal that is all of `tokens`.
fn literal(tokens: TokenStream) -> Option<String> {
    syn::parse2::<syn::LitStr>(tokens).ok().map(|text| text.value())
}

/// The message in `#[deprecated(note = "…")]` of the module that makes a warning.
fn note(tokens: TokenStream) -> Option<String> {
    let mut is_note = false;
    tokens.into_iter().find_map(|tree| match tree {
        TokenTree::Group(group) => note(group.stream()),
        TokenTree::Literal(text) if is_note => literal(TokenTree::from(text).into()),
        other => {
            is_note = matches!(&other, TokenTree::Ident(name) if name == "note") || is_note && other.to_string() == "=";
            None
        }
    })
}

/// The rule at the end of a message's first line; a table may stand below.
fn rule(message: &str) -> String {
    let named = message.rsplit_once("[grafcet::").and_then(|(_, rest)| rest.split_once(']'));
    named.map_or("notation", |(name, _)| name).to_owned()
}

/// The rules and marked texts in what the compiler makes of `text`.
fn said(text: &str, tokens: TokenStream, marks: &mut Marks) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    for (at, tree) in trees.iter().enumerate() {
        match tree {
            // `by_edition! { async [::core::] compile_error! { "…" } }`
            TokenTree::Ident(name) if name == "compile_error" => {
                let message = match &trees[at + 2] {
                    TokenTree::Group(group) => literal(group.stream()).expect("a message"),
                    other => panic!("{other} after `compile_error!`"),
                };
                let (from, to) = (trees[at].span().start(), trees[at + 2].span().end());
                marks.push((rule(&message), between(text, from, to)));
            }
            TokenTree::Group(group) => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                match &inner[..] {
                    [TokenTree::Ident(word), TokenTree::Ident(name), TokenTree::Group(module), path @ ..]
                        if word == "mod" && name == "grafcet" =>
                    {
                        let message = note(module.stream()).expect("the message of a warning");
                        let (first, last) = (path.first().expect("a path"), path.last().expect("a path"));
                        marks.push((rule(&message), between(text, first.span().start(), last.span().end())));
                    }
                    _ => said(text, group.stream(), marks),
                }
            }
            _ => {}
        }
    }
}

/// What is said about a chart, as the lists write it.
fn verdict(chart: &str) -> String {
    let tokens = chart.parse().expect("tokens");
    let mut marks = Marks::new();
    said(chart, grafcet_compiler::compile(&"::grafcet".parse().expect("a path"), tokens), &mut marks);
    let mut rules: Vec<(String, Vec<String>)> = Vec::new();
    for (rule, mark) in marks.into_iter().filter(|(rule, _)| !OF_EVOLUTION.contains(&rule.as_str())) {
        match rules.iter_mut().find(|(other, _)| *other == rule) {
            Some((_, all)) => all.push(mark),
            None => rules.push((rule, vec![mark])),
        }
    }
    let rules: Vec<String> = rules.iter().map(|(rule, marks)| format!("{rule} @ {}", marks.join(" ¦ "))).collect();
    if rules.is_empty() { "none".to_owned() } else { rules.join(" ; ") }
}

/// Compares each fault of a list with its verdict, and shows all differences at once.
fn judge(list: &str, least: usize) {
    let (mut differences, mut count) = (String::new(), 0);
    for entry in read(list).split("\n# ").map(|entry| entry.trim_start_matches("# ")) {
        let (title, rest) = entry.split_once('\n').expect("a title");
        let (expected, body) = rest.split_once('\n').expect("a verdict");
        let expected = expected.strip_prefix("= ").expect("a verdict");
        let chart = match title.split_once(" : ") {
            Some((_, base)) => broken(base, body),
            None => body.to_owned(),
        };
        let verdict = verdict(&chart);
        if verdict != expected {
            _ = writeln!(differences, "{title}\n  expected {expected}\n  found    {verdict}");
        }
        count += 1;
    }
    assert!(differences.is_empty(), "{list}\n{differences}");
    assert!(count >= least, "{list} holds only {count} faults");
}

/// The chart `base` with its replacements.
fn broken(base: &str, replacements: &str) -> String {
    let mut chart = read(&format!("good/{base}.chart"));
    let mut lines = replacements.lines().filter(|line| !line.is_empty());
    while let (Some(old), Some(new)) = (lines.next(), lines.next()) {
        let old = old.strip_prefix("- ").expect("what is replaced").replace("\\n", "\n");
        let new = new.strip_prefix('+').expect("by what").trim_start().replace("\\n", "\n");
        assert_eq!(chart.matches(&old).count(), 1, "{base}: `{old}`");
        chart = chart.replace(&old, &new);
    }
    chart
}

#[test]
fn nothing_is_said_about_the_charts_as_they_are() {
    for file in fs::read_dir(folder().join("good")).expect("a folder of charts") {
        let path = file.expect("a file").path();
        let chart = fs::read_to_string(&path).expect("a chart");
        let tokens = chart.parse().expect("tokens");
        let mut marks = Marks::new();
        said(&chart, grafcet_compiler::compile(&"::grafcet".parse().expect("a path"), tokens), &mut marks);
        assert_eq!(marks, [], "{}", path.display());
    }
}

#[test]
fn drawing() {
    judge("drawing.txt", 50);
}

#[test]
fn conditions() {
    judge("conditions.txt", 40);
}

#[test]
fn actions() {
    judge("actions.txt", 60);
}

#[test]
fn structure() {
    judge("structure.txt", 20);
}

#[test]
fn charts_of_their_own() {
    judge("alone.txt", 30);
}

#[test]
fn what_is_half_written_or_nonsense() {
    judge("malformed.txt", 30);
}
