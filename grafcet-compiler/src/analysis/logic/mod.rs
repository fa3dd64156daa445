//! Conditions as boolean functions over their atoms.
//!
//! An atom is a boolean name, a step variable, an edge, a delay, or any Rust that is not looked into, which is equal
//! only to its own text. Comparisons of one number with constants are about one atom, the number; comparisons of two
//! unknown values are about how they compare. What atoms have to do with each other is added to each question: steps
//! that are never active together, the time of a step that is not active, edges and what they are edges of.
//!
//! Every question has a budget; one that it does not suffice for is answered as if nothing had been proved.

mod atoms;
mod formula;
mod links;
mod ranges;
mod read;
mod solve;
mod values;
mod witness;

pub(super) use witness::UNKNOWN;

use std::cell::{Cell, RefCell};

use self::atoms::{Atom, Atoms, Key};
use self::formula::{AtomId, Formula};
use self::links::{Fact, Links};
use self::read::Reader;
use self::solve::{Domains, Search, Undecided};
use self::values::{Values, is_of_inputs};
use super::Concurrency;
use crate::list::List;
use crate::model::{Model, Name, Read, Tree};
use crate::sorted::{Map, Set};

/// How many functions are looked at for one question before it counts as undecided.
const QUESTION: u32 = 20_000;

/// What it costs to put a question, in the same unit.
const PUT: u32 = 10;

/// The same for all questions of one chart, and more for each of its transitions.
const ALL: u32 = 300_000;
const EACH: u32 = 500;

/// Decides questions about conditions of one chart.
pub struct Logic<'m> {
    model: &'m Model,
    concurrency: Option<&'m Concurrency>,
    atoms: RefCell<Atoms>,
    links: RefCell<Links>,
    budget: Cell<u32>,
}

/// A condition that a [`Logic`] has read; it belongs to that one.
#[derive(Clone, Debug)]
pub struct Condition {
    formula: Formula,
    in_action: bool,
    /// Between which values atoms lie wherever it holds, by atom.
    demands: Vec<(AtomId, i128, i128)>,
}

impl Condition {
    /// Whether the two demand different values of one atom.
    fn clashes(&self, other: &Self) -> bool {
        let mut theirs = other.demands.iter().peekable();
        self.demands.iter().any(|(atom, low, high)| {
            while theirs.next_if(|(other, ..)| other < atom).is_some() {}
            let same = theirs.next_if(|(other, ..)| other == atom);
            same.is_some_and(|(_, other_low, other_high)| high < other_low || other_high < low)
        })
    }
}

/// What was found out about conditions that shall hold, or not hold, together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Under no valuation.
    Never,
    /// Under some valuation, such as `a = true, level = 7`.
    Witness(String),
    /// The budget did not suffice.
    Undecided,
}

/// How much a witness may rely on atoms about which nothing is known.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Trust {
    /// An unknown atom may have any value.
    Any,
    /// The answer has to hold whatever the value of an unknown atom is.
    Known,
}

impl<'m> Logic<'m> {
    /// About the conditions of `model` alone.
    #[must_use]
    pub fn new(model: &'m Model) -> Self {
        Self {
            model,
            concurrency: None,
            atoms: RefCell::default(),
            links: RefCell::default(),
            budget: Cell::new(Self::budget(model)),
        }
    }

    /// The same where none of `never`, which are about inputs, ever holds.
    #[must_use]
    pub fn assuming(model: &'m Model, never: &[&Tree]) -> Self {
        let logic = Self::new(model);
        for tree in never {
            let formula = logic.formula(tree);
            logic.links.borrow_mut().assume_never(&formula, &mut logic.atoms.borrow_mut());
        }
        logic
    }

    /// About conditions in the situations that the chart can reach, where none of `never`, which are about inputs, ever
    /// holds.
    #[must_use]
    pub fn within(model: &'m Model, concurrency: &'m Concurrency, never: &[&Tree]) -> Self {
        Self { concurrency: Some(concurrency), ..Self::assuming(model, never) }
    }

    fn budget(model: &Model) -> u32 {
        let transitions = u32::try_from(model.transitions.len()).unwrap_or(u32::MAX);
        transitions.saturating_mul(EACH).saturating_add(ALL)
    }

    /// Reads a condition of a transition.
    #[must_use]
    pub fn condition(&self, tree: &Tree) -> Condition {
        let formula = self.formula(tree);
        Condition { demands: formula.demands(), formula, in_action: false }
    }

