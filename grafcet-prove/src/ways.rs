//! From where inputs lead to a target: backwards from it, cube by cube, each with the inputs of one cycle.
//!
//! A state from which a cycle leads to a cube that is known is looked for; around it a cube is made, as large as can be, from all of which the
//! same inputs lead there. Nothing is asked about how a chart gets to such a state. Where no more are found, no others have a way.

use crate::aig::{Aig, Lit, Node, value};
use crate::circuit::{Circuit, Condition, Source};
use crate::pdr::code;
use crate::sat::{Limit, Over, Sat, Term, Wires};
use crate::steps::Steps;
use crate::task::{Cube, cone, entry};

/// What a way may rely on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trust {
    /// On what is certain: whatever Rust that is not looked into comes to, and with no result that leaves its type.
    Certain,
    /// On anything that can be.
    Possible,
}

/// From all of a cube these inputs lead, in one cycle, to the target, or to cubes that are nearer to it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Lead {
    pub cube: Cube,
    /// The inputs that are on, by their nodes, ascending.
    pub inputs: Vec<usize>,
    /// How many cycles it may take after this one.
    pub after: usize,
}

/// Ways to a target.
#[derive(Clone, Debug)]
pub struct Ways {
    pub target: Condition,
    /// The nearer ones first.
    pub leads: Vec<Lead>,
}

impl Ways {
    /// So many cycles, at most, where they are gone as they are found.
    #[must_use]
    pub fn longest(&self) -> usize {
        self.leads.last().map_or(0, |lead| lead.after + 1)
    }
}

/// The inputs of a circuit that whoever looks for a way may choose, and those that are as they like.
pub(crate) fn inputs(circuit: &Circuit) -> (Vec<Lit>, Vec<Lit>) {
    let (mut chosen, mut open) = (Vec::new(), Vec::new());
    for wire in &circuit.inputs {
        let kind = if matches!(wire.source, Source::Rust(_)) { &mut open } else { &mut chosen };
        kind.extend(&wire.bits);
    }
    (chosen, open)
}

/// The bits of the time that passes between two cycles, by their nodes.
fn times(circuit: &Circuit) -> Vec<usize> {
    let times = circuit.inputs.iter().filter(|wire| wire.source == Source::Elapsed);
    times.flat_map(|wire| &wire.bits).map(|bit| bit.node()).collect()
}

/// What has to hold in each cycle of a way.
pub(crate) fn may(circuit: &mut Circuit, trust: Trust) -> Lit {
    let no_overflow = if trust == Trust::Certain { !circuit.overflow } else { Lit::TRUE };
    circuit.aig.and(circuit.constraint, no_overflow)
}

/// What a cube costs in steps of the solver, as measured.
const NODES_PER_STEP: u64 = 4;

/// A search that is this short is looked for at first: two evolutions, and one that finds that nothing more clears.
const SHORT: usize = 6;

/// A cube is widened as far as its inputs lead to one of the last so many before it.
const NEAR: usize = 100;

/// One cycle in the solver; of the open inputs all copies have values of their own.
struct Cycle {
    next: Vec<Term>,
    target: Term,
    may: Term,
    /// It ends in the target or in one of the first so many cubes.
    arrives_at_all: Option<(usize, Term)>,
}

/// Wires and what the latches among them become.
fn roots(circuit: &Circuit, latches: &[usize], wires: &[Lit]) -> Vec<Lit> {
    latches.iter().map(|latch| circuit.latches[*latch].next).chain(wires.iter().copied()).collect()
}

pub(crate) struct Search<'c> {
    circuit: &'c Circuit,
    sat: Sat,
    limit: Limit,
    steps: &'c Steps,
    /// The nodes that matter, ascending.
    nodes: Vec<usize>,
    /// The latches that matter, by their numbers, and their terms.
    latches: Vec<usize>,
    now: Vec<Term>,
    target: Condition,
    /// Inputs that are chosen, those of times as long as can be for a start.
    chosen: Vec<(usize, Term)>,
    open: Vec<(Lit, Term)>,
    /// Set where a search goes beyond its first evolutions.
    short: Option<Lit>,
    /// The first one has the open inputs as they are best, the others as they were in the way.
    cycles: Vec<Cycle>,
    may: Lit,
    leads: Vec<Lead>,
}

