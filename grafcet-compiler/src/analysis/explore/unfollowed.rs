//! What is not followed from cycle to cycle, so that a way that relies on it may not exist.

use super::formula::{Atom, Kind};
use super::slots::Slots;
use crate::list::List;
use crate::model::{Association, Binary, Effect, Model, Name, Read, Step, Tree};
use crate::sorted::Map;

/// Which atoms have values that nobody can choose freely: they depend on variables that are not followed, on Rust that is
/// not looked into, or on each other. Inputs can be anything in each cycle, and times count as unknown.
pub(super) fn atoms(atoms: &[Atom]) -> Vec<bool> {
    let mut readers: Map<Name, usize> = Map::new();
    for atom in atoms {
        for name in names(&atom.what) {
            *readers.or_default(name) += 1;
        }
    }
    let own = |name: &Name| matches!(name, Name::Input(_) | Name::Param(_)) && readers.get(name) == Some(&1);
    atoms.iter().map(|atom| !is_free(atom) && !is_open(atom, &own)).list()
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
pub(super) fn writers(model: &Model, slots: &Slots) -> (Vec<bool>, Vec<bool>) {
    let more = |effect: &Effect| effect.writes().iter().any(|place| !slots.numbers.contains_key(place));
    let stored = |association: &Association| !association.qualifier.is_continuous() && more(&association.effect);
    let of_step = |step: &Step| step.associations.iter().any(|id| stored(&model.associations[*id]));
    let steps = model.steps.values().map(of_step).list();
    (steps, model.transitions.values().map(|transition| transition.clearing.iter().any(more)).list())
}
