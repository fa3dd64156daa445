//! What the user wrote: spanned, in source order, names not yet resolved.
//!
//! The parser accepts more than the rules allow (`A -> B`, a clearing action in an SFC), so that a
//! rule can name the mistake at its tokens instead of "unexpected token".

#![allow(missing_docs, reason = "a field says what it holds by its name; a doc is where that is not enough")]

use proc_macro2::{Span, TokenStream};
use syn::{Attribute, Block, Expr, Ident, LitInt, Path, Type, Visibility};

use crate::mark::Mark;
pub use crate::qualifier::Qualifier;

/// `pub sfc Motor { … }`
pub struct Chart {
    pub attrs: Attrs,
    pub vis: Visibility,
    pub dialect: Dialect,
    /// Where that is said.
    pub keyword: Span,
    /// `Motor`
    pub name: Ident,
    pub body: Body,
    /// Something in the chart could not be parsed and is absent: what the rest seems to lack may be there.
    pub incomplete: bool,
    /// It is a plant of a call, written as a chart.
    pub is_plant: bool,
    /// The names of the plants after it.
    pub plants: Vec<String>,
}

/// By whose rules a chart evolves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dialect {
    /// IEC 61131-3, sequential function chart.
    Sfc,
    /// IEC 60848, GRAFCET.
    Grafcet,
}

/// The attributes of an item, by where they go.
#[derive(Default, Clone)]
pub struct Attrs {
    /// Doc comments and lint attributes of rustc and clippy: they reach the generated item.
    pub passed_on: Vec<Attribute>,
    /// `#[allow(grafcet::unreachable_step)]`, one entry a rule: consumed by the macro.
    pub levels: Vec<LevelAttr>,
    /// In front of the chart alone: what its types derive beside their own.
    pub derives: Vec<Derive>,
}

/// `#[derive(Hash)]`, `#[cfg_attr(feature = "log", derive(defmt::Format))]`
#[derive(Clone)]
pub struct Derive {
    /// `feature = "log"`
    pub when: Option<TokenStream>,
    pub traits: Vec<Path>,
    pub mark: Mark,
}

/// Whether a derive is this trait of a crate: `Serialize`, `serde::Serialize`; but no other crate's.
pub(crate) fn is_of(path: &Path, module: &str, name: &str) -> bool {
    let mut names = path.segments.iter().map(|segment| &segment.ident);
    let (first, last) = (names.next(), names.next_back());
    last.or(first).is_some_and(|last| last == name) && (last.is_none() || first.is_some_and(|first| first == module))
}

/// How loud a broken rule is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, PartialOrd, Ord)]
pub enum Severity {
    /// Not shown.
    Allow,
    /// A compiler warning at the user's tokens.
    Warn,
    /// A compile error.
    Deny,
}

/// `allow(grafcet::unreachable_step)`
#[derive(Clone)]
pub struct LevelAttr {
    pub severity: Severity,
    /// `unreachable_step`
    pub rule: Ident,
}

/// The items between the braces of a chart, a partial grafcet or a macro-step, in source order.
#[derive(Default)]
pub struct Body {
    /// `#![allow(grafcet::unreachable_step)]`
    pub levels: Vec<LevelAttr>,
    pub items: Vec<Item>,
    /// Names that items which could not be parsed would have declared, as far as they can be guessed.
    pub broken: Vec<Ident>,
    /// Every name in items that could not be parsed: a step among them is not on its own.
    pub lost: Vec<Ident>,
    /// One of these items may have been a step.
    pub lost_step: bool,
    /// How many steps lack their name.
    pub nameless_steps: usize,
}

/// One item of a body.
pub enum Item {
    Decl(Decl),
    Let(Let),
    Action(ActionDecl),
    Setting(Setting),
    Property(Property),
    Step(Step),
    Chain(Chain),
    Partial(Partial),
}

/// `output speed: u16 = 0;` One entry for all the names of a line.
pub struct Decl {
    pub attrs: Attrs,
    pub kind: DeclKind,
    /// `on, off`
    pub names: Vec<Ident>,
    pub ty: Ty,
    /// After the type: `in {Off, Auto}`.
    pub variants: Option<Variants>,
    /// There, too: `in 1s..10s`.
    pub range: Option<Range>,
    /// What stands after `=`.
    pub init: Option<Expr>,
}

