//! What a way has asked is not asked on it again, as long as nothing has changed it.
//!
//! ```text
//! if empty && again: state = Fill              if empty:
//! else if empty && !again: state = Spin   ->     if again: state = Fill
//! else: state = Drain                            else: state = Spin
//!                                              else: state = Drain
//! ```
//!
//! A condition of which a part is what the next ones ask, too, is taken apart there where that leaves no more to ask and to do.
//!
//! ```text
//! if !full && passed >= 2s: state = Fill       if passed >= 2s:
//! else:                                          if !full: state = Fill
//!   if passed >= 2s: before = start        ->    else:
//!   if passed >= 2s: since = …                     before = start
//!                                                  since = …
//! ```
//!
//! What does nothing where the condition in front of it holds is asked only where that does not.
//!
//! ```text
//! if again && n < 3: state = Fill              if again && n < 3: state = Fill
//! if again && n >= 3: state = Drain     ->     else if again && n >= 3: state = Drain
//! ```
//!
//! Needs: nothing.

use super::super::build::{all, any, no, not, yes};
use super::super::costs::questions;
use super::super::{Comparison, Expr, PlaceId, Program, Statement, Value};
use super::comparisons;
use super::fold::negated;
use super::uses::{blocks, each_read, each_written, is_plain, is_pure, mentions, same, same_block, sum};
use crate::list::PushAll;
use crate::model::Model;

pub(super) fn pass(program: &mut Program<'_>) {
    let mut cycle = std::mem::take(&mut program.cycle);
    statements(program.model, &mut cycle);
    program.cycle = cycle;
}

/// The same for some statements by themselves.
pub(super) fn statements<'m>(model: &'m Model, statements: &mut Vec<Statement<'m>>) {
    block(statements, &mut Learned::of(model));
}

/// Of so much that is asked and done is it tried out, on one way, what it would be if conditions were taken apart.
const EFFORT: usize = 4000;

/// Of so much that is asked and done is it found out whether it does nothing where a condition in front of it holds.
const CHAINED: usize = 100;

/// So many comparisons in the user's own Rust are remembered on one way.
const USERS: usize = 32;

/// A condition that has been asked.
struct Answer<'m> {
    condition: Expr<'m>,
    holds: bool,
    /// Of what places.
    reads: Vec<PlaceId>,
}

impl<'m> Answer<'m> {
    /// Whether another condition holds then: the same one, or one of the same time or integer.
    fn tells(&self, model: &Model, other: &Expr<'m>) -> Option<bool> {
        if same(&self.condition, other) {
            return Some(self.holds);
        }
        if let (Expr::User(told), Expr::User(asked)) = (&self.condition, other) {
            return comparisons::tells(model, (told, self.holds), asked);
        }
        let ((one, least, is_one), (time, end, is_other)) = (limit(&self.condition)?, limit(other)?);
        let reached = self.holds == is_one;
        let follows = if reached { end <= least } else { least <= end };
        (follows && same(one, time)).then_some(reached == is_other)
    }
}

/// Of a comparison of a time with a literal, both, and whether it holds from there on.
fn limit<'e>(condition: &'e Expr<'_>) -> Option<(&'e Expr<'e>, u32, bool)> {
    match condition {
        Expr::Compare(comparison @ (Comparison::AtLeast | Comparison::Less), time, end) => match **end {
            Expr::Value(Value::Ticks(end)) => Some((time, end, *comparison == Comparison::AtLeast)),
            _ => None,
        },
        _ => None,
    }
}

/// What is known on a way.
struct Learned<'m> {
    model: &'m Model,
    told: Vec<Answer<'m>>,
    /// Which of it holds no longer, as something it asks for has been written.
    stale: Vec<usize>,
    /// How much more may be tried out, and whether that is what is done.
    effort: usize,
    is_trying: bool,
}

impl<'m> Learned<'m> {
    fn of(model: &'m Model) -> Self {
        Self { model, told: Vec::new(), stale: Vec::new(), effort: 0, is_trying: false }
    }

