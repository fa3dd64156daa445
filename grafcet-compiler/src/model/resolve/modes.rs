//! `modes;` (A39): the inputs that it declares, and what it makes of conditions.
//!
//! A condition `c` becomes "not paused, and if by hand the push button, else `c`, and the push button where the chart is semi-automatic". Everything after
//! this pass sees conditions and inputs.

use proc_macro2::{Ident, Span};
use quote::ToTokens;
use syn::{parse_quote, parse_quote_spanned};

use super::Resolver;
use super::composed::{and, not, or};
use super::declare::Where;
use super::scope::Meaning;
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::List;
use crate::model::{
    Assumption, Edge, EdgeId, Expr, Id, Input, InputId, Modes, Name, PartialId, Read, StepId, Transition, TransitionId,
    Tree, Ty, placeholder,
};
use crate::place;

/// The inputs, and what the program reads of them.
const INPUTS: [(&str, &str); 4] = [
    ("semi_automatic", " Semi-automatic: a transition needs its condition and the push button."),
    ("manual", " Manual: the push button alone clears what is enabled."),
    ("paused", " Paused: nothing clears."),
    ("push", " The push button: it counts when it goes down."),
];

/// Reports a name that `modes;` needs.
pub(super) fn taken(name: &Ident, modes: Span, sink: &mut Sink) {
    let notes: Vec<(Mark, String)> = vec![
        (
            name.into(),
            format!(
                "`modes;` declares an input `{name}`; choose another name for this one, or leave it away if that input is meant"
            ),
        ),
        (
            modes.into(),
            format!(
                "`modes;` declares `semi_automatic`, `manual`, `paused` and `push`, and `{name}` is declared once more"
            ),
        ),
    ];
    sink.rule(&rules::DUPLICATE_NAME, &[], notes);
}