    /// Reads a condition or event of an action.
    #[must_use]
    pub fn of_action(&self, tree: &Tree) -> Condition {
        Condition { in_action: true, ..self.condition(tree) }
    }

    fn formula(&self, tree: &Tree) -> Formula {
        Reader { model: self.model, atoms: &mut self.atoms.borrow_mut() }.formula(tree)
    }

    /// Whether some valuations do not count.
    #[must_use]
    pub fn has_assumptions(&self) -> bool {
        self.links.borrow().has_assumptions()
    }

    /// Whether a condition can never hold; `false` where that cannot be shown.
    #[must_use]
    pub fn never(&self, a: &Condition) -> bool {
        self.impossible(&[(a, true)])
    }

    /// Whether a condition always holds; `false` where that cannot be shown.
    #[must_use]
    pub fn always(&self, a: &Condition) -> bool {
        self.impossible(&[(a, false)])
    }

    /// Whether two conditions never hold together; `false` where that cannot be shown.
    #[must_use]
    pub fn exclusive(&self, a: &Condition, b: &Condition) -> bool {
        self.impossible(&[(a, true), (b, true)])
    }

    /// Whether one of `others` holds wherever `a` does; `false` where that cannot be shown.
    #[must_use]
    pub fn implies(&self, a: &Condition, others: &[&Condition]) -> bool {
        let goals: Vec<_> = others.iter().map(|other| (*other, false)).and([(a, true)]).list();
        self.impossible(&goals)
    }

    /// Whether two conditions always hold together; `false` where that cannot be shown.
    #[must_use]
    pub fn equivalent(&self, a: &Condition, b: &Condition) -> bool {
        self.implies(a, &[b]) && self.implies(b, &[a])
    }

    /// Whether the conditions cannot have these values together; `false` where that cannot be shown.
    #[must_use]
    pub fn impossible(&self, goals: &[(&Condition, bool)]) -> bool {
        let answer = self.ask(goals, Trust::Any, |_, _| String::new());
        answer == Answer::Never
    }

    /// Whether the conditions can have these values together, where `given` holds and is not worth mentioning.
    #[must_use]
    pub fn together(&self, goals: &[(&Condition, bool)], given: &[&Condition]) -> Answer {
        self.ask_beside(goals, Trust::Any, given)
    }

    /// Whether the conditions have these values together under some valuation of what is known, whatever the value of
    /// Rust that is not looked into and of comparisons whose relation to each other is not known.
    #[must_use]
    pub fn certainly_together(&self, goals: &[(&Condition, bool)], given: &[&Condition]) -> Answer {
        self.ask_beside(goals, Trust::Known, given)
    }

    /// Asks with `given`, the atoms of which the witness does not mention.
    fn ask_beside(&self, goals: &[(&Condition, bool)], trust: Trust, given: &[&Condition]) -> Answer {
        let mut known = Set::new();
        for condition in given {
            condition.formula.each_atom(&mut |atom| _ = known.insert(atom));
        }
        let all: Vec<_> = given.iter().map(|condition| (*condition, true)).and(goals.iter().copied()).list();
        let text = |order: &[AtomId], found: &Domains| {
            let order: Vec<AtomId> = order.iter().copied().filter(|atom| !known.contains(atom)).list();
            witness::text(self.model, &self.atoms.borrow(), &order, found)
        };
        self.ask(&all, trust, text)
    }

