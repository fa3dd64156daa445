//! Typed ids and the arenas they index: a step's id cannot be taken for a transition's.

use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

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
    pub fn ids(&self) -> impl DoubleEndedIterator<Item = I> + ExactSizeIterator + use<I, T> {
        (0..self.items.len()).map(I::new)
    }

    /// All values with their ids.
    #[must_use]
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (I, &T)> + ExactSizeIterator {
        self.items.iter().enumerate().map(|(i, v)| (I::new(i), v))
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

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
        pub struct $name(u32);

        impl Id for $name {
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

ids! {
    /// An `input`.
    InputId;
    /// An `output`.
    OutputId;
    /// A `var`.
    VarId;
    /// A `param`.
    ParamId;
    /// A `let`.
    LetId;
    /// An `action`.
    ActionId;
    /// A step (never a macro-step: those are expanded).
    StepId;
    /// A macro-step.
    MacroId;
    /// A transition.
    TransitionId;
    /// An `any`.
    AnyId;
    /// A partial grafcet; 0 is what stands directly in the chart.
    PartialId;
    /// An association of a step with an action.
    AssociationId;
    /// A forcing order.
    ForceId;
    /// The memory of `rising(e)` and `falling(e)`.
    EdgeId;
    /// A general delay `t1/e/t2`.
    DelayId;
}
