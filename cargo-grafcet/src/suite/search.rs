//! The way to the next goal: cycle by cycle in all directions, with the interpreter.

use std::collections::BTreeSet;

use grafcet_compiler::model::Model;
use grafcet_sim::{Beside, Blocked, Cycle, Error, Scripted, Simulation, Value, Wait, Why};

use super::choices::Asked;
use super::goals::{Ends, Entered, Goal};

/// The end of a cycle, or the beginning.
#[derive(Clone)]
pub(crate) struct Node<'c> {
    simulation: Simulation<'c>,
    pub(crate) now: u32,
    /// What the cycle was given.
    pub(crate) values: Vec<Value>,
    pub(crate) cycle: Option<Cycle>,
    blocked: Blocked,
    entered: Entered,
}

pub(crate) struct Search<'c> {
    beside: &'c Beside<'c>,
    ends: Ends,
    /// By transition of the names, what its condition asks for, and with it what those beside it ask for.
    asked: Vec<[Asked; 2]>,
    /// Values of signals that nobody needs otherwise.
    rest: Vec<Value>,
    /// The signals whose former values count.
    remembered: BTreeSet<usize>,
    pairs: bool,
    /// Ticks from one cycle to the next, where nothing waits for a time.
    step: u32,
    /// So many cycles are tried for each goal.
    effort: usize,
}

/// Cycles, and all goals that they show.
pub(crate) type Gone<'c> = (Vec<Node<'c>>, BTreeSet<Goal>);

/// How a search has ended.
pub(crate) enum Ended<'c> {
    /// The cycles that lead to a goal, and all goals that the last of them shows.
    Found(Vec<Node<'c>>, BTreeSet<Goal>),
    /// So many states were found, and nothing new.
    Exhausted(usize),
    /// It was not looked at all of them.
    GivenUp,
}

impl<'c> Search<'c> {
    /// # Errors
    /// The chart cannot be run.
    pub(crate) fn new(beside: &'c Beside<'c>, pairs: bool, step: u32, effort: usize) -> Result<Self, Error> {
        let model = beside.chart().model();
        let ends = Ends::of(model);
        let alone: Vec<Asked> =
            model.drawn_transitions().map(|(_, one)| Asked::of_transition(one, model, beside)).collect();
        let with_others = |(one, asked): (usize, &Asked)| {
            let mut all = asked.clone();
            ends.beside(one, model.is_grafcet()).for_each(|other| all.join(alone[other].clone()));
            [asked.clone(), all]
        };
        let asked = alone.iter().enumerate().map(with_others).collect();
        let rest = rest(beside, &beside.start()?);
        Ok(Self { beside, ends, asked, rest, remembered: remembered(model, beside), pairs, step, effort })
    }

    pub(crate) fn goals(&self) -> BTreeSet<Goal> {
        self.ends.goals(self.beside.chart(), self.pairs)
    }

