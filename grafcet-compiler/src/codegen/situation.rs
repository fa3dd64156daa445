//! The situation in generated code: how it is asked for its steps and how steps enter and leave it, with a state for each
//! region, or a bit for each step (`encoding flags;`).

use proc_macro2::{Literal, TokenStream};
use quote::ToTokens;

use super::{Cx, names};
use crate::list::List;
use crate::model::{Id, PartialId, StepId};
use crate::place::quote;
use crate::plan::RegionId;

/// Which situation is meant.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum At {
    /// The one before the evolution.
    Before,
    /// The one after the evolution.
    After,
    /// The chart's own.
    Now,
}

impl Cx<'_> {
    /// The state of a region.
    pub(super) fn state(&self, at: At, region: RegionId) -> TokenStream {
        match at {
            At::Before => names::before(region, self.plan).to_token_stream(),
            At::After => names::after(region, self.plan).to_token_stream(),
            At::Now => self.plain_state(region),
        }
    }

    /// Whether a step is active: `before == __MotorState::Off`, `before[0] & 1 != 0`.
    pub(super) fn in_step(&self, at: At, step: StepId) -> TokenStream {
        if self.plan.shape.is_flags() {
            return self.bit(at, step.index(), true);
        }
        let (state, variant) = (self.state(at, self.plan.regions.of_step(step)), self.variant(step));
        quote!(#state == #variant)
    }

    /// Whether a step is not active.
    pub(super) fn not_in_step(&self, at: At, step: StepId) -> TokenStream {
        if self.plan.shape.is_flags() {
            return self.bit(at, step.index(), false);
        }
        let (state, variant) = (self.state(at, self.plan.regions.of_step(step)), self.variant(step));
        quote!(#state != #variant)
    }

    /// Whether the evolution has changed the state of a region.
    pub(super) fn is_changed(&self, region: RegionId) -> TokenStream {
        if self.plan.shape.is_flags() {
            // A region is a step.
            let (before, after) = (self.byte_of(At::Before, region), self.byte_of(At::After, region));
            let mask = place(region).1;
            return quote!((#after ^ #before) & #mask != 0);
        }
        let (before, after) = (names::before(region, self.plan), names::after(region, self.plan));
        quote!(#after != #before)
    }

    /// Whether the first cycle is still to come.
    pub(super) fn is_starting(&self, at: At) -> TokenStream {
        if self.plan.shape.is_flags() {
            return self.bit(at, self.start_bit(), true);
        }
        let (state, start) = (self.state(at, 0), self.start());
        quote!(#state == #start)
    }

    /// A step is active from this evolution on.
    pub(super) fn enter(&self, step: StepId) -> TokenStream {
        if self.plan.shape.is_flags() {
            let (byte, mask) = (self.byte_of(At::After, step.index()), place(step.index()).1);
            return quote!(#byte |= #mask;);
        }
        self.enter_state(self.plan.regions.of_step(step), &self.variant(step))
    }

    /// A step is not active any more, and no other one of its region is.
    pub(super) fn leave_empty(&self, step: StepId) -> TokenStream {
        if self.plan.shape.is_flags() {
            let (byte, mask) = (self.byte_of(At::After, step.index()), place(step.index()).1);
            return quote!(#byte &= !#mask;);
        }
        let region = self.plan.regions.of_step(step);
        let empty = self.empty(region);
        if self.plan.evolution.exclusive[step.index()] {
            return self.enter_state(region, &empty);
        }
        // Another transition out of the step may have cleared already.
        let (after, variant) = (names::after(region, self.plan), self.variant(step));
        quote!(if #after == #variant { #after = #empty; })
    }

    /// Makes exactly these steps of a partial grafcet active.
    pub(super) fn set_situation(&self, partial: PartialId, steps: &[StepId]) -> TokenStream {
        if self.plan.shape.is_flags() {
            return self.set_flags(&self.model.partials[partial].steps, steps);
        }
        let regions = self.plan.regions.of_partial(partial).map(|region| {
            let step = steps.iter().find(|step| self.plan.regions.of_step(**step) == region);
            let state = step.map_or_else(|| self.empty(region), |step| self.variant(*step));
            let enter = self.enter_state(region, &state);
            match self.note_moved() {
                Some(moved) => {
                    let was = self.plain_state(region);
                    quote!(if #was != #state { #enter #moved })
                }
                None => enter,
            }
        });
        regions.tokens()
    }

    /// The initial situation, entered by an evolution of its own in the first cycle.
    pub(super) fn enter_initial(&self) -> TokenStream {
        let begin = self.begin_initial();
        if self.plan.shape.is_flags() {
            let initial = self.initial_flags();
            return quote!(self.situation = #initial; #begin);
        }
        // The other regions hold their initial states from the beginning.
        let enter = self.set_state(0, &self.initial(0));
        quote!(#enter #begin)
    }

    /// Takes the mark of an unstable search away, or sets it (A30).
    pub(super) fn mark(&self, unstable: bool) -> TokenStream {
        if self.plan.shape.is_flags() {
            let (byte, mask) = (self.byte_of(At::Now, self.mark_bit()), place(self.mark_bit()).1);
            return if unstable { quote!(#byte |= #mask;) } else { quote!(#byte &= !#mask;) };
        }
        let field = names::region_field(0, self.plan);
        if unstable {
            quote!(self.#field = self.#field.marked();)
        } else {
            quote!(self.#field = self.#field.unmarked();)
        }
    }

    /// Whether the mark of an unstable search is not there.
    pub(super) fn is_unmarked(&self) -> TokenStream {
        if self.plan.shape.is_flags() {
            return self.bit(At::Now, self.mark_bit(), false);
        }
        let field = names::region_field(0, self.plan);
        quote!(!self.#field.is_marked())
    }

    /// Whether the evolution has not changed the situation, as one comparison for each region.
    pub(super) fn is_same(&self) -> Vec<TokenStream> {
        let regions = 0..if self.plan.shape.is_flags() { 1 } else { self.plan.regions.all().len() };
        let same = regions.map(|region| {
            let (before, after) = (names::before(region, self.plan), names::after(region, self.plan));
            quote!(#after == #before)
        });
        same.list()
    }
}

/// A bit for each step.
impl Cx<'_> {
    /// The bytes of the situation: a bit for each step, one for "the first cycle is still to come" and one for "the last
    /// search did not become stable", where there are such cycles.
    pub(super) fn flag_bytes(&self) -> usize {
        let bits = self.mark_bit() + usize::from(self.plan.may_be_unstable);
        bits.div_ceil(8)
    }

    fn start_bit(&self) -> usize {
        self.model.steps.len()
    }

    fn mark_bit(&self) -> usize {
        self.start_bit() + usize::from(self.plan.has_start)
    }

    /// The situation of a new chart.
    pub(super) fn first_flags(&self) -> TokenStream {
        if self.plan.has_start { self.flags(&[self.start_bit()]) } else { self.initial_flags() }
    }

    /// The initial situation.
    pub(super) fn initial_flags(&self) -> TokenStream {
        self.flags(&self.plan.initial.iter().map(|step| step.index()).list())
    }

    /// The steps alone of the chart's own situation, the initial ones before the first cycle.
    pub(super) fn shown_flags(&self) -> TokenStream {
        let starting = self.plan.has_start.then(|| {
            let (starting, initial) = (self.is_starting(At::Now), self.initial_flags());
            quote!(if #starting { steps_ = #initial; })
        });
        let unmarked = self.plan.may_be_unstable.then(|| {
            let (byte, mask) = place(self.mark_bit());
            quote!(steps_[#byte] &= !#mask;)
        });
        let mutable = (self.plan.has_start || self.plan.may_be_unstable).then(|| quote!(mut));
        quote!(let #mutable steps_ = self.situation; #starting #unmarked)
    }

    /// `[1, 0]`
    fn flags(&self, set: &[usize]) -> TokenStream {
        let mut bytes = vec![0; self.flag_bytes()];
        for bit in set {
            bytes[bit / 8] |= 1 << (bit % 8);
        }
        let bytes = bytes.into_iter().map(Literal::u8_suffixed);
        quote!([#(#bytes),*])
    }

    /// Of `steps`, those in `active` become active and the others inactive, byte by byte.
    fn set_flags(&self, steps: &[StepId], active: &[StepId]) -> TokenStream {
        let mask = |steps: &[StepId], byte: usize| {
            let here = steps.iter().map(|step| step.index()).filter(|bit| bit / 8 == byte);
            here.fold(0_u8, |mask, bit| mask | 1 << (bit % 8))
        };
        let bytes = (0..self.flag_bytes()).filter(|byte| mask(steps, *byte) != 0).map(|byte| {
            let (set, kept) = (Literal::u8_suffixed(mask(active, byte)), Literal::u8_suffixed(!mask(steps, byte)));
            let after = self.byte_of(At::After, 8 * byte);
            quote!(#after = #after & #kept | #set;)
        });
        bytes.tokens()
    }

    /// What happens while steps are active, in their order of declaration. Bytes without an active one of them are passed
    /// over at once.
    pub(super) fn visit(&self, at: At, arms: &[(StepId, TokenStream)]) -> TokenStream {
        let bytes = arms.chunk_by(|(one, _), (other, _)| one.index() / 8 == other.index() / 8).map(|arms| {
            let all = arms.iter().map(|(step, body)| {
                let active = self.in_step(at, *step);
                quote!(if #active { #body })
            });
            let all = self.one_behind_the_other(all);
            let [(first, _), _, ..] = arms else { return all };
            let mask = arms.iter().fold(0_u8, |mask, (step, _)| mask | 1 << (step.index() % 8));
            let (byte, mask) = (self.byte_of(at, first.index()), Literal::u8_suffixed(mask));
            quote!(if #byte & #mask != 0 { #all })
        });
        self.one_behind_the_other(bytes)
    }

    /// Where one step is active at most, nothing is left to be done after it.
    fn one_behind_the_other(&self, all: impl Iterator<Item = TokenStream>) -> TokenStream {
        let all: Vec<_> = all.list();
        if self.plan.most_active == 1 { quote!(#(#all)else*) } else { quote!(#(#all)*) }
    }

    fn byte_of(&self, at: At, bit: usize) -> TokenStream {
        let (byte, state) = (place(bit).0, if at == At::Now { quote!(self.situation) } else { self.state(at, 0) });
        quote!(#state[#byte])
    }

    fn bit(&self, at: At, bit: usize, set: bool) -> TokenStream {
        let (byte, mask) = (self.byte_of(at, bit), place(bit).1);
        if set { quote!(#byte & #mask != 0) } else { quote!(#byte & #mask == 0) }
    }
}

/// Whether a step is active in a `MotorSituation`.
pub(super) fn shown_in(step: StepId) -> TokenStream {
    let (byte, mask) = place(step.index());
    quote!(self.steps[#byte] & #mask != 0)
}

/// Where a bit is: its byte, and in it.
pub(super) fn place(bit: usize) -> (Literal, Literal) {
    (Literal::usize_suffixed(bit / 8), Literal::u8_suffixed(1 << (bit % 8)))
}
