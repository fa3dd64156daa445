//! Values that are compared with each other and with constants: whether there are such values.

use super::atoms::{Atoms, Key};
use super::formula::AtomId;
use super::ranges::Ranges;
use super::solve::{Domains, Search, Undecided};
use crate::analysis::differences::{Differences, FAR};
use crate::analysis::numbers::{float, range};
use crate::analysis::terms::{Demands, Terms, Told, integer};
use crate::list::{List, PushAll};
use crate::model::{Model, Name, Read, Tree};
use crate::sorted::{Map, Set};

/// How two floats compare of which one is no number.
const NONE: i128 = 2;

/// The values that comparisons of one question with each other are about.
#[derive(Default)]
pub(super) struct Values {
    compared: Vec<Value>,
    /// The atom, and which two values it compares.
    orders: Vec<(AtomId, usize, usize)>,
    computed: Option<Computed>,
}

/// The integers of a question, where some are computed of others.
#[derive(Default)]
struct Computed {
    terms: Terms,
    /// What is compared with constants, and booleans that are computed with.
    numbers: Vec<(AtomId, usize)>,
    orders: Vec<(AtomId, usize, usize)>,
}

struct Value {
    /// Where it is compared with constants, too.
    number: Option<AtomId>,
    range: (i128, i128),
}

impl Values {
    /// What the atoms of a question compare with each other, if any do.
    pub(super) fn of(model: &Model, atoms: &Atoms, asked: &Set<AtomId>) -> Option<Self> {
        let mut all = Self::default();
        // In this cycle, or in the one before.
        let mut known: Map<(&Tree, bool), usize> = Map::new();
        for (id, key, before) in keys(atoms, asked) {
            let Key::Order(a, b) = key else { continue };
            let mut value = |tree| {
                *known.or_insert_with((tree, before), || {
                    let limits = match tree {
                        Tree::Int(constant) => (*constant, *constant),
                        _ if float(model, tree).is_some() => (-FAR, FAR + 1),
                        _ => range(model, tree).unwrap_or((-FAR, FAR)),
                    };
                    all.compared.push(Value { number: None, range: limits });
                    all.compared.len() - 1
                })
            };
            let (a, b) = (value(a), value(b));
            all.orders.push((id, a, b));
        }
        if keys(atoms, asked).any(|(id, ..)| atoms.get(id).is_some_and(|atom| atom.is_computed)) {
            all.computed = Some(Computed::of(model, atoms, asked));
        }
        if all.orders.is_empty() && all.computed.is_none() {
            return None;
        }
        for (id, key, before) in keys(atoms, asked) {
            if let Key::Number(tree) = key {
                if let Some(value) = known.get(&(tree, before)) {
                    all.compared[*value].number = Some(id);
                }
            }
        }
        Some(all)
    }

    fn range(&self, value: usize, domains: &Domains) -> (i128, i128) {
        let Value { number, range } = &self.compared[value];
        let hull = number.and_then(|atom| domains.get(&atom)?.hull());
        hull.unwrap_or(*range)
    }

    /// What the intervals demand of the values; none if there are no such floats. No domain has a gap.
    fn demands(&self, domains: &Domains) -> Option<Differences> {
        let mut demands = Differences::new(self.compared.len());
        let mut is_number = vec![false; self.compared.len()];
        let mut unordered = Vec::new();
        for (atom, a, b) in &self.orders {
            let Some((low, high)) = domains.get(atom).and_then(Ranges::hull) else { continue };
            if low == NONE {
                unordered.push((*a, *b));
            } else if high < NONE {
                let far = |end: i128| if end == 0 { 0 } else { FAR * end };
                let less = if high < 0 { -1 } else { far(high) };
                let more = if low > 0 { 1 } else { far(low) };
                demands.within(a + 1, b + 1, (more, less));
                // An integer always is one.
                (is_number[*a], is_number[*b]) = (true, true);
            }
        }
        for (value, is_number) in is_number.iter().enumerate() {
            let (low, high) = self.range(value, domains);
            if *is_number && low > FAR {
                return None;
            }
            if low <= FAR {
                demands.within(value + 1, 0, (low, high));
            }
        }
        let can_be_none = |value: &usize| !is_number[*value] && self.range(*value, domains).1 > FAR;
        unordered.iter().all(|(a, b)| can_be_none(a) || can_be_none(b)).then_some(demands)
    }

    /// The first domain with a gap, interval by interval. Whether two floats compare at all is told apart, too.
    fn gap(&self, domains: &Domains) -> Option<(AtomId, Vec<Ranges>)> {
        let orders = self.orders.iter().map(|(atom, ..)| (*atom, true));
        let numbers = self.compared.iter().filter_map(|value| Some((value.number?, false)));
        let computed = self.computed.iter().flat(|computed| &computed.numbers).map(|(atom, _)| (*atom, false));
        orders.and(numbers).and(computed).find_map(|(atom, is_order)| {
            let domain = domains.get(&atom)?;
            let mut parts = domain.parts();
            let (low, high) = domain.hull()?;
            if is_order && high == NONE && low < NONE && !(low < 0 && parts.len() == 1) {
                for part in &mut parts {
                    part.keep(NONE, NONE, false);
                }
                parts.retain(|part| !part.is_empty());
                parts.push(Ranges::from_to(NONE, NONE));
            }
            (parts.len() > 1).then_some((atom, parts))
        })
    }

