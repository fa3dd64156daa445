//! The chart's struct and the private enums of its regions.

use proc_macro2::{Ident, Literal, TokenStream};

use super::control::set_by;
use super::machine::{Field, Machine};
use super::{Cx, derives, names, recipe, types};
use crate::list::{List, PushAll};
use crate::model::{Place, Qualifier};
use crate::place::quote;
use crate::plan::{RegionId, Target, What};

/// The enum of a region: the steps, of which at most one is active, what it has beside them, and how it is stored.
#[derive(Clone, Copy)]
pub(super) struct StateEnum {
    pub(super) region: RegionId,
    /// None of the steps may be active.
    pub(super) empty: bool,
    /// The first cycle may be still to come.
    pub(super) start: bool,
    /// A bit above the state tells that the last search did not become stable (A30).
    pub(super) marked: bool,
    /// It is as wide as a register, which saves widening it in every evolution. The field holds a byte all the same.
    pub(super) wide: bool,
}

/// The enums of the regions.
pub(super) fn enums(cx: &Cx<'_>) -> TokenStream {
    regions(cx).iter().map(|states| region_enum(cx, states)).tokens()
}

/// Which enums there are.
pub(super) fn regions(cx: &Cx<'_>) -> Vec<StateEnum> {
    let enums = if cx.plan.shape.is_flags() { 0 } else { cx.plan.regions.all().len() };
    let states = |region: RegionId| StateEnum {
        region,
        empty: cx.plan.regions.all()[region].may_be_empty,
        start: cx.has_start_variant(region),
        marked: cx.is_marked(region),
        wide: false,
    };
    (0..enums).map(states).list()
}

/// The variants of a region's enum.
pub(super) fn variants(cx: &Cx<'_>, states: &StateEnum) -> Vec<Ident> {
    let steps = cx.plan.regions.all()[states.region].steps.iter().map(|step| names::private_variant(cx.model, *step));
    let empty = states.empty.then(|| cx.names.empty.clone());
    let start = states.start.then(|| cx.names.start.clone());
    steps.and(empty).and(start).list()
}

