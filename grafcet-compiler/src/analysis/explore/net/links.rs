//! Numbers that are compared with each other as well as with constants, or computed of each other: what is known of them has to
//! go together.

use std::collections::BTreeMap;

use super::formula::{Atom, AtomId, Kind};
use crate::analysis::Union;
use crate::analysis::differences::{Differences, FAR};
use crate::analysis::explore::valuation::Valuation;
use crate::analysis::explore::valuation::computed::Computed;
use crate::analysis::explore::valuation::knowledge::{Knowledge, Known, Learnt};
use crate::analysis::numbers::is_computed;
use crate::list::{List, PushAll};
use crate::model::{Arena, Binary, Model, Tree, ids};
use crate::sorted::{Map, sort, sort_unstable};

ids! {
    /// Atoms that are about the same numbers.
    pub(crate) GroupId;
}

/// How far a number lies above another, as an atom.
#[derive(Debug)]
pub(crate) struct Difference {
    pub(crate) atom: AtomId,
    pub(crate) a: Operand,
    pub(crate) b: Operand,
    /// Of two floats, which may be no numbers: then it lies beyond all others.
    pub(crate) is_float: bool,
}

/// One of the two numbers.
#[derive(Clone, Debug)]
pub(crate) struct Operand {
    pub(crate) tree: Tree,
    pub(crate) range: (i128, i128),
}

/// Which atoms are about the same numbers.
#[derive(Debug, Default)]
pub(crate) struct Links {
    groups: Arena<GroupId, Group>,
    /// Per atom the group, where what is known of it says something about others.
    group_of: Arena<AtomId, Option<GroupId>>,
    /// The two times or numbers of a difference in which a time has part, by atom.
    times: Map<AtomId, (AtomId, AtomId)>,
    /// Per atom whether it is computed of inputs and params, so that it is tried whether there are some.
    tried: Arena<AtomId, bool>,
    /// Per atom whether arithmetic is in it.
    computed: Arena<AtomId, bool>,
}

#[derive(Debug)]
enum Group {
    Compared(Compared),
    Computed(Computed),
}

/// Numbers that are compared.
#[derive(Debug, Default)]
struct Compared {
    atoms: Vec<AtomId>,
    /// Each number with the atom that compares it with constants.
    numbers: Vec<(Option<AtomId>, (i128, i128))>,
    differences: Vec<(AtomId, usize, usize)>,
    is_float: bool,
}

/// Whether there are numbers of which all is true that is known.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Allowed {
    No,
    /// It was not decided, or only without what a result makes that does not fit into its type.
    Unclear,
    Yes,
}

/// The answers about groups in which something is computed.
pub(crate) type Tries = BTreeMap<(GroupId, Learnt), Allowed>;

impl Links {
    /// `numbers` are the atoms that compare a number with constants, by number.
    pub(crate) fn of(
        model: &Model,
        atoms: &Arena<AtomId, Atom>,
        differences: &[Difference],
        numbers: &Map<Tree, AtomId>,
    ) -> Self {
        let computes = |atom: &Atom| match &atom.what {
            Tree::Binary(Binary::Lt, a, b) => is_computed(a) || is_computed(b),
            tree => is_computed(tree) && matches!(atom.kind, Kind::Number(..)),
        };
        let mut links = Self {
            group_of: Arena::filled(atoms.len(), None),
            tried: Arena::filled(atoms.len(), false),
            computed: Arena::of(atoms, |_, atom| computes(atom)),
            ..Self::default()
        };
        for Difference { atom, a, b, .. } in differences {
            if let (Some(a), Some(b)) = (numbers.get(&a.tree), numbers.get(&b.tree)) {
                if is_time(&atoms[*a]) || is_time(&atoms[*b]) {
                    links.times.insert(*atom, (*a, *b));
                }
            }
        }
        for computed in Computed::all(model, atoms, differences, numbers) {
            computed.tried().for_each(|atom| links.tried[atom] = true);
            links.add(Group::Computed(computed));
        }
        let compared: Vec<&Difference> =
            differences.iter().filter(|difference| links.group_of[difference.atom].is_none()).list();
        for compared in Compared::all(&compared, numbers) {
            if compared.is_tied() {
                links.add(Group::Compared(compared));
            }
        }
        links
    }

    fn add(&mut self, group: Group) {
        let number = self.groups.push(group);
        for atom in self.groups[number].atoms() {
            self.group_of[*atom] = Some(number);
        }
    }

