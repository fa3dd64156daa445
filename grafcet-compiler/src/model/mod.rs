//! The resolved chart: arenas in the order of declaration, names replaced by ids, macro-steps expanded.
//!
//! A model is only built from a chart whose names are all known; it may still break rules.

#![allow(missing_docs, reason = "a field says what it holds by its name; a doc is where that is not enough")]

mod begins;
mod declared;
mod endless;
mod expr;
mod ids;
pub(crate) mod operands;
mod orders;
pub mod placeholder;
mod plants;
mod queries;
mod resolve;
mod text;
mod tree;

use proc_macro2::Span;
use syn::{Attribute, Ident, Visibility};

pub use crate::ast::{Derive, Dialect, LevelAttr, Variant};
use crate::diagnostic::Mark;
pub use crate::qualifier::{Qualifier, Trigger};
pub use declared::{Action, Input, Let, Output, Param, Range, Ty, Var, Variants};
pub use expr::{
    Binary, Blink, Blinker, Code, Computed, Expr, How, Integer, Name, Place, Read, Statement, TimeRef, Tree, Unary,
};
pub(crate) use ids::ids;
pub use ids::{
    ActionId, AnyId, Arena, AssociationId, DelayId, EdgeId, ForceId, Id, InputId, LetId, MacroId, MemoryId, OutputId,
    ParamId, PartialId, StepId, TransitionId, VarId,
};
pub use plants::{Driven, Plant, Plants, Seen, Watched, Wire};
pub use resolve::resolve;

/// A whole chart.
pub struct Model {
    pub dialect: Dialect,
    pub name: Ident,
    pub vis: Visibility,
    /// Doc comments and lint attributes for the generated struct.
    pub attrs: Vec<Attribute>,
    /// What the user wants the chart's types to derive.
    pub derives: Vec<Derive>,
    /// Lint attributes of the chart as a whole.
    pub levels: Vec<LevelAttr>,
    /// It is a plant of a call, written as a chart.
    pub is_plant: bool,
    /// The unit of the time argument of `cycle`, in nanoseconds.
    pub clock_nanos: u64,
    /// Something of the source could not be resolved, and an error says so.
    pub incomplete: bool,
    /// `max_evolutions 20;`
    pub max_evolutions: Option<u32>,
    /// `optimize size;`: of two ways to generate code, the smaller one is meant.
    pub optimize_size: bool,
    /// `encoding flags;`: a bit for each step, whatever can be active together.
    pub flags: bool,
    /// `forceable;`: the program may put the chart into a situation by hand.
    pub forceable: bool,
    /// `modes;`: by which inputs transitions are held back.
    pub modes: Option<Modes>,
    pub inputs: Arena<InputId, Input>,
    pub outputs: Arena<OutputId, Output>,
    pub vars: Arena<VarId, Var>,
    pub params: Arena<ParamId, Param>,
    /// The values of enums whose variants are listed.
    pub variants: Vec<Variants>,
    pub lets: Arena<LetId, Let>,
    pub actions: Arena<ActionId, Action>,
    pub partials: Arena<PartialId, Partial>,
    pub steps: Arena<StepId, Step>,
    pub macros: Arena<MacroId, MacroStep>,
    pub transitions: Arena<TransitionId, Transition>,
    /// By step, the transitions that leave it, in source order.
    pub leaving: Vec<Vec<TransitionId>>,
    /// By step, the transitions that lead to it.
    pub entering: Vec<Vec<TransitionId>>,
    /// In source order.
    pub anys: Arena<AnyId, Any>,
    pub associations: Arena<AssociationId, Association>,
    pub forces: Arena<ForceId, Force>,
    pub edges: Arena<EdgeId, Edge>,
    pub delays: Arena<DelayId, Delay>,
    /// `budget 100_000;`: how many situations the checker may explore.
    pub budget: Option<u64>,
    /// What the plant excludes and what ranges of params leave out, in source order.
    pub assumptions: Vec<Assumption>,
    /// `assume often door_closed;`: what comes again and again, in source order.
    pub often: Vec<Expr>,
    /// `assume valve leads_to full within 10s;`: what happens one after the other outside of the chart, in source order.
    pub orders: Vec<Order>,
    /// `assume cycle within 100ms;`: the longest time between two cycles, in ticks.
    pub longest_cycle: Option<u32>,
    /// What the checker shall prove, in source order.
    pub properties: Vec<Property>,
    /// What properties remember of the ends of cycles, each after those that it reads. A program stores nothing of it.
    pub memories: Arena<MemoryId, Memory>,
    /// What stands beside it in a proof.
    pub plants: Plants,
    /// Where names stand that generated code does not repeat there.
    pub mentions: Vec<(Mention, Span)>,
}

