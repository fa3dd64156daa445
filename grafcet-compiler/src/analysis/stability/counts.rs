//! Circles that a count ends: `Lift -[up && strokes < 2]-> Lower`, where `Lower` counts the strokes.
//!
//! Of what clears again and again in one search, nothing but such steps writes the count. So it grows, and each turn needs it to be small.

use super::length::Lengths;
use super::successors::{LARGE, Successors};
use super::{Candidates, circles, entered_again};
use crate::analysis::Concurrency;
use crate::list::{List, PushAll};
use crate::model::{
    Binary, Computed, Effect, How, Id, Integer, Model, Name, Place, Qualifier, Read, Statement, StepId, TransitionId,
    Tree, Ty, Unary,
};
use crate::sorted::Set;

/// A place that a circle counts in.
struct Count {
    /// The most that it holds where the circle goes on.
    most: i128,
    /// The transitions that need it to be no more.
    limited: Candidates,
    /// The transitions with which it grows, and by how much each.
    grows: Vec<(TransitionId, i128)>,
    /// Those that clear a bounded number of times, and with which it may begin anew.
    others: Vec<TransitionId>,
}

/// After how many evolutions a count has ended the circle, if these are all that can clear again and again.
pub(super) fn turns(
    model: &Model,
    concurrency: &Concurrency,
    lengths: &Lengths<'_>,
    successors: &mut Successors<'_>,
    (allowed, circle): (&Candidates, &Candidates),
) -> Option<u64> {
    if circle.len() > LARGE {
        return None;
    }
    // Who forces a chart can put two of its steps beside each other.
    if model.forceable || !is_one_path(model, concurrency, circle) {
        return None;
    }
    let allowed = lasting(model, successors, allowed.clone());
    // What brings the circle to life from outside could do so at any moment.
    let enters = |id: &TransitionId| is_entry(model, successors, *id, circle);
    if allowed.difference(circle).any(enters) {
        return None;
    }
    let partial = circle.iter().map(|id| model.transitions[*id].partial).next()?;
    // What others are entered by would be entered as often as it turns.
    let is_inside = |step: &StepId| model.steps[*step].partial == partial;
    if !circle.iter().all(|id| successors.activates(*id).iter().all(is_inside)) {
        return None;
    }
    let entries = lengths.entries_into(successors, partial, circle);
    let places: Set<Place> = circle.iter().flat(|id| compared(&model.transitions[*id].condition.tree)).collect();
    let ends = |place: &Place| {
        let count = Count::of(model, successors, (&allowed, circle), *place)?;
        let resets = count.resets(model, concurrency, lengths, circle, entries);
        count.turns(successors, circle, entries, resets)
    };
    let found: Vec<Option<u64>> = places.iter().map(ends).list();
    found.into_iter().flatten().min()
}

/// Whether one step of the circle at most is active at a time, so that its transitions clear one after the other.
fn is_one_path(model: &Model, concurrency: &Concurrency, circle: &Candidates) -> bool {
    let transitions = circle.iter().map(|id| &model.transitions[*id]).list();
    let steps = transitions.iter().flat(|transition| transition.sources.clone()).list();
    let alone =
        |at: usize| steps[..at].iter().all(|other| *other == steps[at] || !concurrency.together(*other, steps[at]));
    transitions.iter().all(|one| one.sources.len() == 1 && one.sources != one.targets) && (0..steps.len()).all(alone)
}

/// Whether a transition activates a step of the circle.
fn is_entry(model: &Model, successors: &Successors<'_>, id: TransitionId, circle: &Candidates) -> bool {
    let steps = successors.activates(id);
    circle.iter().any(|one| model.transitions[*one].sources.iter().any(|step| steps.contains(step)))
}

/// Without the transitions that clear a bounded number of times: they are in no circle, and all that leads to them passes tokens on, one for one, of which they take one away for
/// good.
fn lasting(model: &Model, successors: &mut Successors<'_>, mut allowed: Candidates) -> Candidates {
    loop {
        let mut multiplied: Vec<TransitionId> =
            allowed.iter().copied().filter(|id| !passes_on(model, successors, &allowed, *id)).list();
        let mut stays: Candidates = circles(successors, &allowed).into_iter().flatten().collect();
        stays = stays.into_iter().chain(multiplied.iter().copied()).collect();
        while let Some(id) = multiplied.pop() {
            for next in successors.after(id) {
                if allowed.contains(&next) && stays.insert(next) {
                    multiplied.push(next);
                }
            }
        }
        if stays.len() == allowed.len() {
            return allowed;
        }
        allowed = entered_again(successors, stays);
    }
}

