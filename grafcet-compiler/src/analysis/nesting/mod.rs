//! Well-nested charts, which are decided by reduction in about linear time, however many situations they have.
//!
//! Steps that plain arrows connect are a sequence, with alternatives and loops as one likes. Where transitions enter some
//! sequences together and leave them together only, these are the branches of a block, and the block is taken for one
//! step; and so on, from the innermost blocks outwards, until one sequence is left. Whatever has become active in such a
//! chart comes to the end of its branch, waits there for the others, and goes on with them: one branch after the other can be
//! led there by the inputs, whatever the others do meanwhile. So no step is activated while it is active, nothing waits forever,
//! and everything can happen, if each transition can clear alone among those that leave the same steps ([`free`]).

mod free;

use super::Union;
use super::hierarchy::initial_situation;
use crate::list::List;
use crate::model::{Id, InputId, Model, Name, Read, StepId, TransitionId, Tree};
use crate::sorted::Set;

/// A chart that is one sequence in the end.
pub struct Nesting {
    /// What stands in the outermost sequence.
    nodes: Vec<Node>,
    /// Per node those that arrows lead to it from.
    before: Vec<Vec<usize>>,
    /// Parallel branches have no inputs in common.
    independent: bool,
}

/// A step, or a block that is taken for one.
#[derive(Clone)]
struct Node {
    /// `None` for a block.
    step: Option<StepId>,
    active: bool,
    /// In how many ways it can be active.
    situations: u64,
    /// What is read within.
    inputs: Set<InputId>,
}

/// A transition, between steps and blocks.
struct Arc {
    sources: Vec<usize>,
    targets: Vec<usize>,
    /// `false` where it lies within a block.
    outside: bool,
}

impl Arc {
    fn is_plain(&self) -> bool {
        matches!((&self.sources[..], &self.targets[..]), ([_], [_]))
    }
}

impl Nesting {
    /// Reduces a chart; `None` if it is not well nested.
    #[must_use]
    pub fn of(model: &Model) -> Option<Self> {
        Self::starting(model, &initial_situation(model))
    }

    /// The same from a known initial situation.
    pub(super) fn starting(model: &Model, initial: &Set<StepId>) -> Option<Self> {
        let ends = |arcs: &[StepId]| arcs.is_empty();
        let open = model.transitions.values().any(|arc| ends(&arc.sources) || ends(&arc.targets));
        if open || model.partials.len() != 1 || !model.forces.is_empty() {
            return None;
        }
        let mut reduction = Reduction::new(model, initial);
        while reduction.arcs.iter().any(|arc| arc.outside && !arc.is_plain()) {
            if !reduction.round() {
                return None;
            }
        }
        reduction.outermost()
    }

    /// So many situations there are at most.
    #[must_use]
    pub fn situations(&self) -> u64 {
        sum(self.nodes.iter().map(|node| node.situations))
    }

    /// Nothing is to be found out by exploring the chart: it does whatever its structure allows. `never` are the
    /// inputs that do not occur.
    #[must_use]
    pub fn tells_all(&self, model: &Model, never: &[&Tree]) -> bool {
        never.is_empty() && self.independent && free::is_free(model, never) && free::can_wait(model, never)
    }

    /// From every situation there is a way to exactly `home`; `false` where that does not follow from the structure.
    #[must_use]
    pub fn returns_to(&self, model: &Model, home: &[StepId], never: &[&Tree]) -> bool {
        let [home] = home else { return false };
        let Some(node) = self.nodes.iter().position(|node| node.step == Some(*home)) else { return false };
        reached(&[node], &self.before).iter().all(|returns| *returns)
            && free::is_free(model, never)
            && free::comes_to_rest(model, *home, never)
    }
}

struct Reduction<'m> {
    model: &'m Model,
    nodes: Vec<Node>,
    /// By transition.
    arcs: Vec<Arc>,
    /// Per node, whether it has become part of a block.
    inside: Vec<bool>,
    independent: bool,
}

/// The sequences at the beginning of a round.
struct Sequences {
    /// Per node.
    of: Vec<usize>,
    nodes: Vec<Vec<usize>>,
    /// The arcs within each, and those that enter or leave it beside others.
    within: Vec<Vec<usize>>,
    entering: Vec<Vec<usize>>,
    leaving: Vec<Vec<usize>>,
}

