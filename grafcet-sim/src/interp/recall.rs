//! What a chart remembers, put together from the fields of its compiled state.
//!
//! The compiled chart stores what it needs. What it does not store follows from the rest, here as there: which step is active says what a timer of that
//! step has counted, and whether an action under N was active. What follows from nothing is told, and never guessed.

use std::collections::{BTreeMap, BTreeSet};

use super::by_state;
use super::control::{ActionControl, Target};
use super::grafcet::Continuous;
use super::is_combinational;
use super::state::State;
use super::time::{Delayed, Stopwatch};
use super::value::Value;
use super::variant;
use super::view::Situation;
use super::{Interpreter, Machine, Memory};
use grafcet_compiler::held::Held;
use grafcet_compiler::model::{
    ActionId, Association, AssociationId, EdgeId, Effect, Id, MacroId, Model, Name, Place, Qualifier, Read, StepId,
};

/// What is known of a chart's memory.
#[derive(Clone, Default, Debug)]
pub struct Recalled {
    /// The active steps.
    pub steps: Situation,
    /// Whether the first cycle is still to come.
    pub first: bool,
    /// The reading of the clock in the last cycle.
    pub now: u32,
    /// What the fields of the state hold.
    pub values: BTreeMap<Held, Value>,
    /// Of those that name an association by its place in a list (which is left out of the key), that association.
    pub chosen: BTreeMap<Held, AssociationId>,
}

impl Recalled {
    /// What a field holds.
    pub fn note(&mut self, held: Held, value: Value) {
        let place = match value {
            Value::Int(place) => usize::try_from(place).unwrap_or(usize::MAX),
            _ => usize::MAX,
        };
        let (key, of) = match held {
            Held::TimerOf(target, q, all) => (Held::TimerOf(target, q, Vec::new()), all),
            Held::SetBy(target, q, all) => (Held::SetBy(target, q, Vec::new()), all),
            Held::Acted(target, all) => (Held::Acted(target, Vec::new()), all),
            held => {
                self.values.insert(held, value);
                return;
            }
        };
        self.chosen.extend(of.get(place).map(|id| (key, *id)));
    }
}

impl Interpreter<'_> {
    /// Goes on from what was recorded after a cycle.
    ///
    /// # Errors
    /// What cannot be told, in words.
    pub fn recall(&mut self, recalled: &Recalled) -> Result<(), String> {
        if recalled.first || recalled.values.get(&Held::First) == Some(&Value::Bool(true)) {
            return Err("a first cycle that is still to come".to_owned());
        }
        let memory = Memory::initial(self.model).map_err(|error| error.to_string())?;
        let mut recall = Recall { model: self.model, recalled, memory };
        recall.situation()?;
        recall.values()?;
        recall.edges()?;
        recall.delays()?;
        recall.control()?;
        self.memory = recall.memory;
        Ok(())
    }
}

/// A memory in the making.
struct Recall<'r> {
    model: &'r Model,
    recalled: &'r Recalled,
    memory: Memory,
}