/// Whether a transition makes no second token of one, together with others of these that clear beside it.
fn passes_on(model: &Model, successors: &mut Successors<'_>, allowed: &Candidates, id: TransitionId) -> bool {
    let [source] = model.transitions[id].sources[..] else { return false };
    let goes_on = |step: &&StepId| model.leaving[step.index()].iter().any(|next| allowed.contains(next));
    if successors.activates(id).iter().filter(goes_on).count() > 1 {
        return false;
    }
    let beside = model.leaving[source.index()].iter().filter(|other| **other != id && allowed.contains(other)).list();
    beside.into_iter().all(|other| successors.exclude(id, *other))
}

impl Count {
    /// `None` where something in the way of the circle writes the place otherwise.
    fn of(
        model: &Model,
        successors: &Successors<'_>,
        (allowed, circle): (&Candidates, &Candidates),
        place: Place,
    ) -> Option<Self> {
        let condition = |id: &TransitionId| limit(&model.transitions[*id].condition.tree, true, place);
        let limits: Vec<(TransitionId, i128)> = circle.iter().filter_map(|id| Some((*id, condition(id)?))).list();
        let most = limits.iter().map(|(_, limit)| *limit).max()?;
        let (mut grows, mut grows_beside, mut others) = (Vec::new(), Vec::new(), Vec::new());
        let bounded = model.transitions.ids().filter(|id| !allowed.contains(id)).list();
        for association in model.associations.values().filter(|one| one.effect.writes().contains(&place)) {
            let step = association.step;
            match association.qualifier {
                Qualifier::P1 => {
                    let by = if association.condition.is_none() { grown(&association.effect, place) } else { None };
                    // What is forced may be active already, and is not activated then.
                    let by = |id: &TransitionId| by.filter(|_| model.transitions[*id].targets.contains(&step));
                    let activates = |id: &&TransitionId| successors.activates(**id).contains(&step);
                    for id in allowed.iter().filter(activates) {
                        grows.push((*id, by(id)?));
                    }
                    for id in bounded.iter().filter(activates) {
                        match by(id) {
                            Some(by) => grows_beside.push((*id, by)),
                            None => others.push(*id),
                        }
                    }
                }
                Qualifier::P0 => {
                    let stays =
                        model.forces.is_empty() && model.partials[model.steps[step].partial].enclosed_by.is_none();
                    let leaves = |id: &TransitionId| model.transitions[*id].sources.contains(&step);
                    if allowed.iter().any(leaves) || !stays {
                        return None;
                    }
                    others.push_all(bounded.iter().copied().filter(leaves));
                }
                _ => return None,
            }
        }
        for id in allowed {
            for effect in model.transitions[*id].clearing.iter().filter(|effect| effect.writes().contains(&place)) {
                grows.push((*id, grown(effect, place)?));
            }
        }
        let writes =
            |id: &TransitionId| model.transitions[*id].clearing.iter().any(|one| one.writes().contains(&place));
        others.push_all(bounded.iter().copied().filter(writes));
        let Ty::Int { rust, .. } = model.place_ty(place) else { return None };
        let ty = Integer::of(rust)?;
        // It does not come to the end of its type, where it would begin anew.
        let bits = if ty.is_size { 16 } else { ty.bits.min(32) };
        let (total, greatest) = (grows.iter().map(|(_, by)| by).sum::<i128>(), (1_i128 << bits) - 1);
        let largest = most.checked_add(total)?;
        let is_known = !ty.signed && most >= 0 && largest <= greatest;
        let begins_anew = |by: i128| largest.checked_add(by).is_none_or(|sum| sum > greatest);
        others.push_all(grows_beside.into_iter().filter(|(_, by)| begins_anew(*by)).map(|(id, _)| id));
        let is_within = grows.iter().all(|(id, _)| circle.contains(id));
        let limited = limits.into_iter().map(|(id, _)| id).collect();
        (is_known && is_within && !grows.is_empty()).then_some(Self { most, limited, grows, others })
    }

    /// How often something writes it that does not count. Who has left the circle of the only active step comes back with an entry alone.
    fn resets(
        &self,
        model: &Model,
        concurrency: &Concurrency,
        lengths: &Lengths<'_>,
        circle: &Candidates,
        entries: u64,
    ) -> u64 {
        let steps = circle.iter().flat(|id| model.transitions[*id].sources.clone()).list();
        let own = steps.first().map(|step| model.steps[*step].partial);
        let is_beside = |id: &TransitionId| {
            let transition = &model.transitions[*id];
            let mut around = transition.sources.iter().chain(&transition.targets);
            Some(transition.partial) != own
                || around.any(|step| {
                    !steps.contains(step) && steps.iter().any(|inside| concurrency.together(*step, *inside))
                })
        };
        let (beside, alone): (Vec<TransitionId>, Vec<TransitionId>) = self.others.iter().copied().partition(is_beside);
        beside.iter().map(|id| lengths.clearings(*id)).sum::<u64>() + if alone.is_empty() { 0 } else { entries }
    }

