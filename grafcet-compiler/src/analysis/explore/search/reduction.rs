//! Transitions that have nothing to do with each other need not be tried in all combinations.
//!
//! Take two transitions of parallel branches, each with an input of its own. That both clear in one cycle leads where one
//! after the other leads, for each can wait while the other clears. So at most one group of such transitions moves in a
//! run; the others wait, which only demands something of inputs that nothing else reads in this run. A run that turns
//! out to read them is spoilt, and the cycle is then run in all combinations.
//!
//! - Transitions that share a source stay together, and in `sfc` those that read a step that others enter or leave.
//! - Inputs that several groups read are decided first. A group that cannot wait under them takes part in every run; in
//!   `sfc` all the others then do too, since in the next cycle that group may already be somewhere else.
//! - In a `grafcet` it is the fixed point that must be the same, whatever clears first; see [`Net::is_confluent`].

use crate::analysis::Union;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::formula::{AtomId, Formula};
use crate::analysis::explore::valuation::knowledge::{Known, Learnt};
use crate::analysis::explore::valuation::{Valuation, When};
use crate::list::{List, PushAll};
use crate::model::{StepId, TransitionId};
use crate::sorted::{Map, sort, sort_unstable};

/// Whether a group of transitions can wait in a cycle.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Wait {
    No,
    /// With these values of what edges look at; nothing is said about the others.
    With(Vec<(AtomId, Known)>),
    /// With some values of what edges look at, which cannot be said in this way.
    Unclear,
}

/// All that decides whether a group can wait.
type Key = (Vec<TransitionId>, Learnt, Learnt, Vec<StepId>, bool, bool);

/// The answers so far.
pub(crate) type Waits = Map<Key, Wait>;

/// How the transitions that are enabled at the start of a cycle may be tried: the same in all runs from one state.
pub(crate) struct Groups {
    members: Vec<Vec<TransitionId>>,
    /// Atoms that several groups read, ascending.
    shared: Vec<AtomId>,
    /// Where no atom is shared, how each group can wait.
    waits: Option<Vec<Wait>>,
}

/// The groups of what is enabled at the start of a cycle; none where all is tried in all combinations.
pub(crate) fn at_start(valuation: &mut Valuation<'_>, enabled: &[TransitionId]) -> Option<Groups> {
    if enabled.len() < 2 || !may_arbitrate(valuation, enabled) {
        return None;
    }
    let mut found = find(valuation.net, enabled);
    if found.members.len() < 2 {
        return None;
    }
    if found.shared.is_empty() {
        found.waits = Some(found.members.iter().map(|group| can_wait(valuation, group)).list());
    }
    Some(found)
}

fn find(net: &Net, open: &[TransitionId]) -> Groups {
    let groups = groups(net, open);
    let shared = shared(net, &groups);
    Groups { members: groups, shared, waits: None }
}

/// `grafcet`: what becomes enabled later in the cycle waits if it can.
pub(crate) fn later(valuation: &mut Valuation<'_>, enabled: &[TransitionId]) -> Vec<TransitionId> {
    let open: Vec<TransitionId> = enabled.iter().filter(|transition| !valuation.is_still(**transition)).copied().list();
    if open.is_empty() || !may_arbitrate(valuation, &open) {
        return open;
    }
    // To find out which of them can wait each is looked at.
    valuation.work += open.len() as u64;
    arbitrate(valuation, &find(valuation.net, &open), false)
}

