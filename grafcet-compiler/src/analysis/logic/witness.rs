//! Values for which conditions hold, as the user would write them.

use super::atoms::{Atom, Atoms, Key};
use super::formula::AtomId;
use super::solve::Domains;
use crate::model::{Model, Name, Read, Tree};

/// The text of Rust that nobody wrote: a value of which nothing is known and nothing is said.
pub(in crate::analysis) const UNKNOWN: char = '\0';

/// `a = true, level = 7`; empty where every valuation will do. `asked` are the atoms in question, in order.
pub(super) fn text(model: &Model, atoms: &Atoms, asked: &[AtomId], found: &Domains) -> String {
    let mut parts: Vec<String> = Vec::new();
    for id in asked {
        let (Some(atom), Some(domain)) = (atoms.get(*id), found.get(id)) else { continue };
        if *domain == atom.domain || is_implied(atoms, atom, asked, found) {
            continue;
        }
        let Some(value) = domain.example() else { continue };
        let part = one(model, atom, value);
        if !part.contains(UNKNOWN) && !parts.contains(&part) {
            parts.push(part);
        }
    }
    parts.join(", ")
}

/// `Fill.X` beside a time of `Fill` goes without saying.
fn is_implied(atoms: &Atoms, atom: &Atom, asked: &[AtomId], found: &Domains) -> bool {
    let Key::Boolean(Tree::Read(active @ (Read::Active(_) | Read::MacroActive(_)))) = &atom.key else { return false };
    let is_since = |tree: &Tree| match (tree, active) {
        (Tree::Read(Read::Since(step)), Read::Active(other)) => step == other,
        (Tree::Read(Read::MacroSince(id)), Read::MacroActive(other)) => id == other,
        _ => false,
    };
    asked.iter().any(|id| match (atoms.get(*id).map(|atom| &atom.key), found.get(id)) {
        (Some(Key::Number(tree)), Some(domain)) => is_since(tree) && domain.within(1, i128::MAX) == Some(true),
        (Some(Key::Order(a, b)), Some(_)) => is_since(a) || is_since(b),
        _ => false,
    })
}

fn one(model: &Model, atom: &Atom, value: i128) -> String {
    match &atom.key {
        Key::Boolean(tree) => format!("{} = {}", model.tree_text(tree), value != 0),
        Key::Number(tree) if atom.is_float => {
            let size = f64::from_bits(u64::try_from(value.unsigned_abs()).unwrap_or(u64::MAX));
            format!("{} = {}", model.tree_text(tree), if value < 0 { -size } else { size })
        }
        Key::Number(tree) if model.variants_of_tree(tree).is_some() => {
            let variant = model.variants_of_tree(tree).map(|variants| variants.text(value, value));
            format!("{} = {}", model.tree_text(tree), variant.unwrap_or_default())
        }
        Key::Number(tree) if is_time(model, tree) => format!("{} = {}", model.tree_text(tree), model.time_text(value)),
        Key::Number(tree) => format!("{} = {value}", model.tree_text(tree)),
        // Nobody asks for what was.
        Key::Before(_) => UNKNOWN.to_string(),
        Key::Order(a, b) => {
            // `level < low`, not `low > level`: what changes stands first.
            let (a, b, value) = match a {
                Tree::Read(Read::Name(Name::Param(_))) if value <= 1 => (b, a, -value),
                _ => (a, b, value),
            };
            let sign = match value {
                -1 => "<",
                0 => "==",
                1 => ">",
                _ => "!=",
            };
            format!("{} {sign} {}", model.operand_text(a), model.operand_text(b))
        }
    }
}

fn is_time(model: &Model, tree: &Tree) -> bool {
    match tree {
        Tree::Read(Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)) => true,
        Tree::Read(Read::Name(name)) => model.is_time(*name),
        _ => false,
    }
}