    /// After how many evolutions the circle has ended, if each turn is limited and counted.
    fn turns(&self, successors: &mut Successors<'_>, circle: &Candidates, entries: u64, resets: u64) -> Option<u64> {
        let growing: Candidates = self.grows.iter().map(|(id, _)| *id).collect();
        let mut is_broken =
            |without: &Candidates| circles(successors, &circle.difference(without).copied().collect()).is_empty();
        if !is_broken(&growing) || !is_broken(&self.limited) {
            return None;
        }
        // Until the count is too large, with each reset anew, and once more from there and for each entry.
        let by = self.grows.iter().map(|(_, by)| *by).min()?;
        let grown = u64::try_from(self.most / by).ok()?.checked_add(1)?;
        grown.checked_mul(resets + 1)?.checked_add(entries + 1)?.checked_mul(circle.len() as u64)
    }
}

/// The places that a condition compares with a number.
fn compared(tree: &Tree) -> Vec<Place> {
    match tree {
        Tree::Unary(Unary::Not, inner) => compared(inner),
        Tree::Binary(Binary::And | Binary::Or, a, b) => [compared(a), compared(b)].concat(),
        Tree::Binary(_, a, b) => [a, b].into_iter().filter_map(|side| place_of(side)).list(),
        _ => Vec::new(),
    }
}

fn place_of(tree: &Tree) -> Option<Place> {
    match tree {
        Tree::Read(Read::Name(Name::Var(id))) => Some(Place::Var(*id)),
        Tree::Read(Read::Name(Name::Output(id))) => Some(Place::Output(*id)),
        _ => None,
    }
}

/// The most that a place holds where a condition does, or where it does not.
fn limit(tree: &Tree, holds: bool, place: Place) -> Option<i128> {
    let side = |tree: &Tree| limit(tree, holds, place);
    match tree {
        Tree::Unary(Unary::Not, inner) => limit(inner, !holds, place),
        Tree::Binary(operator @ (Binary::And | Binary::Or), a, b) => match (side(a), side(b)) {
            (Some(a), Some(b)) if (*operator == Binary::And) == holds => Some(a.min(b)),
            (Some(a), Some(b)) => Some(a.max(b)),
            (one, other) if (*operator == Binary::And) == holds => one.or(other),
            _ => None,
        },
        Tree::Binary(operator, a, b) => {
            let (operator, number) = match (&**a, &**b) {
                (read, Tree::Int(number)) if place_of(read) == Some(place) => (*operator, *number),
                (Tree::Int(number), read) if place_of(read) == Some(place) => (operator.mirrored(), *number),
                _ => return None,
            };
            match operator {
                Binary::Lt if holds => number.checked_sub(1),
                Binary::Ge if !holds => number.checked_sub(1),
                Binary::Le | Binary::Eq if holds => Some(number),
                Binary::Gt | Binary::Ne if !holds => Some(number),
                _ => None,
            }
        }
        _ => None,
    }
}

/// By how much an effect makes the place larger, if that is all it does to it.
fn grown(effect: &Effect, place: Place) -> Option<i128> {
    let value = match effect {
        Effect::Assign(_, value) => &value.tree,
        Effect::Block(code) => {
            let mut values = code.statements.iter().flatten().filter_map(|statement| match statement {
                Statement::Assign(to, value) => (*to == place).then_some(value),
                Statement::If(..) => None,
            });
            let is_plain = code.statements.iter().flatten().all(|one| matches!(one, Statement::Assign(..)));
            values.next().filter(|_| is_plain && values.next().is_none())?
        }
        Effect::Control(_) | Effect::Call(..) => return None,
    };
    let (a, b) = match value {
        Tree::Binary(Binary::Add, a, b) => (&**a, &**b),
        Tree::Opaque { of: Some(computed), .. } => match &**computed {
            Computed { how: How::Wrapping(Binary::Add) | How::Saturating(Binary::Add), operands } => {
                (operands.first()?, operands.get(1)?)
            }
            _ => return None,
        },
        _ => return None,
    };
    match (a, b) {
        (read, Tree::Int(by)) | (Tree::Int(by), read) if place_of(read) == Some(place) && *by > 0 => Some(*by),
        _ => None,
    }
}
