//! What the fields of a chart's state hold, for whoever reads a recorded state without the compiled chart.

use crate::model::{AssociationId, DelayId, EdgeId, MacroId, OutputId, Qualifier, StepId, VarId};

/// What a field holds. A target of the action control (A31) is named by its first association.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Held {
    /// Which of these steps are active together, by state: after them there may be a state for none of them, and one for "the first cycle is still to come".
    Situation(Vec<Vec<StepId>>),
    /// A bit for each of these steps, and where it has one for the start, another that says that the first cycle is still to come.
    Flags {
        /// In the order of the bits.
        steps: Vec<StepId>,
        /// Whether there is that other bit.
        has_start: bool,
    },
    /// Whether the first cycle is still to come.
    First,
    /// Something that only `next_deadline` asks for.
    Deadline,
    /// What an output was in the last cycle.
    Output(OutputId),
    /// A variable.
    Var(VarId),
    /// What `rising` and `falling` compare with.
    Edge(EdgeId),
    /// `sfc`: the same, as actions saw it.
    ActionEdge(EdgeId),
    /// How long the active one of these steps has been active, as far as anybody asks: of one that blinks but for whole periods that make no difference.
    Time(Vec<StepId>),
    /// The same of a macro-step.
    MacroTime(MacroId),
    /// How long the active one of these steps, which blink so, has been active, but for whole periods.
    Phase(Vec<(StepId, u32)>),
    /// The same of a macro-step.
    MacroPhase(MacroId, u32),
    /// What a delay has seen in the last cycle.
    DelayInput(DelayId),
    /// How long that has been so.
    DelayHeld(DelayId),
    /// 0 where a delay is false, 1 where it waits to be true, 2 where it is true, 3 where it waits to be false; how long it has been so counts where it waits.
    DelayStage(DelayId),
    /// What a delay says.
    DelayOutput(DelayId),
    /// S, SD, DS, SL.
    FlipFlop(AssociationId, Qualifier),
    /// Whether the input of a timer was true in the last cycle.
    TimerInput(AssociationId, Qualifier),
    /// How long it has been.
    TimerHeld(AssociationId, Qualifier),
    /// 0 where it was false, 1 where it was true, 2 where it has been so for as long as the timer takes: how long does not count then.
    TimerStage(AssociationId, Qualifier),
    /// The association whose time the timer takes, by its place among these.
    TimerOf(AssociationId, Qualifier, Vec<AssociationId>),
    /// The association that set a flip-flop last, by its place among these.
    SetBy(AssociationId, Qualifier, Vec<AssociationId>),
    /// Whether a target was active in the last cycle.
    Active(AssociationId),
    /// Whether an association with N, L or D held it up.
    KeptBy(AssociationId),
    /// The association that acted last, by its place among these.
    Acted(AssociationId, Vec<AssociationId>),
}