/// The inputs that `modes;` declares (A39).
#[derive(Clone, Copy, Debug)]
pub struct Modes {
    pub semi_automatic: InputId,
    pub manual: InputId,
    pub paused: InputId,
    /// That the push button goes down.
    pub pushed: EdgeId,
}

/// What is mentioned.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mention {
    /// In chains, forced situations and step variables.
    Step(StepId),
    /// There, too.
    Macro(MacroId),
    /// In forcing orders and in front of the steps of another one.
    Partial(PartialId),
    /// Where an expression reads it.
    Input(InputId),
    /// There, too.
    Param(ParamId),
    /// There, too, and where an action drives it.
    Output(OutputId),
    /// There, too.
    Var(VarId),
    /// Where it is called.
    Action(ActionId),
    /// Where it is used.
    Let(LetId),
}

impl From<Name> for Mention {
    fn from(name: Name) -> Self {
        match name {
            Name::Input(id) => Self::Input(id),
            Name::Output(id) => Self::Output(id),
            Name::Var(id) => Self::Var(id),
            Name::Param(id) => Self::Param(id),
        }
    }
}

/// `assume never b1 && b3;`, or the range of a param.
pub struct Assumption {
    /// A condition over inputs and params under which the chart is never scanned.
    pub never: Expr,
    /// The whole line without its `;`.
    pub mark: Mark,
    /// The param whose range it is: the generated code sees to that itself.
    pub of_range: Option<ParamId>,
}

/// `assume valve leads_to full within 10s;` What is not so of what has happened up to the end of a cycle does not happen.
pub struct Order {
    /// That something leads to something else, or comes before it. What comes after is a condition over inputs.
    pub claim: Claim,
    /// The whole line without its `;`.
    pub mark: Mark,
}

/// Something about the ends of cycles that the checker shall prove.
pub struct Property {
    pub claim: Claim,
    pub levels: Vec<LevelAttr>,
    /// The whole line without its `;`.
    pub mark: Mark,
}

/// What a property says.
pub enum Claim {
    /// `never Up.X && Down.X;`
    Never(Expr),
    /// `always relay => On.X;`, `always !a || b;`
    Always { premise: Option<Expr>, condition: Expr },
    /// `home (A, B);`, with the tokens that name the situation.
    Home(Vec<StepId>, Mark),
    /// `start leads_to Done within 30s;`: with ticks of the clock, where there is a limit.
    LeadsTo { from: Expr, to: Expr, within: Option<u32> },
    /// `Clamp before Drill;`
    Before { first: Expr, then: Expr },
}

/// A partial grafcet: a set of steps that evolves by itself.
pub struct Partial {
    /// `None` for what stands directly in the chart.
    pub name: Option<Ident>,
    /// The enclosing step, for an enclosure.
    pub enclosed_by: Option<StepId>,
    /// The first paragraph of its doc comment.
    pub doc: String,
    pub levels: Vec<LevelAttr>,
    /// Its steps in the order of declaration, those of macro-steps' expansions included, those of enclosures inside not.
    pub steps: Vec<StepId>,
    pub transitions: Vec<TransitionId>,
    /// The orders that force it, in source order.
    pub forced_by: Vec<ForceId>,
}

/// A step.
pub struct Step {
    pub name: Ident,
    pub attrs: Vec<Attribute>,
    pub levels: Vec<LevelAttr>,
    pub partial: PartialId,
    pub initial: bool,
    pub is_final: bool,
    /// Carries the activation link of its enclosure.
    pub linked: bool,
    /// The macro-step whose expansion it belongs to (the innermost).
    pub macro_step: Option<MacroId>,
    /// The enclosures of this step, if it is an enclosing step.
    pub encloses: Vec<PartialId>,
    /// `within 10s`: what says that this is over, a [`Read::Elapsed`] of the step itself.
    pub late: Option<Read>,
    /// A chain of the source touches it, also one that could not be resolved.
    pub drawn: bool,
    /// In source order.
    pub associations: Vec<AssociationId>,
    pub forces: Vec<ForceId>,
}

