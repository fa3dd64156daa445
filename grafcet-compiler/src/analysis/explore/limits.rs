//! How much is explored, and what is answered where it does not suffice.

use super::net::Net;
use super::search::graph::Graph;
use super::verdicts::Report;
use super::verdicts::path::Path;
use crate::list::List;
use crate::model::{Name, Read, StepId, Tree};

/// How much is explored before the search gives up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Units of work: about one for each transition looked at and each atom decided.
    pub work: u64,
    /// Only some ways are gone, as in a chart that is too large to be explored as a whole.
    pub only_ways: bool,
}

impl Default for Limits {
    fn default() -> Self {
        Self { work: 300_000, only_ways: false }
    }
}

impl Limits {
    /// For `budget N;`: enough for this many situations.
    #[must_use]
    pub fn situations(count: u64) -> Self {
        Self { work: count.saturating_mul(64), only_ways: false }
    }

    /// For how many situations to ask where these did not suffice.
    #[must_use]
    pub fn more(&self) -> u64 {
        (self.work / 64).saturating_mul(10).max(100_000)
    }
}

/// The answer to whether something can happen.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Answer {
    /// In no reachable situation.
    Never,
    /// The shortest way there.
    Possible(Path),
    /// It could not be decided.
    Unknown(Doubt),
}

/// Why something could not be decided.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Doubt {
    /// The budget ran out after so many situations.
    Budget(usize),
    /// It ran out in a situation whose next cycle asks for many inputs, in all combinations.
    Inputs {
        /// The situation.
        at: Vec<StepId>,
        /// What it asks for.
        inputs: Vec<Tree>,
    },
    /// It depends on these values, which are not followed from cycle to cycle, or on Rust that is not looked into.
    Unfollowed(Vec<Tree>),
    /// It is about more than one cycle.
    Cycles,
    /// It is about the chart with its plants.
    Plants,
}

/// Per watched expression whether it can hold.
pub(super) fn answers(net: &Net, sooner: Option<&Graph>, whole: &Graph) -> Vec<Answer> {
    let answer = |index| {
        let mut graphs = sooner.into_iter().and([whole]);
        match graphs.find_map(|graph| Report { net, graph }.path_to_watched(index)) {
            Some(path) if path.granted.is_empty() => Answer::Possible(path),
            Some(path) => Answer::Unknown(Doubt::Unfollowed(path.granted)),
            None if whole.complete && !whole.cut_off => Answer::Never,
            None => Answer::Unknown(budget_doubt(net, whole)),
        }
    };
    (0..net.watched.len()).map(answer).list()
}

/// Why the budget did not suffice.
pub(super) fn budget_doubt(net: &Net, graph: &Graph) -> Doubt {
    let Some(end) = &graph.end else { return Doubt::Budget(graph.states.len()) };
    if end.work / (end.state as u64 + 1) < MANY {
        return Doubt::Budget(graph.states.len());
    }
    let mut inputs = Vec::new();
    for atom in &end.asked {
        net.atoms[*atom].what.each_read(&mut |read| {
            let input = Tree::Read(read);
            if matches!(read, Read::Name(Name::Input(_))) && !inputs.contains(&input) {
                inputs.push(input);
            }
        });
    }
    if inputs.len() < FEW {
        return Doubt::Budget(graph.states.len());
    }
    let at = graph.states[end.state].active.to_vec();
    Doubt::Inputs { at, inputs }
}

/// So few are not what it takes long with.
const FEW: usize = 8;

/// A situation that takes so many units of work has too many combinations of inputs.
const MANY: u64 = 1000;

/// A long chart has many situations without being complicated.
pub(super) fn length(net: &Net) -> u64 {
    60 * (net.leaving.len() + net.arcs.len()) as u64
}

/// The units of work for a chart.
pub(super) fn limit(net: &Net, limits: &Limits) -> u64 {
    limits.work.saturating_add(length(net))
}

/// Whether the chart has pieces that can be explored for themselves.
pub(super) fn several(net: &Net) -> bool {
    net.grafcet && (!net.hierarchy.is_empty() || net.has_arcs.values().filter(|has| **has).count() > 1)
}
