//! What is asked of many arms at once, without comparing each with each.

use super::super::{Arm, Expr, Initial, PlaceId, Program, Statement, Type, Value};
use crate::list::List;
use crate::model::Id;
use crate::sorted::{sort, sort_by_key};

/// By thing, which group it is in: those that are the same are one group, numbered by the first of each. They have the same sum.
pub(super) fn groups(sums: &[u64], same: &dyn Fn(usize, usize) -> bool) -> Vec<usize> {
    let mut order = (0..sums.len()).list();
    sort_by_key(&mut order, |number| sums[*number]);
    let mut firsts = (0..sums.len()).list();
    let mut from = 0;
    for (at, number) in order.iter().copied().enumerate() {
        if sums[order[from]] != sums[number] {
            from = at;
        }
        let is_first = |other: usize| firsts[other] == other && same(other, number);
        if let Some(first) = order[from..at].iter().copied().find(|other| is_first(*other)) {
            firsts[number] = first;
        }
    }
    let (mut groups, mut count) = (Vec::with_capacity(firsts.len()), 0);
    for (number, first) in firsts.into_iter().enumerate() {
        let group = if first == number { count } else { groups[first] };
        count = count.max(group + 1);
        groups.push(group);
    }
    groups
}

/// All values that have an arm, in order.
pub(super) fn values(arms: &[Arm<'_>]) -> Vec<Value> {
    let mut all = Vec::with_capacity(arms.len());
    for (values, _) in arms {
        all.extend(values);
    }
    sort(&mut all);
    all
}

/// Gives a match on the state an arm for all values that it does not name: `dead` takes away arms that do nothing, and who writes after the match
/// what its arms have decided must not take their states for the initial one.
pub(super) fn complete(program: &Program<'_>, state: PlaceId, statement: &mut Statement<'_>) {
    let Statement::Match(place, arms, otherwise) = statement else { return };
    let Type::State(region) = program.places[state.0].ty else { return };
    if *place != state || !otherwise.is_empty() {
        return;
    }
    let mut missing = Vec::new();
    for step in &program.regions[region] {
        missing.push(Value::Step(Some(*step)));
    }
    if !program.full[region] && program.regions.len() > 1 {
        missing.push(Value::Step(None));
    }
    if let Initial::Value(start @ Value::Start(_)) = program.places[state.0].initial {
        missing.push(start);
    }
    let named = values(arms);
    missing.retain(|value| named.binary_search(value).is_err());
    if !missing.is_empty() {
        arms.push((missing, Vec::new()));
    }
}

/// A number that statements that do the same have in common, and few others.
pub(super) fn sum_of_block(statements: &[Statement<'_>]) -> u64 {
    let mut sum = Sum(0);
    sum.block(statements);
    sum.0
}

/// The same of an expression.
pub(super) fn sum_of(expr: &Expr<'_>) -> u64 {
    let mut sum = Sum(0);
    sum.expr(expr);
    sum.0
}

struct Sum(u64);

impl Sum {
    fn add(&mut self, part: usize) {
        self.0 = (self.0.rotate_left(5) ^ part as u64).wrapping_mul(0x517c_c1b7_2722_0a95);
    }

    fn block(&mut self, statements: &[Statement<'_>]) {
        self.add(statements.len());
        for statement in statements {
            match statement {
                Statement::Part(_, body) | Statement::Loop { body, .. } => self.block(body),
                Statement::Set(place, value) => {
                    self.add(place.0);
                    self.expr(value);
                }
                Statement::If(condition, then, otherwise) => {
                    self.expr(condition);
                    self.block(then);
                    self.block(otherwise);
                }
                Statement::Match(place, arms, otherwise) => {
                    self.add(place.0);
                    for (_, body) in arms {
                        self.block(body);
                    }
                    self.block(otherwise);
                }
                Statement::Run(run) => {
                    for (_, value) in &run.binds {
                        self.expr(value);
                    }
                }
                Statement::Call(action, phase, args) => {
                    self.add(action.index());
                    self.expr(phase);
                    self.all(args);
                }
                Statement::Break | Statement::Mark(_) | Statement::Fence(_) => self.add(1),
            }
        }
    }

    fn all(&mut self, parts: &[Expr<'_>]) {
        self.add(parts.len());
        for part in parts {
            self.expr(part);
        }
    }

    fn expr(&mut self, expr: &Expr<'_>) {
        match expr {
            Expr::Value(value) => self.value(value),
            Expr::Place(place) | Expr::Initial(place) | Expr::Next(place) | Expr::Table(place, _) => self.add(place.0),
            Expr::Is(place, steps) => {
                self.add(place.0);
                for step in steps {
                    self.add(step.index());
                }
            }
            Expr::Input(input) => self.add(input.index()),
            Expr::Now => self.add(1),
            Expr::Not(inner) => {
                self.add(2);
                self.expr(inner);
            }
            Expr::All(parts) | Expr::Any(parts) => self.all(parts),
            Expr::Compare(_, a, b) | Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Since(a, b) | Expr::Period(a, b, _) => {
                self.expr(a);
                self.expr(b);
            }
            Expr::Choose(parts) => self.all(&**parts),
            Expr::User(user) => {
                for (_, value) in &user.binds {
                    self.expr(value);
                }
            }
        }
    }

    fn value(&mut self, value: &Value) {
        match value {
            Value::Step(step) | Value::Start(step) => self.add(step.map_or(0, |step| step.index() + 1)),
            Value::Bool(value) => self.add(usize::from(*value)),
            Value::Ticks(ticks) => self.add(*ticks as usize),
            Value::Int(_) | Value::Phase(_) | Value::Other(_) => self.add(3),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::groups;

    #[test]
    fn what_is_the_same_is_one_group() {
        let all = ["a", "b", "a", "c", "b", "a"];
        let same = |one: usize, other: usize| all[one] == all[other];
        let sums = all.map(|text| u64::from(text.as_bytes()[0]));
        assert_eq!(groups(&sums, &same), [0, 1, 0, 2, 1, 0]);
        // What differs may have the same sum.
        assert_eq!(groups(&[7, 7, 7, 2, 7, 7], &same), [0, 1, 0, 2, 1, 0]);
    }
}
