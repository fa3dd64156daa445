//! What follows from the active step alone, in a chart that is one sequence: the compiled chart does not store it.

use std::collections::BTreeMap;

use super::value::{Value, default};
use super::view::Situation;
use grafcet_compiler::model::{Association, Effect, Model, OutputId, Place, Qualifier, StepId, Tree};

/// Whether a flip-flop of a boolean is set.
pub(super) fn is_set(model: &Model, place: Place, q: Qualifier, steps: &Situation) -> Option<bool> {
    let of = |step: StepId| {
        associations(model, step).filter(move |one| matches!(&one.effect, Effect::Control(at) if *at == place))
    };
    // What DS sets, it sets when its time is over.
    let is_at_once = q != Qualifier::Ds;
    let enter = |step: StepId, before: Known| {
        let mut after = before;
        for (sets, value) in [(q, true), (Qualifier::R, false)] {
            for one in of(step).filter(|one| one.qualifier == sets) {
                let value = Known::Is(Value::Bool(value));
                let is_certain = one.condition.is_none() && (is_at_once || sets == Qualifier::R);
                after = if is_certain { value } else { after.or(value) };
            }
        }
        after
    };
    let only = model
        .associations
        .values()
        .filter(|one| matches!(&one.effect, Effect::Control(at) if *at == place))
        .all(|one| one.qualifier.sets_or_resets());
    let begins = q == Qualifier::S && only && model.starts_true(place);
    match known(model, Value::Bool(begins), steps, &enter)? {
        Value::Bool(set) => Some(set),
        _ => None,
    }
}

/// What an output is that is written by P1 alone, in a `grafcet` by S and R, too.
pub(super) fn output(model: &Model, id: OutputId, steps: &Situation) -> Option<Value> {
    let place = Place::Output(id);
    let writes = |one: &&Association| one.effect.writes().contains(&place);
    let on_entry = |one: &Association| match one.qualifier {
        Qualifier::P1 => true,
        Qualifier::S | Qualifier::R => model.is_grafcet(),
        _ => false,
    };
    let clears = |effect: &Effect| effect.writes().contains(&place);
    if !model.associations.values().filter(writes).all(on_entry)
        || model.transitions.values().any(|one| one.clearing.iter().any(clears))
    {
        return None;
    }
    let enter = |step: StepId, before: Known| {
        let mut after = before;
        for one in associations(model, step).filter(writes) {
            let value = match &one.effect {
                Effect::Assign(_, value) => constant(&value.tree),
                Effect::Control(_) => Known::Is(Value::Bool(one.qualifier == Qualifier::S)),
                _ => Known::Anything,
            };
            after = if one.condition.is_none() { value } else { after.or(value) };
        }
        after
    };
    let output = &model.outputs[id];
    let begins = match &output.init {
        None => default(&output.ty),
        Some(init) => match constant(&init.tree) {
            Known::Is(value) => value,
            Known::Anything => return None,
        },
    };
    known(model, begins, steps, &enter)
}

fn associations(model: &Model, step: StepId) -> impl Iterator<Item = &Association> {
    model.steps[step].associations.iter().map(|id| &model.associations[*id])
}

fn constant(tree: &Tree) -> Known {
    match tree {
        Tree::Bool(value) => Known::Is(Value::Bool(*value)),
        Tree::Int(value) => Known::Is(Value::Int(*value)),
        _ => Known::Anything,
    }
}

/// What is known of a value.
#[derive(Clone, Copy, PartialEq)]
enum Known {
    Is(Value),
    Anything,
}

impl Known {
    fn or(self, other: Self) -> Self {
        if self == other { self } else { Self::Anything }
    }
}

/// The value that something has in the active step, whichever way has led there; `enter` says what a step makes of it.
fn known(model: &Model, begins: Value, steps: &Situation, enter: &dyn Fn(StepId, Known) -> Known) -> Option<Value> {
    let is_sequence = model.partials.len() == 1
        && model.transitions.values().all(|one| one.sources.len() == 1 && one.targets.len() == 1)
        && model.steps.values().filter(|step| step.initial).count() == 1;
    let (true, [active]) = (is_sequence, &steps.iter().copied().collect::<Vec<_>>()[..]) else { return None };
    let initial = model.steps.iter().find(|(_, step)| step.initial).map(|(id, _)| id)?;
    let mut found: BTreeMap<StepId, Known> = BTreeMap::new();
    let mut open = vec![(initial, Known::Is(begins))];
    while let Some((step, before)) = open.pop() {
        let after = enter(step, before);
        let joined = found.get(&step).map_or(after, |known| known.or(after));
        if found.insert(step, joined) == Some(joined) {
            continue;
        }
        let leaving = model.transitions.values().filter(|one| one.sources == [step]);
        open.extend(leaving.map(|one| (one.targets[0], joined)));
    }
    match found.get(active)? {
        Known::Is(value) => Some(*value),
        Known::Anything => None,
    }
}
