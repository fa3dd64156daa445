//! The first pass: every name of the chart, in source order.

use proc_macro2::Ident;
use syn::Type;

use super::scope::{Meaning, refuse_reserved, spelled};
use super::{Resolver, expr};
use crate::ast::{self, DeclKind, Item, StepKind, Time};
use crate::diagnostic::{Mark, rules};
use crate::list::{List, PushAll};
use crate::model::{
    Action, Expr, Id, Input, MacroId, MacroStep, Name, Output, Param, Partial, PartialId, Read, Step, StepId, TimeRef,
    Tree, Ty, Unary, Var,
};

impl Resolver<'_> {
    /// Declares everything in the chart.
    pub(super) fn declare_chart(&mut self, body: &ast::Body) {
        self.model.partials.push(partial(None, None, &[], Vec::new()));
        self.declare_body(body, PartialId::new(0), Where::Chart);
    }

    fn declare_body(&mut self, body: &ast::Body, partial: PartialId, place: Where) {
        self.scope.add_broken(body);
        for item in &body.items {
            match item {
                // Also where it must not stand: its name is known, and one error is enough.
                Item::Decl(decl) => {
                    self.only_in_chart(place, decl.names.iter());
                    self.declare_decl(decl);
                }
                Item::Let(item) => {
                    self.only_in_chart(place, std::iter::once(&item.name));
                    self.declare_let(item);
                }
                Item::Action(action) => {
                    self.only_in_chart(place, std::iter::once(&action.name));
                    self.declare_action(action);
                }
                Item::Step(step) => self.declare_step(step, partial, place),
                Item::Partial(inner) => {
                    self.refuse_partial(inner, place);
                    self.declare_partial(inner, None);
                }
                Item::Setting(ast::Setting::Modes { keyword }) => self.declare_modes(*keyword, partial, place),
                Item::Setting(setting) => self.setting(setting, place),
                Item::Property(property) => self.refuse_property(property, place),
                Item::Chain(_) => {}
            }
        }
    }

    fn only_in_chart<'n>(&mut self, place: Where, names: impl Iterator<Item = &'n Ident>) {
        if place == Where::Chart {
            return;
        }
        for name in names {
            let message = format!(
                "`{name}` is declared inside {}; the whole chart shares its names: declare it directly in the chart",
                place.text()
            );
            self.sink.notation(name, message);
        }
    }

    fn declare_decl(&mut self, decl: &ast::Decl) {
        let mut values = Vec::new();
        for declared in &decl.names {
            let name = spelled(declared);
            let (attrs, levels) = (decl.attrs.passed_on.clone(), decl.attrs.levels.clone());
            let ty = ty(&decl.ty);
            let value = match decl.kind {
                DeclKind::Input => Name::Input(self.model.inputs.push(Input { name, attrs, levels, ty })),
                DeclKind::Output => {
                    Name::Output(self.model.outputs.push(Output { name, attrs, levels, ty, init: None }))
                }
                DeclKind::Var => Name::Var(self.model.vars.push(Var { name, attrs, levels, ty, init: None })),
                DeclKind::Param => {
                    let param = Param { name, attrs, levels, ty, init: None, range: None };
                    Name::Param(self.model.params.push(param))
                }
            };
            self.scope.declare(declared, Meaning::Value(value), self.sink);
            values.push(value);
        }
        self.variants(decl, values, &ty(&decl.ty));
    }

    /// The second pass over a declaration: what stands after `=`.
    pub(super) fn initial_value(&mut self, decl: &ast::Decl) {
        let Some(init) = &decl.init else { return };
        let init: Expr = expr::resolve(init, self);
        let is_time = matches!(decl.ty, ast::Ty::Time(_));
        let quoted = matches!(&decl.init, Some(syn::Expr::Lit(lit)) if matches!(lit.lit, syn::Lit::Str(_)));
        if let (true, Some(number)) = (is_time && (quoted || matches!(init.tree, Tree::Int(_))), &decl.init) {
            self.no_unit(number);
        }
        if let (true, Tree::Unary(Unary::Neg, _)) = (is_time, &init.tree) {
            let message = "time runs forward; a time is not negative".to_owned();
            self.sink.rule(&rules::BAD_TIME, &[], vec![(Mark::of(decl.init.as_ref()), message)]);
        }
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
        let params = action.params.iter().map(|(name, t)| (spelled(name), ty(t))).list();
        self.refuse_arguments(action);
        let id = self.model.actions.push(Action {
            name: spelled(&action.name),
            attrs: action.attrs.passed_on.clone(),
            levels: action.attrs.levels.clone(),
            params,
        });
        self.scope.declare(&action.name, Meaning::Action(id), self.sink);
    }

    /// Argument names that Rust would refuse in the chart's trait.
    fn refuse_arguments(&mut self, action: &ast::ActionDecl) {
        for (i, (name, _)) in action.params.iter().enumerate() {
            match action.params[..i].iter().find(|(other, _)| other == name) {
                Some((first, _)) => super::scope::report_duplicate(name, first, self.sink),
                None => refuse_reserved(name, self.sink),
            }
        }
    }

    fn declare_partial(&mut self, inner: &ast::Partial, enclosed_by: Option<StepId>) -> PartialId {
        let levels = inner.attrs.levels.iter().and(&inner.body.levels).cloned().list();
        let id =
            self.model.partials.push(partial(Some(spelled(&inner.name)), enclosed_by, &inner.attrs.passed_on, levels));
        self.partials.push(id);
        self.scope.declare_partial(&inner.name, id, self.sink);
        let place = if enclosed_by.is_some() { Where::Enclosure } else { Where::Partial };
        self.declare_body(&inner.body, id, place);
        id
    }

    fn declare_step(&mut self, step: &ast::Step, partial: PartialId, place: Where) {
        self.refuse_words(step, partial, place);
        if let StepKind::Macro(_, body) = &step.kind {
            return self.declare_macro(step, body, partial, place);
        }
        let id = self.model.steps.push(Step {
            name: spelled(&step.name),
            attrs: step.attrs.passed_on.clone(),
            levels: step.attrs.levels.clone(),
            partial,
            initial: step.initial.is_some(),
            is_final: step.is_final.is_some(),
            linked: step.linked.is_some(),
            macro_step: place.expansion(),
            encloses: Vec::new(),
            late: None,
            drawn: false,
            associations: Vec::new(),
            forces: Vec::new(),
        });
        self.steps.push(id);
        self.model.partials[partial].steps.push(id);
        self.withins.push_all(step.within.clone().map(|within| (id, within)));
        // A second step of a name is not on its own: what is drawn to it cannot be told from the first, nor what is drawn
        // from a step `any` from what is drawn from all.
        let is_only = self.scope.declare(&step.name, Meaning::Step(id), self.sink) && step.name != "any";
        self.model.steps[id].drawn = !is_only;
        if let StepKind::Enclosing(_, _, partials) = &step.kind {
            for inner in partials {
                let inner = self.declare_partial(inner, Some(id));
                self.model.steps[id].encloses.push(inner);
            }
        }
    }

    /// The times after `within`, of names that are known by now.
    pub(super) fn resolve_withins(&mut self) {
        for (step, within) in std::mem::take(&mut self.withins) {
            if let Some(ast::TimeArg::Literal(Time { span, nanos: 0 })) = within.time {
                let message = "a step that may take no time at all is late at once; write how long it may take";
                self.sink.rule(&rules::BAD_TIME, &[], vec![(span.into(), message.to_owned())]);
            }
            let time = within.time.map_or(TimeRef::Ticks(0), |time| self.time_arg(&time, None));
            self.model.steps[step].late = Some(Read::Elapsed(time, step));
        }
    }

    /// A macro-step: its expansion's steps stand in the partial grafcet around it.
    fn declare_macro(&mut self, step: &ast::Step, body: &ast::Body, partial: PartialId, place: Where) {
        if let Some(within) = &step.within {
            let message = format!(
                "`{name}` is a macro-step, and `within` watches one step: write it in the expansion, or `10s/{name}` in a condition",
                name = step.name
            );
            self.sink.notation(within.keyword, message);
        }
        let unknown = StepId::new(0);
        let first = self.model.steps.len();
        let (name, outer) = (spelled(&step.name), place.expansion());
        let doc = first_paragraph(&step.attrs.passed_on);
        let macro_step = MacroStep { name, outer, doc, entry: unknown, exit: unknown, steps: Vec::new() };
        let id = self.model.macros.push(macro_step);
        self.scope.declare(&step.name, Meaning::Macro(id), self.sink);
        self.declare_body(body, partial, Where::Expansion(id));
        self.model.macros[id].steps =
            self.model.steps.ids().skip(first).filter(|s| self.model.steps[*s].partial == partial).list();

        let entry = self.macro_end(step, body, "entry", |s| s.entry.is_some());
        let exit = self.macro_end(step, body, "exit", |s| s.exit.is_some());
        if let (Some(entry), Some(exit)) = (entry, exit) {
            self.model.macros[id].entry = entry;
            self.model.macros[id].exit = exit;
            self.model.steps[entry].initial |= step.initial.is_some();
            self.model.steps[entry].linked |= step.linked.is_some();
            self.model.steps[exit].is_final |= step.is_final.is_some();
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
        let ends: Vec<_> = ends.list();
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
        let notes = if ends.is_empty() {
            let message =
                format!("macro-step `{}` has no {which} step; write `{which} step …` in its expansion", step.name);
            vec![((&step.name).into(), message)]
        } else {
            let note = |end: &&ast::Step| {
                let message = format!(
                    "`{}` is one of {} {which} steps of macro-step `{}`, an expansion has exactly one; \
                     leave `{which}` to one of them",
                    end.name,
                    ends.len(),
                    step.name
                );
                (Mark::from(&end.name), message)
            };
            ends.iter().map(note).list()
        };
        self.sink.rule(&rules::MACRO_ENTRY_EXIT, &[], notes);
        None
    }
}

