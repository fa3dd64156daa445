//! What a chart remembers from cycle to cycle beside its situation: only what it uses.

use super::{Control, Drive, Region, RegionId, Regions, is_stored};
use crate::analysis::{combinational, is_constant_read};
use crate::list::List;
use crate::model::{
    Association, AssociationId, Blink, Blinker, EdgeId, Effect, Id, MacroId, Model, OutputId, Read, StepId, TimeRef,
    Transition, VarId,
};
use crate::sorted::Set;

/// An edge, with whether its rising and its falling side are used.
pub(super) type UsedEdge = (EdgeId, bool, bool);

/// The remembered values.
pub struct Memory {
    /// Variables; a combinational one is computed from the situation and not remembered.
    pub vars: Vec<VarId>,
    /// Variables computed from the situation, each after those it reads (A22).
    pub combinational: Vec<VarId>,
    /// Outputs that are remembered, in order of declaration.
    pub stored: Vec<OutputId>,
    /// Outputs whose last value is remembered only because an expression reads it (and `stored` does not hold it).
    pub last: Vec<OutputId>,
    /// The chart looks at the time, so `cycle` takes it.
    pub time: bool,
    /// Steps whose time is read.
    pub timed: Set<StepId>,
    /// Per region, whether the time of its active step is counted.
    pub step_times: Vec<bool>,
    /// Per region, whether that takes no more than 16 bits: the times of its steps are only compared with short ones.
    pub short_times: Vec<bool>,
    /// Whether a transition that enters a step can begin its time: what the evolution still reads of the step that was active
    /// before, the transitions that leave it read.
    pub begins_on_entry: bool,
    /// Macro-steps whose time is counted.
    pub macro_times: Vec<MacroId>,
    /// What blinks, each once.
    pub phases: Vec<Phase>,
    /// Steps whose activation something blinks from.
    pub blinking: Set<StepId>,
    /// Edges, each with whether its rising and its falling side are used.
    pub edges: Vec<UsedEdge>,
    /// `sfc`: the same of those that actions look at and an evolution changes: they are sampled after it.
    pub late_edges: Vec<UsedEdge>,
    /// `grafcet`: edges of what stands still in a search, sampled once in front of it: its first evolution sees them (A2).
    pub still_edges: Vec<EdgeId>,
}

/// How far a period is that began with an activation: a count that neither saturates nor wraps, however long a step stays active.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Phase {
    pub of: Counted,
    /// In ticks.
    pub period: u32,
}

/// Since whose activation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Counted {
    /// The active step of a region.
    Region(RegionId),
    Macro(MacroId),
}

impl Memory {
    pub(super) fn of(model: &Model, regions: &Regions, drives: &[Drive], control: &Control) -> Self {
        let reads: Set<Read> = model.expressions().into_iter().flatten().copied().collect();
        let combinational = combinational::in_order(model);
        let pick =
            |wanted: &dyn Fn(&Drive) -> bool| model.outputs.ids().filter(|id| wanted(&drives[id.index()])).list();
        let timed = timed_steps(model, control, &reads);
        let (edges, late_edges) = edges(model, &reads);
        let step_times: Vec<_> = regions.all().iter().map(|r| r.steps.iter().any(|step| timed.contains(step))).list();
        Self {
            vars: model.vars.ids().filter(|id| !combinational.contains(id)).list(),
            combinational,
            stored: pick(&|drive| drive.stored),
            last: pick(&|drive| drive.last),
            time: model.uses_time(),
            begins_on_entry: begins_on_entry(model),
            short_times: short_times(regions, &step_times, &long_steps(model, control, &reads)),
            step_times,
            timed,
            phases: phases(regions, &reads),
            blinking: blinking(&reads),
            macro_times: model.macros.ids().filter(|id| reads.iter().any(|read| is_time_of(*read, *id))).list(),
            still_edges: still_edges(model),
            edges,
            late_edges,
        }
    }

    /// Whether an edge is used on both sides: what is remembered of it then does not tell by itself that there is none in the
    /// first cycle (A26).
    #[must_use]
    pub fn asks_for_start(&self) -> bool {
        self.edges.iter().and(&self.late_edges).any(|(_, rising, falling)| *rising && *falling)
    }
}

/// The edges that are sampled in front of an evolution, and those sampled after it. What an evolution does not change is the
/// same to both.
fn edges(model: &Model, all: &Set<Read>) -> (Vec<UsedEdge>, Vec<UsedEdge>) {
    let mut acting: Set<Read> = Set::new();
    let mut others: Set<Read> = Set::new();
    acting.extend(model.associations.values().flat(Association::reads).flatten().copied());
    others.extend(model.transitions.values().flat(|transition| &transition.condition.reads).copied());
    others.extend(model.delays.values().flat(|delay| &delay.of.reads).copied());
    // An edge of an edge comes after it.
    let looks = |reads: &Set<Read>, id: EdgeId| reads.contains(&Read::Rising(id)) || reads.contains(&Read::Falling(id));
    for (id, edge) in model.edges.iter().rev() {
        if looks(&acting, id) {
            acting.extend(edge.of.reads.iter().copied());
        }
        if looks(&others, id) {
            others.extend(edge.of.reads.iter().copied());
        }
    }
    let sides = |reads: &Set<Read>, id| (id, reads.contains(&Read::Rising(id)), reads.contains(&Read::Falling(id)));
    let late = |id: &EdgeId| model.is_late(*id) && looks(&acting, *id);
    let early = |id: EdgeId| {
        if late(&id) { looks(&others, id).then(|| sides(&others, id)) } else { Some(sides(all, id)) }
    };
    (model.edges.ids().filter_map(early).list(), model.edges.ids().filter(late).map(|id| sides(&acting, id)).list())
}

