//! What conditions are functions of: the table of atoms of a chart.

use super::formula::AtomId;
use super::ranges::Ranges;
use crate::model::{Binary, Model, Name, Read, TimeRef, Tree, Ty};
use crate::sorted::Map;

/// Beyond this, constants of 128 bits leave no room to calculate.
pub(in crate::analysis) const FAR: i128 = i128::MAX / 4;

/// What an atom stands for.
#[derive(Clone, Debug)]
pub(super) enum Key {
    /// A boolean, 0 or 1: a name, a step variable, an edge, a delay, Rust that is not looked into.
    Boolean(Tree),
    /// A number: what comparisons with constants look at. Of a float the position among all floats.
    Number(Tree),
    /// How two values compare: -1 less, 0 equal, 1 greater, 2 none of these.
    Order(Tree, Tree),
    /// What another atom was in the cycle before, with which edges compare.
    Before,
}

/// One atom.
#[derive(Clone, Debug)]
pub(super) struct Atom {
    pub(super) key: Key,
    /// All values it can have by its type.
    pub(super) domain: Ranges,
    /// Nothing is known of its relation to other atoms.
    pub(super) is_loose: bool,
    /// A float, so that values are not numbers to be shown.
    pub(super) is_float: bool,
}

/// The atoms of a chart, each once.
#[derive(Default)]
pub(super) struct Atoms {
    all: Vec<Atom>,
    booleans: Map<Tree, AtomId>,
    numbers: Map<Tree, AtomId>,
    orders: Map<Tree, Map<Tree, AtomId>>,
    before: Map<AtomId, AtomId>,
}

impl Atoms {
    pub(super) fn get(&self, atom: AtomId) -> Option<&Atom> {
        self.all.get(atom as usize)
    }

    pub(super) fn boolean(&mut self, tree: &Tree) -> AtomId {
        if let Some(known) = self.booleans.get(tree) {
            return *known;
        }
        let is_loose = !matches!(tree, Tree::Read(_));
        let atom = self.push(Key::Boolean(tree.clone()), Ranges::from_to(0, 1), is_loose, false);
        self.booleans.insert(tree.clone(), atom);
        atom
    }

    /// A number that is compared with constants.
    pub(super) fn number(&mut self, model: &Model, tree: &Tree) -> AtomId {
        if let Some(known) = self.numbers.get(tree) {
            return *known;
        }
        let is_float = float(model, tree).is_some();
        // What is no number at all (NaN) lies beyond all of them.
        let (low, high) = if is_float { (-FAR, FAR + 1) } else { range(model, tree).unwrap_or((-FAR, FAR)) };
        let is_loose = !matches!(tree, Tree::Read(_));
        let atom = self.push(Key::Number(tree.clone()), Ranges::from_to(low, high), is_loose, is_float);
        self.numbers.insert(tree.clone(), atom);
        atom
    }

    /// How `a` compares with `b`, which stand in their order.
    pub(super) fn order(&mut self, model: &Model, a: &Tree, b: &Tree) -> AtomId {
        if let Some(known) = self.orders.get(a).and_then(|with| with.get(b)) {
            return *known;
        }
        let total = range(model, a).is_some() || range(model, b).is_some();
        let is_loose = a.is_opaque() || b.is_opaque();
        let domain = Ranges::from_to(-1, if total { 1 } else { 2 });
        let atom = self.push(Key::Order(a.clone(), b.clone()), domain, is_loose, false);
        self.orders.or_default(a.clone()).insert(b.clone(), atom);
        atom
    }

    /// What the atom was in the cycle before.
    pub(super) fn before(&mut self, atom: AtomId) -> AtomId {
        if let Some(known) = self.before.get(&atom) {
            return *known;
        }
        let Some(Atom { domain, is_loose, is_float, .. }) = self.get(atom).cloned() else { return atom };
        let before = self.push(Key::Before, domain, is_loose, is_float);
        self.before.insert(atom, before);
        before
    }

    fn push(&mut self, key: Key, domain: Ranges, is_loose: bool, is_float: bool) -> AtomId {
        self.all.push(Atom { key, domain, is_loose, is_float });
        // A chart with 2^32 atoms does not fit into a source file.
        AtomId::try_from(self.all.len() - 1).unwrap_or(AtomId::MAX)
    }
}

pub(super) fn is_bool_name(model: &Model, name: Name) -> bool {
    matches!(model.ty(name), Ty::Bool(_))
}

/// A floating-point type.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::analysis) enum Float {
    F32,
    F64,
}

/// The type of a name that is a float, or of arithmetic with one.
pub(in crate::analysis) fn float(model: &Model, tree: &Tree) -> Option<Float> {
    match tree {
        Tree::Read(Read::Name(name)) => match model.ty(*name) {
            Ty::Other(syn::Type::Path(path)) if path.path.is_ident("f32") => Some(Float::F32),
            Ty::Other(syn::Type::Path(path)) if path.path.is_ident("f64") => Some(Float::F64),
            _ => None,
        },
        Tree::Unary(_, inner) => float(model, inner),
        Tree::Binary(_, a, b) => float(model, a).or_else(|| float(model, b)),
        _ => None,
    }
}

/// The least and the greatest value of an integer expression or a time, by its type.
pub(super) fn range(model: &Model, tree: &Tree) -> Option<(i128, i128)> {
    let ticks = (0, i128::from(u32::MAX));
    match tree {
        Tree::Read(Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)) => Some(ticks),
        Tree::Read(Read::Name(name)) => match model.ty(*name) {
            Ty::Time(_) => Some(ticks),
            Ty::Int { signed, bits, rust } => {
                // On the host they have 64 bits, on the controller 32.
                let size =
                    matches!(rust, syn::Type::Path(path) if path.path.is_ident("usize") || path.path.is_ident("isize"));
                let bits = if size { 64 } else { *bits };
                Some(match (signed, bits) {
                    (true, 0..128) => (-(1 << (bits - 1)), (1 << (bits - 1)) - 1),
                    (false, 0..127) => (0, (1 << bits) - 1),
                    (true, _) => (-FAR, FAR),
                    (false, _) => (0, FAR),
                })
            }
            _ => None,
        },
        Tree::Unary(_, inner) => range(model, inner),
        Tree::Binary(Binary::Shl | Binary::Shr, a, _) => range(model, a),
        Tree::Binary(operator, a, b) if is_arithmetic(*operator) => range(model, a).or_else(|| range(model, b)),
        _ => None,
    }
}

fn is_arithmetic(operator: Binary) -> bool {
    use Binary::{Add, BitAnd, BitOr, BitXor, Div, Mul, Rem, Sub};
    matches!(operator, Add | Sub | Mul | Div | Rem | BitAnd | BitOr | BitXor)
}

/// A time that a name holds.
pub(super) fn time_tree(time: TimeRef) -> Tree {
    Tree::Read(match time {
        TimeRef::Ticks(ticks) => Read::Ticks(ticks),
        TimeRef::Param(id) => Read::Name(Name::Param(id)),
        TimeRef::Var(id) => Read::Name(Name::Var(id)),
    })
}
