//! What the actions and variables of a program are: who writes what, and what only remembers how something was in the scan before.

use std::collections::{BTreeMap, BTreeSet};

use super::blocks;
use super::expr::{Instance, Kind};
use super::parser::{Expr, Statement, expression, statements};
use super::source::{Block, Piece, Pou, Section, Span, Variable, What, same};
use super::walk::{self, each};

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
    /// Instances of function blocks that are written out, in small letters, and what they keep.
    pub(super) written_out: BTreeSet<String>,
    pub(super) added: Vec<Variable>,
    /// What is a little different here.
    pub(super) differs: Vec<(Span, String)>,
    /// Actions that others call.
    pub(super) called: BTreeSet<String>,
    /// Control variables of `FOR` that nothing else asks for.
    pub(super) counters: BTreeSet<String>,
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
            written_out: BTreeSet::new(),
            added: Vec::new(),
            counters: BTreeSet::new(),
            called: BTreeSet::new(),
            differs: Vec::new(),
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
        facts.called(pou);
        facts.inputs(pou);
        let conditions = conditions(pou);
        facts.instances(pou);
        facts.blocks(pou, &conditions);
        for body in facts.bodies.values().flatten() {
            assigned(body, &mut facts.assigned);
        }
        facts.loops(pou, &conditions);
        facts.memory(pou, plain);
        facts
    }

    /// What a program writes to its own inputs is left out: whoever calls it gives them anew.
    fn inputs(&mut self, pou: &Pou) {
        for variable in pou.variables.iter().filter(|one| one.section == Section::Input && !one.constant) {
            let is_write =
                |one: &Statement| matches!(one, Statement::Assign(target, _) if same(target, &variable.name));
            let mut said = Vec::new();
            for (key, body) in &mut self.bodies {
                let Ok(body) = body else { continue };
                each(body, &mut |one| {
                    let Statement::Assign(_, value) = one else { return };
                    said.extend(is_write(one).then(|| format!("`{} := {}` in `{key}`", variable.name, shown(value))));
                });
                left_out(body, &is_write);
            }
            if !said.is_empty() {
                let message = format!(
                    "`{}` is an input, which whoever calls the chart gives: left out is {}",
                    variable.name,
                    said.join(", ")
                );
                self.differs.push((variable.at.clone(), message));
            }
        }
    }

    /// An action that another one calls stands in its place.
    fn called(&mut self, pou: &Pou) {
        // As deep as actions that call themselves are followed.
        for _ in 0..8 {
            let before = self.bodies.clone();
            let is_action = |one: &Statement| matches!(one, Statement::Call(name, arguments) if arguments.is_empty() && action(pou, name).is_some());
            let calls = |body: &Vec<Statement>| {
                let mut any = false;
                each(body, &mut |one| any |= is_action(one));
                any
            };
            let callers: Vec<String> =
                before.iter().filter(|(_, body)| body.as_ref().is_ok_and(calls)).map(|(key, _)| key.clone()).collect();
            if callers.is_empty() {
                return;
            }
            for body in before.values().flatten() {
                each(body, &mut |one| {
                    if let Statement::Call(name, _) = one {
                        self.called.insert(name.to_lowercase());
                    }
                });
            }
            for key in callers {
                let Some(Ok(body)) = self.bodies.get_mut(&key) else { continue };
                if let Err(why) = inlined(body, &before) {
                    self.bodies.insert(key, Err(why));
                }
            }
        }
    }

    fn blocks(&mut self, pou: &Pou, conditions: &[Expr]) {
        for variable in &pou.variables {
            let key = variable.name.to_lowercase();
            if blocks::is_one(&variable.ty) && !self.instances.contains_key(&key) {
                let mut bodies: Vec<&mut Vec<Statement>> = self.bodies.values_mut().flatten().collect();
                if blocks::written_out(variable, &mut bodies, conditions, &mut self.added) {
                    self.written_out.insert(key);
                }
            }
        }
    }

    fn loops(&mut self, pou: &Pou, conditions: &[Expr]) {
        for variable in pou.variables.iter().filter(|one| one.section == Section::Local && one.address.is_none()) {
            let all = self.bodies.values().flatten().flatten();
            let all: usize = all.map(|one| walk::count(one, &variable.name)).sum();
            let outside: usize = conditions.iter().map(|condition| walk::reads(condition, &variable.name)).sum();
            let (mut own, mut written) = (0, false);
            for body in self.bodies.values().flatten() {
                each(body, &mut |one| {
                    let Statement::For(name, ends, by, inner) = one else { return };
                    if !same(name, &variable.name) {
                        return;
                    }
                    own += walk::count(one, name);
                    let mut names = BTreeSet::new();
                    assigned(inner, &mut names);
                    let in_ends = ends.iter().chain(by).map(|end| walk::reads(end, name)).sum::<usize>() > 0;
                    written |= in_ends || names.contains(&name.to_lowercase());
                });
            }
            if all > 0 && all == own && outside == 0 && !written {
                self.counters.insert(variable.name.to_lowercase());
            }
        }
    }

    fn body(&mut self, key: String, text: &Piece) {
        let read = match &text.language {
            Some(language) => Err(format!("it is written in {language}")),
            None => statements(text).map_err(|wrong| wrong.message),
        };
        self.bodies.insert(key, read);
    }

    /// What is written, if the bodies of these actions are left out.
    pub(super) fn written(&self, left_out: &BTreeSet<String>) -> BTreeSet<String> {
        let mut written = self.switched.clone();
        let bodies = self.bodies.iter().filter(|(key, _)| !left_out.contains(*key));
        bodies.filter_map(|(_, body)| body.as_ref().ok()).for_each(|body| assigned(body, &mut written));
        written
    }

    /// `R_TRIG`, `F_TRIG`, `TON` and `TOF` that are called once, by themselves, are edges and delays.
    fn instances(&mut self, pou: &Pou) {
        for variable in &pou.variables {
            let kind = variable.ty.to_uppercase();
            if !["R_TRIG", "F_TRIG", "TON", "TOF"].contains(&&*kind) {
                continue;
            }
            if kind == "TON" && self.timed(pou, variable) {
                continue;
            }
            let is_call = |one: &Statement| is_call(one, &variable.name);
            let all: Vec<&Statement> = self.bodies.values().flatten().flatten().filter(|one| is_call(one)).collect();
            let [Statement::Call(_, arguments)] = all[..] else { continue };
            let argument = |wanted: &str| {
                let found = arguments.iter().find(|(name, _)| name.as_deref().is_some_and(|name| same(name, wanted)));
                found.map(|(_, value)| value.clone())
            };
            let instance = match &*kind {
                "R_TRIG" => argument("clk").map(Instance::Rising),
                "F_TRIG" => argument("clk").map(Instance::Falling),
                "TON" => argument("in").zip(argument("pt")).map(|(of, limit)| Instance::Delayed(of, limit)),
                _ => argument("in").zip(argument("pt")).map(|(of, limit)| Instance::Kept(of, limit)),
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
    let mut found = 0;
    each(body, &mut |one| found += usize::from(writes(one, name)));
    found
}

pub(super) fn writes(statement: &Statement, name: &str) -> bool {
    matches!(statement, Statement::Assign(target, _) | Statement::For(target, ..) if same(target, name))
}

pub(super) fn assigned(body: &[Statement], written: &mut BTreeSet<String>) {
    each(body, &mut |one| {
        if let Statement::Assign(target, _) | Statement::For(target, ..) = one {
            written.insert(target.to_lowercase());
        }
    });
}

pub(super) fn left_out(body: &mut Vec<Statement>, is: &dyn Fn(&Statement) -> bool) {
    body.retain_mut(|one| {
        let before = one.bodies().iter().filter(|inner| !inner.is_empty()).count();
        one.bodies_mut().into_iter().for_each(|inner| left_out(inner, is));
        // An `IF` in which nothing else stood.
        let nothing =
            matches!(one, Statement::If(..)) && before > 0 && one.bodies().iter().all(|inner| inner.is_empty());
        !is(one) && !nothing
    });
}

/// A value as it is written, where it is a short one.
fn shown(value: &Expr) -> String {
    match value {
        Expr::Bool(value) => value.to_string().to_uppercase(),
        Expr::Int(value) => value.to_string(),
        Expr::Real(value) | Expr::Name(value) => value.clone(),
        _ => "…".to_owned(),
    }
}

pub(super) fn is_call(statement: &Statement, instance: &str) -> bool {
    matches!(statement, Statement::Call(name, _) if same(name, instance))
}

/// Those of all transitions that can be read.
fn conditions(pou: &Pou) -> Vec<Expr> {
    let texts = pou.transitions.iter().map(|transition| &transition.condition);
    texts.filter(|text| text.language.is_none()).filter_map(|text| expression(text).ok()).collect()
}

/// With the bodies of the actions that are called.
fn inlined(body: &mut Vec<Statement>, bodies: &BTreeMap<String, Result<Vec<Statement>, String>>) -> Result<(), String> {
    let mut done = Vec::new();
    for mut statement in std::mem::take(body) {
        match &statement {
            Statement::Call(name, arguments) if arguments.is_empty() && bodies.contains_key(&name.to_lowercase()) => {
                let called = bodies[&name.to_lowercase()].clone();
                done.extend(called.map_err(|why| format!("of `{name}`, which it calls: {why}"))?);
                if done.len() > 1_000 {
                    return Err("it calls more than anybody reads".to_owned());
                }
                continue;
            }
            _ => {}
        }
        for inner in statement.bodies_mut() {
            inlined(inner, bodies)?;
        }
        done.push(statement);
    }
    *body = done;
    Ok(())
}
