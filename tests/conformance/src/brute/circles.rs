//! Which circles turn for ever whenever they are entered (A30), by all searches of all situations.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::model::{Model, Name, Read, StepId, TransitionId};
use grafcet_sim::interp::{Evolution, Interpreter};

use super::graph::{Edge, Graph};

/// Transitions that clear again and again.
type Ring = BTreeSet<TransitionId>;

/// In which rings the searches turn that a transition begins; one that comes to rest has none.
type Begun = BTreeMap<TransitionId, Vec<Vec<Ring>>>;

/// The searches of all cycles that begin at rest.
#[derive(Default)]
struct Searches {
    /// By what clears first, in the first cycle and in the others.
    at_first: Begun,
    later: Begun,
    /// The rings of the first cycle's searches.
    first: Vec<Vec<Ring>>,
    /// The initial situation is a stable one.
    starts_at_rest: bool,
}

/// The rings that turn whenever they are entered, each apart from what only turns beside it; `None` where a search neither ends
/// nor turns within reach.
///
/// # Errors
/// The interpreter does not understand the chart.
pub(super) fn certain(model: &Model, graph: &Graph) -> Result<Option<BTreeSet<Ring>>, String> {
    let Some(searches) = searches(model, graph)? else { return Ok(None) };
    let rests = searches.first.iter().any(Vec::is_empty);
    let always = |begun: Option<&Vec<Vec<Ring>>>, ring: &Ring| {
        begun.is_none_or(|all| all.iter().all(|rings| rings.iter().any(|other| meet(model, other, ring))))
    };
    let enters = |begun: &Begun, ring: &Ring| {
        begun.iter().any(|(entry, all)| {
            let turns = all.iter().any(|rings| rings.contains(ring));
            turns && belongs(model, *entry, ring) && always(Some(all), ring)
        })
    };
    let all = searches.later.values().flatten().chain(&searches.first).flatten();
    let mut certain: BTreeSet<Ring> = all.cloned().collect();
    certain.retain(|ring| {
        let entered = !rests && searches.first.iter().any(|rings| rings.contains(ring))
            || enters(&searches.at_first, ring)
            || enters(&searches.later, ring);
        let calm_at_first = |id: &TransitionId| {
            searches.starts_at_rest && searches.at_first.get(id).is_some_and(|all| all.iter().any(Vec::is_empty))
        };
        entered && ring.iter().all(|id| always(searches.later.get(id), ring) && !calm_at_first(id))
    });
    Ok(Some(certain))
}

fn searches(model: &Model, graph: &Graph) -> Result<Option<Searches>, String> {
    let mut searches = Searches::default();
    let mut machine = Interpreter::new(model).map_err(|error| error.to_string())?;
    let (mut known, mut open) = (BTreeSet::from([0]), vec![0]);
    while let Some(from) = open.pop() {
        for edge in &graph.states[from].cycles {
            let rings = if edge.stable {
                if known.insert(edge.to) {
                    open.push(edge.to);
                }
                Vec::new()
            } else {
                machine.resume(graph.states[from].memory().clone());
                let most = 40 * u32::try_from(model.steps.len() + 1).unwrap_or(u32::MAX);
                let turn = machine.turn(&graph.valuations[edge.valuation], 0, most);
                match turn.map_err(|error| error.to_string())? {
                    Some(turn) if !turn.is_empty() => apart(model, &turn),
                    _ => return Ok(None),
                }
            };
            searches.note(from, edge, &rings);
        }
    }
    Ok(Some(searches))
}

impl Searches {
    fn note(&mut self, from: usize, edge: &Edge, rings: &[Ring]) {
        let begun = if from == 0 { &mut self.at_first } else { &mut self.later };
        for id in edge.evolutions.first().iter().flat_map(|evolution| &evolution.cleared) {
            begun.entry(*id).or_default().push(rings.to_vec());
        }
        // What turns by values alone is no circle of the chart, and no rest.
        if from == 0 && (edge.stable || !rings.is_empty()) {
            self.first.push(rings.to_vec());
            let stays = |one: &Evolution| one.cleared.is_empty() && one.before == one.after;
            self.starts_at_rest |= edge.stable && edge.evolutions.first().is_some_and(stays);
        }
    }
}

/// The rings of a turn: without what leads nowhere in it, and each by itself that shares no step with another and reads none of its.
fn apart(model: &Model, turn: &[Evolution]) -> Vec<Ring> {
    let cleared: Ring = turn.iter().flat_map(|evolution| evolution.cleared.iter().copied()).collect();
    let mut rings: Vec<(BTreeSet<StepId>, Ring)> = Vec::new();
    for id in cleared {
        let mut all = (touched(model, id), Ring::from([id]));
        let (same, others): (Vec<_>, Vec<_>) = rings.into_iter().partition(|(steps, _)| !steps.is_disjoint(&all.0));
        for (steps, ring) in same {
            all.0.extend(steps);
            all.1.extend(ring);
        }
        rings = others;
        rings.push(all);
    }
    rings.into_iter().map(|(_, ring)| turning(model, ring)).filter(|ring| !ring.is_empty()).collect()
}

/// The steps of a transition, and those its condition reads.
fn touched(model: &Model, id: TransitionId) -> BTreeSet<StepId> {
    let transition = &model.transitions[id];
    let mut steps: BTreeSet<StepId> = transition.sources.iter().chain(&transition.targets).copied().collect();
    let mut open: Vec<Read> = transition.condition.reads.clone();
    while let Some(read) = open.pop() {
        match read {
            Read::Active(step) => _ = steps.insert(step),
            Read::MacroActive(id) => steps.extend(&model.macros[id].steps),
            Read::Rising(edge) | Read::Falling(edge) => open.extend(&model.edges[edge].of.reads),
            _ => {}
        }
    }
    steps
}

/// Without transitions that nothing in the ring follows, or that follow nothing in it.
fn turning(model: &Model, mut ring: Ring) -> Ring {
    let transition = |id: &TransitionId| &model.transitions[*id];
    ring.retain(|id| transition(id).sources != transition(id).targets || !transition(id).clearing.is_empty());
    loop {
        let sources: BTreeSet<_> = ring.iter().flat_map(|id| &transition(id).sources).collect();
        let targets: BTreeSet<_> = ring.iter().flat_map(|id| &transition(id).targets).collect();
        let turns = |id: &&TransitionId| {
            transition(id).sources.iter().any(|step| targets.contains(step))
                && transition(id).targets.iter().any(|step| sources.contains(step))
        };
        let kept: Ring = ring.iter().filter(turns).copied().collect();
        if kept.len() == ring.len() {
            return ring;
        }
        ring = kept;
    }
}

fn meet(model: &Model, one: &Ring, other: &Ring) -> bool {
    let steps = |ring: &Ring| -> BTreeSet<StepId> {
        let of = |id: &TransitionId| model.transitions[*id].sources.clone();
        ring.iter().flat_map(of).collect()
    };
    !steps(one).is_disjoint(&steps(other))
}

/// Whether clearing a transition can have to do with the ring: both are of one partial grafcet, or the ring looks at steps or
/// variables, or is commanded.
fn belongs(model: &Model, entry: TransitionId, ring: &Ring) -> bool {
    let varies = |read: &Read| !matches!(read, Read::Name(Name::Input(_) | Name::Param(_)));
    ring.iter().any(|id| {
        let transition = &model.transitions[*id];
        let partial = transition.partial;
        partial == model.transitions[entry].partial
            || model.partials[partial].enclosed_by.is_some()
            || model.forces.values().any(|force| force.target == partial)
            || transition.condition.reads.iter().any(varies)
    })
}
