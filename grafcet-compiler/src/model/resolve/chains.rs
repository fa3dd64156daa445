//! Chains of steps and transitions.

use proc_macro2::Ident;

use super::blink::Owner;
use super::scope::Meaning;
use super::{Resolver, expr, otherwise};
use crate::ast::{self, Arrow, Condition, Node};
use crate::diagnostic::{Mark, rules};
use crate::list::{List, PushAll};
use crate::model::{Blinker, Dialect, Effect, MacroId, PartialId, StepId, Transition};
use crate::similar;
use crate::sorted::Set;

/// At which end of an arrow a node stands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Source,
    Target,
}

impl Resolver<'_> {
    /// All transitions of a chain, in source order.
    pub(super) fn chain(&mut self, chain: &ast::Chain, partial: PartialId) {
        let mut before = &chain.first;
        let nodes = std::iter::once(before).and(chain.rest.iter().map(|(_, node)| node));
        nodes.flat(names).for_each(|name| self.mention(name));
        self.repeated(before);
        if chain.rest.is_empty() {
            self.node(before, End::Source, partial);
            self.lose();
        }
        let mut condition = false;
        for (position, (arrow, after)) in chain.rest.iter().enumerate() {
            // The second arrow of `A -> on -> B`.
            if std::mem::take(&mut condition) {
                before = after;
                continue;
            }
            self.repeated(after);
            if let Some((Arrow::Bare(end), last)) = chain.rest.get(position + 1) {
                condition = self.condition_as_step(before, arrow, after, *end, last, partial);
                if condition {
                    continue;
                }
            }
            match arrow {
                // See `anys`.
                _ if position == 0 && matches!(before, Node::Any(_)) => {}
                Arrow::Bare(mark) => self.bare_arrow(*mark, before, after, partial),
                Arrow::Transition(transition) => self.transition(chain, before, transition, after, partial),
            }
            before = after;
        }
    }

    /// `A -> on -> B`, where `on` is a value: meant as a condition.
    fn condition_as_step(
        &mut self,
        before: &Node,
        arrow: &Arrow,
        name: &Node,
        end: Mark,
        after: &Node,
        partial: PartialId,
    ) -> bool {
        let (Arrow::Bare(start), Node::Step(name)) = (arrow, name) else { return false };
        let Some(value @ Meaning::Value(_)) = self.scope.get(name) else { return false };
        self.node(before, End::Source, partial);
        self.node(after, End::Target, partial);
        let (from, to) = (name_of(before), name_of(after));
        let message = format!(
            "`{name}` is {}, and a condition stands in brackets: write `{from} -[{name}]-> {to}`",
            value.kind()
        );
        self.sink.rule(&rules::STEPS_WITHOUT_TRANSITION, &[], vec![(start.to(end), message)]);
        self.lose();
        true
    }

    fn transition(
        &mut self,
        chain: &ast::Chain,
        before: &Node,
        transition: &ast::Transition,
        after: &Node,
        partial: PartialId,
    ) {
        let sources = self.node(before, End::Source, partial);
        let targets = self.node(after, End::Target, partial);
        self.crossing(before, after);
        self.owner = self.owner_of(before);
        self.from = names(before).first().map(ToString::to_string);
        let condition = match &transition.condition {
            Condition::Holds(condition) => Some(expr::resolve_condition(condition, self)),
            Condition::Else(word) => Some(otherwise::always(*word)),
            Condition::Broken => None,
        };
        if let Some(name) = &transition.name {
            self.scope.declare_transition(name, self.sink);
        }
        self.forgotten(before, End::Source);
        self.forgotten(after, End::Target);
        let clearing = self.clearing(transition);
        self.owner = Owner::Chart;
        self.from = None;
        self.missing(after);
        let (Some(sources), Some(targets), Some(condition)) = (sources, targets, condition) else { return self.lose() };
        self.loose_end(before, End::Source);
        self.loose_end(after, End::Target);
        let id = self.model.transitions.push(Transition {
            name: transition.name.clone(),
            levels: chain.attrs.levels.clone(),
            partial,
            sources,
            targets,
            condition,
            otherwise: None,
            held: None,
            clearing,
            mark: transition.mark,
            any: None,
            guards: Vec::new(),
        });
        if matches!(transition.condition, Condition::Else(_)) {
            self.elses.push(id);
        }
        self.model.partials[partial].transitions.push(id);
    }

    /// `A -[x]-[y]-> B`
    pub(super) fn missing(&mut self, after: &Node) {
        if let Node::Missing(mark) = after {
            let message = "between two transitions there is always a step; \
                           put an empty step between them, or write one condition with `&&`";
            self.sink.rule(&rules::TRANSITIONS_WITHOUT_STEP, &[], vec![(*mark, message.to_owned())]);
        }
    }

    /// To which step the condition of a transition belongs.
    fn owner_of(&self, before: &Node) -> Owner {
        match names(before) {
            [] => Owner::Sourceless,
            [name] => match self.scope.get(name) {
                Some(Meaning::Macro(id)) => Owner::One(Blinker::Macro(id)),
                Some(Meaning::Step(step)) => Owner::One(Blinker::Step(step)),
                // It has been reported.
                _ => Owner::Several(name.clone()),
            },
            [first, ..] => Owner::Several(first.clone()),
        }
    }

    /// `A -> B`
    pub(super) fn bare_arrow(&mut self, mark: Mark, before: &Node, after: &Node, partial: PartialId) {
        self.node(before, End::Source, partial);
        self.node(after, End::Target, partial);
        let message = format!(
            "between two steps there is always a transition; write `{} -[true]-> {}`, or the condition it waits for",
            name_of(before),
            name_of(after),
        );
        self.sink.rule(&rules::STEPS_WITHOUT_TRANSITION, &[], vec![(mark, message)]);
        self.lose();
    }

    /// The steps of a node: of a macro-step its entry or its exit.
    pub(super) fn node(&mut self, node: &Node, end: End, partial: PartialId) -> Option<Vec<StepId>> {
        if matches!(node, Node::Missing(_) | Node::Forgotten(_)) {
            return None;
        }
        if matches!(node, Node::Any(_)) {
            return Some(Vec::new());
        }
        let mut steps = Vec::new();
        let mut complete = true;
        for name in names(node) {
            if self.is_slip(name) {
                complete = false;
                continue;
            }
            let step = match self.scope.step(name, self.sink) {
                Some(Meaning::Step(step)) => step,
                Some(Meaning::Macro(id)) if self.broken_macros.contains(&id) => {
                    complete = false;
                    continue;
                }
                Some(Meaning::Macro(id)) => {
                    let macro_step = &self.model.macros[id];
                    if end == End::Source { macro_step.exit } else { macro_step.entry }
                }
                _ => {
                    complete = false;
                    continue;
                }
            };
            self.model.steps[step].drawn = true;
            if self.model.steps[step].partial != partial {
                // Of two steps of one name the other one is meant, and that there are two has been reported.
                if !self.scope.is_twice(name) {
                    let message = format!(
                        "`{name}` belongs to {}; a transition connects steps of one partial grafcet",
                        self.partial_name(self.model.steps[step].partial)
                    );
                    self.sink.notation(name, message);
                }
                complete = false;
            }
            if !steps.contains(&step) {
                steps.push(step);
            }
        }
        complete.then_some(steps)
    }

    /// Whether a name that is no step was meant as one that no chain names; that is reported, and the step is not on its own.
    fn is_slip(&mut self, name: &Ident) -> bool {
        if self.scope.is_broken(name) || matches!(self.scope.get(name), Some(Meaning::Step(_) | Meaning::Macro(_))) {
            return false;
        }
        let written = name.to_string().to_lowercase();
        let near = |step: &&Ident| {
            let step = step.to_string();
            !self.drawn.contains(&step) && similar::distance(&step.to_lowercase(), &written) <= 1
        };
        let mut candidates = self.scope.steps().filter(near);
        let (Some(step), None) = (candidates.next().cloned(), candidates.next()) else { return false };
        let message =
            format!("no step is called `{name}`; did you mean `{step}`, which nothing else leads to or from?");
        self.sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), message)]);
        if let Some(Meaning::Step(id)) = self.scope.get(&step) {
            self.model.steps[id].drawn = true;
        }
        true
    }

    /// An expansion is entered and left through its macro-step alone.
    fn crossing(&mut self, before: &Node, after: &Node) {
        let ends = names(before).iter().map(|name| (name, End::Source));
        let ends = ends.and(names(after).iter().map(|name| (name, End::Target)));
        let placed: Vec<_> = ends.filter_map(|(name, end)| Some((name, end, self.expansion(name)?))).list();
        // Seen from outside: from where the fewest expansions are around it.
        let Some((.., home)) = placed.iter().min_by_key(|(.., inside)| inside.len()) else { return };
        for (name, end, inside) in &placed {
            let Some(border) = inside.iter().find(|id| !home.contains(id)) else { continue };
            let expansion = &self.model.macros[*border].name;
            let way = match end {
                End::Source => "one that leaves it starts at",
                End::Target => "one that enters it leads to",
            };
            let message = format!(
                "`{name}` stands in the expansion of macro-step `{expansion}`, and this transition crosses its border; {way} \
                 `{expansion}` itself"
            );
            self.sink.rule(&rules::MACRO_ENTRY_EXIT, &[], vec![((*name).into(), message)]);
        }
    }

    /// The macro-steps around a step, outwards.
    pub(super) fn expansion(&self, name: &Ident) -> Option<Vec<MacroId>> {
        let mut inside = Vec::new();
        let mut next = match self.scope.get(name)? {
            Meaning::Step(step) => self.model.steps[step].macro_step,
            Meaning::Macro(id) => self.model.macros[id].outer,
            _ => return None,
        };
        while let Some(id) = next {
            inside.push(id);
            next = self.model.macros[id].outer;
        }
        Some(inside)
    }

    /// `(B, B)`: a step twice in one list.
    pub(super) fn repeated(&mut self, node: &Node) {
        let Node::Group(names, _) = node else { return };
        for (i, name) in names.iter().enumerate() {
            if let Some(first) = names[..i].iter().find(|first| *first == name) {
                self.repeated_step(first, name);
            }
        }
    }

    /// A step twice in one list, marked at both places.
    pub(super) fn repeated_step(&mut self, first: &Ident, second: &Ident) {
        let notes = vec![
            (first.into(), format!("`{first}` stands here and again in this list; name each step once")),
            (second.into(), format!("`{second}` stands here a second time; name each step once")),
        ];
        self.sink.rule(&rules::REPEATED_STEP, &[], notes);
    }

    /// `()` in an `sfc`.
    pub(super) fn loose_end(&mut self, node: &Node, end: End) {
        let Node::Group(names, mark) = node else { return };
        if !names.is_empty() || self.model.dialect == Dialect::Grafcet {
            return;
        }
        let (rule, message) = match end {
            End::Source => (
                &rules::SOURCE_TRANSITION,
                "a transition of an `sfc` has a step in front of it; name it, or write a `grafcet`, which has source transitions",
            ),
            End::Target => (
                &rules::SINK_TRANSITION,
                "a transition of an `sfc` has a step after it; name it, or write a `grafcet`, which has sink transitions",
            ),
        };
        self.sink.rule(rule, &[], vec![(*mark, message.to_owned())]);
    }

    /// The steps that are named in items that could not be parsed are not on their own for all we know; and one of these
    /// items may be the initial step.
    pub(super) fn lost_items(&mut self, body: &ast::Body) {
        for name in &body.lost {
            if let Some(Meaning::Step(step)) = self.scope.get(name) {
                self.model.steps[step].drawn = true;
            }
        }
        if body.lost_step {
            self.lose();
        }
    }

    pub(super) fn clearing(&mut self, transition: &ast::Transition) -> Vec<Effect> {
        let mut effects = Vec::new();
        for clearing in &transition.clearing {
            if self.model.dialect == Dialect::Sfc {
                let message = "an `sfc` ties actions to steps, not to transitions (IEC 61131-3); \
                               write the action after `P1` in the step that follows";
                self.sink.rule(&rules::CLEARING_ACTION, &[], vec![(clearing.mark, message.to_owned())]);
            }
            let effect = self.effect(&clearing.target);
            if let (Some(Effect::Control(place)), Dialect::Grafcet) = (&effect, self.model.dialect) {
                let name = self.model.place_name(*place);
                let message = format!("this does not say what `{name}` becomes; write `{name} = …`");
                self.sink.rule(&rules::WRONG_TARGET, &[], vec![(clearing.mark, message)]);
            }
            effects.push_all(effect);
        }
        effects
    }
}

