//! IC3 (property directed reachability): a proof by an inductive invariant, or a way to where `bad` holds, without unrolling.
//!
//! Frame `i` holds what is certain of all states that at most `i` cycles lead to. A state of the last frame from which `bad` follows is
//! traced back, frame by frame: where it has no predecessor, a cube around it is excluded, as large as can be. Where two frames become
//! the same, what they hold is inductive.

use std::collections::{BTreeMap, BTreeSet};

use crate::limit::{At, Limit, Over};
use crate::sat::{Sat, Term, Wires};
use crate::task::{Cube, Invariant, Task, Way, entry};

/// How it ends.
pub(crate) enum Answer {
    Holds(Invariant),
    Fails(Way),
}

/// A cube that has to be excluded from a frame, because what follows it is bad.
struct Obligation {
    cube: Cube,
    /// The inputs with which it goes on.
    inputs: Vec<usize>,
    /// What it leads to.
    after: Option<usize>,
    depth: usize,
}

pub(crate) struct Pdr<'t, 'c> {
    task: &'t Task<'c>,
    sat: Sat,
    limit: Limit,
    /// Terms of the latches, and of what they are after the cycle, by number.
    now: BTreeMap<usize, Term>,
    next: BTreeMap<usize, Term>,
    inputs: Vec<(usize, Term)>,
    constraint: Term,
    bad: Term,
    /// By frame: holds where the cubes that are excluded there count.
    active: Vec<Term>,
    /// By frame: the cubes that are excluded up to it.
    frames: Vec<Vec<Cube>>,
    obligations: Vec<Obligation>,
    /// By frame and depth.
    queue: BTreeSet<(usize, usize, usize)>,
}

/// What a query finds: the inputs and the state before, or which part of the cube cannot be reached.
enum Before {
    State(Cube, Vec<usize>),
    Never(Cube),
}

impl<'t, 'c> Pdr<'t, 'c> {
    pub(crate) fn new(task: &'t Task<'c>, limit: &Limit) -> Self {
        let aig = &task.circuit.aig;
        let mut sat = Sat::new(limit);
        let mut wires = Wires::new(aig);
        let (mut now, mut next) = (BTreeMap::new(), BTreeMap::new());
        for latch in &task.latches {
            now.insert(*latch, wires.term(&mut sat, aig, task.latch(*latch).now));
        }
        for latch in &task.latches {
            next.insert(*latch, wires.term(&mut sat, aig, task.latch(*latch).next));
        }
        let constraint = wires.term(&mut sat, aig, task.circuit.constraint);
        let bad = wires.term(&mut sat, aig, task.bad);
        let mut inputs = Vec::new();
        for lit in task.inputs() {
            if wires.has(lit) {
                inputs.push((lit.node(), wires.term(&mut sat, aig, lit)));
            }
        }
        let first = sat.term();
        for latch in &task.latches {
            match task.latch(*latch).initial {
                Some(true) => sat.clause(&[!first, now[latch]]),
                Some(false) => sat.clause(&[!first, !now[latch]]),
                None => {}
            }
        }
        Self {
            task,
            sat,
            limit: limit.clone(),
            now,
            next,
            inputs,
            constraint,
            bad,
            active: vec![first],
            frames: vec![Vec::new()],
            obligations: Vec::new(),
            queue: BTreeSet::new(),
        }
    }

    pub(crate) fn run(mut self) -> Result<Answer, Over> {
        loop {
            while let Some((cube, inputs)) = self.bad_state()? {
                if let Some(way) = self.exclude(cube, inputs)? {
                    return Ok(Answer::Fails(way));
                }
            }
            let active = self.sat.term();
            self.active.push(active);
            self.frames.push(Vec::new());
            self.limit.tell(At::Frame(self.last()));
            if let Some(invariant) = self.propagate()? {
                return Ok(Answer::Holds(invariant));
            }
        }
    }

    fn last(&self) -> usize {
        self.frames.len() - 1
    }