    /// A part of a condition that is better asked first, as what stands after it asks for it, too; and the rest.
    fn apart(&mut self, condition: &Expr<'m>, otherwise: &[Statement<'m>]) -> Option<(Expr<'m>, Expr<'m>)> {
        if self.told.is_empty() {
            self.effort = EFFORT;
        }
        let Expr::All(parts) = condition else { return None };
        if self.is_trying || otherwise.is_empty() {
            return None;
        }
        for (at, part) in parts.iter().enumerate().take_while(|(_, part)| is_pure(part)) {
            // What stands in front of it may be there so that it does not panic.
            let may_come_first = at == 0 || is_plain(part);
            if may_come_first && is_asked(self.model, otherwise, part) {
                let mut rest = parts.clone();
                let part = rest.remove(at);
                let rest = all(rest);
                self.effort = self.effort.checked_sub(size(otherwise))?;
                if self.gains((&part, &rest), condition, otherwise) {
                    return Some((part, rest));
                }
            }
        }
        None
    }

    /// Whether there is no more to ask and to do where the first of two parts of a condition is asked first.
    fn gains(&mut self, (part, rest): (&Expr<'m>, &Expr<'m>), both: &Expr<'m>, otherwise: &[Statement<'m>]) -> bool {
        let (mut with, mut without, mut plain) = (otherwise.to_vec(), otherwise.to_vec(), otherwise.to_vec());
        self.is_trying = true;
        self.within(|learned| {
            learned.learn(part, true);
            under(&mut with, rest, false, learned);
        });
        under(&mut without, part, false, self);
        under(&mut plain, both, false, self);
        self.is_trying = false;
        let whole = size(&plain);
        size(&with) != whole && size(&without) != whole && size(&with) + size(&without) <= whole
    }

    /// What is known still.
    fn known(&self) -> impl Iterator<Item = &Answer<'m>> {
        self.told.iter().enumerate().filter(|(at, _)| !self.stale.contains(at)).map(|(_, told)| told)
    }

    /// Something that is known only there.
    fn within(&mut self, work: impl FnOnce(&mut Self)) {
        let (told, stale) = (self.told.len(), self.stale.len());
        work(self);
        self.told.truncate(told);
        self.stale.truncate(stale);
    }

    fn learn(&mut self, condition: &Expr<'m>, holds: bool) {
        match (condition, holds) {
            (Expr::Not(inner), _) => self.learn(inner, !holds),
            (Expr::All(parts), true) | (Expr::Any(parts), false) => {
                for part in parts {
                    self.learn(part, holds);
                }
            }
            _ if is_pure(condition) && self.has_room(condition) => {
                let mut reads = Vec::new();
                each_read(condition, &mut |place| reads.push(place));
                if let Expr::Compare(Comparison::Equal | Comparison::Differs, ..) = condition {
                    let condition = negated(condition.clone());
                    self.told.push(Answer { condition, holds: !holds, reads: reads.clone() });
                }
                self.told.push(Answer { condition: condition.clone(), holds, reads });
            }
            _ => {}
        }
    }

    /// Whether it is not one too many of those that take long to compare.
    fn has_room(&self, condition: &Expr<'m>) -> bool {
        let is_user = |expr: &Expr<'m>| matches!(expr, Expr::User(_));
        !is_user(condition) || self.told.iter().filter(|told| is_user(&told.condition)).count() < USERS
    }

    /// What these statements may have changed is not known after them.
    fn forget(&mut self, statements: &[Statement<'m>]) {
        if self.known().all(|told| told.reads.is_empty()) {
            return;
        }
        each_written(statements, &mut |written| {
            for (at, told) in self.told.iter().enumerate() {
                if told.reads.contains(&written) && !self.stale.contains(&at) {
                    self.stale.push(at);
                }
            }
        });
    }
}

fn block<'m>(statements: &mut Vec<Statement<'m>>, learned: &mut Learned<'m>) {
    if !learned.is_trying {
        chain(learned.model, statements);
    }
    let mut new = Vec::with_capacity(statements.len());
    let last = statements.len().saturating_sub(1);
    for (at, statement) in statements.drain(..).enumerate() {
        let before = new.len();
        match statement {
            Statement::If(condition, then, otherwise) => branches(&condition, then, otherwise, learned, &mut new),
            Statement::Part(name, mut body) => {
                learned.within(|learned| block(&mut body, learned));
                new.push(Statement::Part(name, body));
            }
            Statement::Loop { rounds, mut body } => {
                learned.forget(&body);
                learned.within(|learned| block(&mut body, learned));
                new.push(Statement::Loop { rounds, body });
            }
            Statement::Match(place, mut arms, mut otherwise) => {
                for (_, body) in &mut arms {
                    learned.within(|learned| block(body, learned));
                }
                learned.within(|learned| block(&mut otherwise, learned));
                new.push(Statement::Match(place, arms, otherwise));
            }
            Statement::Set(place, value) => new.push(Statement::Set(place, known(&value, learned))),
            other => new.push(other),
        }
        if at < last {
            learned.forget(&new[before..]);
        }
        join(&mut new);
    }
    *statements = new;
}