pub(super) fn names(node: &Node) -> &[Ident] {
    match node {
        Node::Step(name) => std::slice::from_ref(name),
        Node::Group(names, _) => names,
        Node::Any(any) => &any.except,
        Node::Missing(_) | Node::Forgotten(_) => &[],
    }
}

/// A node as the user wrote it.
fn name_of(node: &Node) -> String {
    match node {
        Node::Step(name) => name.to_string(),
        Node::Group(names, _) => {
            format!("({})", names.iter().map(ToString::to_string).list().join(", "))
        }
        Node::Any(_) => "any".to_owned(),
        Node::Missing(_) | Node::Forgotten(_) => "…".to_owned(),
    }
}

/// Every name in the chains of a body and of the bodies inside it.
pub(super) fn drawn(body: &ast::Body, found: &mut Set<String>) {
    for item in &body.items {
        match item {
            ast::Item::Chain(chain) => {
                let nodes = std::iter::once(&chain.first).and(chain.rest.iter().map(|(_, node)| node));
                for name in nodes.flat(names) {
                    found.insert(name.to_string());
                }
            }
            ast::Item::Partial(inner) => drawn(&inner.body, found),
            ast::Item::Step(ast::Step { kind: ast::StepKind::Macro(_, inner), .. }) => drawn(inner, found),
            ast::Item::Step(ast::Step { kind: ast::StepKind::Enclosing(_, _, partials), .. }) => {
                for inner in partials {
                    drawn(&inner.body, found);
                }
            }
            _ => {}
        }
    }
}
