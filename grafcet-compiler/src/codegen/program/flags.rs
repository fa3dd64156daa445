//! A situation that is stored as a bit for each step (`encoding flags;`): in a cycle the state of a region is a local like any other, which is
//! taken from the bits in front of it, and put back where it has changed.

use proc_macro2::{Ident, Literal, TokenStream};

use super::Printer;
use super::layout::{Kind, Start};
use crate::codegen::machine::Field;
use crate::codegen::names;
use crate::list::List;
use crate::model::{Id, StepId};
use crate::place::quote;
use crate::program::uses::{each_asked, each_written};
use crate::program::{PlaceId, Role, Statement};

/// The bits of a situation.
#[derive(Clone, Copy)]
pub(in crate::codegen) struct Flags {
    /// A bit for each of so many steps.
    pub(in crate::codegen) steps: usize,
    /// One for the first cycle, as long as it is still to come.
    pub(in crate::codegen) start: bool,
    /// One for a search that did not become stable (A30).
    pub(in crate::codegen) unstable: bool,
}

impl Flags {
    pub(in crate::codegen) fn bytes(self) -> usize {
        (self.steps + usize::from(self.start) + usize::from(self.unstable)).div_ceil(8)
    }

    pub(super) fn start_bit(self) -> usize {
        self.steps
    }

    pub(super) fn unstable_bit(self) -> usize {
        self.steps + usize::from(self.start)
    }

    /// The bytes in which these bits are set.
    fn set(self, bits: impl Iterator<Item = usize>) -> Vec<u8> {
        let mut bytes = vec![0; self.bytes()];
        for bit in bits {
            bytes[bit / 8] |= 1 << (bit % 8);
        }
        bytes
    }
}

/// The field with the bits of all steps.
pub(super) fn field() -> Ident {
    names::own("situation")
}

/// A bit of a field: its byte, and the mask.
pub(in crate::codegen) fn bit(index: usize) -> (Literal, Literal) {
    (Literal::usize_suffixed(index / 8), Literal::u8_suffixed(1 << (index % 8)))
}

