//! A user's expression in generated code: what it reads is bound to the names it uses, then its tokens follow.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};

use super::{Cx, names};
use crate::model::{Expr, Name, Read, StepId, placeholder};
use crate::plan::RegionId;

/// At which moment of the cycle an expression is evaluated: which situation and which outputs it sees.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Moment {
    /// A transition condition: the situation before the evolution.
    Condition,
    /// An action of an `sfc`: the situation after the evolution, the outputs of the cycle before.
    Action,
    /// A stored action of a `grafcet`: everything from before the evolution (A6).
    Stored,
    /// A stored action on the activation of the initial situation: before it, nothing was active (A37).
    Start,
    /// A continuous action of a `grafcet`: the stable situation (A9).
    Stable,
}

impl Cx<'_> {
    /// The value of `expr`.
    pub(super) fn value(&self, expr: &Expr, moment: Moment) -> TokenStream {
        let tokens = &expr.tokens;
        // A single input needs no binding: the user's own token names the field.
        if let ([Read::Name(Name::Input(_))], Some(name)) = (&expr.reads[..], plain_name(tokens)) {
            return quote!(inputs.#name);
        }
        let bindings = self.bindings(&expr.reads, moment);
        if bindings.is_empty() { without_parens(tokens) } else { quote!({ #bindings #tokens }) }
    }

    /// `let on = inputs.on;` for everything that is read.
    fn bindings(&self, reads: &[Read], moment: Moment) -> TokenStream {
        let one = |read: &Read| {
            let value = self.read(*read, moment);
            let name = match read {
                Read::Name(name) => self.model.value_name(*name).clone(),
                other => placeholder::ident(*other, Span::mixed_site()).unwrap_or_else(|| names::local("unnamed")),
            };
            quote!(let #name = #value;)
        };
        reads.iter().map(one).collect()
    }

    fn read(&self, read: Read, moment: Moment) -> TokenStream {
        let p = &self.p;
        match read {
            Read::Name(Name::Input(id)) => {
                let name = &self.model.inputs[id].name;
                quote!(inputs.#name)
            }
            Read::Name(Name::Output(id)) => match moment {
                Moment::Action | Moment::Stored => names::output_last(self.model, id).into_token_stream(),
                Moment::Condition | Moment::Start | Moment::Stable => {
                    let field = names::output_field(self.model, id);
                    quote!(self.#field)
                }
            },
            Read::Active(step) => self.is_active(step, moment),
            Read::Ticks(ticks) => quote!(#p::Ticks::new(#ticks)),
            // The gate in front of codegen refuses what is not compiled yet.
            _ => TokenStream::new(),
        }
    }

    /// Whether a step is active at a moment of the cycle.
    pub(super) fn is_active(&self, step: StepId, moment: Moment) -> TokenStream {
        let region = self.plan.regions.of_step(step);
        let state = match moment {
            Moment::Condition | Moment::Stored => names::before(region, self.plan),
            Moment::Action | Moment::Stable => names::after(region, self.plan),
            Moment::Start => return quote!(false),
        };
        let variant = self.variant(step);
        quote!((#state == #variant))
    }

    /// `__MotorState::Off`
    pub(super) fn variant(&self, step: StepId) -> TokenStream {
        let region = self.names.region(self.plan.regions.of_step(step), self.plan);
        let step = names::private_variant(self.model, step);
        quote!(#region::#step)
    }

    /// `__MotorState::NONE`
    pub(super) fn empty(&self, region: RegionId) -> TokenStream {
        let (region, empty) = (self.names.region(region, self.plan), &self.names.empty);
        quote!(#region::#empty)
    }
}

/// A constant expression: literals, times and Rust constants.
pub(super) fn constant(expr: &Expr, p: &TokenStream) -> TokenStream {
    let bindings: TokenStream = expr
        .reads
        .iter()
        .filter_map(|read| match read {
            Read::Ticks(ticks) => {
                let name = placeholder::ident(*read, Span::mixed_site())?;
                Some(quote!(let #name = #p::Ticks::new(#ticks);))
            }
            _ => None,
        })
        .collect();
    let tokens = &expr.tokens;
    if bindings.is_empty() { tokens.to_token_stream() } else { quote!({ #bindings #tokens }) }
}

fn plain_name(expr: &syn::Expr) -> Option<&Ident> {
    match expr {
        syn::Expr::Path(path) => path.path.get_ident(),
        _ => None,
    }
}

/// `if (a)` would be an `unused_parens` at the user's tokens.
fn without_parens(expr: &syn::Expr) -> TokenStream {
    match expr {
        syn::Expr::Paren(paren) => without_parens(&paren.expr),
        other => other.to_token_stream(),
    }
}