    /// The terms that make the cubes of a frame count.
    fn frame(&self, level: usize) -> Vec<Term> {
        let mut terms: Vec<Term> = self.active[level.max(1).min(self.active.len())..].to_vec();
        if level == 0 {
            terms.push(self.active[0]);
        }
        terms
    }

    fn state(&self) -> Cube {
        let code = |(latch, term): (&usize, &Term)| code(*latch, self.sat.holds(*term));
        self.now.iter().map(code).collect()
    }

    fn inputs_on(&self) -> Vec<usize> {
        self.inputs.iter().filter(|(_, term)| self.sat.holds(*term)).map(|(node, _)| *node).collect()
    }

    /// A cube of the last frame, all of whose states show `bad` with the inputs.
    fn bad_state(&mut self) -> Result<Option<(Cube, Vec<usize>)>, Over> {
        let mut assumed = self.frame(self.last());
        assumed.extend([self.constraint, self.bad]);
        if !self.sat.solve(&assumed)? {
            return Ok(None);
        }
        let (state, inputs) = (self.state(), self.inputs_on());
        let lifted = self.lift(&state, &inputs, &[self.bad])?;
        Ok(Some((lifted, inputs)))
    }

    /// The part of a state that is enough for all of these to follow, with the same inputs.
    fn lift(&mut self, state: &[u32], inputs: &[usize], follows: &[Term]) -> Result<Cube, Over> {
        let ask = self.sat.term();
        let mut clause = vec![!ask, !self.constraint];
        clause.extend(follows.iter().map(|term| !*term));
        self.sat.clause(&clause);
        let mut assumed = vec![ask];
        assumed.extend(self.inputs.iter().map(
            |(node, term)| {
                if inputs.binary_search(node).is_ok() { *term } else { !*term }
            },
        ));
        let terms: Vec<Term> = state.iter().map(|code| term(&self.now, *code)).collect();
        assumed.extend(&terms);
        let open = self.sat.solve(&assumed)?;
        let mut lifted = Vec::new();
        for (code, term) in state.iter().zip(terms) {
            if open || self.sat.in_core(term) {
                lifted.push(*code);
            }
        }
        self.sat.clause(&[!ask]);
        Ok(lifted)
    }

    /// Whether a cycle leads from a frame, outside the cube, into the cube.
    fn before(&mut self, cube: &[u32], level: usize) -> Result<Before, Over> {
        let ask = self.sat.term();
        let mut clause = vec![!ask];
        clause.extend(cube.iter().map(|code| !term(&self.now, *code)));
        self.sat.clause(&clause);
        let mut assumed = self.frame(level);
        assumed.extend([ask, self.constraint]);
        let terms: Vec<Term> = cube.iter().map(|code| term(&self.next, *code)).collect();
        assumed.extend(&terms);
        let found = self.sat.solve(&assumed)?;
        let result = if found {
            let (state, inputs) = (self.state(), self.inputs_on());
            self.sat.clause(&[!ask]);
            Before::State(self.lift(&state, &inputs, &terms)?, inputs)
        } else {
            let mut part = Vec::new();
            for (code, term) in cube.iter().zip(&terms) {
                if self.sat.in_core(*term) {
                    part.push(*code);
                }
            }
            self.sat.clause(&[!ask]);
            Before::Never(self.outside(part, cube))
        };
        Ok(result)
    }

    /// The part of a cube, with so much of the rest that no chart begins in it.
    fn outside(&self, mut part: Cube, cube: &[u32]) -> Cube {
        if !self.task.is_no_beginning(&part) {
            if let Some(code) = cube.iter().find(|code| self.task.is_no_beginning(&[**code])) {
                part.push(*code);
                part.sort_unstable();
            }
        }
        part
    }

