//! What somebody has typed: where the chart is in it, and places in it as a page counts them.

use std::ops::Range;

use grafcet_compiler::diagnostic::{Mark, Sink};
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_sim::{calls, chart_name};
use proc_macro2::{Span, TokenStream};

/// Places of a text as JavaScript counts them, in units of UTF-16.
pub(crate) struct Places<'t> {
    text: &'t str,
}

impl<'t> Places<'t> {
    pub(crate) fn of(text: &'t str) -> Self {
        Self { text }
    }

    /// From the first to the last character of a mark; none where it stands nowhere in the text.
    pub(crate) fn mark(&self, mark: Mark) -> Option<Range<usize>> {
        self.bytes(mark.start.byte_range().start..mark.end.byte_range().end)
    }

    fn bytes(&self, range: Range<usize>) -> Option<Range<usize>> {
        let units = |end: usize| Some(self.text.get(..end)?.encode_utf16().count());
        let found = units(range.start)?..units(range.end)?;
        (range.end > 0 && range.start <= range.end).then_some(found)
    }
}

/// A chart that was found in a text.
pub(crate) struct Written {
    pub(crate) name: String,
    /// What stands between the braces of the macro.
    pub(crate) tokens: TokenStream,
    /// Where what stands nowhere is shown.
    pub(crate) call: Span,
}

impl Written {
    /// The chart that the text is, or the first call of `grafcet!` in it: people paste what they have.
    ///
    /// # Errors
    /// Where it ends to be a sequence of Rust's tokens.
    pub(crate) fn find(text: &str) -> Result<Self, Span> {
        let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| error.span())?;
        let called = calls(&tokens).into_iter().next();
        let (call, tokens) = called.unwrap_or_else(|| (Span::call_site(), tokens));
        Ok(Self { name: chart_name(&tokens).unwrap_or_default(), tokens, call })
    }

    /// The model, where the chart is whole enough to be drawn: rules that it breaks leave the drawing as it is.
    pub(crate) fn drawn(&self) -> Option<Model> {
        let (model, whole) = self.model()?;
        whole.then_some(model)
    }

    /// The model, and whether nothing of the source is missing in it.
    pub(crate) fn model(&self) -> Option<(Model, bool)> {
        let mut sink = Sink::new();
        let chart = parse::chart(self.tokens.clone(), &mut sink);
        let resolved = chart.map(|chart| {
            let model = model::resolve(&chart, &mut sink);
            let whole = !chart.incomplete && !model.incomplete;
            (model, whole)
        });
        let said = sink.finish();
        resolved.map(|(model, whole)| (model, whole && said.iter().all(|one| one.rule.is_some())))
    }
}

#[cfg(test)]
mod tests {
    use super::{Places, Written};

    #[test]
    fn places_are_counted_as_javascript_does() {
        // Two bytes and one unit; four bytes and two units.
        let text = "/* é𝄞 */ sfc M";
        let written = Written::find(text).expect("tokens");
        let name = written.tokens.into_iter().nth(1).expect("a name");
        assert_eq!(Places::of(text).mark(name.span().into()), Some(14..15));
    }

    #[test]
    fn the_chart_of_a_pasted_file_is_found() {
        let text = "use grafcet::grafcet; grafcet! { sfc First { } } grafcet! { sfc Second { } }";
        assert_eq!(Written::find(text).expect("tokens").name, "First");
        assert_eq!(Written::find("pub grafcet Alone { }").expect("tokens").name, "Alone");
    }
}
