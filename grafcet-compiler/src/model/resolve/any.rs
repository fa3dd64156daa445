//! `any -[stop]-> Stopped;`: a transition from every step of a net, before all others.

use quote::ToTokens;

use super::Resolver;
use super::blink::Owner;
use super::chains::End;
use super::composed::{and, not, or_in_rust};
use super::exclusion;
use super::expr;
use super::scope::Meaning;
use crate::ast::{self, Arrow, Condition, Item, Node, StepKind};
use crate::diagnostic::{Mark, rules};
use crate::list::List;
use crate::model::{
    Any, AnyId, Binary, Expr, ForceOrder, Id, PartialId, Read, StepId, Transition, TransitionId, Tree, placeholder,
};
use crate::place::{self, quote};
use crate::sorted::{Set, sort};

impl Resolver<'_> {
    /// All `any` of a chart or partial grafcet: they come before its other transitions.
    pub(super) fn anys(&mut self, body: &ast::Body, partial: PartialId) {
        for item in &body.items {
            match item {
                Item::Chain(chain) => {
                    if let (Node::Any(any), Some((arrow, after))) = (&chain.first, chain.rest.first()) {
                        self.any(chain, any, arrow, after, partial);
                    }
                }
                Item::Step(ast::Step { kind: StepKind::Macro(_, inner), .. }) => self.any_in_macro(inner),
                _ => {}
            }
        }
    }

    fn any_in_macro(&mut self, body: &ast::Body) {
        for item in &body.items {
            match item {
                Item::Chain(ast::Chain { first: Node::Any(any), .. }) => {
                    let message = "`any` speaks of a whole chart or partial grafcet, and this is the expansion of a macro-step; \
                                   write it outside of the macro-step";
                    self.sink.notation(any.mark, message);
                    self.lose();
                }
                Item::Step(ast::Step { kind: StepKind::Macro(_, inner), .. }) => self.any_in_macro(inner),
                _ => {}
            }
        }
    }

    fn any(&mut self, chain: &ast::Chain, any: &ast::Any, arrow: &Arrow, after: &Node, partial: PartialId) {
        let transition = match arrow {
            Arrow::Bare(mark) => return self.bare_arrow(*mark, &chain.first, after, partial),
            Arrow::Transition(transition) => transition,
        };
        self.repeated(&Node::Group(any.except.clone(), any.mark));
        let excepted = self.excepted(any, partial);
        let targets = self.node(after, End::Target, partial);
        self.entered_from_outside(after);
        self.owner = Owner::Any;
        let condition = match &transition.condition {
            Condition::Holds(condition) => Some(expr::resolve_condition(condition, self)),
            Condition::Broken => None,
            Condition::Else(word) => {
                let message =
                    "`else` stands at a branch of a step, and `any` comes before all branches; write its condition";
                self.sink.notation(*word, message);
                None
            }
        };
        if let Some(name) = &transition.name {
            self.scope.declare_transition(name, self.sink);
        }
        self.forgotten(after, End::Target);
        let clearing = self.clearing(transition);
        self.owner = Owner::Chart;
        self.missing(after);
        let (Some(excepted), Some(targets), Some(condition)) = (excepted, targets, condition) else {
            return self.lose();
        };
        self.loose_end(after, End::Target);
        let entered = self.all_of(after);
        let steps = self.model.partials[partial].steps.iter();
        let sources: Vec<StepId> =
            steps.copied().filter(|step| !entered.contains(step) && !excepted.contains(step)).list();
        if sources.is_empty() {
            self.nothing_left(any, partial);
            return self.lose();
        }
        let id = AnyId::new(self.model.anys.len());
        let first = TransitionId::new(self.model.transitions.len());
        for source in &sources {
            let one = self.model.transitions.push(Transition {
                name: transition.name.clone(),
                levels: chain.attrs.levels.clone(),
                partial,
                sources: vec![*source],
                targets: targets.clone(),
                condition: condition.clone(),
                otherwise: None,
                held: None,
                clearing: clearing.clone(),
                mark: transition.mark,
                any: Some(id),
                guards: Vec::new(),
            });
            self.model.partials[partial].transitions.push(one);
        }
        self.model.anys.push(Any { partial, first, sources, except: any.except.clone() });
    }

    /// The steps that are left out; of a macro-step all of its expansion.
    fn excepted(&mut self, any: &ast::Any, partial: PartialId) -> Option<Set<StepId>> {
        let mut steps = Set::new();
        let mut complete = true;
        for name in &any.except {
            self.mention(name);
            let own = match self.scope.step(name, self.sink) {
                Some(Meaning::Step(step)) => vec![step],
                Some(Meaning::Macro(id)) => self.model.macros[id].steps.clone(),
                _ => {
                    complete = false;
                    continue;
                }
            };
            if let Some(step) = own.first().filter(|step| self.model.steps[**step].partial != partial) {
                let (home, here) = (self.partial_name(self.model.steps[*step].partial), self.partial_name(partial));
                let message =
                    format!("`{name}` belongs to {home}, and this `any` stands for the steps of {here}; leave it away");
                self.sink.notation(name, message);
                complete = false;
            }
            steps.extend(own);
        }
        complete.then_some(steps)
    }

    /// The steps of a target: of a macro-step all of its expansion.
    fn all_of(&self, node: &Node) -> Set<StepId> {
        let steps = super::chains::names(node).iter().flat(|name| match self.scope.get(name) {
            Some(Meaning::Step(step)) => vec![step],
            Some(Meaning::Macro(id)) => self.model.macros[id].steps.clone(),
            _ => Vec::new(),
        });
        steps.collect()
    }

    fn nothing_left(&mut self, any: &ast::Any, partial: PartialId) {
        let net = self.partial_name(partial);
        let message = if any.except.is_empty() {
            format!(
                "no step is left for `any`: it stands for all steps of {net} but its targets; declare the others, or delete it"
            )
        } else {
            format!(
                "no step is left for `any`: its targets and `except` are all steps of {net}; leave fewer of them out"
            )
        };
        self.sink.notation(any.mark, message);
    }

    /// `any` stands outside of all macro-steps.
    fn entered_from_outside(&mut self, after: &Node) {
        for name in super::chains::names(after) {
            let inside = self.expansion(name).unwrap_or_default();
            let Some(outermost) = inside.last() else { continue };
            let expansion = &self.model.macros[*outermost].name;
            let message = format!(
                "`{name}` stands in the expansion of macro-step `{expansion}`, and `any` leads into it from outside; name \
                 `{expansion}` itself"
            );
            self.sink.rule(&rules::MACRO_ENTRY_EXIT, &[], vec![(name.into(), message)]);
        }
    }

    /// Lets transitions clear only where no `any` of their net does. Where these leave one of the sources of a transition, in an `sfc`
    /// their priority sees to it.
    pub(super) fn guard(&mut self) {
        // As written, before they are guarded themselves.
        let anys = self.model.anys.iter().map(|(id, any)| (id, self.model.transitions[any.first].condition.clone()));
        let anys: Vec<(AnyId, Expr)> = anys.list();
        let mut asked_again = Vec::new();
        for (id, condition) in anys {
            let (partial, first) = (self.model.anys[id].partial, self.model.anys[id].first);
            // The steps of a sequence of an `sfc` are never active together, and priority asks each branch once.
            if condition.tree.may_differ() && (self.model.is_grafcet() || self.is_parallel(partial)) {
                asked_again.push((condition.text.clone(), condition.mark));
            }
            let sources: Set<StepId> = self.model.anys[id].sources.iter().copied().collect();
            let activity = self.is_parallel(partial).then(|| active(&self.model.anys[id].sources, condition.mark));
            for other in self.model.partials[partial].transitions.clone() {
                let transition = &self.model.transitions[other];
                if transition.any == Some(id) || other < first {
                    continue;
                }
                let guard = if transition.sources.iter().any(|step| sources.contains(step)) {
                    if !self.model.is_grafcet() {
                        continue;
                    }
                    condition.clone()
                } else {
                    let Some(activity) = &activity else { continue };
                    and(condition.clone(), activity.clone())
                };
                let guarded = and(self.model.transitions[other].condition.clone(), not(guard));
                let transition = &mut self.model.transitions[other];
                transition.condition = guarded;
                transition.guards.push(id);
            }
        }
        for (text, mark) in asked_again {
            let message = format!(
                "`{text}` may have another value each time, and the condition of this `any` is asked for several steps in one evolution; \
                 hand it to the chart as an input, which is read once a cycle, or say `assume pure …;` where it has no state"
            );
            self.sink.notation(mark, message);
            self.lose();
        }
        self.asked_again_by_else();
    }

    /// An `else` beside an `any` of a `grafcet`, or one that `modes;` holds back, asks anew for what the other branches ask for: it does not only
    /// wait for them.
    fn asked_again_by_else(&mut self) {
        let asks = |(_, transition): &(TransitionId, &Transition)| transition.plain_else().is_none();
        let elses = self.model.transitions.iter().filter(asks).filter_map(|(_, one)| one.otherwise.clone());
        let mut branches: Vec<TransitionId> = elses.flatten().list();
        sort(&mut branches);
        branches.dedup();
        for id in branches {
            let Expr { text, mark, .. } = &self.model.transitions[id].condition;
            if self.model.transitions[id].own_condition().may_differ() {
                let beside =
                    if self.model.transitions[id].held.is_some() { "with `modes;`" } else { "beside an `any`" };
                let message = format!(
                    "`{text}` may have another value each time, and {beside} the `else` of this step asks for it once more; \
                     hand it to the chart as an input, which is read once a cycle, or say `assume pure …;` where it has no state"
                );
                self.sink.notation(*mark, message);
                self.model.incomplete = true;
            }
        }
    }

    /// Whether several steps of a net may be active together, at first sight.
    fn is_parallel(&self, partial: PartialId) -> bool {
        let net = &self.model.partials[partial];
        let several = |wanted: fn(&crate::model::Step) -> bool| {
            net.steps.iter().filter(|step| wanted(&self.model.steps[**step])).count() > 1
        };
        let forks = |id: &TransitionId| {
            let transition = &self.model.transitions[*id];
            transition.targets.len() > 1 || transition.sources.is_empty()
        };
        let forced = |order: &ForceOrder| matches!(order, ForceOrder::Steps(steps) if steps.len() > 1);
        let overlap = || self.model.is_grafcet() && exclusion::may_part(self, partial);
        several(|step| step.initial)
            || several(|step| step.linked)
            || net.transitions.iter().any(forks)
            || self.model.orders_on(partial).any(|force| forced(&force.order))
            || overlap()
    }
}

/// Whether one of the steps is active. Halves, so that a long list lies not deep.
fn active(steps: &[StepId], mark: Mark) -> Expr {
    let (tree, tokens, reads) = match steps {
        [] => (Tree::Bool(false), syn::Expr::Verbatim(quote!(false)), Vec::new()),
        [step] => {
            let read = Read::Active(*step);
            let tokens = placeholder::ident(read, place::mixed()).into_token_stream();
            (Tree::Read(read), syn::Expr::Verbatim(tokens), vec![read])
        }
        _ => {
            let (left, right) = steps.split_at(steps.len() / 2);
            let (left, right) = (active(left, mark), active(right, mark));
            let tokens = or_in_rust(left.tokens, right.tokens);
            let tree = Tree::Binary(Binary::Or, Box::new(left.tree), Box::new(right.tree));
            (tree, tokens, left.reads.into_iter().and(right.reads).list())
        }
    };
    Expr { tree, tokens, reads, text: String::new(), mark }
}
