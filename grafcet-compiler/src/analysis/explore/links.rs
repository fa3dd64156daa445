//! Numbers that are compared with each other as well as with constants: what is known of them has to go together.

use super::formula::{Atom, Kind};
use super::knowledge::{Knowledge, Known};
use super::scene::Scene;
use crate::analysis::Union;
use crate::analysis::differences::Differences;
use crate::list::List;
use crate::model::Tree;
use crate::sorted::Map;

/// How far a number lies above another, as an atom.
#[derive(Debug)]
pub(super) struct Difference {
    pub(super) atom: usize,
    pub(super) a: Operand,
    pub(super) b: Operand,
}

/// One of the two numbers.
#[derive(Clone, Debug)]
pub(super) struct Operand {
    pub(super) tree: Tree,
    pub(super) range: (i128, i128),
}

/// Which atoms are about the same numbers.
#[derive(Debug, Default)]
pub(super) struct Links {
    groups: Vec<Group>,
    /// Per atom the group, where what is known of it says something about others.
    group_of: Vec<Option<usize>>,
    /// The two times or numbers of a difference in which a time has part, by atom.
    times: Map<usize, (usize, usize)>,
}

#[derive(Debug, Default)]
struct Group {
    atoms: Vec<usize>,
    /// Each number with the atom that compares it with constants.
    numbers: Vec<(Option<usize>, (i128, i128))>,
    differences: Vec<(usize, usize, usize)>,
}

impl Links {
    /// `numbers` are the atoms that compare a number with constants, by number.
    pub(super) fn of(atoms: &[Atom], differences: &[Difference], numbers: &Map<Tree, usize>) -> Self {
        let mut links = Self { group_of: vec![None; atoms.len()], ..Self::default() };
        let mut known: Map<&Tree, usize> = Map::new();
        let mut all: Vec<&Operand> = Vec::new();
        let mut pairs: Vec<(usize, usize, usize)> = Vec::new();
        for Difference { atom, a, b } in differences {
            let [a, b] = [a, b].map(|operand| {
                *known.or_insert_with(&operand.tree, || {
                    all.push(operand);
                    all.len() - 1
                })
            });
            pairs.push((*atom, a, b));
        }
        let number = |operand: &Operand| numbers.get(&operand.tree).copied();
        let mut union = Union::new(all.len());
        for (atom, a, b) in &pairs {
            union.join(*a, *b);
            if let (Some(first), Some(second)) = (number(all[*a]), number(all[*b])) {
                if is_time(&atoms[first]) || is_time(&atoms[second]) {
                    links.times.insert(*atom, (first, second));
                }
            }
        }
        let mut groups: Map<usize, (Group, Vec<usize>)> = Map::new();
        for (position, operand) in all.iter().enumerate() {
            let (group, members) = groups.or_default(union.root(position));
            group.numbers.push((number(operand), operand.range));
            group.atoms.extend(number(operand));
            members.push(position);
        }
        for (atom, a, b) in &pairs {
            let (group, members) = groups.or_default(union.root(*a));
            let at = |of: usize| members.iter().position(|member| *member == of).unwrap_or(0);
            let pair = (*atom, at(*a), at(*b));
            group.atoms.push(*atom);
            group.differences.push(pair);
        }
        links.groups = groups.into_iter().map(|(_, (group, _))| group).filter(Group::is_tied).list();
        for (number, group) in links.groups.iter().enumerate() {
            for atom in &group.atoms {
                links.group_of[*atom] = Some(number);
            }
        }
        links
    }

    /// The atoms of which something may follow from what is known of this one; itself is among them.
    pub(super) fn with(&self, atom: usize) -> &[usize] {
        self.group_of[atom].map_or(&[], |group| &self.groups[group].atoms)
    }

    /// The two atoms behind a difference in which a time has part.
    pub(super) fn times(&self, atom: usize) -> Option<(usize, usize)> {
        self.times.get(&atom).copied()
    }

    /// Whether there are numbers of which all this is true.
    fn allow(&self, knowledge: &Knowledge) -> bool {
        let mut asked: Vec<usize> = knowledge.learnt().iter().filter_map(|atom| self.group_of[*atom]).list();
        asked.sort_unstable();
        asked.dedup();
        asked.into_iter().all(|group| self.groups[group].allows(knowledge))
    }
}

impl Group {
    /// Whether more is to be said than that each comparison can have any outcome: numbers whose comparisons form no circle
    /// and have no limits lie as one wants them.
    fn is_tied(&self) -> bool {
        let count = self.numbers.len();
        let width = |(low, high): &(i128, i128)| high.saturating_sub(*low);
        let is_narrow = |(_, range): &(Option<usize>, (i128, i128))| width(range) < 2 * count as i128;
        self.differences.len() >= count
            || self.numbers.iter().any(|(number, _)| number.is_some())
            || self.numbers.iter().any(is_narrow)
            || self.numbers.iter().any(|(_, range)| *range != self.numbers[0].1)
    }

    fn allows(&self, knowledge: &Knowledge) -> bool {
        let mut all = Differences::new(self.numbers.len());
        for (atom, a, b) in &self.differences {
            if let Known::Range(low, high) = knowledge.get(*atom) {
                all.within(a + 1, b + 1, (low, high));
            }
        }
        if all.len() == 0 {
            return true;
        }
        for (index, (atom, range)) in self.numbers.iter().enumerate() {
            let known = atom.map(|atom| knowledge.get(atom));
            let (low, high) = if let Some(Known::Range(low, high)) = known { (low, high) } else { *range };
            all.within(index + 1, 0, (low, high));
        }
        all.is_possible()
    }
}

fn is_time(atom: &Atom) -> bool {
    matches!(atom.kind, Kind::Since(_) | Kind::MacroSince(_))
}

impl Scene<'_> {
    /// Whether what has been decided about numbers goes together, in this cycle and in the one before.
    pub(super) fn goes_together(&self) -> bool {
        let (given, recorded) = self.knowledge();
        self.net.links.allow(given) && self.net.links.allow(recorded)
    }
}
