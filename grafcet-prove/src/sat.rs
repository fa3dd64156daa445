//! The SAT solver behind a small interface, so that another one can take its place (docs/decisions/sat.md), and how a circuit's gates get
//! there.

use std::cell::Cell;
use std::rc::Rc;
use std::time::{Duration, Instant};

use batsat::{BasicCallbacks, Lit as Inner, Solver, SolverInterface, SolverOpts, Var, lbool};

use crate::aig::{Aig, Lit, Node};

/// How long is searched, and who is told of it.
#[derive(Clone)]
pub struct Limit(Rc<Bound>);

/// How far a search is, for whoever waits for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum At {
    /// This cycle from the beginning on is looked at.
    Cycle(usize),
    /// This frame of IC3.
    Frame(usize),
    /// What steps and what clocks have to do with each other.
    Lemmas,
    /// So many sets of states with a way home have been found.
    Ways(usize),
}

/// Who is told how far a search is; nothing where it only goes on.
type Watch = Box<dyn Fn(Option<At>)>;

enum Bound {
    None,
    Until(Instant, Cell<bool>),
    Work(Cell<u64>),
    Part(Limit, Cell<u64>),
    Watched(Limit, Watch),
}

impl Limit {
    #[must_use]
    pub fn none() -> Self {
        Self(Rc::new(Bound::None))
    }

    /// For so long.
    #[must_use]
    pub fn time(time: Duration) -> Self {
        let until = Instant::now().checked_add(time);
        Self(Rc::new(until.map_or(Bound::None, |until| Bound::Until(until, Cell::new(false)))))
    }

    /// So many steps of the solver: the same on every machine.
    #[must_use]
    pub fn work(steps: u64) -> Self {
        Self(Rc::new(Bound::Work(Cell::new(steps))))
    }

    /// So many steps at most of what is left.
    #[must_use]
    pub fn part(&self, steps: u64) -> Self {
        Self(Rc::new(Bound::Part(self.clone(), Cell::new(steps))))
    }

    /// Half of the steps that are left, and so many at most.
    pub(crate) fn half(&self, most: u64) -> Self {
        let left = match &*self.0 {
            Bound::Work(left) | Bound::Part(_, left) => left.get() / 2,
            Bound::None | Bound::Until(..) | Bound::Watched(..) => most,
        };
        self.part(left.min(most))
    }

    /// The same limit; `watch` is told how far the search is, and, with nothing, again and again that it goes on.
    #[must_use]
    pub fn watched(self, watch: impl Fn(Option<At>) + 'static) -> Self {
        Self(Rc::new(Bound::Watched(self, Box::new(watch))))
    }

    /// Tells how far the search is.
    pub(crate) fn tell(&self, at: At) {
        match &*self.0 {
            Bound::None | Bound::Until(..) | Bound::Work(_) => {}
            Bound::Part(whole, _) => whole.tell(at),
            Bound::Watched(whole, watch) => {
                watch(Some(at));
                whole.tell(at);
            }
        }
    }

    /// Whether it is reached, and stays so. Asking is a step.
    #[must_use]
    pub fn is_over(&self) -> bool {
        match &*self.0 {
            Bound::None => false,
            Bound::Until(until, over) => {
                over.set(over.get() || Instant::now() >= *until);
                over.get()
            }
            Bound::Work(left) => Self::step(left),
            Bound::Part(whole, left) => Self::step(left) || whole.is_over(),
            Bound::Watched(whole, watch) => {
                watch(None);
                whole.is_over()
            }
        }
    }

    /// So many steps more are taken than are asked about: work that is none of the solver's.
    pub(crate) fn spend(&self, steps: u64) {
        match &*self.0 {
            Bound::None | Bound::Until(..) => {}
            Bound::Work(left) => left.set(left.get().saturating_sub(steps)),
            Bound::Part(whole, left) => {
                left.set(left.get().saturating_sub(steps));
                whole.spend(steps);
            }
            Bound::Watched(whole, _) => whole.spend(steps),
        }
    }

    fn step(left: &Cell<u64>) -> bool {
        left.set(left.get().saturating_sub(1));
        left.get() == 0
    }
}

/// The limit is reached.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Over;

/// A variable of the solver, or its negation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Term(Inner);

impl std::ops::Not for Term {
    type Output = Self;

    fn not(self) -> Self {
        Self(!self.0)
    }
}