impl<'m> Reduction<'m> {
    fn new(model: &'m Model, initial: &Set<StepId>) -> Self {
        let node = |step: StepId| Node {
            step: Some(step),
            active: initial.contains(&step),
            situations: 1,
            inputs: Set::new(),
        };
        let numbers = |steps: &[StepId]| steps.iter().map(|step| step.index()).list();
        let arcs = model.transitions.values();
        let arcs = arcs.map(|t| Arc { sources: numbers(&t.sources), targets: numbers(&t.targets), outside: true });
        Self {
            model,
            nodes: model.steps.ids().map(node).list(),
            arcs: arcs.list(),
            inside: vec![false; model.steps.len()],
            independent: true,
        }
    }

    fn sequences(&self) -> Sequences {
        let mut union = Union::new(self.nodes.len());
        let outside = || self.arcs.iter().enumerate().filter(|(_, arc)| arc.outside);
        for (_, arc) in outside().filter(|(_, arc)| arc.is_plain()) {
            union.join(arc.sources[0], arc.targets[0]);
        }
        let of: Vec<usize> = (0..self.nodes.len()).map(|node| union.root(node)).list();
        let none = || vec![Vec::new(); of.len()];
        let (mut nodes, mut within, mut entering, mut leaving) = (none(), none(), none(), none());
        for node in (0..of.len()).filter(|node| !self.inside[*node]) {
            nodes[of[node]].push(node);
        }
        for (number, arc) in outside() {
            if arc.is_plain() {
                within[of[arc.sources[0]]].push(number);
                continue;
            }
            arc.targets.iter().for_each(|target| entering[of[*target]].push(number));
            arc.sources.iter().for_each(|source| leaving[of[*source]].push(number));
        }
        Sequences { of, nodes, within, entering, leaving }
    }

    /// Takes the innermost blocks for steps; `false` if there are none.
    fn round(&mut self) -> bool {
        let sequences = self.sequences();
        let mut found = false;
        for number in 0..self.arcs.len() {
            let arc = &self.arcs[number];
            // Steps of this round are not looked at before the next.
            let is_fork = arc.outside && arc.targets.len() > 1 && arc.targets.iter().all(|t| *t < sequences.of.len());
            if is_fork && !self.inside[arc.targets[0]] {
                let branches: Vec<usize> = arc.targets.iter().map(|target| sequences.of[*target]).list();
                if self.is_block(&sequences, &branches) {
                    self.enclose(&sequences, &branches);
                    found = true;
                }
            }
        }
        found
    }

    /// Whether sequences are the branches of a block.
    fn is_block(&self, sequences: &Sequences, branches: &[usize]) -> bool {
        let of = |node: &usize| sequences.of.get(*node).copied();
        let all: Set<Option<usize>> = branches.iter().map(|branch| Some(*branch)).collect();
        let one_each = |nodes: &[usize]| nodes.len() == all.len() && nodes.iter().map(of).collect::<Set<_>>() == all;
        let mut entering = branches.iter().flat(|branch| &sequences.entering[*branch]);
        let mut leaving = branches.iter().flat(|branch| &sequences.leaving[*branch]);
        let Some(first) = leaving.next() else { return false };
        let last: Set<usize> = self.arcs[*first].sources.iter().copied().collect();
        let starts = branches.iter().filter(|branch| self.starts(sequences, **branch)).count();
        all.len() == branches.len()
            && one_each(&self.arcs[*first].sources)
            && leaving.all(|arc| self.arcs[*arc].sources.iter().copied().collect::<Set<_>>() == last)
            && entering.all(|arc| one_each(&self.arcs[*arc].targets))
            && (starts == 0 || starts == branches.len())
            && branches.iter().all(|branch| self.is_branch(sequences, *branch, &last))
    }

    fn starts(&self, sequences: &Sequences, branch: usize) -> bool {
        sequences.nodes[branch].iter().any(|node| self.nodes[*node].active)
    }

