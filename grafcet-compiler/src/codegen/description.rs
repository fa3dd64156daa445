//! `Motor::CHART`, and the drawing in the documentation of `Motor`.

use grafcet_core::description::{Action, Any, Description, Dialect, Let, MacroStep, Partial, Step, Transition, table};
use proc_macro2::{Literal, TokenStream};
use quote::format_ident;

use super::Cx;
use crate::describe::with_description;
use crate::list::List;
use crate::place::quote;

/// The chart as it is drawn, in the documentation alone: editors that show the source's comments show no picture.
pub(super) fn drawing(cx: &Cx<'_>) -> TokenStream {
    let (svg, large) =
        with_description(cx.model, |chart| (grafcet_draw::svg_inline(chart), grafcet_draw::is_large(chart)));
    let what = if large { "An overview of the chart, which is too large to be drawn here:\n\n" } else { "" };
    // Markdown passes on what stands between the tags of a block, up to the first blank line.
    let doc = format!("\n\n{what}<div style=\"overflow-x:auto\">{svg}</div>\n");
    quote!(#[cfg_attr(doc, doc = #doc)])
}

/// The constant `CHART` of the chart, and the numbers of the active steps.
///
/// The constants of an `impl` are computed where they are used, and statics that are flat tables are quickly checked: otherwise the
/// description of a long chart would take half the time of a check.
pub(super) fn all(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (vis, chart, step) = (&model.vis, &names.chart, &names.step);
    let described = with_description(model, description);
    let situation = if cx.plan.one_step { step } else { &names.situation };
    let active = if cx.plan.one_step { quote!(active_ == self) } else { quote!(self.is_active(*active_)) };
    quote! {
        impl #chart {
            /// What the chart looks like: its steps, transitions and actions as they stand in the source.
            #vis const CHART: #p::description::Description<'static> = {
                use #p::description as d;
                #described
            };
        }

        impl #p::ActiveSteps for #situation {
            fn is_active_at(&self, step_: #p::usize) -> #p::bool {
                match <#chart as #p::Chart>::STEPS.get(step_) {
                    #p::Option::Some(active_) => #active,
                    #p::Option::None => false,
                }
            }
        }
    }
}

