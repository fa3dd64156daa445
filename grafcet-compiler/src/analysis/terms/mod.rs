//! Arithmetic of integers: whether there are values for which what is computed of them lies where it is said to.
//!
//! Terms are computed as Rust does. Where a result does not fit into its type, a program that is built with checks for that
//! panics, and any other goes on at the other end: nothing is said to be impossible that either of the two can do, and nothing is
//! said to be possible unless there are values with which nothing of the kind happens. These values have been tried.

mod bits;
mod build;
mod solve;
mod spans;

pub(crate) use build::integer;

use super::differences::FAR;
use crate::model::{Integer, Tree};
use crate::sorted::Map;

/// From the least to the greatest of some numbers.
pub(super) type Span = (i128, i128);

/// Anything at all.
pub(super) const ANY: Span = (-FAR, FAR);

/// What was found out about numbers.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Told {
    /// There are none like this.
    Impossible,
    /// There are, such as these: the value of each term.
    Possible(Vec<i128>),
    /// It was not decided, or there are some only where a result does not fit into its type.
    Unclear,
}

/// What is to be true of some numbers.
#[derive(Default)]
pub(super) struct Demands {
    /// In which span a term lies.
    pub(super) spans: Vec<(usize, Span)>,
    /// How far a term lies above another one.
    pub(super) differences: Vec<(usize, usize, Span)>,
}

/// Terms, each after those that it is computed of.
#[derive(Debug, Default)]
pub(super) struct Terms {
    nodes: Vec<Node>,
    /// Of this cycle, or of the one before.
    known: Map<(Tree, bool), usize>,
    constants: Map<i128, usize>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    what: What,
    /// Every value that it can have, and those that it has without anything out of the common.
    range: Span,
    usual: Span,
}

#[derive(Clone, Copy, Debug)]
enum What {
    Constant,
    /// A value that is not computed, or nobody knows how.
    Leaf,
    /// The exact result, of which nobody asks whether it fits into a type.
    Exact(Operation, usize, usize),
    /// What a type makes of an exact result.
    Fit(usize, Fit),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Operation {
    Add,
    Sub,
    Mul,
    /// Towards zero, and what is left.
    Div,
    Rem,
    /// Downwards where the divisor is positive, and what is left.
    DivEuclid,
    RemEuclid,
    And,
    Or,
    Xor,
    Min,
    Max,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Fit {
    /// A program with checks panics, any other goes on at the other end.
    Checked(Integer),
    /// It goes on at the other end.
    Wrapping(Integer),
    /// It stays at the end.
    Saturating(Integer),
}

impl Terms {
    /// Whether anything is computed.
    pub(super) fn is_computed(&self) -> bool {
        self.nodes.iter().any(|node| matches!(node.what, What::Exact(..) | What::Fit(..)))
    }

    /// How many terms there are.
    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Those that it is computed of.
    pub(super) fn operands(&self, term: usize) -> Vec<usize> {
        match self.nodes[term].what {
            What::Constant | What::Leaf => Vec::new(),
            What::Exact(_, a, b) => vec![a, b],
            What::Fit(of, _) => vec![of],
        }
    }

    pub(super) fn is_constant(&self, term: usize) -> bool {
        matches!(self.nodes[term].what, What::Constant)
    }

    /// What is not computed.
    pub(super) fn leaves(&self) -> impl Iterator<Item = (&Tree, usize)> {
        let is_leaf = |term: usize| matches!(self.nodes[term].what, What::Leaf);
        self.known.iter().map(|((tree, _), term)| (tree, *term)).filter(move |(_, term)| is_leaf(*term))
    }

    /// Per term whether all is so that it is computed of.
    pub(super) fn all_of(&self, is_so: impl Fn(&Tree) -> bool) -> Vec<bool> {
        let mut all = vec![true; self.nodes.len()];
        for (tree, leaf) in self.leaves() {
            all[leaf] = is_so(tree);
        }
        for term in 0..all.len() {
            all[term] &= self.operands(term).into_iter().all(|operand| all[operand]);
        }
        all
    }

    /// The number of what this tree stands for, if it is known.
    pub(super) fn of(&self, tree: &Tree, before: bool) -> Option<usize> {
        self.known.get(&(tree.clone(), before)).copied()
    }
}
