//! Expressions of the user, resolved: once as tokens for the generated code, once as a tree for whoever reasons about them.

use super::ids::{DelayId, EdgeId, InputId, MacroId, MemoryId, OutputId, ParamId, StepId, VarId};
use crate::diagnostic::Mark;

/// An expression with its names resolved.
#[derive(Clone)]
pub struct Expr {
    /// What it means.
    pub tree: Tree,
    /// The user's tokens, the forms that are not Rust (`Off.X`, `5s/Heat`, `rising(a)`, `5s`) replaced by
    /// placeholders, which `reads` lists.
    pub tokens: syn::Expr,
    /// Everything the tokens mention, each once, in order of appearance.
    pub reads: Vec<Read>,
    /// As the user wrote it, on one line.
    pub text: String,
    /// All of it in the source.
    pub mark: Mark,
}

/// A Rust block of the user after a qualifier, an event or `=>`.
#[derive(Clone)]
pub struct Code {
    /// The user's tokens with placeholders, as in [`Expr::tokens`].
    pub tokens: syn::Block,
    /// The statements the interpreter understands; `None` where there are others.
    pub statements: Option<Vec<Statement>>,
    /// Everything mentioned.
    pub reads: Vec<Read>,
    /// Variables and outputs it may assign to: a subset of what it mentions.
    pub writes: Vec<Place>,
    /// Those of them that are only handed to something that nobody knows, with what that is: `n.bump(…)`.
    pub unsure: Vec<(Place, String)>,
    /// As the user wrote it, on one line.
    pub text: String,
}

/// A statement of a [`Code`] that is understood.
#[derive(Clone, Debug)]
pub enum Statement {
    /// `count = e;` (`count += e;` is `count = count + e`).
    Assign(Place, Tree),
    /// `if c { … } else { … }`
    If(Tree, Vec<Statement>, Vec<Statement>),
}

/// Something an expression reads, and so needs bound to its placeholder or name.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Read {
    /// A declared name, under that name.
    Name(Name),
    /// `Step.X`
    Active(StepId),
    /// `Step.T`
    Since(StepId),
    /// `M.X` of a macro-step.
    MacroActive(MacroId),
    /// `M.T`
    MacroSince(MacroId),
    /// `rising(e)`
    Rising(EdgeId),
    /// `falling(e)`
    Falling(EdgeId),
    /// `t1/e/t2`
    Delay(DelayId),
    /// A literal time in ticks, e.g. `5s`.
    Ticks(u32),
    /// `5s/Step`, as [`Tree::Elapsed`].
    Elapsed(TimeRef, StepId),
    /// `5s/M`, as [`Tree::MacroElapsed`].
    MacroElapsed(TimeRef, MacroId),
    /// `blink(700ms/300ms)`
    Blink(Blink),
    /// `rising(e)`, `falling(e)` or `t1/e/t2` in a property; what it looks at stands beside it where reads are listed.
    Memory(MemoryId),
}

/// `blink(700ms/300ms, Step)`: as long as the step is active, true for the first part of each period since its activation,
/// false for the second. Neither part is zero, and a period can be counted as a time.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Blink {
    /// The one that is named, or to which the condition belongs.
    pub of: Blinker,
    /// In ticks.
    pub on: u32,
    /// In ticks.
    pub off: u32,
}

/// Since whose activation something blinks.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Blinker {
    Step(StepId),
    Macro(MacroId),
}

impl Read {
    /// The step or macro-step whose activity or time it is.
    #[must_use]
    pub fn about(&self) -> Option<Blinker> {
        match *self {
            Self::Active(step) | Self::Since(step) | Self::Elapsed(_, step) => Some(Blinker::Step(step)),
            Self::MacroActive(id) | Self::MacroSince(id) | Self::MacroElapsed(_, id) => Some(Blinker::Macro(id)),
            Self::Blink(blink) => Some(blink.of),
            Self::Name(_) | Self::Rising(_) | Self::Falling(_) | Self::Delay(_) | Self::Ticks(_) | Self::Memory(_) => {
                None
            }
        }
    }
}

impl Blink {
    /// From one rise to the next.
    #[must_use]
    pub fn period(&self) -> u32 {
        // Resolving refuses a longer one.
        self.on.saturating_add(self.off)
    }
}

impl Blinker {
    /// Its step variable.
    #[must_use]
    pub fn active(self) -> Read {
        match self {
            Self::Step(step) => Read::Active(step),
            Self::Macro(id) => Read::MacroActive(id),
        }
    }

    /// Its time.
    #[must_use]
    pub fn since(self) -> Read {
        match self {
            Self::Step(step) => Read::Since(step),
            Self::Macro(id) => Read::MacroSince(id),
        }
    }
}

/// A declared name that holds a value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Name {
    Input(InputId),
    Output(OutputId),
    Var(VarId),
    Param(ParamId),
}

