//! Numbers that are computed of each other: whether there are inputs with which they are as conditions have found them.

use super::knowledge::{Known, Learnt};
use crate::analysis::Union;
use crate::analysis::explore::net::formula::{Atom, AtomId, Kind};
use crate::analysis::explore::net::links::{Allowed, Difference};
use crate::analysis::numbers::{float, is_computed};
use crate::analysis::terms::{Demands, Terms, Told, integer};
use crate::list::List;
use crate::model::{Arena, Model, Name, Read, Tree};
use crate::sorted::Map;

/// What one question may cost, and how much is left to be spent on all of them.
const QUESTION: u64 = 600_000;
pub(crate) const ALL: u64 = 3_000_000;

/// Numbers of which some are computed of others.
#[derive(Debug, Default)]
pub(crate) struct Computed {
    atoms: Vec<AtomId>,
    terms: Terms,
    /// Atoms that compare a term with constants; and booleans that are computed with.
    numbers: Map<AtomId, usize>,
    /// How far a term lies above another.
    differences: Map<AtomId, (usize, usize)>,
    tried: Vec<AtomId>,
}

/// An atom with the one or two trees that it is about.
struct Subject<'a> {
    atom: AtomId,
    trees: [Option<&'a Tree>; 2],
}

impl Computed {
    /// The groups of atoms that have to do with each other by what is computed.
    pub(crate) fn all(
        model: &Model,
        atoms: &Arena<AtomId, Atom>,
        differences: &[Difference],
        numbers: &Map<Tree, AtomId>,
    ) -> Vec<Self> {
        let mut subjects: Vec<Subject<'_>> = Vec::new();
        let mut is_difference = Arena::filled(atoms.len(), false);
        for Difference { atom, a, b, is_float } in differences {
            is_difference[*atom] = true;
            if !is_float {
                subjects.push(Subject { atom: *atom, trees: [Some(&a.tree), Some(&b.tree)] });
            }
        }
        for (number, atom) in atoms.iter() {
            let is_number = matches!(atom.kind, Kind::Number(..) | Kind::Since(_) | Kind::MacroSince(_));
            let is_float = float(model, &atom.what).is_some();
            if is_number && !is_difference[number] && !is_float {
                subjects.push(Subject { atom: number, trees: [Some(&atom.what), None] });
            }
        }
        if !subjects.iter().any(|subject| subject.trees.iter().flatten().any(|tree| is_computed(tree))) {
            return Vec::new();
        }
        let mut terms = Terms::default();
        let of: Vec<Vec<usize>> = subjects.iter().map(|subject| subject.add(model, &mut terms)).list();
        let mut union = Union::new(terms.len());
        for term in 0..terms.len() {
            for operand in terms.operands(term).into_iter().filter(|operand| !terms.is_constant(*operand)) {
                union.join(term, operand);
            }
        }
        for pair in &of {
            if let [a, b] = pair[..] {
                if !terms.is_constant(a) && !terms.is_constant(b) {
                    union.join(a, b);
                }
            }
        }
        let mut members: Map<usize, Vec<usize>> = Map::new();
        for (subject, terms_of) in of.iter().enumerate() {
            if let Some(root) = terms_of.iter().find(|term| !terms.is_constant(**term)) {
                members.or_default(union.root(*root)).push(subject);
            }
        }
        let groups = members.into_iter().map(|(_, members)| Self::group(model, &subjects, &members, numbers));
        groups.filter(|group| group.terms.is_computed()).list()
    }

    fn group(model: &Model, subjects: &[Subject<'_>], members: &[usize], numbers: &Map<Tree, AtomId>) -> Self {
        let mut group = Self::default();
        for subject in members.iter().map(|member| &subjects[*member]) {
            group.atoms.push(subject.atom);
            match subject.add(model, &mut group.terms)[..] {
                [a, b] => _ = group.differences.insert(subject.atom, (a, b)),
                [a] => _ = group.numbers.insert(subject.atom, a),
                _ => {}
            }
        }
        let can_be_chosen = group.terms.all_of(can_be_chosen);
        let chosen = |tree: &&Tree| is_time(tree) || group.terms.of(tree, false).is_none_or(|term| can_be_chosen[term]);
        for subject in members.iter().map(|member| &subjects[*member]) {
            if subject.trees.iter().flatten().all(chosen) {
                group.tried.push(subject.atom);
            }
        }
        // Booleans that are computed with.
        for (tree, term) in group.terms.leaves() {
            if let Some(atom) = numbers.get(tree).filter(|atom| !group.atoms.contains(atom)) {
                group.atoms.push(*atom);
                group.numbers.insert(*atom, term);
            }
        }
        group
    }

    pub(crate) fn atoms(&self) -> &[AtomId] {
        &self.atoms
    }

    /// The atoms that are about inputs and params alone.
    pub(crate) fn tried(&self) -> impl Iterator<Item = AtomId> + '_ {
        self.tried.iter().copied()
    }

    /// Whether there are values with which all this is known.
    pub(crate) fn allows(&self, known: &Learnt, left: &mut u64) -> Allowed {
        let mut demands = Demands::default();
        for (atom, known) in known {
            let span = match known {
                Known::Unknown => continue,
                Known::Bool(value) => (i128::from(*value), i128::from(*value)),
                Known::Range(low, high) => (*low, *high),
            };
            if let Some(term) = self.numbers.get(atom) {
                demands.spans.push((*term, span));
            }
            if let Some((a, b)) = self.differences.get(atom) {
                demands.differences.push((*a, *b, span));
            }
        }
        let mut question = QUESTION.min(*left);
        let before = question;
        let told = self.terms.told(&demands, &mut question);
        *left -= before - question;
        match told {
            Told::Impossible => Allowed::No,
            Told::Possible(_) => Allowed::Yes,
            Told::Unclear => Allowed::Unclear,
        }
    }
}

impl Subject<'_> {
    fn add(&self, model: &Model, terms: &mut Terms) -> Vec<usize> {
        let ty = self.trees.iter().flatten().find_map(|tree| integer(model, tree));
        self.trees.iter().flatten().map(|tree| terms.add(model, tree, ty, false)).list()
    }
}

/// The time of a step as it stands: it counts as unknown, and where it is zero that is seen to elsewhere.
fn is_time(tree: &Tree) -> bool {
    matches!(tree, Tree::Read(Read::Since(_) | Read::MacroSince(_)))
}

/// An input or a param.
fn can_be_chosen(tree: &Tree) -> bool {
    matches!(tree, Tree::Read(Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_)))
}