/// Whether a bit is set.
pub(super) fn is_set(index: usize) -> TokenStream {
    let (field, (byte, mask)) = (field(), bit(index));
    quote!(self.#field[#byte] & #mask != 0)
}

fn array(bytes: &[u8]) -> TokenStream {
    let bytes = bytes.iter().map(|byte| Literal::u8_suffixed(*byte));
    quote!([#(#bytes),*])
}

impl<'m> Printer<'_, 'm> {
    /// The field of the situation.
    pub(super) fn flags_field(&self, flags: Flags) -> Field {
        let (p, bytes) = (&self.cx.p, Literal::usize_suffixed(flags.bytes()));
        let starts = flags.start.then_some(flags.start_bit());
        let initial = array(&flags.set(self.initial_bits().chain(starts)));
        Field { name: field(), ty: quote!([#p::u8; #bytes]), initial, align: Some(1) }
    }

    /// The bits of the steps of the initial situation.
    fn initial_bits(&self) -> impl Iterator<Item = usize> + '_ {
        self.cx.plan.initial.iter().map(|step| step.index())
    }

    /// Whether a step is active; before the first cycle those of the initial situation are (A1).
    pub(super) fn is_active_by_flags(&self, flags: Flags, step: StepId) -> TokenStream {
        let active = is_set(step.index());
        if !(flags.start && self.cx.plan.initial.contains(&step)) {
            return active;
        }
        let starting = is_set(flags.start_bit());
        quote!(#active || #starting)
    }

    /// The situation, in which nothing but steps is told.
    pub(super) fn situation_of_flags(&self, flags: Flags) -> TokenStream {
        let (field, name) = (field(), &self.cx.names.situation);
        let others = [flags.start.then_some(flags.start_bit()), flags.unstable.then_some(flags.unstable_bit())];
        let hidden = others.into_iter().flatten().map(|index| {
            let (byte, mask) = bit(index);
            quote!(steps_[#byte] &= !#mask;)
        });
        let hidden = hidden.tokens();
        if hidden.is_empty() {
            return quote!(#name { steps: self.#field });
        }
        quote!(let mut steps_ = self.#field; #hidden #name { steps: steps_ })
    }

    /// A function for each region that is asked for or changed: its state.
    pub(super) fn unpacking(&self, flags: Flags) -> Option<TokenStream> {
        let chart = &self.cx.names.chart;
        let places = (0..self.program.places.len()).map(PlaceId);
        let asked = places.filter(|place| self.layout.slot(*place).kind == Kind::Unpacked);
        let methods = asked.map(|place| {
            let (region, name, ty) = (self.region_of(place), self.layout.name(place), self.ty(place));
            let starts = self.layout.regions[region].start.map(|_| {
                let (starting, start) = (is_set(flags.start_bit()), self.start(region));
                quote!(if #starting { return #start; })
            });
            let state = self.unpacked(region);
            quote! {
                const fn #name(&self) -> #ty {
                    #starts
                    #state
                }
            }
        });
        let methods = methods.tokens();
        (!methods.is_empty()).then(|| {
            quote! {
                #[allow(clippy::all, clippy::pedantic)]
                impl #chart { #methods }
            }
        })
    }

    fn region_of(&self, place: PlaceId) -> usize {
        match self.info(place).role {
            Role::State(region) => region,
            _ => 0,
        }
    }

    /// The state that the bits of a region tell.
    fn unpacked(&self, region: usize) -> TokenStream {
        let (p, field) = (&self.cx.p, field());
        let steps = self.program.states(region);
        let none = self.layout.regions[region].empty.then(|| self.cx.empty(region));
        // One of them is active, if the region is never empty.
        let (asked, otherwise) = match (none, steps.split_last()) {
            (Some(none), _) => (&steps[..], none),
            (None, Some((last, others))) => (others, self.cx.variant_of(*last, region)),
            (None, None) => return self.cx.empty(region),
        };
        let index = |step: &StepId| step.index();
        let (Some(least), Some(most)) = (asked.iter().map(index).min(), asked.iter().map(index).max()) else {
            return otherwise;
        };
        let first = least / 8;
        let mut masks = vec![0_u8; most / 8 + 1 - first];
        for step in asked {
            masks[step.index() / 8 - first] |= 1 << (step.index() % 8);
        }
        if let [mask] = masks[..] {
            let (byte, mask) = (Literal::usize_suffixed(first), Literal::u8_suffixed(mask));
            let arms = asked.iter().map(|step| {
                let (mask, state) = (bit(step.index()).1, self.cx.variant_of(*step, region));
                quote!(#mask => #state,)
            });
            return quote!(match self.#field[#byte] & #mask { #(#arms)* _ => #otherwise });
        }
        let arms = asked.iter().map(|step| {
            let (place, state) = (Literal::usize_suffixed(step.index() - 8 * first), self.cx.variant_of(*step, region));
            quote!(#place => #state,)
        });
        let (first, masks) = (Literal::usize_suffixed(first), array(&masks));
        quote!(match #p::flags::first(&self.#field, #first, &#masks) { #(#arms)* _ => #otherwise })
    }

    /// The states that statements ask for, in front of them, and what puts those back that they change.
    pub(super) fn around(&self, flags: Flags, statements: &[Statement<'m>]) -> (TokenStream, TokenStream) {
        let (mut read, mut written) = (vec![false; self.program.places.len()], vec![false; self.program.places.len()]);
        each_asked(statements, &mut |place| read[place.0] = true);
        each_written(statements, &mut |place| written[place.0] = true);
        let (mut first, mut front, mut after) = (TokenStream::new(), TokenStream::new(), TokenStream::new());
        for index in 0..self.program.places.len() {
            let place = PlaceId(index);
            if self.layout.slot(place).kind != Kind::Unpacked || !(read[index] || written[index]) {
                continue;
            }
            let name = self.layout.name(place);
            if !written[index] {
                front.extend(quote!(let #name = Self::#name(self);));
                continue;
            }
            let (region, before) = (self.region_of(place), names::before(self.region_of(place), self.cx.plan));
            let unpack = quote!(let #before = Self::#name(self); let mut #name = #before;);
            if self.layout.regions[region].start.is_some() {
                // No other bits are set then, whatever a state says that was stored elsewhere.
                let (start, field, initial) = (self.start(region), field(), array(&flags.set(self.initial_bits())));
                first.extend(quote!(#unpack if #before == #start { self.#field = #initial; }));
            } else {
                front.extend(unpack);
            }
            let packed = self.packed(flags, region, name, &before);
            after.extend(quote!(if #name != #before { #packed }));
        }
        (quote!(#first #front), after)
    }

    /// The bits of a region become those of its state.
    fn packed(&self, flags: Flags, region: usize, state: &Ident, before: &Ident) -> TokenStream {
        let (p, field, steps) = (&self.cx.p, field(), self.program.states(region));
        let starts = self.layout.regions[region].start;
        let bytes = steps.iter().map(|step| step.index() / 8);
        if let (Some(byte), true) = (bytes.clone().min(), bytes.clone().min() == bytes.max()) {
            let mask = steps.iter().fold(0_u8, |mask, step| mask | 1 << (step.index() % 8));
            let arms = steps.iter().map(|step| {
                let (mask, state) = (bit(step.index()).1, self.cx.variant_of(*step, region));
                quote!(#state => #mask,)
            });
            let rest = (self.layout.regions[region].empty || starts.is_some()).then(|| quote!(_ => 0u8,));
            let (byte, others) = (Literal::usize_suffixed(byte), Literal::u8_suffixed(!mask));
            return quote!(self.#field[#byte] = self.#field[#byte] & #others | match #state { #(#arms)* #rest };);
        }
        let (mut from, to) = (self.index(flags, region, before), self.index(flags, region, state));
        if let Some(Start(Some(seen))) = starts {
            let (start, seen) = (self.start(region), Literal::usize_suffixed(seen.index()));
            from = quote!(if #before == #start { #seen } else { #from });
        }
        quote!(#p::flags::exchange(&mut self.#field, #from, #to);)
    }

    /// The bit of a state; none is after all of them.
    fn index(&self, flags: Flags, region: usize, of: &Ident) -> TokenStream {
        let (p, steps, none) = (&self.cx.p, self.program.states(region), Literal::usize_suffixed(8 * flags.bytes()));
        let has_others = self.layout.regions[region].empty || self.layout.regions[region].start.is_some();
        let first = steps.first().map_or(0, |step| step.index());
        if steps.iter().enumerate().all(|(at, step)| step.index() == first + at) {
            // The enum has them in this order, and all else after them.
            let mut index = quote!(#of as #p::usize);
            if first > 0 {
                let first = Literal::usize_suffixed(first);
                index = quote!((#index).wrapping_add(#first));
            }
            let count = Literal::usize_suffixed(steps.len());
            return if has_others { quote!(if (#of as #p::usize) < #count { #index } else { #none }) } else { index };
        }
        let arms = steps.iter().map(|step| {
            let (index, state) = (Literal::usize_suffixed(step.index()), self.cx.variant_of(*step, region));
            quote!(#state => #index,)
        });
        let rest = has_others.then(|| quote!(_ => #none,));
        quote!(match #of { #(#arms)* #rest })
    }
}
