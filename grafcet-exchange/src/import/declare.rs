//! What a chart declares: inputs, params, outputs and variables.

use std::collections::{BTreeMap, BTreeSet};

use super::Wrong;
use super::expr::{Kind, Scope};
use super::facts::Facts;
use super::parser::{Expr, expression};
use super::rust::{WIDTH, docs};
use super::source::{Pou, Section, Variable};

/// What a variable is in a chart.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Role {
    Input,
    Param,
    Output,
    Var,
}

impl Role {
    fn word(self) -> &'static str {
        match self {
            Self::Input => "input",
            Self::Param => "param",
            Self::Output => "output",
            Self::Var => "var",
        }
    }
}

/// What it is, by where it stands and who writes it.
fn role(variable: &Variable, written: &BTreeSet<String>) -> Role {
    let written = written.contains(&variable.name.to_lowercase());
    let address = variable.address.as_deref().unwrap_or_default().to_uppercase();
    match variable.section {
        _ if variable.constant => Role::Param,
        Section::Input if variable.init.is_some() => Role::Param,
        Section::Output => Role::Output,
        Section::InOut | Section::External if written => Role::Output,
        Section::Local if address.starts_with("%Q") => Role::Output,
        Section::Local if written => Role::Var,
        // It keeps its value, unless somebody outside changes it.
        Section::Local if variable.init.is_some() && address.is_empty() => Role::Param,
        _ => Role::Input,
    }
}

/// The declarations, by what they are; neighbours of one type on one line.
pub(super) fn declared(
    pou: &Pou,
    facts: &Facts,
    (written, scope): (&BTreeSet<String>, &mut Scope<'_>),
    notes: &mut Vec<Wrong>,
) -> Vec<String> {
    let mut all = Vec::new();
    let mut seen = BTreeSet::new();
    for variable in &pou.variables {
        let key = variable.name.to_lowercase();
        if facts.memory.contains_key(&key) || facts.instances.contains_key(&key) || !seen.insert(key) {
            continue;
        }
        let Some(kind) = scope.kinds.get(&variable.name.to_lowercase()).copied() else { continue };
        let role = role(variable, written);
        let outside = !variable.constant && variable.section == Section::Local && variable.address.is_none();
        if outside && matches!(role, Role::Input | Role::Param) {
            let what = if role == Role::Input { "an input" } else { "a param" };
            let message = format!("nothing that is translated writes `{}`: it is {what}", variable.name);
            notes.push(Wrong { at: variable.at.clone(), message });
        }
        let shared = match variable.section {
            Section::InOut => Some("an in-out variable"),
            Section::External => Some("a global variable"),
            _ => None,
        };
        if let (Some(what), Role::Output) = (shared, role) {
            let message = format!(
                "`{}`, {what}, is an output: what others write to it is not seen; what the chart has to know of that is an input",
                variable.name
            );
            notes.push(Wrong { at: variable.at.clone(), message });
        }
        let value = initial(variable, kind, scope, notes);
        // What keeps its value: the compiler wants to know the first one.
        let first = match kind {
            Kind::Enum(of) if matches!(role, Role::Output | Role::Var) => Some(scope.first(of)),
            _ => None,
        };
        let value = value.or(first).filter(|value| {
            let nothing = matches!(&**value, "false" | "0" | "0s" | "0.0");
            role != Role::Input && (role == Role::Param || !nothing)
        });
        all.push((role, kind, value, variable));
    }
    all.sort_by_key(|(role, ..)| *role);
    let mut lines: Vec<String> = Vec::new();
    let mut open: Option<(Role, Kind)> = None;
    for (role, kind, value, variable) in all {
        let name = scope.names.get(&variable.name).unwrap_or_default().to_owned();
        let note = note(variable);
        match (&value, lines.last_mut()) {
            (None, Some(last)) if open == Some((role, kind)) && note.is_empty() && last.len() < WIDTH - name.len() => {
                let at = last.rfind(':').unwrap_or(last.len());
                last.insert_str(at, &format!(", {name}"));
            }
            _ => {
                docs(&mut lines, &note, "        ///");
                let init = value.as_ref().map(|value| format!(" = {value}")).unwrap_or_default();
                lines.push(format!("        {} {name}: {}{init};", role.word(), typed(scope, role, kind)));
            }
        }
        open = (value.is_none() && note.is_empty()).then_some((role, kind));
    }
    lines
}

/// The type; the checker is told the variants of an enum.
fn typed(scope: &mut Scope<'_>, role: Role, kind: Kind) -> String {
    let name = scope.type_of(kind);
    let Kind::Enum(of) = kind else { return name };
    scope.used.insert(of);
    if role == Role::Output {
        return name;
    }
    let variants: Vec<&str> = scope.enums[of].values.iter().map(|(_, rust, _)| &**rust).collect();
    format!("{name} in {{{}}}", variants.join(", "))
}

/// Variables whose type a chart does not have: instances of function blocks that are no code actions.
pub(super) fn left_out(
    pou: &Pou,
    facts: &Facts,
    scope: &Scope<'_>,
    code: &BTreeMap<String, (Vec<String>, String)>,
) -> Vec<Wrong> {
    let known = |variable: &&Variable| {
        let is_code = scope.names.get(&variable.name).is_some_and(|name| code.contains_key(name));
        let key = variable.name.to_lowercase();
        let known =
            scope.kinds.contains_key(&key) || facts.memory.contains_key(&key) || scope.counters.contains_key(&key);
        known || is_code || facts.instances.contains_key(&key) || facts.written_out.contains(&key)
    };
    let others = pou.variables.iter().filter(|variable| !known(variable));
    let one = |variable: &Variable| {
        let message = format!(
            "`{}` of type {} is left out: a chart has `bool`, `time`, numbers and enums",
            variable.name, variable.ty
        );
        Wrong { at: variable.at.clone(), message }
    };
    others.map(one).collect()
}

/// What is said of a variable, and where it is wired.
fn note(variable: &Variable) -> Vec<String> {
    // What `cargo grafcet export` says of every parameter.
    let said = variable.note.strip_prefix("parameter").map_or(&*variable.note, |rest| rest.trim_start_matches(':'));
    let wired = variable.address.as_ref().map(|address| format!("At {address}."));
    [said.trim().to_owned()].into_iter().chain(wired).filter(|line| !line.is_empty()).collect()
}

fn initial(variable: &Variable, kind: Kind, scope: &mut Scope<'_>, notes: &mut Vec<Wrong>) -> Option<String> {
    let text = variable.init.as_ref()?;
    let value = expression(text).map_err(|wrong| wrong.message).and_then(|value| match value {
        Expr::Bool(_) | Expr::Int(_) | Expr::Real(_) | Expr::Time(_) | Expr::Minus(_) => scope.rust(&value, Some(kind)),
        Expr::Name(_) | Expr::Member(..) | Expr::Typed(..) if matches!(kind, Kind::Enum(_)) => {
            scope.rust(&value, Some(kind))
        }
        _ => Err("it is no literal".to_owned()),
    });
    value
        .map_err(|why| {
            let message = format!("the initial value of `{}` is left out: {why}", variable.name);
            notes.push(Wrong { at: text.at.clone(), message });
        })
        .ok()
}