    /// `text` makes a witness of the atoms in question, in order, and what was found.
    fn ask(
        &self,
        goals: &[(&Condition, bool)],
        trust: Trust,
        text: impl FnOnce(&[AtomId], &Domains) -> String,
    ) -> Answer {
        // Most branches exclude each other at first sight.
        if let [.., (first, true), (second, true)] = goals {
            if first.clashes(second) {
                return Answer::Never;
            }
        }
        if self.budget.get() < PUT {
            return Answer::Undecided;
        }
        let mut order: Vec<AtomId> = Vec::new();
        let mut asked = Set::new();
        for (condition, _) in goals {
            condition.formula.each_atom(&mut |atom| {
                if asked.insert(atom) {
                    order.push(atom);
                }
            });
        }
        let in_action = goals.iter().any(|(condition, _)| condition.in_action);
        let links = {
            let (mut links, mut atoms) = (self.links.borrow_mut(), self.atoms.borrow_mut());
            links.about(self.model, self.concurrency, &mut atoms, &mut asked, in_action)
        };
        let goals = goals.iter().map(|(condition, wanted)| (&condition.formula, *wanted));
        let all = links.iter().map(|link| (&*link.formula, true)).and(goals.clone());
        let found = if trust == Trust::Known {
            let loose = self.loose(&asked);
            // An assumption about what nobody knows may exclude whatever is found.
            let is_assumed = |link: &&Fact| link.is_assumed;
            let certain: Vec<(Formula, bool)> = links
                .iter()
                .filter(is_assumed)
                .map(|link| (&*link.formula, true))
                .and(goals)
                .map(|(formula, wanted)| (formula.certainly(wanted, &|atom| loose.contains(&atom)), wanted))
                .list();
            let all = links.iter().map(|link| (&*link.formula, true));
            self.solve(&asked, all.and(certain.iter().map(|(formula, wanted)| (formula, *wanted))).list(), true)
        } else {
            self.solve(&asked, all.list(), false)
        };
        match found {
            Err(Undecided) => Answer::Undecided,
            Ok(None) => Answer::Never,
            Ok(Some(found)) => Answer::Witness(text(&order, &found)),
        }
    }

    fn solve(
        &self,
        asked: &Set<AtomId>,
        goals: Vec<(&Formula, bool)>,
        sure: bool,
    ) -> Result<Option<Domains>, Undecided> {
        let atoms = self.atoms.borrow();
        let domain = |id: &AtomId| atoms.get(*id).map(|atom| (*id, atom.domain.clone()));
        let domains: Map<_, _> = asked.iter().filter_map(domain).collect();
        let budget = QUESTION.min(self.budget.get()).checked_sub(PUT).ok_or(Undecided)?;
        let values = Values::of(self.model, &atoms, asked);
        let mut search = Search { budget, values: values.as_ref(), sure };
        let found = search.solve(domains, goals);
        self.budget.set(self.budget.get() - PUT - (budget - search.budget));
        found
    }

    /// The atoms of a question whose values may depend on each other in a way that is not known.
    fn loose(&self, asked: &Set<AtomId>) -> Set<AtomId> {
        let atoms = self.atoms.borrow();
        // Of plain values it is known how they compare; but of two params one may be meant to be the greater one.
        let is_open = |id: &AtomId| match atoms.get(*id).map(|atom| &atom.key) {
            Some(Key::Order(a, b)) => !is_plain(a) || !is_plain(b) || is_param(a) || is_param(b),
            Some(Key::Boolean(Tree::Read(Read::Blink(_)))) => true,
            _ => false,
        };
        let reads = |id: &AtomId| {
            let mut reads: Vec<Read> = Vec::new();
            match atoms.get(*id).map(|atom| &atom.key) {
                Some(Key::Order(a, b)) => {
                    for tree in [a, b] {
                        tree.each_read(&mut |read| reads.push(read));
                    }
                }
                Some(Key::Number(a)) => a.each_read(&mut |read| reads.push(read)),
                // What blinks follows the time of its step.
                Some(Key::Boolean(Tree::Read(Read::Blink(blink)))) => reads.push(blink.of.since()),
                _ => {}
            }
            reads
        };
        let shared = |id: &AtomId| {
            let own = reads(id);
            asked.iter().any(|other| other != id && reads(other).iter().any(|read| own.contains(read)))
        };
        // What is computed of inputs is tried.
        let is_tried = |atom: &Atom| match &atom.key {
            Key::Number(tree) => atom.is_computed && is_of_inputs(self.model, &[tree]),
            Key::Order(a, b) => atom.is_computed && is_of_inputs(self.model, &[a, b]),
            _ => false,
        };
        let is_loose = |id: &&AtomId| {
            atoms.get(**id).is_none_or(|atom| (atom.is_loose || is_open(id) && shared(id)) && !is_tried(atom))
        };
        asked.iter().filter(is_loose).copied().collect()
    }
}

fn is_param(tree: &Tree) -> bool {
    matches!(tree, Tree::Read(Read::Name(Name::Param(_))))
}

/// A value that is not computed.
fn is_plain(tree: &Tree) -> bool {
    matches!(tree, Tree::Read(_) | Tree::Int(_))
}
