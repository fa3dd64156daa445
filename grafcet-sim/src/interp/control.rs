//! `sfc`: the `ACTION_CONTROL` of IEC 61131-3, one for each target (A31).

use std::collections::{BTreeMap, BTreeSet};

use super::time::Stopwatch;
use super::value::Error;
use super::view::{Situation, View};
use grafcet_compiler::model::{ActionId, AssociationId, Effect, Model, Place, Qualifier};

/// A31: what associations are combined for.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Target {
    /// An output or a variable that is controlled, or an output that is assigned (A35), by its name.
    Place(Place),
    /// A declared action by its name, whatever its arguments.
    Action(ActionId),
    /// Every block and every stored assignment is a target of its own.
    Own(AssociationId),
}

/// The target of an association.
///
/// Reading chosen: an output assigned after another qualifier than N is written, not assigned in the sense of A35,
/// and so a target of its own like an assignment to a variable.
pub(super) fn target_of(model: &Model, id: AssociationId) -> Target {
    let association = &model.associations[id];
    match &association.effect {
        Effect::Control(place) => Target::Place(*place),
        Effect::Assign(place @ Place::Output(_), _) if association.qualifier == Qualifier::N => Target::Place(*place),
        Effect::Call(action, _) => Target::Action(*action),
        Effect::Assign(..) | Effect::Block(_) => Target::Own(id),
    }
}

/// How one evolution changed the situation.
#[derive(Clone, Default, Debug)]
pub(super) struct Change {
    /// The steps left, those re-entered at once included (A4s).
    pub(super) left: Situation,
    /// The steps entered, those re-entered included; a step that was active and not left is not entered anew.
    pub(super) entered: Situation,
    /// The situation after it.
    pub(super) after: Situation,
}

impl Change {
    fn reentered(&self, association: AssociationId, model: &Model) -> bool {
        let step = model.associations[association].step;
        self.left.contains(&step) && self.entered.contains(&step)
    }
}

/// The inputs of all action controls in one cycle: the associations whose step flag or event is true.
///
/// P, P1 and P0 are events; the others are flags. The condition of `N q if c` belongs to the flag. All are read before the
/// first action runs (rule 5); P0's condition sees the time a re-entered step had reached, as P0 itself does (A34).
pub(super) fn inputs(change: &Change, leaving: &View<'_>, view: &View<'_>) -> Result<BTreeSet<AssociationId>, Error> {
    use Qualifier::{D, Ds, L, N, On, P, P0, P1, R, S, Sd, Sl};
    let mut on = BTreeSet::new();
    for (id, association) in view.model.associations.iter() {
        let (steps, view) = match association.qualifier {
            P | P1 => (&change.entered, view),
            P0 => (&change.left, leaving),
            N | S | R | L | D | Sd | Ds | Sl | On => (&change.after, view),
        };
        let condition = || association.condition.as_ref().map_or(Ok(true), |c| view.holds(&c.tree));
        if steps.contains(&association.step) && condition()? {
            on.insert(id);
        }
    }
    Ok(on)
}

/// The flip-flops and timers of one target.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct ActionControl {
    /// In source order.
    pub(super) associations: Vec<AssociationId>,
    /// The reset-dominant flip-flops that are set: S, SD, DS, SL.
    pub(super) flip_flops: BTreeSet<Qualifier>,
    /// The inputs of TON and the time they have been true: L, D, SD, DS, SL.
    pub(super) timers: BTreeMap<Qualifier, Stopwatch>,
    /// The association of each timer that was active last: its time counts.
    pub(super) time_of: BTreeMap<Qualifier, AssociationId>,
    /// Rule 7: the association that set a flip-flop last, and so acts while that drives Q.
    pub(super) set_by: BTreeMap<Qualifier, AssociationId>,
    /// Q of the cycle before.
    pub(super) was: bool,
    /// The associations with N, L and D that held Q up in the cycle before.
    pub(super) holding: BTreeSet<AssociationId>,
    /// Rule 7: the association that made Q true when it was so last, the last in the source of several.
    pub(super) acted_last: Option<AssociationId>,
}

/// What the function block gives in one cycle.
struct Drive {
    q: bool,
    /// Those of N, L and D that hold by themselves, R or not.
    terms: BTreeSet<Qualifier>,
    /// As in [`Verdict`].
    acts: Option<AssociationId>,
}

/// What an action control says in one cycle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Verdict {
    pub(super) q: bool,
    /// Q of the cycle before.
    pub(super) before: bool,
    /// Q fell because a step with N, L or D was left.
    pub(super) by_leaving: bool,
    /// Rule 7: the association that acts, the last in the source of those that alone would make Q true.
    pub(super) acts: Option<AssociationId>,
    /// The association whose P1 event occurred, the last in the source.
    pub(super) p1: Option<AssociationId>,
    /// The same of P0.
    pub(super) p0: Option<AssociationId>,
}

impl ActionControl {
    /// With the set flip-flop at the initial value of a boolean that only S and R control.
    pub(super) fn new(associations: Vec<AssociationId>, set: bool) -> Self {
        Self {
            associations,
            flip_flops: set.then_some(Qualifier::S).into_iter().collect(),
            timers: BTreeMap::new(),
            time_of: BTreeMap::new(),
            set_by: BTreeMap::new(),
            was: false,
            holding: BTreeSet::new(),
            acted_last: None,
        }
    }