impl<'c> Search<'c> {
    /// `may` holds in each cycle of a way.
    pub(crate) fn new(
        (circuit, steps): (&'c Circuit, &'c Steps),
        target: Condition,
        may: Lit,
        trust: Trust,
        limit: &Limit,
    ) -> Self {
        let aig = &circuit.aig;
        let latches = cone(circuit, vec![target.now, target.end, may, steps.known]);
        let (mut sat, mut wires) = (Sat::of_inputs(limit), Wires::new(aig));
        let (mut chosen, mut open) = inputs(circuit);
        if trust == Trust::Possible {
            chosen.append(&mut open);
        }
        let nodes = aig.cone(&roots(circuit, &latches, &[target.now, target.end, may, steps.known]));
        let mut of = |lits: Vec<Lit>| -> Vec<(Lit, Term)> {
            let mut terms = Vec::new();
            for lit in lits.into_iter().filter(|lit| nodes.binary_search(&lit.node()).is_ok()) {
                let term = sat.term_on();
                wires.bind(lit, term);
                terms.push((lit, term));
            }
            terms
        };
        let (chosen, open) = (of(chosen), of(open));
        let chosen = chosen.into_iter().map(|(lit, term)| (lit.node(), term)).collect();
        let now: Vec<Term> =
            latches.iter().map(|latch| wires.term(&mut sat, aig, circuit.latches[*latch].now)).collect();
        let cycle = Self::cycle(circuit, &latches, (target, may), &mut sat, &mut wires);
        let (here, known) = (wires.term(&mut sat, aig, target.now), wires.term(&mut sat, aig, steps.known));
        sat.clause(&[!here]);
        sat.clause(&[known]);
        let short = None;
        let cycles = vec![cycle];
        let limit = limit.clone();
        Self {
            circuit,
            sat,
            limit,
            steps,
            nodes,
            latches,
            now,
            target,
            chosen,
            open,
            short,
            cycles,
            may,
            leads: Vec::new(),
        }
    }

    fn cycle(
        circuit: &Circuit,
        latches: &[usize],
        (target, may): (Condition, Lit),
        sat: &mut Sat,
        wires: &mut Wires,
    ) -> Cycle {
        let next = latches.iter().map(|latch| wires.term(sat, &circuit.aig, circuit.latches[*latch].next)).collect();
        let target = wires.term(sat, &circuit.aig, target.end);
        Cycle { next, target, may: wires.term(sat, &circuit.aig, may), arrives_at_all: None }
    }

    /// The same among cycles in which a search ends soon. None where that is always so.
    pub(crate) fn short(mut self) -> Option<Self> {
        let long = *self.circuit.rounds.get(SHORT)?;
        let mut wires = self.wires();
        for (node, term) in &self.chosen {
            wires.bind(Lit::of(*node), *term);
        }
        for (lit, term) in &self.open {
            wires.bind(*lit, *term);
        }
        let term = wires.term(&mut self.sat, &self.circuit.aig, long);
        self.sat.clause(&[!term]);
        self.short = Some(long);
        Some(self)
    }

    /// The same among cycles before which as much time passes as can: then a time that is waited for is over. None where no time counts.
    pub(crate) fn patient(mut self) -> Option<Self> {
        let times = times(self.circuit);
        let bits: Vec<Term> =
            self.chosen.iter().filter(|(node, _)| times.contains(node)).map(|(_, term)| *term).collect();
        for bit in &bits {
            self.sat.clause(&[*bit]);
        }
        (!bits.is_empty()).then_some(self)
    }

    /// What another search has found.
    pub(crate) fn knowing(mut self, ways: Ways) -> Self {
        ways.leads.into_iter().for_each(|lead| self.add(lead));
        self
    }

    pub(crate) fn ways(&self) -> Ways {
        Ways { target: self.target, leads: self.leads.clone() }
    }

