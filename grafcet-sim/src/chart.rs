//! A chart from its source.

use std::fmt;

use grafcet_compiler::describe::with_description;
use grafcet_compiler::diagnostic::{Severity, Sink};
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::{check, parse};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::names::Names;

/// A chart that can be run.
pub struct Chart {
    model: Model,
    names: Names,
    source: Option<TokenStream>,
}

/// Why a source is no chart that can be run.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Refused {
    /// The text is no sequence of Rust tokens.
    Tokens(String),
    /// There is no `grafcet! { … }` with a chart of that name in the file.
    Missing(String),
    /// The compiler refuses the chart: its messages, each with the line where it stands, counted from one.
    Chart(Vec<(usize, String)>),
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Tokens(error) => write!(f, "no Rust tokens: {error}"),
            Self::Missing(name) => write!(f, "no chart `{name}` in a call of `grafcet!`"),
            Self::Chart(messages) => {
                let lines: Vec<String> = messages.iter().map(|(line, text)| format!("line {line}: {text}")).collect();
                f.write_str(&lines.join("\n"))
            }
        }
    }
}

impl std::error::Error for Refused {}

impl Chart {
    /// From what stands between the braces of `grafcet! { … }`.
    ///
    /// # Errors
    /// The text is no chart, or one that its names or its drawing make impossible. What the compiler proves about charts is not proved
    /// again: what runs has been compiled.
    pub fn parse(source: &str) -> Result<Self, Refused> {
        Self::of_tokens(tokens(source)?)
    }

    /// From a Rust file with a call of `grafcet!` in it: the chart of that name, whose lines are those of the file.
    ///
    /// # Errors
    /// As of [`Chart::parse`]; or there is no such chart.
    pub fn in_file(file: &str, name: &str) -> Result<Self, Refused> {
        let found = find(tokens(file)?, name).ok_or_else(|| Refused::Missing(name.to_owned()))?;
        Self::of_tokens(found)
    }

    /// From the tokens between the braces.
    ///
    /// # Errors
    /// As of [`Chart::parse`].
    pub fn of_tokens(tokens: TokenStream) -> Result<Self, Refused> {
        let mut sink = Sink::new();
        let source = tokens.clone();
        let model = parse::chart(tokens, &mut sink).map(|chart| {
            let model = model::resolve(&chart, &mut sink);
            check::drawing(&model, &mut sink);
            model
        });
        let wrong = sink.has_errors();
        let messages = sink.finish();
        match model {
            Some(model) if !wrong => Ok(Self { source: Some(source), ..Self::of_model(model) }),
            _ => {
                let errors = messages.iter().filter(|one| one.severity == Severity::Deny);
                let errors = errors.filter_map(|one| one.notes.first());
                Err(Refused::Chart(errors.map(|(mark, text)| (mark.start.start().line, text.clone())).collect()))
            }
        }
    }

    /// From the compiler's model.
    #[must_use]
    pub fn of_model(model: Model) -> Self {
        Self { names: Names::of(&model), model, source: None }
    }

    /// The compiler's model.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Tells charts apart, as the fingerprint that a recorder writes; none for a chart that was made of a model.
    #[must_use]
    pub fn fingerprint(&self) -> Option<u32> {
        self.source.as_ref().map(grafcet_compiler::fingerprint::of)
    }

    /// The tokens it was made of.
    pub(crate) fn source(&self) -> Option<&TokenStream> {
        self.source.as_ref()
    }

    /// What everything in it is called.
    #[must_use]
    pub fn names(&self) -> &Names {
        &self.names
    }

    /// The chart as a picture in characters, with these steps marked.
    #[must_use]
    pub fn text(&self, active: &[usize]) -> String {
        with_description(&self.model, |chart| grafcet_draw::text(chart, &Marked(active)))
    }

    /// The chart as a picture, with these steps marked.
    #[must_use]
    pub fn svg(&self, active: &[usize]) -> String {
        with_description(&self.model, |chart| grafcet_draw::svg(chart, &Marked(active)))
    }
}

/// Steps by their places in [`Names::steps`].
pub(crate) struct Marked<'a>(pub(crate) &'a [usize]);

impl grafcet_core::ActiveSteps for Marked<'_> {
    fn is_active_at(&self, step: usize) -> bool {
        self.0.contains(&step)
    }
}

fn tokens(text: &str) -> Result<TokenStream, Refused> {
    text.parse().map_err(|error: proc_macro2::LexError| Refused::Tokens(error.to_string()))
}

/// What stands between the braces of the call of `grafcet!` with the chart of that name.
fn find(tokens: TokenStream, name: &str) -> Option<TokenStream> {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, tree) in trees.iter().enumerate() {
        let TokenTree::Group(group) = tree else { continue };
        let called = index >= 2
            && matches!(&trees[index - 1], TokenTree::Punct(punct) if punct.as_char() == '!')
            && matches!(&trees[index - 2], TokenTree::Ident(ident) if ident == "grafcet");
        if called && group.delimiter() == Delimiter::Brace && is_named(group.stream(), name) {
            return Some(group.stream());
        }
        if let Some(found) = find(group.stream(), name) {
            return Some(found);
        }
    }
    None
}

/// `pub sfc Motor { … }`: the name stands after the first `sfc` or `grafcet`.
fn is_named(tokens: TokenStream, name: &str) -> bool {
    let keyword = |tree: &TokenTree| matches!(tree, TokenTree::Ident(ident) if ident == "sfc" || ident == "grafcet");
    let mut after = tokens.into_iter().skip_while(|tree| !keyword(tree)).skip(1);
    matches!(after.next(), Some(TokenTree::Ident(ident)) if ident == name)
}
