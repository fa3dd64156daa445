//! The actions that write what is followed from cycle to cycle.

use super::compile::Compiler;
use super::formula::Formula;
use super::slots::{Bit, SlotId, Slots};
use crate::analysis::explore::verdicts::rivals::Rivals;
use crate::list::{List, PushAll};
use crate::model::{
    Arena, Association, Effect, Id, Model, Place, Qualifier, Statement, StepId, TransitionId, Tree, ids,
};
use crate::sorted::{Map, Set};

ids! {
    /// `grafcet`: a stored action.
    pub(crate) StoredId;
    /// `sfc`: what associations are combined for.
    pub(crate) TargetId;
}

/// An action with the conditions under which it runs.
pub(crate) struct Action {
    /// Its place in the source.
    pub(crate) position: usize,
    pub(crate) qualifier: Qualifier,
    /// None where it is done on the clearing of a transition.
    pub(crate) step: Option<StepId>,
    pub(crate) event: Option<Formula>,
    pub(crate) condition: Option<Formula>,
    pub(crate) program: Vec<Command>,
    /// Beside what is followed it does something that counts as a change (A25): a call, or a value that is not followed.
    pub(crate) more: bool,
}

impl Action {
    /// Whether its step is among these.
    pub(crate) fn is_of(&self, steps: &[StepId]) -> bool {
        self.step.is_some_and(|step| steps.contains(&step))
    }
}

/// A statement of an action.
pub(crate) enum Command {
    Set(SlotId, Formula),
    If(Formula, Vec<Command>, Vec<Command>),
}

/// `sfc`: what associations are combined for (A31).
pub(crate) enum Target {
    /// `N q`, `S q`, `R q`, `P q`
    Control { slot: SlotId, timed: Timed, by: Vec<Action> },
    /// `speed = …` on an output: the initial value while no association is active (A35).
    Assigned { slot: SlotId, initial: Bit, by: Vec<Action> },
    /// A block or a stored assignment.
    Own(Action),
}

/// What a place needs that more than S and R control: its flip-flops, and whether the times of its qualifiers have come
/// (L: have not run out).
#[derive(Default)]
pub(crate) struct Timed {
    pub(crate) flip_flops: Vec<(Qualifier, SlotId)>,
    pub(crate) times: Vec<(Qualifier, Formula)>,
}

/// The step whose action writes, or the transition on whose clearing is written.
pub(crate) type WrittenBy = (Option<StepId>, Option<TransitionId>);

/// All actions of a chart that write what is followed.
#[derive(Default)]
pub(crate) struct Actions {
    /// `grafcet`: the stored actions, in source order, and those of each step.
    pub(crate) stored: Arena<StoredId, Action>,
    pub(crate) stored_of: Map<StepId, Vec<StoredId>>,
    /// `grafcet`: the actions on clearing of each transition.
    pub(crate) clearing: Map<TransitionId, Vec<Action>>,
    /// `sfc`: the targets in the order in which they first stand in the source, and those of each step.
    pub(crate) targets: Arena<TargetId, Target>,
    pub(crate) targets_of: Map<StepId, Vec<TargetId>>,
    /// `sfc`: targets that go on as long as a flip-flop is set.
    pub(crate) lasting: Vec<(SlotId, TargetId)>,
    /// `grafcet`: stored actions of which it is asked whether they run in the same evolution.
    pub(crate) rivals: Rivals,
    /// `sfc`: which slots are outputs; these are read as the previous cycle returned them.
    pub(crate) is_output: Arena<SlotId, bool>,
}

impl Actions {
    /// Whether nothing is followed.
    pub(crate) fn is_empty(&self) -> bool {
        self.stored.is_empty() && self.clearing.is_empty() && self.targets.is_empty() && self.rivals.all.is_empty()
    }