/// Of two conditions that exclude each other, one after the other, the second is asked only where the first does not hold.
fn chain<'m>(model: &'m Model, statements: &mut Vec<Statement<'m>>) {
    for at in (1..statements.len()).rev() {
        let [.., Statement::If(condition, then, otherwise), next @ Statement::If(..)] = &statements[..=at] else {
            continue;
        };
        if !otherwise.is_empty() || !is_pure(condition) || size(std::slice::from_ref(next)) > CHAINED {
            continue;
        }
        let mut learned = Learned { is_trying: true, ..Learned::of(model) };
        learned.learn(condition, true);
        learned.forget(then);
        let mut left = vec![next.clone()];
        block(&mut left, &mut learned);
        if left.is_empty() {
            let next = statements.remove(at);
            if let Some(Statement::If(_, _, otherwise)) = statements.get_mut(at - 1) {
                otherwise.push(next);
            }
        }
    }
}

/// Two that ask for the same, one after the other, are one.
fn join(statements: &mut Vec<Statement<'_>>) {
    let [.., Statement::If(one, first, none), Statement::If(other, ..)] = &statements[..] else { return };
    let mut is_kept = none.is_empty() && is_pure(one) && same(one, other);
    if is_kept {
        each_written(first, &mut |written| is_kept &= !mentions(one, written));
    }
    if !is_kept {
        return;
    }
    let Some(Statement::If(_, second, otherwise)) = statements.pop() else { return };
    if let Some(Statement::If(_, first, none)) = statements.last_mut() {
        first.push_all(second);
        none.push_all(otherwise);
    }
}

fn branches<'m>(
    condition: &Expr<'m>,
    mut then: Vec<Statement<'m>>,
    mut otherwise: Vec<Statement<'m>>,
    learned: &mut Learned<'m>,
    new: &mut Vec<Statement<'m>>,
) {
    let condition = known(condition, learned);
    if let Expr::Value(Value::Bool(holds)) = condition {
        let mut body = if holds { then } else { otherwise };
        block(&mut body, learned);
        new.append(&mut body);
        return;
    }
    if let Some((part, rest)) = learned.apart(&condition, &otherwise) {
        let (mut met, mut unmet) = (Vec::new(), otherwise.clone());
        learned.within(|learned| {
            learned.learn(&part, true);
            branches(&rest, then, otherwise, learned, &mut met);
        });
        under(&mut unmet, &part, false, learned);
        new.push(match part {
            Expr::Not(part) if !unmet.is_empty() => Statement::If(*part, unmet, met),
            part => Statement::If(part, met, unmet),
        });
        return;
    }
    under(&mut then, &condition, true, learned);
    under(&mut otherwise, &condition, false, learned);
    if same_block(&then, &otherwise) && is_pure(&condition) {
        new.append(&mut then);
    } else {
        new.push(Statement::If(condition, then, otherwise));
    }
}

/// A body where a condition has been found to hold, or not.
fn under<'m>(body: &mut Vec<Statement<'m>>, condition: &Expr<'m>, holds: bool, learned: &mut Learned<'m>) {
    learned.within(|learned| {
        learned.learn(condition, holds);
        block(body, learned);
    });
}

/// Whether something is asked that a condition tells, holds it or not.
fn is_asked<'m>(model: &'m Model, statements: &[Statement<'m>], condition: &Expr<'m>) -> bool {
    let mut learned = Learned::of(model);
    learned.learn(condition, true);
    learned.learn(condition, false);
    let mut found = false;
    each_asked(statements, &mut |asked| found |= learned.told.iter().any(|one| tells_of(model, one, asked)));
    found
}

/// Whether it tells something of an expression.
fn tells_of<'m>(model: &Model, told: &Answer<'m>, expr: &Expr<'m>) -> bool {
    told.tells(model, expr).is_some()
        || match expr {
            Expr::Not(inner) => tells_of(model, told, inner),
            Expr::All(parts) | Expr::Any(parts) => parts.iter().any(|one| tells_of(model, told, one)),
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

/// What is left of an expression of which something is known.
fn known<'m>(expr: &Expr<'m>, learned: &Learned<'m>) -> Expr<'m> {
    if learned.told.is_empty() {
        return expr.clone();
    }
    if let Some(holds) = learned.known().find_map(|told| told.tells(learned.model, expr)) {
        return if holds { yes() } else { no() };
    }
    let list = |parts: &[Expr<'m>]| {
        let mut list = Vec::with_capacity(parts.len());
        for part in parts {
            list.push(known(part, learned));
        }
        list
    };
    match expr {
        Expr::Not(inner) => not(known(inner, learned)),
        Expr::All(parts) if is_pure(expr) => all(list(parts)),
        Expr::Any(parts) if is_pure(expr) => any(list(parts)),
        other => other.clone(),
    }
}

/// How much there is to ask and to do.
pub(super) fn size(statements: &[Statement<'_>]) -> usize {
    sum(statements, &|statement| match statement {
        Statement::If(condition, ..) => questions(condition),
        Statement::Part(..) | Statement::Loop { .. } => 0,
        Statement::Match(_, arms, _) => arms.len(),
        _ => 1,
    })
}
