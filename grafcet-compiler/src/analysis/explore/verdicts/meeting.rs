//! Why a step is activated while it is active: where the two ways that meet in it have parted.

use super::path::Activation;
use crate::analysis::explore::Exploration;
use crate::list::List;
use crate::model::{Id, Model, StepId, TransitionId};
use crate::sorted::{Map, Set};

/// How two activations of a step come to meet.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Meeting {
    /// Where they have parted.
    pub parting: Parting,
    /// The transition by which the second went back to a step before that.
    pub back: Option<TransitionId>,
    /// The steps that were active at the start and led to one of them.
    pub starts: Vec<StepId>,
}

/// Where two ways have parted.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Parting {
    /// With this transition: it starts parallel branches, or activates a step from which several transitions clear.
    At(TransitionId),
    /// They come from different initial steps.
    Start,
    /// A source transition started one of them.
    Source,
}

impl Exploration {
    /// The steps that can be activated while they are active: for each parting the one with the shortest way. What source transitions
    /// start may meet itself.
    pub(crate) fn meetings(&self, model: &Model) -> Vec<(StepId, Meeting, &Activation)> {
        let mut first: Map<Parting, (StepId, Meeting, &Activation)> = Map::new();
        for step in model.steps.ids() {
            let Some(activation) = self.unsafe_step(step) else { continue };
            let meeting = activation.meeting(model, step);
            let parting = meeting.parting;
            if parting == Parting::Source {
                continue;
            }
            let known = first.get(&parting).map(|(.., known)| known.path.cycles.len());
            if known.is_none_or(|known| activation.path.cycles.len() < known) {
                first.insert(parting, (step, meeting, activation));
            }
        }
        first.into_iter().map(|(_, found)| found).list()
    }
}

impl Meeting {
    /// The initial steps from which the ways come, where the start of the chart has parted them.
    pub(crate) fn initial_starts(&self, model: &Model) -> Vec<StepId> {
        if self.parting != Parting::Start {
            return Vec::new();
        }
        self.starts.iter().filter(|start| model.steps[**start].initial).copied().list()
    }

    /// The step from which several transitions have cleared at once, where that has parted the ways.
    pub(crate) fn divergence(&self, model: &Model) -> Option<StepId> {
        let from = match self.parting {
            Parting::At(parting) => &model.transitions[parting].targets,
            Parting::Start => &self.starts,
            Parting::Source => return None,
        };
        let [step] = from[..] else { return None };
        (model.leaving[step.index()].len() > 1).then_some(step)
    }
}

/// That a step became active, or that a transition cleared.
struct Event {
    by: Option<TransitionId>,
    /// The events that activated its sources.
    causes: Vec<usize>,
}

impl Activation {
    /// How the two activations of `step` come to meet.
    #[must_use]
    pub fn meeting(&self, model: &Model, step: StepId) -> Meeting {
        let mut events: Vec<Event> = Vec::new();
        let mut active: Map<StepId, usize> = Map::new();
        for start in &self.path.start {
            active.insert(*start, events.len());
            events.push(Event { by: None, causes: Vec::new() });
        }
        let last = self.path.cycles.len().saturating_sub(1);
        let mut live: Set<StepId> = self.path.start.iter().copied().collect();
        let mut found = None;
        'path: for (number, cycle) in self.path.cycles.iter().enumerate() {
            for transition in &cycle.cleared {
                let arc = &model.transitions[*transition];
                let causes: Vec<usize> = arc.sources.iter().filter_map(|source| active.get(source).copied()).list();
                let event = events.len();
                events.push(Event { by: Some(*transition), causes });
                if number == last && *transition == self.by {
                    let known = active.get(&step).copied().unwrap_or(event);
                    // A search for stability may clear it several times: it is meant where the step is active.
                    if live.contains(&step) {
                        found = Some((known, event));
                        break 'path;
                    }
                    found = found.or(Some((known, event)));
                }
                arc.sources.iter().for_each(|source| _ = live.remove(source));
                live.extend(&arc.targets);
                // The sources stay known: other branches may clear in the same evolution.
                active.extend(arc.targets.iter().map(|target| (*target, event)));
            }
        }
        let Some((known, event)) = found else {
            return Meeting { parting: Parting::Start, back: None, starts: Vec::new() };
        };
        let mut meeting = meeting(model, &events, known, event);
        let (first, second) = (causes_of(&events, known), causes_of(&events, event));
        let starts = self.path.start.iter().enumerate();
        let starts = starts.filter(|(start, _)| first[*start] || second[*start]);
        meeting.starts = starts.map(|(_, step)| *step).list();
        meeting
    }
}

fn meeting(model: &Model, events: &[Event], first: usize, second: usize) -> Meeting {
    let (to_first, to_second) = (causes_of(events, first), causes_of(events, second));
    let by = |event: usize| events[event].by;
    let Some(common) = (0..events.len()).rev().find(|event| to_first[*event] && to_second[*event]) else {
        let is_source = |transition: TransitionId| model.transitions[transition].sources.is_empty();
        let mut causes = (0..events.len()).filter(|event| to_first[*event] || to_second[*event]).filter_map(by);
        let parting = if causes.any(is_source) { Parting::Source } else { Parting::Start };
        return Meeting { parting, back: None, starts: Vec::new() };
    };
    // The steps before the parting: sources of what led to it.
    let before = causes_of(events, common);
    let passed: Vec<StepId> = (0..events.len())
        .filter(|event| before[*event])
        .filter_map(by)
        .flat(|transition| model.transitions[transition].sources.iter().copied())
        .list();
    let goes_back = |transition: &TransitionId| {
        let targets = &model.transitions[*transition].targets;
        targets.iter().any(|target| passed.contains(target))
    };
    let mut since = (common + 1..second).filter(|event| to_second[*event]).filter_map(by);
    Meeting { parting: by(common).map_or(Parting::Start, Parting::At), back: since.find(goes_back), starts: Vec::new() }
}

fn causes_of(events: &[Event], of: usize) -> Vec<bool> {
    let mut found = vec![false; events.len()];
    let mut work = vec![of];
    while let Some(event) = work.pop() {
        if !std::mem::replace(&mut found[event], true) {
            work.extend(&events[event].causes);
        }
    }
    found
}
