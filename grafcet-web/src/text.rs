//! What somebody has typed: where the chart is in it, and places in it as a page counts them.

use std::ops::Range;

use grafcet_compiler::diagnostic::{Mark, Sink};
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::{parse, plant};
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

/// Why a text is no sequence of tokens, and where.
#[derive(Debug)]
pub(crate) struct Unread {
    pub(crate) at: Range<usize>,
    pub(crate) why: &'static str,
}

/// Where brackets are nested so deeply that whoever walks through the tokens has no stack left, in bytes. The compiler bounds what a chart nests, far below
/// this; but it looks at tokens. Brackets in texts and comments count, too.
fn too_deep(text: &str) -> Option<usize> {
    const MOST: usize = 1000;
    let mut depth: usize = 0;
    text.bytes().position(|byte| {
        match byte {
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth > MOST
    })
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
    /// It is no sequence of Rust's tokens.
    pub(crate) fn find(text: &str) -> Result<Self, Unread> {
        let places = Places::of(text);
        if let Some(at) = too_deep(text) {
            let at = places.bytes(at..at + 1).unwrap_or(0..0);
            return Err(Unread { at, why: "brackets are nested too deeply from here on" });
        }
        let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| Unread {
            at: places.mark(error.span().into()).unwrap_or(0..0),
            why: "this is not Rust: it cannot be read beyond this point",
        })?;
        let called = calls(&tokens).into_iter().next();
        let (call, tokens) = called.unwrap_or_else(|| (Span::call_site(), tokens));
        Ok(Self { name: chart_name(&tokens).unwrap_or_default(), tokens, call })
    }

    /// The model, where the chart is whole enough to be drawn: rules that it breaks leave the drawing as it is.
    pub(crate) fn drawn(&self) -> Option<Model> {
        let (model, whole) = self.model()?;
        whole.then_some(model)
    }

    /// The model together with its plants, what a proof is about.
    pub(crate) fn with_plants(&self) -> Option<Model> {
        let mut sink = Sink::new();
        let model = plant::model(self.tokens.clone(), &mut sink);
        let said = sink.finish();
        model.filter(|model| !model.incomplete && said.iter().all(|one| one.rule.is_some()))
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
    fn what_is_nested_without_end_is_refused_at_its_place() {
        let nested = |depth: usize| format!("sfc A {{ {}x{} }}", "(".repeat(depth), ")".repeat(depth));
        assert!(Written::find(&nested(999)).is_ok());
        // The brace is one of them, so that the thousandth parenthesis is one too many.
        assert_eq!(Written::find(&nested(100_000)).err().map(|unread| unread.at), Some(1007..1008));
        assert_eq!(Written::find("sfc A { ) }").err().map(|unread| unread.at), Some(8..8));
    }

    #[test]
    fn the_chart_of_a_pasted_file_is_found() {
        let text = "use grafcet::grafcet; grafcet! { sfc First { } } grafcet! { sfc Second { } }";
        assert_eq!(Written::find(text).expect("tokens").name, "First");
        assert_eq!(Written::find("pub grafcet Alone { }").expect("tokens").name, "Alone");
    }
}
