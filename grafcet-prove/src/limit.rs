//! How long the solver may search: for a time, for so many steps, or for so much work as a chart's properties have together.

use std::cell::Cell;
use std::rc::Rc;
use std::time::{Duration, Instant};

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
    Within(Limit, Effort),
    Watched(Limit, Watch),
}

/// What all searches of a chart may cost together, counted in values that the solver finds for its variables: a step takes as long as it finds
/// values, and finds few or ten thousands. Who has a copy spends the same.
#[derive(Clone)]
pub(crate) struct Effort(Rc<Purse>);

struct Purse {
    left: Cell<u64>,
    is_spent: Cell<bool>,
}

impl Effort {
    pub(crate) fn new(values: u64) -> Self {
        Self(Rc::new(Purse { left: Cell::new(values), is_spent: Cell::new(false) }))
    }

    /// Whether nothing was left when somebody asked, and stays so, though a search may turn out to have found less.
    pub(crate) fn is_spent(&self) -> bool {
        self.0.is_spent.set(self.0.is_spent.get() || self.left() == 0);
        self.0.is_spent.get()
    }

    pub(crate) fn left(&self) -> u64 {
        self.0.left.get()
    }

    /// A share of so much, which is spent here until it comes back.
    pub(crate) fn part(&self, values: u64) -> Self {
        let values = values.min(self.left());
        self.spend(values);
        Self::new(values)
    }

    /// What a share has not spent comes back.
    pub(crate) fn take_back(&self, share: &Self) {
        self.regain(share.0.left.take());
    }

    fn regain(&self, values: u64) {
        self.0.left.set(self.left().saturating_add(values));
    }

    fn spend(&self, values: u64) {
        self.0.left.set(self.left().saturating_sub(values));
    }
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

    /// The same limit, as long as anything is left of the effort.
    #[must_use]
    pub(crate) fn within(self, effort: &Effort) -> Self {
        Self(Rc::new(Bound::Within(self, effort.clone())))
    }

    /// Half of the steps and of the effort that are left, and so many steps at most.
    pub(crate) fn half(&self, most: u64) -> Self {
        let (steps, effort) = self.left();
        let part = self.part(steps.map_or(most, |left| most.min(left / 2)));
        effort.map_or(part.clone(), |left| part.within(&Effort::new(left / 2)))
    }

    /// The steps and the effort that are left, where these are limited.
    fn left(&self) -> (Option<u64>, Option<u64>) {
        match &*self.0 {
            Bound::None | Bound::Until(..) => (None, None),
            Bound::Work(left) => (Some(left.get()), None),
            Bound::Part(whole, left) => (Some(left.get()), whole.left().1),
            Bound::Within(whole, effort) => (whole.left().0, Some(effort.left())),
            Bound::Watched(whole, _) => whole.left(),
        }
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
            Bound::Part(whole, _) | Bound::Within(whole, _) => whole.tell(at),
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
            Bound::Within(whole, effort) => whole.is_over() || effort.is_spent(),
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
            Bound::Within(whole, _) | Bound::Watched(whole, _) => whole.spend(steps),
        }
    }

    /// The solver has found so many values.
    pub(crate) fn found(&self, values: u64) {
        self.efforts(&|effort| effort.spend(values));
    }

    /// Nor were so many found that have been told.
    pub(crate) fn not_found(&self, values: u64) {
        self.efforts(&|effort| effort.regain(values));
    }

    fn efforts(&self, tell: &dyn Fn(&Effort)) {
        match &*self.0 {
            Bound::None | Bound::Until(..) | Bound::Work(_) => {}
            Bound::Part(whole, _) | Bound::Watched(whole, _) => whole.efforts(tell),
            Bound::Within(whole, effort) => {
                tell(effort);
                whole.efforts(tell);
            }
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
