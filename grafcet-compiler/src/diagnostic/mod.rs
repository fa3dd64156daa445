//! Where mistakes go: the sink, the table of rules, and how both look to the user.

mod emit;
pub mod rules;

use proc_macro2::TokenStream;

pub use rules::Rule;

pub use crate::ast::Severity;
use crate::ast::{Dialect, LevelAttr};
pub use crate::mark::Mark;
use crate::sorted::{Set, sort_by_key};

/// One mistake: a message for each participant, the culprit first.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// None is a mistake of notation.
    pub rule: Option<&'static Rule>,
    /// The level in force where the mistake is.
    pub severity: Severity,
    /// Each participant and what is said there.
    pub notes: Vec<(Mark, String)>,
}

impl Diagnostic {
    /// Whether it is about what the chart claims of itself, and not about what it does.
    #[must_use]
    pub fn is_about_a_claim(&self) -> bool {
        let claims = [
            &rules::PROPERTY_VIOLATED,
            &rules::PROPERTY_UNDECIDED,
            &rules::NOT_HOME,
            &rules::VACUOUS_PROPERTY,
            &rules::VACUOUS_ASSUMPTION,
        ]
        .map(|rule| rule.name);
        self.rule.is_some_and(|rule| claims.contains(&rule.name))
    }
}

/// Collects the mistakes of one chart.
///
/// A sink that is dropped without [`Sink::finish`] loses errors, so tests panic on it.
#[derive(Default)]
pub struct Sink {
    diagnostics: Vec<Diagnostic>,
    read: bool,
}

impl Sink {
    /// An empty sink.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A mistake of notation: it carries no rule name and nothing can allow it.
    pub fn notation(&mut self, mark: impl Into<Mark>, message: impl Into<String>) {
        self.diagnostics.push(Diagnostic {
            rule: None,
            severity: Severity::Deny,
            notes: vec![(mark.into(), message.into())],
        });
    }

    /// Changes what has been said so far.
    pub(crate) fn reword(&mut self, change: &dyn Fn(&str) -> String) {
        for (_, message) in self.diagnostics.iter_mut().flat_map(|one| &mut one.notes) {
            *message = change(message);
        }
    }

    /// Takes over an error of `syn`, all its messages.
    pub fn syn(&mut self, error: &syn::Error) {
        for part in error {
            self.notation(part.span(), part.to_string());
        }
    }

    /// A chart breaks `rule`, which has one level in both dialects; `scopes` are the lint attributes that can change it, the
    /// innermost first.
    pub fn rule(&mut self, rule: &'static Rule, scopes: &[&[LevelAttr]], notes: Vec<(Mark, String)>) {
        debug_assert_eq!(rule.default, rule.in_sfc, "`{}` has two levels", rule.name);
        self.rule_in(Dialect::Grafcet, rule, scopes, notes);
    }

    /// A chart of `dialect` breaks `rule`.
    pub(crate) fn rule_in(
        &mut self,
        dialect: Dialect,
        rule: &'static Rule,
        scopes: &[&[LevelAttr]],
        notes: Vec<(Mark, String)>,
    ) {
        self.broken(rule, rule.severity_in(dialect, scopes), notes);
    }

    /// A chart breaks `rule`, whose level there is `severity`. An error marks all who take part, a warning the culprit: rustc would
    /// count each mark as a warning of its own.
    pub(crate) fn broken(&mut self, rule: &'static Rule, severity: Severity, mut notes: Vec<(Mark, String)>) {
        debug_assert!(!notes.is_empty(), "`{}` is said nowhere", rule.name);
        if severity == Severity::Warn {
            notes.truncate(1);
        }
        if severity != Severity::Allow {
            self.diagnostics.push(Diagnostic { rule: Some(rule), severity, notes });
        }
    }

    /// Whether anything collected so far stops the compilation.
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Deny)
    }

    /// How many errors were collected so far.
    pub(crate) fn errors(&self) -> usize {
        self.diagnostics.iter().filter(|one| one.severity == Severity::Deny).count()
    }

    /// Whether something was said that breaks the rule.
    #[must_use]
    pub(crate) fn broke(&self, rule: &Rule) -> bool {
        self.diagnostics.iter().any(|one| one.rule.is_some_and(|broken| broken.name == rule.name))
    }

    /// Whether an error tells that something of the chart never happens.
    pub(crate) fn has_dead_ends(&self) -> bool {
        let dead = [
            &rules::UNREACHABLE_STEP,
            &rules::DEAD_TRANSITION,
            &rules::NEVER_TRUE,
            &rules::SHADOWED_BRANCH,
            &rules::STUCK_JOIN,
        ];
        let is_one = |one: &Diagnostic| one.rule.is_some_and(|rule| dead.iter().any(|other| other.name == rule.name));
        self.diagnostics.iter().any(|one| one.severity == Severity::Deny && is_one(one))
    }

    /// Whether nothing so far stands in the way of looking at how the chart evolves: what is wrong with an action or with what a
    /// condition reads leaves the rest as it is drawn.
    #[must_use]
    pub(crate) fn leaves_evolution(&self) -> bool {
        let aside = [
            &rules::MIXED_MODES,
            &rules::WRONG_TARGET,
            &rules::READS_CONTINUOUS,
            &rules::EDGE_IN_ASSIGNATION,
            &rules::EVENT_WITHOUT_EDGE,
        ];
        let is_aside =
            |one: &Diagnostic| one.rule.is_some_and(|rule| aside.iter().any(|other| other.name == rule.name));
        self.diagnostics.iter().all(|one| one.severity != Severity::Deny || is_aside(one))
    }

    /// Whether one of the errors so far is about more than what the chart claims of itself: about what it does there is code,
    /// in which rustc may find more.
    #[must_use]
    pub(crate) fn has_more_than_claims(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Deny && !d.is_about_a_claim())
    }

    /// How much was collected so far.
    pub(crate) fn count(&self) -> usize {
        self.diagnostics.len()
    }

    /// What was collected, in source order.
    #[must_use]
    pub fn finish(mut self) -> Vec<Diagnostic> {
        self.read = true;
        let mut all = std::mem::take(&mut self.diagnostics);
        // A stable sort: where a toolchain gives no positions, the order of the passes stays.
        sort_by_key(&mut all, |d| d.notes.first().map(|(mark, _)| mark.position()));
        // Nothing is said twice at one place: a block is read as tokens and as statements, and of three steps with one
        // name the first takes part in two mistakes.
        let mut said = Set::new();
        for diagnostic in &mut all {
            diagnostic.notes.retain(|(mark, message)| said.insert((mark.key(), message.clone())));
        }
        all.retain(|diagnostic| !diagnostic.notes.is_empty());
        all
    }
}

impl Drop for Sink {
    fn drop(&mut self) {
        debug_assert!(
            self.read || self.diagnostics.is_empty() || std::thread::panicking(),
            "diagnostics were collected and never shown"
        );
    }
}

/// The tokens that make rustc show the diagnostics at their marks.
#[must_use]
pub fn tokens(diagnostics: &[Diagnostic], root: &TokenStream) -> TokenStream {
    emit::tokens(diagnostics, root)
}
