//! What the fields of the state hold, by their places in the program.

use crate::held::Held;
use crate::list::List;
use crate::model::AssociationId;
use crate::program::{Program, Role};

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
        Role::Asked(_) | Role::Reading | Role::Recorded | Role::Param(_) | Role::Local | Role::Evolutions => {
            return None;
        }
        Role::Time(region) | Role::Began(region) => Held::Time(steps(region)),
        Role::MacroTime(id) | Role::MacroBegan(id) => Held::MacroTime(id),
        Role::Phase { .. } => Held::Phase(program.phases.iter().find(|(other, _)| *other == role)?.1.clone()),
        Role::MacroPhase { of, period } => Held::MacroPhase(of, period),
        Role::Edge(id) => Held::Edge(id),
        Role::ActionEdge(id) => Held::ActionEdge(id),
        Role::DelayInput(id) => Held::DelayInput(id),
        Role::DelayHeld(id) | Role::DelayBegan(id) => Held::DelayHeld(id),
        Role::DelayStage(id) => Held::DelayStage(id),
        Role::DelayOutput(id) => Held::DelayOutput(id),
        Role::Output(id) => Held::Output(id),
        Role::Var(id) => Held::Var(id),
        Role::FlipFlop(of, qualifier) => Held::FlipFlop(of, qualifier),
        Role::TimerInput(of, qualifier) => Held::TimerInput(of, qualifier),
        Role::TimerHeld(of, qualifier) | Role::TimerBegan(of, qualifier) => Held::TimerHeld(of, qualifier),
        Role::TimerStage(of, qualifier) => Held::TimerStage(of, qualifier),
        Role::TimerOf(of, qualifier) => Held::TimerOf(of, qualifier, all()),
        Role::SetBy(of, qualifier) => Held::SetBy(of, qualifier, all()),
        Role::Active(of) => Held::Active(of),
        Role::Acted(of) => Held::Acted(of, all()),
        Role::Held(of) => Held::KeptBy(of),
    })
}