    /// Narrows the domains of numbers to values that go together, each as near to zero as it can be.
    fn choose(&self, domains: &mut Domains, mut demands: Differences) {
        for (index, value) in self.compared.iter().enumerate() {
            let Some(domain) = value.number.and_then(|atom| domains.get_mut(&atom)) else { continue };
            if domain.hull().is_none_or(|(low, _)| low > FAR) {
                continue;
            }
            let (low, high) = demands.range(index + 1);
            let (low, high) = (low.unwrap_or(-FAR), high.unwrap_or(FAR));
            domain.keep(low, high, true);
            if let Some(near) = domain.example() {
                *domain = Ranges::from_to(near, near);
                demands.within(index + 1, 0, (near, near));
            }
        }
    }
}

/// So much of what it costs to look for values is one unit.
const PER_UNIT: u64 = 16;

/// Whether a value is computed of inputs alone, in a way that is understood.
pub(super) fn is_of_inputs(model: &Model, trees: &[&Tree]) -> bool {
    let mut terms = Terms::default();
    let ty = trees.iter().find_map(|tree| integer(model, tree));
    for tree in trees {
        terms.add(model, tree, ty, false);
    }
    terms.leaves().all(|(tree, _)| matches!(tree, Tree::Read(Read::Name(Name::Input(_)))))
}

impl Computed {
    fn of(model: &Model, atoms: &Atoms, asked: &Set<AtomId>) -> Self {
        let mut all = Self::default();
        for (id, key, before) in keys(atoms, asked) {
            match key {
                Key::Number(tree) if float(model, tree).is_none() => {
                    let term = all.terms.add(model, tree, None, before);
                    all.numbers.push((id, term));
                }
                Key::Order(a, b) if float(model, a).is_none() && float(model, b).is_none() => {
                    let ty = integer(model, a).or_else(|| integer(model, b));
                    let [a, b] = [a, b].map(|tree| all.terms.add(model, tree, ty, before));
                    all.orders.push((id, a, b));
                }
                _ => {}
            }
        }
        for (id, key, before) in keys(atoms, asked) {
            if let Key::Boolean(tree) = key {
                all.numbers.push_all(all.terms.of(tree, before).map(|term| (id, term)));
            }
        }
        all
    }

    fn demands(&self, domains: &Domains) -> Demands {
        let mut demands = Demands::default();
        let hull = |atom: &AtomId| domains.get(atom).and_then(Ranges::hull);
        for (atom, term) in &self.numbers {
            demands.spans.push_all(hull(atom).map(|span| (*term, span)));
        }
        for (atom, a, b) in &self.orders {
            let Some((low, high)) = hull(atom) else { continue };
            let span = (if low < 0 { -FAR } else { low }, if high > 0 { FAR } else { high });
            demands.differences.push((*a, *b, span));
        }
        demands
    }

    /// Narrows the domains of numbers to values that were found.
    fn choose(&self, domains: &mut Domains, found: &[i128]) {
        for (atom, term) in &self.numbers {
            if let Some(domain) = domains.get_mut(atom) {
                *domain = Ranges::from_to(found[*term], found[*term]);
            }
        }
    }
}

/// Atoms with what they stand for, and whether in the cycle before.
fn keys<'a>(atoms: &'a Atoms, asked: &'a Set<AtomId>) -> impl Iterator<Item = (AtomId, &'a Key, bool)> {
    asked.iter().filter_map(|id| match &atoms.get(*id)?.key {
        Key::Before(of) => Some((*id, &atoms.get(*of)?.key, true)),
        key => Some((*id, key, false)),
    })
}

impl Search<'_> {
    /// Domains from which values can be chosen that compare as they shall, if there are any.
    pub(super) fn settle(&mut self, mut domains: Domains, depth: u32) -> Result<Option<Domains>, Undecided> {
        let Some(values) = self.values else { return Ok(Some(domains)) };
        let Some(demands) = values.demands(&domains) else { return Ok(None) };
        self.pay(demands.len() * (values.compared.len() + 1))?;
        if !demands.is_possible() {
            return Ok(None);
        }
        let Some((atom, parts)) = values.gap(&domains) else {
            if let Some(computed) = &values.computed {
                let mut left = u64::from(self.budget / 2) * PER_UNIT;
                let before = left;
                let told = computed.terms.told(&computed.demands(&domains), &mut left);
                self.pay(usize::try_from((before - left) / PER_UNIT).unwrap_or(usize::MAX))?;
                match told {
                    Told::Impossible => return Ok(None),
                    Told::Possible(found) => computed.choose(&mut domains, &found),
                    Told::Unclear if self.sure => return Err(Undecided),
                    Told::Unclear => {}
                }
            }
            values.choose(&mut domains, demands);
            return Ok(Some(domains));
        };
        let depth = depth.checked_sub(1).ok_or(Undecided)?;
        for part in parts {
            domains.insert(atom, part);
            if let Some(found) = self.settle(domains.clone(), depth)? {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }
}