pub(crate) struct Sat {
    solver: Solver<BasicCallbacks>,
    limit: Limit,
    /// What gates come to follows from what they read, and is not tried.
    inputs_only: bool,
}

impl Sat {
    pub(crate) fn new(limit: &Limit) -> Self {
        let mut callbacks = BasicCallbacks::new();
        let stop = limit.clone();
        callbacks.set_stop(move || stop.is_over());
        Self { solver: Solver::new(SolverOpts::default(), callbacks), limit: limit.clone(), inputs_only: false }
    }

    /// One that tries values of inputs alone: for many easy questions, whose answers shall be simple.
    pub(crate) fn of_inputs(limit: &Limit) -> Self {
        Self { inputs_only: true, ..Self::new(limit) }
    }

    pub(crate) fn term(&mut self) -> Term {
        Term(Inner::new(self.solver.new_var_default(), true))
    }

    /// One that is true where nothing asks for anything else.
    pub(crate) fn term_on(&mut self) -> Term {
        Term(Inner::new(self.solver.new_var(lbool::TRUE, true), true))
    }

    fn gate(&mut self) -> Term {
        Term(Inner::new(self.solver.new_var(lbool::UNDEF, !self.inputs_only), true))
    }

    pub(crate) fn clause(&mut self, terms: &[Term]) {
        let mut clause: Vec<Inner> = terms.iter().map(|term| term.0).collect();
        self.solver.add_clause_reuse(&mut clause);
    }

    /// Whether there is a model in which all of these hold.
    pub(crate) fn solve(&mut self, assumed: &[Term]) -> Result<bool, Over> {
        if self.limit.is_over() {
            return Err(Over);
        }
        let assumed: Vec<Inner> = assumed.iter().map(|term| term.0).collect();
        let found = self.solver.solve_limited(&assumed);
        if found == lbool::TRUE {
            Ok(true)
        } else if found == lbool::FALSE {
            Ok(false)
        } else {
            Err(Over)
        }
    }

    /// In the last model; what it leaves open is false.
    pub(crate) fn holds(&self, term: Term) -> bool {
        self.solver.value_lit(term.0) == lbool::TRUE
    }

    /// Whether it was one of the assumptions that cannot hold together.
    pub(crate) fn in_core(&self, term: Term) -> bool {
        let var: Var = term.0.var();
        self.solver.unsat_core_contains_var(var)
    }
}

/// The wires of a circuit as terms, each made where it is first asked for.
pub(crate) struct Wires {
    terms: Vec<Option<Term>>,
}

impl Wires {
    pub(crate) fn new(aig: &Aig) -> Self {
        Self { terms: vec![None; aig.len()] }
    }

    /// The term of a free node is that of another circuit's wire.
    pub(crate) fn bind(&mut self, lit: Lit, term: Term) {
        self.terms[lit.node()] = Some(if lit.is_negated() { !term } else { term });
    }

    /// Whether the node of a wire has been made.
    pub(crate) fn has(&self, lit: Lit) -> bool {
        self.terms[lit.node()].is_some()
    }

    pub(crate) fn term(&mut self, sat: &mut Sat, aig: &Aig, lit: Lit) -> Term {
        self.terms.resize(aig.len().max(self.terms.len()), None);
        let mut open = vec![lit.node()];
        while let Some(node) = open.last().copied() {
            if self.terms[node].is_some() {
                open.pop();
                continue;
            }
            match aig.node(node) {
                Node::False => {
                    let term = sat.term();
                    sat.clause(&[!term]);
                    self.terms[node] = Some(term);
                }
                Node::Free => self.terms[node] = Some(sat.term()),
                Node::And(a, b) => match (self.terms[a.node()], self.terms[b.node()]) {
                    (Some(x), Some(y)) => {
                        let (x, y) = (signed(x, a), signed(y, b));
                        let term = sat.gate();
                        sat.clause(&[!term, x]);
                        sat.clause(&[!term, y]);
                        sat.clause(&[term, !x, !y]);
                        self.terms[node] = Some(term);
                    }
                    (x, y) => {
                        open.extend(x.is_none().then_some(a.node()));
                        open.extend(y.is_none().then_some(b.node()));
                    }
                },
            }
        }
        // It has been made above.
        let term = self.terms[lit.node()].unwrap_or_else(|| sat.term());
        signed(term, lit)
    }
}

fn signed(term: Term, lit: Lit) -> Term {
    if lit.is_negated() { !term } else { term }
}
