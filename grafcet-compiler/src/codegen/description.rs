//! `Motor::CHART`, and the drawing in the documentation of `Motor`.

use grafcet_core::description::{Action, Description, Dialect, MacroStep, Step, Transition, table};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::format_ident;

use super::Cx;
use crate::describe::with_description;
use crate::list::List;
use crate::place::quote;
use crate::sorted::sort_unstable;

/// What is said of the chart as a whole.
pub(super) struct Said {
    /// The attribute of the chart's type with the drawing.
    pub(super) drawing: TokenStream,
    /// The constant `CHART` of the chart, and the numbers of the active steps.
    pub(super) items: TokenStream,
}

/// Both are made of one description, as making it takes as long as drawing it.
pub(super) fn all(cx: &Cx<'_>) -> Said {
    with_description(cx.model, |description| Said { drawing: drawing(description), items: items(cx, description) })
}

/// The chart as it is drawn, in the documentation alone: editors that show the source's comments show no picture.
fn drawing(chart: &Description<'_>) -> TokenStream {
    let (svg, large) = (grafcet_draw::svg_inline(chart), grafcet_draw::is_large(chart));
    let what = if large { "An overview of the chart, which is too large to be drawn here:\n\n" } else { "" };
    // Markdown passes on what stands between the tags of a block, up to the first blank line.
    let doc = format!("\n\n{what}<div style=\"overflow-x:auto\">{svg}</div>\n");
    quote!(#[cfg_attr(doc, doc = #doc)])
}

/// The constants of an `impl` are computed where they are used, and two flat tables are quickly checked: otherwise the description of a long chart would
/// take half the time of a check.
fn items(cx: &Cx<'_>, description: &Description<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (vis, chart, step) = (&model.vis, &names.chart, &names.step);
    let Tables { texts, numbers, described } = tables(description, chart);
    let situation = if cx.plan.one_step { step } else { &names.situation };
    let active = if cx.plan.one_step { quote!(active_ == *self) } else { quote!(self.is_active(active_)) };
    quote! {
        impl #chart {
            /// What the chart looks like: its steps, transitions and actions as they stand in the source.
            #vis const CHART: #p::description::Description<'static> = #p::description::table::#described;
        }

        impl #p::description::table::Tables for #chart {
            const TEXTS: &'static [&'static #p::str] = &[#texts];
            const NUMBERS: &'static [#p::u8] = #numbers;
        }

        impl #p::ActiveSteps for #situation {
            fn is_active_at(&self, step_: #p::usize) -> #p::bool {
                match #p::step_at::<#chart>(step_) {
                    #p::Option::Some(active_) => #active,
                    #p::Option::None => false,
                }
            }
        }
    }
}

/// What `grafcet_core::description::table` makes a description of.
struct Tables {
    texts: TokenStream,
    numbers: Literal,
    /// The function that reads them.
    described: TokenStream,
}

/// In the order in which they are read.
fn tables(chart: &Description<'_>, ty: &Ident) -> Tables {
    let Description { name, dialect, partials, macros, steps, transitions, lets } = chart;
    let actions: Vec<&Action<'_>> = steps.iter().flat(|step| step.actions).list();
    let words = steps.iter().flat(|step| step.forces).and(transitions.iter().flat(words)).list();
    let ends = transitions.iter().flat(ends).list();
    let mut stream = Stream::default();
    for action in &actions {
        stream.texts(&[action.qualifier, action.time, action.condition, action.text]);
    }
    for word in &words {
        stream.texts(&[word]);
    }
    for end in &ends {
        stream.numbers(&[**end]);
    }
    stream.texts(&[name]);
    for partial in *partials {
        stream.texts(&[partial.name]);
        stream.numbers(&[or_none(partial.enclosed_by)]);
        stream.texts(&[partial.doc]);
    }
    for MacroStep { name, outer, entry, exit, doc } in *macros {
        stream.texts(&[name]);
        stream.numbers(&[or_none(*outer), *entry, *exit]);
        stream.texts(&[doc]);
    }
    for one in *steps {
        step(&mut stream, one);
    }
    for one in *transitions {
        transition(&mut stream, one);
    }
    for named in *lets {
        stream.texts(&[named.name, named.text, named.doc]);
    }
    let counts = [
        actions.len(),
        words.len(),
        ends.len(),
        partials.len(),
        macros.len(),
        steps.len(),
        transitions.len(),
        lets.len(),
    ];
    let dialect = match dialect {
        Dialect::Sfc => "sfc",
        Dialect::Grafcet => "grafcet",
    };
    let (dialect, counts) = (format_ident!("{dialect}"), counts.iter().map(|count| Literal::usize_unsuffixed(*count)));
    let (texts, numbers) = stream.tables();
    Tables {
        texts: quote!(#(#texts),*),
        numbers: Literal::byte_string(&numbers),
        described: quote!(Described::<#ty, #(#counts),*>::#dialect()),
    }
}

/// The texts of which a transition has lists.
fn words<'t>(transition: &Transition<'t>) -> impl Iterator<Item = &'t &'t str> {
    transition.clearing.iter().and(transition.any.iter().flat(|any| any.except))
}

/// The steps of which it has lists.
fn ends<'t>(transition: &Transition<'t>) -> impl Iterator<Item = &'t usize> {
    transition.sources.iter().and(transition.targets).and(transition.any.iter().flat(|any| any.steps))
}