/// `in {Off, Auto, Manual}`
pub struct Variants {
    /// `in`
    pub keyword: Span,
    pub list: Vec<Variant>,
}

/// `1s..10s`, `1..=8`
#[derive(Clone)]
pub struct Range {
    pub low: Bound,
    pub high: Bound,
    /// `..=`: the upper end is in it.
    pub closed: bool,
    pub mark: Mark,
}

/// An end of a range.
#[derive(Clone)]
pub struct Bound {
    pub limit: Limit,
    /// As it is written.
    pub text: String,
    pub mark: Mark,
}

/// What an end of a range is.
#[derive(Clone)]
pub enum Limit {
    Int(i128),
    Time(Time),
}

/// A variant of an enum.
#[derive(Clone)]
pub struct Variant {
    pub name: Ident,
    /// `Auto(..)`
    pub has_data: bool,
}

/// `let go = auto || rising(next);`
pub struct Let {
    pub attrs: Attrs,
    pub name: Ident,
    pub value: Expr,
}

/// The keyword of a declaration.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DeclKind {
    Input,
    Output,
    Var,
    Param,
}

/// A declared type.
#[derive(Clone)]
pub enum Ty {
    /// The keyword `time`.
    Time(Span),
    /// Any Rust type.
    Rust(Type),
}

/// `action heat(setpoint: i16);`
pub struct ActionDecl {
    pub attrs: Attrs,
    pub name: Ident,
    pub params: Vec<(Ident, Ty)>,
}

/// A statement about the chart as a whole.
pub enum Setting {
    /// `clock 1ms;`
    Clock { keyword: Span, unit: Time },
    /// `max_evolutions 20;`
    MaxEvolutions { keyword: Span, count: LitInt },
    /// `budget 100_000;`
    Budget { keyword: Span, count: LitInt },
    /// `assume never b1 && b3;`
    AssumeNever { keyword: Span, condition: Expr },
    /// `assume cycle within 100ms;`
    AssumeCycle { keyword: Span, longest: Time },
    /// `assume often door_closed;`
    AssumeOften { keyword: Span, condition: Expr },
    /// `assume valve leads_to full within 10s;` `assume lower before bottom;`
    AssumeOrder { keyword: Span, order: Property },
    /// `assume pure level_ok, sensors::valid;`
    AssumePure { keyword: Span, paths: Vec<Path> },
    /// `forceable;`
    Forceable { keyword: Span },
    /// `modes;`, which also stands in a partial grafcet.
    Modes { keyword: Span },
    /// `optimize size;`
    OptimizeSize { keyword: Span },
    /// `encoding flags;`
    EncodingFlags { keyword: Span },
}

/// Something the checker shall prove.
pub enum Property {
    /// `never Up.X && Down.X;`
    Never { attrs: Attrs, keyword: Span, condition: Expr },
    /// `always relay => !over_temp || On.X;` (`premise` is `relay`), `always !a || b;`
    Always { attrs: Attrs, keyword: Span, premise: Option<Expr>, condition: Expr },
    /// `home (A, B);`
    Home { attrs: Attrs, keyword: Span, steps: Vec<Ident> },
    /// `start leads_to Done within 30s;`
    LeadsTo { attrs: Attrs, keyword: Span, from: Expr, to: Expr, within: Option<Time> },
    /// `Clamp before Drill;`
    Before { attrs: Attrs, keyword: Span, first: Expr, then: Expr },
}

/// A duration as it stands in the source.
#[derive(Clone)]
pub struct Time {
    pub span: Span,
    /// Nanoseconds; the chart's clock decides later whether that can be counted.
    pub nanos: u64,
}

/// `initial step Off { N red; }`
pub struct Step {
    pub attrs: Attrs,
    /// `initial`, where it stands.
    pub initial: Option<Span>,
    /// `final`
    pub is_final: Option<Span>,
    /// `linked`: carries the activation link of its enclosure.
    pub linked: Option<Span>,
    /// `entry` of a macro-step's expansion.
    pub entry: Option<Span>,
    /// `exit` of a macro-step's expansion.
    pub exit: Option<Span>,
    pub name: Ident,
    pub within: Option<Within>,
    pub kind: StepKind,
}