/// In which kind of body a name is declared.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Where {
    Chart,
    Partial,
    Enclosure,
    Expansion(MacroId),
}

impl Where {
    /// The macro-step in whose expansion this is.
    fn expansion(self) -> Option<MacroId> {
        match self {
            Self::Expansion(id) => Some(id),
            _ => None,
        }
    }

    pub(super) fn text(self) -> &'static str {
        match self {
            Self::Chart => "the chart",
            Self::Partial => "a partial grafcet",
            Self::Enclosure => "an enclosure",
            Self::Expansion(_) => "the expansion of a macro-step",
        }
    }
}

fn partial(
    name: Option<Ident>,
    enclosed_by: Option<StepId>,
    attrs: &[syn::Attribute],
    levels: Vec<ast::LevelAttr>,
) -> Partial {
    Partial {
        name,
        enclosed_by,
        doc: first_paragraph(attrs),
        levels,
        steps: Vec::new(),
        transitions: Vec::new(),
        forced_by: Vec::new(),
    }
}

/// What a doc comment says up to an empty line, on one line.
pub(super) fn first_paragraph(attrs: &[syn::Attribute]) -> String {
    let text = |attr: &syn::Attribute| match &attr.meta {
        syn::Meta::NameValue(doc) if doc.path.is_ident("doc") => match &doc.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    };
    let lines: Vec<String> = attrs.iter().filter_map(text).list();
    let lines = lines.iter().flat(|text| text.lines().map(str::trim).and(text.is_empty().then_some("")));
    let words: Vec<&str> = lines.skip_while(|line| line.is_empty()).take_while(|line| !line.is_empty()).list();
    words.join(" ")
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
