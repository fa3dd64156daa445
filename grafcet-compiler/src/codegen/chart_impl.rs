//! The methods of a chart, its situation, and its implementation of the trait `Chart`.

use proc_macro2::{Literal, TokenStream};

use super::machine::Machine;
use super::state::{StateEnum, step_name};
use super::{Cx, deadline, derives, late, names, program, recipe, requirements, types};
use crate::list::List;
use crate::model::{Id, Name, Read, StepId};
use crate::place::{self, quote};

/// `cycle`, `init`, `is_active`, `active_steps`, `situation`, `is_exactly`, `is_stable`, `next_deadline`.
pub(super) fn inherent(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (vis, chart, step) = (&model.vis, &names.chart, &names.step);
    let (cycle, init) = (cycle(cx, machine), init(cx));
    let (capacity, active_steps) = active_steps(cx, machine);
    let is_active = is_active(cx, machine);
    let (situation_type, situation) = (situation_type(cx), &machine.situation);
    let (stable, deadline, late) = (is_stable(cx, machine), deadline::method(cx, machine), late::method(cx, machine));
    let (ticks, assumptions) = (ticks(cx), assumptions_hold(cx));
    let (situation_struct, levels) = (situation_struct(cx, machine), types::levels(model));
    let unreached = super::unreached(model);
    let asked = names::parameter("step", &quote!(#step));
    let all = names::parameter("steps", &quote!(&[#step]));
    quote! {
        #situation_struct

        #levels
        #unreached
        impl #chart {
            #cycle
            #init

            /// Whether the step is active.
            #[must_use]
            #vis fn is_active(&self, #asked) -> #p::bool {
                #is_active
            }

            /// The active steps, in the order of their declaration; the capacity is the most that can be active.
            #[must_use]
            #vis fn active_steps(&self) -> #p::heapless::Vec<#step, #capacity> {
                #active_steps
            }

            /// The situation: which steps are active.
            #[must_use]
            #vis const fn situation(&self) -> #situation_type {
                #situation
            }

            /// Whether these steps are active, in any order, and no others: the same question for one active step and
            /// for several.
            #[must_use]
            #vis fn is_exactly(&self, #all) -> #p::bool {
                #p::Chart::is_exactly(self, steps_)
            }

            #stable
            #deadline
            #late
            #ticks
            #assumptions
        }
    }
}

