//! Boolean functions over atoms.
use crate::list::{List, PushAll};
use crate::sorted::sort;

/// The upper bound where a boolean atom is true: beyond all numbers.
const TRUE: i128 = i128::MAX;

/// The number of an atom in the table of a chart.
pub(super) type AtomId = u32;

/// A boolean function.
#[derive(Clone, Debug)]
pub(super) enum Formula {
    Const(bool),
    /// The value of the atom lies between `low` and `high`; a boolean atom is 0 where it is false and more where it is true.
    Leaf {
        atom: AtomId,
        low: i128,
        high: i128,
    },
    Not(Box<Formula>),
    All(Vec<Formula>),
    Any(Vec<Formula>),
    /// Both hold, or neither.
    Same(Box<Formula>, Box<Formula>),
}

impl Formula {
    /// A boolean atom is true.
    pub(super) fn is_true(atom: AtomId) -> Self {
        Self::Leaf { atom, low: 1, high: TRUE }
    }

    pub(super) fn not(self) -> Self {
        match self {
            Self::Const(value) => Self::Const(!value),
            Self::Not(inner) => *inner,
            other => Self::Not(Box::new(other)),
        }
    }

    /// If `self` holds, `other` does.
    pub(super) fn implies(self, other: Self) -> Self {
        Self::Any(vec![self.not(), other])
    }

    /// `a && b && c` is one list, so that long chains are flat.
    pub(super) fn and(self, other: Self) -> Self {
        match self {
            Self::All(mut parts) => {
                parts.push(other);
                Self::All(parts)
            }
            first => Self::All(vec![first, other]),
        }
    }

    /// `a || b || c` is one list.
    pub(super) fn or(self, other: Self) -> Self {
        match self {
            Self::Any(mut parts) => {
                parts.push(other);
                Self::Any(parts)
            }
            first => Self::Any(vec![first, other]),
        }
    }

    /// The atoms, in the order in which they stand.
    pub(super) fn each_atom(&self, f: &mut dyn FnMut(AtomId)) {
        match self {
            Self::Const(_) => {}
            Self::Leaf { atom, .. } => f(*atom),
            Self::Not(inner) => inner.each_atom(f),
            Self::All(parts) | Self::Any(parts) => parts.iter().for_each(|part| part.each_atom(f)),
            Self::Same(a, b) => {
                a.each_atom(f);
                b.each_atom(f);
            }
        }
    }

    /// The same function of other atoms.
    pub(super) fn of_others(&self, other: &mut dyn FnMut(AtomId) -> AtomId) -> Self {
        match self {
            Self::Const(value) => Self::Const(*value),
            Self::Leaf { atom, low, high } => Self::Leaf { atom: other(*atom), low: *low, high: *high },
            Self::Not(inner) => Self::Not(Box::new(inner.of_others(other))),
            Self::All(parts) => Self::All(parts.iter().map(|part| part.of_others(other)).list()),
            Self::Any(parts) => Self::Any(parts.iter().map(|part| part.of_others(other)).list()),
            Self::Same(a, b) => Self::Same(Box::new(a.of_others(other)), Box::new(b.of_others(other))),
        }
    }

    /// Between which values atoms lie wherever the function is true, as far as that is seen at once; by atom.
    pub(super) fn demands(&self) -> Vec<(AtomId, i128, i128)> {
        let mut demands = Vec::new();
        let mut work = vec![self];
        while let Some(part) = work.pop() {
            match part {
                Self::Leaf { atom, low, high } => demands.push((*atom, *low, *high)),
                // Below all values from `low` on; what lies outside of an interval is no interval.
                Self::Not(inner) => {
                    if let Self::Leaf { atom, low, high: TRUE } = **inner {
                        demands.push((atom, i128::MIN, low - 1));
                    }
                }
                Self::All(parts) => work.push_all(parts),
                _ => {}
            }
        }
        sort(&mut demands);
        demands.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                (kept.1, kept.2) = (kept.1.max(next.1), kept.2.min(next.2));
            }
            same
        });
        demands
    }

    /// A function that has the value `wanted` only where this one has it whatever the atoms are that `loose` names.
    pub(super) fn certainly(&self, wanted: bool, loose: &dyn Fn(AtomId) -> bool) -> Self {
        match self {
            Self::Const(value) => Self::Const(*value),
            Self::Leaf { atom, .. } if loose(*atom) => Self::Const(!wanted),
            Self::Leaf { .. } => self.clone(),
            Self::Not(inner) => inner.certainly(!wanted, loose).not(),
            Self::All(parts) => Self::All(parts.iter().map(|part| part.certainly(wanted, loose)).list()),
            Self::Any(parts) => Self::Any(parts.iter().map(|part| part.certainly(wanted, loose)).list()),
            Self::Same(..) => {
                let mut open = false;
                self.each_atom(&mut |atom| open |= loose(atom));
                if open { Self::Const(!wanted) } else { self.clone() }
            }
        }
    }
}