    /// The formulas that actions evaluate.
    pub(crate) fn formulas(&self) -> Vec<&Formula> {
        let targets = self.targets.values().flat(|target| match target {
            Target::Control { by, .. } | Target::Assigned { by, .. } => by.iter(),
            Target::Own(action) => std::slice::from_ref(action).iter(),
        });
        let mut formulas = Vec::new();
        for action in self.stored.values().and(self.clearing.values().flatten()).and(targets) {
            formulas.push_all(action.event.iter().and(&action.condition));
            collect(&action.program, &mut formulas);
        }
        formulas.push_all(self.rivals.all.iter().flat(|rival| &rival.conditions));
        formulas
    }

    /// Which slots are written by an action of which step, or on the clearing of which transition.
    pub(crate) fn writers(&self) -> Vec<(SlotId, WrittenBy)> {
        let mut writers = Vec::new();
        for action in self.stored.values() {
            slots_of(&action.program, &mut |slot| writers.push((slot, (action.step, None))));
        }
        for (transition, actions) in &self.clearing {
            for action in actions {
                slots_of(&action.program, &mut |slot| writers.push((slot, (None, Some(*transition)))));
            }
        }
        writers
    }
}

fn slots_of(program: &[Command], found: &mut dyn FnMut(SlotId)) {
    for command in program {
        match command {
            Command::Set(slot, _) => found(*slot),
            Command::If(_, then, otherwise) => {
                slots_of(then, found);
                slots_of(otherwise, found);
            }
        }
    }
}

fn collect<'a>(program: &'a [Command], formulas: &mut Vec<&'a Formula>) {
    for command in program {
        match command {
            Command::Set(_, value) => formulas.push(value),
            Command::If(condition, then, otherwise) => {
                formulas.push(condition);
                collect(then, formulas);
                collect(otherwise, formulas);
            }
        }
    }
}

pub(crate) fn compile(model: &Model, slots: &Slots, compiler: &mut Compiler<'_>) -> Actions {
    let mut actions = Actions { is_output: Arena::filled(slots.initial.len(), false), ..Actions::default() };
    for (place, slot) in &slots.numbers {
        actions.is_output[*slot] = matches!(place, Place::Output(_));
    }
    let mut compile = Compile { slots, compiler };
    if model.is_grafcet() {
        compile.stored(model, &mut actions);
    } else {
        compile.targets(model, &mut actions);
    }
    actions
}

struct Compile<'c, 'm> {
    slots: &'c Slots,
    compiler: &'c mut Compiler<'m>,
}

impl Compile<'_, '_> {
    fn stored(&mut self, model: &Model, actions: &mut Actions) {
        for (id, association) in model.associations.iter() {
            let stored = association.is_stored();
            let on = association.qualifier == Qualifier::On;
            if stored && (on || self.is_followed(&association.effect)) {
                let action = actions.stored.push(self.action(id.index(), association));
                actions.stored_of.or_default(association.step).push(action);
            }
        }
        for (id, transition) in model.transitions.iter() {
            if transition.clearing.is_empty() {
                continue;
            }
            let clearing = transition.clearing.iter().map(|effect| Action {
                position: id.index(),
                qualifier: Qualifier::On,
                step: None,
                event: None,
                condition: None,
                program: self.program(effect, None),
                more: self.does_more(effect),
            });
            actions.clearing.insert(id, clearing.list());
        }
    }

    fn targets(&mut self, model: &Model, actions: &mut Actions) {
        let mut numbers: Map<Place, TargetId> = Map::new();
        for (id, association) in model.associations.iter() {
            if !self.is_followed(&association.effect) {
                continue;
            }
            let action = self.action(id.index(), association);
            let place = match &association.effect {
                Effect::Control(place) => Some(*place),
                Effect::Assign(place @ Place::Output(_), _) if association.qualifier == Qualifier::N => Some(*place),
                _ => None,
            };
            let known = place.and_then(|place| numbers.get(&place).copied());
            let number = match (known, place) {
                (Some(known), _) => {
                    if let Target::Control { by, .. } | Target::Assigned { by, .. } = &mut actions.targets[known] {
                        by.push(action);
                    }
                    known
                }
                (None, Some(place)) => {
                    let Some(slot) = self.slots.numbers.get(&place).copied() else { continue };
                    let number = actions.targets.push(self.target(model, (place, slot), &association.effect, action));
                    numbers.insert(place, number);
                    if let Target::Control { timed, .. } = &actions.targets[number] {
                        actions.lasting.push_all(timed.flip_flops.iter().map(|(_, slot)| (*slot, number)));
                    }
                    number
                }
                (None, None) => actions.targets.push(Target::Own(action)),
            };
            let of_step = actions.targets_of.or_default(association.step);
            if !of_step.contains(&number) {
                of_step.push(number);
            }
        }
    }

