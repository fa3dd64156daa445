//! What cost decides and no statement says: who prints a program as Rust asks for it.

use super::uses::sum;
use super::{Expr, Program, Statement, Value};
use crate::sorted::Map;

/// About so many bytes takes a state that is told apart in front of a match, where a table has one for each.
const JUMP: usize = 8;

/// For each step and transition a chart takes so many statements at most, or else they stand on many ways.
const USUAL: usize = 8;

/// Of a chart of more steps and transitions no other program is tried out: that would take the macro too long.
const TRIED: usize = 400;

/// In statements, how long a match is on a state, without its arms.
const MATCH: usize = 9;

impl Program<'_> {
    /// Whether all parts of a condition are asked, whatever the first ones say: of inputs no jump is worth what it saves, but in a loop.
    pub(crate) fn asks_at_once(&self, parts: &[Expr<'_>]) -> bool {
        let is_input = |part: &Expr<'_>| match part {
            Expr::Not(inner) => matches!(**inner, Expr::Input(_)),
            part => matches!(part, Expr::Input(_)),
        };
        let is_loop = |statement: &Statement<'_>| matches!(statement, Statement::Loop { rounds: 2.., .. });
        parts.iter().all(is_input) && !self.cycle.iter().any(is_loop)
    }

    /// Whether the code of a cycle is worth the instructions that its second matches take beside that of another one for the same chart.
    pub(super) fn is_shorter(&self, other: &Self) -> bool {
        let [own, others] = [self, other].map(|program| length(&program.cycle));
        if self.model.optimize_size { own < others } else { 10 * own <= 9 * others }
    }

    fn size_of_chart(&self) -> usize {
        self.model.steps.len() + self.model.transitions.len()
    }

    /// Whether it takes little time to try another program for its chart.
    pub(super) fn is_short(&self) -> bool {
        self.size_of_chart() <= TRIED
    }

    /// Whether the code of a cycle is longer than a chart of its size should take.
    pub(super) fn is_long(&self) -> bool {
        length(&self.cycle) > USUAL * self.size_of_chart()
    }

    /// Of a table that is printed as a match, the states that do not lead to the one after them in `states`. Under `optimize size;` LLVM computes
    /// the next state where all arms of a match go on in that order, so the few jumps that a sequence has are told apart in front of it.
    pub(crate) fn jumps(&self, states: &[Value], table: &Map<Value, Value>) -> Option<Vec<(Value, Value)>> {
        if !self.model.optimize_size {
            return None;
        }
        let mut jumps = Vec::new();
        for (index, from) in states.iter().enumerate() {
            let to = *table.get(from).unwrap_or(from);
            if to != *states.get(index + 1).unwrap_or(from) {
                jumps.push((*from, to));
            }
        }
        (JUMP * jumps.len() <= states.len()).then_some(jumps)
    }
}

/// About how long the code of statements is, in statements that set a place.
fn length(statements: &[Statement<'_>]) -> usize {
    sum(statements, &|statement| match statement {
        Statement::If(condition, ..) => questions(condition),
        Statement::Part(..) | Statement::Loop { .. } => 0,
        Statement::Match(..) => MATCH,
        _ => 1,
    })
}

/// How many things a condition asks for.
pub(super) fn questions(condition: &Expr<'_>) -> usize {
    match condition {
        Expr::Not(inner) => questions(inner),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().map(questions).sum(),
        _ => 1,
    }
}
