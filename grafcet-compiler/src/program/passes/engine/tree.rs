//! What is done on all ways from one state.

use super::super::super::build::not;
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

impl<'m> Tree<'m> {
    pub(in super::super) fn each_leaf(&self, each: &mut dyn FnMut(&Leaf<'m>)) {
        match &self.end {
            End::Leaf(leaf) => each(leaf),
            End::Fork(_, ways) => ways.iter().for_each(|way| way.each_leaf(each)),
        }
    }

    pub(in super::super) fn each_leaf_mut(&mut self, each: &mut dyn FnMut(&mut Leaf<'m>)) {
        match &mut self.end {
            End::Leaf(leaf) => each(leaf),
            End::Fork(_, ways) => ways.iter_mut().for_each(|way| way.each_leaf_mut(each)),
        }
    }

    pub(in super::super) fn copy(&self) -> Self {
        let end = match &self.end {
            End::Leaf(leaf) => End::Leaf(Leaf { body: leaf.body.clone(), facts: Vec::new(), ..*leaf }),
            End::Fork(condition, ways) => End::Fork(condition.clone(), Box::new([ways[0].copy(), ways[1].copy()])),
        };
        Self { body: self.body.clone(), end }
    }

    pub(in super::super) fn statements(self) -> Vec<Statement<'m>> {
        let mut body = self.body;
        match self.end {
            End::Leaf(leaf) => {
                body.extend(leaf.body);
                if leaf.breaks {
                    body.push(Statement::Break);
                }
            }
            End::Fork(condition, ways) => {
                let [then, otherwise] = *ways;
                let (then, otherwise) = (then.statements(), otherwise.statements());
                body.push(if then.is_empty() {
                    Statement::If(not(condition), otherwise, then)
                } else {
                    Statement::If(condition, then, otherwise)
                });
            }
        }
        body
    }
}
