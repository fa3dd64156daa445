//! What one cycle may be given: values that conditions can tell apart.

use std::collections::BTreeSet;

use grafcet_compiler::model::{Effect, Id, Model, Name, Place, Read, Statement, Transition, Tree};
use grafcet_sim::{Beside, Kind, Simulation, Value};

/// More combinations than this are not tried in full: then each value alone.
const MOST: usize = 128;
/// So many constants are few.
const FEW: usize = 6;

/// What a condition reads from outside, and the constants in it.
#[derive(Clone, Default)]
pub(crate) struct Asked {
    signals: BTreeSet<usize>,
    numbers: BTreeSet<i128>,
    names: BTreeSet<String>,
    /// Parameters and variables, whose values count as constants.
    params: BTreeSet<usize>,
    vars: BTreeSet<String>,
}

impl Asked {
    /// What a condition asks for, also by way of edges, delays, and what is assigned to what it reads.
    pub(crate) fn of(tree: &Tree, model: &Model, beside: &Beside<'_>) -> Self {
        let mut asking = Asking { model, beside, asked: Self::default(), seen: BTreeSet::new() };
        asking.tree(tree);
        asking.asked
    }

    /// What counts as a transition clears: what its condition asks for, and what is computed then in the steps that it leads to, with
    /// the constants of what reads the results.
    pub(crate) fn of_transition(transition: &Transition, model: &Model, beside: &Beside<'_>) -> Self {
        let mut asked = Self::of(&transition.condition.tree, model, beside);
        let entered = transition.targets.iter().flat_map(|step| &model.steps[*step].associations);
        let effects = entered.map(|id| &model.associations[*id].effect).chain(&transition.clearing);
        for effect in effects.filter(|effect| !matches!(effect, Effect::Control(_) | Effect::Call(..))) {
            let mut asking = Asking { model, beside, asked: Self::default(), seen: BTreeSet::new() };
            asking.effect(effect);
            if asking.asked.signals.is_empty() {
                continue;
            }
            for condition in model.transitions.values().map(|one| &one.condition) {
                let reads = |place: &Place| condition.reads.contains(&Read::Name((*place).into()));
                if effect.writes().iter().any(reads) {
                    asking.tree(&condition.tree);
                }
            }
            asked.join(asking.asked);
        }
        asked
    }

    pub(crate) fn join(&mut self, other: Self) {
        self.signals.extend(other.signals);
        self.numbers.extend(other.numbers);
        self.names.extend(other.names);
        self.params.extend(other.params);
        self.vars.extend(other.vars);
    }

    pub(crate) fn signals(&self) -> impl Iterator<Item = usize> {
        self.signals.iter().copied()
    }

    /// Ways to set the signals that are asked for; all others are as in `base`.
    pub(crate) fn ways(&self, base: &[Value], simulation: &Simulation<'_>, beside: &Beside<'_>) -> Vec<Vec<Value>> {
        let mut ways = vec![base.to_vec()];
        let values: Vec<(usize, Vec<Value>)> =
            self.signals().map(|place| (place, self.values(place, simulation, beside))).collect();
        let all: usize = values.iter().fold(1, |all, (_, values)| all.saturating_mul(values.len().max(1)));
        for (place, values) in &values {
            let with = |way: &Vec<Value>| -> Vec<Vec<Value>> {
                let other = |value: &Value| {
                    let mut way = way.clone();
                    way[*place] = value.clone();
                    way
                };
                values.iter().map(other).collect()
            };
            if all <= MOST {
                ways = ways.iter().flat_map(with).collect();
            } else {
                let more = with(&ways[0]);
                ways.extend(more);
            }
        }
        ways
    }

