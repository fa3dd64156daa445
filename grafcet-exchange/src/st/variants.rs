//! Listed variants, which structured text has as numbers: their places in the list.

use grafcet_compiler::model::{Model, Name, Tree, Variants};

use super::expr::plain;

/// Which number is which variant: `Off = 0, Auto = 1`; empty of what has none.
pub(crate) fn listed(model: &Model, name: Name) -> String {
    let Some(listed) = model.variants_of(name) else { return String::new() };
    let all = listed.list.iter().enumerate().map(|(place, variant)| format!("{} = {place}", plain(&variant.name)));
    all.collect::<Vec<_>>().join(", ")
}

/// Whether a number is the same variant in both.
pub(crate) fn same_list(one: &Variants, other: &Variants) -> bool {
    let ty = |listed: &Variants| listed.path.segments.last().map(|segment| segment.ident.to_string());
    let names = |listed: &Variants| listed.list.iter().map(|variant| plain(&variant.name)).collect::<Vec<_>>();
    ty(one) == ty(other) && names(one) == names(other)
}

/// The place of a variant that is named by its path.
pub(crate) fn listed_value(listed: &Variants, tree: &Tree) -> Option<usize> {
    let place = match tree {
        Tree::Int(place) => usize::try_from(*place).ok()?,
        Tree::Opaque { text, .. } => {
            let (path, last) = text.rsplit_once("::")?;
            let of = listed.path.segments.last()?.ident.to_string();
            let is_of = path.rsplit("::").next().is_some_and(|word| word.trim() == of);
            listed.list.iter().position(|variant| is_of && variant.name == last.trim())?
        }
        _ => return None,
    };
    (place < listed.list.len()).then_some(place)
}
