//! What is not followed from cycle to cycle, so that a way that relies on it may not exist.

use super::formula::{Atom, AtomId, Kind};
use super::links::Links;
use super::slots::Slots;
use crate::analysis::Union;
use crate::list::List;
use crate::model::{Arena, Association, Binary, Effect, Id, Model, Name, Read, Step, StepId, TransitionId, Tree};
use crate::sorted::Map;

/// Which atoms have values that nobody can choose freely: they depend on variables that are not followed, on Rust that is
/// not looked into, or on each other. Inputs can be anything in each cycle, and times count as unknown. Where numbers are
/// computed of inputs, it is tried whether there are some.
pub(crate) fn atoms(atoms: &Arena<AtomId, Atom>, links: &Links, presumed: &Arena<AtomId, bool>) -> Arena<AtomId, bool> {
    let own = own(atoms);
    let is_open = |atom: &Atom| is_open(atom, &own);
    Arena::of(atoms, |id, atom| {
        let can_be =
            if links.is_computed(id) { links.is_tried(id) } else { is_free(atom) || is_open(atom) && !presumed[id] };
        !can_be
    })
}

/// Which atoms ask Rust that is not looked into about inputs that nothing else reads, such as `near(level)`. Nobody knows whether
/// that has each of its values, so it proves nothing; but a way to what must not happen may presume it.
pub(crate) fn presumed(atoms: &Arena<AtomId, Atom>, links: &Links) -> Arena<AtomId, bool> {
    let own = own(atoms);
    let asks = |atom: &Atom| !is_free(atom) && is_open(atom, &own) && !is_looked_into(&atom.what);
    Arena::of(atoms, |id, atom| !links.is_computed(id) && asks(atom))
}

/// The inputs and params that only one of the atoms reads.
fn own(atoms: &Arena<AtomId, Atom>) -> impl Fn(&Name) -> bool {
    let mut readers: Map<Name, usize> = Map::new();
    for atom in atoms.values() {
        for name in names(&atom.what) {
            *readers.or_default(name) += 1;
        }
    }
    move |name: &Name| matches!(name, Name::Input(_) | Name::Param(_)) && readers.get(name) == Some(&1)
}

/// Which atoms have to do with those that are `unfollowed`, because both read an input or a param, or through others: such an
/// input cannot be chosen whatever they are.
pub(crate) fn bound(atoms: &Arena<AtomId, Atom>, unfollowed: &Arena<AtomId, bool>) -> Arena<AtomId, bool> {
    if !unfollowed.values().any(|is| *is) {
        return unfollowed.clone();
    }
    let mut union = Union::new(atoms.len());
    let mut reader: Map<Name, AtomId> = Map::new();
    for (id, atom) in atoms.iter() {
        for name in names(&atom.what) {
            if matches!(name, Name::Input(_) | Name::Param(_)) {
                let first = *reader.or_insert_with(name, || id);
                union.join(first.index(), id.index());
            }
        }
    }
    let mut is_root = vec![false; atoms.len()];
    for atom in atoms.ids().filter(|atom| unfollowed[*atom]) {
        is_root[union.root(atom.index())] = true;
    }
    Arena::of(unfollowed, |id, own| *own || is_root[union.root(id.index())])
}

/// The atoms that read an input which one of those `assumed` reads, too, of which nobody knows what it has to do with them;
/// by that one.
pub(crate) fn beside(
    atoms: &Arena<AtomId, Atom>,
    unfollowed: &Arena<AtomId, bool>,
    assumed: &[AtomId],
) -> Map<AtomId, Vec<AtomId>> {
    let mut beside: Map<AtomId, Vec<AtomId>> = Map::new();
    for atom in assumed.iter().filter(|atom| unfollowed[**atom]) {
        let own = names(&atoms[*atom].what);
        let shares = |name: &Name| own.contains(name);
        let others = atoms.ids().filter(|other| names(&atoms[*other].what).iter().any(shares));
        beside.insert(*atom, others.list());
    }
    beside
}

/// An input, a param, a time, or something that is followed.
fn is_free(atom: &Atom) -> bool {
    let free = matches!(
        atom.what,
        Tree::Read(Read::Name(Name::Input(_) | Name::Param(_)) | Read::Delay(_) | Read::Blink(_))
            | Tree::Elapsed(..)
            | Tree::MacroElapsed(..)
    );
    // How plain values compare is as free as they are: what does not go together is left out.
    let plain = |tree: &Tree| {
        matches!(
            tree,
            Tree::Read(
                Read::Name(Name::Input(_) | Name::Param(_)) | Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)
            )
        )
    };
    let compares = matches!(atom.kind, Kind::Number(..))
        && matches!(&atom.what, Tree::Binary(Binary::Lt, a, b) if plain(a) && plain(b));
    free || compares || atom.is_time || !matches!(atom.kind, Kind::Free | Kind::Number(..))
}

/// Whether it reads something of its `own` that can be chosen to suit, and nothing that is not followed.
fn is_open(atom: &Atom, own: &impl Fn(&Name) -> bool) -> bool {
    let mut known = true;
    atom.what.each_read(&mut |read| {
        known &= matches!(
            read,
            Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_) | Read::Since(_) | Read::MacroSince(_)
        );
    });
    known && names(&atom.what).iter().any(own)
}

fn is_looked_into(tree: &Tree) -> bool {
    match tree {
        Tree::Opaque { reads, call, open, .. } => call.is_none() && (*open || reads.is_empty()),
        Tree::Unary(_, inner) => is_looked_into(inner),
        Tree::Binary(_, a, b) => is_looked_into(a) && is_looked_into(b),
        _ => true,
    }
}

fn names(tree: &Tree) -> Vec<Name> {
    let mut names = Vec::new();
    tree.each_read(&mut |read| {
        if let Read::Name(name) = read {
            if !names.contains(&name) {
                names.push(name);
            }
        }
    });
    names
}

/// The steps and the transitions with stored actions that write what is not followed.
pub(crate) fn writers(model: &Model, slots: &Slots) -> (Arena<StepId, bool>, Arena<TransitionId, bool>) {
    let more = |effect: &Effect| effect.writes().iter().any(|place| !slots.numbers.contains_key(place));
    let stored = |association: &Association| !association.qualifier.is_continuous() && more(&association.effect);
    let of_step = |step: &Step| step.associations.iter().any(|id| stored(&model.associations[*id]));
    let steps = Arena::of(&model.steps, |_, step| of_step(step));
    (steps, Arena::of(&model.transitions, |_, transition| transition.clearing.iter().any(more)))
}
