//! A user's expression in generated code: what it reads is bound to the names it uses, then its tokens follow.

use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote_spanned};

use super::rust::{bare, behind, eager, is_term, plain_name, without_parens};
use super::situation::At;
use super::{Cx, names, writes};
use crate::list::List;
use crate::model::{
    Binary, Blink, Blinker, Code, Expr, Id, MacroId, Name, Place, Read, StepId, TimeRef, TransitionId, Tree, Ty, Unary,
    placeholder,
};
use crate::place::{self, quote};
use crate::plan::{Phase, RegionId};

/// At which moment of the cycle an expression is evaluated: which situation and which values it sees.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Moment {
    /// What the cycle starts from, the initial situation in the first one (A1): edges and delays.
    Sample,
    /// Everything from before the evolution.
    Condition,
    /// The condition of this transition, where its source steps are known to be active: the same.
    Enabled(TransitionId),
    /// An action of an `sfc`: the situation after the evolution, outputs of the cycle before, variables as they are.
    Action,
    /// The same before the first of them: edges (point 8).
    Late,
    /// An action on leaving a step, whose time is the one it had reached also on a self-loop (A34).
    Leaving,
    /// A stored action of a `grafcet`: everything from before the evolution (A6).
    Stored,
    /// A stored action on the activation of the initial situation: before it, nothing was active (A37).
    Start,
    /// A continuous action of a `grafcet`: the stable situation (A9).
    Stable,
}

impl Moment {
    /// Which situation is meant.
    fn at(self) -> At {
        match self {
            Self::Sample | Self::Condition | Self::Enabled(_) | Self::Stored => At::Before,
            Self::Action | Self::Late | Self::Leaving | Self::Start | Self::Stable => At::After,
        }
    }
}