    /// Whether all of a sequence is reached from where it is entered, and its last step, which nothing else leaves, from
    /// all of it.
    fn is_branch(&self, sequences: &Sequences, branch: usize, last: &Set<usize>) -> bool {
        let nodes = &sequences.nodes[branch];
        let arcs = || sequences.within[branch].iter().map(|arc| &self.arcs[*arc]);
        let Some(last) = nodes.iter().find(|node| last.contains(*node)) else { return false };
        let number = |node: usize| nodes.binary_search(&node).unwrap_or_default();
        let (mut before, mut after) = (vec![Vec::new(); nodes.len()], vec![Vec::new(); nodes.len()]);
        for arc in arcs() {
            let (from, to) = (number(arc.sources[0]), number(arc.targets[0]));
            after[from].push(to);
            before[to].push(from);
        }
        let entered = sequences.entering[branch].iter().flat(|arc| &self.arcs[*arc].targets);
        let active: Vec<usize> = nodes.iter().copied().filter(|node| self.nodes[*node].active).list();
        let first: Vec<usize> =
            entered.and(&active).filter(|node| nodes.contains(node)).map(|node| number(*node)).list();
        active.len() < 2
            && after[number(*last)].is_empty()
            && reached(&first, &after).iter().all(|is| *is)
            && reached(&[number(*last)], &before).iter().all(|is| *is)
    }

    /// Takes branches for one step.
    fn enclose(&mut self, sequences: &Sequences, branches: &[usize]) {
        let mut block =
            Node { step: None, active: self.starts(sequences, branches[0]), situations: 1, inputs: Set::new() };
        for branch in branches {
            let nodes = &sequences.nodes[*branch];
            let situations = sum(nodes.iter().map(|node| self.nodes[*node].situations));
            block.situations = block.situations.saturating_mul(situations);
            let mut inputs = Set::new();
            for node in nodes {
                self.inside[*node] = true;
                inputs.extend(std::mem::take(&mut self.nodes[*node].inputs));
            }
            for arc in &sequences.within[*branch] {
                self.arcs[*arc].outside = false;
                let transition = &self.model.transitions[TransitionId::new(*arc)];
                inputs_of(self.model, &transition.condition.reads, &mut inputs);
            }
            self.independent &= block.inputs.is_disjoint(&inputs);
            block.inputs.extend(inputs);
        }
        let number = self.nodes.len();
        for branch in branches {
            for arc in &sequences.entering[*branch] {
                self.arcs[*arc].targets = vec![number];
            }
            for arc in &sequences.leaving[*branch] {
                self.arcs[*arc].sources = vec![number];
            }
        }
        self.nodes.push(block);
        self.inside.push(false);
    }

    /// What is left, if it is one sequence that goes on from each of its steps.
    fn outermost(self) -> Option<Nesting> {
        let left: Vec<usize> = (0..self.nodes.len()).filter(|node| !self.inside[*node]).list();
        let number = |node: usize| left.binary_search(&node).unwrap_or_default();
        let (mut before, mut after) = (vec![Vec::new(); left.len()], vec![Vec::new(); left.len()]);
        for arc in self.arcs.iter().filter(|arc| arc.outside) {
            let (from, to) = (number(arc.sources[0]), number(arc.targets[0]));
            after[from].push(to);
            before[to].push(from);
        }
        let nodes: Vec<Node> = left.iter().map(|node| self.nodes[*node].clone()).list();
        let active: Vec<usize> = (0..nodes.len()).filter(|node| nodes[*node].active).list();
        let is_sequence = active.len() == 1
            && after.iter().all(|next| !next.is_empty())
            && reached(&active, &after).iter().all(|is| *is);
        is_sequence.then_some(Nesting { nodes, before, independent: self.independent })
    }
}

/// What can be reached from some nodes.
fn reached(from: &[usize], next: &[Vec<usize>]) -> Vec<bool> {
    let mut reached = vec![false; next.len()];
    let mut work = from.to_vec();
    while let Some(node) = work.pop() {
        if !std::mem::replace(&mut reached[node], true) {
            work.extend(&next[node]);
        }
    }
    reached
}

fn sum(numbers: impl Iterator<Item = u64>) -> u64 {
    numbers.fold(0, u64::saturating_add)
}

/// The inputs that a condition reads.
fn inputs_of(model: &Model, reads: &[Read], inputs: &mut Set<InputId>) {
    for read in reads {
        match read {
            Read::Name(Name::Input(id)) => _ = inputs.insert(*id),
            Read::Rising(edge) | Read::Falling(edge) => inputs_of(model, &model.edges[*edge].of.reads, inputs),
            _ => {}
        }
    }
}
