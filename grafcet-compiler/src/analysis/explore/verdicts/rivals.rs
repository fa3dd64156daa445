//! Which pairs of stored actions run in the same evolution, found out by trying.

use crate::analysis::explore::Limits;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::compile::Compiler;
use crate::analysis::explore::net::formula::{Atom, Formula};
use crate::analysis::explore::search::Search;
use crate::analysis::explore::search::graph::Seen;
use crate::analysis::explore::valuation::{Valuation, When};
use crate::analysis::{Facts, is_constant_read};
use crate::list::List;
use crate::model::{Association, Dialect, Model, Name, Qualifier, Read, StepId, TransitionId, Tree, Trigger};

/// A stored action of a `grafcet` that is watched beside another.
#[derive(Clone, Copy)]
pub(crate) enum Rival<'m> {
    /// Of a step.
    Action(&'m Association),
    /// On the clearing of a transition.
    Clearing(TransitionId),
}

impl<'m> Rival<'m> {
    /// What it asks, beside the change of the situation.
    pub(crate) fn conditions(self) -> impl Iterator<Item = &'m Tree> {
        let association = match self {
            Self::Action(association) => Some(association),
            Self::Clearing(_) => None,
        };
        association.into_iter().flat(|a| a.event.iter().and(&a.condition)).map(|expr| &expr.tree)
    }

    fn is(self, other: Self) -> bool {
        match (self, other) {
            (Self::Action(one), Self::Action(other)) => std::ptr::eq(one, other),
            (Self::Clearing(one), Self::Clearing(other)) => one == other,
            _ => false,
        }
    }

    fn compile(self, compiler: &mut Compiler<'_>) -> Watched {
        let conditions = self.conditions().map(|tree| compiler.formula(tree)).list();
        let at = match self {
            Self::Action(association) => At::Step(association.step, association.qualifier),
            Self::Clearing(id) => At::Transition(id),
        };
        Watched { at, conditions }
    }
}

/// Pairs of which it is asked whether they run in the same evolution.
#[derive(Default)]
pub(crate) struct Rivals {
    pub(crate) all: Vec<Watched>,
    /// The places of both.
    pairs: Vec<(usize, usize)>,
}

impl Rivals {
    pub(crate) fn of<'m>(pairs: &[(Rival<'m>, Rival<'m>)], compiler: &mut Compiler<'_>) -> Self {
        let mut known: Vec<Rival<'m>> = Vec::new();
        let mut number = |rival: Rival<'m>| {
            let place = known.iter().position(|other| other.is(rival));
            place.unwrap_or_else(|| {
                known.push(rival);
                known.len() - 1
            })
        };
        let pairs = pairs.iter().map(|(a, b)| (number(*a), number(*b))).list();
        Self { all: known.iter().map(|rival| rival.compile(compiler)).list(), pairs }
    }
}

/// A [`Rival`] by numbers.
pub(crate) struct Watched {
    at: At,
    pub(crate) conditions: Vec<Formula>,
}

enum At {
    Step(StepId, Qualifier),
    Transition(TransitionId),
}

impl Watched {
    /// Whether it runs in an evolution, as far as the change of the situation tells.
    fn is_due(&self, before: &[StepId], after: &[StepId], cleared: &[TransitionId]) -> bool {
        match &self.at {
            At::Step(step, qualifier) => {
                let (was, is) = (before.binary_search(step).is_ok(), after.binary_search(step).is_ok());
                match qualifier.trigger(Dialect::Grafcet) {
                    Trigger::Deactivation => was && !is,
                    Trigger::Event => was,
                    Trigger::Active | Trigger::Activation => !was && is,
                }
            }
            At::Transition(transition) => cleared.contains(transition),
        }
    }
}

/// Notes which of the watched pairs run in this evolution.
pub(crate) fn note(valuation: &mut Valuation<'_>, before: &[StepId], after: &[StepId], cleared: &[TransitionId]) {
    let rivals = &valuation.net.actions.rivals;
    let due = rivals.all.iter().map(|one| one.is_due(before, after, cleared)).list();
    for (number, (a, b)) in rivals.pairs.iter().enumerate() {
        if !due[*a] || !due[*b] || valuation.have_met[number] || valuation.met.contains(&number) {
            continue;
        }
        let mut conditions = rivals.all[*a].conditions.iter().and(&rivals.all[*b].conditions);
        if conditions.all(|condition| valuation.decide(condition, When::Now)) {
            valuation.met.push(number);
        }
    }
}

/// For each pair whether both can run in the same evolution, under all inputs that the chart does not exclude; `true` also
/// where that could not be excluded.
pub(crate) fn rivals_meeting(
    model: &Model,
    facts: &Facts<'_>,
    limits: &Limits,
    pairs: &[(Rival<'_>, Rival<'_>)],
) -> Vec<bool> {
    let all = vec![true; pairs.len()];
    if limits.only_ways || pairs.len() > PAIRS {
        return all;
    }
    let net = Net::beside(model, facts, pairs);
    if !net.atoms.values().all(is_told) {
        return all;
    }
    let mut seen = Seen::nothing(&net);
    let (complete, met) = Search::new(&net, None, false, limits.work, &mut seen).run_beside(pairs.len());
    if complete { met } else { all }
}

/// More pairs are not looked at.
const PAIRS: usize = 1000;

/// Whether an atom has, at each moment, one of the values that are tried then: what nobody follows changes with actions alone.
fn is_told(atom: &Atom) -> bool {
    let mut told = true;
    atom.what.each_read(&mut |read| {
        told &= is_constant_read(&read) || matches!(read, Read::Name(Name::Var(_) | Name::Output(_)));
    });
    told || atom.is_exact()
}