impl Resolver<'_> {
    /// `modes;` in a chart or in a partial grafcet.
    pub(super) fn declare_modes(&mut self, keyword: Span, partial: PartialId, place: Where) {
        if matches!(place, Where::Expansion(_)) {
            let message = "`modes;` is about a chart or a partial grafcet, and this is the expansion of a macro-step, which is held back with the net around it; \
                           write it outside of the macro-step";
            return self.sink.notation(keyword, message);
        }
        if let Some((_, first)) = self.modes.iter().find(|(other, _)| *other == partial) {
            self.sink.notation(*first, "`modes` stands here first, and again further down; keep one of them");
            self.sink.notation(keyword, "`modes` stands here a second time; keep one of them");
            return;
        }
        self.modes.push((partial, keyword));
        if self.modes.len() > 1 {
            return;
        }
        self.mode_inputs = Some(INPUTS.map(|(name, doc)| self.input(name, doc, keyword)));
    }

    fn input(&mut self, name: &str, doc: &str, keyword: Span) -> InputId {
        let name = Ident::new(name, keyword);
        let ty = Ty::Bool(parse_quote_spanned!(keyword=> bool));
        let id = self.model.inputs.push(Input {
            name: name.clone(),
            attrs: vec![parse_quote_spanned!(keyword=> #[doc = #doc])],
            levels: Vec::new(),
            ty,
        });
        self.scope.declare_of_modes(&name, Meaning::Value(Name::Input(id)), self.sink);
        id
    }

    fn of_input(&self, id: InputId, keyword: Span) -> Expr {
        let name = &self.model.inputs[id].name;
        let read = Read::Name(Name::Input(id));
        Expr {
            tree: Tree::Read(read),
            tokens: parse_quote!(#name),
            reads: vec![read],
            text: name.to_string(),
            mark: keyword.into(),
        }
    }

    /// Makes the conditions of all transitions that are held back.
    pub(super) fn hold(&mut self) {
        let Some([semi_automatic, manual, paused, push]) = self.mode_inputs else { return };
        let here = self.modes.clone();
        let keyword = here[0].1;
        let pushed = self.edge(Edge { of: self.of_input(push, keyword) });
        let modes = Modes { semi_automatic, manual, paused, pushed };
        self.model.modes = Some(modes);
        // By hand a chart comes to any situation: what is proved is about its own ways. That the button is not pushed leaves everything out that clears by
        // hand, and nothing else: what reads `manual` itself still is either.
        let make = Make { resolver: self, at: keyword.into() };
        let (text, mark) = ("manual && push".to_owned(), keyword.into());
        let never = Expr { text, mark, ..and(make.input(manual), make.input(push)) };
        self.model.assumptions.push(Assumption { never, mark, of_range: None });
        let is_twice = self.told_twice();
        let mut idle: Vec<PartialId> = here.iter().map(|(partial, _)| *partial).list();
        let mut held: Vec<TransitionId> = Vec::new();
        for (id, transition) in self.model.transitions.iter() {
            let around =
                here.iter().map(|(partial, _)| *partial).find(|partial| self.is_in(transition.partial, *partial));
            // What has no step in front of it, and `any`, wait for something outside: the emergency stop works in every mode.
            if let (Some(around), false, None) = (around, transition.sources.is_empty(), transition.any) {
                idle.retain(|partial| *partial != around);
                held.push(id);
            }
        }
        let conditions = held.iter().map(|id| self.held(&modes, *id, &held)).list();
        for (id, condition) in held.into_iter().zip(conditions) {
            let transition = &mut self.model.transitions[id];
            transition.held = Some(std::mem::replace(&mut transition.condition, condition).tree);
        }
        if !is_twice && !self.unread && !self.model.incomplete {
            for (_, keyword) in here.iter().filter(|(partial, _)| idle.contains(partial)) {
                let message = "`modes;` holds transitions back that leave a step, and there is none here; draw one, or remove this";
                self.sink.notation(*keyword, message);
            }
        }
    }

    /// Reports `modes;` within what another one holds back anyway.
    fn told_twice(&mut self) -> bool {
        let here = self.modes.clone();
        let mut found = false;
        for (partial, keyword) in &here {
            if let Some((_, first)) = here.iter().find(|(other, _)| other != partial && self.is_in(*partial, *other)) {
                found = true;
                self.sink.notation(
                    *first,
                    "`modes;` holds back everything in here, and a part of it says so, too; keep one of them",
                );
                self.sink.notation(*keyword, "another `modes;` around this one holds this back, too; keep one of them");
            }
        }
        found
    }

    /// Whether a partial grafcet belongs to another one: all belong to the chart, enclosures to that of their step.
    fn is_in(&self, partial: PartialId, of: PartialId) -> bool {
        let mut next = Some(partial);
        while let Some(id) = next {
            if id == of || of.index() == 0 {
                return true;
            }
            next = self.model.partials[id].enclosed_by.map(|step| self.model.steps[step].partial);
        }
        false
    }

    /// `!paused && (pushed || !manual && !semi_automatic) && (manual || c)`
    fn held(&self, modes: &Modes, id: TransitionId, held: &[TransitionId]) -> Expr {
        let transition = &self.model.transitions[id];
        let at = transition.condition.mark;
        let make = Make { resolver: self, at };
        let (manual, own) = (make.input(modes.manual), transition.condition.clone());
        let automatic = and(not(manual.clone()), not(make.input(modes.semi_automatic)));
        let running = and(not(make.input(modes.paused)), or(make.pushed(modes.pushed), automatic));
        let condition = match self.by_hand(transition, id, held) {
            ByHand::Never => and(not(manual), own),
            ByHand::Always => or(manual, own),
            ByHand::Unless(others) => {
                let free = others.iter().map(|steps| not(make.all(steps)));
                let free = free.reduce(and);
                let by_hand = free.map_or(manual.clone(), |free| and(manual.clone(), free));
                or(by_hand, and(not(manual), own))
            }
        };
        Expr { text: transition.condition.text.clone(), mark: at, ..and(running, condition) }
    }

    /// By hand, of transitions that leave a step together the first in the source clears: later branches never do. In an `sfc` priority does the
    /// rest; in a `grafcet` one waits for those before it that share some of its steps, as long as these are enabled.
    fn by_hand(&self, transition: &Transition, id: TransitionId, held: &[TransitionId]) -> ByHand {
        let mut others: Vec<Vec<StepId>> = Vec::new();
        for other in held.iter().filter(|other| **other < id) {
            let other = &self.model.transitions[*other];
            if !other.sources.iter().any(|step| transition.sources.contains(step)) {
                continue;
            }
            let more = other.sources.iter().filter(|step| !transition.sources.contains(step)).copied().list();
            if more.is_empty() {
                return ByHand::Never;
            }
            if self.model.is_grafcet() && !others.contains(&more) {
                others.push(more);
            }
        }
        if others.is_empty() { ByHand::Always } else { ByHand::Unless(others) }
    }
}

/// Whether the push button alone clears a transition that is enabled.
enum ByHand {
    Never,
    Always,
    /// Unless all steps of one of these lists are active.
    Unless(Vec<Vec<StepId>>),
}

/// How expressions are put together.
struct Make<'a, 's> {
    resolver: &'a Resolver<'s>,
    at: Mark,
}

impl Make<'_, '_> {
    fn input(&self, id: InputId) -> Expr {
        self.resolver.of_input(id, self.resolver.model.inputs[id].name.span())
    }

    fn pushed(&self, edge: EdgeId) -> Expr {
        self.read(Read::Rising(edge))
    }

    fn read(&self, read: Read) -> Expr {
        let tokens = placeholder::ident(read, place::mixed()).map(ToTokens::into_token_stream).unwrap_or_default();
        Expr {
            tree: Tree::Read(read),
            tokens: syn::Expr::Verbatim(tokens),
            reads: vec![read],
            text: String::new(),
            mark: self.at,
        }
    }

    /// Whether all of these steps, of which there is one at least, are active.
    fn all(&self, steps: &[StepId]) -> Expr {
        let mut active = steps.iter().map(|step| self.read(Read::Active(*step)));
        let first = active.next().unwrap_or_else(|| super::otherwise::always(place::mixed()));
        active.fold(first, and)
    }
}