    /// Timers are no longer than this.
    pub(super) fn settle(&mut self, longest: u32) {
        self.timers.values_mut().for_each(|timer| timer.settle(longest));
    }

    /// One scan.
    pub(super) fn scan(
        &mut self,
        on: &BTreeSet<AssociationId>,
        change: &Change,
        elapsed: u32,
        view: &View<'_>,
    ) -> Result<Verdict, Error> {
        let model = view.model;
        let here: Vec<_> = self.associations.iter().copied().filter(|id| on.contains(id)).collect();
        let last = |q: Qualifier| here.iter().copied().rfind(|id| model.associations[*id].qualifier == q);

        let before = std::mem::take(&mut self.holding);
        let Drive { q, terms, acts } = self.q(&here, change, elapsed, view)?;
        self.acted_last = acts.or(self.acted_last);
        // What D held up ends by leaving also where the step is re-entered: its delay starts again.
        let left = |id: &AssociationId| match model.associations[*id].qualifier {
            // What another step's association of the same qualifier holds up does not end by leaving, but by R.
            qualifier if terms.contains(&qualifier) => false,
            Qualifier::D => change.left.contains(&model.associations[*id].step),
            _ => !change.after.contains(&model.associations[*id].step),
        };
        let verdict = Verdict {
            q,
            before: self.was,
            by_leaving: self.was && !q && before.iter().any(left),
            acts,
            p1: last(Qualifier::P1),
            p0: last(Qualifier::P0),
        };
        self.was = q;
        Ok(verdict)
    }

    /// The standard's function block; `here` are its inputs that are true.
    fn q(&mut self, here: &[AssociationId], change: &Change, elapsed: u32, view: &View<'_>) -> Result<Drive, Error> {
        use Qualifier::{D, Ds, L, N, P, R, S, Sd, Sl};
        let model = view.model;
        let with = |q: Qualifier| here.iter().copied().filter(move |id| model.associations[*id].qualifier == q);
        let input = |q: Qualifier| with(q).next().is_some();
        // A step re-entered by A4s starts L, D and DS again.
        let again = |q: Qualifier| with(q).any(|id| change.reentered(id, model));
        for q in Qualifier::ALL.into_iter().filter(|q| q.has_time()) {
            if let Some(id) = with(q).next_back() {
                self.time_of.insert(q, id);
            }
        }

        let reset = input(R);
        let stored = self.rs(S, input(S), reset);
        let limit = self.ton(L, input(L), elapsed, again(L), view)?;
        let delayed = self.ton(D, input(D), elapsed, again(D), view)?;
        let pulse = input(P);
        let stored_then = self.rs(Sd, input(Sd), reset);
        let stored_then_delayed = self.ton(Sd, stored_then, elapsed, false, view)?;
        let delayed_then = self.ton(Ds, input(Ds), elapsed, again(Ds), view)?;
        let delayed_then_stored = self.rs(Ds, delayed_then, reset);
        let stored_and = self.rs(Sl, input(Sl), reset);
        let stored_limit = self.ton(Sl, stored_and, elapsed, false, view)?;

        // A flip-flop is that of the association that set it last; DS sets its own only when its delay is over.
        for (q, sets) in [(S, input(S)), (Sd, input(Sd)), (Ds, delayed_then), (Sl, input(Sl))] {
            if let Some(id) = with(q).next_back().filter(|_| sets) {
                self.set_by.insert(q, id);
            }
        }

        let terms = [(N, input(N)), (L, input(L) && !limit), (D, delayed)];
        let terms: BTreeSet<Qualifier> = terms.into_iter().filter(|(_, holds)| *holds).map(|(q, _)| q).collect();
        let driven =
            [(S, stored), (Sd, stored_then_delayed), (Ds, delayed_then_stored), (Sl, stored_and && !stored_limit)];
        let by_flip_flop = driven.into_iter().filter(|(_, drives)| *drives).filter_map(|(q, _)| self.set_by.get(&q));
        let holds = |id: &AssociationId| terms.contains(&model.associations[*id].qualifier);
        let acts = here.iter().copied().filter(|id| holds(id)).chain(with(P)).chain(by_flip_flop.copied()).max();
        let q = !reset && (!terms.is_empty() || pulse || driven.iter().any(|(_, drives)| *drives));
        self.holding = here.iter().copied().filter(|id| q && holds(id)).collect();
        Ok(Drive { q, terms, acts: acts.filter(|_| q) })
    }

    /// The reset-dominant flip-flop of a qualifier.
    fn rs(&mut self, q: Qualifier, set: bool, reset: bool) -> bool {
        let value = !reset && (set || self.flip_flops.contains(&q));
        if value {
            self.flip_flops.insert(q);
        } else {
            self.flip_flops.remove(&q);
        }
        value
    }

    /// TON of one qualifier; "it takes the time of the one active last", read anew in every cycle (rule 5).
    fn ton(&mut self, q: Qualifier, signal: bool, elapsed: u32, again: bool, view: &View<'_>) -> Result<bool, Error> {
        let timer = self.timers.entry(q).or_default();
        timer.step(signal, elapsed, again);
        match self.time_of.get(&q).and_then(|id| view.model.associations[*id].time) {
            Some(time) => Ok(timer.reached(view.ticks(time)?)),
            None => Ok(false),
        }
    }
}
