//! The names of a chart: what is declared, what is meant, what was nearly meant.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use crate::diagnostic::{Mark, Sink, rules};
use crate::model::{ActionId, MacroId, Name, PartialId, StepId};

/// What a name in an expression or behind a qualifier means.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Meaning {
    Value(Name),
    Action(ActionId),
    Step(StepId),
    Macro(MacroId),
}

/// The declared names. Steps and values share one name space: `Off.X` must mean one thing.
#[derive(Default)]
pub(super) struct Scope {
    names: BTreeMap<String, (Meaning, Ident)>,
    partials: BTreeMap<String, (PartialId, Ident)>,
    transitions: BTreeMap<String, Ident>,
    /// Names that a broken item would have declared: no error about them, its own error says enough.
    broken: Vec<String>,
}

/// Qualifiers and words of the notation that would make it ambiguous.
const RESERVED: &[&str] = &[
    "N", "S", "R", "L", "D", "P", "P1", "P0", "SD", "DS", "SL", "INIT", "X", "T", "rising", "falling", "self", "Self",
    "super", "crate", "_",
];

impl Scope {
    /// Takes note of the names of items that could not be parsed.
    pub(super) fn add_broken(&mut self, names: impl IntoIterator<Item = String>) {
        self.broken.extend(names);
    }

    /// Declares `name`; a reserved or second one is reported and not declared (`false`).
    pub(super) fn declare(&mut self, name: &Ident, meaning: Meaning, sink: &mut Sink) -> bool {
        if !free_to_use(name, sink) {
            return false;
        }
        let first = self.names.get(&name.to_string()).map(|(_, first)| first);
        if let Some(first) = first {
            report_duplicate(name, first, sink);
            return false;
        }
        self.names.insert(name.to_string(), (meaning, name.clone()));
        true
    }

    /// Declares a partial grafcet.
    pub(super) fn declare_partial(&mut self, name: &Ident, id: PartialId, sink: &mut Sink) -> bool {
        if let Some((_, first)) = self.partials.get(&name.to_string()) {
            report_duplicate(name, first, sink);
            return false;
        }
        self.partials.insert(name.to_string(), (id, name.clone()));
        free_to_use(name, sink)
    }

    /// Declares a named transition.
    pub(super) fn declare_transition(&mut self, name: &Ident, sink: &mut Sink) -> bool {
        if let Some(first) = self.transitions.get(&name.to_string()) {
            report_duplicate(name, first, sink);
            return false;
        }
        self.transitions.insert(name.to_string(), name.clone());
        true
    }

    /// What `name` means, if it is declared.
    pub(super) fn get(&self, name: &Ident) -> Option<Meaning> {
        self.names.get(&name.to_string()).map(|(meaning, _)| *meaning)
    }

    /// The partial grafcet `name`; an unknown one is reported.
    pub(super) fn partial(&self, name: &Ident, sink: &mut Sink) -> Option<PartialId> {
        if let Some((id, _)) = self.partials.get(&name.to_string()) {
            return Some(*id);
        }
        if !self.is_broken(name) {
            let hint = nearest(&name.to_string(), self.partials.keys())
                .unwrap_or_else(|| format!("declare it: `partial {name} {{ … }}`"));
            sink.rule(
                &rules::UNKNOWN_PARTIAL,
                &[],
                vec![(name.into(), format!("no partial grafcet is called `{name}`; {hint}"))],
            );
        }
        None
    }

    /// The step or macro-step `name`; anything else is reported.
    pub(super) fn step(&self, name: &Ident, sink: &mut Sink) -> Option<Meaning> {
        match self.get(name) {
            Some(meaning @ (Meaning::Step(_) | Meaning::Macro(_))) => Some(meaning),
            Some(Meaning::Value(_) | Meaning::Action(_)) => {
                sink.rule(&rules::UNKNOWN_STEP, &[], vec![(
                    name.into(),
                    format!("`{name}` is not a step; a transition leads from steps to steps: declare `step` under another name"),
                )]);
                None
            }
            None => {
                self.unknown_step(name, sink);
                None
            }
        }
    }

    /// Reports a step that is not declared.
    pub(super) fn unknown_step(&self, name: &Ident, sink: &mut Sink) {
        if self.is_broken(name) {
            return;
        }
        let hint = self.suggest(name, |m| matches!(m, Meaning::Step(_) | Meaning::Macro(_)));
        let hint = hint.unwrap_or_else(|| format!("declare it: `step {name};`"));
        let message = format!("no step is called `{name}`; {hint}");
        sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), message)]);
    }

    /// Reports a name in an expression or behind a qualifier that is not declared.
    pub(super) fn unknown_name(&self, name: &Ident, wanted: &str, sink: &mut Sink) {
        if self.is_broken(name) {
            return;
        }
        let hint = self
            .suggest(name, |m| matches!(m, Meaning::Value(_) | Meaning::Action(_)))
            .unwrap_or_else(|| format!("declare it: `{wanted}`"));
        let message = format!("no name `{name}` is declared; {hint}");
        sink.rule(&rules::UNKNOWN_NAME, &[], vec![(name.into(), message)]);
    }

    fn is_broken(&self, name: &Ident) -> bool {
        self.broken.iter().any(|b| name == b)
    }

    fn suggest(&self, name: &Ident, fits: impl Fn(Meaning) -> bool) -> Option<String> {
        let candidates = self.names.iter().filter(|(_, (m, _))| fits(*m)).map(|(n, _)| n);
        nearest(&name.to_string(), candidates)
    }
}

/// "did you mean `Off`?", where something is near enough.
fn nearest<'a>(name: &str, candidates: impl Iterator<Item = &'a String>) -> Option<String> {
    let lower = name.to_lowercase();
    candidates
        .map(|c| (strsim::osa_distance(&lower, &c.to_lowercase()), c))
        .min()
        .filter(|(distance, c)| *distance <= 1.max(c.chars().count() / 3))
        .map(|(_, c)| format!("did you mean `{c}`?"))
}

fn free_to_use(name: &Ident, sink: &mut Sink) -> bool {
    let free = !RESERVED.iter().any(|word| name == word);
    if !free {
        let message = format!("`{name}` is reserved by the notation; choose another name");
        sink.rule(&rules::RESERVED_NAME, &[], vec![(name.into(), message)]);
    }
    free
}

fn report_duplicate(second: &Ident, first: &Ident, sink: &mut Sink) {
    let notes: Vec<(Mark, String)> = vec![
        (first.into(), format!("`{first}` is declared here first, and again further down; rename one of them")),
        (second.into(), format!("`{second}` is declared here a second time; rename one of them")),
    ];
    sink.rule(&rules::DUPLICATE_NAME, &[], notes);
}
