//! Whether every search for stability of a `grafcet` comes to an end (A30).
//!
//! A search without end clears some transitions again and again. Each of them is enabled anew by one that clears
//! before it in the same cycle, so somewhere there is a circle of transitions that all clear on one set of inputs. Two
//! transitions whose conditions exclude each other by what stays constant during a cycle never do, and some clear once a
//! cycle at most. Where no circle is left without these, and without those that count how often they turn, the search ends.

mod counts;
mod length;
mod once;
mod rounds;
mod successors;

use self::length::Lengths;
use self::successors::Successors;
use super::Concurrency;
use super::edges::is_edge_of_inputs;
use crate::list::List;
use crate::model::{Id, Model, Name, Read, StepId, Transition, TransitionId};
use crate::sorted::Set;

/// So many circles are looked at, each with one choice between transitions that exclude each other, before nothing is claimed.
const CIRCLES: usize = 128;

/// Transitions that all may clear again and again in one search.
type Candidates = Set<TransitionId>;

/// What is known about the end of the search.
pub struct Stability {
    /// Every search ends.
    is_certain: bool,
    /// After so many evolutions, as far as that is known.
    longest: Option<u64>,
    at_once: bool,
    ends: Ends,
}

/// The steps with whose activation a search ends, in a chart that is one sequence: nothing can leave them in the same cycle.
#[derive(Clone, Default)]
pub struct Ends {
    steps: Set<StepId>,
    always: bool,
}

impl Ends {
    /// These steps.
    #[must_use]
    pub fn steps(&self) -> &Set<StepId> {
        &self.steps
    }

    /// All steps that a transition activates are such ones: a search has one evolution.
    #[must_use]
    pub fn always(&self) -> bool {
        self.always
    }
}

impl Stability {
    /// Looks at the circles of a chart.
    #[must_use]
    pub fn of(model: &Model, concurrency: &Concurrency) -> Self {
        // An event that needs inputs or clearings to change keeps no search from its end, but makes more looks necessary.
        let Some(events) = once::events(model).filter(|_| !is_refilled(model)) else {
            return Self { is_certain: false, longest: None, at_once: false, ends: Ends::default() };
        };
        let has_events = events != once::Events::None;
        let mut successors = Successors::new(model);
        let all: Candidates = model.transitions.ids().collect();
        let has_no_circle = !has_events
            && model.partials.len() == 1
            && model.forces.is_empty()
            && circles(&mut successors, &all).is_empty();
        let lengths = Lengths::of(model, concurrency, &successors);
        let at_once = has_no_circle && lengths.is_some();
        let counted = if has_no_circle {
            Some(0)
        } else {
            let again = all.iter().copied().filter(|id| !once::clears_once(model, concurrency, *id)).collect();
            let (lengths, successors) = (lengths.as_ref(), &mut successors);
            Turning { model, concurrency, lengths, successors, looked_at: 0 }.end(again, &all)
        };
        let longest = counted
            .and_then(|counted| length::evolutions((model, lengths.as_ref()), &mut successors, (counted, events)));
        let ends = if has_events { Ends::default() } else { search_ends(model, &mut successors) };
        Self { is_certain: counted.is_some(), longest, at_once, ends }
    }

    /// Whether the situation after an evolution follows from the one before it and from what stays constant during a cycle: a
    /// search that comes back to a situation then goes on for ever.
    #[must_use]
    pub(crate) fn is_memoryless(model: &Model) -> bool {
        let stays = |read: &Read| is_constant_read(read) || matches!(read, Read::Active(_) | Read::MacroActive(_));
        model.transitions.values().flat(|transition| &transition.condition.reads).all(stays)
    }

    /// Whether a search of so many evolutions goes on for ever.
    #[must_use]
    pub fn goes_on_after(model: &Model, concurrency: &Concurrency, evolutions: u32) -> bool {
        let is_sequence = model.steps.ids().all(|step| concurrency.beside(step).next().is_none());
        let evolutions = evolutions as usize;
        is_sequence && Self::is_memoryless(model) && evolutions >= model.steps.len()
            || rounds::longest(model, concurrency).is_some_and(|longest| longest < evolutions)
    }

    /// Every search ends.
    #[must_use]
    pub fn is_certain(&self) -> bool {
        self.is_certain
    }

    /// Every search ends after so many evolutions, as far as that is known.
    pub(super) fn longest(&self) -> Option<u64> {
        self.longest
    }

    /// Where a search ends without another look.
    #[must_use]
    pub fn ends(&self) -> &Ends {
        &self.ends
    }

    /// Every search ends after each transition has cleared at most once.
    #[must_use]
    pub fn is_at_once(&self) -> bool {
        self.at_once
    }
}

/// The steps that are active alone and that no transition can leave in the cycle in which another one has entered them. An edge of what
/// changes within a search, as of a step or of another edge, has to be looked at once more: the next cycle compares with the last evolution.
fn search_ends(model: &Model, successors: &mut Successors<'_>) -> Ends {
    if !model.edges.values().flat(|edge| &edge.of.reads).all(is_constant_read) {
        return Ends::default();
    }
    let is_sequence = model.partials.len() == 1
        && model.steps.values().filter(|step| step.initial).count() == 1
        && model.transitions.values().all(|t| t.sources.len() == 1 && t.targets.len() == 1);
    if !is_sequence {
        return Ends::default();
    }
    let mut steps: Set<StepId> = model.transitions.values().flat(|t| &t.targets).copied().collect();
    let entered = steps.len();
    for (id, transition) in model.transitions.iter() {
        // What is left and entered at once stays active, and what is done on clearing is done again (A4g).
        let goes_on = if transition.sources == transition.targets {
            !transition.clearing.is_empty()
        } else {
            !successors.is_followed_by_none(id)
        };
        if goes_on {
            transition.targets.iter().for_each(|step| _ = steps.remove(step));
        }
    }
    let always = steps.len() == entered;
    Ends { steps, always }
}