/// Decides which of the transitions wait in this evolution and the rest of the cycle, and returns the others in source
/// order; `may_move` is false where all wait that can.
pub(crate) fn arbitrate(valuation: &mut Valuation<'_>, found: &Groups, may_move: bool) -> Vec<TransitionId> {
    let net = valuation.net;
    let mut free: Vec<TransitionId> = Vec::new();
    let mut waiting: Vec<(&Vec<TransitionId>, Wait)> = Vec::new();
    let mut moved = false;
    for (number, group) in found.members.iter().enumerate() {
        for transition in group {
            decide_shared(valuation, &net.arcs[*transition].condition, &found.shared);
        }
        let wait = match &found.waits {
            Some(waits) => waits[number].clone(),
            None => can_wait(valuation, group),
        };
        if wait != Wait::No {
            valuation.spoilt |= wait == Wait::Unclear;
            waiting.push((group, wait));
            continue;
        }
        free.extend(group);
        moved |= group.iter().any(|transition| valuation.decide(&net.arcs[*transition].condition, When::Now));
    }
    if moved && !net.grafcet {
        free.extend(waiting.iter().flat(|(group, _)| *group));
        sort_unstable(&mut free);
        return free;
    }
    let chosen = if may_move { valuation.tape.choose(waiting.len() + 1) } else { waiting.len() };
    for (number, (group, wait)) in waiting.iter().enumerate() {
        if number == chosen {
            // Where it waits as well, it is the run in which all wait.
            let could_move =
                group.iter().any(|transition| valuation.decide(&net.arcs[*transition].condition, When::Now));
            valuation.redundant = !could_move;
            free.extend(*group);
        } else if let Wait::With(values) = wait {
            valuation.wait(group, values);
        }
    }
    sort_unstable(&mut free);
    free
}

/// Whether waiting and moving can be told apart by the inputs alone.
fn may_arbitrate(valuation: &Valuation<'_>, open: &[TransitionId]) -> bool {
    let net = valuation.net;
    if net.grafcet { net.is_confluent(valuation.unit) } else { open.iter().all(|t| !net.arcs[*t].reads_slots) }
}

/// The transitions in groups that share sources; `sfc`: and steps that one reads and another changes.
pub(crate) fn groups(net: &Net, open: &[TransitionId]) -> Vec<Vec<TransitionId>> {
    let mut union = Union::new(open.len());
    let mut by_source: Vec<(StepId, usize)> = Vec::new();
    for (position, transition) in open.iter().enumerate() {
        by_source.push_all(net.arcs[*transition].sources.iter().map(|step| (*step, position)));
    }
    sort(&mut by_source);
    for pair in by_source.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        union.join(pair[0].1, pair[1].1);
    }
    for (position, transition) in open.iter().enumerate() {
        for step in &net.arcs[*transition].reads_steps {
            for (other, changing) in open.iter().enumerate() {
                let arc = &net.arcs[*changing];
                if arc.sources.contains(step) || arc.targets.contains(step) {
                    union.join(position, other);
                }
            }
        }
    }
    let mut groups: Map<usize, Vec<TransitionId>> = Map::new();
    for (position, transition) in open.iter().enumerate() {
        groups.or_default(union.root(position)).push(*transition);
    }
    groups.into_iter().map(|(_, members)| members).list()
}

/// The atoms that more than one group reads, ascending.
fn shared(net: &Net, groups: &[Vec<TransitionId>]) -> Vec<AtomId> {
    let mut uses: Vec<(AtomId, usize)> = Vec::new();
    for (number, group) in groups.iter().enumerate() {
        for transition in group {
            uses.push_all(net.arcs[*transition].atoms.iter().map(|atom| (*atom, number)));
        }
    }
    sort(&mut uses);
    uses.dedup();
    let twice = uses.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[0].0);
    let mut shared: Vec<AtomId> = twice.list();
    shared.push_all(uses.iter().map(|(atom, _)| *atom).filter(|atom| net.is_common[*atom]));
    sort_unstable(&mut shared);
    shared.dedup();
    shared
}

/// Decides the comparisons of shared atoms, so that what a group does is left to atoms of its own.
fn decide_shared(valuation: &mut Valuation<'_>, formula: &Formula, shared: &[AtomId]) {
    if shared.is_empty() {
        return;
    }
    match formula {
        Formula::Const(_) => {}
        Formula::Is(atom) | Formula::Below(atom, _) | Formula::Equals(atom, _) => {
            if shared.binary_search(atom).is_ok() {
                valuation.decide(formula, When::Now);
            }
        }
        Formula::Not(inner) => decide_shared(valuation, inner, shared),
        Formula::And(a, b) | Formula::Or(a, b) | Formula::Same(a, b) => {
            decide_shared(valuation, a, shared);
            decide_shared(valuation, b, shared);
        }
        Formula::Rising(edge) | Formula::Falling(edge) => {
            let net = valuation.net;
            if let Some(of) = &net.edges[*edge] {
                if net.edge_reads(*edge, shared) {
                    valuation.decide(of, When::Sample);
                    if !valuation.edgeless {
                        valuation.decide(of, When::Before);
                    }
                }
            }
        }
        Formula::Shared(index) => {
            let net = valuation.net;
            decide_shared(valuation, &net.shared[*index], shared);
        }
    }
}

