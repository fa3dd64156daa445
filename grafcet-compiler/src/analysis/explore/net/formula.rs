//! Conditions over numbered atoms.

use super::slots::SlotId;
use crate::analysis::is_constant_read;
use crate::model::{EdgeId, MacroId, StepId, Tree, ids};

ids! {
    /// Something that conditions read.
    pub(crate) AtomId;
    /// A formula that stands in several others.
    pub(crate) SharedId;
}

/// A condition.
#[derive(Debug)]
pub(crate) enum Formula {
    Const(bool),
    /// A boolean atom.
    Is(AtomId),
    /// A number is below a constant.
    Below(AtomId, i128),
    /// A number is a constant.
    Equals(AtomId, i128),
    Not(Box<Formula>),
    And(Box<Formula>, Box<Formula>),
    Or(Box<Formula>, Box<Formula>),
    Same(Box<Formula>, Box<Formula>),
    Rising(EdgeId),
    Falling(EdgeId),
    /// Such as a combinational variable (A22).
    Shared(SharedId),
}

impl Formula {
    pub(crate) fn negate(self) -> Self {
        match self {
            Self::Const(value) => Self::Const(!value),
            Self::Not(inner) => *inner,
            other => Self::Not(Box::new(other)),
        }
    }

    pub(crate) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Const(true), other) | (other, Self::Const(true)) => other,
            (Self::Const(false), _) | (_, Self::Const(false)) => Self::Const(false),
            (a, b) => Self::And(Box::new(a), Box::new(b)),
        }
    }

    pub(crate) fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Const(false), other) | (other, Self::Const(false)) => other,
            (Self::Const(true), _) | (_, Self::Const(true)) => Self::Const(true),
            (a, b) => Self::Or(Box::new(a), Box::new(b)),
        }
    }

    pub(crate) fn same(self, other: Self) -> Self {
        Self::Same(Box::new(self), Box::new(other))
    }
}

/// Something that conditions read.
#[derive(Debug)]
pub(crate) struct Atom {
    pub(crate) kind: Kind,
    /// As the user wrote it.
    pub(crate) what: Tree,
    /// Written by actions that are not followed, so that it may change within a cycle.
    pub(crate) volatile: bool,
    /// Whether the time of an action has come.
    pub(crate) is_time: bool,
}

impl Atom {
    /// Whether its value at each moment of a cycle follows from what was chosen at the begin and from what has happened since.
    pub(crate) fn is_exact(&self) -> bool {
        match self.kind {
            Kind::Step(_) | Kind::Was(_) | Kind::Macro(_) | Kind::Slot(_) | Kind::Since(_) | Kind::Phase(_) => true,
            Kind::MacroSince(_) => false,
            Kind::Free | Kind::Number(..) => {
                let mut stands_still = !self.what.may_differ();
                self.what.each_read(&mut |read| stands_still &= is_constant_read(&read));
                stands_still
            }
        }
    }
}

/// How the value of an atom is found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    /// Any boolean value, once per cycle.
    Free,
    /// Any number of a range, once per cycle.
    Number(i128, i128),
    /// Whether the step is active.
    Step(StepId),
    /// `sfc`: whether the step was active when the cycle began.
    Was(StepId),
    /// Whether a step of the macro-step's expansion is active.
    Macro(MacroId),
    /// A boolean that is followed from cycle to cycle.
    Slot(SlotId),
    /// How long the step has been active; zero if it is not.
    Since(StepId),
    /// The same of a macro-step.
    MacroSince(MacroId),
    /// Whether the first part of a period since the activation of the step is under way: true when it is entered.
    Phase(StepId),
}