/// A macro-step. Its expansion's steps and transitions stand in the partial grafcet around it; transitions to it
/// lead to `entry`, those from it start at `exit`.
pub struct MacroStep {
    pub name: Ident,
    /// The macro-step in whose expansion it stands.
    pub outer: Option<MacroId>,
    /// The first paragraph of its doc comment.
    pub doc: String,
    pub entry: StepId,
    pub exit: StepId,
    /// All steps of the expansion, those of macro-steps inside included.
    pub steps: Vec<StepId>,
}

/// A transition.
pub struct Transition {
    /// `go` of `-[go: x]->`
    pub name: Option<Ident>,
    pub levels: Vec<LevelAttr>,
    pub partial: PartialId,
    /// Each step once, in source order; empty for a source transition.
    pub sources: Vec<StepId>,
    /// Each step once; empty for a sink transition.
    pub targets: Vec<StepId>,
    pub condition: Expr,
    /// `else`: the other branches of the same steps, in source order. None of their conditions holds where this one, which
    /// is made of them, does.
    pub otherwise: Option<Vec<TransitionId>>,
    /// `modes;` may hold it back: what is written as its condition, of which `condition` is made.
    pub held: Option<Tree>,
    /// `grafcet`: what is done when it clears, in source order.
    pub clearing: Vec<Effect>,
    /// From `-[` to `]->`.
    pub mark: Mark,
    /// It is one of those for which an `any` stands.
    pub any: Option<AnyId>,
    /// What comes before it where it would otherwise clear along: `condition` holds only where these do not clear.
    pub guards: Vec<AnyId>,
}

/// `any -[stop]-> Stopped;` It stands for a transition from each of its sources to its targets, which all clear together. These
/// transitions stand before all others of their partial grafcet.
pub struct Any {
    pub partial: PartialId,
    /// The transition from its first source, which stands for it where it is shown.
    pub first: TransitionId,
    /// In order of declaration; not the targets, and not what is excepted: these stay as they are.
    pub sources: Vec<StepId>,
    /// After `except`, as written.
    pub except: Vec<Ident>,
}

/// A step's association with an action.
pub struct Association {
    pub step: StepId,
    pub qualifier: Qualifier,
    /// The time of L, D, SD, DS, SL.
    pub time: Option<TimeRef>,
    /// The event of `on`.
    pub event: Option<Expr>,
    /// After `if`.
    pub condition: Option<Expr>,
    pub effect: Effect,
    /// The whole line without its `;`.
    pub mark: Mark,
    /// The qualifier, where one is written.
    pub qualifier_mark: Option<Mark>,
    /// The name after the qualifier, or the block.
    pub target_mark: Mark,
}

/// What an action does.
#[derive(Clone)]
pub enum Effect {
    /// A boolean output or variable that is controlled: `N relay`, `S lamp`.
    Control(Place),
    /// `speed = e`. After N on an output: a continuous assignation; elsewhere a stored one.
    Assign(Place, Expr),
    /// `heat(80)`
    Call(ActionId, Vec<Expr>),
    /// `{ count += 1; }`
    Block(Code),
}

/// A forcing order of a step.
pub struct Force {
    pub step: StepId,
    pub target: PartialId,
    pub order: ForceOrder,
    pub mark: Mark,
}

/// To which situation a partial grafcet is forced.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ForceOrder {
    /// `{S1, S2}`; empty for `{}`.
    Steps(Vec<StepId>),
    /// `{*}`
    Hold,
    /// `{INIT}`
    Init,
}

/// An edge or a delay in a property: where one of the chart looks at the moments of evolutions, this looks at the ends of cycles.
pub struct Memory {
    pub kind: Remembers,
    /// What it looks at.
    pub of: Expr,
}

/// What a [`Memory`] is true for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Remembers {
    /// `rising(e)`: at this end and not at the one before; never at the end of the first cycle (A26).
    Rise,
    /// `falling(e)`
    Fall,
    /// `t1/e/t2`: from the end where `e` has held for the first time to that where it has not held for the second (A36).
    Delay(TimeRef, TimeRef),
}

/// An expression whose value of the evolution before is remembered for `rising` and `falling`.
pub struct Edge {
    pub of: Expr,
}

/// `t1/e/t2`: true once `of` has been true for `on`, false once it has been false for `off`.
pub struct Delay {
    pub on: TimeRef,
    pub of: Expr,
    pub off: TimeRef,
}