/// Whether no transition of the group clears under some values of the atoms that are not decided yet.
fn can_wait(valuation: &mut Valuation<'_>, group: &[TransitionId]) -> Wait {
    let net = valuation.net;
    let mut atoms: Vec<AtomId> = Vec::new();
    let mut just_entered: Vec<StepId> = Vec::new();
    let mut steps_matter = false;
    for transition in group {
        let arc = &net.arcs[*transition];
        atoms.extend(&arc.atoms);
        just_entered.extend(arc.sources.iter().filter(|step| valuation.just_entered.contains(step)));
        steps_matter |= !arc.reads_steps.is_empty();
    }
    sort_unstable(&mut atoms);
    atoms.dedup();
    let (given, recorded) = valuation.knowledge_of(&atoms);
    let key = (group.to_vec(), given, recorded, just_entered, valuation.edgeless, valuation.previous.is_some());
    if !steps_matter {
        if let Some(known) = valuation.waits.get(&key) {
            return known.clone();
        }
    }
    let wait = try_to_wait(valuation, group, &key, &atoms);
    if !steps_matter {
        valuation.waits.insert(key, wait.clone());
    }
    wait
}

fn try_to_wait(valuation: &mut Valuation<'_>, group: &[TransitionId], key: &Key, atoms: &[AtomId]) -> Wait {
    let net = valuation.net;
    let mut trial = valuation.trial.take().unwrap_or_else(|| Box::new(Valuation::new(net, valuation.unit)));
    let edge_atoms: Vec<AtomId> = atoms.iter().filter(|atom| net.is_edge_atom[**atom]).copied().list();
    let mut ways: Vec<Vec<(AtomId, Known)>> = Vec::new();
    let mut unclear = false;
    trial.tape.restart();
    loop {
        trial.resume(valuation, &key.1, &key.2);
        let waits = !group.iter().any(|transition| trial.decide(&net.arcs[*transition].condition, When::Now));
        if waits && trial.goes_together() {
            unclear |= trial.late;
            let (given, _) = trial.knowledge_of(&edge_atoms);
            if !ways.contains(&given) {
                ways.push(given);
            }
        }
        if !trial.tape.advance() {
            break;
        }
    }
    valuation.work += std::mem::take(&mut trial.work);
    valuation.trial = Some(trial);
    let known = |way: &Vec<(AtomId, Known)>| way.iter().all(|pair| key.1.contains(pair));
    match &ways[..] {
        [] => Wait::No,
        _ if unclear => Wait::Unclear,
        ways if ways.iter().any(known) => Wait::With(Vec::new()),
        [way] => Wait::With(way.clone()),
        ways if covers(ways, &key.1) => Wait::With(Vec::new()),
        _ => Wait::Unclear,
    }
}

/// Whether ways that differ in one boolean atom cover both of its values.
fn covers(ways: &[Vec<(AtomId, Known)>], given: &[(AtomId, Known)]) -> bool {
    let new = |way: &Vec<(AtomId, Known)>| -> Vec<(AtomId, Known)> {
        way.iter().filter(|pair| !given.contains(pair)).copied().list()
    };
    let ways: Vec<Vec<(AtomId, Known)>> = ways.iter().map(new).list();
    let mut atoms: Vec<AtomId> = ways.iter().flatten().map(|(atom, _)| *atom).list();
    sort_unstable(&mut atoms);
    atoms.dedup();
    // All combinations of boolean values, each atom decided in all of them.
    atoms.len() < 8
        && (0..1_usize << atoms.len()).all(|bits| {
            ways.iter().any(|way| {
                way.iter().all(|(atom, known)| {
                    let position = atoms.binary_search(atom).unwrap_or(0);
                    *known == Known::Bool(bits & (1 << position) != 0)
                })
            })
        })
}