/// A declared name that can be written.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Place {
    Output(OutputId),
    Var(VarId),
}

impl From<Place> for Name {
    fn from(place: Place) -> Self {
        match place {
            Place::Output(id) => Self::Output(id),
            Place::Var(id) => Self::Var(id),
        }
    }
}

/// The meaning of an expression.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Tree {
    /// `true`
    Bool(bool),
    /// `80`
    Int(i128),
    /// A leaf: a name, a step variable, a time, an edge, a delay; never `Elapsed`, which has a node of its own.
    Read(Read),
    /// `t/Step`: active for at least `t` (`Step.X && Step.T >= t`).
    Elapsed(TimeRef, StepId),
    /// `t/M` for a macro-step.
    MacroElapsed(TimeRef, MacroId),
    /// `!a`, `-a`
    Unary(Unary, Box<Tree>),
    /// `a && b`, `a < b`, `a + b`
    Binary(Binary, Box<Tree>, Box<Tree>),
    /// Rust that is not looked into: equal only to its own text.
    Opaque {
        text: String,
        /// What it mentions.
        reads: Vec<Read>,
        /// Where each evaluation may have another value, as of a function that counts: the number of this one.
        call: Option<u32>,
        /// Its type is one of integers, `bool` or `char`, as of `level.abs()` and `level as u8`.
        whole: bool,
        /// A part of what it reads, such as `sensor.level`, or a pattern of it: it can be anything, as that can.
        open: bool,
        /// What it computes, where that is arithmetic of integers.
        of: Option<Box<Computed>>,
    },
}

/// Arithmetic of integers that Rust has no operator for.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Computed {
    pub how: How,
    /// As many as it takes; of a method what it is called on stands first.
    pub operands: Vec<Tree>,
}

/// How a [`Computed`] follows from its operands.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum How {
    /// `a as u16`, `u16::from(a)`
    As(Integer),
    /// `a.get()` of a time.
    Get,
    /// `a.wrapping_add(b)`; of `+`, `-` and `*`.
    Wrapping(Binary),
    /// `a.saturating_add(b)`; of the same.
    Saturating(Binary),
    Min,
    Max,
    /// `a.clamp(low, high)`
    Clamp,
    Abs,
    UnsignedAbs,
    AbsDiff,
    Signum,
    DivEuclid,
    RemEuclid,
    /// `a.pow(2)`
    Pow,
    /// `if a { b } else { c }`: a condition and two values of any type.
    If,
    /// In a way that nobody knows: `a.ilog2()`.
    Other,
}

/// A type of integers.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Integer {
    pub signed: bool,
    /// Of `usize` and `isize` 64, the most that they have.
    pub bits: u32,
    /// `usize` or `isize`, which have fewer bits on a controller.
    pub is_size: bool,
}

impl Integer {
    /// `u16` of its name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let signed = name.starts_with('i');
        let (bits, is_size) = match name.strip_prefix(['u', 'i'])? {
            "8" => (8, false),
            "16" => (16, false),
            "32" => (32, false),
            "64" => (64, false),
            "128" => (128, false),
            "size" => (64, true),
            _ => return None,
        };
        Some(Self { signed, bits, is_size })
    }

    /// The type of this Rust.
    #[must_use]
    pub fn of(rust: &syn::Type) -> Option<Self> {
        match rust {
            syn::Type::Paren(inner) => Self::of(&inner.elem),
            syn::Type::Group(inner) => Self::of(&inner.elem),
            syn::Type::Path(path) if path.qself.is_none() => Self::named(&path.path.get_ident()?.to_string()),
            _ => None,
        }
    }
}

/// An operator with one operand.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Unary {
    Not,
    Neg,
}

/// An operator with two operands.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Binary {
    /// `&&` (lazy) and `&` on booleans are told apart by their operands' types only: both are here as written.
    And,
    Or,
    BitAnd,
    BitOr,
    BitXor,
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    Shl,
    Shr,
}

impl Binary {
    /// What says the same with the sides exchanged: `a < b` is `b > a`.
    pub(crate) fn mirrored(self) -> Self {
        match self {
            Self::Lt => Self::Gt,
            Self::Le => Self::Ge,
            Self::Gt => Self::Lt,
            Self::Ge => Self::Le,
            other => other,
        }
    }
}

/// A time: a literal in ticks, or a declared name of type `time`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum TimeRef {
    Ticks(u32),
    Param(ParamId),
    Var(VarId),
}

impl TimeRef {
    /// The name, where it is one.
    #[must_use]
    pub fn name(self) -> Option<Name> {
        match self {
            Self::Ticks(_) => None,
            Self::Param(id) => Some(Name::Param(id)),
            Self::Var(id) => Some(Name::Var(id)),
        }
    }
}