fn step<'t>(stream: &mut Stream<'t>, step: &Step<'t>) {
    let flags = if step.initial { table::INITIAL } else { 0 } | if step.linked { table::LINKED } else { 0 };
    stream.texts(&[step.name]);
    stream.numbers(&[usize::from(flags), step.partial, or_none(step.expansion), step.actions.len()]);
    stream.texts(&[step.within]);
    stream.numbers(&[step.forces.len()]);
}

fn transition<'t>(stream: &mut Stream<'t>, transition: &Transition<'t>) {
    let Transition { name, sources, any, targets, condition, clearing } = transition;
    stream.texts(&[name, condition]);
    stream.numbers(&[sources.len(), targets.len(), clearing.len()]);
    match any {
        None => stream.numbers(&[0]),
        Some(any) => stream.numbers(&[1, any.steps.len(), any.except.len()]),
    }
}

/// One more than a number that is there.
fn or_none(number: Option<usize>) -> usize {
    number.map_or(0, |number| number + 1)
}

/// What is written one after the other, before the texts have numbers.
#[derive(Default)]
struct Stream<'t>(Vec<Entry<'t>>);

enum Entry<'t> {
    Text(&'t str),
    Number(usize),
}

impl<'t> Stream<'t> {
    fn texts(&mut self, texts: &[&'t str]) {
        for text in texts {
            self.0.push(Entry::Text(text));
        }
    }

    fn numbers(&mut self, numbers: &[usize]) {
        for number in numbers {
            self.0.push(Entry::Number(*number));
        }
    }

    /// Each text once, in order, and all numbers as bytes.
    fn tables(&self) -> (Vec<&'t str>, Vec<u8>) {
        let mut texts = Vec::new();
        for entry in &self.0 {
            if let Entry::Text(text) = entry {
                texts.push(*text);
            }
        }
        sort_unstable(&mut texts);
        texts.dedup();
        let mut bytes = Vec::new();
        for entry in &self.0 {
            match entry {
                Entry::Text(text) => put(&mut bytes, texts.partition_point(|other| other < text)),
                Entry::Number(number) => put(&mut bytes, *number),
            }
        }
        (texts, bytes)
    }
}

/// Seven bits a byte, the lowest first; all but the last one have the eighth bit set.
fn put(bytes: &mut Vec<u8>, number: usize) {
    let [low, ..] = number.to_le_bytes();
    if number < 0x80 {
        bytes.push(low);
    } else {
        bytes.push(low | 0x80);
        put(bytes, number >> 7);
    }
}

#[cfg(test)]
mod tests {
    use super::{Stream, or_none};

    #[test]
    fn each_text_is_there_once_and_a_number_takes_as_many_bytes_as_it_needs() {
        let mut stream = Stream::default();
        stream.texts(&["b", "", "a", "b"]);
        stream.numbers(&[0, 127, 128, 16383, 16384, or_none(Some(0)), or_none(None)]);
        let (texts, bytes) = stream.tables();
        assert_eq!(texts, ["", "a", "b"]);
        assert_eq!(bytes, [2, 0, 1, 2, 0, 127, 0x80, 1, 0xff, 0x7f, 0x80, 0x80, 1, 1, 0]);
    }
}