/// The type and what belongs to it.
pub(super) fn region_enum(cx: &Cx<'_>, states: &StateEnum) -> TokenStream {
    let p = &cx.p;
    let derives = derives::of_states().attributes(cx.model, p);
    let name = cx.names.region(states.region, cx.plan);
    let variants = variants(cx, states);
    let marked = states.marked.then(|| marked(cx, &variants));
    let texts = variants.iter().map(|variant| variant.to_string().trim_start_matches("r#").to_owned()).list();
    let wide = states.wide.then(|| quote!(#[repr(u32)]));
    quote! {
        #derives
        #[doc(hidden)]
        #wide
        enum #name { #(#variants,)* }

        #[automatically_derived]
        impl #p::core::fmt::Debug for #name {
            fn fmt(&self, f: &mut #p::core::fmt::Formatter<'_>) -> #p::core::fmt::Result {
                f.write_str(#p::name_at(&[#(#texts),*], *self as #p::usize))
            }
        }

        #marked
    }
}

/// A30: that the last search did not become stable is told by a bit above the first region's state, so that it takes no
/// byte of its own.
fn marked(cx: &Cx<'_>, variants: &[Ident]) -> TokenStream {
    let p = &cx.p;
    let (name, state) = (cx.names.marked(cx.plan), cx.names.region(0, cx.plan));
    let derives = derives::of_states().and("Debug").attributes(cx.model, p);
    let mark = variants.len().next_power_of_two();
    let (number, literal): (_, fn(usize) -> Literal) = match mark {
        0..=128 => (quote!(#p::u8), |n| Literal::u8_suffixed(u8::try_from(n).unwrap_or(u8::MAX))),
        _ => (quote!(#p::u16), |n| Literal::u16_suffixed(u16::try_from(n).unwrap_or(u16::MAX))),
    };
    let (mark, below) = (literal(mark), literal(mark - 1));
    let numbered = from_number(&state, variants, &literal);
    quote! {
        /// A state, and above it the mark of a search that did not become stable.
        #derives
        #[doc(hidden)]
        struct #name(#number);

        impl #name {
            const fn of(state: #state) -> Self {
                Self(state as #number)
            }

            const fn state(self) -> #state {
                let number = self.0 & #below;
                #numbered
            }

            /// Another state, and the mark as it is.
            const fn with(self, state: #state) -> Self {
                Self(self.0 & #mark | state as #number)
            }

            const fn unmarked(self) -> Self {
                Self(self.0 & #below)
            }

            const fn marked(self) -> Self {
                Self(self.0 | #mark)
            }

            const fn is_marked(self) -> #p::bool {
                self.0 & #mark != 0
            }
        }
    }
}

/// The state that `number` stands for. Numbers that no state has are the last one's; that it is asked for first keeps LLVM
/// from comparing with each of three.
fn from_number(state: &Ident, variants: &[Ident], literal: &impl Fn(usize) -> Literal) -> TokenStream {
    let Some((last, others)) = variants.split_last() else { return TokenStream::new() };
    let Some((rest, first)) = others.split_last() else { return quote!({ let _ = number; #state::#last }) };
    let arms = first.iter().enumerate().map(|(i, variant)| {
        let number = literal(i);
        quote!(#number => #state::#variant,)
    });
    let highest = literal(others.len());
    quote!(if number >= #highest { #state::#last } else { match number { #(#arms)* _ => #state::#rest } })
}

impl Cx<'_> {
    /// The first region's state also says that the first cycle is still to come.
    pub(super) fn has_start_variant(&self, region: RegionId) -> bool {
        region == 0 && self.plan.has_start
    }

    /// The first region's state also says that the last search did not become stable.
    pub(super) fn is_marked(&self, region: RegionId) -> bool {
        region == 0 && self.plan.may_be_unstable
    }

    /// The state of a region as the chart holds it.
    pub(super) fn plain_state(&self, region: RegionId) -> TokenStream {
        let field = names::region_field(region, self.plan);
        let state = self.is_marked(region).then(|| quote!(.state()));
        quote!(self.#field #state)
    }

    /// `state` as a value of the region's field.
    pub(super) fn held(&self, region: RegionId, state: &TokenStream) -> TokenStream {
        if !self.is_marked(region) {
            return state.clone();
        }
        let marked = self.names.marked(self.plan);
        quote!(#marked::of(#state))
    }

    /// The chart holds `state` from now on.
    pub(super) fn set_state(&self, region: RegionId, state: &TokenStream) -> TokenStream {
        let (field, held) = (names::region_field(region, self.plan), self.held(region, state));
        quote!(self.#field = #held;)
    }

    /// `__MotorState::INIT`
    pub(super) fn start(&self) -> TokenStream {
        let (region, start) = (self.names.region(0, self.plan), &self.names.start);
        quote!(#region::#start)
    }

    /// The state of a region in the initial situation, once entered.
    pub(super) fn initial(&self, region: RegionId) -> TokenStream {
        match self.plan.regions.all()[region].initial {
            Some(step) => self.variant(step),
            None => self.empty(region),
        }
    }

    pub(super) fn fields(&self) -> Vec<Field> {
        let mut fields = self.region_fields();
        fields.push_all(self.place_fields());
        fields.push_all(self.time_fields());
        fields.push_all(self.control_fields());
        fields.push_all(self.call_fields());
        fields
    }

    fn flag(&self, name: &str, initial: bool) -> Field {
        let p = &self.p;
        Field { name: names::local(name), ty: quote!(#p::bool), initial: quote!(#initial) }
    }

    fn region_fields(&self) -> Vec<Field> {
        if self.plan.shape.is_flags() {
            let (p, bytes) = (&self.p, Literal::usize_suffixed(self.flag_bytes()));
            return vec![Field {
                name: names::local("situation"),
                ty: quote!([#p::u8; #bytes]),
                initial: self.first_flags(),
            }];
        }
        let one = |region| Field {
            name: names::region_field(region, self.plan),
            ty: {
                let marked = self.is_marked(region).then(|| self.names.marked(self.plan));
                let name = marked.unwrap_or_else(|| self.names.region(region, self.plan));
                quote!(#name)
            },
            initial: {
                let start = self.has_start_variant(region);
                self.held(region, &if start { self.start() } else { self.initial(region) })
            },
        };
        (0..self.plan.regions.all().len()).map(one).list()
    }

    /// Remembered outputs, variables and the values that edges compare with.
    fn place_fields(&self) -> Vec<Field> {
        let output = |id, name| Field {
            name,
            ty: types::rust_type(&self.model.outputs[id].ty, &self.p),
            initial: types::initial_output(self.model, id, &self.p),
        };
        let stored = self.plan.memory.stored.iter().map(|id| output(*id, names::output_field(self.model, *id)));
        let last = self.plan.memory.last.iter().map(|id| output(*id, names::output_last_field(self.model, *id)));
        let mut fields: Vec<_> = stored.and(last).list();
        fields.push_all(self.plan.memory.vars.iter().map(|id| {
            let var = &self.model.vars[*id];
            Field {
                name: names::var_field(self.model, *id),
                ty: types::rust_type(&var.ty, &self.p),
                initial: types::initial_value(var.init.as_ref(), &var.ty, &self.p),
            }
        }));
        // After a value that was true no edge rises: there is none in the first cycle (A26).
        let edges = self.plan.memory.edges.iter();
        fields.push_all(
            edges.map(|(id, rising, falling)| self.flag(&names::edge_field(*id).to_string(), *rising && !falling)),
        );
        fields.push_all(
            self.plan
                .memory
                .late_edges
                .iter()
                .map(|(id, rising, falling)| self.flag(&names::late_edge(*id, None).to_string(), *rising && !falling)),
        );
        fields
    }

    fn time_fields(&self) -> Vec<Field> {
        if !self.plan.memory.time {
            return Vec::new();
        }
        let p = &self.p;
        let ticks = |name| Field { name, ty: quote!(#p::Ticks), initial: quote!(#p::Ticks::ZERO) };
        let mut fields = vec![ticks(names::local("now"))];
        fields.push_all(self.left_over_field().map(|(name, ty, initial)| Field { name, ty, initial }));
        fields.push_all(self.timed_regions().map(|region| {
            let (name, time) = (names::step_time(region, self.plan), self.time_type(region));
            Field { name, initial: quote!(#time::ZERO), ty: time }
        }));
        fields.push_all(self.plan.memory.macro_times.iter().map(|id| ticks(names::macro_time(*id))));
        fields.push_all((0..self.plan.memory.phases.len()).map(|index| ticks(names::phase(index))));
        fields.push_all(self.model.delays.ids().map(|id| Field {
            name: names::delay_field(id),
            ty: quote!(#p::Delay),
            initial: quote!(#p::Delay::new()),
        }));
        fields
    }

    /// The flip-flops, timers and memories of the action control, as far as a target needs them.
    fn control_fields(&self) -> Vec<Field> {
        let targets = self.plan.control.targets.iter().enumerate();
        targets.flat(|(index, target)| self.target_fields(index, target)).list()
    }

    fn target_fields(&self, index: usize, target: &Target) -> Vec<Field> {
        let p = &self.p;
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        let mut fields = Vec::new();
        for qualifier in
            Qualifier::ALL.into_iter().filter(|qualifier| qualifier.has_flip_flop() || qualifier.has_time())
        {
            if !target.has(self.model, qualifier) {
                continue;
            }
            let flag = names::flag(qualifier);
            if qualifier.has_flip_flop() {
                let initial = qualifier == Qualifier::S && self.starts_set(target);
                fields.push(self.flag(&name(&format!("memory_{flag}")).to_string(), initial));
            }
            if qualifier.has_time() {
                let (ty, initial) = (quote!(#p::OnDelay), quote!(#p::OnDelay::new()));
                fields.push(Field { name: name(&format!("timer_{flag}")), ty, initial });
            }
            if target.remembers_time(self.model, qualifier) {
                let ty = names::number_type(target.associations.len(), p);
                fields.push(Field { name: name(&format!("time_{flag}")), ty, initial: quote!(0) });
            }
            if qualifier.has_flip_flop() && target.chooses_under(self.model, qualifier) {
                let ty = names::number_type(target.associations.len(), p);
                fields.push(Field { name: name(&set_by(qualifier)), ty, initial: quote!(0) });
            }
        }
        if target.remembers_q && target.remembers_terms(self.model) {
            for qualifier in target.leavable(self.model) {
                fields.push(self.flag(&name(&format!("kept_{}", names::flag(qualifier))).to_string(), false));
            }
        }
        for id in &target.remembers_held {
            fields.push(self.flag(&name(&names::held(target, *id)).to_string(), false));
        }
        if target.remembers_q {
            fields.push(self.flag(&name("kept_q").to_string(), false));
        }
        if target.remembers_association {
            fields.push(Field {
                name: name("association"),
                ty: names::number_type(target.associations.len(), p),
                initial: quote!(0),
            });
        }
        fields
    }

    /// A boolean that only S and R control starts with its initial value.
    fn starts_set(&self, target: &Target) -> bool {
        let only = target.associations.iter().all(|id| self.model.associations[*id].qualifier.sets_or_resets());
        let init = match target.what {
            What::Boolean(Place::Output(id)) => self.model.outputs[id].init.as_ref(),
            What::Boolean(Place::Var(id)) => self.model.vars[id].init.as_ref(),
            What::Runs => None,
        };
        only && init.is_some_and(|init| init.tree == crate::model::Tree::Bool(true))
    }

    /// `grafcet`: what the phase and the arguments of a continuous call follow from.
    fn call_fields(&self) -> Vec<Field> {
        let mut fields = Vec::new();
        if !self.model.is_grafcet() {
            return fields;
        }
        for action in self.model.actions.ids().filter(|id| !self.continuous_calls_of(*id).is_empty()) {
            fields.push(self.flag(&names::called(self.model, action).to_string(), false));
            if self.remembers_call(action) {
                let ty = names::number_type(self.continuous_calls_of(action).len(), &self.p);
                fields.push(Field { name: names::called_number(self.model, action), ty, initial: quote!(0) });
            }
        }
        fields
    }
}

/// The struct, and how it is made.
pub(super) fn chart(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    let Cx { model, p, .. } = cx;
    let (vis, name) = (&model.vis, &model.name);
    let docs = types::docs(&model.attrs, &format!("The chart `{name}`."));
    let fields = &machine.fields;
    let declared = fields.iter().map(|Field { name, ty, .. }| quote!(#name: #ty,));
    let values = fields.iter().map(|Field { name, initial, .. }| quote!(#name: #initial,));
    let stored = machine.stored.iter().copied();
    let derives = derives::of(stored.and(model.params.values().map(|param| &param.ty))).of_chart();
    let (written_out, derives) = (derives.written_out(name, p), derives.attributes(model, p));
    let levels = types::levels(model);
    let (params_field, new) = constructors(cx, &quote!(#(#values)*));
    let encoding = cx.encoding().map(|text| format!("\n\n{text}"));
    let encoding = encoding.map(|text| quote!(#[doc = #text]));
    let drawing = super::description::drawing(cx);
    quote! {
        #docs
        #drawing
        #encoding
        #derives
        #vis struct #name { #(#declared)* #params_field }

        #written_out

        #levels
        impl #name { #new }

        impl #p::core::default::Default for #name {
            fn default() -> Self {
                Self::new()
            }
        }
    }
}

/// `new`, and with a recipe `with_params`, `params` and `set_params`.
fn constructors(cx: &Cx<'_>, values: &TokenStream) -> (Option<TokenStream>, TokenStream) {
    let (vis, name) = (&cx.model.vis, &cx.model.name);
    let doc = format!("A chart `{name}` in its initial situation; its activation belongs to the first cycle.");
    if cx.model.params.is_empty() {
        let new = quote! {
            #[doc = #doc]
            #[must_use]
            #vis const fn new() -> Self {
                Self { #values }
            }
        };
        return (None, new);
    }
    let params = &cx.names.params;
    let with_doc = format!("A chart `{name}` in its initial situation, with this recipe.");
    if recipe::has_ranges(cx.model) {
        let exchanged = recipe::exchanged_in_range(cx, values);
        let new = quote! {
            #[doc = #doc]
            #[must_use]
            #vis const fn new() -> Self {
                let params = #params::new();
                Self { #values params }
            }

            #exchanged
        };
        return (Some(quote!(params: #params,)), new);
    }
    let new = quote! {
        #[doc = #doc]
        #[must_use]
        #vis const fn new() -> Self {
            Self::with_params(#params::new())
        }

        #[doc = #with_doc]
        #[must_use]
        #vis const fn with_params(params: #params) -> Self {
            Self { #values params }
        }

        /// The recipe in use.
        #[must_use]
        #vis const fn params(&self) -> &#params {
            &self.params
        }

        /// Exchanges the recipe; the next cycle uses the new one.
        #vis fn set_params(&mut self, params: #params) {
            self.params = params;
        }
    };
    (Some(quote!(params: #params,)), new)
}

/// `MotorStep::Off`
pub(super) fn step_name(cx: &Cx<'_>, step: crate::model::StepId) -> TokenStream {
    let (names, step) = (&cx.names.step, &cx.model.steps[step].name);
    quote!(#names::#step)
}
