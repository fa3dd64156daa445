//! What the fields of the state hold, by their names: of a state that the plan lays out, and of that of a program.

use super::control::set_by;
use super::{Cx, names};
use crate::held::Held;
use crate::list::{List, PushAll};
use crate::model::{ActionId, AssociationId, Effect, Qualifier, StepId};
use crate::plan::{Counted, RegionId, Target, is_stored, source_order};
use crate::program::{Program, Role};

impl Cx<'_> {
    /// The fields of the plan's state, as `fields` lays them out.
    pub(super) fn meanings(&self) -> Vec<(String, Held)> {
        let Self { model, plan, .. } = self;
        let memory = &plan.memory;
        let mut held = Vec::new();
        if plan.shape.is_flags() {
            held.push((
                names::own("situation").to_string(),
                Held::Flags { steps: model.steps.ids().list(), has_start: plan.has_start },
            ));
        }
        for region in 0..plan.regions.all().len() {
            held.push((
                names::region_field(region, plan).to_string(),
                Held::Situation(self.steps_of(region).into_iter().map(|step| vec![step]).list()),
            ));
            held.push((names::step_time(region, plan).to_string(), Held::Time(self.steps_of(region))));
        }
        held.push(("settled".to_owned(), Held::Deadline));
        held.push_all(memory.stored.iter().map(|id| (names::output_field(model, *id).to_string(), Held::Output(*id))));
        held.push_all(memory.last.iter().map(|id| (names::output_last_field(model, *id).to_string(), Held::Last(*id))));
        held.push_all(memory.vars.iter().map(|id| (names::var_field(model, *id).to_string(), Held::Var(*id))));
        held.push_all(memory.edges.iter().map(|(id, ..)| (names::edge_field(*id).to_string(), Held::Edge(*id))));
        let late = memory.late_edges.iter();
        held.push_all(late.map(|(id, ..)| (names::late_edge(*id, None).to_string(), Held::ActionEdge(*id))));
        held.push_all(memory.macro_times.iter().map(|id| (names::macro_time(*id).to_string(), Held::MacroTime(*id))));
        held.push_all(memory.phases.iter().enumerate().map(|(index, phase)| {
            let what = match phase.of {
                Counted::Region(region) => Held::Phase(self.steps_of(region), phase.period),
                Counted::Macro(id) => Held::MacroPhase(id, phase.period),
            };
            (names::phase(index).to_string(), what)
        }));
        held.push_all(model.delays.ids().map(|id| (names::delay_field(id).to_string(), Held::Delay(id))));
        for (index, target) in plan.control.targets.iter().enumerate() {
            self.held_by_target(index, target, &mut held);
        }
        for action in model.actions.ids() {
            held.push((names::called(model, action).to_string(), Held::Called(action)));
            held.push((names::called_number(model, action).to_string(), Held::CalledBy(action, self.callers(action))));
        }
        held
    }

    /// As `continuous_calls_of` lists them.
    fn callers(&self, action: ActionId) -> Vec<AssociationId> {
        let calls = |id: &AssociationId| {
            let association = &self.model.associations[*id];
            !is_stored(association) && matches!(association.effect, Effect::Call(other, _) if other == action)
        };
        source_order(self.model).filter(calls).list()
    }

    fn steps_of(&self, region: RegionId) -> Vec<StepId> {
        self.plan.regions.all()[region].steps.iter().copied().list()
    }

    fn held_by_target(&self, index: usize, target: &Target, held: &mut Vec<(String, Held)>) {
        let Some(first) = target.associations.first().copied() else { return };
        let all = || target.associations.clone();
        let mut note = |prefix: &str, what: Held| {
            held.push((names::target(prefix, self.model, index, target).to_string(), what));
        };
        for qualifier in Qualifier::ALL {
            let flag = names::flag(qualifier);
            note(&format!("memory_{flag}"), Held::FlipFlop(first, qualifier));
            note(&format!("timer_{flag}"), Held::Timer(first, qualifier));
            note(&format!("time_{flag}"), Held::TimerOf(first, qualifier, all()));
            note(&set_by(qualifier), Held::SetBy(first, qualifier, all()));
            note(&format!("kept_{flag}"), Held::Kept(first, qualifier));
        }
        for id in &target.remembers_held {
            note(&names::held(target, *id), Held::KeptBy(*id));
        }
        note("kept_q", Held::Active(first));
        note("association", Held::Acted(first, all()));
    }
}

/// What a place of a program holds; none of what does not outlive a cycle, or is no part of what a chart does.
pub(super) fn of_role(program: &Program<'_>, role: Role) -> Option<Held> {
    let all = || -> Vec<AssociationId> { program.model.associations.ids().list() };
    let steps = |region: usize| program.regions[region].clone();
    Some(match role {
        Role::State(region) => {
            let states = program.states(region).into_iter().map(|state| program.active_in(region, state));
            Held::Situation(states.list())
        }
        Role::First => Held::First,
        Role::Stable | Role::Settled | Role::Before | Role::Passed(_) => Held::Deadline,
        Role::Bit(_)
        | Role::Asked(_)
        | Role::Reading
        | Role::Recorded
        | Role::Param(_)
        | Role::Local
        | Role::Evolutions => return None,
        Role::Time(region) | Role::Began(region) => Held::Time(steps(region)),
        Role::MacroTime(id) | Role::MacroBegan(id) => Held::MacroTime(id),
        Role::Phase { region, period } => Held::Phase(steps(region), period),
        Role::MacroPhase { of, period } => Held::MacroPhase(of, period),
        Role::Edge(id) => Held::Edge(id),
        Role::ActionEdge(id) => Held::ActionEdge(id),
        Role::DelayInput(id) => Held::DelayInput(id),
        Role::DelayHeld(id) => Held::DelayHeld(id),
        Role::DelayOutput(id) => Held::DelayOutput(id),
        Role::Output(id) => Held::Last(id),
        Role::Var(id) => Held::Var(id),
        Role::FlipFlop(of, qualifier) => Held::FlipFlop(of, qualifier),
        Role::TimerInput(of, qualifier) => Held::TimerInput(of, qualifier),
        Role::TimerHeld(of, qualifier) => Held::TimerHeld(of, qualifier),
        Role::TimerOf(of, qualifier) => Held::TimerOf(of, qualifier, all()),
        Role::SetBy(of, qualifier) => Held::SetBy(of, qualifier, all()),
        Role::Active(of) => Held::Active(of),
        Role::Acted(of) => Held::Acted(of, all()),
        Role::Held(of) => Held::KeptBy(of),
    })
}
