//! Questions that several passes ask of a model.

use std::slice;

use super::ids::EdgeId;
use super::{
    Association, Binary, Claim, Effect, Expr, LevelAttr, Model, Name, Place, Read, Step, StepId, TimeRef, Transition,
    TransitionId, Tree, Ty, Unary, Variants,
};
use crate::diagnostic::rules::Rule;
use crate::list::{List, PushAll};

impl Model {
    /// What each expression of the chart reads: conditions, events, values, arguments, blocks, edges and delays; and what
    /// tells that a step is late, which is asked from outside.
    #[must_use]
    pub fn expressions(&self) -> Vec<&[Read]> {
        let mut all: Vec<&[Read]> = Vec::new();
        for transition in self.transitions.values() {
            all.push(&transition.condition.reads);
            all.push_all(transition.clearing.iter().flat(Effect::reads));
        }
        for association in self.associations.values() {
            all.push_all(association.reads());
        }
        all.push_all(self.edges.values().map(|edge| &edge.of.reads[..]));
        all.push_all(self.delays.values().map(|delay| &delay.of.reads[..]));
        all.push_all(self.steps.values().filter_map(|step| step.late.as_ref()).map(slice::from_ref));
        all
    }

    /// `sfc`: whether an evolution can change what an edge looks at: actions look at it after the evolution, conditions of
    /// transitions in front of it.
    #[must_use]
    pub fn is_late(&self, id: EdgeId) -> bool {
        let changes = |read: &Read| match read {
            Read::Rising(inner) | Read::Falling(inner) => self.is_late(*inner),
            Read::Name(_) | Read::Delay(_) | Read::Ticks(_) => false,
            _ => true,
        };
        !self.is_grafcet() && self.edges[id].of.reads.iter().any(changes)
    }

    /// What actions do, those of steps and those on clearing.
    #[must_use]
    pub fn effects(&self) -> Vec<&Effect> {
        let mut all: Vec<&Effect> = self.associations.values().map(|association| &association.effect).list();
        for transition in self.transitions.values() {
            all.push_all(&transition.clearing);
        }
        all
    }

    /// Whether `cycle` has to know the time.
    #[must_use]
    pub fn uses_time(&self) -> bool {
        let timed = |read: &Read| {
            matches!(
                read,
                Read::Since(_)
                    | Read::MacroSince(_)
                    | Read::Elapsed(..)
                    | Read::MacroElapsed(..)
                    | Read::Delay(_)
                    | Read::Blink(_)
            )
        };
        self.associations.values().any(|a| a.time.is_some())
            || self.expressions().iter().any(|reads| reads.iter().any(timed))
    }

    /// The variants that a value can have, where the chart lists them.
    #[must_use]
    pub fn variants_of(&self, name: Name) -> Option<&Variants> {
        self.variants.iter().find(|variants| variants.names.contains(&name))
    }

    /// The same of an expression.
    #[must_use]
    pub fn variants_of_tree(&self, tree: &Tree) -> Option<&Variants> {
        match tree {
            Tree::Read(Read::Name(name)) => self.variants_of(*name),
            _ => None,
        }
    }

    /// The lint attributes around a transition, the innermost first.
    #[must_use]
    pub(crate) fn levels_of_transition<'m>(&'m self, transition: &'m Transition) -> Vec<&'m [LevelAttr]> {
        vec![&transition.levels, &self.partials[transition.partial].levels, &self.levels]
    }

    /// Whether a lint attribute anywhere in the chart sets the level of a rule.
    #[must_use]
    pub(crate) fn has_level_of(&self, rule: &Rule) -> bool {
        let partials = self.partials.values().map(|partial| &partial.levels);
        let steps = self.steps.values().map(|step| &step.levels);
        let transitions = self.transitions.values().map(|transition| &transition.levels);
        let outputs = self.outputs.values().map(|output| &output.levels);
        let vars = self.vars.values().map(|var| &var.levels);
        let inside = partials.and(steps).and(transitions).and(outputs).and(vars);
        inside.and([&self.levels]).flatten().any(|level| level.rule == rule.name)
    }