    /// What a signal may be: on both sides of each constant.
    fn values(&self, place: usize, simulation: &Simulation<'_>, beside: &Beside<'_>) -> Vec<Value> {
        let around = |value: i128| [value.saturating_sub(1), value, value.saturating_add(1)];
        let known = simulation.params().into_iter().enumerate().filter(|(at, _)| self.params.contains(at));
        let known = known.map(|(_, value)| value).chain(self.vars.iter().filter_map(|name| simulation.variable(name)));
        let known = known.filter_map(|value| match value {
            Value::Int(value) => Some(value),
            Value::Ticks(value) => Some(i128::from(value)),
            _ => None,
        });
        let constants: BTreeSet<i128> = self.numbers.iter().copied().chain(known).collect();
        // Where few are added to and taken from each other, their sums and differences count, too.
        let few = if constants.len() <= FEW { constants.clone() } else { BTreeSet::new() };
        let sums = few.iter().flat_map(|a| few.iter().flat_map(move |b| [a.checked_add(*b), a.checked_sub(*b)]));
        let all = constants.iter().copied().chain(sums.flatten());
        let numbers: BTreeSet<i128> = all.chain([0]).flat_map(around).collect();
        match &beside.signals()[place].kind {
            Kind::Bool => vec![Value::Bool(false), Value::Bool(true)],
            Kind::Int { signed, bits } => {
                let bits = (*bits).min(126);
                let (low, high) =
                    if *signed { (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) } else { (0, (1 << bits) - 1) };
                numbers.into_iter().filter(|number| (low..=high).contains(number)).map(Value::Int).collect()
            }
            Kind::Float(_) => numbers
                .into_iter()
                .filter_map(|number| i32::try_from(number).ok())
                .map(|n| f64::from(n).into())
                .collect(),
            Kind::Time => {
                numbers.into_iter().filter_map(|number| u32::try_from(number).ok()).map(Value::Ticks).collect()
            }
            Kind::Listed(_, list) => list.iter().map(|name| Value::Name(name.clone())).collect(),
            Kind::Other(_) => {
                let names = self.names.iter().map(|name| Value::Name(name.clone()));
                [beside.first_of(place)].into_iter().chain(names).collect()
            }
        }
    }
}

/// Gathers what conditions and effects ask for.
struct Asking<'w> {
    model: &'w Model,
    beside: &'w Beside<'w>,
    asked: Asked,
    seen: BTreeSet<Read>,
}

impl Asking<'_> {
    fn tree(&mut self, tree: &Tree) {
        match tree {
            Tree::Bool(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => {}
            Tree::Int(value) => _ = self.asked.numbers.insert(*value),
            Tree::Read(read) => self.read(*read),
            Tree::Unary(_, of) => self.tree(of),
            Tree::Binary(_, a, b) => {
                self.tree(a);
                self.tree(b);
            }
            Tree::Opaque { text, reads, of, .. } => self.opaque(text, reads, of.iter().flat_map(|of| &of.operands)),
        }
    }

    fn opaque<'t>(&mut self, text: &str, reads: &[Read], operands: impl Iterator<Item = &'t Tree>) {
        let plain = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
        let (signals, inputs) = (self.beside.signals(), self.beside.inputs());
        let place = signals.iter().skip(inputs).position(|signal| plain(&signal.name) == plain(text));
        if let Some(place) = place {
            // The program answers, whatever it reads.
            self.asked.signals.insert(inputs + place);
            return;
        }
        if let Ok(value) = text.parse::<f64>() {
            #[expect(clippy::cast_possible_truncation, reason = "a whole number near it will do")]
            self.asked.numbers.insert(value as i128);
        } else if let Some((_, variant)) = text.rsplit_once("::") {
            self.asked.names.insert(variant.trim().to_owned());
        }
        operands.for_each(|operand| self.tree(operand));
        for read in reads {
            self.read(*read);
        }
    }

    fn read(&mut self, read: Read) {
        if !self.seen.insert(read) {
            return;
        }
        let model = self.model;
        match read {
            Read::Name(Name::Input(id)) => _ = self.asked.signals.insert(id.index()),
            Read::Name(Name::Param(id)) => _ = self.asked.params.insert(id.index()),
            Read::Name(Name::Output(id)) => self.written(Place::Output(id)),
            Read::Name(Name::Var(id)) => {
                self.asked.vars.insert(model.vars[id].name.to_string());
                self.written(Place::Var(id));
            }
            Read::Rising(id) | Read::Falling(id) => self.tree(&model.edges[id].of.tree),
            Read::Delay(id) => self.tree(&model.delays[id].of.tree),
            _ => {}
        }
    }

    fn effect(&mut self, effect: &Effect) {
        effect.expressions().iter().for_each(|one| self.tree(&one.tree));
        if let Effect::Block(code) = effect {
            code.statements.iter().for_each(|statements| self.statements(statements));
            for read in &code.reads {
                self.read(*read);
            }
        }
    }

    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Assign(_, value) => self.tree(value),
                Statement::If(condition, then, otherwise) => {
                    self.tree(condition);
                    self.statements(then);
                    self.statements(otherwise);
                }
            }
        }
    }

    /// By what is assigned to it.
    fn written(&mut self, place: Place) {
        let model = self.model;
        for association in model.associations.values().filter(|one| one.effect.writes().contains(&place)) {
            let conditions = association.condition.iter().chain(&association.event);
            conditions.for_each(|one| self.tree(&one.tree));
            self.effect(&association.effect);
        }
    }
}
