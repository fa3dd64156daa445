//! A chart as it stands in a file, whatever its notation: nothing is looked up or translated yet.

use std::ops::Range;

use super::expr::Kind;
use super::types::Enum;

/// Bytes of the file.
pub(super) type Span = Range<usize>;

/// A program, a function block or a function.
#[derive(Clone, Default, Debug)]
pub(super) struct Pou {
    pub(super) name: String,
    pub(super) at: Span,
    /// What is said in front of it, line by line.
    pub(super) notes: Vec<String>,
    /// Of a function.
    pub(super) returns: Option<String>,
    pub(super) variables: Vec<Variable>,
    pub(super) steps: Vec<Step>,
    pub(super) transitions: Vec<Transition>,
    pub(super) actions: Vec<Action>,
    /// What it has instead of steps.
    pub(super) body: String,
    /// What stands there and has no place in a chart: what it is.
    pub(super) lost: Vec<(Span, String)>,
    /// All of the file.
    pub(super) enums: Vec<Enum>,
}

impl Pou {
    /// What a value of a type is.
    pub(super) fn kind(&self, ty: &str) -> Option<Kind> {
        Kind::of(ty).or_else(|| self.enums.iter().position(|one| same(&one.name, ty)).map(Kind::Enum))
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Section {
    Input,
    Output,
    Local,
    InOut,
    External,
}

#[derive(Clone, Debug)]
pub(super) struct Variable {
    pub(super) name: String,
    pub(super) at: Span,
    pub(super) section: Section,
    pub(super) constant: bool,
    pub(super) ty: String,
    pub(super) init: Option<Piece>,
    /// `%IX0.0`
    pub(super) address: Option<String>,
    pub(super) note: String,
}

/// A piece of structured text, or of another language.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub(super) struct Piece {
    pub(super) text: String,
    pub(super) at: Span,
    /// None is structured text.
    pub(super) language: Option<String>,
}

#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) name: String,
    pub(super) at: Span,
    pub(super) initial: bool,
    pub(super) note: String,
    /// The longest time that it may take.
    pub(super) within: Option<Piece>,
    pub(super) blocks: Vec<Block>,
}

/// What belongs to a step.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) at: Span,
    pub(super) qualifier: String,
    pub(super) time: Option<String>,
    pub(super) what: What,
}

#[derive(Clone, Debug)]
pub(super) enum What {
    /// An action, or a boolean variable.
    Named(String),
    /// A body of its own.
    Inline(Piece),
}

#[derive(Clone, Debug)]
pub(super) struct Transition {
    pub(super) name: Option<String>,
    pub(super) at: Span,
    pub(super) note: String,
    pub(super) priority: Option<u64>,
    pub(super) from: Vec<String>,
    pub(super) to: Vec<String>,
    pub(super) condition: Piece,
}

#[derive(Clone, Debug)]
pub(super) struct Action {
    pub(super) name: String,
    pub(super) note: String,
    pub(super) body: Piece,
}

/// Whether both are one name, which the language does not tell apart by capitals.
pub(super) fn same(one: &str, other: &str) -> bool {
    one.eq_ignore_ascii_case(other)
}