    /// The chart before its first cycle.
    ///
    /// # Errors
    /// It cannot be run.
    pub(crate) fn start(&self) -> Result<Node<'c>, Error> {
        let simulation = self.beside.start()?;
        let blocked = simulation.blocked();
        Ok(Node { simulation, now: 0, values: self.rest.clone(), cycle: None, blocked, entered: Entered::new() })
    }

    /// The shortest way from there to an open goal.
    pub(crate) fn next(&self, from: &Node<'c>, open: &BTreeSet<Goal>) -> Ended<'c> {
        let mut nodes: Vec<(Node<'c>, usize)> = vec![(from.clone(), 0)];
        let mut seen = BTreeSet::from([self.key(from)]);
        let (mut at, mut tried) = (0, 0);
        while at < nodes.len() {
            let mut best: Option<(Node<'c>, BTreeSet<Goal>)> = None;
            for (now, values) in self.choices(&nodes[at].0) {
                if tried == self.effort {
                    break;
                }
                tried += 1;
                // A division by zero, or what does not fit, is no way.
                let Ok((node, shown)) = self.cycle(&nodes[at].0, now, values) else { continue };
                let new: BTreeSet<Goal> = shown.intersection(open).copied().collect();
                if worth(&new) > best.as_ref().map_or((0, 0), |(_, best)| worth(best)) {
                    best = Some((node, new));
                } else if best.is_none() && seen.insert(self.key(&node)) {
                    nodes.push((node, at));
                }
            }
            if let Some((last, new)) = best {
                return Ended::Found(way(&nodes, at, last), new);
            }
            if tried == self.effort {
                return Ended::GivenUp;
            }
            at += 1;
        }
        Ended::Exhausted(seen.len())
    }

    /// These cycles from the start on, with all goals that they show; none where one of them cannot be run.
    ///
    /// # Errors
    /// The chart cannot be run.
    pub(crate) fn along(&self, way: &[Scripted]) -> Result<Option<Gone<'c>>, Error> {
        let (mut nodes, mut shown) = (Vec::new(), BTreeSet::new());
        let mut last = self.start()?;
        for (now, values) in way {
            let Ok((next, goals)) = self.cycle(&last, *now, values.clone()) else { return Ok(None) };
            shown.extend(goals);
            nodes.push(next.clone());
            last = next;
        }
        Ok(Some((nodes, shown)))
    }

    fn cycle(&self, before: &Node<'c>, now: u32, values: Vec<Value>) -> Result<(Node<'c>, BTreeSet<Goal>), Error> {
        let (simulation, cycle) = self.beside.cycle(&before.simulation, now, &values)?;
        let mut entered = before.entered.clone();
        let shown = self.ends.shown(before.cycle.as_ref().map(|_| &before.blocked), &cycle, &mut entered);
        let blocked = cycle.blocked.clone();
        Ok((Node { simulation, now, values, cycle: Some(cycle), blocked, entered }, shown))
    }

    /// Times and values for the next cycle, first those in which little is set.
    fn choices(&self, node: &Node<'c>) -> Vec<(u32, Vec<Value>)> {
        let rest = &self.rest;
        if node.cycle.is_none() {
            return vec![(0, rest.clone())];
        }
        let mut ways: Vec<Vec<Value>> = vec![rest.clone(), node.values.clone()];
        for waiting in node.blocked.waiting.iter().filter(|one| !matches!(one.why, Why::Frozen(_))) {
            for (asked, base) in
                self.asked[waiting.transition].iter().flat_map(|asked| [(asked, rest), (asked, &node.values)])
            {
                for way in asked.ways(base, &node.simulation, self.beside) {
                    if !ways.contains(&way) {
                        ways.push(way);
                    }
                }
            }
        }
        let inputs = self.beside.inputs();
        ways.retain(|way| !node.simulation.is_excluded(&way[..inputs]));
        ways.sort_by_key(|way| way.iter().zip(rest).filter(|(value, rest)| value != rest).count());
        let left: Vec<u32> = left(&node.blocked).into_iter().map(|(_, left)| left).collect();
        // Before a time that is over with the next step there is time enough for a cycle.
        let soon = left.iter().copied().min().filter(|left| *left <= self.step);
        let mut steps: Vec<u32> = [self.step].into_iter().chain(soon.map(|left| left / 2)).collect();
        steps.extend(left.into_iter().filter(|left| *left > self.step));
        let at = |step: u32| ways.iter().map(move |way| (node.now.wrapping_add(step), way.clone()));
        steps.into_iter().flat_map(at).collect()
    }

    /// What tells states apart. Of times it is whether they are still running.
    fn key(&self, node: &Node<'c>) -> String {
        let remembered: Vec<&Value> = self.remembered.iter().map(|place| &node.values[*place]).collect();
        let running: Vec<String> = left(&node.blocked).into_iter().map(|(text, _)| text).collect();
        let (simulation, entered) = (&node.simulation, self.pairs.then_some(&node.entered));
        format!(
            "{:?}",
            (
                simulation.steps(),
                simulation.outputs(),
                simulation.variables(),
                remembered,
                running,
                entered,
                node.blocked.is_first
            )
        )
    }
}

/// How many goals there are; of as many those are worth more that are shown while the chart waits: who leaves has to come back for them.
fn worth(goals: &BTreeSet<Goal>) -> (usize, usize) {
    (goals.len(), goals.iter().filter(|goal| matches!(goal, Goal::Waited(_))).count())
}

/// From the beginning to a last cycle after the node at a place.
fn way<'c>(nodes: &[(Node<'c>, usize)], mut at: usize, last: Node<'c>) -> Vec<Node<'c>> {
    let mut way = vec![last];
    while at != 0 {
        way.push(nodes[at].0.clone());
        at = nodes[at].1;
    }
    way.reverse();
    way
}

/// The times that are running, with the ticks that are left.
fn left(blocked: &Blocked) -> Vec<(String, u32)> {
    fn walk(wait: &Wait, found: &mut Vec<(String, u32)>) {
        match wait {
            Wait::Part(part) => found.extend(part.left.map(|left| (part.text.clone(), left))),
            Wait::All(parts) | Wait::Any(parts) => parts.iter().for_each(|part| walk(part, found)),
        }
    }
    let mut found = Vec::new();
    for waiting in &blocked.waiting {
        if let Why::Waits(wait) | Why::Held { wait: Some(wait), .. } = &waiting.why {
            walk(wait, &mut found);
        }
    }
    found
}

/// What nobody has set, or where the chart assumes that this never comes, what is nearest to it and may come.
fn rest(beside: &Beside<'_>, start: &Simulation<'_>) -> Vec<Value> {
    let (model, first) = (beside.chart().model(), beside.first());
    let mut asked = Asked::default();
    model.assumptions.iter().for_each(|one| asked.join(Asked::of(&one.never.tree, model, beside)));
    let mut ways = asked.ways(&first, start, beside);
    ways.sort_by_key(|way| way.iter().zip(&first).filter(|(value, first)| value != first).count());
    let may_come = |way: &Vec<Value>| !start.is_excluded(&way[..beside.inputs()]);
    ways.into_iter().find(may_come).unwrap_or(first)
}

/// What edges and delays remember.
fn remembered(model: &Model, beside: &Beside<'_>) -> BTreeSet<usize> {
    let edges = model.edges.values().map(|edge| &edge.of.tree);
    let trees = edges.chain(model.delays.values().map(|delay| &delay.of.tree));
    trees.flat_map(|tree| Asked::of(tree, model, beside).signals().collect::<Vec<_>>()).collect()
}
