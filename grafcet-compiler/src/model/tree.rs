//! Questions about the tree of an expression.

use super::{Binary, Read, StepId, Tree, Unary};
use crate::list::List;

impl Tree {
    /// Whether the tree holds Rust that is not looked into.
    #[must_use]
    pub(crate) fn is_opaque(&self) -> bool {
        match self {
            Tree::Opaque { .. } => true,
            Tree::Unary(_, inner) => inner.is_opaque(),
            Tree::Binary(_, a, b) => a.is_opaque() || b.is_opaque(),
            _ => false,
        }
    }

    /// Whether each evaluation may have another value.
    #[must_use]
    pub(crate) fn may_differ(&self) -> bool {
        match self {
            Tree::Opaque { call, .. } => call.is_some(),
            Tree::Unary(_, inner) => inner.may_differ(),
            Tree::Binary(_, a, b) => a.may_differ() || b.may_differ(),
            _ => false,
        }
    }

    /// Whether its evaluation may panic, as that of arithmetic may; comparisons do not.
    #[must_use]
    pub(crate) fn may_panic(&self) -> bool {
        match self {
            Tree::Opaque { .. }
            | Tree::Unary(Unary::Neg, _)
            | Tree::Binary(
                Binary::Add | Binary::Sub | Binary::Mul | Binary::Div | Binary::Rem | Binary::Shl | Binary::Shr,
                ..,
            ) => true,
            Tree::Unary(Unary::Not, inner) => inner.may_panic(),
            Tree::Binary(_, a, b) => a.may_panic() || b.may_panic(),
            _ => false,
        }
    }

    /// The tree with one step in place of another, but for what blinks.
    #[must_use]
    pub fn renamed(&self, from: StepId, to: StepId) -> Self {
        let one = |step: StepId| if step == from { to } else { step };
        let read = |read: &Read| match *read {
            Read::Active(step) => Read::Active(one(step)),
            Read::Since(step) => Read::Since(one(step)),
            Read::Elapsed(time, step) => Read::Elapsed(time, one(step)),
            other => other,
        };
        match self {
            Tree::Read(name) => Tree::Read(read(name)),
            Tree::Elapsed(time, step) => Tree::Elapsed(*time, one(*step)),
            Tree::Unary(operator, inner) => Tree::Unary(*operator, Box::new(inner.renamed(from, to))),
            Tree::Binary(operator, a, b) => {
                Tree::Binary(*operator, Box::new(a.renamed(from, to)), Box::new(b.renamed(from, to)))
            }
            Tree::Opaque { reads, .. } => {
                let mut renamed = self.clone();
                if let Tree::Opaque { reads: all, .. } = &mut renamed {
                    *all = reads.iter().map(read).list();
                }
                renamed
            }
            Tree::Bool(_) | Tree::Int(_) | Tree::MacroElapsed(..) => self.clone(),
        }
    }

    /// Whether both are written alike, so that one evaluation serves for both.
    #[must_use]
    pub(crate) fn is_alike(&self, other: &Self) -> bool {
        match (self, other) {
            (Tree::Opaque { text, reads, .. }, Tree::Opaque { text: other, reads: others, .. }) => {
                text == other && reads == others
            }
            (Tree::Unary(operator, inner), Tree::Unary(same, other)) => operator == same && inner.is_alike(other),
            (Tree::Binary(operator, a, b), Tree::Binary(same, c, d)) => {
                operator == same && a.is_alike(c) && b.is_alike(d)
            }
            (one, other) => one == other,
        }
    }

    /// Calls `f` with everything the tree mentions, in order.
    pub fn each_read(&self, f: &mut dyn FnMut(Read)) {
        match self {
            Tree::Bool(_) | Tree::Int(_) => {}
            Tree::Read(read) => f(*read),
            Tree::Elapsed(time, step) => f(Read::Elapsed(*time, *step)),
            Tree::MacroElapsed(time, id) => f(Read::MacroElapsed(*time, *id)),
            Tree::Unary(_, inner) => inner.each_read(f),
            Tree::Binary(_, a, b) => {
                a.each_read(f);
                b.each_read(f);
            }
            Tree::Opaque { reads, .. } => reads.iter().for_each(|read| f(*read)),
        }
    }
}