    /// Looks for ways from where `inside` holds, from so many cubes at most; whether no more are to be found.
    pub(crate) fn run(&mut self, inside: Lit, most: usize) -> Result<bool, Over> {
        let mut wires = self.wires();
        let inside = wires.term(&mut self.sat, &self.circuit.aig, inside);
        // From where one cycle leads to what is known, then from where one leads to that and to what has been found so, and so on.
        loop {
            let known = self.leads.len();
            let arrives = self.arrives();
            while let Some(lead) = self.before(known, [inside, arrives])? {
                if self.leads.len() == most {
                    return Ok(false);
                }
                self.add(lead);
            }
            if self.leads.len() == known {
                return Ok(true);
            }
        }
    }

    /// A term that is true only where a cycle leads to something that is known, whatever the open inputs are.
    fn arrives(&mut self) -> Term {
        let all = self.sat.term();
        for cycle in 0..self.cycles.len() {
            self.arrives_with(cycle, self.leads.len(), all);
        }
        all
    }

    /// That term, for the open inputs of one cycle.
    fn arrives_with(&mut self, cycle: usize, known: usize, all: Term) {
        // What has been said of the first cubes is not said again.
        let (from, before) = match self.cycles[cycle].arrives_at_all {
            Some((count, before)) if count <= known => (count, before),
            _ => (0, self.cycles[cycle].target),
        };
        let here = self.sat.term();
        let mut any = vec![!here, before];
        for lead in from..known {
            any.push(self.arrives_at(cycle, lead));
        }
        self.sat.clause(&any);
        self.cycles[cycle].arrives_at_all = Some((known, here));
        self.sat.clause(&[!all, here]);
        self.sat.clause(&[!all, self.cycles[cycle].may]);
    }

    /// A term that is true only where a cycle ends in a cube.
    fn arrives_at(&mut self, cycle: usize, lead: usize) -> Term {
        let here = self.sat.term();
        for code in self.leads[lead].cube.clone() {
            let (latch, value) = entry(code);
            let next = self.cycles[cycle].next[self.index(latch)];
            self.sat.clause(&[!here, if value { next } else { !next }]);
        }
        here
    }

    fn add(&mut self, lead: Lead) {
        let clause: Vec<Term> = lead.cube.iter().map(|code| !self.term_now(*code)).collect();
        self.sat.clause(&clause);
        self.leads.push(lead);
    }

    /// The latches as they are, for wires of which only they decide.
    fn wires(&self) -> Wires {
        let mut wires = Wires::new(&self.circuit.aig);
        for (latch, term) in self.latches.iter().zip(&self.now) {
            wires.bind(self.circuit.latches[*latch].now, *term);
        }
        wires
    }

    fn index(&self, latch: usize) -> usize {
        self.latches.binary_search(&latch).unwrap_or(usize::MAX)
    }

    fn term_now(&self, code: u32) -> Term {
        let (latch, value) = entry(code);
        let term = self.now[self.index(latch)];
        if value { term } else { !term }
    }

    /// A state of which no way is known yet, and inputs that lead on from it to the first so many cubes.
    fn before(&mut self, known: usize, assumed: [Term; 2]) -> Result<Option<Lead>, Over> {
        loop {
            if !self.sat.solve(&assumed)? {
                return Ok(None);
            }
            let state = self.state();
            let on = |(node, term): &(usize, Term)| self.sat.holds(*term).then_some(*node);
            let mut inputs: Vec<usize> = self.chosen.iter().filter_map(on).collect();
            inputs.sort_unstable();
            let near = self.near(&inputs, known);
            let (simpler, mut otherwise) = (self.simpler(&inputs, &near), None);
            for inputs in [simpler, inputs] {
                match self.widened(&state, &inputs, &near)? {
                    Ok(cube) => {
                        let after = known.checked_sub(1).map_or(0, |last| self.leads[last].after + 1);
                        return Ok(Some(Lead { cube, inputs, after }));
                    }
                    Err(open) => otherwise = Some(open),
                }
            }
            if let Some(otherwise) = otherwise {
                self.beside(known, assumed[1], &otherwise);
            }
        }
    }