    /// Whether two transitions never clear together by what they are: one is the `else` of the other, or that of an `any` which comes
    /// before it.
    #[must_use]
    pub fn exclude_each_other(&self, a: TransitionId, b: TransitionId) -> bool {
        let is_other = |id: TransitionId, other: TransitionId| {
            // In source order.
            self.transitions[id].otherwise.as_ref().is_some_and(|others| others.binary_search(&other).is_ok())
        };
        let comes_first = |a: TransitionId, b: TransitionId| {
            self.transitions[a].any.is_some_and(|any| self.transitions[b].guards.contains(&any))
        };
        is_other(a, b) || is_other(b, a) || comes_first(a, b) || comes_first(b, a)
    }

    /// The transitions as they stand in the source: of those for which an `any` stands the first.
    pub fn drawn_transitions(&self) -> impl Iterator<Item = (TransitionId, &Transition)> {
        self.transitions.iter().filter(|(id, transition)| transition.any.is_none_or(|any| self.anys[any].first == *id))
    }

    /// By drawn transition, the steps in front of it; of those for which an `any` stands the steps in front of each.
    pub(crate) fn drawn_sources(&self) -> Vec<Vec<&[StepId]>> {
        let mut drawn = Vec::new();
        for (_, transition) in self.drawn_transitions() {
            let mut sources = vec![&transition.sources[..]];
            if transition.any.is_some() {
                let others = self.transitions.values().filter(|other| other.any == transition.any);
                sources = others.map(|other| &other.sources[..]).list();
            }
            drawn.push(sources);
        }
        drawn
    }

    /// The lint attributes of a declared place, without those of the chart.
    #[must_use]
    pub(crate) fn levels_of_place(&self, place: Place) -> &[LevelAttr] {
        match place {
            Place::Output(id) => &self.outputs[id].levels,
            Place::Var(id) => &self.vars[id].levels,
        }
    }

    /// The name of a place as the user wrote it.
    #[must_use]
    pub fn place_name(&self, place: Place) -> &syn::Ident {
        match place {
            Place::Output(id) => &self.outputs[id].name,
            Place::Var(id) => &self.vars[id].name,
        }
    }

    /// The declared name of a value.
    #[must_use]
    pub fn value_name(&self, name: Name) -> &syn::Ident {
        match name {
            Name::Input(id) => &self.inputs[id].name,
            Name::Output(id) => &self.outputs[id].name,
            Name::Var(id) => &self.vars[id].name,
            Name::Param(id) => &self.params[id].name,
        }
    }

    /// The type of a value.
    #[must_use]
    pub fn ty(&self, name: Name) -> &Ty {
        match name {
            Name::Input(id) => &self.inputs[id].ty,
            Name::Output(id) => &self.outputs[id].ty,
            Name::Var(id) => &self.vars[id].ty,
            Name::Param(id) => &self.params[id].ty,
        }
    }

    /// Whether a value is a time.
    #[must_use]
    pub fn is_time(&self, name: Name) -> bool {
        matches!(self.ty(name), Ty::Time(_))
    }

    /// The type of a place.
    #[must_use]
    pub(crate) fn place_ty(&self, place: Place) -> &Ty {
        match place {
            Place::Output(id) => &self.outputs[id].ty,
            Place::Var(id) => &self.vars[id].ty,
        }
    }
}

impl Step {
    /// How long it may be active before it is late.
    #[must_use]
    pub fn within(&self) -> Option<TimeRef> {
        match self.late {
            Some(Read::Elapsed(time, _)) => Some(time),
            _ => None,
        }
    }
}

impl Transition {
    /// Of an `else` the other branches, if nothing but these decides about it.
    #[must_use]
    pub(crate) fn plain_else(&self) -> Option<&Vec<TransitionId>> {
        self.otherwise.as_ref().filter(|_| self.guards.is_empty() && self.held.is_none())
    }