fn description(chart: &Description<'_>) -> TokenStream {
    let Description { name, dialect, partials, macros, steps, transitions, lets } = chart;
    let dialect = match dialect {
        Dialect::Sfc => quote!(d::Dialect::Sfc),
        Dialect::Grafcet => quote!(d::Dialect::Grafcet),
    };
    let (partials, macros) = (partials.iter().map(partial), macros.iter().map(macro_step));
    let forces = or_empty(!steps.iter().all(|step| step.forces.is_empty()), "FORCES");
    let times = times(steps);
    let (step_count, steps) = (number(steps.len()), step_tables(steps));
    let (tables, transitions) = (transition_tables(transitions), all_transitions(transitions));
    let lets = lets.iter().map(named);
    let all_steps = quote!(d::table::steps::<#step_count>(&STEPS, &STEP_NUMBERS, Actions::ALL, #forces));
    let all_steps =
        if let Some(times) = times { quote!(d::table::with_times(#all_steps, &[#times])) } else { all_steps };
    quote! {
        #steps
        #tables
        d::Description {
            name: #name,
            dialect: #dialect,
            partials: &[#(#partials),*],
            macros: &[#(#macros),*],
            steps: &#all_steps,
            transitions: &#transitions,
            lets: &[#(#lets),*],
        }
    }
}

/// Out of the tables; what an `any` leaves, of which a chart has few, stands beside them.
fn all_transitions(transitions: &[Transition<'_>]) -> TokenStream {
    let count = number(transitions.len());
    let named = or_empty(!transitions.is_empty(), "TRANSITIONS");
    let clearing = or_empty(!transitions.iter().all(|transition| transition.clearing.is_empty()), "CLEARING");
    let all = quote!(d::table::transitions::<#count>(#named, &TRANSITION_NUMBERS, &ENDS, #clearing));
    let anys = transitions.iter().enumerate().filter_map(|(id, transition)| {
        let (id, Any { steps, except }) = (number(id), transition.any?);
        let steps = steps.iter().copied().map(number);
        Some(quote!((#id, d::Any { steps: &[#(#steps),*], except: &[#(#except),*] })))
    });
    let anys: Vec<TokenStream> = anys.list();
    if anys.is_empty() { all } else { quote!(d::table::with_any(#all, &[#(#anys),*])) }
}

/// Of the steps that have one, the time after which they are late.
fn times(steps: &[Step<'_>]) -> Option<TokenStream> {
    let mut times = TokenStream::new();
    for (at, step) in steps.iter().enumerate().filter(|(_, step)| !step.within.is_empty()) {
        let (at, within) = (number(at), step.within);
        times.extend(quote!((#at, #within),));
    }
    (!times.is_empty()).then_some(times)
}

fn named(Let { name, text, doc }: &Let<'_>) -> TokenStream {
    let documented = documented(doc);
    quote!(d::Let::new(#name, #text) #documented)
}

fn partial(Partial { name, enclosed_by, doc }: &Partial<'_>) -> TokenStream {
    let enclosed = enclosed_by.map(number).map(|step| quote!(.enclosed_by(#step)));
    let documented = documented(doc);
    quote!(d::Partial::new(#name) #enclosed #documented)
}

fn macro_step(MacroStep { name, outer, entry, exit, doc }: &MacroStep<'_>) -> TokenStream {
    let (inside, entry, exit, documented) = (inside(*outer), number(*entry), number(*exit), documented(doc));
    quote!(d::MacroStep::new(#name, #entry, #exit) #inside #documented)
}

fn documented(doc: &str) -> Option<TokenStream> {
    (!doc.is_empty()).then(|| quote!(.documented(#doc)))
}

fn step_tables(steps: &[Step<'_>]) -> TokenStream {
    let row = |step: &Step<'_>| {
        let flags = if step.initial { table::INITIAL } else { 0 } | if step.linked { table::LINKED } else { 0 };
        let expansion = short(step.expansion.map_or(0, |id| id + 1));
        [
            short(step.partial),
            Literal::u32_suffixed(flags),
            expansion,
            short(step.actions.len()),
            short(step.forces.len()),
        ]
    };
    let names = texts("STEPS", steps.iter().map(|step| step.name));
    let numbers = numbers("STEP_NUMBERS", &quote!(Number), steps.iter().flat(row));
    let forces = texts("FORCES", steps.iter().flat(|step| step.forces).copied());
    let actions: Vec<&Action<'_>> = steps.iter().flat(|step| step.actions).list();
    let (count, written) = (number(actions.len()), or_empty(!actions.is_empty(), "ACTIONS"));
    let parts = actions.iter().flat(|a| [a.qualifier, a.time, a.condition, a.text]);
    let actions = texts("ACTIONS", parts);
    quote! {
        #names
        #numbers
        #forces
        #actions
        struct Actions;
        impl Actions {
            const ALL: &'static [d::Action<'static>] = &d::table::actions::<#count>(#written);
        }
    }
}

fn transition_tables(transitions: &[Transition<'_>]) -> TokenStream {
    let row = |t: &Transition<'_>| [t.sources.len(), t.targets.len(), t.clearing.len()].map(short);
    let ends = transitions.iter().flat(|t| t.sources.iter().and(t.targets));
    let named = texts("TRANSITIONS", transitions.iter().flat(|t| [t.name, t.condition]));
    let rows = numbers("TRANSITION_NUMBERS", &quote!(Number), transitions.iter().flat(row));
    let ends = numbers("ENDS", &quote!(End), ends.map(|id| Literal::usize_suffixed(*id)));
    let clearing = texts("CLEARING", transitions.iter().flat(|t| t.clearing).copied());
    quote!(#named #rows #ends #clearing)
}

/// A table that many charts do without: it would cost rustc as much as any other item.
fn or_empty(is_there: bool, name: &str) -> TokenStream {
    let name = format_ident!("{name}");
    if is_there { quote!(&#name) } else { quote!(&[]) }
}

fn texts<'t>(name: &str, texts: impl Iterator<Item = &'t str>) -> TokenStream {
    let texts: Vec<&str> = texts.list();
    if texts.is_empty() {
        return TokenStream::new();
    }
    let (name, count) = (format_ident!("{name}"), number(texts.len()));
    quote!(static #name: [d::table::Text; #count] = [#(#texts),*];)
}

fn numbers(name: &str, ty: &TokenStream, numbers: impl Iterator<Item = Literal>) -> TokenStream {
    let numbers: Vec<Literal> = numbers.list();
    let (name, count) = (format_ident!("{name}"), number(numbers.len()));
    quote!(static #name: [d::table::#ty; #count] = [#(#numbers),*];)
}

/// A number of a table.
fn short(value: usize) -> Literal {
    Literal::u32_suffixed(u32::try_from(value).unwrap_or(u32::MAX))
}

fn number(id: usize) -> Literal {
    Literal::usize_unsuffixed(id)
}

fn inside(expansion: Option<usize>) -> Option<TokenStream> {
    expansion.map(number).map(|id| quote!(.inside(#id)))
}
