//! A chart with its plants, gone through naively by the interpreters of all of them: from every state one cycle with every input, choice and
//! fault, and with every time up to one than which nothing is longer.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Claim, Id, InputId, Model, Tree, Ty, Wire};
use grafcet_sim::interp::{ClosedLoop, Value};

use super::graph;
use super::responses::{Broken, Edges, Step};

/// What has been seen, by what is assumed to come one after the other: for how long an answer has been waited for, or that the first has come.
type Seen = Vec<Option<u32>>;

/// All that can happen.
pub(crate) struct Closed {
    /// By state, its cycles; the first state is what is before the first cycle.
    cycles: Vec<Vec<Cycle>>,
}

/// A cycle.
struct Cycle {
    to: usize,
    elapsed: u32,
    /// By property: its two conditions, and what it is about.
    holds: Vec<[bool; 3]>,
    comes: Vec<bool>,
}

impl Closed {
    /// Explores a chart with its plants, in which no time is compared with anything that is longer than `longest` ticks; `None` if that takes more
    /// cycles than `most`.
    ///
    /// # Errors
    /// The interpreter does not understand it.
    pub(crate) fn of(model: &Model, longest: u32, most: usize) -> Result<Option<Self>, String> {
        let mut start = ClosedLoop::new(model).map_err(|error| error.to_string())?;
        let nothing: Seen = vec![None; model.orders.len()];
        let mut numbers = BTreeMap::from([((start.settle(longest), nothing.clone()), 0)]);
        let (mut states, mut cycles) = (vec![(start, nothing)], Vec::new());
        let Some(choices) = choices(model, &states[0].0, most) else { return Ok(None) };
        let times = 0..=model.longest_cycle.unwrap_or(longest).min(longest);
        while cycles.len() < states.len() {
            let mut here = Vec::new();
            if states.len() * choices.len() * times.clone().count() > most {
                return Ok(None);
            }
            for (inputs, free) in &choices {
                for elapsed in times.clone() {
                    let ((mut next, mut seen), mut inputs) = (states[cycles.len()].clone(), inputs.clone());
                    next.cycle(&mut inputs, free, elapsed).map_err(|error| error.to_string())?;
                    let holds = |tree: &Tree| next.holds(tree, &inputs).map_err(|error| error.to_string());
                    let excluded = model.assumptions.iter().map(|one| holds(&one.never.tree));
                    if excluded.collect::<Result<Vec<_>, _>>()?.contains(&true) {
                        continue;
                    }
                    let mut is_so = true;
                    for (order, seen) in model.orders.iter().zip(&mut seen) {
                        let (one, other) = conditions(&order.claim);
                        is_so &= goes_on(&order.claim, (holds(&one)?, holds(&other)?), seen, elapsed);
                    }
                    if !is_so {
                        continue;
                    }
                    let of_claim = |claim: &Claim| {
                        let (one, other) = conditions(claim);
                        let trigger = claim.trigger().map_or(Ok(true), |trigger| holds(&trigger.tree))?;
                        Ok([holds(&one)?, holds(&other)?, trigger])
                    };
                    let all = model.properties.iter().map(|property| of_claim(&property.claim));
                    let all = all.collect::<Result<_, String>>()?;
                    let often = model.often.iter().map(|often| holds(&often.tree));
                    let answered = model.orders.iter().zip(&seen).filter(|(order, _)| is_some_time(&order.claim));
                    let answered = answered.map(|(_, seen)| Ok(seen.is_none()));
                    let comes = often.chain([Ok(elapsed > 0)]).chain(answered).collect::<Result<_, String>>()?;
                    let to = *numbers.entry((next.settle(longest), seen.clone())).or_insert_with(|| {
                        states.push((next, seen));
                        states.len() - 1
                    });
                    here.push(Cycle { to, elapsed, holds: all, comes });
                }
            }
            cycles.push(here);
        }
        Ok(Some(Self { cycles }))
    }

    /// How many states.
    pub(crate) fn states(&self) -> usize {
        self.cycles.len()
    }

    /// How a property is broken, if it is.
    pub(crate) fn broken(&self, property: usize, claim: &Claim) -> Option<Broken> {
        let step = |cycle: &Cycle| {
            let [one, other, _] = cycle.holds[property];
            Step { to: cycle.to, elapsed: cycle.elapsed, one, other, comes: cycle.comes.clone() }
        };
        Edges(self.cycles.iter().map(|cycles| cycles.iter().map(step).collect()).collect()).broken(claim)
    }

    /// Whether what a property is about ever happens.
    pub(crate) fn happens(&self, property: usize) -> bool {
        self.cycles.iter().flatten().any(|cycle| cycle.holds[property][2])
    }
}

fn is_some_time(claim: &Claim) -> bool {
    matches!(claim, Claim::LeadsTo { within: None, .. })
}

/// Whether what is assumed goes on to be so at the end of a cycle, of which two conditions are given.
fn goes_on(claim: &Claim, (one, other): (bool, bool), seen: &mut Option<u32>, elapsed: u32) -> bool {
    match claim {
        Claim::LeadsTo { within, .. } => {
            let waited = seen.map(|time| time + elapsed);
            let is_late = within.is_some_and(|most| waited.is_some_and(|time| time >= most) && !other);
            let time = waited.or(one.then_some(0)).filter(|_| !other);
            // Where nothing limits it, how long does not matter.
            *seen = time.map(|time| if within.is_some() { time } else { 0 });
            !is_late
        }
        _ => {
            *seen = seen.or(one.then_some(0));
            !other || seen.is_some()
        }
    }
}

fn conditions(claim: &Claim) -> (Tree, Tree) {
    match claim {
        Claim::LeadsTo { from, to, .. } => (from.tree.clone(), to.tree.clone()),
        Claim::Before { first, then } => (first.tree.clone(), then.tree.clone()),
        claim => (claim.violation().unwrap_or(Tree::Bool(false)), Tree::Bool(false)),
    }
}

/// What the chart can be given, and what nobody drives of the plants.
type Choice = (Vec<Value>, Vec<Vec<Value>>);

fn choices(model: &Model, start: &ClosedLoop<'_>, most: usize) -> Option<Vec<Choice>> {
    let plants = &model.plants;
    let is_given = |id: InputId| {
        plants.driven.iter().all(|driven| driven.input != id)
            && plants.watched.iter().all(|watched| watched.input != id)
    };
    let mut all = vec![start.nothing()];
    let mut each = |values: &[Value], put: &dyn Fn(&mut Choice, Value)| {
        if all.len() * values.len() > most {
            return None;
        }
        let with = |choice: &Choice| -> Vec<Choice> {
            let one = |value: &Value| {
                let mut choice = choice.clone();
                put(&mut choice, *value);
                choice
            };
            values.iter().map(one).collect()
        };
        all = all.iter().flat_map(with).collect();
        Some(())
    };
    for (id, input) in model.inputs.iter().filter(|(id, _)| is_given(*id)) {
        let values = match input.ty {
            Ty::Bool(_) => vec![Value::Bool(false), Value::Bool(true)],
            Ty::Int { signed, bits, .. } => graph::representatives(model, signed, bits),
            Ty::Time(_) | Ty::Other(_) => return None,
        };
        each(&values, &|choice, value| choice.0[id.index()] = value)?;
    }
    for (number, plant) in plants.list.iter().enumerate() {
        for (input, _) in plant.wires.iter().enumerate().filter(|(_, wire)| matches!(wire, Wire::Free)) {
            let both = [Value::Bool(false), Value::Bool(true)];
            each(&both, &|choice, value| choice.1[number][input] = value)?;
        }
    }
    Some(all)
}