    /// What the user has written as its condition, without what comes before it.
    #[must_use]
    pub fn own_condition(&self) -> &Tree {
        let mut tree = &self.condition.tree;
        for _ in &self.guards {
            if let Tree::Binary(Binary::And, own, _) = tree {
                tree = own;
            }
        }
        tree
    }
}

impl Association {
    /// Whether the action of a `grafcet` acts at an instant.
    #[must_use]
    pub fn is_stored(&self) -> bool {
        self.qualifier.is_stored_action()
    }

    /// What its expressions read, one list an expression: condition, event and effect.
    #[must_use]
    pub fn reads(&self) -> Vec<&[Read]> {
        let mut all: Vec<&[Read]> = self.condition.iter().and(&self.event).map(|expr| &expr.reads[..]).list();
        all.push_all(self.effect.reads());
        all
    }
}

impl Effect {
    /// The expressions of an effect; a block has none.
    #[must_use]
    pub fn expressions(&self) -> &[Expr] {
        match self {
            Effect::Assign(_, value) => slice::from_ref(value),
            Effect::Call(_, args) => args,
            Effect::Control(_) | Effect::Block(_) => &[],
        }
    }

    /// What the expressions of an effect read, one list an expression.
    #[must_use]
    pub fn reads(&self) -> Vec<&[Read]> {
        match self {
            Effect::Block(code) => vec![&code.reads],
            _ => self.expressions().iter().map(|expr| &expr.reads[..]).list(),
        }
    }

    /// What may write the place in a block, where nobody can know whether it does: `n.bump(…)`.
    #[must_use]
    pub fn unsure(&self, place: Place) -> Option<&str> {
        let Effect::Block(code) = self else { return None };
        code.unsure.iter().find(|(at, _)| *at == place).map(|(_, call)| call.as_str())
    }

    /// The places an effect may write.
    #[must_use]
    pub fn writes(&self) -> &[Place] {
        match self {
            Effect::Control(place) | Effect::Assign(place, _) => slice::from_ref(place),
            Effect::Call(..) => &[],
            Effect::Block(code) => &code.writes,
        }
    }
}

impl Effect {
    /// If the effect acts on `place` as a continuous action can: the value it assigns, or none where it asserts.
    #[must_use]
    #[allow(clippy::option_option, reason = "none, an assertion, or an assigned value")]
    pub(crate) fn continuous_value(&self, place: Place) -> Option<Option<&Tree>> {
        match self {
            Effect::Control(at) if *at == place => Some(None),
            Effect::Assign(at, value) if *at == place => Some(Some(&value.tree)),
            _ => None,
        }
    }
}

impl Claim {
    /// The expressions in it.
    #[must_use]
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            Self::Never(condition) => vec![condition],
            Self::Always { premise, condition } => premise.iter().and([condition]).list(),
            Self::Home(..) => Vec::new(),
            Self::LeadsTo { from, to, .. } => vec![from, to],
            Self::Before { first, then } => vec![first, then],
        }
    }

    /// What holds at the end of a cycle that violates it; none where one cycle alone does not tell.
    #[must_use]
    pub fn violation(&self) -> Option<Tree> {
        let not = |tree: &Tree| Tree::Unary(Unary::Not, Box::new(tree.clone()));
        match self {
            Self::Never(condition) => Some(condition.tree.clone()),
            Self::Always { premise: None, condition } => Some(not(&condition.tree)),
            Self::Always { premise: Some(premise), condition } => {
                Some(Tree::Binary(Binary::And, Box::new(premise.tree.clone()), Box::new(not(&condition.tree))))
            }
            Self::Home(..) | Self::LeadsTo { .. } | Self::Before { .. } => None,
        }
    }

    /// What has to happen before it says anything; none of what always says something.
    #[must_use]
    pub fn trigger(&self) -> Option<&Expr> {
        match self {
            Self::Always { premise: Some(premise), .. } => Some(premise),
            Self::LeadsTo { from, .. } => Some(from),
            Self::Before { then, .. } => Some(then),
            Self::Never(_) | Self::Always { premise: None, .. } | Self::Home(..) => None,
        }
    }
}
