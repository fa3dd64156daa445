//! What is done on all ways from one state.

use super::super::super::{Expr, Statement, Value};
use super::facts::Fact;

/// What is done on all ways from one state.
pub(in super::super) struct Tree<'m> {
    pub(in super::super) body: Vec<Statement<'m>>,
    pub(in super::super) end: End<'m>,
}

pub(in super::super) enum End<'m> {
    /// Where the condition holds the first, else the second.
    Fork(Expr<'m>, Box<[Tree<'m>; 2]>),
    Leaf(Leaf<'m>),
}

/// The end of a way: what is done after its last fork.
pub(in super::super) struct Leaf<'m> {
    pub(in super::super) body: Vec<Statement<'m>>,
    /// The state after it.
    pub(in super::super) state: Value,
    /// What is known then of the fields.
    pub(in super::super) facts: Vec<Fact>,
    /// It leaves the loop.
    pub(in super::super) breaks: bool,
}

/// The state is not known in the end, or there are too many ways.
pub(in super::super) struct Lost;
