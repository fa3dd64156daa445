//! What a program stores: places, what each is for, and the values in them.

use crate::model::{
    AssociationId, DelayId, EdgeId, Expr as Written, MacroId, OutputId, ParamId, Qualifier, StepId, Ty, VarId,
};

/// An index into [`Program::places`](super::Program::places).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct PlaceId(pub usize);

/// Something that holds a value.
#[derive(Clone)]
pub struct PlaceInfo<'m> {
    pub name: String,
    pub role: Role,
    pub ty: Type<'m>,
    pub initial: Initial<'m>,
    /// It outlives the cycle. What does not begins each cycle with its initial value.
    pub is_field: bool,
}

impl<'m> PlaceInfo<'m> {
    pub(super) fn local(name: String, ty: Type<'m>, initial: Initial<'m>) -> Self {
        Self { name, role: Role::Local, ty, initial, is_field: false }
    }

    /// A local that is false at first.
    pub(super) fn truth(name: String) -> Self {
        Self::local(name, Type::Bool, Initial::Value(Value::Bool(false)))
    }
}

/// What a place is for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// The next cycle is a first one.
    First,
    /// `grafcet`: the last search ended in a stable situation.
    Stable,
    /// The reading of the clock in the last cycle.
    Reading,
    /// The same where a recorder asks for it.
    Recorded,
    /// The next cycle would do the same as the last one, were it not for inputs and time.
    Settled,
    /// The state that the last cycle began with, or what tells that it was in the next one's, or that a time is over.
    Before,
    /// Which step of a region is active.
    State(usize),
    /// Which step of a region is asked for by hand. Whoever asks sets it before the cycle.
    Asked(usize),
    /// The time of the active step of a region.
    Time(usize),
    /// The time of a macro-step.
    MacroTime(MacroId),
    /// The reading of the clock at which the active step of a region was entered, or at which the last period of what blinks began, or one that is so long ago that nobody can tell.
    Began(usize),
    /// The same of a macro-step.
    MacroBegan(MacroId),
    /// A time of the active step of a region is over that is not waited for any more. Beside steps that do not wait so it means nothing.
    Passed(usize),
    /// How far a period is since the activation of the active step of a region. Beside steps that do not blink so it means nothing.
    Phase {
        region: usize,
        /// None where no step of the region blinks in two ways, so that one phase is enough.
        period: Option<u32>,
    },
    /// The same of a macro-step.
    MacroPhase {
        of: MacroId,
        period: u32,
    },
    /// What `rising` and `falling` compare with.
    Edge(EdgeId),
    /// `sfc`: the same, as the actions of the cycle before saw it.
    ActionEdge(EdgeId),
    DelayInput(DelayId),
    DelayHeld(DelayId),
    /// The reading of the clock at which the input of a delay changed; where the output has followed, it means nothing.
    DelayBegan(DelayId),
    /// Of such a delay: 0 where it is false, 1 where it waits to be true, 2 where it is true, 3 where it waits to be false.
    DelayStage(DelayId),
    DelayOutput(DelayId),
    Output(OutputId),
    Var(VarId),
    /// Exchanged from outside, and kept by `init`.
    Param(ParamId),
    /// S, SD, DS, SL of a target, which is named by its first association.
    FlipFlop(AssociationId, Qualifier),
    /// Whether the input of a timer (L, D, SD, DS, SL) was true.
    TimerInput(AssociationId, Qualifier),
    /// How long it has been.
    TimerHeld(AssociationId, Qualifier),
    /// The reading of the clock at which it became true; unless the timer runs, it means nothing.
    TimerBegan(AssociationId, Qualifier),
    /// Of such a timer: 0 where its input is false, 1 where it runs, 2 where it is over.
    TimerStage(AssociationId, Qualifier),
    /// The association whose time the timer takes.
    TimerOf(AssociationId, Qualifier),
    /// The association that set a flip-flop.
    SetBy(AssociationId, Qualifier),
    /// Whether an action was active in the last cycle.
    Active(AssociationId),
    /// How many evolutions of a search have changed something, where a bound stops it.
    Evolutions,
    /// The association that acted last.
    Acted(AssociationId),
    /// Whether an association with N, L or D held its action up in the last cycle.
    Held(AssociationId),
    /// Of one cycle.
    Local,
}

/// What values a place holds.
#[derive(Clone, Copy)]
pub enum Type<'m> {
    Bool,
    Ticks,
    /// One step of a region, or none.
    State(usize),
    /// The number of an association.
    Number,
    /// So many kinds of states, by number; each list of kinds has one of its own.
    Kind {
        list: usize,
        count: i128,
    },
    /// A declared type that is none of these.
    User(&'m Ty),
}

/// What a place begins with.
#[derive(Clone, Copy)]
pub enum Initial<'m> {
    Value(Value),
    /// The constant after `=`.
    Constant(&'m Written),
    /// `Default` of a declared type.
    Default,
}

/// A value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Value {
    Bool(bool),
    /// Of an integer type, a variant's place in its list, or the number of an association.
    Int(i128),
    Ticks(u32),
    /// The state of a region.
    Step(Option<StepId>),
    /// The same while the first cycle is still to come; seen from outside this step is active (A1).
    Start(Option<StepId>),
    Phase(Phase),
    /// Of a type that nothing is known about: a number that only the caller of `run` understands.
    Other(u64),
}

/// Which call of a code action this is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Phase {
    /// The action has become active, or runs once.
    First,
    Repeated,
    /// It is no longer active.
    Final,
}