/// Whether a source transition, which nothing has to enable, may go on filling a chart in which what clears depends on what
/// is active or stored: the steps after it can then turn each other on and off. What is done on clearing is done again each time.
fn is_refilled(model: &Model) -> bool {
    let varies = |read: &Read| !is_constant_read(read) && !is_edge_of_inputs(model, read);
    let goes_on = |transition: &Transition| {
        transition.sources.len() > 1 || !transition.clearing.is_empty() || transition.condition.reads.iter().any(varies)
    };
    let mut transitions = model.transitions.values();
    transitions.any(|transition| transition.sources.is_empty())
        && (model.partials.len() > 1 || model.transitions.values().any(goes_on))
}

/// Whether a read has one value throughout a cycle.
#[must_use]
pub(crate) fn is_constant_read(read: &Read) -> bool {
    matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Delay(_) | Read::Ticks(_))
}

/// The transitions that may clear again and again in one search, as more and more of them are excluded.
struct Turning<'s, 'm> {
    model: &'m Model,
    concurrency: &'s Concurrency,
    lengths: Option<&'s Lengths<'s>>,
    successors: &'s mut Successors<'m>,
    looked_at: usize,
}

impl Turning<'_, '_> {
    /// If no set of transitions can clear again and again, all on one set of inputs, that is one of `allowed` and has its circle in
    /// `focus`: the evolutions that counts take to end circles.
    fn end(&mut self, allowed: Candidates, focus: &Candidates) -> Option<u64> {
        let allowed = entered_again(self.successors, allowed);
        let focus = focus.intersection(&allowed).copied().collect();
        let mut counted = 0_u64;
        for circle in circles(self.successors, &focus) {
            counted = counted.checked_add(self.end_of(&allowed, &circle)?)?;
        }
        Some(counted)
    }

    fn end_of(&mut self, allowed: &Candidates, circle: &Candidates) -> Option<u64> {
        self.looked_at += 1;
        if self.looked_at > CIRCLES {
            return None;
        }
        // Of a transition and those that exclude it, only the one or the others clear.
        let Some((one, others)) = self.successors.choice(circle) else {
            let lengths = self.lengths?;
            return counts::turns(self.model, self.concurrency, lengths, self.successors, (allowed, circle));
        };
        let mut without = |gone: &Candidates| {
            let rest = |all: &Candidates| all.difference(gone).copied().collect::<Candidates>();
            self.end(rest(allowed), &rest(circle))
        };
        Some(without(&Candidates::from([one]))?.max(without(&others)?))
    }
}

/// What is left of these transitions if each source step of each has to be entered by another one.
fn entered_again(successors: &mut Successors<'_>, mut candidates: Candidates) -> Candidates {
    loop {
        let before = candidates.len();
        let next = candidates.iter().copied().filter(|id| successors.is_entered(*id, &candidates)).collect();
        candidates = next;
        if candidates.len() == before {
            return candidates;
        }
    }
}

/// The sets of transitions that enable each other in circles: the strongly connected ones, by Tarjan's search with an explicit
/// stack, since charts may be long.
fn circles(successors: &mut Successors<'_>, among: &Candidates) -> Vec<Candidates> {
    let mut search = Tarjan {
        order: vec![None; successors.transitions()],
        low: vec![0; successors.transitions()],
        ..Tarjan::default()
    };
    for root in among {
        if search.order[root.index()].is_none() {
            search.from(*root, successors, among);
        }
    }
    search.found
}

#[derive(Default)]
struct Tarjan {
    /// By transition, when it was met.
    order: Vec<Option<usize>>,
    low: Vec<usize>,
    met: usize,
    open: Vec<TransitionId>,
    found: Vec<Candidates>,
}

impl Tarjan {
    fn from(&mut self, root: TransitionId, successors: &mut Successors<'_>, among: &Candidates) {
        let mut path = vec![(root, self.meet(root, successors, among).into_iter())];
        while let Some((at, next)) = path.last_mut() {
            let at = *at;
            match next.next() {
                Some(child) => match self.order[child.index()] {
                    None => {
                        let following = self.meet(child, successors, among);
                        path.push((child, following.into_iter()));
                    }
                    Some(order) if self.open.contains(&child) => {
                        self.low[at.index()] = self.low[at.index()].min(order);
                    }
                    Some(_) => {}
                },
                None => {
                    path.pop();
                    if let Some((from, _)) = path.last() {
                        self.low[from.index()] = self.low[from.index()].min(self.low[at.index()]);
                    }
                    self.close(at, successors);
                }
            }
        }
    }

    fn meet(&mut self, id: TransitionId, successors: &mut Successors<'_>, among: &Candidates) -> Vec<TransitionId> {
        self.order[id.index()] = Some(self.met);
        self.low[id.index()] = self.met;
        self.met += 1;
        self.open.push(id);
        successors.after(id).into_iter().filter(|next| among.contains(next)).list()
    }

    /// What was met after the first one of a set and is still open belongs to it.
    fn close(&mut self, first: TransitionId, successors: &mut Successors<'_>) {
        if self.order[first.index()] != Some(self.low[first.index()]) {
            return;
        }
        let place = self.open.iter().rposition(|id| *id == first).unwrap_or_default();
        let set: Candidates = self.open.split_off(place).into_iter().collect();
        if set.len() > 1 || successors.after(first).contains(&first) {
            self.found.push(set);
        }
    }
}
