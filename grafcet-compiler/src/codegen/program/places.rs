//! How places are read and written, and the fields that hold them.

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;

use super::Printer;
use super::bytes::{self, Bytes};
use super::constants::{self, Constant};
use super::expr::kind_type;
use super::flags::{self, bit};
use super::layout::{Kind, Slot};
use crate::codegen::machine::{Began, Field};
use crate::codegen::{names, rust, types};
use crate::list::{List, PushAll};
use crate::model::{StepId, Ty};
use crate::place::quote;
use crate::program::uses::mentions;
use crate::program::{Deadline, Expr, Initial, PlaceId, PlaceInfo, Role, Type, Value, Wait};

/// The longest time that an expression names, in ticks.
fn longest_in(expr: &Expr<'_>) -> u32 {
    let mut longest = 0;
    constants::each_of(expr, &mut |constant| {
        if let Constant::Elsewhere(Value::Ticks(ticks)) = constant {
            longest = longest.max(ticks);
        }
    });
    longest
}

impl<'m> Printer<'_, 'm> {
    pub(super) fn info(&self, place: PlaceId) -> &PlaceInfo<'m> {
        &self.program.places[place.0]
    }

    /// The value of a place, as an operand.
    pub(super) fn get(&self, place: PlaceId) -> TokenStream {
        let Slot { name, kind } = self.layout.slot(place);
        match kind {
            Kind::Unused => self.initial(place),
            Kind::Local | Kind::Asked => name.to_token_stream(),
            Kind::Result => quote!(outputs_.#name),
            Kind::Field => quote!(self.#name),
            Kind::Late => {
                let initial = self.initial(place);
                quote!(self.#name.unwrap_or_else(|| #initial))
            }
            Kind::Param => quote!(self.params.#name),
            Kind::Marked => quote!(self.#name.state()),
            Kind::Mark => {
                let state = self.marked();
                quote!(!self.#state.is_marked())
            }
            Kind::Unpacked if self.within => name.to_token_stream(),
            // Not as a method: one of a trait of the user may be found first.
            Kind::Unpacked => quote!(Self::#name(self)),
            Kind::Unset(index) => {
                let is_set = flags::is_set(*index);
                quote!(!(#is_set))
            }
        }
    }

    /// The statement that sets a place.
    pub(super) fn put(&self, place: PlaceId, value: &TokenStream) -> TokenStream {
        let Slot { name, kind } = self.layout.slot(place);
        match kind {
            Kind::Unused => quote!(let _ = #value;),
            Kind::Local | Kind::Asked | Kind::Unpacked => quote!(#name = #value;),
            Kind::Result => quote!(outputs_.#name = #value;),
            Kind::Field => quote!(self.#name = #value;),
            Kind::Late => {
                let p = &self.cx.p;
                quote!(self.#name = #p::Option::Some(#value);)
            }
            Kind::Param => quote!(self.params.#name = #value;),
            Kind::Marked => quote!(self.#name = self.#name.with(#value);),
            // No block of the user writes it.
            Kind::Mark | Kind::Unset(_) => TokenStream::new(),
        }
    }

    /// The same of an expression, whose value is `tokens`.
    pub(super) fn set(&self, place: PlaceId, value: &Expr<'m>, tokens: &TokenStream) -> TokenStream {
        let (on, off) = match self.layout.slot(place).kind {
            Kind::Mark => {
                let state = self.marked();
                (quote!(self.#state = self.#state.unmarked();), quote!(self.#state = self.#state.marked();))
            }
            Kind::Unset(index) => {
                let (field, (byte, mask)) = (flags::field(), bit(index));
                (quote!(self.#field[#byte] &= !#mask;), quote!(self.#field[#byte] |= #mask;))
            }
            _ => return self.put(place, tokens),
        };
        match value {
            Expr::Value(Value::Bool(true)) => on,
            Expr::Value(Value::Bool(false)) => off,
            _ => quote!(if #tokens { #on } else { #off }),
        }
    }

    /// The field with the mark.
    fn marked(&self) -> Ident {
        names::region_field(0, self.cx.plan)
    }

    /// The same as [`put`](Self::put) where the mark is set next.
    pub(super) fn put_unmarked(&self, place: PlaceId, value: &TokenStream) -> TokenStream {
        let Slot { name, kind } = self.layout.slot(place);
        if *kind != Kind::Marked {
            return self.put(place, value);
        }
        let marked = self.cx.names.marked(self.cx.plan);
        quote!(self.#name = #marked::of(#value);)
    }

    /// What the address of a field is a multiple of, if that is known.
    fn align(&self, place: PlaceId) -> Option<u8> {
        let field = (self.info(place), self.layout.slot(place).kind);
        let sizes = (&self.layout.regions[..], self.layout.number_size());
        Bytes::of_field(self.cx, self.program, field, sizes).map(|bytes| bytes.align)
    }

    /// The type of a place.
    pub(super) fn ty(&self, place: PlaceId) -> TokenStream {
        let p = &self.cx.p;
        match (self.info(place).ty, bytes::declared(self.cx, self.info(place))) {
            (Type::User(ty), _) | (_, Some(ty)) => types::rust_type(ty, p),
            (Type::Bool, _) => quote!(#p::bool),
            (Type::Ticks, _) => quote!(#p::Ticks),
            (Type::State(region), _) => self.cx.names.region(region, self.cx.plan).to_token_stream(),
            // What is counted in a loop is in a register.
            (Type::Number, _) if self.info(place).role == Role::Evolutions => quote!(#p::u32),
            (Type::Number, _) => self.layout.number(p),
            (ty @ Type::Kind { .. }, _) => kind_type(ty).to_token_stream(),
        }
    }

    /// What a place begins with.
    pub(super) fn initial(&self, place: PlaceId) -> TokenStream {
        let (p, info) = (&self.cx.p, self.info(place));
        match (info.initial, info.ty) {
            (Initial::Value(value), _) => self.constant(value, info.ty),
            (Initial::Constant(expr), _) => rust::constant(expr, p),
            (Initial::Default, Type::Ticks) => quote!(#p::Ticks::ZERO),
            (Initial::Default, Type::Bool) => quote!(false),
            (Initial::Default, Type::User(ty)) => types::initial_value(None, ty, p),
            (Initial::Default, Type::Number | Type::Kind { .. }) => quote!(0),
            (Initial::Default, Type::State(region)) => self.cx.empty(region),
        }
    }

    /// The fields of the chart's struct, beside the recipe.
    pub(super) fn fields(&self) -> Vec<Field> {
        let p = &self.cx.p;
        let mut fields = Vec::new();
        fields.push_all(self.layout.flags.map(|flags| self.flags_field(flags)));
        for index in 0..self.program.places.len() {
            let place = PlaceId(index);
            let Slot { name, kind } = self.layout.slot(place);
            let (name, ty, align) = (name.clone(), self.ty(place), self.align(place));
            match kind {
                Kind::Field => fields.push(Field { name, ty, initial: self.initial(place), align }),
                Kind::Late => {
                    fields.push(Field { name, ty: quote!(#p::Option<#ty>), initial: quote!(#p::Option::None), align });
                }
                Kind::Marked => {
                    let (marked, initial) = (self.cx.names.marked(self.cx.plan), self.initial(place));
                    fields.push(Field {
                        name,
                        ty: marked.to_token_stream(),
                        initial: quote!(#marked::of(#initial)),
                        align,
                    });
                }
                Kind::Unused
                | Kind::Local
                | Kind::Asked
                | Kind::Result
                | Kind::Param
                | Kind::Unpacked
                | Kind::Unset(_)
                | Kind::Mark => {}
            }
        }
        fields
    }

    /// The fields with readings at which times began.
    pub(super) fn began(&self) -> Vec<Began> {
        let places = self.program.places.iter().zip(&self.layout.slots).enumerate();
        let began =
            |role| matches!(role, Role::Began(_) | Role::MacroBegan(_) | Role::DelayBegan(_) | Role::TimerBegan(..));
        places
            .filter(|(_, (place, slot))| began(place.role) && slot.kind == Kind::Field)
            .map(|(index, (_, slot))| self.began_at(PlaceId(index), slot.name.clone()))
            .list()
    }

    fn began_at(&self, began: PlaceId, name: Ident) -> Began {
        let (mut awaited, mut longest) = (Vec::new(), 0);
        if let Some(Deadline { at_once, reading, waits, .. }) = &self.program.deadline {
            if mentions(reading, began) {
                awaited.push(self.condition(at_once));
            }
            for Wait { condition, from, time } in waits {
                if *from == began || mentions(condition, began) || mentions(time, began) {
                    awaited.push(self.condition(condition));
                    longest = longest.max(longest_in(time));
                }
            }
        }
        let awaited = if awaited.is_empty() { quote!(false) } else { quote!(#((#awaited))||*) };
        Began { name, awaited, longest }
    }

    /// The declared types in fields.
    pub(super) fn stored(&self) -> Vec<&'m Ty> {
        let places = self.program.places.iter().zip(&self.layout.slots);
        let fields = places.filter(|(_, slot)| matches!(slot.kind, Kind::Field | Kind::Late));
        let types = fields.filter_map(|(place, _)| match place.ty {
            Type::User(ty) => Some(ty),
            _ => None,
        });
        types.list()
    }

    /// The state of a place that is named after a step.
    pub(super) fn state(&self, place: PlaceId, step: StepId) -> TokenStream {
        match self.info(place).ty {
            Type::State(region) => self.cx.variant_of(step, region),
            _ => self.cx.variant(step),
        }
    }

    /// The variant of a state.
    pub(super) fn variant(&self, step: Option<StepId>, region: usize) -> TokenStream {
        step.map_or_else(|| self.cx.empty(region), |step| self.cx.variant_of(step, region))
    }

    /// The variant for "the first cycle is still to come".
    pub(super) fn start(&self, region: usize) -> TokenStream {
        let (states, start) = (self.cx.names.region(region, self.cx.plan), &self.cx.names.start);
        quote!(#states::#start)
    }

    /// Whether two values of a place's type are the same, or differ.
    pub(super) fn compared(
        &self,
        place: PlaceId,
        one: &TokenStream,
        sign: &TokenStream,
        other: &TokenStream,
    ) -> TokenStream {
        match self.info(place).ty {
            Type::User(ty) => types::compare(ty, one, sign, other, &self.cx.p),
            _ => quote!(#one #sign #other),
        }
    }
}