    /// The atoms of which something may follow from what is known of this one; itself is among them.
    pub(crate) fn with(&self, atom: AtomId) -> &[AtomId] {
        self.group_of[atom].map_or(&[], |group| self.groups[group].atoms())
    }

    /// The two atoms after a difference in which a time has part.
    pub(crate) fn times(&self, atom: AtomId) -> Option<(AtomId, AtomId)> {
        self.times.get(&atom).copied()
    }

    /// Whether anything is computed.
    pub(crate) fn any_computed(&self) -> bool {
        self.groups.values().any(|group| matches!(group, Group::Computed(_)))
    }

    /// Whether there is arithmetic in an atom.
    pub(crate) fn is_computed(&self, atom: AtomId) -> bool {
        self.computed[atom]
    }

    /// Whether an atom is computed of nothing but what can be chosen: where that was, it was tried.
    pub(crate) fn is_tried(&self, atom: AtomId) -> bool {
        self.tried[atom]
    }

    /// Whether there are numbers of which all this is true; `unclear` are the atoms of which that is not known.
    fn allow(&self, knowledge: &Knowledge, tries: &mut Tries, left: &mut u64, unclear: &mut Vec<AtomId>) -> bool {
        if self.groups.is_empty() {
            return true;
        }
        let mut asked: Vec<GroupId> = knowledge.learnt().iter().filter_map(|atom| self.group_of[*atom]).list();
        sort_unstable(&mut asked);
        asked.dedup();
        for number in asked {
            let allowed = match &self.groups[number] {
                Group::Compared(compared) if compared.allows(knowledge) => Allowed::Yes,
                Group::Compared(_) => Allowed::No,
                Group::Computed(computed) => {
                    let mut known = Learnt::new();
                    for atom in knowledge.learnt() {
                        if self.group_of[*atom] == Some(number) && knowledge.get(*atom) != Known::Unknown {
                            known.push((*atom, knowledge.get(*atom)));
                        }
                    }
                    sort(&mut known);
                    known.dedup();
                    let key = (number, known);
                    match tries.get(&key) {
                        Some(allowed) => *allowed,
                        None => {
                            let allowed = computed.allows(&key.1, left);
                            tries.insert(key, allowed);
                            allowed
                        }
                    }
                }
            };
            match allowed {
                Allowed::Yes => {}
                Allowed::No => return false,
                Allowed::Unclear => {
                    let of_group = |atom: &&AtomId| self.group_of[**atom] == Some(number);
                    unclear.extend(knowledge.learnt().iter().filter(of_group));
                }
            }
        }
        true
    }
}

impl Group {
    fn atoms(&self) -> &[AtomId] {
        match self {
            Self::Compared(compared) => &compared.atoms,
            Self::Computed(computed) => computed.atoms(),
        }
    }
}

impl Compared {
    /// The numbers that are compared with each other, directly or by others.
    fn all(differences: &[&Difference], numbers: &Map<Tree, AtomId>) -> Vec<Self> {
        let mut known: Map<&Tree, usize> = Map::new();
        let mut all: Vec<&Operand> = Vec::new();
        let mut pairs: Vec<(AtomId, usize, usize, bool)> = Vec::new();
        for Difference { atom, a, b, is_float } in differences.iter().copied() {
            let [a, b] = [a, b].map(|operand| {
                *known.or_insert_with(&operand.tree, || {
                    all.push(operand);
                    all.len() - 1
                })
            });
            pairs.push((*atom, a, b, *is_float));
        }
        let mut union = Union::new(all.len());
        for (_, a, b, _) in &pairs {
            union.join(*a, *b);
        }
        let number = |operand: &Operand| numbers.get(&operand.tree).copied();
        let mut groups: Map<usize, (Self, Vec<usize>)> = Map::new();
        for (position, operand) in all.iter().enumerate() {
            let (group, members) = groups.or_default(union.root(position));
            group.numbers.push((number(operand), operand.range));
            group.atoms.push_all(number(operand));
            members.push(position);
        }
        for (atom, a, b, is_float) in &pairs {
            let (group, members) = groups.or_default(union.root(*a));
            let at = |of: usize| members.iter().position(|member| *member == of).unwrap_or(0);
            let pair = (*atom, at(*a), at(*b));
            group.atoms.push(*atom);
            group.differences.push(pair);
            group.is_float |= *is_float;
        }
        groups.into_iter().map(|(_, (group, _))| group).list()
    }

