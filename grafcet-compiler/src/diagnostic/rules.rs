//! The table of rules: one row a rule, in the order of the page of rules.

use crate::ast::LevelAttr;

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

/// A rule of the checker.
#[derive(Debug)]
pub struct Rule {
    /// What `allow(grafcet::…)` takes and what every message ends with.
    pub name: &'static str,
    /// The level without any attribute.
    pub default: Severity,
    /// Whether an attribute may lower the level.
    pub can_be_allowed: bool,
}

impl Rule {
    /// The level in force under these lint attributes, the innermost scope first.
    #[must_use]
    pub fn severity_in(&self, scopes: &[&[LevelAttr]]) -> Severity {
        let wanted = scopes.iter().flat_map(|s| s.iter().rev()).find(|l| l.rule == self.name);
        match wanted {
            Some(level) if self.can_be_allowed || level.severity > self.default => level.severity,
            _ => self.default,
        }
    }
}

/// Error: no attribute takes it back.
const fn error(name: &'static str) -> Rule {
    Rule { name, default: Severity::Deny, can_be_allowed: false }
}

/// Error by default, can be allowed.
const fn deny(name: &'static str) -> Rule {
    Rule { name, default: Severity::Deny, can_be_allowed: true }
}

macro_rules! rules {
    ($($constant:ident = $level:ident($name:literal);)*) => {
        $(#[doc = concat!("`", $name, "`")] pub static $constant: Rule = $level($name);)*
        /// Every rule the checker knows.
        pub static ALL: &[&Rule] = &[$(&$constant),*];
    };
}

rules! {
    STEPS_WITHOUT_TRANSITION = error("steps_without_transition");
    TRANSITIONS_WITHOUT_STEP = error("transitions_without_step");
    NO_INITIAL_STEP = error("no_initial_step");
    SEVERAL_INITIAL_STEPS = deny("several_initial_steps");
    UNKNOWN_STEP = error("unknown_step");
    UNKNOWN_NAME = error("unknown_name");
    UNKNOWN_PARTIAL = error("unknown_partial");
    DUPLICATE_NAME = error("duplicate_name");
    RESERVED_NAME = error("reserved_name");
    DUPLICATE_TRANSITION = error("duplicate_transition");
    REPEATED_STEP = error("repeated_step");
    ISOLATED_STEP = error("isolated_step");
    SOURCE_TRANSITION = error("source_transition");
    SINK_TRANSITION = error("sink_transition");
    CLEARING_ACTION = error("clearing_action");
    WRONG_TARGET = error("wrong_target");
    BAD_TIME = error("bad_time");
    FORCED_STEP_OUTSIDE = error("forced_step_outside");
    MACRO_ENTRY_EXIT = error("macro_entry_exit");
}
