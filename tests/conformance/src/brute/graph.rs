//! A naive exploration: from every state, one cycle with every valuation of the inputs.
//!
//! Time is taken in leaps: from one cycle to the next none passes, or half of all the time that there is. What happens so can
//! happen; not everything that can happen does so.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::model::{
    Binary, Claim, Effect, Expr, Model, Name, Place, Read, StepId, TimeRef, TransitionId, Tree, Ty,
};
use grafcet_sim::interp::{Evolution, Interpreter, Memory, Situation, Value};

/// Half of what a tick count holds: two of them are more than any time in a chart, and lead back to the same count.
pub(crate) const LEAP: u32 = 1 << 31;

/// All that can happen in a chart without time; in one with time, a part of it.
pub struct Graph {
    /// What can be at the end of a cycle; the first is what is before the first cycle.
    pub states: Vec<State>,
    /// The inputs of each valuation, in the order of declaration.
    pub valuations: Vec<Vec<Value>>,
}

/// What a chart remembers between two cycles.
pub struct State {
    /// The active steps.
    pub situation: Situation,
    /// All of it.
    memory: Memory,
    /// One cycle for each valuation; in a chart with time these without and then with a leap.
    pub cycles: Vec<Edge>,
}

/// One cycle.
pub struct Edge {
    /// The state after it.
    pub to: usize,
    /// The evolutions that were looked at, in `grafcet` also the one with which the search was over.
    pub evolutions: Vec<Evolution>,
    /// It ended in a stable situation (A30).
    pub stable: bool,
    /// The number of its inputs among the valuations.
    pub valuation: usize,
}

impl Edge {
    /// What was cleared.
    pub fn cleared<'a>(&'a self, model: &Model) -> impl Iterator<Item = TransitionId> + 'a {
        self.done(model).iter().flat_map(|evolution| evolution.cleared.iter().copied())
    }

    /// The evolutions that took place: not the one at which the bound stopped a search. Where that is stable the last one cleared at most
    /// what leads to the same situation (A4g): a self-loop turns all the same.
    #[must_use]
    pub fn done(&self, model: &Model) -> &[Evolution] {
        match self.evolutions.split_last() {
            Some((_, before)) if model.is_grafcet() && !self.stable => before,
            _ => &self.evolutions,
        }
    }
}

impl Graph {
    /// Explores a chart; `None` if that takes more cycles than `most`.
    ///
    /// # Errors
    /// The interpreter does not understand the chart, or its arithmetic fails.
    pub fn of(model: &Model, most: usize) -> Result<Option<Self>, String> {
        let mut machine = Interpreter::new(model).map_err(|error| error.to_string())?;
        let Some(mut valuations) = valuations(model, most) else { return Ok(None) };
        let excluded = excluded(model, &machine, &valuations)?;
        let mut excluded = excluded.into_iter();
        valuations.retain(|_| !excluded.next().unwrap_or(false));
        let mut numbers = BTreeMap::from([(machine.memory().clone(), 0)]);
        let mut graph = Self { states: vec![State::new(&machine)], valuations };
        let times: &[u32] = if passes(model) { &[0, LEAP] } else { &[0] };
        let mut nows = vec![0_u32];
        let mut next = 0;
        while next < graph.states.len() {
            if graph.states.len() * graph.valuations.len() * times.len() > most {
                return Ok(None);
            }
            for index in 0..graph.valuations.len() * times.len() {
                let now = nows[next].wrapping_add(times[index / graph.valuations.len()]);
                let inputs = &graph.valuations[index % graph.valuations.len()];
                machine.resume(graph.states[next].memory.clone());
                let cycle = machine.cycle(inputs, now).map_err(|error| error.to_string())?;
                let to = *numbers.entry(machine.memory().clone()).or_insert_with(|| {
                    nows.push(now);
                    graph.states.push(State::new(&machine));
                    graph.states.len() - 1
                });
                let valuation = index % graph.valuations.len();
                let edge = Edge { to, evolutions: cycle.seen, stable: cycle.stable, valuation };
                graph.states[next].cycles.push(edge);
            }
            next += 1;
        }
        Ok(Some(graph))
    }

    /// All cycles with the states they start from.
    pub fn cycles(&self) -> impl Iterator<Item = (usize, &Edge)> {
        self.states.iter().enumerate().flat_map(|(from, state)| state.cycles.iter().map(move |edge| (from, edge)))
    }

