//! Enums whose variants the chart does not list: `mode == Mode::Auto` and `mode == Mode::Manual` may hold together, for all that
//! is known. What would follow from a list, `mode: Mode in {…}`.

use super::{Condition, Logic};
use crate::list::{List, PushAll};
use crate::model::{Binary, Model, Name, Read, Tree, Ty, Unary};

/// More of them are not compared with each other.
const VARIANTS: usize = 40;

/// A value that is compared with several variants.
pub(crate) struct Unlisted {
    pub(crate) name: Name,
    /// They do not hold, if the list is what it seems to be.
    never: Vec<Condition>,
}

/// The values of the chart that are compared with variants of an enum that is not listed.
pub(crate) fn unlisted(model: &Model, logic: &Logic<'_>) -> Vec<Unlisted> {
    let mut compared: Vec<(Name, Vec<Tree>)> = Vec::new();
    for transition in model.transitions.values() {
        collect(model, &transition.condition.tree, &mut compared);
    }
    for association in model.associations.values() {
        for expr in association.condition.iter().and(&association.event) {
            collect(model, &expr.tree, &mut compared);
        }
    }
    compared.into_iter().map(|(name, variants)| Unlisted { name, never: never(logic, name, &variants) }).list()
}

/// The first such value that one of these trees compares.
pub(crate) fn unlisted_of(model: &Model, trees: &[Tree]) -> Option<Name> {
    let mut compared = Vec::new();
    for tree in trees {
        collect(model, tree, &mut compared);
    }
    compared.first().map(|(name, _)| *name)
}

impl Unlisted {
    /// Whether the conditions could not hold together, if the variants were listed.
    pub(crate) fn decides(&self, logic: &Logic<'_>, conditions: &[Condition]) -> bool {
        let goals = conditions.iter().map(|condition| (condition, true));
        let goals: Vec<_> = goals.and(self.never.iter().map(|never| (never, false))).list();
        logic.impossible(&goals)
    }
}

fn never(logic: &Logic<'_>, name: Name, variants: &[Tree]) -> Vec<Condition> {
    let of = |operator: Binary, variant: &Tree| {
        Tree::Binary(operator, Box::new(Tree::Read(Read::Name(name))), Box::new(variant.clone()))
    };
    let both = |a: Tree, b: Tree| logic.condition(&Tree::Binary(Binary::And, Box::new(a), Box::new(b)));
    let not = |tree: Tree| Tree::Unary(Unary::Not, Box::new(tree));
    let mut never = Vec::new();
    for (at, variant) in variants.iter().enumerate() {
        let (is, differs) = (of(Binary::Eq, variant), of(Binary::Ne, variant));
        never.push(both(is.clone(), differs.clone()));
        never.push(both(not(is.clone()), not(differs)));
        never.push_all(variants[..at].iter().map(|other| both(is.clone(), of(Binary::Eq, other))));
    }
    never
}

fn collect(model: &Model, tree: &Tree, compared: &mut Vec<(Name, Vec<Tree>)>) {
    match tree {
        Tree::Unary(_, inner) => collect(model, inner, compared),
        Tree::Binary(Binary::Eq | Binary::Ne, a, b) => {
            let (name, variant) = match (&**a, &**b) {
                (Tree::Read(Read::Name(name)), variant) | (variant, Tree::Read(Read::Name(name))) => (*name, variant),
                _ => return,
            };
            if !is_variant(model, name, variant) {
                return;
            }
            let at = compared.iter().position(|(other, _)| *other == name).unwrap_or(compared.len());
            if at == compared.len() {
                compared.push((name, Vec::new()));
            }
            let variants = &mut compared[at].1;
            if variants.len() < VARIANTS && !variants.contains(variant) {
                variants.push(variant.clone());
            }
        }
        Tree::Binary(_, a, b) => {
            collect(model, a, compared);
            collect(model, b, compared);
        }
        _ => {}
    }
}

/// Whether it looks like `Mode::Auto`, beside a value of type `Mode`.
fn is_variant(model: &Model, name: Name, tree: &Tree) -> bool {
    let (Tree::Opaque { text, .. }, Ty::Other(syn::Type::Path(ty))) = (tree, model.ty(name)) else { return false };
    let mut parts = text.rsplit("::").map(str::trim);
    let is_word = |part: &str| part.chars().all(|one| one == '_' || one.is_alphanumeric());
    let (Some(variant), Some(of), Some(last)) = (parts.next(), parts.next(), ty.path.segments.last()) else {
        return false;
    };
    model.variants_of(name).is_none() && is_word(variant) && last.ident == of
}
