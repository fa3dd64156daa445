//! The search itself: which states lead to what is known, in a solver that learns of each cube that is found.

use super::{Lead, Leads, Trust, inputs, times};
use crate::aig::Lit;
use crate::circuit::{Circuit, Condition};
use crate::limit::{At, Limit, Over};
use crate::sat::{Sat, Term, Wires};
use crate::steps::Steps;
use crate::task::{cone, entry};

/// A search that is this short is looked for at first: two evolutions, and one that finds that nothing more clears.
const SHORT: usize = 6;

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
    pub(super) circuit: &'c Circuit,
    pub(super) sat: Sat,
    pub(super) limit: Limit,
    pub(super) steps: &'c Steps,
    /// The nodes that matter, ascending.
    pub(super) nodes: Vec<usize>,
    /// The latches that matter, by their numbers, and their terms.
    pub(super) latches: Vec<usize>,
    pub(super) now: Vec<Term>,
    pub(super) target: Condition,
    /// Inputs that are chosen, those of times as long as can be for a start.
    pub(super) chosen: Vec<(usize, Term)>,
    pub(super) open: Vec<(Lit, Term)>,
    /// Set where a search goes beyond its first evolutions.
    pub(super) short: Option<Lit>,
    /// The first one has the open inputs as they are best, the others as they were in the way.
    cycles: Vec<Cycle>,
    pub(super) may: Lit,
    pub(super) leads: Vec<Lead>,
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
    pub(crate) fn knowing(mut self, ways: Leads) -> Self {
        ways.leads.into_iter().for_each(|lead| self.add(lead));
        self
    }

    pub(crate) fn ways(&self) -> Leads {
        Leads { target: self.target, leads: self.leads.clone() }
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
        self.limit.tell(At::Ways(self.leads.len()));
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
}