    /// Excludes a cube from the last frame; the way, if it can be reached.
    fn exclude(&mut self, cube: Cube, inputs: Vec<usize>) -> Result<Option<Way>, Over> {
        self.obligations.clear();
        self.queue.clear();
        self.oblige(Obligation { cube, inputs, after: None, depth: 0 }, self.last());
        while let Some((level, depth, number)) = self.queue.pop_first() {
            let cube = self.obligations[number].cube.clone();
            if level == 0 || !self.task.is_no_beginning(&cube) {
                return Ok(Some(self.way(number)));
            }
            if self.is_excluded(&cube, level) {
                continue;
            }
            match self.before(&cube, level - 1)? {
                Before::State(before, inputs) => {
                    self.queue.insert((level, depth, number));
                    self.oblige(Obligation { cube: before, inputs, after: Some(number), depth: depth + 1 }, level - 1);
                }
                Before::Never(part) => {
                    let (part, level) = self.widened(part, level)?;
                    self.add(part, level);
                    if level < self.last() {
                        self.queue.insert((level + 1, depth, number));
                    }
                }
            }
        }
        Ok(None)
    }

    fn oblige(&mut self, obligation: Obligation, level: usize) {
        self.queue.insert((level, obligation.depth, self.obligations.len()));
        self.obligations.push(obligation);
    }

    fn is_excluded(&self, cube: &[u32], level: usize) -> bool {
        self.frames[level..].iter().flatten().any(|other| is_part(other, cube))
    }

    /// As large a cube as can be excluded, and up to which frame.
    fn widened(&mut self, cube: Cube, level: usize) -> Result<(Cube, usize), Over> {
        let (mut cube, mut level) = (cube, level);
        for code in cube.clone() {
            let mut fewer = cube.clone();
            fewer.retain(|other| *other != code);
            if fewer.len() == cube.len() || !self.task.is_no_beginning(&fewer) {
                continue;
            }
            if let Before::Never(part) = self.before(&fewer, level - 1)? {
                cube = part;
            }
        }
        while level < self.last() {
            match self.before(&cube, level)? {
                Before::Never(_) => level += 1,
                Before::State(..) => break,
            }
        }
        Ok((cube, level))
    }

    fn add(&mut self, cube: Cube, level: usize) {
        for frame in &mut self.frames[..=level] {
            frame.retain(|other| !is_part(&cube, other));
        }
        let mut clause = vec![!self.active[level]];
        clause.extend(cube.iter().map(|code| !term(&self.now, *code)));
        self.sat.clause(&clause);
        self.frames[level].push(cube);
    }

    /// Moves on what holds one cycle later, too.
    fn propagate(&mut self) -> Result<Option<Invariant>, Over> {
        for level in 1..self.last() {
            for cube in self.frames[level].clone() {
                // It may have gone meanwhile, with a larger one.
                if !self.frames[level].contains(&cube) {
                    continue;
                }
                if let Before::Never(part) = self.before(&cube, level)? {
                    self.add(part, level + 1);
                }
            }
            if self.frames[level].is_empty() {
                let mut excluded: Vec<Cube> = self.frames[level + 1..].concat();
                excluded.sort_unstable();
                return Ok(Some(Invariant { excluded, depth: 0 }));
            }
        }
        Ok(None)
    }

    fn way(&self, number: usize) -> Way {
        let first = &self.obligations[number];
        let mut initial = Vec::new();
        for code in &first.cube {
            let (latch, value) = entry(*code);
            if self.task.latch(latch).initial.is_none() {
                initial.push((latch, value));
            }
        }
        let (mut inputs, mut at) = (Vec::new(), Some(number));
        while let Some(number) = at {
            inputs.push(self.obligations[number].inputs.clone());
            at = self.obligations[number].after;
        }
        Way { initial, inputs }
    }
}

pub(crate) fn code(latch: usize, value: bool) -> u32 {
    u32::try_from(latch).unwrap_or(u32::MAX >> 1) << 1 | u32::from(value)
}

/// Whether one sorted list is a part of another.
fn is_part(part: &[u32], of: &[u32]) -> bool {
    part.len() <= of.len() && part.iter().all(|code| of.binary_search(code).is_ok())
}

fn term(of: &BTreeMap<usize, Term>, code: u32) -> Term {
    let (latch, value) = entry(code);
    if value { of[&latch] } else { !of[&latch] }
}
