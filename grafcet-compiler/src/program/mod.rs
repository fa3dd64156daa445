//! The cycle of a chart as a program of a small language: places, statements, expressions.
//!
//! [`naive`] makes one from a model, a function for each paragraph of `docs/semantics.md` and without a thought of cost; its text is
//! pseudo-code (`Display`); `run` executes it on values. Both need the feature `program`.
//!
//! ```text
//! was.state = state
//! clears.Off→On = was.state is Off && on
//! …
//! if entered.On: state = On
//! ```

#![allow(missing_docs, reason = "a field says what it holds by its name; a doc is where that is not enough")]

mod build;
mod costs;
mod deadline;
mod lower;
pub mod passes;
mod places;
#[cfg(feature = "program")]
mod print;
mod regions;
#[cfg(feature = "program")]
pub mod run;
mod united;
pub(crate) mod uses;

use crate::analysis::{Facts, Relation};
use crate::model::{ActionId, Code, InputId, Model, Place, Read, StepId, TransitionId, Tree};
use crate::sorted::{Set, sort_unstable};

pub use deadline::{Deadline, Wait};
pub use lower::{Refused, counted, naive};
pub use places::{Initial, Phase, PlaceId, PlaceInfo, Role, Type, Value};
pub use regions::{Region, RegionId, Regions};
pub use united::United;

/// The program from which the macro prints the cycle of a chart; of one that is recorded it keeps the reading of the clock.
///
/// # Errors
/// The chart has not passed the checks.
pub(crate) fn optimised<'m>(
    model: &'m Model,
    facts: &Facts<'_>,
    regions: &Regions,
    recorded: bool,
) -> Result<Program<'m>, Refused> {
    let mut program = lower::in_regions(model, facts, regions)?;
    if let (Some(reading), true) = (program.place(Role::Reading), recorded) {
        program.places[reading.0].role = Role::Recorded;
    }
    passes::optimise(&mut program, &passes::Pass::ALL);
    Ok(program)
}

/// What a chart does in one cycle.
#[derive(Clone)]
pub struct Program<'m> {
    /// Whose names and types it uses.
    pub model: &'m Model,
    /// All that is stored, in a cycle and between two of them. Those that are fields are what `new` writes and a snapshot holds.
    pub places: Vec<PlaceInfo<'m>>,
    /// The groups of steps that share a place, in the order of [`Role::State`].
    pub regions: Vec<Vec<StepId>>,
    /// By region: one of its steps is active before and after each evolution.
    pub full: Vec<bool>,
    /// Which steps may be active together, before and after each evolution; without any step where all share a place.
    pub beside: Relation,
    /// Of two regions at a time, where the search over all of them tells more.
    pub meetings: Vec<Meeting>,
    /// Which regions share a place.
    pub united: Vec<United>,
    pub search: Search,
    /// By [`Role::Phase`]: the steps that blink by it, each with its period. Of others that blink their time tells.
    pub phases: Vec<(Role, Vec<(StepId, u32)>)>,
    pub cycle: Vec<Statement<'m>>,
    /// Of a chart that says `forceable;`: the cycle that leads into a situation by hand (A38).
    pub forced: Option<Vec<Statement<'m>>>,
    /// The plants of a `counted` program, in the order of the model.
    pub plants: Vec<Program<'m>>,
    /// Of a chart that uses time.
    pub deadline: Option<Deadline<'m>>,
}

/// Which states two regions may have together, before and after each evolution.
#[derive(Clone)]
pub struct Meeting {
    pub regions: [usize; 2],
    pub states: Set<[Option<StepId>; 2]>,
}

impl Meeting {
    /// Whether a region may be in this state while another one is in that.
    fn allows(&self, one: (usize, Option<StepId>), other: (usize, Option<StepId>)) -> bool {
        match [one.0, other.0] {
            regions if regions == self.regions => self.states.contains(&[one.1, other.1]),
            [second, first] if [first, second] == self.regions => self.states.contains(&[other.1, one.1]),
            _ => true,
        }
    }
}

/// What is known of the search for stability of a `grafcet` in which one step is active.
#[derive(Clone, Default)]
pub struct Search {
    /// Where nothing but the situation makes it go on: after as many evolutions as the bound says, it has come back to a step and goes on for
    /// ever.
    pub comes_back: bool,
    /// With the activation of one of these it ends.
    pub ends: Set<StepId>,
    /// With the activation of any step that a transition leads to.
    pub is_one_evolution: bool,
    /// Truths of which one at most becomes true in an evolution: that one of the transitions of a step clears.
    pub excluding: Vec<Vec<PlaceId>>,
}

