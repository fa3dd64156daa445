//! Names in an expression: what they stand for, `Off.X` and `Off.T`.

use proc_macro2::Ident;
use syn::Member;

use super::expr::{Lower, Seen, looks_like_a_variable, single_name, step_path, without_field};
use super::habits;
use super::scope::Meaning;
use crate::diagnostic::rules;
use crate::model::{Name, Read, Tree};

impl Lower<'_, '_> {
    pub(super) fn path(&mut self, expr: &mut syn::Expr) -> Tree {
        let Some(name) = single_name(expr) else { return self.opaque(expr) };
        if name == "true" || name == "false" {
            return Tree::Bool(name == "true");
        }
        match self.resolver.scope.get(&name) {
            _ if self.locals.contains(&name) => Tree::Opaque {
                text: name.to_string(),
                reads: Vec::new(),
                call: None,
                whole: false,
                open: false,
                of: None,
            },
            Some(Meaning::Let(id)) => self.put_in_place(expr, &name, id),
            Some(Meaning::Value(value)) if self.resolver.is_later(&name, value) => Tree::Bool(true),
            Some(Meaning::Value(value)) => {
                self.note(Read::Name(value));
                self.places.push(Seen { read: Read::Name(value), mark: (&name).into(), within: None });
                self.resolver.model.mentions.push((value.into(), name.span()));
                self.join(expr, value);
                Tree::Read(Read::Name(value))
            }
            Some(Meaning::Step(_) | Meaning::Macro(_)) => {
                self.resolver.sink.notation(&name, without_field(&name.to_string()));
                Tree::Bool(true)
            }
            Some(Meaning::Action(_)) => {
                let message = format!("`{name}` is an action; it can stand after a qualifier, not in an expression");
                self.resolver.sink.notation(&name, message);
                Tree::Bool(true)
            }
            None if habits::name(&name, self.resolver).is_some() => {
                let message = habits::name(&name, self.resolver).unwrap_or_default();
                self.resolver.sink.notation(&name, message);
                Tree::Bool(true)
            }
            _ if !looks_like_a_variable(&name) && !self.resolver.scope.is_misspelt(&name) => Tree::Opaque {
                text: name.to_string(),
                reads: Vec::new(),
                call: None,
                whole: false,
                open: false,
                of: None,
            },
            _ => {
                self.resolver.scope.unknown_name(&name, &format!("input {name}: bool;"), self.resolver.sink);
                Tree::Bool(true)
            }
        }
    }

    /// A chart's names are the same whichever macro they come from: a use of one becomes what Rust takes for the
    /// declared name.
    fn join(&self, expr: &mut syn::Expr, value: Name) {
        let declared = self.resolver.model.value_name(value).span();
        let syn::Expr::Path(path) = expr else { return };
        for segment in &mut path.path.segments {
            segment.ident.set_span(segment.ident.span().resolved_at(declared));
        }
    }

    /// `Off.X`, `Off.T`, `Production::Feed.X`; any other field is Rust.
    pub(super) fn field(&mut self, expr: &mut syn::Expr) -> Tree {
        let syn::Expr::Field(field) = &*expr else { return self.opaque(expr) };
        let member = match &field.member {
            Member::Named(name) if is_of_step(name) => name.clone(),
            _ => return self.opaque(expr),
        };
        let Some(step) = step_path(&field.base) else { return self.opaque(expr) };
        if matches!(&step[..], [name] if self.locals.contains(name)) {
            return self.opaque(expr);
        }
        if member == "late" {
            return self.late(expr, &step);
        }
        let Some(meaning) = self.step(&step) else {
            return if member == "X" { Tree::Bool(true) } else { Tree::Int(0) };
        };
        let read = match (meaning, member == "X") {
            (Meaning::Step(id), true) => Read::Active(id),
            (Meaning::Step(id), false) => Read::Since(id),
            (Meaning::Macro(id), true) => Read::MacroActive(id),
            (Meaning::Macro(id), false) => Read::MacroSince(id),
            (Meaning::Value(value), _) if self.resolver.is_plain(value) => {
                let (name, kind) = (&step[0], meaning.kind());
                let message = format!("`{name}` is {kind}, not a step; only a step has `.{member}`");
                self.resolver.sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), message)]);
                return Tree::Bool(true);
            }
            _ => return self.opaque(expr),
        };
        self.replace(expr, read)
    }

    /// `Fill.late` is `10s/Fill`, where that is the time of `Fill`. A constant of Rust may have such a field.
    fn late(&mut self, expr: &mut syn::Expr, path: &[Ident]) -> Tree {
        let is_constant = |name: &Ident| !name.to_string().contains(char::is_lowercase);
        let may_be = |name: &&Ident| {
            self.resolver.scope.get(name).is_some() || !looks_like_a_variable(name) && !is_constant(name)
        };
        let Some(name) = path.last().filter(may_be) else { return self.opaque(expr) };
        let message = match self.step(path) {
            Some(Meaning::Step(id)) => match self.resolver.model.steps[id].late {
                Some(late) => return self.replace(expr, late),
                None => format!(
                    "nothing says how long `{name}` may take; write it at the step, `step {name} within 10s`, or `10s/{name}` here"
                ),
            },
            Some(Meaning::Macro(_)) => format!("`{name}` is a macro-step, which is never late; write `10s/{name}`"),
            Some(Meaning::Value(value)) if self.resolver.is_plain(value) => {
                format!("`{name}` is no step; only a step that has a time, `step Fill within 10s`, can be late")
            }
            None => return Tree::Bool(true),
            Some(_) => return self.opaque(expr),
        };
        self.resolver.sink.notation(name, message);
        Tree::Bool(true)
    }

    /// The step a path names; `None` is reported. A declared value with a field `X` is Rust.
    pub(super) fn step(&mut self, path: &[Ident]) -> Option<Meaning> {
        let name = path.last()?;
        self.resolver.mention(name);
        if let [partial, _] = path {
            let partial = self.resolver.find_partial(partial)?;
            let found = self.resolver.scope.step(name, self.resolver.sink)?;
            if let Meaning::Step(step) = found {
                self.resolver.step_of_partial(name, step, partial);
            }
            return Some(found);
        }
        match self.resolver.scope.get(name) {
            Some(value @ Meaning::Value(_)) => Some(value),
            _ => self.resolver.scope.step(name, self.resolver.sink),
        }
    }
}

/// What stands after the `.` of a step.
pub(super) fn is_of_step(name: &Ident) -> bool {
    name == "X" || name == "T" || name == "late"
}