    /// The cubes with which one is looked for around the state in the last model: those found last, and one to which it leads. With open inputs
    /// all of them, as it may lead elsewhere with each value of these.
    fn near(&self, inputs: &[usize], known: usize) -> Vec<usize> {
        if !self.open.is_empty() {
            return (0..known).collect();
        }
        let values = self.values(&self.free(inputs));
        let last = known.saturating_sub(NEAR);
        let mut near: Vec<usize> = (0..last).filter(|lead| self.is_inside(*lead, &values)).take(1).collect();
        near.extend(last..known);
        near
    }

    /// The free nodes in the last model, with these inputs.
    fn free(&self, inputs: &[usize]) -> Vec<bool> {
        let mut free = vec![false; self.circuit.aig.len()];
        for (latch, term) in self.latches.iter().zip(&self.now) {
            free[self.circuit.latches[*latch].now.node()] = self.sat.holds(*term);
        }
        for (lit, term) in &self.open {
            free[lit.node()] = self.sat.holds(*term);
        }
        for node in inputs {
            free[*node] = true;
        }
        free
    }

    fn values(&self, free: &[bool]) -> Vec<bool> {
        self.circuit.aig.simulate(|node| free[node])
    }

    /// Whether a cycle ends in a cube.
    fn is_inside(&self, lead: usize, values: &[bool]) -> bool {
        let cube = self.leads[lead].cube.iter().map(|code| entry(*code));
        cube.into_iter().all(|(latch, on)| value(values, self.circuit.latches[latch].next) == on)
    }

    /// The inputs of the last model without those that can be off, and with as much time as can pass: what happens beside the way is as little as can be,
    /// so that it is gone from more states.
    fn simpler(&self, inputs: &[usize], near: &[usize]) -> Vec<usize> {
        let mut free = self.free(inputs);
        let time = times(self.circuit);
        // From the last one on: what is declared first is what the plant is about.
        for (node, _) in self.chosen.iter().rev() {
            let before = free[*node];
            free[*node] = time.contains(node);
            if free[*node] != before && !self.leads_on(&free, near) {
                free[*node] = before;
            }
        }
        let mut on: Vec<usize> = self.chosen.iter().map(|(node, _)| *node).filter(|node| free[*node]).collect();
        on.sort_unstable();
        on
    }

    /// Whether a cycle leads on, by the values of free nodes, to what a cube around the state is looked for with.
    fn leads_on(&self, free: &[bool], near: &[usize]) -> bool {
        let values = self.values(free);
        let is = |lit: Lit| value(&values, lit);
        let short = self.short.is_none_or(|long| !is(long));
        let arrives = || is(self.target.end) || near.iter().any(|lead| self.is_inside(*lead, &values));
        short && is(self.may) && arrives()
    }

    /// The state in the last model. Which step of a region is active is told by that step alone.
    fn state(&self) -> Cube {
        let code = |(latch, term): (&usize, &Term)| {
            let value = self.sat.holds(*term);
            (!self.steps.is_told(*latch, value)).then(|| code(*latch, value))
        };
        self.latches.iter().zip(&self.now).filter_map(code).collect()
    }

    /// One more cycle, with the open inputs as they were where the last way led nowhere.
    fn beside(&mut self, known: usize, arrives: Term, otherwise: &[bool]) {
        let mut wires = self.wires();
        for (node, term) in &self.chosen {
            wires.bind(Lit::of(*node), *term);
        }
        let truth = self.sat.term();
        self.sat.clause(&[truth]);
        for ((lit, _), on) in self.open.iter().zip(otherwise) {
            wires.bind(*lit, if *on { truth } else { !truth });
        }
        let cycle = Self::cycle(self.circuit, &self.latches, (self.target, self.may), &mut self.sat, &mut wires);
        self.cycles.push(cycle);
        self.arrives_with(self.cycles.len() - 1, known, arrives);
    }

