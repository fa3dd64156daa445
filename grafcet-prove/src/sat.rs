//! The SAT solver after a small interface, so that another one can take its place (docs/decisions/sat.md), and how a circuit's gates get
//! there.

use std::cell::Cell;
use std::rc::Rc;

use batsat::{BasicCallbacks, Lit as Inner, Solver, SolverInterface, SolverOpts, Var, lbool};

use crate::aig::{Aig, Lit, Node};
use crate::limit::{Limit, Over};

/// A variable of the solver, or its negation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Term(Inner);

impl std::ops::Not for Term {
    type Output = Self;

    fn not(self) -> Self {
        Self(!self.0)
    }
}

/// How many values a step of the solver finds: the solver tells only after a search, and a search has to end.
struct Pace {
    steps: Cell<u64>,
    each: Cell<u64>,
}

impl Pace {
    /// In a search of few steps, most values are found before the first one.
    const LONG: u64 = 64;

    fn new() -> Self {
        Self { steps: Cell::new(0), each: Cell::new(100) }
    }

    /// One step more, which is taken to find as many values as those of the last long search.
    fn step(&self, limit: &Limit) {
        self.steps.set(self.steps.get() + 1);
        limit.found(self.each.get());
    }

    /// After a search, in which so many values were found: what was told is corrected.
    fn correct(&self, limit: &Limit, found: u64) {
        let steps = self.steps.take();
        let told = steps * self.each.get();
        limit.found(found.saturating_sub(told));
        limit.not_found(told.saturating_sub(found));
        if steps >= Self::LONG {
            self.each.set(found / steps);
        }
    }
}

pub(crate) struct Sat {
    solver: Solver<BasicCallbacks>,
    limit: Limit,
    pace: Rc<Pace>,
    /// What gates come to follows from what they read, and is not tried.
    inputs_only: bool,
}

impl Sat {
    pub(crate) fn new(limit: &Limit) -> Self {
        let mut callbacks = BasicCallbacks::new();
        let pace = Rc::new(Pace::new());
        let (over, step) = (limit.clone(), Rc::clone(&pace));
        callbacks.set_stop(move || {
            step.step(&over);
            over.is_over()
        });
        Self { solver: Solver::new(SolverOpts::default(), callbacks), limit: limit.clone(), pace, inputs_only: false }
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
        // To take up a clause is as much work as to find a value.
        self.limit.found(1);
        let mut clause: Vec<Inner> = terms.iter().map(|term| term.0).collect();
        self.solver.add_clause_reuse(&mut clause);
    }

    /// Whether there is a model in which all of these hold.
    pub(crate) fn solve(&mut self, assumed: &[Term]) -> Result<bool, Over> {
        if self.limit.is_over() {
            return Err(Over);
        }
        let assumed: Vec<Inner> = assumed.iter().map(|term| term.0).collect();
        let before = self.solver.num_propagations();
        let found = self.solver.solve_limited(&assumed);
        self.pace.correct(&self.limit, self.solver.num_propagations() - before);
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
