//! The table of rules: one row a rule, in the order of the page of rules.

use crate::ast::{Dialect, LevelAttr, Severity};
use crate::list::List;
use crate::similar;

/// A rule of the checker.
#[derive(Debug)]
pub struct Rule {
    /// What `allow(grafcet::…)` takes and what every message ends with.
    pub name: &'static str,
    /// The level in a `grafcet` without any attribute.
    pub default: Severity,
    /// The level in an `sfc` without any attribute.
    pub in_sfc: Severity,
    /// Whether an attribute may lower the level.
    pub can_be_allowed: bool,
}

impl Rule {
    /// The level in a chart of this dialect without any attribute.
    #[must_use]
    pub fn default_in(&self, dialect: Dialect) -> Severity {
        if dialect == Dialect::Sfc { self.in_sfc } else { self.default }
    }

    /// The level in force under these lint attributes, the innermost scope first.
    #[must_use]
    pub(crate) fn severity_in(&self, dialect: Dialect, scopes: &[&[LevelAttr]]) -> Severity {
        let wanted = scopes.iter().flat(|s| s.iter().rev()).find(|l| l.rule == self.name);
        let default = self.default_in(dialect);
        match wanted {
            Some(level) if self.can_be_allowed || level.severity > default => level.severity,
            _ => default,
        }
    }
}

/// Error: no attribute takes it back.
const fn error(name: &'static str) -> Rule {
    Rule { name, default: Severity::Deny, in_sfc: Severity::Deny, can_be_allowed: false }
}

/// Error by default, can be allowed.
const fn deny(name: &'static str) -> Rule {
    Rule { name, default: Severity::Deny, in_sfc: Severity::Deny, can_be_allowed: true }
}

/// Error by default in a `grafcet`, a warning in an `sfc`.
const fn warn_in_sfc(name: &'static str) -> Rule {
    Rule { name, default: Severity::Deny, in_sfc: Severity::Warn, can_be_allowed: true }
}

/// Error by default in an `sfc`, a warning in a `grafcet`.
const fn warn_in_grafcet(name: &'static str) -> Rule {
    Rule { name, default: Severity::Warn, in_sfc: Severity::Deny, can_be_allowed: true }
}

/// Says nothing unless the chart asks for it.
const fn allow(name: &'static str) -> Rule {
    Rule { name, default: Severity::Allow, in_sfc: Severity::Allow, can_be_allowed: true }
}

/// Warning by default.
const fn warn(name: &'static str) -> Rule {
    Rule { name, default: Severity::Warn, in_sfc: Severity::Warn, can_be_allowed: true }
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
    UNREACHABLE_STEP = deny("unreachable_step");
    DEAD_TRANSITION = deny("dead_transition");
    UNSAFE_STEP = warn_in_grafcet("unsafe_step");
    STUCK_JOIN = deny("stuck_join");
    DEADLOCK = deny("deadlock");
    NOT_HOME = error("not_home");
    CLEARING_ACTION = error("clearing_action");
    WRONG_TARGET = error("wrong_target");
    BAD_TIME = error("bad_time");
    NEVER_TRUE = deny("never_true");
    ALWAYS_TRUE = deny("always_true");
    SHADOWED_BRANCH = deny("shadowed_branch");
    OVERLAPPING_BRANCHES = warn("overlapping_branches");
    UNSTABLE = error("unstable");
    POSSIBLE_INSTABILITY = allow("possible_instability");
    LEVEL_SOURCE_TRANSITION = deny("level_source_transition");
    READS_CONTINUOUS = error("reads_continuous");
    COMBINATIONAL_CIRCLE = error("combinational_circle");
    EDGE_IN_ASSIGNATION = error("edge_in_assignation");
    EVENT_WITHOUT_EDGE = error("event_without_edge");
    MIXED_MODES = error("mixed_modes");
    CONFLICTING_VALUES = deny("conflicting_values");
    WRITE_RACE = warn_in_sfc("write_race");
    SET_WITHOUT_RESET = warn("set_without_reset");
    RESET_WITHOUT_SET = warn("reset_without_set");
    TIMED_CONTENTION = deny("timed_contention");
    UNUSED_INPUT = warn("unused_input");
    UNDRIVEN_OUTPUT = warn("undriven_output");
    UNUSED_VARIABLE = warn("unused_variable");
    UNUSED_ACTION = warn("unused_action");
    UNUSED_PARAM = warn("unused_param");
    UNUSED_LET = warn("unused_let");
    FORCING_CIRCLE = error("forcing_circle");
    TWO_MASTERS = error("two_masters");
    FORCED_STEP_OUTSIDE = error("forced_step_outside");
    INIT_WITHOUT_INITIAL = error("init_without_initial");
    FORCED_ENCLOSURE = error("forced_enclosure");
    ENCLOSURE_WITHOUT_LINK = error("enclosure_without_link");
    INITIAL_WITHOUT_EFFECT = warn("initial_without_effect");
    MACRO_ENTRY_EXIT = error("macro_entry_exit");
    PROPERTY_VIOLATED = error("property_violated");
    PROPERTY_UNDECIDED = deny("property_undecided");
    VACUOUS_PROPERTY = warn("vacuous_property");
    VACUOUS_ASSUMPTION = warn("vacuous_assumption");
}

/// Why an attribute cannot set `rule` to `level`; `None` if it can.
#[must_use]
pub(crate) fn refuse_level(rule: &str, level: Severity) -> Option<String> {
    if let Some(known) = ALL.iter().find(|known| known.name == rule) {
        let lowered = !known.can_be_allowed && level < known.default;
        return lowered
            .then(|| format!("the rule `{rule}` cannot be switched off or lowered; mend the chart, and remove this"));
    }
    let nearest = ALL.iter().map(|rule| rule.name).map(|name| (similar::distance(rule, name), name)).min();
    Some(match nearest {
        Some((distance, name)) if distance <= name.len() / 3 => {
            format!("no rule is called `{rule}`; did you mean `grafcet::{name}`?")
        }
        _ => format!("no rule is called `{rule}`; the page of rules lists them"),
    })
}
