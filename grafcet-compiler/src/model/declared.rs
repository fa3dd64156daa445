//! What a chart declares beside its steps: signals, the recipe, named conditions, code actions; and the types of these.

use proc_macro2::Span;
use syn::{Attribute, Ident};

use super::{Expr, LevelAttr, Name, Variant};
use crate::list::List;

/// `mode: Mode in {Off, Auto, Manual}`: in the trees of expressions a variant is its place in the list.
pub struct Variants {
    /// The values.
    pub names: Vec<Name>,
    /// Of the type, without arguments.
    pub path: syn::Path,
    pub list: Vec<Variant>,
    /// Other paths by which comparisons name the type.
    pub others: Vec<syn::Path>,
    /// A variant with which `==` compares.
    pub compared: Option<usize>,
}

/// A declared type.
#[derive(Clone)]
pub enum Ty {
    Bool(syn::Type),
    /// A primitive integer: `i16` is `{ signed: true, bits: 16 }`; `isize`/`usize` count as 32 bits.
    Int {
        signed: bool,
        bits: u32,
        rust: syn::Type,
    },
    /// The keyword `time`: `Ticks`.
    Time(Span),
    /// Any other Rust type.
    Other(syn::Type),
}

/// `input on: bool;`
pub struct Input {
    pub name: Ident,
    pub attrs: Vec<Attribute>,
    pub levels: Vec<LevelAttr>,
    pub ty: Ty,
}

/// `output speed: u16 = 0;`
pub struct Output {
    pub name: Ident,
    pub attrs: Vec<Attribute>,
    pub levels: Vec<LevelAttr>,
    pub ty: Ty,
    /// A constant expression; none is `Default`.
    pub init: Option<Expr>,
}

/// `var count: u16 = 0;`
pub struct Var {
    pub name: Ident,
    pub attrs: Vec<Attribute>,
    pub levels: Vec<LevelAttr>,
    pub ty: Ty,
    pub init: Option<Expr>,
}

/// `param soak: time in 1s..10s = 5s;`
pub struct Param {
    pub name: Ident,
    pub attrs: Vec<Attribute>,
    pub levels: Vec<LevelAttr>,
    pub ty: Ty,
    pub init: Option<Expr>,
    /// What it never leaves; one of the [assumptions](super::Model::assumptions) says the same.
    pub range: Option<Range>,
}

/// `1s..10s`: from the lowest value to the highest, both in it; times in ticks.
#[derive(Clone)]
pub struct Range {
    pub low: i128,
    pub high: i128,
    /// As it is written.
    pub text: String,
}

/// `let go = auto || rising(next);` Expressions that use it hold what it stands for.
pub struct Let {
    pub name: Ident,
    pub levels: Vec<LevelAttr>,
    /// The first paragraph of its doc comment.
    pub doc: String,
    /// What it stands for, as written.
    pub text: String,
    /// The values in it, used or not.
    pub mentions: Vec<Name>,
    /// An expression that is no unused `let` uses it.
    pub used: bool,
}

/// `action heat(setpoint: i16);`
pub struct Action {
    pub name: Ident,
    pub attrs: Vec<Attribute>,
    pub levels: Vec<LevelAttr>,
    pub params: Vec<(Ident, Ty)>,
}

impl Variants {
    /// Some of them, by their places in the list: `Auto`, `Off or Auto`.
    #[must_use]
    pub fn text(&self, low: i128, high: i128) -> String {
        let all = self.list.iter().zip(0i128..).filter(|(_, place)| (low..=high).contains(place));
        all.map(|(variant, _)| variant.name.to_string()).list().join(" or ")
    }

    /// The place in the list of a variant that is written as a path, `Mode::Auto`.
    #[must_use]
    pub fn place_of(&self, path: &str) -> Option<usize> {
        let (ty, name) = path.rsplit_once("::")?;
        let ty = ty.rsplit("::").next()?.trim();
        let same = self.path.segments.last().is_some_and(|segment| segment.ident == ty);
        let name = name.trim();
        self.list.iter().position(|variant| same && !variant.has_data && variant.name == name)
    }

    /// The first and the last place in the list.
    #[must_use]
    pub fn range(&self) -> (i128, i128) {
        (0, i128::try_from(self.list.len()).unwrap_or(i128::MAX) - 1)
    }
}

impl Ty {
    /// `f32` or `f64`.
    #[must_use]
    pub fn is_float(&self) -> bool {
        let Self::Other(syn::Type::Path(path)) = self else { return false };
        path.path.is_ident("f32") || path.path.is_ident("f64")
    }
}