fn still_edges(model: &Model) -> Vec<EdgeId> {
    let edges = model.edges.iter().filter(|(_, edge)| model.is_grafcet() && edge.of.reads.iter().all(is_constant_read));
    edges.map(|(id, _)| id).list()
}

/// Whether each evolution reads times of steps only in front of the transitions that leave them. A step that is forced may have
/// been active before, and its time goes on (A4g).
fn begins_on_entry(model: &Model) -> bool {
    let time_of = |read: &Read| match read {
        Read::Since(step) | Read::Elapsed(_, step) | Read::Blink(Blink { of: Blinker::Step(step), .. }) => Some(*step),
        _ => None,
    };
    let own = |transition: &Transition| {
        let mut times = transition.condition.reads.iter().filter_map(time_of);
        let mut clearing = transition.clearing.iter().flat(Effect::reads).flatten();
        times.all(|step| transition.sources.contains(&step)) && !clearing.any(|read| time_of(read).is_some())
    };
    let stored = |association: &Association| {
        let reads = association.reads();
        model.is_grafcet() && is_stored(association) && reads.into_iter().flatten().any(|read| time_of(read).is_some())
    };
    model.partials.len() == 1 && model.transitions.values().all(own) && !model.associations.values().any(stored)
}

/// Steps whose time is read.
fn timed_steps(model: &Model, control: &Control, reads: &Set<Read>) -> Set<StepId> {
    let read = reads.iter().filter_map(|read| match read {
        Read::Since(step) | Read::Elapsed(_, step) => Some(*step),
        _ => None,
    });
    let is_limited = |(id, _): &(AssociationId, &Association)| control.step_limit(model, *id).is_some();
    let limited = model.associations.iter().filter(is_limited).map(|(_, association)| association.step);
    read.and(limited).collect()
}

/// Steps from whose activation something blinks.
fn blinking(reads: &Set<Read>) -> Set<StepId> {
    let steps = reads.iter().filter_map(|read| match read {
        Read::Blink(Blink { of: Blinker::Step(step), .. }) => Some(*step),
        _ => None,
    });
    steps.collect()
}

/// Steps of one region share a phase where they share the period.
fn phases(regions: &Regions, reads: &Set<Read>) -> Vec<Phase> {
    let phases: Set<Phase> = reads.iter().filter_map(|read| Phase::of(regions, *read)).collect();
    phases.into_iter().list()
}

impl Phase {
    /// What a `blink` looks at.
    #[must_use]
    pub fn of(regions: &Regions, read: Read) -> Option<Self> {
        let Read::Blink(blink) = read else { return None };
        let of = match blink.of {
            Blinker::Step(step) => Counted::Region(regions.of_step(step)),
            Blinker::Macro(id) => Counted::Macro(id),
        };
        Some(Self { of, period: blink.period() })
    }
}

/// Steps whose time is used in another way than in a comparison with a literal that fits into 16 bits.
fn long_steps(model: &Model, control: &Control, reads: &Set<Read>) -> Set<StepId> {
    let is_long = |time: TimeRef| !matches!(time, TimeRef::Ticks(ticks) if u16::try_from(ticks).is_ok());
    let read = reads.iter().filter_map(|read| match read {
        Read::Since(step) => Some(*step),
        Read::Elapsed(time, step) => is_long(*time).then_some(*step),
        _ => None,
    });
    let limited = model.associations.iter().filter(|(id, _)| control.step_limit(model, *id).is_some_and(is_long));
    read.and(limited.map(|(_, association)| association.step)).collect()
}

/// Regions whose times take 16 bits. One such region alone would mostly save no memory, as the struct is aligned to words, and
/// saturating at 16 bits takes more instructions.
fn short_times(regions: &Regions, timed: &[bool], long: &Set<StepId>) -> Vec<bool> {
    let is_short = |(region, timed): (&Region, &bool)| *timed && region.steps.iter().all(|step| !long.contains(step));
    let short: Vec<_> = regions.all().iter().zip(timed).map(is_short).list();
    let several = short.iter().filter(|short| **short).count() > 1;
    short.into_iter().map(|short| short && several).list()
}

fn is_time_of(read: Read, id: MacroId) -> bool {
    matches!(read, Read::MacroSince(other) | Read::MacroElapsed(_, other) if other == id)
}
