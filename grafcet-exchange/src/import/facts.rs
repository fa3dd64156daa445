//! What the actions and variables of a program are: who writes what, and what only remembers how something was in the scan before.

use std::collections::{BTreeMap, BTreeSet};

use super::expr::{Instance, Kind};
use super::parser::{Expr, Statement, statements};
use super::source::{Block, Piece, Pou, Section, Variable, What, same};

/// The bodies of a program, read.
pub(super) struct Facts {
    /// By action; none where it is no structured text that is translated, with the reason.
    pub(super) bodies: BTreeMap<String, Result<Vec<Statement>, String>>,
    /// Variables that hold what an expression was in the scan before.
    pub(super) memory: BTreeMap<String, Expr>,
    pub(super) instances: BTreeMap<String, Instance>,
    /// By an action that is structured text; all names in small letters.
    pub(super) assigned: BTreeSet<String>,
    /// Switched by steps themselves.
    switched: BTreeSet<String>,
}

/// The key of a body that stands at the step itself.
pub(super) fn inline(step: usize, block: usize) -> String {
    format!("{step} {block}")
}

impl Facts {
    /// `plain` are variables that are read as they are, so that they are no memory of edges.
    pub(super) fn of(pou: &Pou, plain: &BTreeSet<String>) -> Self {
        let mut facts = Self {
            bodies: BTreeMap::new(),
            memory: BTreeMap::new(),
            instances: BTreeMap::new(),
            assigned: BTreeSet::new(),
            switched: BTreeSet::new(),
        };
        for action in &pou.actions {
            facts.body(action.name.to_lowercase(), &action.body);
        }
        for (number, step) in pou.steps.iter().enumerate() {
            for (index, block) in step.blocks.iter().enumerate() {
                match &block.what {
                    What::Inline(text) => facts.body(inline(number, index), text),
                    What::Named(name) if action(pou, name).is_none() => {
                        facts.switched.insert(name.to_lowercase());
                    }
                    What::Named(_) => {}
                }
            }
        }
        facts.instances(pou);
        facts.memory(pou, plain);
        facts
    }

    fn body(&mut self, key: String, text: &Piece) {
        let read = match &text.language {
            Some(language) => Err(format!("it is written in {language}")),
            None => statements(text).map_err(|wrong| wrong.message),
        };
        if let Ok(statements) = &read {
            assigned(statements, &mut self.assigned);
        }
        self.bodies.insert(key, read);
    }

    /// What is written, if the bodies of these actions are left out.
    pub(super) fn written(&self, left_out: &BTreeSet<String>) -> BTreeSet<String> {
        let mut written = self.switched.clone();
        let bodies = self.bodies.iter().filter(|(key, _)| !left_out.contains(*key));
        bodies.filter_map(|(_, body)| body.as_ref().ok()).for_each(|body| assigned(body, &mut written));
        written
    }

    /// `R_TRIG`, `F_TRIG` and `TON` that are called once, by themselves, are edges and delays.
    fn instances(&mut self, pou: &Pou) {
        for variable in &pou.variables {
            let kind = variable.ty.to_uppercase();
            if !["R_TRIG", "F_TRIG", "TON"].contains(&&*kind) {
                continue;
            }
            let is_call = |one: &Statement| matches!(one, Statement::Call(name, _) if same(name, &variable.name));
            let all: Vec<&Statement> = self.bodies.values().flatten().flatten().filter(|one| is_call(one)).collect();
            let [Statement::Call(_, arguments)] = all[..] else { continue };
            let argument = |wanted: &str| {
                let found = arguments.iter().find(|(name, _)| name.as_deref().is_some_and(|name| same(name, wanted)));
                found.map(|(_, value)| value.clone())
            };
            let instance = match &*kind {
                "R_TRIG" => argument("clk").map(Instance::Rising),
                "F_TRIG" => argument("clk").map(Instance::Falling),
                _ => argument("in").zip(argument("pt")).map(|(of, limit)| Instance::Delayed(of, limit)),
            };
            let Some(instance) = instance else { continue };
            self.instances.insert(variable.name.to_lowercase(), instance);
            for body in self.bodies.values_mut().flatten() {
                body.retain(|one| !is_call(one));
            }
        }
    }