#[derive(Clone)]
pub enum Statement<'m> {
    /// A paragraph.
    Part(&'static str, Vec<Statement<'m>>),
    Set(PlaceId, Expr<'m>),
    If(Expr<'m>, Vec<Statement<'m>>, Vec<Statement<'m>>),
    /// By the value of a place, each value in one arm at most; the last statements are for all other values.
    Match(PlaceId, Vec<Arm<'m>>, Vec<Statement<'m>>),
    Loop {
        /// As many rounds as this are certain to reach a `Break`.
        rounds: u32,
        body: Vec<Statement<'m>>,
    },
    /// Leaves the innermost loop.
    Break,
    Run(Box<Run<'m>>),
    Call(ActionId, Expr<'m>, Vec<Expr<'m>>),
    Mark(Mark),
    Fence(Fence),
}

/// What keeps the optimiser from making more of the code than it has to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fence {
    /// No access to memory is moved across it.
    Memory,
    /// The same on ARMv6-M alone.
    Armv6m,
    /// The same everywhere else.
    BeyondArmv6m,
    /// What has been found out of the inputs in front of it is not known any more: none is read before it is asked for.
    Inputs,
}

/// Some values, and what is done for them.
pub type Arm<'m> = (Vec<Value>, Vec<Statement<'m>>);

/// A block of the user.
#[derive(Clone)]
pub struct Run<'m> {
    pub code: &'m Code,
    /// What each name in it stands for; what it writes stands for itself.
    pub binds: Vec<(Read, Expr<'m>)>,
    pub writes: Vec<Write>,
}

/// What a block may write.
#[derive(Clone, Copy)]
pub struct Write {
    pub name: Place,
    pub to: PlaceId,
    /// Becomes true where it really is written.
    pub noted: Option<PlaceId>,
}

/// What observers are told. Nothing else depends on it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mark {
    Cleared(TransitionId),
    Activated(StepId),
    Deactivated(StepId),
    /// All that one evolution has done is told.
    Evolved,
}

#[derive(Clone)]
pub enum Expr<'m> {
    Value(Value),
    Place(PlaceId),
    /// What a place begins with.
    Initial(PlaceId),
    Input(InputId),
    /// The reading of the clock.
    Now,
    /// Whether the state of a region is one of these.
    Is(PlaceId, Vec<StepId>),
    Not(Box<Expr<'m>>),
    /// In this order, and no further than needed.
    All(Vec<Expr<'m>>),
    Any(Vec<Expr<'m>>),
    Compare(Comparison, Box<Expr<'m>>, Box<Expr<'m>>),
    /// The second where the first holds, else the third.
    Choose(Box<[Expr<'m>; 3]>),
    /// What a table has for the state that a place holds; for one that it does not have, that state.
    Table(PlaceId, Vec<(Value, Value)>),
    /// Of times: a sum or difference that saturates.
    Add(Box<Expr<'m>>, Box<Expr<'m>>),
    Sub(Box<Expr<'m>>, Box<Expr<'m>>),
    /// Of a number: one more.
    Next(PlaceId),
    /// From the second reading of the clock to the first, which may have wrapped.
    Since(Box<Expr<'m>>, Box<Expr<'m>>),
    /// How far a period is (the last) that had come so far (the first) when so much time has passed.
    Period(Box<Expr<'m>>, Box<Expr<'m>>, u32),
    /// Rust of the user.
    User(Box<User<'m>>),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Comparison {
    Equal,
    Differs,
    Less,
    AtLeast,
}

/// An expression of the user: its tokens for a printer of Rust, its tree for whoever has to understand it.
#[derive(Clone)]
pub struct User<'m> {
    pub tokens: &'m syn::Expr,
    pub tree: &'m Tree,
    /// What it reads, and what that is at this moment of the cycle.
    pub binds: Vec<(Read, Expr<'m>)>,
}

impl<'m> Program<'m> {
    /// The cycle, and the one that is forced.
    pub(crate) fn cycles(&self) -> impl Iterator<Item = &Vec<Statement<'m>>> {
        std::iter::once(&self.cycle).chain(&self.forced)
    }

    /// The same, to be changed.
    pub(crate) fn cycles_mut(&mut self) -> impl Iterator<Item = &mut Vec<Statement<'m>>> {
        std::iter::once(&mut self.cycle).chain(&mut self.forced)
    }
}

impl Program<'_> {
    /// The active steps by the values of the places.
    #[must_use]
    pub fn active(&self, values: &[Value]) -> Vec<StepId> {
        let mut active = Vec::new();
        for (place, value) in self.places.iter().zip(values) {
            if let (Role::State(region), Value::Step(Some(state)) | Value::Start(Some(state))) = (place.role, value) {
                active.extend(self.active_in(region, *state));
            }
        }
        sort_unstable(&mut active);
        active
    }

    /// The place with a role.
    #[must_use]
    pub fn place(&self, role: Role) -> Option<PlaceId> {
        self.places.iter().position(|place| place.role == role).map(PlaceId)
    }
}
