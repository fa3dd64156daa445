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

/// The charts of a Rust file, in its order.
///
/// # Errors
/// It is no Rust.
pub fn of_rust(file: &str) -> Result<Vec<Shown>, String> {
    let tokens: TokenStream = file.parse().map_err(|error: proc_macro2::LexError| error.to_string())?;
    let found = calls(&tokens).into_iter().filter_map(|(_, inner)| {
        let name = chart_name(&inner)?;
        let text = between(file, &range(inner)?);
        Some(Shown { name, text })
    });
    Ok(found.collect())
}

/// The charts in the Rust blocks of a page in Markdown, each with the heading above it.
///
/// # Errors
/// A block is no Rust.
pub fn of_markdown(page: &str) -> Result<Vec<(String, Shown)>, String> {
    let mut found = Vec::new();
    let mut heading = "";
    let mut block: Option<String> = None;
    for line in page.lines() {
        match (&mut block, line) {
            (None, line) if line.starts_with("```rust") => block = Some(String::new()),
            (None, line) => heading = line.strip_prefix("## ").unwrap_or(heading),
            (Some(text), "```") => {
                found.extend(of_rust(text)?.into_iter().map(|shown| (heading.to_owned(), shown)));
                block = None;
            }
            // What rustdoc hides is Rust all the same.
            (Some(text), line) => {
                let line = if line == "#" { "" } else { line.strip_prefix("# ").unwrap_or(line) };
                text.push_str(line);
                text.push('\n');
            }
        }
    }
    Ok(found)
}

/// From the first to the last token.
fn range(tokens: TokenStream) -> Option<Range<usize>> {
    let mut tokens = tokens.into_iter();
    let first = tokens.next()?;
    let start = first.span().byte_range().start;
    Some(start..tokens.last().unwrap_or(first).span().byte_range().end)
}

/// Whole lines, with the blanks taken away that all of them begin with. A comment in front of the first token or behind the last one belongs to them.
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
    use super::{Shown, of_markdown, of_rust};

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
}
