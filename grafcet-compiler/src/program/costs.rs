//! What cost decides and no statement says: who prints a program as Rust asks for it.

use super::{Expr, Program, Statement, Value};
use crate::sorted::Map;

/// About so many bytes takes a state that is told apart in front of a match, where a table has one for each.
const JUMP: usize = 8;

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
