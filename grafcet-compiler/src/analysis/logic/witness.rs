//! Values for which conditions hold, as the user would write them.

use super::atoms::{Atom, Atoms, Key};
use super::formula::AtomId;
use super::solve::Domains;
use crate::model::{Binary, Model, Name, Read, TimeRef, Tree, Unary};

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
        Key::Boolean(tree) => format!("{} = {}", written(model, tree), value != 0),
        Key::Number(tree) if atom.is_float => {
            let size = f64::from_bits(u64::try_from(value.unsigned_abs()).unwrap_or(u64::MAX));
            format!("{} = {}", written(model, tree), if value < 0 { -size } else { size })
        }
        Key::Number(tree) if model.variants_of_tree(tree).is_some() => {
            let variant = model.variants_of_tree(tree).map(|variants| variants.text(value, value));
            format!("{} = {}", written(model, tree), variant.unwrap_or_default())
        }
        Key::Number(tree) if is_time(model, tree) => format!("{} = {}", written(model, tree), model.time_text(value)),
        Key::Number(tree) => format!("{} = {value}", written(model, tree)),
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
            format!("{} {sign} {}", operand(model, a), operand(model, b))
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

/// The tree as the user would write it.
fn written(model: &Model, tree: &Tree) -> String {
    match tree {
        Tree::Bool(value) => value.to_string(),
        Tree::Int(value) => value.to_string(),
        Tree::Read(read) => read_text(model, *read),
        Tree::Elapsed(time, step) => format!("{}/{}", time_text(model, *time), model.steps[*step].name),
        Tree::MacroElapsed(time, id) => format!("{}/{}", time_text(model, *time), model.macros[*id].name),
        Tree::Unary(operator, inner) => {
            let sign = if *operator == Unary::Not { "!" } else { "-" };
            format!("{sign}{}", operand(model, inner))
        }
        Tree::Binary(operator, a, b) if model.variant_text(a, b).is_some() => {
            format!("{} {} {}", operand(model, a), sign(*operator), model.variant_text(a, b).unwrap_or_default())
        }
        Tree::Binary(operator, a, b) => format!("{} {} {}", operand(model, a), sign(*operator), operand(model, b)),
        Tree::Opaque { text, .. } => text.clone(),
    }
}

fn operand(model: &Model, tree: &Tree) -> String {
    let text = written(model, tree);
    if matches!(tree, Tree::Binary(..)) { format!("({text})") } else { text }
}

fn read_text(model: &Model, read: Read) -> String {
    match read {
        Read::Name(name) => model.value_name(name).to_string(),
        Read::Active(step) => format!("{}.X", model.steps[step].name),
        Read::Since(step) => format!("{}.T", model.steps[step].name),
        Read::MacroActive(id) => format!("{}.X", model.macros[id].name),
        Read::MacroSince(id) => format!("{}.T", model.macros[id].name),
        Read::Rising(id) => format!("rising({})", model.edges[id].of.text),
        Read::Falling(id) => format!("falling({})", model.edges[id].of.text),
        Read::Delay(id) => {
            let delay = &model.delays[id];
            let of = if delay.of.text.contains(' ') { format!("({})", delay.of.text) } else { delay.of.text.clone() };
            match delay.off {
                TimeRef::Ticks(0) => format!("{}/{of}", time_text(model, delay.on)),
                off => format!("{}/{of}/{}", time_text(model, delay.on), time_text(model, off)),
            }
        }
        Read::Ticks(ticks) => model.time_text(i128::from(ticks)),
        Read::Elapsed(time, step) => format!("{}/{}", time_text(model, time), model.steps[step].name),
        Read::MacroElapsed(time, id) => format!("{}/{}", time_text(model, time), model.macros[id].name),
        Read::Blink(blink) => model.blink_text(blink),
    }
}

fn time_text(model: &Model, time: TimeRef) -> String {
    match time {
        TimeRef::Ticks(ticks) => model.time_text(i128::from(ticks)),
        TimeRef::Param(id) => model.value_name(Name::Param(id)).to_string(),
        TimeRef::Var(id) => model.value_name(Name::Var(id)).to_string(),
    }
}

fn sign(operator: Binary) -> &'static str {
    match operator {
        Binary::And => "&&",
        Binary::Or => "||",
        Binary::BitAnd => "&",
        Binary::BitOr => "|",
        Binary::BitXor => "^",
        Binary::Eq => "==",
        Binary::Ne => "!=",
        Binary::Lt => "<",
        Binary::Le => "<=",
        Binary::Gt => ">",
        Binary::Ge => ">=",
        Binary::Add => "+",
        Binary::Sub => "-",
        Binary::Mul => "*",
        Binary::Div => "/",
        Binary::Rem => "%",
        Binary::Shl => "<<",
        Binary::Shr => ">>",
    }
}
