//! What is remembered from one moment to the next: edges and delays, of the chart and of its properties.

use super::Resolver;
use crate::list::List;
use crate::model::{
    Arena, Computed, Delay, DelayId, Edge, EdgeId, Expr, Memory, MemoryId, Model, Read, Remembers, Tree,
};

/// Edges and delays, and what named conditions stand for, in which they occur.
pub(super) struct Sampled {
    edges: Arena<EdgeId, Edge>,
    delays: Arena<DelayId, Delay>,
    named: Vec<Option<Expr>>,
}

impl Resolver<'_> {
    /// The memory of an edge; equal expressions share one.
    pub(super) fn edge(&mut self, edge: Edge) -> EdgeId {
        let same = self.model.edges.iter().find(|(_, e)| e.of.tree.is_alike(&edge.of.tree)).map(|(id, _)| id);
        same.unwrap_or_else(|| self.model.edges.push(edge))
    }

    /// A delay; equal ones share their timer.
    pub(super) fn delay(&mut self, delay: Delay) -> DelayId {
        let same = |d: &Delay| (d.on, d.off) == (delay.on, delay.off) && d.of.tree.is_alike(&delay.of.tree);
        let found = self.model.delays.iter().find(|(_, d)| same(d)).map(|(id, _)| id);
        found.unwrap_or_else(|| self.model.delays.push(delay))
    }

    /// Takes those of the chart away, so that what is resolved next has its own.
    pub(super) fn take_sampled(&mut self) -> Sampled {
        Sampled {
            edges: std::mem::take(&mut self.model.edges),
            delays: std::mem::take(&mut self.model.delays),
            named: self.lets.iter_mut().map(|named| named.known.take()).list(),
        }
    }

    /// Brings those of the chart back; what has been resolved meanwhile.
    pub(super) fn sampled_again(&mut self, of_chart: Sampled) -> Sampled {
        let own = self.take_sampled();
        (self.model.edges, self.model.delays) = (of_chart.edges, of_chart.delays);
        for (named, known) in self.lets.iter_mut().zip(of_chart.named) {
            named.known = known;
        }
        own
    }
}

/// Puts memories of a property in the place of its edges and delays.
pub(super) struct Remembering<'r> {
    pub(super) own: &'r Sampled,
    pub(super) model: &'r mut Model,
}

impl Remembering<'_> {
    pub(super) fn expr(&mut self, expr: &Expr) -> Expr {
        let tree = self.tree(&expr.tree);
        let mut reads = Vec::new();
        self.reads(&expr.reads, &mut reads);
        Expr { tree, reads, tokens: expr.tokens.clone(), text: expr.text.clone(), mark: expr.mark }
    }

    fn tree(&mut self, tree: &Tree) -> Tree {
        match tree {
            Tree::Read(read) => Tree::Read(self.read(*read)),
            Tree::Unary(operator, inner) => Tree::Unary(*operator, Box::new(self.tree(inner))),
            Tree::Binary(operator, a, b) => Tree::Binary(*operator, Box::new(self.tree(a)), Box::new(self.tree(b))),
            Tree::Opaque { text, reads, call, whole, open, of } => Tree::Opaque {
                text: text.clone(),
                reads: reads.iter().map(|read| self.read(*read)).list(),
                call: *call,
                whole: *whole,
                open: *open,
                of: of.as_ref().map(|of| {
                    let operands = of.operands.iter().map(|operand| self.tree(operand)).list();
                    Box::new(Computed { how: of.how, operands })
                }),
            },
            Tree::Bool(_) | Tree::Int(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => tree.clone(),
        }
    }

    fn read(&mut self, read: Read) -> Read {
        let (kind, of) = match read {
            Read::Rising(id) => (Remembers::Rise, &self.own.edges[id].of),
            Read::Falling(id) => (Remembers::Fall, &self.own.edges[id].of),
            Read::Delay(id) => {
                let delay = &self.own.delays[id];
                (Remembers::Delay(delay.on, delay.off), &delay.of)
            }
            other => return other,
        };
        let of = self.expr(of);
        Read::Memory(self.memory(Memory { kind, of }))
    }

    /// Equal ones are one.
    fn memory(&mut self, memory: Memory) -> MemoryId {
        let same = |other: &Memory| other.kind == memory.kind && other.of.tree.is_alike(&memory.of.tree);
        let found = self.model.memories.iter().find(|(_, other)| same(other)).map(|(id, _)| id);
        found.unwrap_or_else(|| self.model.memories.push(memory))
    }

    /// With what a memory looks at, and the times of its delays.
    fn reads(&mut self, reads: &[Read], all: &mut Vec<Read>) {
        for read in reads {
            let read = self.read(*read);
            let mut found = vec![read];
            if let Read::Memory(id) = read {
                let memory = &self.model.memories[id];
                found.extend(&memory.of.reads);
                if let Remembers::Delay(on, off) = memory.kind {
                    found.extend([on, off].into_iter().filter_map(crate::model::TimeRef::name).map(Read::Name));
                }
            }
            for read in found {
                if !all.contains(&read) {
                    all.push(read);
                }
            }
        }
    }
}