impl Recall<'_> {
    fn state(&mut self) -> &mut State {
        &mut self.memory.state
    }

    fn value(&self, held: &Held) -> Option<Value> {
        self.recalled.values.get(held).copied()
    }

    fn truth(&self, held: &Held) -> Option<bool> {
        self.value(held).map(|value| value == Value::Bool(true))
    }

    fn ticks(&self, held: &Held) -> Option<u32> {
        match self.value(held)? {
            Value::Ticks(ticks) => Some(ticks),
            _ => None,
        }
    }

    fn is_active(&self, step: StepId) -> bool {
        self.recalled.steps.contains(&step)
    }

    fn situation(&mut self) -> Result<(), String> {
        let (model, recalled) = (self.model, self.recalled);
        let state = &mut self.memory.state;
        (state.first, state.now, state.situation) = (false, recalled.now, recalled.steps.clone());
        state.times.steps = BTreeMap::new();
        state.times.macros = BTreeMap::new();
        for step in &recalled.steps {
            let time = since(recalled, &|held| match held {
                Held::Time(steps) => steps.contains(step).then_some(None),
                Held::Phase(steps) => steps.iter().find(|(other, _)| other == step).map(|(_, period)| Some(*period)),
                _ => None,
            });
            let time = time.ok_or_else(|| format!("how long `{}` has been active", model.steps[*step].name))?;
            self.state().times.steps.insert(*step, time);
        }
        let active = |id: &MacroId| model.macros[*id].steps.iter().any(|step| recalled.steps.contains(step));
        for id in model.macros.ids().filter(active) {
            let time = since(recalled, &|held| match held {
                Held::MacroTime(of) => (*of == id).then_some(None),
                Held::MacroPhase(of, period) => (*of == id).then_some(Some(*period)),
                _ => None,
            });
            let time = time.ok_or_else(|| format!("how long `{}` has been active", model.macros[id].name))?;
            self.state().times.macros.insert(id, time);
        }
        Ok(())
    }

    /// Outputs and variables. What nobody reads and what is made anew in each cycle is unknown up to the next one.
    fn values(&mut self) -> Result<(), String> {
        let model = self.model;
        for id in model.vars.ids().filter(|id| !is_combinational(model, *id)) {
            let value = self.value(&Held::Var(id)).ok_or_else(|| format!("what `{}` is", model.vars[id].name))?;
            let value = variant::told(value, Name::Var(id), model).map_err(|error| error.to_string())?;
            self.state().vars[id.index()] = value;
        }
        for (id, output) in model.outputs.iter() {
            let place = Place::Output(id);
            let value = self.value(&Held::Output(id));
            let value = value.or_else(|| by_state::output(model, id, &self.recalled.steps));
            match value {
                Some(value) => self.state().outputs[id.index()] = value,
                None if is_kept(model, place) || is_read(model, Name::Output(id)) => {
                    return Err(format!("what `{}` was", output.name));
                }
                // The next cycle says it, unless nothing ever does.
                None if is_driven(model, place) => self.state().outputs[id.index()] = Value::Unknown,
                None => {}
            }
        }
        Ok(())
    }

    /// What `rising` and `falling` compare with: what is not asked for is taken as false.
    fn edges(&mut self) -> Result<(), String> {
        let model = self.model;
        let asked: BTreeSet<EdgeId> = model.expressions().into_iter().flatten().filter_map(edge_of).collect();
        for id in model.edges.ids() {
            let (early, late) = (self.truth(&Held::Edge(id)), self.truth(&Held::ActionEdge(id)));
            if early.or(late).is_none() && asked.contains(&id) {
                return Err(format!("what `{}` was", model.edges[id].of.text));
            }
            self.state().edges.insert(id, early.or(late).unwrap_or(false));
            self.state().action_edges.insert(id, late.or(early).unwrap_or(false));
        }
        Ok(())
    }

    fn delays(&mut self) -> Result<(), String> {
        let model = self.model;
        for (id, delay) in model.delays.iter() {
            let stage = self.value(&Held::DelayStage(id));
            let is_one_of = |stages: [i128; 2]| stage.map(|stage| stages.map(Value::Int).contains(&stage));
            let parts = (
                self.truth(&Held::DelayInput(id)).or(is_one_of([1, 2])),
                self.ticks(&Held::DelayHeld(id)),
                self.truth(&Held::DelayOutput(id)).or(is_one_of([2, 3])),
            );
            let (Some(signal), Some(held), Some(output)) = parts else {
                return Err(format!("how long `{}` has been so", delay.of.text));
            };
            self.state().delays.insert(id, Delayed::of(signal, held, output));
        }
        Ok(())
    }

    fn control(&mut self) -> Result<(), String> {
        let machine = std::mem::replace(&mut self.memory.machine, Machine::Grafcet(super::Grafcet::default()));
        self.memory.machine = match machine {
            Machine::Sfc(mut sfc) => {
                for (target, control) in &mut sfc.controls {
                    self.target(*target, control).map_err(|what| format!("{what} of {}", self.name_of(control)))?;
                }
                Machine::Sfc(sfc)
            }
            Machine::Grafcet(mut grafcet) => {
                for action in self.model.actions.ids() {
                    grafcet.calls.extend(self.called(action).map(|continuous| (action, continuous)));
                }
                Machine::Grafcet(grafcet)
            }
        };
        Ok(())
    }

    /// Whether a continuous call of a `grafcet` was active, and by which association. What no field tells, the active step does.
    fn called(&self, action: ActionId) -> Option<Continuous> {
        let calls = |(id, association): (AssociationId, &Association)| {
            let is_call = matches!(association.effect, Effect::Call(other, _) if other == action);
            (is_call && super::continuous::is_continuous(association)).then_some(id)
        };
        let callers: Vec<AssociationId> = self.model.associations.iter().filter_map(calls).collect();
        let of_active = || callers.iter().copied().filter(|id| self.is_active(self.model.associations[*id].step));
        let field = callers.iter().find_map(|id| self.truth(&Held::Active(*id)));
        let active = field.unwrap_or_else(|| of_active().next().is_some());
        let by = callers.iter().find_map(|id| self.recalled.chosen.get(&Held::Acted(*id, Vec::new())));
        let last = by.copied().or_else(|| of_active().next_back()).or_else(|| callers.last().copied());
        (!callers.is_empty()).then_some(Continuous { active, last })
    }

    /// The flip-flops and timers of a target of an `sfc`.
    fn target(&self, target: Target, control: &mut ActionControl) -> Result<(), String> {
        let all = control.associations.clone();
        let held = |make: &dyn Fn(AssociationId) -> Held| {
            all.iter().map(|id| make(*id)).find(|held| self.recalled.values.contains_key(held))
        };
        let chosen = |make: &dyn Fn(AssociationId) -> Held| {
            all.iter().find_map(|id| self.recalled.chosen.get(&make(*id))).copied()
        };
        let under = |q: Qualifier| -> Vec<AssociationId> {
            all.iter().copied().filter(|id| self.model.associations[*id].qualifier == q).collect()
        };
        // What begins as true and has nothing but R is set by no association.
        let begins_set = control.flip_flops.contains(&Qualifier::S);
        control.flip_flops.clear();
        let is_asked = |q: &Qualifier| !under(*q).is_empty() || *q == Qualifier::S && begins_set;
        for q in Qualifier::ALL.into_iter().filter(|q| q.has_flip_flop() && is_asked(q)) {
            let field = held(&|id| Held::FlipFlop(id, q)).and_then(|held| self.truth(&held));
            let stored = || self.stored_by(target, q, &all);
            let Some(set) = field.or_else(stored) else { return Err(format!("what {} has set", q.word())) };
            if set {
                control.flip_flops.insert(q);
            }
            let by = chosen(&|id| Held::SetBy(id, q, Vec::new())).or_else(|| under(q).pop());
            control.set_by.extend(by.map(|by| (q, by)));
        }
        for q in Qualifier::ALL.into_iter().filter(|q| q.has_time() && !under(*q).is_empty()) {
            let times: BTreeSet<_> = under(q).iter().map(|id| self.model.associations[*id].time).collect();
            let of =
                chosen(&|id| Held::TimerOf(id, q, Vec::new())).or_else(|| under(q).pop().filter(|_| times.len() == 1));
            let Some(of) = of else { return Err(format!("which time of {} counts", q.word())) };
            control.time_of.insert(q, of);
            let stage = held(&|id| Held::TimerStage(id, q)).and_then(|held| self.value(&held));
            let input = held(&|id| Held::TimerInput(id, q)).and_then(|held| self.truth(&held));
            let input = input.or(stage.map(|stage| stage != Value::Int(0)));
            let of_flip_flop = q.times_its_flip_flop().then(|| control.flip_flops.contains(&q));
            let signal = input.or(of_flip_flop).or_else(|| self.is_on(&under(q)));
            let Some(signal) = signal else { return Err(format!("whether the timer of {} runs", q.word())) };
            let counted = held(&|id| Held::TimerHeld(id, q)).and_then(|held| self.ticks(&held));
            // Of one that is over nobody asks for how long.
            let counted = if stage == Some(Value::Int(2)) { Some(u32::MAX) } else { counted };
            let counted = counted.or_else(|| if signal { self.time_of_step(q, &under(q)) } else { Some(0) });
            let Some(counted) = counted else { return Err(format!("how long the timer of {} has run", q.word())) };
            control.timers.insert(q, Stopwatch::of(signal, counted));
        }
        if matches!(target, Target::Place(_)) {
            // It takes its value anew in each cycle, and nothing runs where that ends.
            return Ok(());
        }
        self.active(control)
    }

    /// Whether a target whose end something asks for was active, and by which associations.
    fn active(&self, control: &mut ActionControl) -> Result<(), String> {
        use Qualifier::N;
        let all = control.associations.clone();
        let qualifier = |id: &AssociationId| self.model.associations[*id].qualifier;
        let driving: Vec<AssociationId> = all.iter().copied().filter(|id| qualifier(id).drives_q()).collect();
        let field = all.iter().find_map(|id| self.truth(&Held::Active(*id)));
        let plain = driving.iter().all(|id| qualifier(id) == N);
        let derived = if driving.is_empty() {
            Some(false)
        } else {
            self.is_on(&driving).filter(|_| plain && !all.iter().any(|id| qualifier(id) == Qualifier::R))
        };
        let Some(was) = field.or(derived) else { return Err("whether it was active".to_owned()) };
        control.was = was;
        control.holding.clear();
        for id in driving.iter().filter(|id| was && qualifier(id).is_continuous()) {
            let by = self.truth(&Held::KeptBy(*id)).unwrap_or(true);
            if by && self.is_active(self.model.associations[*id].step) {
                control.holding.insert(*id);
            }
        }
        let acted = all.iter().find_map(|id| self.recalled.chosen.get(&Held::Acted(*id, Vec::new()))).copied();
        control.acted_last = acted.or_else(|| control.holding.last().copied()).or_else(|| driving.last().copied());
        Ok(())
    }

    /// Whether one of them has an active step, where that is all that is asked.
    fn is_on(&self, associations: &[AssociationId]) -> Option<bool> {
        let active = |id: &&AssociationId| self.is_active(self.model.associations[**id].step);
        let asks = associations.iter().filter(active).any(|id| self.model.associations[*id].condition.is_some());
        (!asks).then(|| associations.iter().any(|id| active(&id)))
    }

    /// What a timer has counted that runs as long as one step is active.
    fn time_of_step(&self, q: Qualifier, associations: &[AssociationId]) -> Option<u32> {
        let [one] = associations else { return None };
        let association = &self.model.associations[*one];
        let is_timed = self
            .recalled
            .values
            .keys()
            .any(|held| matches!(held, Held::Time(steps) if steps.contains(&association.step)));
        let plain = !q.times_its_flip_flop() && association.condition.is_none() && is_timed;
        let time = self.memory.state.times.steps.get(&association.step).filter(|_| plain)?;
        Some(u32::try_from(*time).unwrap_or(u32::MAX))
    }

    /// What S has set, where the output itself tells it, or the active step.
    fn stored_by(&self, target: Target, q: Qualifier, all: &[AssociationId]) -> Option<bool> {
        let Target::Place(place) = target else { return None };
        let only = all.iter().all(|id| self.model.associations[*id].qualifier.sets_or_resets());
        let field = match place {
            Place::Output(id) => self.truth(&Held::Output(id)).filter(|_| only),
            Place::Var(id) => self.truth(&Held::Var(id)).filter(|_| only),
        };
        let field = field.filter(|_| q == Qualifier::S);
        field.or_else(|| by_state::is_set(self.model, place, q, &self.recalled.steps))
    }

    fn name_of(&self, control: &ActionControl) -> String {
        let first = control.associations.first().map(|id| &self.model.associations[*id].effect);
        match first {
            Some(Effect::Control(place) | Effect::Assign(place, _)) => format!("`{}`", self.model.place_name(*place)),
            Some(Effect::Call(action, _)) => format!("`{}`", self.model.actions[*action].name),
            _ => "a block".to_owned(),
        }
    }
}

