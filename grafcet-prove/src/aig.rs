//! And-inverter graphs: each gate once, constants folded.

use std::ops::Not;

/// A wire of an [`Aig`]: a node, or its negation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Lit(u32);

impl Lit {
    pub const FALSE: Self = Self(0);
    pub const TRUE: Self = Self(1);

    /// The wire of a node that is not negated.
    #[must_use]
    pub fn of(node: usize) -> Self {
        Self(u32::try_from(node).unwrap_or(u32::MAX / 2) << 1)
    }

    /// Its number in AIGER.
    #[must_use]
    pub fn code(self) -> u32 {
        self.0
    }

    #[must_use]
    pub fn node(self) -> usize {
        (self.0 >> 1) as usize
    }

    #[must_use]
    pub(crate) fn is_negated(self) -> bool {
        self.0 & 1 == 1
    }

    /// The same wire, negated where `negated`.
    #[must_use]
    pub fn xor(self, negated: bool) -> Self {
        Self(self.0 ^ u32::from(negated))
    }

    #[must_use]
    pub fn constant(value: bool) -> Self {
        Self(u32::from(value))
    }

    /// Its value, if it is a constant.
    #[must_use]
    pub fn known(self) -> Option<bool> {
        (self.0 < 2).then_some(self.0 == 1)
    }
}

impl Not for Lit {
    type Output = Self;

    fn not(self) -> Self {
        Self(self.0 ^ 1)
    }
}

/// What a node is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Node {
    /// The first node.
    False,
    /// An input, or the value of a latch.
    Free,
    And(Lit, Lit),
}

/// A graph of AND gates whose inputs may be negated. The operands of a gate stand before it.
#[derive(Clone, Debug)]
pub struct Aig {
    nodes: Vec<Node>,
    /// By hash: the last node with it.
    heads: Vec<u32>,
    /// By node: the one before it with the same hash.
    next: Vec<u32>,
}

impl Default for Aig {
    fn default() -> Self {
        Self { nodes: vec![Node::False], heads: vec![0; 64], next: vec![0] }
    }
}

impl Aig {
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.len() == 1
    }

    #[must_use]
    pub fn node(&self, index: usize) -> Node {
        self.nodes[index]
    }

    /// A new wire that anything may drive.
    pub fn free(&mut self) -> Lit {
        self.push(Node::Free)
    }

    fn push(&mut self, node: Node) -> Lit {
        self.nodes.push(node);
        self.next.push(0);
        Lit::of(self.nodes.len() - 1)
    }

    pub fn and(&mut self, a: Lit, b: Lit) -> Lit {
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        if a == Lit::FALSE || a == !b {
            return Lit::FALSE;
        }
        if a == Lit::TRUE || a == b {
            return b;
        }
        if let Some(simpler) = self.absorbed(a, b).or_else(|| self.absorbed(b, a)) {
            return simpler;
        }
        if self.nodes.len() > self.heads.len() {
            self.grow();
        }
        let slot = self.slot(a, b);
        let mut at = self.heads[slot];
        while at != 0 {
            if self.nodes[at as usize] == Node::And(a, b) {
                return Lit::of(at as usize);
            }
            at = self.next[at as usize];
        }
        let made = self.push(Node::And(a, b));
        self.next[made.node()] = self.heads[slot];
        self.heads[slot] = made.code() >> 1;
        made
    }

    /// `a && (a && x)`, `a && !(a && x)` and the like.
    fn absorbed(&mut self, a: Lit, b: Lit) -> Option<Lit> {
        let Node::And(x, y) = self.nodes[b.node()] else { return None };
        match b.is_negated() {
            false if x == a || y == a => Some(b),
            false if x == !a || y == !a => Some(Lit::FALSE),
            true if x == !a || y == !a => Some(a),
            true if x == a => Some(self.and(a, !y)),
            true if y == a => Some(self.and(a, !x)),
            _ => None,
        }
    }

    fn slot(&self, a: Lit, b: Lit) -> usize {
        let mixed = a.0.wrapping_mul(0x9e37_79b1) ^ b.0.wrapping_mul(0x85eb_ca6b).rotate_left(15);
        (mixed ^ (mixed >> 15)) as usize % self.heads.len()
    }

    fn grow(&mut self) {
        self.heads = vec![0; self.heads.len() * 2];
        for index in 1..self.nodes.len() {
            if let Node::And(a, b) = self.nodes[index] {
                let slot = self.slot(a, b);
                self.next[index] = self.heads[slot];
                self.heads[slot] = u32::try_from(index).unwrap_or(0);
            }
        }
    }

    pub fn or(&mut self, a: Lit, b: Lit) -> Lit {
        !self.and(!a, !b)
    }

    /// `then` where the condition holds, else `otherwise`.
    pub fn mux(&mut self, condition: Lit, then: Lit, otherwise: Lit) -> Lit {
        if then == otherwise {
            return then;
        }
        let (a, b) = (self.and(condition, then), self.and(!condition, otherwise));
        self.or(a, b)
    }

    pub fn xor(&mut self, a: Lit, b: Lit) -> Lit {
        let (one, other) = (self.and(a, !b), self.and(!a, b));
        self.or(one, other)
    }

    pub(crate) fn iff(&mut self, a: Lit, b: Lit) -> Lit {
        !self.xor(a, b)
    }

    pub fn all(&mut self, lits: &[Lit]) -> Lit {
        lits.iter().fold(Lit::TRUE, |all, lit| self.and(all, *lit))
    }

    pub fn any(&mut self, lits: &[Lit]) -> Lit {
        lits.iter().fold(Lit::FALSE, |any, lit| self.or(any, *lit))
    }

    /// The value of every node, by those of the free ones.
    #[must_use]
    pub fn simulate(&self, free: impl Fn(usize) -> bool) -> Vec<bool> {
        let mut values: Vec<bool> = Vec::with_capacity(self.nodes.len());
        for (index, node) in self.nodes.iter().enumerate() {
            let value = match *node {
                Node::False => false,
                Node::Free => free(index),
                // Both are looked at: which way a jump goes nobody can guess here.
                Node::And(a, b) => (values[a.node()] ^ a.is_negated()) & (values[b.node()] ^ b.is_negated()),
            };
            values.push(value);
        }
        values
    }

    /// The nodes on which some wires depend, each after its operands.
    #[must_use]
    pub(crate) fn cone(&self, roots: &[Lit]) -> Vec<usize> {
        let mut marked = vec![false; self.nodes.len()];
        for root in roots {
            marked[root.node()] = true;
        }
        for index in (1..self.nodes.len()).rev() {
            if let (true, Node::And(a, b)) = (marked[index], self.nodes[index]) {
                marked[a.node()] = true;
                marked[b.node()] = true;
            }
        }
        (1..self.nodes.len()).filter(|index| marked[*index]).collect()
    }
}

/// The value of a wire by those of all nodes.
#[must_use]
pub fn value(values: &[bool], lit: Lit) -> bool {
    values[lit.node()] ^ lit.is_negated()
}
