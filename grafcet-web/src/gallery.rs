//! Charts to open in the page, out of the files of the repository.

use std::ops::Range;

use proc_macro2::TokenStream;

use grafcet_sim::{calls, chart_name};

/// A chart of a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Shown {
    /// `Motor`
    pub name: String,
    /// What stands between the braces of the macro, moved to the left edge.
    pub text: String,
}

/// A block of Rust in a page.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Block {
    /// The heading of the second level above it.
    pub heading: String,
    /// As it stands in the page, with the lines that rustdoc hides.
    pub text: String,
    /// It is there to be refused.
    pub fails: bool,
    /// In their order.
    pub charts: Vec<Shown>,
    /// The places among `charts` of those that a reader of the page sees.
    pub seen: Vec<usize>,
}

/// The charts of a Rust file, in its order.
///
/// # Errors
/// It is no Rust.
pub fn of_rust(file: &str) -> Result<Vec<Shown>, String> {
    Ok(placed(file)?.into_iter().map(|(_, shown)| shown).collect())
}

/// The charts in the Rust blocks of a page in Markdown, each with the heading above it.
///
/// # Errors
/// A block is no Rust.
pub fn of_markdown(page: &str) -> Result<Vec<(String, Shown)>, String> {
    let pairs = |block: Block| block.charts.into_iter().map(move |shown| (block.heading.clone(), shown));
    Ok(blocks(page)?.into_iter().flat_map(pairs).collect())
}

/// The Rust blocks of a page in Markdown, in its order.
///
/// # Errors
/// A block is no Rust.
pub fn blocks(page: &str) -> Result<Vec<Block>, String> {
    let mut found = Vec::new();
    let mut heading = "";
    let mut inside: Option<(bool, Vec<&str>)> = None;
    for line in page.lines() {
        match (&mut inside, line) {
            (None, line) if line.starts_with("```rust") => inside = Some((line.contains("compile_fail"), Vec::new())),
            (None, line) => heading = line.strip_prefix("## ").unwrap_or(heading),
            (Some((fails, lines)), "```") => {
                found.push(block(heading, *fails, lines)?);
                inside = None;
            }
            (Some((_, lines)), line) => lines.push(line),
        }
    }
    Ok(found)
}

fn block(heading: &str, fails: bool, lines: &[&str]) -> Result<Block, String> {
    let is_hidden = |line: &str| line == "#" || line.starts_with("# ");
    // What rustdoc hides is Rust all the same.
    let rust =
        |line: &'_ &str| line.strip_prefix("# ").unwrap_or(if *line == "#" { "" } else { line }).to_owned() + "\n";
    let rust: String = lines.iter().map(rust).collect();
    let charts = placed(&rust)?;
    let is_seen = |at: usize| !is_hidden(lines[rust[..at].matches('\n').count()]);
    let seen = (0..charts.len()).filter(|place| is_seen(charts[*place].0)).collect();
    let charts = charts.into_iter().map(|(_, shown)| shown).collect();
    Ok(Block { heading: heading.to_owned(), text: lines.join("\n"), fails, charts, seen })
}

/// The charts of a Rust file, each with the place of its first token.
fn placed(file: &str) -> Result<Vec<(usize, Shown)>, String> {
    let tokens: TokenStream = file.parse().map_err(|error: proc_macro2::LexError| error.to_string())?;
    let found = calls(&tokens).into_iter().filter_map(|(_, inner)| {
        let name = chart_name(&inner)?;
        let range = range(inner)?;
        let text = between(file, &range);
        Some((range.start, Shown { name, text }))
    });
    Ok(found.collect())
}

/// From the first to the last token.
fn range(tokens: TokenStream) -> Option<Range<usize>> {
    let mut tokens = tokens.into_iter();
    let first = tokens.next()?;
    let start = first.span().byte_range().start;
    Some(start..tokens.last().unwrap_or(first).span().byte_range().end)
}

/// Whole lines, with the blanks taken away that all of them begin with. A comment in front of the first token or after the last one belongs to them.
fn between(file: &str, tokens: &Range<usize>) -> String {
    let start = file[..tokens.start].rfind('{').map_or(0, |brace| brace + 1);
    let end = file[tokens.end..].find('}').map_or(file.len(), |brace| tokens.end + brace);
    let text = file[start..end].trim_matches('\n').trim_end();
    let blanks = |line: &str| line.len() - line.trim_start_matches(' ').len();
    let common = text.lines().filter(|line| !line.trim().is_empty()).map(blanks).min().unwrap_or(0);
    let lines: Vec<&str> = text.lines().map(|line| line.get(common..).unwrap_or("")).collect();
    format!("{}\n", lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::{Shown, blocks, of_markdown, of_rust};

    #[test]
    fn a_chart_is_moved_to_the_left_edge() {
        let file = "mod inner {\n    grafcet! {\n        // Why.\n        /// A motor.\n        pub sfc Motor {\n            initial step Off;\n\n        }\n    }\n}\n";
        let text = "// Why.\n/// A motor.\npub sfc Motor {\n    initial step Off;\n\n}\n".to_owned();
        assert_eq!(of_rust(file), Ok(vec![Shown { name: "Motor".to_owned(), text }]));
    }

    #[test]
    fn a_chart_of_a_page_has_its_heading() {
        let page = "# Page\n## Debounce\n```rust\n# use grafcet::grafcet;\ngrafcet! { sfc A { } }\n#\n```\n```text\ngrafcet! { sfc No { } }\n```\n## Next\n```rust\nfn f() {}\n```\n";
        let found = of_markdown(page).expect("Rust");
        assert_eq!(
            found.iter().map(|(heading, shown)| (heading.as_str(), shown.text.trim())).collect::<Vec<_>>(),
            [("Debounce", "sfc A { }")]
        );
    }

    #[test]
    fn a_page_shows_some_of_its_charts() {
        let page = "```rust\n# grafcet! { sfc Hidden { } }\n# fn main() {\n#[derive(Debug)]\nstruct A;\ngrafcet! {\n    #[derive(Hash)]\n    sfc Seen { }\n}\n#\n# }\n```\n";
        let found = blocks(page).expect("Rust");
        let [block] = &found[..] else { panic!("{found:?}") };
        assert_eq!(block.charts.iter().map(|shown| &*shown.name).collect::<Vec<_>>(), ["Hidden", "Seen"]);
        assert_eq!((&block.seen[..], &*block.charts[1].text), (&[1][..], "#[derive(Hash)]\nsfc Seen { }\n"));
        assert!(block.text.starts_with("# grafcet!") && block.text.ends_with("\n# }"), "as it stands in the page");
    }
}