    /// What an action of every step copies into variables of its own, without asking for steps.
    fn memory(&mut self, pou: &Pou, plain: &BTreeSet<String>) {
        for action in pou.actions.iter().filter(|action| everywhere(pou, &action.name)) {
            let Some(Ok(body)) = self.bodies.get(&action.name.to_lowercase()) else { continue };
            for statement in body {
                let Statement::Assign(target, value) = statement else { continue };
                let copies = is_local(pou, target) && self.assignments(target) == 1 && !asks(value);
                if copies && !plain.contains(&target.to_lowercase()) {
                    self.memory.insert(target.to_lowercase(), value.clone());
                }
            }
        }
    }

    /// How often something is assigned.
    fn assignments(&self, name: &str) -> usize {
        let all = self.bodies.values().flatten();
        all.map(|body| count(body, name)).sum()
    }

    /// The action does nothing but remember.
    pub(super) fn only_remembers(&self, body: &[Statement]) -> bool {
        let remembers = |one: &Statement| matches!(one, Statement::Assign(target, _) if self.memory.contains_key(&target.to_lowercase()));
        body.iter().all(remembers)
    }
}

/// Whether an action runs in each scan: it belongs to every step, or an initial one sets it and nothing resets it.
pub(super) fn everywhere(pou: &Pou, name: &str) -> bool {
    let by = |block: &Block, qualifier: &str| is_named(block, name) && same(&block.qualifier, qualifier);
    pou.steps.iter().all(|step| step.blocks.iter().any(|block| by(block, "N"))) || is_set(pou, name)
}

/// Whether an initial step sets an action and nothing resets it.
pub(super) fn is_set(pou: &Pou, name: &str) -> bool {
    let mut all = pou.steps.iter().flat_map(|step| &step.blocks).filter(|block| is_named(block, name));
    let is_s = |block: &Block| same(&block.qualifier, "S");
    let begins = |block: &Block| is_named(block, name) && is_s(block);
    all.all(is_s) && pou.steps.iter().any(|step| step.initial && step.blocks.iter().any(begins))
}

fn is_named(block: &Block, name: &str) -> bool {
    matches!(&block.what, What::Named(other) if same(other, name))
}

/// For a step, or for a part of an instance.
fn asks(expr: &Expr) -> bool {
    match expr {
        Expr::Member(..) | Expr::Call(..) => true,
        Expr::Not(inner) | Expr::Minus(inner) => asks(inner),
        Expr::Binary(_, a, b) => asks(a) || asks(b),
        _ => false,
    }
}

pub(super) fn action<'p>(pou: &'p Pou, name: &str) -> Option<&'p super::source::Action> {
    pou.actions.iter().find(|action| same(&action.name, name))
}

pub(super) fn variable<'p>(pou: &'p Pou, name: &str) -> Option<&'p Variable> {
    pou.variables.iter().find(|variable| same(&variable.name, name))
}

fn is_local(pou: &Pou, name: &str) -> bool {
    variable(pou, name)
        .is_some_and(|variable| variable.section == Section::Local && Kind::of(&variable.ty) == Some(Kind::Bool))
}

fn count(body: &[Statement], name: &str) -> usize {
    let of = |statement: &Statement| match statement {
        Statement::Assign(target, _) => usize::from(same(target, name)),
        Statement::Call(..) => 0,
        Statement::If(branches, otherwise) => {
            branches.iter().map(|(_, then)| count(then, name)).sum::<usize>() + count(otherwise, name)
        }
    };
    body.iter().map(of).sum()
}

fn assigned(body: &[Statement], written: &mut BTreeSet<String>) {
    for statement in body {
        match statement {
            Statement::Assign(target, _) => {
                written.insert(target.to_lowercase());
            }
            Statement::Call(..) => {}
            Statement::If(branches, otherwise) => {
                for (_, then) in branches {
                    assigned(then, written);
                }
                assigned(otherwise, written);
            }
        }
    }
}