    /// Whether more is to be said than that each comparison can have any outcome: numbers whose comparisons form no circle
    /// and have no limits lie as one wants them.
    fn is_tied(&self) -> bool {
        let count = self.numbers.len();
        let width = |(low, high): &(i128, i128)| high.saturating_sub(*low);
        let is_narrow = |(_, range): &(Option<AtomId>, (i128, i128))| width(range) < 2 * count as i128;
        // Of floats one that is no number is so in all of its comparisons.
        self.is_float && count > 2
            || self.differences.len() >= count
            || self.numbers.iter().any(|(number, _)| number.is_some())
            || self.numbers.iter().any(is_narrow)
            || self.numbers.iter().any(|(_, range)| *range != self.numbers[0].1)
    }

    fn allows(&self, knowledge: &Knowledge) -> bool {
        let Some(none) = self.no_numbers(knowledge) else { return false };
        let mut all = Differences::new(self.numbers.len());
        for (atom, a, b) in &self.differences {
            if let (Known::Range(low, high), false) = (knowledge.get(*atom), none[*a] || none[*b]) {
                // One that is none is told apart.
                let high = if self.is_float { high.min(FAR) } else { high };
                all.within(a + 1, b + 1, (low, high));
            }
        }
        if all.len() == 0 {
            return true;
        }
        for (index, (atom, range)) in self.numbers.iter().enumerate() {
            if none[index] {
                continue;
            }
            let known = atom.map(|atom| knowledge.get(atom));
            let (low, high) = if let Some(Known::Range(low, high)) = known { (low, high) } else { *range };
            let (low, high) = if self.is_float { (low.max(range.0), high.min(range.1)) } else { (low, high) };
            all.within(index + 1, 0, (low, high));
        }
        all.is_possible()
    }

    /// Which floats are no numbers; none where some would have to be both. The more are none the less is demanded, so
    /// those are that can be.
    fn no_numbers(&self, knowledge: &Knowledge) -> Option<Vec<bool>> {
        if !self.is_float {
            return Some(vec![false; self.numbers.len()]);
        }
        let known =
            |atom: AtomId| if let Known::Range(low, high) = knowledge.get(atom) { Some((low, high)) } else { None };
        let mut none = vec![true; self.numbers.len()];
        for (atom, a, b) in &self.differences {
            if known(*atom).is_some_and(|(_, high)| high <= FAR) {
                (none[*a], none[*b]) = (false, false);
            }
        }
        for (index, (atom, _)) in self.numbers.iter().enumerate() {
            match atom.and_then(known) {
                Some((_, high)) if high <= FAR => none[index] = false,
                Some((low, _)) if low > FAR && !none[index] => return None,
                _ => {}
            }
        }
        let is_explained = |(atom, a, b): &(AtomId, usize, usize)| {
            known(*atom).is_none_or(|(low, _)| low <= FAR) || none[*a] || none[*b]
        };
        self.differences.iter().all(is_explained).then_some(none)
    }
}

fn is_time(atom: &Atom) -> bool {
    matches!(atom.kind, Kind::Since(_) | Kind::MacroSince(_))
}

impl Valuation<'_> {
    /// Whether what has been decided about numbers goes together, in this cycle and in the one before. What is unclear is
    /// taken for granted.
    pub(crate) fn goes_together(&mut self) -> bool {
        let links = &self.net.links;
        let (mut unclear, mut past) = (Vec::new(), Vec::new());
        let mut tries = std::mem::take(&mut self.tries);
        let mut left = self.left;
        let (given, recorded) = self.knowledge();
        let allowed = links.allow(given, &mut tries, &mut left, &mut unclear)
            && links.allow(recorded, &mut tries, &mut left, &mut past);
        // Whether there were such values in the cycle before, the way there has to answer for.
        let is_new = |atom: &AtomId| !self.before.contains(&(*atom, recorded.get(*atom)));
        if past.iter().any(is_new) {
            unclear.append(&mut past);
        }
        self.work += (self.left - left) / PER_UNIT;
        self.left = left;
        self.tries = tries;
        if allowed && !unclear.is_empty() {
            self.late = true;
            let computed = unclear.into_iter().filter(|atom| links.is_computed(*atom));
            self.granted.push_all(computed.map(|atom| (atom, Known::Unknown)));
        }
        allowed
    }
}

/// So much of what it costs to look for values is one unit of work.
const PER_UNIT: u64 = 64;
