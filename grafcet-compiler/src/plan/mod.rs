//! What the machine code will look like: which steps share a byte, which states there are, what is remembered.
//! No tokens yet.

mod drive;
mod regions;

pub use drive::Drive;
pub use regions::{Region, RegionId, Regions, starts};

use crate::analysis::{Concurrency, Stability};
use crate::model::{Dialect, Effect, Id, Model, OutputId, Qualifier, StepId, TransitionId};

/// The plan for one chart.
pub struct Plan {
    pub regions: Regions,
    /// The first cycle differs from the others, so the state says whether it is still to come.
    pub has_start: bool,
    /// How each output gets its value, by output.
    pub drives: Vec<Drive>,
    /// Outputs that are remembered from cycle to cycle, in order of declaration.
    pub stored: Vec<OutputId>,
    /// Outputs whose last value is remembered only because an expression reads it (and `stored` does not hold it).
    pub last: Vec<OutputId>,
    /// Per step, the transitions that leave it, in source order.
    pub leaving: Vec<Vec<TransitionId>>,
    /// Per region, whether an action can see that a step was left and entered again in one evolution.
    pub sees_reentry: Vec<bool>,
    /// A search for stability may have no end, as far as is known (A30).
    pub may_be_unstable: bool,
    /// After how many evolutions that changed something such a search is given up.
    pub max_evolutions: u32,
}

impl Plan {
    /// Plans a chart that has passed all checks.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let concurrency = Concurrency::of(model);
        let regions = Regions::of(model, &concurrency);
        let drives = drive::all(model, &concurrency);
        let pick = |wanted: &dyn Fn(&Drive) -> bool| {
            model.outputs.ids().filter(|id| wanted(&drives[id.index()])).collect::<Vec<_>>()
        };
        let sees_reentry = (0..regions.all().len()).map(|region| sees_reentry(model, &regions.all()[region])).collect();
        Self {
            has_start: has_start(model),
            stored: pick(&|drive| drive.stored),
            last: pick(&|drive| drive.last),
            drives,
            leaving: leaving(model),
            sees_reentry,
            may_be_unstable: model.is_grafcet() && !Stability::of(model).is_certain(),
            max_evolutions: max_evolutions(model),
            regions,
        }
    }
}

fn leaving(model: &Model) -> Vec<Vec<TransitionId>> {
    let mut leaving = vec![Vec::new(); model.steps.len()];
    for (id, transition) in model.transitions.iter() {
        transition.sources.iter().for_each(|step| leaving[step.index()].push(id));
    }
    leaving
}

/// A4s: in an `sfc`, a self-loop deactivates and activates its step. In a `grafcet` (A4g) nothing happens to it.
fn sees_reentry(model: &Model, region: &Region) -> bool {
    let looks = |step: StepId| {
        let associations = model.steps[step].associations.iter().map(|id| &model.associations[*id]);
        associations.into_iter().any(|a| !matches!(a.qualifier, Qualifier::N | Qualifier::S | Qualifier::R))
    };
    let reentered =
        |step: &StepId| model.transitions.values().any(|t| t.sources.contains(step) && t.targets.contains(step));
    model.dialect == Dialect::Sfc && region.steps.iter().any(|step| looks(*step) && reentered(step))
}

/// Whether the first cycle differs from the others.
///
/// In an `sfc` it does not evolve (A27). In a `grafcet` it differs where something happens on the activation of the
/// initial situation, or where something looks at the time or at the evolution before.
fn has_start(model: &Model) -> bool {
    let acts = |step: StepId| {
        model.steps[step].associations.iter().map(|id| &model.associations[*id]).any(|association| {
            let continuous = matches!(association.qualifier, Qualifier::N | Qualifier::L | Qualifier::D);
            !continuous || matches!(association.effect, Effect::Call(..))
        })
    };
    model.dialect == Dialect::Sfc
        || !model.edges.is_empty()
        || model.uses_time()
        || model.steps.ids().any(|step| starts(model, step) && acts(step))
}

/// A30: what the chart states, or twice the number of steps plus two.
fn max_evolutions(model: &Model) -> u32 {
    let steps = u32::try_from(model.steps.len()).unwrap_or(u32::MAX);
    model.max_evolutions.unwrap_or_else(|| steps.saturating_mul(2).saturating_add(2))
}
