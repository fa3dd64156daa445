//! Timers that are called in some steps alone: their time begins with these steps.

use super::expr::{Instance, Kind, Rust, Scope, strength};
use super::facts::{Facts, inline, is_call, left_out};
use super::parser::{Arguments, Expr, Op, Statement};
use super::source::{Pou, Variable, What, same};
use super::walk::each;

/// A call of a timer, with its input and its time.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Timed {
    pub(super) steps: Vec<String>,
    pub(super) of: Expr,
    pub(super) limit: Expr,
    /// One of the steps sets it back: its time is that of each step.
    pub(super) each: bool,
}

impl Facts {
    /// A timer that is called in some steps alone. A call with `FALSE` sets it back, which leaving the step does here.
    pub(super) fn timed(&mut self, pou: &Pou, variable: &Variable) -> bool {
        let (mut calls, mut set_back) = (Vec::new(), Vec::new());
        for (key, body) in &self.bodies {
            let Ok(body) = body else { continue };
            let mut found = Vec::new();
            if !guarded(body, &variable.name, None, &mut found) {
                return false;
            }
            for (guard, arguments) in found {
                let value = |wanted: &str, place: usize| {
                    let named =
                        arguments.iter().find(|(name, _)| name.as_deref().is_some_and(|name| same(name, wanted)));
                    named.or_else(|| arguments.get(place).filter(|(name, _)| name.is_none())).map(|(_, value)| value)
                };
                match (value("in", 0), value("pt", 1)) {
                    (Some(Expr::Bool(false)), _) => {
                        set_back.extend(with_body(pou, key).map(|(step, _)| step.to_owned()));
                    }
                    (Some(of), Some(limit)) => {
                        let of = match guard {
                            None => of.clone(),
                            Some(guard) if guard == *of || *of == Expr::Bool(true) => guard,
                            Some(guard) => Expr::Binary(Op::And, Box::new(guard), Box::new(of.clone())),
                        };
                        calls.push(Timed { steps: steps_of(pou, key), of, limit: limit.clone(), each: false });
                    }
                    _ => return false,
                }
            }
        }
        let alone = calls.iter().all(|call| !call.steps.is_empty() && call.steps.len() < pou.steps.len());
        for call in &mut calls {
            call.each = call.steps.iter().any(|step| set_back.contains(step));
        }
        if calls.is_empty() || !alone {
            return false;
        }
        let message = format!("`{}` is called in some steps alone: here its time begins with them", variable.name);
        self.differs.push((variable.at.clone(), message));
        self.instances.insert(variable.name.to_lowercase(), Instance::Timed(calls));
        for body in self.bodies.values_mut().flatten() {
            left_out(body, &|one| is_call(one, &variable.name));
        }
        true
    }
}

impl Scope<'_> {
    /// A timer of the steps that are active here.
    pub(super) fn timed(&mut self, name: &str, calls: &[Timed]) -> Result<Rust, String> {
        let is_here = |step: &String| self.active.iter().any(|active| same(active, step));
        let found: Vec<&Timed> = calls.iter().filter(|call| call.steps.iter().any(is_here)).collect();
        let [call] = found[..] else {
            return Err(format!("`{name}` is called in several steps, and none or several of them are meant here"));
        };
        let steps = call.steps.iter().filter(|step| !call.each || is_here(step));
        let steps: Vec<String> = steps.filter_map(|step| self.names.get_step(step)).map(str::to_owned).collect();
        let active = steps.iter().map(|step| format!("{step}.X")).collect::<Vec<_>>().join(" || ");
        let limit = self.rust(&call.limit, Some(Kind::Time))?;
        let step = if let [step] = &steps[..] { format!("{limit}/{step}") } else { format!("{limit}/({active})") };
        if call.of == Expr::Bool(true) {
            return Ok(Rust(step, strength::PRODUCT));
        }
        // Both have been so for that long where each has.
        let of = self.expr(&call.of, Some(Kind::Bool))?.within(strength::UNARY);
        Ok(Rust(format!("{step} && {limit}/{of}"), strength::AND))
    }
}

/// The calls of an instance with the conditions around them; false where one stands in a loop, or in a branch after others.
fn guarded<'s>(
    body: &'s [Statement],
    instance: &str,
    guard: Option<&Expr>,
    found: &mut Vec<(Option<Expr>, &'s Arguments)>,
) -> bool {
    let and = |condition: Expr| match guard {
        Some(guard) => Expr::Binary(Op::And, Box::new(guard.clone()), Box::new(condition)),
        None => condition,
    };
    body.iter().all(|statement| match statement {
        Statement::Call(name, arguments) => {
            found.extend(same(name, instance).then(|| (guard.cloned(), arguments)));
            true
        }
        Statement::If(branches, otherwise) => match &branches[..] {
            [(condition, then)] => {
                // `IF c = TRUE THEN`
                let condition = match condition {
                    Expr::Binary(Op::Equal, of, value) if **value == Expr::Bool(true) => of,
                    other => other,
                };
                let no = and(Expr::Not(Box::new(condition.clone())));
                guarded(then, instance, Some(&and(condition.clone())), found)
                    && guarded(otherwise, instance, Some(&no), found)
            }
            _ => !calls_within(statement, instance),
        },
        other => !calls_within(other, instance),
    })
}

fn calls_within(statement: &Statement, instance: &str) -> bool {
    let mut found = false;
    for body in statement.bodies() {
        each(body, &mut |one| found |= is_call(one, instance));
    }
    found
}

/// The steps that have a body, each with its qualifier.
fn with_body<'p>(pou: &'p Pou, key: &'p str) -> impl Iterator<Item = (&'p str, &'p str)> {
    pou.steps.iter().enumerate().flat_map(move |(number, step)| {
        let blocks = step.blocks.iter().enumerate().filter(move |(index, block)| match &block.what {
            What::Named(name) => same(name, key),
            What::Inline(_) => inline(number, *index) == key,
        });
        blocks.map(|(_, block)| (&*step.name, &*block.qualifier))
    })
}

/// The steps in which a body runs in each scan; none where it runs in others, too, by another qualifier.
fn steps_of(pou: &Pou, key: &str) -> Vec<String> {
    let all: Vec<(&str, &str)> = with_body(pou, key).collect();
    if all.iter().any(|(_, qualifier)| !same(qualifier, "N")) {
        return Vec::new();
    }
    all.into_iter().map(|(step, _)| step.to_owned()).collect()
}
