//! Typed ids and the arenas they index: a step's id cannot be taken for a transition's.

use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

use crate::list::searches;

/// An index into one arena.
pub trait Id: Copy {
    /// From the position of declaration.
    fn new(index: usize) -> Self;
    /// The position of declaration.
    fn index(self) -> usize;
}

/// Values in the order of their declaration, indexed by their own kind of id.
#[derive(Clone, Debug)]
pub struct Arena<I, T> {
    items: Vec<T>,
    id: PhantomData<I>,
}

impl<I, T> Default for Arena<I, T> {
    fn default() -> Self {
        Self { items: Vec::new(), id: PhantomData }
    }
}

impl<I: Id, T> Arena<I, T> {
    /// Appends a value.
    pub fn push(&mut self, value: T) -> I {
        self.items.push(value);
        I::new(self.items.len() - 1)
    }

    /// The same value for so many ids.
    #[must_use]
    pub(crate) fn filled(count: usize, value: T) -> Self
    where
        T: Clone,
    {
        Self { items: vec![value; count], id: PhantomData }
    }

    /// What is found out of each value of another arena.
    #[must_use]
    pub(crate) fn of<S>(values: &Arena<I, S>, mut found: impl FnMut(I, &S) -> T) -> Self {
        let mut all = Self::default();
        for (id, value) in values.iter() {
            all.push(found(id, value));
        }
        all
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// All ids, in the order of declaration.
    #[must_use]
    pub fn ids(&self) -> Ids<I> {
        Ids { from: 0, to: self.items.len(), id: PhantomData }
    }

    /// All values with their ids.
    #[must_use]
    #[allow(clippy::iter_without_into_iter, reason = "a loop over an arena says whether it is about ids or values")]
    pub fn iter(&self) -> Entries<'_, I, T> {
        Entries { ids: self.ids(), items: &self.items }
    }

    /// All values.
    pub fn values(&self) -> std::slice::Iter<'_, T> {
        self.items.iter()
    }
}

impl<I: Id, T> Index<I> for Arena<I, T> {
    type Output = T;
    fn index(&self, id: I) -> &T {
        &self.items[id.index()]
    }
}

impl<I: Id, T> IndexMut<I> for Arena<I, T> {
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.items[id.index()]
    }
}

/// The ids of an arena, in the order of declaration.
#[derive(Clone)]
pub struct Ids<I> {
    from: usize,
    to: usize,
    id: PhantomData<I>,
}

impl<I: Id> Iterator for Ids<I> {
    type Item = I;

    fn next(&mut self) -> Option<I> {
        if self.from == self.to {
            return None;
        }
        self.from += 1;
        Some(I::new(self.from - 1))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.to - self.from, Some(self.to - self.from))
    }

    searches!();
}

impl<I: Id> DoubleEndedIterator for Ids<I> {
    fn next_back(&mut self) -> Option<I> {
        if self.from == self.to {
            return None;
        }
        self.to -= 1;
        Some(I::new(self.to))
    }
}

impl<I: Id> ExactSizeIterator for Ids<I> {}

/// The values of an arena with their ids, in the order of declaration.
pub struct Entries<'a, I, T> {
    ids: Ids<I>,
    items: &'a [T],
}

impl<I: Clone, T> Clone for Entries<'_, I, T> {
    fn clone(&self) -> Self {
        Self { ids: self.ids.clone(), items: self.items }
    }
}

impl<'a, I: Id, T> Iterator for Entries<'a, I, T> {
    type Item = (I, &'a T);

    fn next(&mut self) -> Option<(I, &'a T)> {
        let id = self.ids.next()?;
        Some((id, &self.items[id.index()]))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.ids.size_hint()
    }

    searches!();
}

impl<I: Id, T> DoubleEndedIterator for Entries<'_, I, T> {
    fn next_back(&mut self) -> Option<Self::Item> {
        let id = self.ids.next_back()?;
        Some((id, &self.items[id.index()]))
    }
}

impl<I: Id, T> ExactSizeIterator for Entries<'_, I, T> {}

/// Ids, each of an arena of its own.
macro_rules! ids {
    ($($(#[$doc:meta])* $seen:vis $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
        $seen struct $name(u32);

        impl $crate::model::Id for $name {
            fn new(index: usize) -> Self {
                // A chart with 2^32 items does not fit into a source file.
                Self(u32::try_from(index).unwrap_or(u32::MAX))
            }
            fn index(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

pub(crate) use ids;

ids! {
    /// An `input`.
    pub InputId;
    /// An `output`.
    pub OutputId;
    /// A `var`.
    pub VarId;
    /// A `param`.
    pub ParamId;
    /// A `let`.
    pub LetId;
    /// An `action`.
    pub ActionId;
    /// A step (never a macro-step: those are expanded).
    pub StepId;
    /// A macro-step.
    pub MacroId;
    /// A transition.
    pub TransitionId;
    /// An `any`.
    pub AnyId;
    /// A partial grafcet; 0 is what stands directly in the chart.
    pub PartialId;
    /// An association of a step with an action.
    pub AssociationId;
    /// A forcing order.
    pub ForceId;
    /// The memory of `rising(e)` and `falling(e)`.
    pub EdgeId;
    /// A general delay `t1/e/t2`.
    pub DelayId;
    /// What a property remembers.
    pub MemoryId;
}