/// `within 10s`: how long a step may be active before it is late.
#[derive(Clone)]
pub struct Within {
    pub keyword: Span,
    /// None where it could not be read, as has been said.
    pub time: Option<TimeArg>,
}

/// What is between the braces of a step.
pub enum StepKind {
    Plain(StepBody),
    /// `macro step M { … }` with the keyword's place.
    Macro(Span, Body),
    /// `enclosing step E { partial … }`; associations are allowed too.
    Enclosing(Span, StepBody, Vec<Partial>),
}

/// The associations and forcing orders of a step, in source order.
#[derive(Default)]
pub struct StepBody {
    pub associations: Vec<Association>,
    pub forces: Vec<Force>,
}

/// `L 5s heat(80) if ready;`
pub struct Association {
    /// The whole line without its `;`.
    pub mark: Mark,
    /// `L`; none is N.
    pub qualifier: Option<(Qualifier, Span)>,
    /// `5s`
    pub time: Option<TimeArg>,
    /// `rising(a)` of `on rising(a) count = count + 1`.
    pub event: Option<Expr>,
    pub target: Target,
    /// `ready`
    pub condition: Option<Expr>,
}

/// The time of a qualifier or after `within`.
#[derive(Clone)]
pub enum TimeArg {
    Literal(Time),
    /// A `param` or `var` of type `time`.
    Name(Ident),
}

/// What can stand after a qualifier.
pub enum Target {
    /// `relay`
    Name(Ident),
    /// `count = count + 1`
    Assign { name: Ident, value: Expr },
    /// `heat(80)`
    Call { name: Ident, args: Vec<Expr> },
    /// `{ count += 1; }`
    Block(Block),
}

/// `force Production {S1, S2};`
pub struct Force {
    pub mark: Mark,
    pub partial: Ident,
    pub order: ForceOrder,
}

/// The four forms of a forcing order.
pub enum ForceOrder {
    /// `{S1, S2}`
    Steps(Vec<Ident>),
    /// `{*}`: hold the current situation.
    Hold,
    /// `{}`
    Empty,
    /// `{INIT}`
    Init,
}

/// `partial Safety { … }`
pub struct Partial {
    pub attrs: Attrs,
    pub name: Ident,
    pub body: Body,
}

/// `A -[x]-> B -[y]-> (C, D);` Without arrows where those beside `first` could not be parsed.
pub struct Chain {
    pub attrs: Attrs,
    pub first: Node,
    pub rest: Vec<(Arrow, Node)>,
}

/// `any except (A, B)`
pub struct Any {
    /// All of it.
    pub mark: Mark,
    pub except: Vec<Ident>,
}

/// What an arrow touches.
pub enum Node {
    /// All steps of the net, at the begin of a chain.
    Any(Any),
    /// One step.
    Step(Ident),
    /// `(B, C)`; empty for a source or sink. The mark covers the parentheses.
    Group(Vec<Ident>, Mark),
    /// Nothing stands between two arrows: `A -[x]-[y]-> B`.
    Missing(Mark),
    /// Nothing stands at the end of an arrow: `A -[x]->;`. The mark is the arrow.
    Forgotten(Mark),
}

/// What stands between two nodes.
pub enum Arrow {
    /// `->` without a transition.
    Bare(Mark),
    /// `-[go: x && y => n = 0]->`
    Transition(Transition),
}

/// `-[go: x && y => n = 0]->`
pub struct Transition {
    /// From `-[` to `]->`.
    pub mark: Mark,
    /// `go`
    pub name: Option<Ident>,
    pub condition: Condition,
    /// After `=>`.
    pub clearing: Vec<Clearing>,
}

/// When a transition clears.
pub enum Condition {
    /// `x && y`
    Holds(Expr),
    /// `else`: where none of the other branches of the same steps does.
    Else(Span),
    /// It could not be read, as has been said.
    Broken,
}

/// `n = 0`, an action on clearing.
pub struct Clearing {
    pub mark: Mark,
    pub target: Target,
}
