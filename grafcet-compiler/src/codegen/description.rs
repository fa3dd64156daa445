//! `Motor::CHART`, and the drawing in the documentation of `Motor`.

use grafcet_core::description::{Action, Description, Dialect, MacroStep, Partial, Step, Transition};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::Cx;
use crate::describe::with_description;

/// The chart as it is drawn, in the documentation alone: editors that show the source's comments show no picture.
pub(super) fn drawing(cx: &Cx<'_>) -> TokenStream {
    let (svg, large) =
        with_description(cx.model, |chart| (grafcet_draw::svg_inline(chart), grafcet_draw::is_large(chart)));
    let what = if large { "An overview of the chart, which is too large to be drawn here:\n\n" } else { "" };
    // Markdown passes on what stands between the tags of a block, up to the first blank line.
    let doc = format!("\n\n{what}<div style=\"overflow-x:auto\">{svg}</div>\n");
    quote!(#[cfg_attr(doc, doc = #doc)])
}

/// The constant `CHART` of the chart, and the numbers of the active steps. Clippy takes long arrays for such on the stack
/// (`large_stack_arrays`) in the constant of an `impl`, but not in one by itself.
pub(super) fn all(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (vis, chart, step) = (&model.vis, &names.chart, &names.step);
    let described = with_description(model, description);
    let situation = if cx.plan.one_step { step } else { &names.situation };
    let active = if cx.plan.one_step { quote!(active == self) } else { quote!(self.is_active(*active)) };
    quote! {
        impl #chart {
            /// What the chart looks like: its steps, transitions and actions as they stand in the source.
            #vis const CHART: #p::description::Description<'static> = {
                use #p::description as d;
                const CHART: d::Description<'static> = #described;
                CHART
            };
        }

        impl #p::ActiveSteps for #situation {
            fn is_active_at(&self, step: #p::usize) -> #p::bool {
                match <#chart as #p::Chart>::STEPS.get(step) {
                    #p::Option::Some(active) => #active,
                    #p::Option::None => false,
                }
            }
        }
    }
}

fn description(chart: &Description<'_>) -> TokenStream {
    let Description { name, dialect, partials, macros, steps, transitions } = chart;
    let dialect = match dialect {
        Dialect::Sfc => quote!(d::Dialect::Sfc),
        Dialect::Grafcet => quote!(d::Dialect::Grafcet),
    };
    let (partials, macros) = (partials.iter().map(partial), macros.iter().map(macro_step));
    let (steps, transitions) = (steps.iter().map(step), transitions.iter().map(transition));
    quote! {
        d::Description {
            name: #name,
            dialect: #dialect,
            partials: &[#(#partials),*],
            macros: &[#(#macros),*],
            steps: &[#(#steps),*],
            transitions: &[#(#transitions),*],
        }
    }
}

fn partial(Partial { name, enclosed_by }: &Partial<'_>) -> TokenStream {
    let enclosed = enclosed_by.map(number).map(|step| quote!(.enclosed_by(#step)));
    quote!(d::Partial::new(#name) #enclosed)
}

fn macro_step(MacroStep { name, outer, entry, exit }: &MacroStep<'_>) -> TokenStream {
    let (inside, entry, exit) = (inside(*outer), number(*entry), number(*exit));
    quote!(d::MacroStep::new(#name, #entry, #exit) #inside)
}

fn step(Step { name, initial, linked, partial, expansion, actions, forces }: &Step<'_>) -> TokenStream {
    let (partial, inside) = (number(*partial), inside(*expansion));
    let initial = initial.then(|| quote!(.initial()));
    let linked = linked.then(|| quote!(.linked()));
    let actions = actions.iter().map(action);
    quote!(d::Step::new(#name, #partial, &[#(#actions),*], &[#(#forces),*]) #initial #linked #inside)
}

fn action(Action { qualifier, time, condition, text }: &Action<'_>) -> TokenStream {
    quote!(d::Action::new(#qualifier, #time, #condition, #text))
}

fn transition(Transition { name, sources, targets, condition, clearing }: &Transition<'_>) -> TokenStream {
    let (sources, targets) = (sources.iter().map(|id| number(*id)), targets.iter().map(|id| number(*id)));
    quote!(d::Transition::new(#name, &[#(#sources),*], &[#(#targets),*], #condition, &[#(#clearing),*]))
}

fn number(id: usize) -> Literal {
    Literal::usize_unsuffixed(id)
}

fn inside(expansion: Option<usize>) -> Option<TokenStream> {
    expansion.map(number).map(|id| quote!(.inside(#id)))
}
