//! What a way has asked of the inputs is not asked on it again.
//!
//! ```text
//! if empty && again: state = Fill              if empty:
//! else if empty && !again: state = Spin   ->     if again: state = Fill
//! else: state = Drain                            else: state = Spin
//!                                              else: state = Drain
//! ```
//!
//! Inputs are the same throughout a cycle. A condition that begins with what the next ones ask, too, is taken apart there where that leaves no
//! more to ask and to do. Needs: nothing.

use super::super::build::{all, any, no, not, yes};
use super::super::{Expr, Program, Statement, Value};
use super::uses::{blocks, is_pure, same, same_block};

pub(super) fn pass(program: &mut Program<'_>) {
    let mut cycle = std::mem::take(&mut program.cycle);
    statements(&mut cycle);
    program.cycle = cycle;
}

/// The same for some statements by themselves.
pub(super) fn statements(statements: &mut Vec<Statement<'_>>) {
    block(statements, &mut Learned::default());
}

/// So many conditions are tried to be taken apart within one that is: each has what stands after it looked at twice more.
const TRIES: usize = 64;

/// Conditions of inputs alone, and whether each holds.
type Told<'m> = Vec<(Expr<'m>, bool)>;

/// What is known on a way.
#[derive(Default)]
struct Learned<'m> {
    told: Told<'m>,
    /// In how many conditions that are tried to be taken apart this one lies, and how many more may be tried.
    depth: usize,
    tries: usize,
}

impl Learned<'_> {
    fn may_try(&mut self) -> bool {
        if self.depth == 0 {
            self.tries = TRIES;
        }
        self.tries = self.tries.saturating_sub(1);
        self.tries > 0
    }
}

fn block<'m>(statements: &mut Vec<Statement<'m>>, learned: &mut Learned<'m>) {
    let mut new = Vec::with_capacity(statements.len());
    for statement in statements.drain(..) {
        match statement {
            Statement::If(condition, then, otherwise) => branches(&condition, then, otherwise, learned, &mut new),
            Statement::Part(name, mut body) => {
                block(&mut body, learned);
                new.push(Statement::Part(name, body));
            }
            Statement::Loop { rounds, mut body } => {
                block(&mut body, learned);
                new.push(Statement::Loop { rounds, body });
            }
            Statement::Match(place, mut arms, mut otherwise) => {
                for (_, body) in &mut arms {
                    block(body, learned);
                }
                block(&mut otherwise, learned);
                new.push(Statement::Match(place, arms, otherwise));
            }
            Statement::Set(place, value) => new.push(Statement::Set(place, known(&value, &learned.told))),
            other => new.push(other),
        }
    }
    *statements = new;
}

fn branches<'m>(
    condition: &Expr<'m>,
    mut then: Vec<Statement<'m>>,
    otherwise: Vec<Statement<'m>>,
    learned: &mut Learned<'m>,
    new: &mut Vec<Statement<'m>>,
) {
    let condition = known(condition, &learned.told);
    if let Expr::Value(Value::Bool(holds)) = condition {
        let mut body = if holds { then } else { otherwise };
        block(&mut body, learned);
        new.append(&mut body);
        return;
    }
    under(&mut then, &condition, true, learned);
    let mut plain = otherwise.clone();
    under(&mut plain, &condition, false, learned);
    if same_block(&then, &plain) && is_pure(&condition) {
        new.append(&mut then);
        return;
    }
    let Some((first, rest)) = first(&condition).filter(|(first, _)| is_asked(&otherwise, first) && learned.may_try())
    else {
        new.push(Statement::If(condition, then, plain));
        return;
    };
    let (mut with, mut without) = (otherwise.clone(), otherwise);
    learned.depth += 1;
    let before = learned.told.len();
    learn(&first, true, &mut learned.told);
    under(&mut with, &rest, false, learned);
    learned.told.truncate(before);
    under(&mut without, &first, false, learned);
    learned.depth -= 1;
    if differs(&with, &plain) && differs(&without, &plain) && size(&with) + size(&without) <= size(&plain) {
        new.push(Statement::If(first, vec![Statement::If(rest, then, with)], without));
    } else {
        new.push(Statement::If(condition, then, plain));
    }
}

