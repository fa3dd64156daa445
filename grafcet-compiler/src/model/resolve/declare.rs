//! The first pass: every name of the chart, in source order.

use proc_macro2::Ident;
use syn::Type;

use super::scope::Meaning;
use super::{Resolver, expr};
use crate::ast::{self, DeclKind, Item, StepKind};
use crate::diagnostic::{Mark, rules};
use crate::model::{
    Action, Expr, Id, Input, MacroId, MacroStep, Name, Output, Param, Partial, PartialId, Read, Step, StepId, Ty, Var,
};

impl Resolver<'_> {
    /// The statements that the meaning of others depends on.
    pub(super) fn read_settings(&mut self, body: &ast::Body) {
        for item in &body.items {
            match item {
                Item::Setting(ast::Setting::Clock { unit, .. }) => {
                    if unit.nanos == 0 {
                        let message = "a clock unit cannot be zero; write `clock 1ms;`".to_owned();
                        self.sink.rule(&rules::BAD_TIME, &[], vec![(unit.span.into(), message)]);
                    } else {
                        self.model.clock_nanos = unit.nanos;
                    }
                }
                Item::Setting(ast::Setting::MaxEvolutions { count, .. }) => match count.base10_parse() {
                    Ok(0) => self.sink.notation(count.span(), "a cycle has at least one evolution; write 1 or more"),
                    Ok(count) => self.model.max_evolutions = Some(count),
                    Err(error) => self.sink.syn(&error),
                },
                _ => {}
            }
        }
    }

    /// Declares everything in the chart.
    pub(super) fn declare_chart(&mut self, body: &ast::Body) {
        self.model.partials.push(partial(None, None, Vec::new()));
        self.declare_body(body, PartialId::new(0), None, true);
    }

    fn declare_body(&mut self, body: &ast::Body, partial: PartialId, inside: Option<MacroId>, is_chart: bool) {
        self.scope.add_broken(body.broken.iter().map(ToString::to_string));
        for item in &body.items {
            match item {
                Item::Decl(decl) if is_chart => self.declare_decl(decl),
                Item::Action(action) if is_chart => self.declare_action(action),
                Item::Decl(ast::Decl { names, .. }) => self.only_in_chart(names.first()),
                Item::Action(ast::ActionDecl { name, .. }) => self.only_in_chart(Some(name)),
                Item::Step(step) => self.declare_step(step, partial, inside),
                Item::Partial(inner) => {
                    self.declare_partial(inner, None);
                }
                Item::Setting(_) | Item::Property(_) | Item::Chain(_) => {}
            }
        }
    }

    fn only_in_chart(&mut self, name: Option<&Ident>) {
        if let Some(name) = name {
            let message =
                format!("`{name}` is declared inside a part of the chart; names are declared directly in the chart");
            self.sink.notation(name, message);
        }
        self.lose();
    }

    fn declare_decl(&mut self, decl: &ast::Decl) {
        for name in &decl.names {
            let name = name.clone();
            let (attrs, levels) = (decl.attrs.passed_on.clone(), decl.attrs.levels.clone());
            let ty = ty(&decl.ty);
            let value = match decl.kind {
                DeclKind::Input => Name::Input(self.model.inputs.push(Input { name: name.clone(), attrs, levels, ty })),
                DeclKind::Output => {
                    Name::Output(self.model.outputs.push(Output { name: name.clone(), attrs, levels, ty, init: None }))
                }
                DeclKind::Var => Name::Var(self.model.vars.push(Var { name: name.clone(), levels, ty, init: None })),
                DeclKind::Param => {
                    Name::Param(self.model.params.push(Param { name: name.clone(), attrs, levels, ty, init: None }))
                }
            };
            self.scope.declare(&name, Meaning::Value(value), self.sink);
        }
    }

    /// The second pass over a declaration: what stands behind `=`.
    pub(super) fn initial_value(&mut self, decl: &ast::Decl) {
        let Some(init) = &decl.init else { return };
        let init: Expr = expr::resolve(init, self);
        if init.reads.iter().any(|read| !matches!(read, Read::Ticks(_))) {
            let message = "an initial value is a constant; it cannot read a declared name or a step";
            self.sink.notation(Mark::of(decl.init.as_ref()), message);
            return;
        }
        for name in &decl.names {
            match self.scope.get(name) {
                Some(Meaning::Value(Name::Output(id))) => self.model.outputs[id].init = Some(init.clone()),
                Some(Meaning::Value(Name::Var(id))) => self.model.vars[id].init = Some(init.clone()),
                Some(Meaning::Value(Name::Param(id))) => self.model.params[id].init = Some(init.clone()),
                _ => {}
            }
        }
    }

    fn declare_action(&mut self, action: &ast::ActionDecl) {
        let params = action.params.iter().map(|(name, t)| (name.clone(), ty(t))).collect();
        let id = self.model.actions.push(Action {
            name: action.name.clone(),
            attrs: action.attrs.passed_on.clone(),
            levels: action.attrs.levels.clone(),
            params,
        });
        self.scope.declare(&action.name, Meaning::Action(id), self.sink);
    }

    fn declare_partial(&mut self, inner: &ast::Partial, enclosed_by: Option<StepId>) -> PartialId {
        let levels = inner.attrs.levels.iter().chain(&inner.body.levels).cloned().collect();
        let id = self.model.partials.push(partial(Some(inner.name.clone()), enclosed_by, levels));
        self.partials.push(id);
        self.scope.declare_partial(&inner.name, id, self.sink);
        self.declare_body(&inner.body, id, None, false);
        id
    }

    fn declare_step(&mut self, step: &ast::Step, partial: PartialId, inside: Option<MacroId>) {
        if let StepKind::Macro(_, body) = &step.kind {
            return self.declare_macro(step, body, partial);
        }
        let id = self.model.steps.push(Step {
            name: step.name.clone(),
            attrs: step.attrs.passed_on.clone(),
            levels: step.attrs.levels.clone(),
            partial,
            initial: step.initial.is_some(),
            is_final: step.is_final.is_some(),
            linked: step.linked.is_some(),
            macro_step: inside,
            encloses: Vec::new(),
            drawn: false,
            associations: Vec::new(),
            forces: Vec::new(),
        });
        self.steps.push(id);
        self.model.partials[partial].steps.push(id);
        self.scope.declare(&step.name, Meaning::Step(id), self.sink);
        if let StepKind::Enclosing(_, _, partials) = &step.kind {
            for inner in partials {
                let inner = self.declare_partial(inner, Some(id));
                self.model.steps[id].encloses.push(inner);
            }
        }
    }

    /// A macro-step: its expansion's steps stand in the partial grafcet around it.
    fn declare_macro(&mut self, step: &ast::Step, body: &ast::Body, partial: PartialId) {
        let unknown = StepId::new(0);
        let first = self.model.steps.len();
        let macro_step = MacroStep { name: step.name.clone(), entry: unknown, exit: unknown, steps: Vec::new() };
        let id = self.model.macros.push(macro_step);
        self.scope.declare(&step.name, Meaning::Macro(id), self.sink);
        self.declare_body(body, partial, Some(id), false);
        self.model.macros[id].steps =
            self.model.steps.ids().skip(first).filter(|s| self.model.steps[*s].partial == partial).collect();

        let entry = self.macro_end(step, body, "entry", |s| s.entry.is_some());
        let exit = self.macro_end(step, body, "exit", |s| s.exit.is_some());
        if let (Some(entry), Some(exit)) = (entry, exit) {
            self.model.macros[id].entry = entry;
            self.model.macros[id].exit = exit;
            self.model.steps[entry].initial |= step.initial.is_some();
            self.model.steps[entry].linked |= step.linked.is_some();
        } else {
            self.broken_macros.push(id);
            self.lose();
        }
    }

    /// The one entry or exit step of an expansion; none or several are reported.
    fn macro_end(
        &mut self,
        step: &ast::Step,
        body: &ast::Body,
        which: &str,
        is_end: impl Fn(&ast::Step) -> bool,
    ) -> Option<StepId> {
        let ends = body.items.iter().filter_map(|item| match item {
            Item::Step(inner) if is_end(inner) => Some(inner),
            _ => None,
        });
        let ends: Vec<_> = ends.collect();
        if let [end] = ends[..] {
            return match self.scope.get(&end.name) {
                Some(Meaning::Step(id)) => Some(id),
                Some(Meaning::Macro(id)) if !self.broken_macros.contains(&id) => {
                    let inner = &self.model.macros[id];
                    Some(if which == "entry" { inner.entry } else { inner.exit })
                }
                _ => None,
            };
        }
        let (place, message) = match ends.get(1) {
            None => (
                &step.name,
                format!("macro-step `{}` has no {which} step; write `{which} step …` in its expansion", step.name),
            ),
            Some(second) => (
                &second.name,
                format!("macro-step `{}` has a second {which} step; an expansion has exactly one", step.name),
            ),
        };
        self.sink.rule(&rules::MACRO_ENTRY_EXIT, &[], vec![(place.into(), message)]);
        None
    }
}

fn partial(name: Option<Ident>, enclosed_by: Option<StepId>, levels: Vec<ast::LevelAttr>) -> Partial {
    Partial { name, enclosed_by, levels, steps: Vec::new(), transitions: Vec::new() }
}

/// The declared type, told apart as far as the compiler needs it.
fn ty(ty: &ast::Ty) -> Ty {
    let rust = match ty {
        ast::Ty::Time(span) => return Ty::Time(*span),
        ast::Ty::Rust(rust) => rust.clone(),
    };
    let Type::Path(path) = &rust else { return Ty::Other(rust) };
    let Some(name) = path.path.get_ident().map(ToString::to_string) else { return Ty::Other(rust) };
    match name.as_str() {
        "bool" => Ty::Bool(rust),
        "isize" | "usize" => Ty::Int { signed: name == "isize", bits: 32, rust },
        _ => match (name.get(..1), name.get(1..).and_then(|bits| bits.parse().ok())) {
            (Some(sign @ ("i" | "u")), Some(bits @ (8 | 16 | 32 | 64 | 128))) => {
                Ty::Int { signed: sign == "i", bits, rust }
            }
            _ => Ty::Other(rust),
        },
    }
}