/// How long something has been active, put together of a time that may have stopped counting and of how far periods are; zero where nobody asks. `asked` says of
/// a field whether it is about that, and of which period.
fn since(recalled: &Recalled, asked: &dyn Fn(&Held) -> Option<Option<u32>>) -> Option<u64> {
    let (mut time, mut phases) = (0, Vec::new());
    for (held, value) in &recalled.values {
        let (Some(period), Value::Ticks(ticks)) = (asked(held), value) else { continue };
        match period {
            None => time = u64::from(*ticks),
            Some(period) => phases.push((u64::from(period), u64::from(*ticks))),
        }
    }
    let Some((period, reached)) = phases.first().copied() else { return Some(time) };
    let first = time + (reached + period - time % period) % period;
    let fits = |time: &u64| phases.iter().all(|(period, reached)| time % period == *reached);
    (0..MOST).map(|round| first + round * period).find(fits)
}

/// More periods are not looked at to find a time that fits to several.
const MOST: u64 = 100_000;

/// Whether a field for the place holds but a part of it: what `S` has set, beside what acts as long as a step is active.
#[must_use]
pub fn is_part(model: &Model, place: Place) -> bool {
    model
        .associations
        .values()
        .any(|one| matches!(&one.effect, Effect::Control(at) if *at == place) && !one.qualifier.sets_or_resets())
}

/// Whether some action gives an output its value.
fn is_driven(model: &Model, place: Place) -> bool {
    model.effects().iter().any(|effect| effect.writes().contains(&place))
}

/// Whether an output keeps its value from one cycle to the next unless something writes it.
fn is_kept(model: &Model, place: Place) -> bool {
    let anew = |one: &Association| match (&one.effect, model.is_grafcet()) {
        (Effect::Control(_), false) => true,
        (Effect::Assign(..), false) => one.qualifier == Qualifier::N,
        (Effect::Control(_) | Effect::Assign(..), true) => super::continuous::is_continuous(one),
        _ => false,
    };
    let stored = model.associations.values().filter(|one| !anew(one)).map(|one| &one.effect);
    let clearing = model.transitions.values().flat_map(|transition| &transition.clearing);
    stored.chain(clearing).any(|effect| effect.writes().contains(&place))
}

fn is_read(model: &Model, name: Name) -> bool {
    model.expressions().into_iter().flatten().any(|read| *read == Read::Name(name))
}

fn edge_of(read: &Read) -> Option<EdgeId> {
    match read {
        Read::Rising(id) | Read::Falling(id) => Some(*id),
        _ => None,
    }
}
