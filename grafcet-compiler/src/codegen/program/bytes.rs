//! What the fields of a chart take, as far as that is known.

use super::layout::{Kind, Slot, States};
use crate::codegen::{Cx, types};
use crate::model::Ty;
use crate::program::{PlaceInfo, Program, Role, Type};

/// What a field takes, and what its address is a multiple of.
#[derive(Clone, Copy)]
pub(super) struct Bytes {
    pub(super) size: usize,
    pub(super) align: u8,
}

impl Bytes {
    fn of(number: u8) -> Self {
        Self { size: number.into(), align: number }
    }

    /// Of a place that is a field; `number` is the size of the number of an association.
    pub(super) fn of_field(
        cx: &Cx<'_>,
        program: &Program<'_>,
        (info, kind): (&PlaceInfo<'_>, Kind),
        (regions, number): (&[States], u8),
    ) -> Option<Self> {
        // A search that did not become stable is marked by a bit above the state.
        let limit = if kind == Kind::Marked { 0x80 } else { 0x100 };
        let of_count = |count: usize| Some(Self::of(if count <= limit { 1 } else { 2 }));
        let own = match (info.ty, declared(cx, info)) {
            (Type::User(ty), _) | (_, Some(ty)) => types::align(ty).map(Self::of),
            (Type::Bool, _) => Some(Self::of(1)),
            (Type::Ticks, _) => Some(Self::of(4)),
            (Type::State(region), _) => {
                let States { empty, start } = regions[region];
                of_count(program.states(region).len() + usize::from(empty) + usize::from(start.is_some()))
            }
            (Type::Number, _) => Some(Self::of(number)),
            (Type::Kind { count, .. }, _) => usize::try_from(count).ok().and_then(of_count),
        }?;
        // Whether there is a value already takes as much again, but for a truth, which has values left.
        let is_twice = kind == Kind::Late && !matches!(info.ty, Type::Bool);
        Some(Self { size: if is_twice { 2 * own.size } else { own.size }, ..own })
    }
}

/// The type with which an output or a variable is declared.
pub(super) fn declared<'m>(cx: &Cx<'m>, info: &PlaceInfo<'_>) -> Option<&'m Ty> {
    match info.role {
        Role::Output(id) => Some(&cx.model.outputs[id].ty),
        Role::Var(id) => Some(&cx.model.vars[id].ty),
        _ => None,
    }
}

/// Whether the struct of these fields, and of the recipe, ends with a byte that none of them needs, where words are aligned.
pub(super) fn is_one_left(
    cx: &Cx<'_>,
    program: &Program<'_>,
    slots: &[Slot],
    (regions, number): (&[States], u8),
) -> bool {
    let mut fields = Vec::new();
    for (info, slot) in program.places.iter().zip(slots) {
        if matches!(slot.kind, Kind::Field | Kind::Late | Kind::Marked) {
            fields.push(Bytes::of_field(cx, program, (info, slot.kind), (regions, number)));
        }
    }
    let params: Option<Vec<Bytes>> =
        cx.model.params.values().map(|param| types::align(&param.ty).map(Bytes::of)).collect();
    fields.push(
        params.and_then(|params| if params.is_empty() { Some(Bytes { size: 0, align: 1 }) } else { sum(&params) }),
    );
    let fields: Option<Vec<Bytes>> = fields.into_iter().collect();
    let Some(fields) = fields else { return false };
    let size: usize = fields.iter().map(|field| field.size).sum();
    sum(&fields).is_some_and(|all| size < all.size)
}

/// What a struct of them takes. The size of a `usize` differs from machine to machine, and so does the alignment of 128 bits.
fn sum(fields: &[Bytes]) -> Option<Bytes> {
    let align = fields.iter().map(|field| field.align).max()?;
    let is_known = fields.iter().all(|field| matches!(field.align, 1 | 2 | 4 | 8));
    let size: usize = fields.iter().map(|field| field.size).sum();
    is_known.then(|| Bytes { size: size.next_multiple_of(align.into()), align })
}