    fn target(&mut self, model: &Model, (place, slot): (Place, SlotId), effect: &Effect, action: Action) -> Target {
        let by = vec![action];
        match effect {
            Effect::Control(_) => Target::Control { slot, timed: self.timed(model, place), by },
            _ => Target::Assigned { slot, initial: self.slots.initial[slot], by },
        }
    }

    /// Where only S and R control the place, it is its own flip-flop.
    fn timed(&mut self, model: &Model, place: Place) -> Timed {
        let own =
            |((of, qualifier), slot): &((Place, Qualifier), SlotId)| (*of == place).then_some((*qualifier, *slot));
        let flip_flops = self.slots.flip_flops.iter().filter_map(own).list();
        let controls = |a: &&Association| matches!(a.effect, Effect::Control(of) if of == place);
        let qualifiers: Set<Qualifier> =
            model.associations.values().filter(controls).filter(|a| a.time.is_some()).map(|a| a.qualifier).collect();
        let times = qualifiers.into_iter().map(|qualifier| (qualifier, self.compiler.time_of(qualifier, place)));
        Timed { flip_flops, times: times.list() }
    }

    fn is_followed(&self, effect: &Effect) -> bool {
        effect.writes().iter().any(|place| self.slots.numbers.contains_key(place))
    }

    fn does_more(&self, effect: &Effect) -> bool {
        matches!(effect, Effect::Call(..))
            || effect.writes().iter().any(|place| !self.slots.numbers.contains_key(place))
    }

    fn action(&mut self, position: usize, association: &Association) -> Action {
        let value = match (association.qualifier, &association.effect) {
            (Qualifier::S, Effect::Control(_)) => Some(true),
            (Qualifier::R, Effect::Control(_)) => Some(false),
            _ => None,
        };
        Action {
            position,
            qualifier: association.qualifier,
            step: Some(association.step),
            event: association.event.as_ref().map(|expr| self.compiler.formula(&expr.tree)),
            condition: association.condition.as_ref().map(|expr| self.compiler.formula(&expr.tree)),
            program: self.program(&association.effect, value),
            more: self.does_more(&association.effect),
        }
    }

    fn program(&mut self, effect: &Effect, control: Option<bool>) -> Vec<Command> {
        match effect {
            Effect::Control(place) => match (self.slots.numbers.get(place), control) {
                (Some(slot), Some(value)) => vec![Command::Set(*slot, Formula::Const(value))],
                _ => Vec::new(),
            },
            Effect::Assign(place, value) => self.set(*place, &value.tree).into_iter().list(),
            Effect::Call(..) => Vec::new(),
            Effect::Block(code) => code.statements.as_deref().map_or_else(Vec::new, |all| self.commands(all)),
        }
    }

    fn commands(&mut self, statements: &[Statement]) -> Vec<Command> {
        let mut commands = Vec::new();
        for statement in statements {
            match statement {
                Statement::Assign(place, value) => commands.push_all(self.set(*place, value)),
                Statement::If(condition, then, otherwise) => {
                    let condition = self.compiler.formula(condition);
                    commands.push(Command::If(condition, self.commands(then), self.commands(otherwise)));
                }
            }
        }
        commands
    }

    fn set(&mut self, place: Place, value: &Tree) -> Option<Command> {
        let slot = *self.slots.numbers.get(&place)?;
        Some(Command::Set(slot, self.compiler.formula(value)))
    }
}
