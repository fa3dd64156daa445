//! `else`: the condition of a branch is that none of the other branches of the same steps clears.

use proc_macro2::Span;

use super::Resolver;
use super::composed::{and_in_rust, in_parentheses, negated};
use crate::list::List;
use crate::model::{Binary, Expr, Read, StepId, TransitionId, Tree, Unary};
use crate::place;
use crate::sorted::{Map, Set, sort};

/// What stands for the condition as long as the other branches are not known.
pub(super) fn always(word: Span) -> Expr {
    let tokens = literal_true(Span::mixed_site().located_at(word));
    Expr { tree: Tree::Bool(true), tokens, reads: Vec::new(), text: "else".to_owned(), mark: word.into() }
}

impl Resolver<'_> {
    /// The conditions of all transitions with `else`, once all others are known.
    pub(super) fn otherwise(&mut self) {
        if self.elses.is_empty() {
            return;
        }
        let branches = self.branches();
        for id in self.elses.clone() {
            let sources = in_order(&self.model.transitions[id].sources);
            let others = branches.get(&sources).into_iter().flatten().copied();
            let others: Vec<TransitionId> = others.filter(|other| *other != id).list();
            if sources.is_empty() {
                let message = "`else` stands at a branch of a step, and nothing stands in front of this transition; \
                               write its condition";
                self.sink.notation(self.model.transitions[id].condition.mark, message);
            } else if self.is_last(id, &others) {
                self.model.transitions[id].condition = self.none_of(id, &others);
                // As all of them are enabled together, they stand at the same step in the generated code.
                let sources = self.model.transitions[others[0]].sources.clone();
                others.iter().and([&id]).for_each(|one| self.model.transitions[*one].sources.clone_from(&sources));
                self.model.transitions[id].otherwise = Some(others);
            }
        }
    }

    /// The transitions that leave the same steps, in source order.
    fn branches(&self) -> Map<Vec<StepId>, Vec<TransitionId>> {
        let mut branches: Map<Vec<StepId>, Vec<TransitionId>> = Map::new();
        for (id, transition) in self.model.transitions.iter().filter(|(_, transition)| transition.any.is_none()) {
            branches.or_default(in_order(&transition.sources)).push(id);
        }
        branches
    }

    /// Whether an `else` stands after other branches and in front of none; else it is reported.
    fn is_last(&mut self, id: TransitionId, others: &[TransitionId]) -> bool {
        let mark = self.model.transitions[id].condition.mark;
        let steps = self.steps_text(id);
        let after = others.iter().find(|other| **other > id);
        match after {
            None if !others.is_empty() => return true,
            None if self.unread || self.model.incomplete => {}
            None => {
                let message = format!(
                    "`else` has nothing to be the other case of: no other branch leaves {steps}; write `true`, or draw \
                     the other branches in front of it"
                );
                self.sink.notation(mark, message);
            }
            Some(other) if self.is_else(*other) => {
                let second = self.model.transitions[*other].condition.mark;
                self.sink.notation(mark, format!("{steps} has an `else` here and another one further down; keep one"));
                self.sink.notation(second, format!("{steps} has a second `else` here; keep one of them"));
            }
            Some(other) => {
                let other = self.model.transition_text(&self.model.transitions[*other]);
                let message = format!(
                    "`else` is the last branch of {steps}, and {other} stands after it; move this one to the end"
                );
                self.sink.notation(mark, message);
            }
        }
        false
    }

    fn is_else(&self, id: TransitionId) -> bool {
        self.elses.contains(&id)
    }

    fn steps_text(&self, id: TransitionId) -> String {
        format!("`{}`", self.model.steps_text(&self.model.transitions[id].sources))
    }

    /// `!(a) && !(b)`
    fn none_of(&self, id: TransitionId, others: &[TransitionId]) -> Expr {
        let Expr { text, mark, .. } = &self.model.transitions[id].condition;
        let conditions: Vec<&Expr> = others.iter().map(|other| &self.model.transitions[*other].condition).list();
        let mut reads: Vec<Read> = Vec::new();
        let mut known: Set<Read> = Set::new();
        for read in conditions.iter().flat(|condition| &condition.reads) {
            if known.insert(*read) {
                reads.push(*read);
            }
        }
        Expr { tree: none(&conditions), tokens: none_in_rust(&conditions), reads, text: text.clone(), mark: *mark }
    }
}

fn in_order(steps: &[StepId]) -> Vec<StepId> {
    let mut steps = steps.to_vec();
    sort(&mut steps);
    steps
}

/// No deeper than it has to be: there may be many branches.
fn none(conditions: &[&Expr]) -> Tree {
    match conditions {
        [] => Tree::Bool(true),
        [one] => Tree::Unary(Unary::Not, Box::new(one.tree.clone())),
        _ => {
            let (left, right) = conditions.split_at(conditions.len() / 2);
            Tree::Binary(Binary::And, Box::new(none(left)), Box::new(none(right)))
        }
    }
}

fn none_in_rust(conditions: &[&Expr]) -> syn::Expr {
    match conditions {
        [] => literal_true(place::mixed()),
        [one] => negated(one.tokens.clone()),
        _ => {
            let (left, right) = conditions.split_at(conditions.len() / 2);
            let half = |part: &[&Expr]| {
                let inner = none_in_rust(part);
                if part.len() > 1 { in_parentheses(inner) } else { inner }
            };
            and_in_rust(half(left), half(right))
        }
    }
}

fn literal_true(span: Span) -> syn::Expr {
    syn::Expr::Lit(syn::ExprLit { attrs: Vec::new(), lit: syn::Lit::Bool(syn::LitBool { value: true, span }) })
}