    /// The cube around a state, as large as can be, from which these inputs lead on whatever the open ones are; where that is not so of the state
    /// itself, open ones with which they do not.
    fn widened(&self, state: &[u32], inputs: &[usize], near: &[usize]) -> Result<Result<Cube, Vec<bool>>, Over> {
        // Its gates are gone through several times.
        self.limit.spend(self.nodes.len() as u64 / NODES_PER_STEP);
        let mut given = Given::new(self, inputs, near);
        let Some(mut cube) = given.core(state)? else { return Ok(Err(given.otherwise())) };
        for code in cube.clone() {
            let fewer: Cube = cube.iter().copied().filter(|other| *other != code).collect();
            if fewer.len() < cube.len() {
                if let Some(less) = given.core(&fewer)? {
                    cube = less;
                }
            }
        }
        // Where it need not be this step, some others are left out.
        for code in cube.clone() {
            let Some(others) = self.steps.beside(code) else { continue };
            let wider: Cube = cube.iter().copied().filter(|other| *other != code).chain(others.clone()).collect();
            if let Some(wider) = given.core(&wider)? {
                if others.iter().any(|other| !wider.contains(other)) {
                    cube = wider;
                }
            }
        }
        cube.sort_unstable();
        Ok(Ok(cube))
    }
}

/// One cycle with inputs that are given: most gates come to nothing then.
struct Given {
    sat: Sat,
    /// By latch: its term, where it matters.
    now: Vec<Option<Term>>,
    /// The open inputs.
    open: Vec<Term>,
    /// It does not lead on.
    fails: Term,
}

impl Given {
    fn new(search: &Search<'_>, inputs: &[usize], near: &[usize]) -> Self {
        let circuit = search.circuit;
        let mut aig = Aig::default();
        let mut of: Vec<Lit> = vec![Lit::FALSE; circuit.aig.len()];
        let mut chosen = search.chosen.iter().map(|(node, _)| *node).collect::<Vec<usize>>();
        chosen.sort_unstable();
        let mut long = Lit::FALSE;
        for node in &search.nodes {
            of[*node] = match circuit.aig.node(*node) {
                Node::False => Lit::FALSE,
                Node::Free if chosen.binary_search(node).is_ok() => Lit::constant(inputs.binary_search(node).is_ok()),
                Node::Free => aig.free(),
                Node::And(a, b) => {
                    let of = |lit: Lit| of[lit.node()].xor(lit.is_negated());
                    aig.and(of(a), of(b))
                }
            };
            // That the search is short is asked for, and what it would do otherwise is no matter.
            if let Some(lit) = search.short.filter(|lit| lit.node() == *node) {
                long = of[*node].xor(lit.is_negated());
                of[*node] = Lit::constant(lit.is_negated());
            }
        }
        let is = |lit: Lit| of[lit.node()].xor(lit.is_negated());
        let mut arrives = is(search.target.end);
        for lead in near {
            let mut here = Lit::TRUE;
            for code in &search.leads[*lead].cube {
                let (latch, value) = entry(*code);
                here = aig.and(here, is(circuit.latches[latch].next).xor(!value));
            }
            arrives = aig.or(arrives, here);
        }
        let may = aig.and(is(search.may), !long);
        let leads = aig.and(may, arrives);
        let (mut sat, mut wires) = (Sat::of_inputs(&search.limit), Wires::new(&aig));
        let mut now = vec![None; circuit.latches.len()];
        for latch in &search.latches {
            now[*latch] = Some(wires.term(&mut sat, &aig, is(circuit.latches[*latch].now)));
        }
        let known = wires.term(&mut sat, &aig, is(search.steps.known));
        sat.clause(&[known]);
        let open = search.open.iter().map(|(lit, _)| wires.term(&mut sat, &aig, is(*lit))).collect();
        let fails = !wires.term(&mut sat, &aig, leads);
        Self { sat, now, open, fails }
    }

    /// The open inputs in the last model.
    fn otherwise(&self) -> Vec<bool> {
        self.open.iter().map(|term| self.sat.holds(*term)).collect()
    }

    /// The part of a cube from which they lead on; none where they do not from all of it.
    fn core(&mut self, cube: &[u32]) -> Result<Option<Cube>, Over> {
        let mut assumed = vec![self.fails];
        for code in cube {
            let (latch, value) = entry(*code);
            assumed.extend(self.now[latch].map(|term| if value { term } else { !term }));
        }
        if self.sat.solve(&assumed)? {
            return Ok(None);
        }
        let part = cube.iter().zip(&assumed[1..]).filter(|(_, term)| self.sat.in_core(**term));
        Ok(Some(part.map(|(code, _)| *code).collect()))
    }
}
