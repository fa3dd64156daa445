//! What has to clear with a transition: in a `grafcet` all that is enabled and whose condition holds clears at once.

use crate::analysis::Relation;
use crate::list::{List, PushAll};
use crate::model::{Binary, ForceOrder, Id, Model, PartialId, Read, Transition, TransitionId, Tree, Unary};
use crate::sorted::{Map, Set};

/// Per transition those with one source step that clear in the same evolution if that step is active: their condition
/// follows from its own and from its sources, and no order holds them that does not hold it, too.
pub(super) fn of(model: &Model, may_meet: &Relation, granted: &Set<TransitionId>) -> Vec<Vec<usize>> {
    let terms = Terms::of(model, granted);
    let dragged = |(id, transition): (TransitionId, &Transition)| -> Vec<usize> {
        let Some(own) = &terms.by_transition[id.index()] else { return Vec::new() };
        let sources: Vec<usize> = transition.sources.iter().map(|step| step.index()).list();
        let mut given: Set<usize> = own.clone();
        given.extend((0..terms.all.len()).filter(|term| follows(terms.all[*term], &sources, may_meet)));
        let mut held: Vec<usize> = terms.without.clone();
        held.push_all(given.iter().flat(|term| terms.first_in[*term].iter().copied()));
        held.retain(|other| {
            let theirs = &model.transitions[TransitionId::new(*other)];
            *other != id.index()
                && theirs.sources.len() == 1
                && terms.by_transition[*other].as_ref().is_some_and(|terms| terms.is_subset(&given))
                && is_free(model, transition.partial, theirs)
        });
        held
    };
    model.transitions.iter().map(dragged).list()
}

/// What conditions are made of: each holds where all of its terms do.
struct Terms<'m> {
    all: Vec<&'m Tree>,
    /// `None` for conditions that are not looked at.
    by_transition: Vec<Option<Set<usize>>>,
    /// Per term the transitions of whose terms it is the first.
    first_in: Vec<Vec<usize>>,
    /// The transitions whose conditions always hold.
    without: Vec<usize>,
}

impl<'m> Terms<'m> {
    fn of(model: &'m Model, granted: &Set<TransitionId>) -> Self {
        let mut numbers: Map<&Tree, usize> = Map::new();
        let mut terms = Self { all: Vec::new(), by_transition: Vec::new(), first_in: Vec::new(), without: Vec::new() };
        for (id, transition) in model.transitions.iter() {
            if granted.contains(&id) {
                terms.by_transition.push(None);
                continue;
            }
            let mut own: Set<usize> = Set::new();
            let mut open = vec![&transition.condition.tree];
            while let Some(tree) = open.pop() {
                match tree {
                    Tree::Bool(true) => {}
                    Tree::Binary(Binary::And | Binary::BitAnd, a, b) => open.push_all([&**a, &**b]),
                    _ => {
                        let next = numbers.len();
                        let number = *numbers.or_insert_with(tree, || next);
                        if number == next {
                            terms.all.push(tree);
                            terms.first_in.push(Vec::new());
                        }
                        own.insert(number);
                    }
                }
            }
            match own.first() {
                Some(first) => terms.first_in[*first].push(id.index()),
                None => terms.without.push(id.index()),
            }
            terms.by_transition.push(Some(own));
        }
        terms
    }
}

/// Whether a term holds because these steps are active.
fn follows(term: &Tree, active: &[usize], may_meet: &Relation) -> bool {
    match term {
        Tree::Read(Read::Active(step)) => active.contains(&step.index()),
        Tree::Unary(Unary::Not, inner) => match &**inner {
            Tree::Read(Read::Active(step)) => {
                active.iter().any(|source| *source != step.index() && !may_meet.contains(*source, step.index()))
            }
            _ => false,
        },
        _ => false,
    }
}

/// Whether what keeps this transition's source step keeps the other partial grafcet, too.
fn is_free(model: &Model, beside: PartialId, transition: &Transition) -> bool {
    let keeps = |order: &ForceOrder| match order {
        ForceOrder::Hold | ForceOrder::Init => true,
        ForceOrder::Steps(steps) => !steps.is_empty(),
    };
    let orders = || model.forces.values();
    orders()
        .filter(|force| force.target == transition.partial && keeps(&force.order))
        .all(|force| orders().any(|other| other.step == force.step && other.target == beside))
}