    /// Whether an expression can hold at the end of a cycle, on its inputs, outputs and situation.
    ///
    /// # Errors
    /// The interpreter does not understand it.
    pub fn can_hold(&self, model: &Model, tree: &Tree) -> Result<bool, String> {
        for (_, edge) in self.cycles() {
            if self.holds(model, edge, tree)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether an expression holds at the end of a cycle.
    ///
    /// # Errors
    /// The interpreter does not understand it.
    pub fn holds(&self, model: &Model, edge: &Edge, tree: &Tree) -> Result<bool, String> {
        let mut machine = Interpreter::new(model).map_err(|error| error.to_string())?;
        machine.resume(self.states[edge.to].memory.clone());
        machine.holds(tree, &self.valuations[edge.valuation]).map_err(|error| error.to_string())
    }

    /// Whether the end of some cycle has no way back to the end of one in exactly this situation.
    #[must_use]
    pub fn can_miss(&self, model: &Model, home: &Situation) -> bool {
        self.misses(model, home).into_iter().skip(1).any(|missed| missed)
    }

    /// For each state, whether it has no way back to the end of a cycle in exactly this situation.
    #[must_use]
    pub fn misses(&self, model: &Model, home: &Situation) -> Vec<bool> {
        // It speaks of the partial grafcets that hold its steps.
        let partials: BTreeSet<_> = home.iter().map(|step| model.steps[*step].partial).collect();
        let concerned = |step: &&StepId| partials.contains(&model.steps[**step].partial);
        let is_home = |situation: &Situation| situation.iter().filter(concerned).eq(home.iter());
        let back = self.can_still(|edge| is_home(&self.states[edge.to].situation));
        self.states.iter().zip(back).map(|(state, back)| !back && !is_home(&state.situation)).collect()
    }

    /// Whether leaps of time show every situation and every way: times are those of steps, all compared with the same
    /// constant and each alone, or matter to outputs alone, which nothing reads.
    #[must_use]
    pub fn is_whole(model: &Model) -> bool {
        let mut times = BTreeSet::new();
        let conditions = model.transitions.values().map(|transition| &transition.condition);
        let actions = model.associations.values().flat_map(|a| a.condition.iter().chain(&a.event));
        let values = model.associations.values().flat_map(|a| a.effect.expressions());
        let edges = model.edges.values().map(|edge| &edge.of);
        let mut all = conditions.chain(actions).chain(values).chain(edges);
        let of_output =
            |effect: &Effect| matches!(effect, Effect::Control(Place::Output(_)) | Effect::Assign(Place::Output(_), _));
        let mut with_time = model.associations.values().filter(|association| association.time.is_some());
        // That one time is always longer than another is not followed by the checker.
        let is_time = |read: &&Read| {
            matches!(read, Read::Since(_) | Read::MacroSince(_) | Read::Elapsed(..) | Read::MacroElapsed(..))
        };
        let one_step = |expr: &Expr| expr.reads.iter().filter(is_time).count() < 2;
        all.all(|expr| is_plain(&expr.tree, &mut times) && one_step(expr))
            && with_time.all(|association| of_output(&association.effect))
            && times.len() < 2
    }

    /// For each state, whether a cycle of which `good` is true can still come.
    pub fn can_still(&self, good: impl Fn(&Edge) -> bool) -> Vec<bool> {
        let mut can: Vec<bool> = self.states.iter().map(|state| state.cycles.iter().any(&good)).collect();
        let mut changed = true;
        while changed {
            changed = false;
            for from in (0..self.states.len()).rev() {
                if !can[from] && self.states[from].cycles.iter().any(|edge| can[edge.to]) {
                    can[from] = true;
                    changed = true;
                }
            }
        }
        can
    }
}

impl State {
    /// All that the chart remembers.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    fn new(machine: &Interpreter<'_>) -> Self {
        let (situation, memory) = (machine.situation().clone(), machine.memory().clone());
        Self { situation, memory, cycles: Vec::new() }
    }
}

/// Whether it matters that time passes, to the chart or to its properties.
pub(crate) fn passes(model: &Model) -> bool {
    let is_time =
        |read: &Read| matches!(read, Read::Since(_) | Read::MacroSince(_) | Read::Elapsed(..) | Read::MacroElapsed(..));
    let reads = |claim: &Claim| claim.expressions().iter().any(|expr| expr.reads.iter().any(is_time));
    let deadline = |claim: &Claim| matches!(claim, Claim::LeadsTo { within: Some(_), .. });
    model.uses_time() || model.properties.iter().any(|property| reads(&property.claim) || deadline(&property.claim))
}

/// Whether an expression reads no outputs, and times only to see whether steps have been active for so long; collects for
/// how long.
fn is_plain(tree: &Tree, times: &mut BTreeSet<u32>) -> bool {
    match tree {
        Tree::Elapsed(TimeRef::Ticks(ticks), _) | Tree::MacroElapsed(TimeRef::Ticks(ticks), _) => {
            times.insert(*ticks);
            true
        }
        Tree::Binary(Binary::Lt | Binary::Ge, a, b)
            if matches!(**a, Tree::Read(Read::Since(_) | Read::MacroSince(_))) =>
        {
            let Tree::Read(Read::Ticks(ticks)) = **b else { return false };
            times.insert(ticks);
            true
        }
        Tree::Read(Read::Since(_) | Read::MacroSince(_) | Read::Delay(_) | Read::Name(Name::Output(_)))
        | Tree::Elapsed(..)
        | Tree::MacroElapsed(..) => false,
        Tree::Unary(_, inner) => is_plain(inner, times),
        Tree::Binary(_, a, b) => is_plain(a, times) && is_plain(b, times),
        Tree::Bool(_) | Tree::Int(_) | Tree::Read(_) | Tree::Opaque { .. } => true,
    }
}

/// Both values of every boolean, and of a number those around each constant it could be compared with; `None` if these are
/// more than `most`, or there is an input of another type.
fn valuations(model: &Model, most: usize) -> Option<Vec<Vec<Value>>> {
    let mut all = vec![Vec::new()];
    for (id, input) in model.inputs.iter() {
        let values: Vec<Value> = match input.ty {
            Ty::Bool(_) => vec![Value::Bool(false), Value::Bool(true)],
            Ty::Int { signed, bits, .. } => representatives(model, signed, bits),
            Ty::Time(_) | Ty::Other(_) => {
                // A variant is its place in the list.
                let listed = model.variants_of(Name::Input(id))?;
                (0..listed.list.len()).map(|place| Value::Int(place as i128)).collect()
            }
        };
        if all.len() * values.len() > most {
            return None;
        }
        let longer = |start: Vec<Value>| values.iter().map(move |value| [&start[..], &[*value]].concat()).collect();
        all = all.into_iter().flat_map(|start| -> Vec<Vec<Value>> { longer(start) }).collect();
    }
    Some(all)
}

/// Which inputs the plant excludes.
fn excluded(model: &Model, machine: &Interpreter<'_>, valuations: &[Vec<Value>]) -> Result<Vec<bool>, String> {
    let excluded = |inputs: &Vec<Value>| {
        let mut holds = model.assumptions.iter().map(|assumption| machine.holds(&assumption.never.tree, inputs));
        holds.try_fold(false, |any, one| Ok(any || one.map_err(|error| error.to_string())?))
    };
    valuations.iter().map(excluded).collect()
}

pub(super) fn representatives(model: &Model, signed: bool, bits: u32) -> Vec<Value> {
    let (first, last) = if signed { (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) } else { (0, (1_i128 << bits) - 1) };
    let mut values = BTreeSet::from([first, last]);
    let conditions = model.transitions.values().map(|transition| &transition.condition.tree);
    let edges = model.edges.values().map(|edge| &edge.of.tree);
    let others = model.associations.values().flat_map(|a| a.condition.iter().chain(&a.event)).map(|expr| &expr.tree);
    let assigned = model.associations.values().flat_map(|a| a.effect.expressions()).map(|expr| &expr.tree);
    let assumed = model.assumptions.iter().map(|assumption| &assumption.never.tree);
    let claimed = model.properties.iter().flat_map(|property| property.claim.expressions()).map(|expr| &expr.tree);
    for tree in conditions.chain(edges).chain(others).chain(assigned).chain(assumed).chain(claimed) {
        constants(tree, &mut |constant| values.extend([constant - 1, constant, constant + 1]));
        // Between two numbers that are compared with each other, or added, all that are small count.
        if relates(tree) {
            values.extend(0..=4);
        }
    }
    values.into_iter().filter(|value| (first..=last).contains(value)).map(Value::Int).collect()
}

/// Whether numbers that are not constants meet in it.
fn relates(tree: &Tree) -> bool {
    let is_constant = |tree: &Tree| matches!(tree, Tree::Int(_));
    match tree {
        Tree::Unary(_, operand) => relates(operand),
        Tree::Binary(Binary::Add | Binary::Mul | Binary::Div | Binary::Rem, ..) => true,
        Tree::Binary(Binary::Lt | Binary::Le | Binary::Gt | Binary::Ge | Binary::Eq | Binary::Ne, left, right) => {
            !is_constant(left) && !is_constant(right) || relates(left) || relates(right)
        }
        Tree::Binary(_, left, right) => relates(left) || relates(right),
        _ => false,
    }
}

fn constants(tree: &Tree, found: &mut impl FnMut(i128)) {
    match tree {
        Tree::Int(value) => found(*value),
        Tree::Unary(_, operand) => constants(operand, found),
        Tree::Binary(_, left, right) => {
            constants(left, found);
            constants(right, found);
        }
        _ => {}
    }
}
