//! Long sequences: where each step ends on one input, a table says which one and what comes behind. A cycle costs the
//! same few instructions whatever its step, and a step two bytes; under `optimize size` one, since what comes behind is
//! computed.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Cx, names};
use crate::model::{Id, InputId, Name, Read, StepId, Tree, Ty, Unary};

/// From how many steps on a table is smaller than code.
const LONG: usize = 20;

/// In an entry of the table, above the number of the input.
const NEGATED: u8 = 0x80;

/// How a step ends.
struct Exit {
    input: InputId,
    negated: bool,
    target: StepId,
}

impl Cx<'_> {
    /// Whether every step has one transition, to another step, on one input or its negation.
    pub(super) fn is_sequence(&self) -> bool {
        self.is_one_match()
            && self.model.steps.len() >= LONG
            && self.model.inputs.len() <= usize::from(NEGATED)
            && self.model.steps.ids().all(|step| self.exit(step).is_some())
    }

    fn exit(&self, step: StepId) -> Option<Exit> {
        let [id] = self.plan.evolution.owned[step.index()][..] else { return None };
        let transition = &self.model.transitions[id];
        let (input, negated) = match &transition.condition.tree {
            Tree::Unary(Unary::Not, inner) => (&**inner, true),
            tree => (tree, false),
        };
        let Tree::Read(Read::Name(Name::Input(input))) = *input else { return None };
        let alone = transition.clearing.is_empty() && transition.sources != transition.targets;
        let bool = matches!(self.model.inputs[input].ty, Ty::Bool(_));
        let target = *transition.targets.first()?;
        (alone && bool).then_some(Exit { input, negated, target })
    }

    /// `let after = …;` by a table: for each step the number of its input, above it whether that is negated, and the step
    /// behind it, where that is not computed. In a search a path on which nothing clears ends it.
    pub(super) fn sequence(&self) -> TokenStream {
        let p = &self.p;
        let (before, after) = (names::before(0, self.plan), names::after(0, self.plan));
        let inputs = self.exit_inputs();
        let steps = &self.plan.regions.all()[0].steps;
        let exits = steps.iter().filter_map(|step| {
            let exit = self.exit(*step)?;
            let position = inputs.iter().position(|(input, _)| *input == exit.input)?;
            let negated = if exit.negated { NEGATED } else { 0 };
            let number = Literal::u8_suffixed(u8::try_from(position).ok()? | negated);
            let target = self.variant(exit.target);
            Some(if self.model.small { quote!(#number) } else { quote!((#number, #target)) })
        });
        let (length, region) = (Literal::usize_suffixed(steps.len()), self.names.region(0, self.plan));
        let (entry, exit, next) = if self.model.small {
            (quote!(#p::u8), quote!(exit), self.next_in_sequence(steps))
        } else {
            (quote!((#p::u8, #region)), quote!((exit, next)), quote!(*next))
        };
        let last = inputs.last().map(|(_, value)| quote!(_ => #value,));
        let arms = inputs.iter().enumerate().take(inputs.len().saturating_sub(1)).map(|(i, (_, value))| {
            let number = Literal::usize_unsuffixed(i);
            quote!(#number => #value,)
        });
        let (negated, number) = (Literal::u8_suffixed(NEGATED), Literal::u8_suffixed(NEGATED - 1));
        let (some, none) = (quote!(#p::core::option::Option::Some), quote!(#p::core::option::Option::None));
        let (stay, first) =
            if self.model.is_grafcet() { (self.stop(), self.stop()) } else { (quote!(#before), self.initial(0)) };
        quote! {
            const EXITS: [#entry; #length] = [#(#exits),*];
            let #after = match EXITS.get(#before as #p::usize) {
                #some(#exit) => {
                    let input = match *exit & #number { #(#arms)* #last };
                    if input != (*exit >= #negated) { #next } else { #stay }
                }
                // Behind the steps there is only the state before the first cycle.
                #none => #first,
            };
        }
    }

    /// Whether the next step of a sequence is computed from the active one.
    pub(super) fn is_small_sequence(&self) -> bool {
        self.model.small && self.is_sequence()
    }

    /// The chart's state, of which LLVM does not know how it came to be: it would take the table's arithmetic apart again,
    /// step by step, to jump from each into its actions.
    pub(super) fn opaque_state(&self) -> TokenStream {
        let (p, field) = (&self.p, names::region_field(0, self.plan));
        let state = self.is_marked(0).then(|| quote!(.state()));
        quote!((*#p::core::hint::black_box(&self.#field)) #state)
    }

    /// The step behind the active one. LLVM computes it as `state + 1` where all of a `match` do that, so the few jumps that
    /// a sequence has are told apart behind it.
    fn next_in_sequence(&self, steps: &[StepId]) -> TokenStream {
        let before = names::before(0, self.plan);
        let (mut in_order, mut jumps) = (TokenStream::new(), TokenStream::new());
        for (i, step) in steps.iter().enumerate() {
            let Some(exit) = self.exit(*step) else { continue };
            let (state, target) = (self.variant(*step), self.variant(exit.target));
            let Some(behind) = steps.get(i + 1) else {
                in_order.extend(quote!(_ => #target,));
                break;
            };
            let behind_state = self.variant(*behind);
            in_order.extend(quote!(#state => #behind_state,));
            if *behind != exit.target {
                jumps.extend(quote!(#state => #target,));
            }
        }
        let in_order = quote!(match #before { #in_order });
        if jumps.is_empty() { in_order } else { quote!(match #before { #jumps _ => #in_order }) }
    }

    /// The inputs that steps end on, each once, and how to read them.
    fn exit_inputs(&self) -> Vec<(InputId, TokenStream)> {
        let mut inputs: Vec<(InputId, TokenStream)> = Vec::new();
        for exit in self.model.steps.ids().filter_map(|step| self.exit(step)) {
            if !inputs.iter().any(|(input, _)| *input == exit.input) {
                let name = &self.model.inputs[exit.input].name;
                inputs.push((exit.input, quote!(inputs.#name)));
            }
        }
        inputs.sort_by_key(|(input, _)| *input);
        inputs
    }
}
