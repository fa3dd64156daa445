//! Fragments of `macro_rules!` in the text of a chart: `frag_e!(a || b)` stands for an `$e:expr` that was given `a || b`.
//!
//! Compiled, it is one: the chart stands in a macro that is called with what stands in parentheses. What it means is what a
//! reader takes it for: an expression is a whole, whatever stands around it; of the others nothing is left to say.

use std::fmt::Write as _;

/// The letter after `frag_`, and what `macro_rules!` calls it.
const KINDS: [(char, &str); 4] = [('e', "expr"), ('t', "ty"), ('l', "literal"), ('b', "block")];

/// Where one stands in a text.
struct Found {
    kind: (char, &'static str),
    start: usize,
    /// What stands in the parentheses.
    inside: std::ops::Range<usize>,
}

fn find(text: &str) -> Option<Found> {
    let marks = KINDS.iter().filter_map(|kind| Some((text.find(&format!("frag_{}!(", kind.0))?, *kind)));
    let (start, kind) = marks.min()?;
    let open = start + "frag_e!(".len();
    let mut depth = 1;
    let end = text[open..].char_indices().find_map(|(index, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        (depth == 0).then_some(open + index)
    })?;
    Some(Found { kind, start, inside: open..end })
}

/// The chart as it is meant: expressions in parentheses, everything else as it stands.
#[must_use]
pub fn plain(text: &str) -> String {
    let mut text = text.to_owned();
    while let Some(Found { kind, start, inside }) = find(&text) {
        let end = inside.end + 1;
        let inside = if kind.0 == 'e' { format!("({})", &text[inside]) } else { text[inside].to_owned() };
        text.replace_range(start..end, &inside);
    }
    text
}

/// The chart with the named conditions of single lines written out, as whoever has no `let` would write it.
#[must_use]
pub fn written_out(text: &str) -> String {
    let (mut named, mut done) = (Vec::<(&str, String)>::new(), String::new());
    for line in text.lines() {
        let whole = |line| named.iter().fold(line, |line: String, (name, of)| replaced(&line, name, of));
        let one = line.trim().strip_prefix("let ").and_then(|rest| rest.strip_suffix(';')?.split_once(" = "));
        match one {
            Some((name, of)) => {
                let of = format!("({})", whole(of.to_owned()));
                named.push((name, of));
            }
            None => _ = writeln!(done, "{}", whole(line.to_owned())),
        }
    }
    done
}

/// The line with a name replaced, where it is a word of its own.
fn replaced(line: &str, name: &str, by: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let (mut done, mut rest) = (String::new(), line);
    while let Some(start) = rest.find(name) {
        let end = start + name.len();
        let apart = !rest[..start].ends_with(is_word) && !rest[end..].starts_with(is_word);
        let alone = apart && !(rest[..start].is_empty() && done.ends_with(is_word));
        _ = write!(done, "{}{}", &rest[..start], if alone { by } else { name });
        rest = &rest[end..];
    }
    done + rest
}

/// The call of the macro `by` that makes the chart; where it has fragments, macros that call each other: one for each depth of nesting.
#[must_use]
pub fn call(text: &str, by: &str) -> String {
    let (mut body, mut arguments) = outermost(&format!("{by}! {{\n{text}\n}}"));
    let mut macros = String::new();
    let mut level = 0;
    while !arguments.is_empty() {
        let matcher = arguments.iter().enumerate().map(|(index, (kind, _))| format!("$f{index}:{kind}, "));
        let matcher: String = matcher.collect();
        _ = writeln!(macros, "macro_rules! level{level} {{ ({matcher}) => {{\n{body}\n}} }}");
        let given: String = arguments.iter().map(|(_, argument)| format!("{argument}, ")).collect();
        (body, arguments) = outermost(&format!("level{level}! {{ {given} }}"));
        level += 1;
    }
    macros + &body
}

/// The text with its outermost fragments replaced by `$f0`, `$f1` …, and these: what they are, and their text.
fn outermost(text: &str) -> (String, Vec<(&'static str, String)>) {
    let (mut done, mut rest, mut arguments) = (String::new(), text, Vec::new());
    while let Some(Found { kind, start, inside }) = find(rest) {
        _ = write!(done, "{}$f{}", &rest[..start], arguments.len());
        arguments.push((kind.1, rest[inside.clone()].to_owned()));
        rest = &rest[inside.end + 1..];
    }
    (done + rest, arguments)
}

#[cfg(test)]
mod tests {
    use super::{call, plain, written_out};

    const CHART: &str = "A -[!frag_e!(a || frag_e!(b && c))]-> B; input a: frag_t!(bool);";

    #[test]
    fn what_is_meant() {
        assert_eq!(plain(CHART), "A -[!(a || (b && c))]-> B; input a: bool;");
    }

    #[test]
    fn names_are_written_out() {
        let text = "let go = a || b;\nlet on = rising(go);\ninput gone: bool;\nA -[go && !on]-> B; ago";
        let whole = "input gone: bool;\nA -[(a || b) && !(rising((a || b)))]-> B; ago\n";
        assert_eq!(written_out(text), whole);
    }

    #[test]
    fn macros_that_call_each_other() {
        let text = call(CHART, "grafcet::grafcet").replace('\n', "");
        let inner =
            "macro_rules! level0 { ($f0:expr, $f1:ty, ) => {grafcet::grafcet! {A -[!$f0]-> B; input a: $f1;}} }";
        let outer = "macro_rules! level1 { ($f0:expr, ) => {level0! { a || $f0, bool,  }} }level1! { b && c,  }";
        assert_eq!(text, format!("{inner}{outer}"));
        assert_eq!(call("sfc C {}", "grafcet::grafcet"), "grafcet::grafcet! {\nsfc C {}\n}");
    }
}
