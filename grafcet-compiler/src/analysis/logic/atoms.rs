//! What conditions are functions of: the table of atoms of a chart.

use super::formula::AtomId;
use super::ranges::Ranges;
use crate::analysis::differences::FAR;
use crate::analysis::numbers::{domain, float, is_computed};
use crate::model::{Model, Name, Read, TimeRef, Tree, Ty};
use crate::sorted::Map;

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
    Before(AtomId),
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
    /// Arithmetic is in what it stands for.
    pub(super) is_computed: bool,
}

/// The atoms of a chart, each once.
#[derive(Default)]
pub(super) struct Atoms {
    all: Vec<Atom>,
    /// Sorted by what they stand for, which is large: there may be many, as each step of a circle has its own.
    booleans: Vec<AtomId>,
    numbers: Map<Tree, AtomId>,
    orders: Map<Tree, Map<Tree, AtomId>>,
    before: Map<AtomId, AtomId>,
}

impl Atoms {
    pub(super) fn get(&self, atom: AtomId) -> Option<&Atom> {
        self.all.get(atom as usize)
    }

    pub(super) fn boolean(&mut self, tree: &Tree) -> AtomId {
        let place = match self.booleans.binary_search_by(|known| self.stands_for(*known).cmp(&Some(tree))) {
            Ok(found) => return self.booleans[found],
            Err(place) => place,
        };
        let is_loose = !matches!(tree, Tree::Read(_));
        let atom = self.push(Key::Boolean(tree.clone()), Ranges::from_to(0, 1), is_loose, false, false);
        self.booleans.insert(place, atom);
        atom
    }

    fn stands_for(&self, boolean: AtomId) -> Option<&Tree> {
        match &self.get(boolean)?.key {
            Key::Boolean(tree) => Some(tree),
            _ => None,
        }
    }

    /// A number that is compared with constants.
    pub(super) fn number(&mut self, model: &Model, tree: &Tree) -> AtomId {
        if let Some(known) = self.numbers.get(tree) {
            return *known;
        }
        let is_float = float(model, tree).is_some();
        // What is no number at all (NaN) lies beyond all of them.
        let (low, high) = if is_float { (-FAR, FAR + 1) } else { domain(model, tree).unwrap_or((-FAR, FAR)) };
        let is_loose = !matches!(tree, Tree::Read(_));
        let computes = !is_float && is_computed(tree);
        let atom = self.push(Key::Number(tree.clone()), Ranges::from_to(low, high), is_loose, is_float, computes);
        self.numbers.insert(tree.clone(), atom);
        atom
    }

    /// How `a` compares with `b`, which stand in their order; of two floats one may be no number.
    pub(super) fn order(&mut self, a: &Tree, b: &Tree, total: bool) -> AtomId {
        if let Some(known) = self.orders.get(a).and_then(|with| with.get(b)) {
            return *known;
        }
        let is_loose = a.is_opaque() || b.is_opaque();
        let domain = Ranges::from_to(-1, if total { 1 } else { 2 });
        let computes = total && (is_computed(a) || is_computed(b));
        let atom = self.push(Key::Order(a.clone(), b.clone()), domain, is_loose, false, computes);
        self.orders.or_default(a.clone()).insert(b.clone(), atom);
        atom
    }

    /// What the atom was in the cycle before.
    pub(super) fn before(&mut self, atom: AtomId) -> AtomId {
        if let Some(known) = self.before.get(&atom) {
            return *known;
        }
        let Some(Atom { domain, is_loose, is_float, is_computed, .. }) = self.get(atom).cloned() else { return atom };
        let before = self.push(Key::Before(atom), domain, is_loose, is_float, is_computed);
        self.before.insert(atom, before);
        before
    }

    /// The values that an atom compares, in this cycle or in the one before, and those that they are computed of.
    pub(super) fn compared(&self, atom: AtomId) -> Vec<(Tree, bool)> {
        let (key, before) = match self.get(atom).map(|atom| &atom.key) {
            Some(Key::Before(of)) => (self.get(*of).map(|atom| &atom.key), true),
            key => (key, false),
        };
        let mut values = Vec::new();
        let trees = match key {
            Some(Key::Number(tree)) => [Some(tree), None],
            Some(Key::Order(a, b)) => [Some(a), Some(b)],
            _ => [None, None],
        };
        for tree in trees.into_iter().flatten() {
            values.push((tree.clone(), before));
            if is_computed(tree) {
                tree.each_read(&mut |read| values.push((Tree::Read(read), before)));
            }
        }
        values
    }

    fn push(&mut self, key: Key, domain: Ranges, is_loose: bool, is_float: bool, is_computed: bool) -> AtomId {
        self.all.push(Atom { key, domain, is_loose, is_float, is_computed });
        // A chart with 2^32 atoms does not fit into a source file.
        AtomId::try_from(self.all.len() - 1).unwrap_or(AtomId::MAX)
    }
}

pub(super) fn is_bool_name(model: &Model, name: Name) -> bool {
    matches!(model.ty(name), Ty::Bool(_))
}

/// A time that a name holds.
pub(super) fn time_tree(time: TimeRef) -> Tree {
    Tree::Read(match time {
        TimeRef::Ticks(ticks) => Read::Ticks(ticks),
        TimeRef::Param(id) => Read::Name(Name::Param(id)),
        TimeRef::Var(id) => Read::Name(Name::Var(id)),
    })
}