impl Cx<'_> {
    /// The value of `expr`.
    pub(super) fn value(&self, expr: &Expr, moment: Moment) -> TokenStream {
        let tokens = without_parens(&expr.tokens);
        // A single input needs no binding: the user's own token names the field.
        if let ([Read::Name(Name::Input(_))], Some(name)) = (&expr.reads[..], plain_name(tokens)) {
            // Located there, so that a type error stands there.
            return quote_spanned!(Span::call_site().located_at(name.span())=> inputs_.#name);
        }
        let is_condition = matches!(moment, Moment::Condition | Moment::Enabled(_));
        if let (Tree::Elapsed(time, step), Moment::Enabled(_)) = (&expr.tree, moment) {
            return bare(self.elapsed(*time, *step, moment));
        }
        if is_condition && !expr.reads.is_empty() && self.is_logic(&expr.tree) {
            // In a search, an input that a lazy operator does not come to is better not read; elsewhere a jump costs more.
            let tokens = if self.model.is_grafcet() { tokens.clone() } else { eager(tokens) };
            let read = self.with_inputs(tokens.to_token_stream());
            return if is_term(&tokens) { read } else { quote!({ let value_ = #read; value_ }) };
        }
        let bindings = self.bindings(&expr.reads, &[], expr.tree.is_opaque(), moment);
        behind(&bindings, tokens)
    }

    /// Whether an expression is made of boolean inputs, `!`, `&&` and `||` alone.
    pub(super) fn is_logic(&self, tree: &Tree) -> bool {
        match tree {
            Tree::Read(Read::Name(Name::Input(id))) => matches!(self.model.inputs[*id].ty, Ty::Bool(_)),
            Tree::Unary(Unary::Not, operand) => self.is_logic(operand),
            Tree::Binary(Binary::And | Binary::Or, left, right) => self.is_logic(left) && self.is_logic(right),
            _ => false,
        }
    }

    /// Tokens with `inputs.on` where they say `on`.
    pub(super) fn with_inputs(&self, tokens: TokenStream) -> TokenStream {
        let one = |token: TokenTree| match token {
            TokenTree::Ident(name) if self.model.inputs.values().any(|input| input.name == name) => {
                // Located there, so that a type error stands there.
                quote_spanned!(Span::call_site().located_at(name.span())=> inputs_.#name)
            }
            TokenTree::Group(group) => {
                let mut inner = Group::new(group.delimiter(), self.with_inputs(group.stream()));
                inner.set_span(group.span());
                TokenTree::Group(inner).into()
            }
            other => other.into(),
        };
        tokens.into_iter().map(one).tokens()
    }

    /// A block of the user: what it may write is a copy, which `commit` takes over.
    pub(super) fn block(&self, code: &Code, moment: Moment, commit: impl Fn(Place) -> TokenStream) -> TokenStream {
        let Code { tokens, reads, writes, .. } = code;
        let bindings = self.bindings(reads, writes, true, moment);
        let mut tokens = tokens.clone();
        let (mut notes, mut commits) = (TokenStream::new(), TokenStream::new());
        for place in writes {
            let (name, target) = (self.model.place_name(*place), commit(*place));
            let note = names::written(name);
            let may_leave = self.is_written_back(*place, moment) && !writes::always(&tokens, name);
            match may_leave.then(|| writes::noted(&tokens, name, self.model.place_ty(*place), &note)).flatten() {
                Some(block) => {
                    tokens = block;
                    notes.extend(quote!(let mut #note = false;));
                    commits.extend(quote!(if #note { #target = #name; }));
                }
                None => commits.extend(quote!(#target = #name;)),
            }
        }
        // The braces are the user's: they keep the block's own names apart from the ones written back.
        quote!({ #bindings #notes #[allow(unused_braces)] #tokens #commits })
    }

    /// Whether a block that writes nothing must leave the place alone: its copy is of the cycle before, and another action
    /// may have written the place in this one.
    fn is_written_back(&self, place: Place, moment: Moment) -> bool {
        let Place::Output(id) = place else { return false };
        let in_actions = matches!(moment, Moment::Action | Moment::Leaving) && !self.model.is_grafcet();
        in_actions && self.plan.drives[id.index()].read_by_actions
    }

    /// `let on = inputs.on;` for everything that is read. In Rust that is not looked into (`opaque`) a name that is
    /// mentioned may stand for something of its own.
    fn bindings(&self, reads: &[Read], writes: &[Place], opaque: bool, moment: Moment) -> TokenStream {
        let unused = opaque.then(|| quote!(#[allow(unused_variables)]));
        let one = |read: &Read| {
            let written = writes.iter().find(|place| Read::Name(Name::from(**place)) == *read);
            if let Some(place) = written {
                let (name, value) = (self.model.place_name(*place), self.read(*read, moment));
                // A block may mention a name in a way that does not write it.
                return quote!(#[allow(unused_mut, unused_variables)] let mut #name = #value;);
            }
            let value = self.read(*read, moment);
            let name = match read {
                Read::Name(name) => self.model.value_name(*name).clone(),
                other => placeholder::ident(*other, place::mixed()).unwrap_or_else(|| names::local("unnamed")),
            };
            let value = bare(value);
            quote!(#unused let #name = #value;)
        };
        reads.iter().map(one).tokens()
    }

    fn read(&self, read: Read, moment: Moment) -> TokenStream {
        let p = &self.p;
        match read {
            Read::Name(Name::Input(id)) => {
                let name = &self.model.inputs[id].name;
                quote!(inputs_.#name)
            }
            Read::Name(Name::Param(id)) => {
                let name = &self.model.params[id].name;
                quote!(self.params.#name)
            }
            Read::Name(Name::Var(id)) if self.plan.memory.combinational.contains(&id) => {
                names::combinational(self.model, id).into_token_stream()
            }
            Read::Name(Name::Var(id)) => {
                let field = names::var_field(self.model, id);
                quote!(self.#field)
            }
            Read::Name(Name::Output(id))
                if self.plan.drives[id.index()].read_by_actions && !self.model.is_grafcet() =>
            {
                match moment {
                    Moment::Action | Moment::Leaving => names::output_last(self.model, id).into_token_stream(),
                    _ => {
                        let field = names::output_field(self.model, id);
                        quote!(self.#field)
                    }
                }
            }
            Read::Name(Name::Output(id)) if self.plan.drives[id.index()].last => {
                let field = names::output_last_field(self.model, id);
                quote!(self.#field)
            }
            Read::Name(Name::Output(id)) => {
                let field = names::output_field(self.model, id);
                quote!(self.#field)
            }
            Read::Active(step) => self.is_active(step, moment),
            Read::MacroActive(id) => self.macro_active(id, moment),
            Read::Since(step) => self.since(step, moment),
            Read::MacroSince(id) => {
                let (active, since) = (self.macro_active(id, moment), names::macro_time(id));
                quote!(if #active { self.#since } else { #p::Ticks::ZERO })
            }
            Read::Elapsed(time, step) => self.elapsed(time, step, moment),
            Read::MacroElapsed(time, id) => {
                let (active, since, time) = (self.macro_active(id, moment), names::macro_time(id), self.time(time));
                quote!((#active && self.#since >= #time))
            }
            Read::Rising(_) | Read::Falling(_) if moment == Moment::Start => quote!(false),
            // Only properties have it, of which no code is made.
            Read::Memory(_) => quote!(false),
            Read::Rising(id) => self.edge(id, true, moment).into_token_stream(),
            Read::Falling(id) => self.edge(id, false, moment).into_token_stream(),
            Read::Delay(id) => {
                let field = names::delay_field(id);
                quote!(#p::Delay::output(&self.#field))
            }
            Read::Ticks(ticks) => quote!(#p::Ticks::new(#ticks)),
            Read::Blink(blink) => self.blink(blink, moment),
        }
    }

    /// `blink(700ms/300ms, Step)`
    fn blink(&self, blink: Blink, moment: Moment) -> TokenStream {
        let (p, on) = (&self.p, blink.on);
        let (reached, reached_before) = self.phases_of_blink(blink);
        let (active, reached) = match blink.of {
            Blinker::Step(step) => {
                (self.is_active(step, moment), self.reached(step, moment, &quote!(self.#reached), &reached_before))
            }
            Blinker::Macro(id) => (self.macro_active(id, moment), quote!(self.#reached)),
        };
        quote!((#active && #reached < #p::Ticks::new(#on)))
    }

    /// How far a blink is in its period: the field, and what it was before the evolution.
    pub(super) fn phases_of_blink(&self, blink: Blink) -> (Ident, Ident) {
        let phase = Phase::of(&self.plan.regions, Read::Blink(blink));
        // All that expressions read is planned for.
        let index = self.plan.memory.phases.iter().position(|other| Some(*other) == phase).unwrap_or_default();
        (names::phase(index), names::phase_before(index))
    }

    /// `t/Step`: active for at least `t`.
    pub(super) fn elapsed(&self, time: TimeRef, step: StepId, moment: Moment) -> TokenStream {
        let (since, time) = (self.since(step, moment), self.time(time));
        if self.is_known(step, moment) {
            return quote!((#since >= #time));
        }
        let active = self.is_active(step, moment);
        quote!((#active && #since >= #time))
    }

    /// A time in ticks.
    pub(super) fn time(&self, time: TimeRef) -> TokenStream {
        let p = &self.p;
        match time {
            TimeRef::Ticks(ticks) => quote!(#p::Ticks::new(#ticks)),
            TimeRef::Param(id) => {
                let name = &self.model.params[id].name;
                quote!(self.params.#name)
            }
            TimeRef::Var(id) => {
                let field = names::var_field(self.model, id);
                quote!(self.#field)
            }
        }
    }

    /// Whether a step is active at a moment of the cycle.
    pub(super) fn is_active(&self, step: StepId, moment: Moment) -> TokenStream {
        if moment == Moment::Start {
            return quote!(false);
        }
        if self.is_known(step, moment) {
            return quote!(true);
        }
        let active = self.in_step(moment.at(), step);
        let starts = self.plan.initial.contains(&step);
        if moment == Moment::Sample && starts && self.plan.has_start && !self.model.is_grafcet() {
            let starting = self.is_starting(At::Before);
            return quote!((#active || #starting));
        }
        quote!((#active))
    }

    /// Whether the code stands where the step is active anyway.
    fn is_known(&self, step: StepId, moment: Moment) -> bool {
        self.plan.shape.takes_for_granted
            && matches!(moment, Moment::Enabled(id) if self.model.transitions[id].sources.contains(&step))
    }

    /// Whether any step of a macro-step's expansion is active (A20).
    pub(super) fn macro_active(&self, id: MacroId, moment: Moment) -> TokenStream {
        if moment == Moment::Start {
            return quote!(false);
        }
        let steps = &self.model.macros[id].steps;
        let active = steps.iter().map(|step| self.is_active(*step, moment));
        if steps.is_empty() { quote!(false) } else { quote!((#(#active)||*)) }
    }

    /// The time of a step (A34): zero when it is not active, what it had reached where it has just been left.
    fn since(&self, step: StepId, moment: Moment) -> TokenStream {
        let region = self.plan.regions.of_step(step);
        if self.is_known(step, moment) {
            return self.counted(region);
        }
        self.reached(step, moment, &self.counted(region), &names::step_time_before(region, self.plan))
    }

    /// The same of anything that counts since the activation: `since` is its count, `reached` what that was before the evolution.
    fn reached(&self, step: StepId, moment: Moment, since: &TokenStream, reached: &Ident) -> TokenStream {
        let p = &self.p;
        let (before, after) = (self.in_step(At::Before, step), self.in_step(At::After, step));
        match moment {
            Moment::Start => quote!(#p::Ticks::ZERO),
            Moment::Sample | Moment::Condition | Moment::Enabled(_) | Moment::Stored => {
                quote!((if #before { #since } else { #p::Ticks::ZERO }))
            }
            Moment::Stable => quote!((if #after { #since } else { #p::Ticks::ZERO })),
            Moment::Leaving => quote!((if #before { #reached } else { #p::Ticks::ZERO })),
            Moment::Action | Moment::Late => quote! {
                (if #after { #since } else if #before { #reached } else { #p::Ticks::ZERO })
            },
        }
    }

    /// `__MotorState::Off`
    pub(super) fn variant(&self, step: StepId) -> TokenStream {
        self.variant_of(step, self.plan.regions.of_step(step))
    }

    /// The state that is named after a step, in a region that is perhaps another one's.
    pub(super) fn variant_of(&self, step: StepId, region: RegionId) -> TokenStream {
        let region = self.names.region(region, self.plan);
        let step = names::private_variant(self.model, step);
        quote!(#region::#step)
    }

    /// `__MotorState::NONE`
    pub(super) fn empty(&self, region: RegionId) -> TokenStream {
        let (region, empty) = (self.names.region(region, self.plan), &self.names.empty);
        quote!(#region::#empty)
    }
}