/// A body where a condition has been found to hold, or not.
fn under<'m>(body: &mut Vec<Statement<'m>>, condition: &Expr<'m>, holds: bool, learned: &mut Learned<'m>) {
    let before = learned.told.len();
    learn(condition, holds, &mut learned.told);
    block(body, learned);
    learned.told.truncate(before);
}

/// Whether something is asked that a condition tells, holds it or not.
fn is_asked(statements: &[Statement<'_>], condition: &Expr<'_>) -> bool {
    let mut told = Vec::new();
    learn(condition, true, &mut told);
    learn(condition, false, &mut told);
    let mut found = false;
    each_asked(statements, &mut |asked| found |= told.iter().any(|(one, _)| has(asked, one)));
    found
}

/// Whether it is part of an expression.
fn has(expr: &Expr<'_>, part: &Expr<'_>) -> bool {
    same(expr, part)
        || match expr {
            Expr::Not(inner) => has(inner, part),
            Expr::All(parts) | Expr::Any(parts) => parts.iter().any(|one| has(one, part)),
            _ => false,
        }
}

fn each_asked<'m>(statements: &[Statement<'m>], each: &mut dyn FnMut(&Expr<'m>)) {
    for statement in statements {
        if let Statement::If(asked, ..) | Statement::Set(_, asked) = statement {
            each(asked);
        }
        for block in blocks(statement) {
            each_asked(block, each);
        }
    }
}

fn learn<'m>(condition: &Expr<'m>, holds: bool, told: &mut Told<'m>) {
    match (condition, holds) {
        (Expr::Not(inner), _) => learn(inner, !holds, told),
        (Expr::All(parts), true) | (Expr::Any(parts), false) => parts.iter().for_each(|part| learn(part, holds, told)),
        _ if is_of_inputs(condition) => told.push((condition.clone(), holds)),
        _ => {}
    }
}

/// What is left of an expression of which something is known.
fn known<'m>(expr: &Expr<'m>, told: &Told<'m>) -> Expr<'m> {
    if told.is_empty() {
        return expr.clone();
    }
    if let Some((_, holds)) = told.iter().find(|(other, _)| same(other, expr)) {
        return if *holds { yes() } else { no() };
    }
    let list = |parts: &[Expr<'m>]| {
        let mut list = Vec::with_capacity(parts.len());
        for part in parts {
            list.push(known(part, told));
        }
        list
    };
    match expr {
        Expr::Not(inner) => not(known(inner, told)),
        Expr::All(parts) if is_pure(expr) => all(list(parts)),
        Expr::Any(parts) if is_pure(expr) => any(list(parts)),
        other => other.clone(),
    }
}

/// The first part of a condition, and the rest.
fn first<'m>(condition: &Expr<'m>) -> Option<(Expr<'m>, Expr<'m>)> {
    match condition {
        Expr::All(parts) => {
            let (first, rest) = parts.split_first()?;
            is_of_inputs(first).then(|| (first.clone(), all(rest.to_vec())))
        }
        _ => None,
    }
}

fn is_of_inputs(expr: &Expr<'_>) -> bool {
    match expr {
        Expr::Input(_) => true,
        Expr::Not(inner) => is_of_inputs(inner),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().all(is_of_inputs),
        Expr::User(user) => is_pure(expr) && user.binds.iter().all(|(_, value)| is_of_inputs(value)),
        _ => false,
    }
}

fn differs(a: &[Statement<'_>], b: &[Statement<'_>]) -> bool {
    size(a) != size(b)
}

/// How much there is to ask and to do.
fn size(statements: &[Statement<'_>]) -> usize {
    let mut all = 0;
    for statement in statements {
        all += match statement {
            Statement::If(condition, then, otherwise) => questions(condition) + size(then) + size(otherwise),
            Statement::Part(_, body) | Statement::Loop { body, .. } => size(body),
            Statement::Match(_, arms, otherwise) => {
                arms.iter().map(|(_, body)| 1 + size(body)).sum::<usize>() + size(otherwise)
            }
            _ => 1,
        };
    }
    all
}

fn questions(condition: &Expr<'_>) -> usize {
    match condition {
        Expr::Not(inner) => questions(inner),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().map(questions).sum(),
        _ => 1,
    }
}
