//! What a chart remembers between two cycles, in both dialects.

use std::collections::BTreeMap;

use super::hierarchy;
use super::rest::cap;
use super::time::{self, Delayed};
use super::value::{Error, Value, default};
use super::variant;
use super::view::{Edges, Situation, Times, View};
use super::world::{Given, Nothing};
use grafcet_compiler::model::{DelayId, EdgeId, Expr, Model, Name, Read};

/// The memory of a running chart.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct State {
    /// The next cycle is a first one.
    pub(super) first: bool,
    /// The time of the last cycle.
    pub(super) now: u32,
    pub(super) situation: Situation,
    pub(super) times: Times,
    /// Where times saturate: not while something blinks, whose phase goes on for ever.
    longest: u64,
    pub(super) vars: Vec<Value>,
    /// What the last cycle returned; in `grafcet`, stored outputs change during the search.
    pub(super) outputs: Vec<Value>,
    pub(super) initial_outputs: Vec<Value>,
    /// The values of the edges' expressions in the snapshot before.
    pub(super) edges: BTreeMap<EdgeId, bool>,
    /// `sfc`: the same, as the actions of the cycle before saw them.
    pub(super) action_edges: BTreeMap<EdgeId, bool>,
    pub(super) delays: BTreeMap<DelayId, Delayed>,
}

impl State {
    /// A1: the initial situation with the initial values, before the first cycle.
    pub(super) fn initial(model: &Model) -> Result<Self, Error> {
        let outputs = constants(model.outputs.iter().map(|(id, o)| (Name::Output(id), &o.init)), model)?;
        let situation = hierarchy::initial_situation(model)?;
        let mut times = Times::default();
        times.enter(model, &situation);
        Ok(Self {
            first: true,
            now: 0,
            situation,
            times,
            longest: if blinks(model) { u64::MAX } else { u64::from(u32::MAX) },
            vars: constants(model.vars.iter().map(|(id, v)| (Name::Var(id), &v.init)), model)?,
            initial_outputs: outputs.clone(),
            outputs,
            edges: BTreeMap::new(),
            action_edges: BTreeMap::new(),
            delays: BTreeMap::new(),
        })
    }

    /// The time since the previous cycle, a wrapping difference; the first cycle has none. Step times add it up and
    /// saturate.
    pub(super) fn advance(&mut self, now: u32) -> u32 {
        let elapsed = if self.first { 0 } else { now.wrapping_sub(self.now) };
        self.now = now;
        let times = self.times.steps.values_mut().chain(self.times.macros.values_mut());
        times.for_each(|time| *time = time.saturating_add(u64::from(elapsed)).min(self.longest));
        elapsed
    }

    /// Times are no longer than this, and the clock reads zero.
    pub(super) fn settle(&mut self, longest: u32) {
        self.now = 0;
        cap(&mut self.times.steps, longest);
        cap(&mut self.times.macros, longest);
        self.delays.values_mut().for_each(|delay| delay.settle(longest));
    }

    /// The snapshot of the present state. Edges are evaluated against the memory; in a first cycle there are none (A26).
    pub(super) fn view<'a>(
        &'a self,
        model: &'a Model,
        given: Given<'a>,
        delays: &'a BTreeMap<DelayId, bool>,
    ) -> View<'a> {
        View {
            model,
            given,
            vars: &self.vars,
            outputs: &self.outputs,
            situation: &self.situation,
            times: &self.times,
            edges: Edges { before: &self.edges, now: None },
            delays,
            remembered: None,
            own: None,
        }
    }

    /// A36: `t1/e/t2` on the situation the cycle starts from.
    pub(super) fn sample_delays(
        &mut self,
        model: &Model,
        given: Given<'_>,
        elapsed: u32,
    ) -> Result<BTreeMap<DelayId, bool>, Error> {
        let mut delays = std::mem::take(&mut self.delays);
        let nothing = BTreeMap::new();
        let outputs = time::sample_delays(&mut delays, elapsed, &self.view(model, given, &nothing));
        self.delays = delays;
        outputs
    }
}

impl Times {
    /// A new situation: what has become active starts at zero, what is no longer active loses its time (A23). A20: `M.T`
    /// counts since `M.X` rose.
    pub(super) fn enter(&mut self, model: &Model, situation: &Situation) {
        self.steps = situation.iter().map(|step| (*step, self.time_of_step(*step))).collect();
        let active = model.macros.iter().filter(|(_, m)| m.steps.iter().any(|step| situation.contains(step)));
        self.macros = active.map(|(id, _)| (id, self.macros.get(&id).copied().unwrap_or(0))).collect();
    }

    fn time_of_step(&self, step: grafcet_compiler::model::StepId) -> u64 {
        self.steps.get(&step).copied().unwrap_or(0)
    }
}

/// Whether some expression asks for a phase.
fn blinks(model: &Model) -> bool {
    let claimed = model.properties.iter().flat_map(|property| property.claim.expressions());
    let mut reads = model.expressions().into_iter().flatten().chain(claimed.flat_map(|expr| &expr.reads));
    reads.any(|read| matches!(read, Read::Blink(_)))
}

/// The values after `=`, or those of `Default`.
pub(super) fn constants<'m>(
    names: impl Iterator<Item = (Name, &'m Option<Expr>)>,
    model: &Model,
) -> Result<Vec<Value>, Error> {
    let (nothing, situation, times) = (BTreeMap::new(), Situation::new(), Times::default());
    let (no_edges, no_delays) = (BTreeMap::new(), &nothing);
    let view = View {
        model,
        given: Given { inputs: &[], params: &[], world: &Nothing },
        vars: &[],
        outputs: &[],
        situation: &situation,
        times: &times,
        edges: Edges { before: &no_edges, now: None },
        delays: no_delays,
        remembered: None,
        own: None,
    };
    let value = |(name, init): (Name, &Option<Expr>)| match init {
        None => Ok(default(model.ty(name))),
        Some(init) => variant::value(view.eval(&init.tree)?, name, model),
    };
    names.map(value).collect()
}