/// `Motor::assumptions_hold(&inputs)`
fn assumptions_hold(cx: &Cx<'_>) -> Option<TokenStream> {
    let Cx { model, p, names, .. } = cx;
    let (vis, inputs) = (&model.vis, &names.inputs);
    let stated = || model.assumptions.iter().filter(|assumption| assumption.of_range.is_none());
    let excluded: Vec<_> = (0..stated().count()).map(|index| names::local(&format!("excluded_{index}"))).list();
    let values = stated().map(|assumption| cx.value(&assumption.never));
    let reads = |is: fn(&Read) -> bool| stated().any(|assumption| assumption.never.reads.iter().any(is));
    let reads_nothing = !reads(|read| matches!(read, Read::Name(Name::Input(_))));
    let of_recipe = reads(|read| matches!(read, Read::Name(Name::Param(_)))).then(|| quote!(&self,));
    let copied = requirements::copied(model, p);
    let unread = reads_nothing.then(|| quote!(let _ = inputs_;));
    let given = names::parameter("inputs", &quote!(&#inputs));
    (!excluded.is_empty()).then(|| {
        // What the user wrote is an assumption, and not the Rust of a function: its style is nobody's business.
        quote! {
            /// Whether the plant keeps to what the chart assumes of it (`assume never …;`): what was proved when the chart
            /// was compiled holds as long as this is true in every cycle.
            #[must_use]
            #[allow(clippy::all, clippy::pedantic)]
            #vis fn assumptions_hold(#of_recipe #given) -> #p::bool {
                #copied
                #unread
                #(let #excluded: #p::bool = #values;)*
                #(!#excluded)&&*
            }
        }
    })
}

fn cycle(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (vis, inputs, outputs) = (&model.vis, &names.inputs, &names.outputs);
    let Machine { cycle: body, .. } = machine;
    let time = cx.model.uses_time();
    let given = names::parameter("inputs", &quote!(&#inputs));
    let now = time.then(|| names::parameter("now", &quote!(impl #p::core::convert::Into<#p::Ticks>)));
    let now = now.map(|now| quote!(, #now));
    let ticks = time.then(|| quote!(let now_: #p::Ticks = #p::core::convert::Into::into(now_);));
    let actions = (!model.actions.is_empty()).then(|| {
        let actions = &names.actions;
        let actions = names::parameter("actions", &quote!(&mut (impl #actions + ?#p::core::marker::Sized)));
        quote!(, #actions)
    });
    // Where the outputs are returned in memory, inlining would take them apart and write them one by one.
    let outlined = (model.outputs.len() > 8).then(|| quote!(#[inline(never)]));
    let copied = requirements::copied(model, p);
    // Fields may be written twice, and locals that stand for them.
    let unread = machine.flags.map(|_| quote!(#[allow(unused_assignments)]));
    quote! {
        #outlined
        #unread
        /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
        /// situation.
        #vis fn cycle(&mut self, #given #now #actions) -> #outputs {
            #copied
            #ticks
            #body
        }
    }
}

fn init(cx: &Cx<'_>) -> TokenStream {
    let vis = &cx.model.vis;
    let new = match cx.model.params.is_empty() {
        true => quote!(*self = Self::new();),
        // It is in its range.
        false if recipe::has_ranges(cx.model) => quote! {
            let params_ = self.params;
            *self = Self::new();
            self.params = params_;
        },
        false => quote!(*self = Self::with_params(self.params);),
    };
    let copied = (!cx.model.params.is_empty()).then(|| requirements::copied(cx.model, &cx.p));
    quote! {
        /// Back to the initial situation (the classic *Init*), stored outputs and variables reset; the next cycle is a
        /// first one.
        #vis fn init(&mut self) {
            #copied
            #new
        }
    }
}

/// `Motor::ticks(Duration)`
fn ticks(cx: &Cx<'_>) -> Option<TokenStream> {
    let (vis, p) = (&cx.model.vis, &cx.p);
    let unit = Literal::u64_unsuffixed(cx.model.clock_nanos);
    let duration = names::parameter("duration", &quote!(#p::core::time::Duration));
    let bound = names::bound_in_const("duration");
    cx.model.uses_time().then(|| {
        quote! {
            /// A duration in the chart's clock unit, rounded up.
            #[must_use]
            #vis const fn ticks(#duration) -> #p::Ticks {
                #bound
                #p::Ticks::from_duration(duration_, #unit)
            }
        }
    })
}

/// The uniform form for generic code.
pub(super) fn uniform(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (chart, inputs, outputs, step) = (&names.chart, &names.inputs, &names.outputs, &names.step);
    let transition = &names.transition;
    let name = model.name.to_string();
    let steps = model.steps.ids().map(|id| step_name(cx, id));
    let transitions = model.drawn_transitions().map(|(id, _)| cx.names.transition_variant(id));
    let situation = situation_type(cx);
    let has_actions = !model.actions.is_empty();
    let actions = if has_actions {
        let actions = &names.actions;
        quote!(dyn #actions + 'a)
    } else {
        quote!(())
    };
    let (now, now_name) = if cx.model.uses_time() { (Some(quote!(, now_)), quote!(now_)) } else { (None, quote!(_)) };
    let (pass, actions_name) =
        if has_actions { (Some(quote!(, actions_)), quote!(actions_)) } else { (None, quote!(_)) };
    quote! {
        impl #p::Chart for #chart {
            type Inputs = #inputs;
            type Outputs = #outputs;
            type Step = #step;
            type Transition = #transition;
            type Situation = #situation;
            type Actions<'a> = #actions;

            const NAME: &'static #p::str = #name;
            const STEPS: &'static [#step] = &[#(#steps),*];
            const TRANSITIONS: &'static [#transition] = &[#(#transition::#transitions),*];

            fn scan(&mut self, inputs_: &#inputs, #now_name: #p::Ticks, #actions_name: &mut Self::Actions<'_>) -> #outputs {
                self.cycle(inputs_ #now #pass)
            }

            fn init(&mut self) {
                self.init();
            }

            fn is_active(&self, step_: #step) -> #p::bool {
                self.is_active(step_)
            }

            fn situation(&self) -> #situation {
                self.situation()
            }
        }
    }
}

/// The capacity of `active_steps` and the body that fills it.
fn active_steps(cx: &Cx<'_>, machine: &Machine<'_>) -> (Literal, TokenStream) {
    // No two steps of a region are active together.
    let capacity = Literal::usize_unsuffixed(cx.plan.regions.all().len().max(1));
    let p = &cx.p;
    let steps = names::local("steps");
    let pushes = if cx.plan.one_step {
        quote!(let _ = #p::heapless::Vec::push(&mut #steps, self.situation());)
    } else {
        // The order of declaration runs across the regions.
        let push = |id: StepId| {
            let (active, name) = (&machine.active[id.index()], step_name(cx, id));
            quote!(if #active { let _ = #p::heapless::Vec::push(&mut #steps, #name); })
        };
        cx.model.steps.ids().map(push).tokens()
    };
    (capacity, quote!(let mut #steps = #p::heapless::Vec::new(); #pushes #steps))
}

fn is_active(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    if cx.plan.one_step {
        return quote!(self.situation() == step_);
    }
    let arms = cx.model.steps.ids().map(|id| {
        let (name, active) = (step_name(cx, id), &machine.active[id.index()]);
        quote!(#name => #active,)
    });
    quote!(match step_ { #(#arms)* })
}

impl Cx<'_> {
    /// Whether a state is one of some, or the one in front of the first cycle.
    pub(super) fn is_one_of(
        &self,
        state: &TokenStream,
        states: &[TokenStream],
        start: Option<TokenStream>,
    ) -> TokenStream {
        let p = &self.p;
        match states {
            [] => quote!(false),
            [one] => {
                let starting = start.map(|start| quote!(|| #state == #start));
                quote!(#state == #one #starting)
            }
            _ => {
                let start = start.map(|start| quote!(| #start));
                quote!(#p::core::matches!(#state, #(#states)|* #start))
            }
        }
    }
}

/// One step, where that is all a situation can be.
fn situation_type(cx: &Cx<'_>) -> TokenStream {
    let name = if cx.plan.one_step { &cx.names.step } else { &cx.names.situation };
    quote!(#name)
}

/// `MotorSituation`: the states of all regions.
fn situation_struct(cx: &Cx<'_>, machine: &Machine<'_>) -> Option<TokenStream> {
    if cx.plan.one_step {
        return None;
    }
    let Cx { model, p, names, .. } = cx;
    let (vis, name, step, chart) = (&model.vis, &names.situation, &names.step, &names.chart);
    let (fields, arms) = situation_fields(cx, machine);
    let derives = derives::of_states();
    let (written_out, derives) = (derives.written_out(name, p), derives.users(model, &["Default"]));
    let doc = format!("A situation of [`{}`]: which steps are active.", model.name);
    let item = place::item("struct", name, &model.name, &quote!(#fields));
    let asked = names::parameter("step", &quote!(#step));
    Some(quote! {
        #[doc = #doc]
        #[derive(#p::core::clone::Clone, #p::core::marker::Copy, #p::core::cmp::PartialEq)]
        #derives
        #vis #item

        #written_out

        impl #name {
            /// Whether the step is active in this situation.
            #[must_use]
            #vis fn is_active(&self, #asked) -> #p::bool {
                match step_ { #arms }
            }
        }

        impl #p::core::fmt::Debug for #name {
            fn fmt(&self, f_: &mut #p::core::fmt::Formatter<'_>) -> #p::core::fmt::Result {
                let mut set_ = f_.debug_set();
                for step_ in <#chart as #p::Chart>::STEPS {
                    if self.is_active(*step_) {
                        let _ = #p::core::fmt::DebugSet::entry(&mut set_, step_);
                    }
                }
                #p::core::fmt::DebugSet::finish(&mut set_)
            }
        }

        /// The names of the active steps, as in `Fill, Heat`; nothing where none is active.
        impl #p::core::fmt::Display for #name {
            fn fmt(&self, f_: &mut #p::core::fmt::Formatter<'_>) -> #p::core::fmt::Result {
                let names_ = #p::core::iter::Iterator::map(<#chart as #p::Chart>::STEPS.iter(), |step_| (*step_).name());
                #p::situation::write(self, names_, f_)
            }
        }
    })
}

/// What a situation holds, and for each step whether it is active there.
fn situation_fields(cx: &Cx<'_>, machine: &Machine<'_>) -> (TokenStream, TokenStream) {
    let Cx { model, p, plan, .. } = cx;
    let fields = machine.regions.iter().map(|StateEnum { region, .. }| {
        let (field, ty) = (names::region_field(*region, plan), cx.names.region(*region, plan));
        quote!(#field: #ty,)
    });
    let fields: TokenStream = match machine.flags {
        Some(flags) => {
            let bytes = Literal::usize_suffixed(flags.bytes());
            quote!(steps: [#p::u8; #bytes])
        }
        None => fields.tokens(),
    };
    let arms = model.steps.ids().map(|id| {
        let step = step_name(cx, id);
        if machine.flags.is_some() {
            let (byte, mask) = program::bit(id.index());
            return quote!(#step => self.steps[#byte] & #mask != 0,);
        }
        let (region, states) = &machine.homes[id.index()];
        let field = names::region_field(*region, plan);
        let states = states.iter().map(|state| cx.variant_of(*state, *region)).list();
        let active = cx.is_one_of(&quote!(self.#field), &states, None);
        quote!(#step => #active,)
    });
    (fields, arms.tokens())
}

/// A30: whether the last search for stability came to an end.
fn is_stable(cx: &Cx<'_>, machine: &Machine<'_>) -> Option<TokenStream> {
    let (vis, p) = (&cx.model.vis, &cx.p);
    if !cx.model.is_grafcet() {
        return None;
    }
    let value = &machine.stable;
    Some(quote! {
        /// Whether the last cycle reached a stable situation. If not, it stopped after the most evolutions it may make
        /// and keeps the situation it had reached (decision A30).
        #[must_use]
        #vis const fn is_stable(&self) -> #p::bool {
            #value
        }
    })
}
