//! Which association acted last is asked where it makes a difference, and no more.
//!
//! ```text
//! match acted.beep              call beep() final
//!   0: call beep() final
//!   1: call beep() final   ->
//!   4: call beep() final
//! ```
//!
//! A call that several associations hold up has the arguments of the one that acted last. What is the same for all of them needs no match, and what is the same for most of
//! them is what the match does otherwise. It is only looked at where one of them has acted.

use super::super::{Program, Role, Statement};
use super::edits::blocks_mut;
use super::share::merged;

pub(super) fn pass(program: &mut Program<'_>) {
    let mut is_number = Vec::with_capacity(program.places.len());
    for place in &program.places {
        is_number.push(matches!(place.role, Role::Acted(_)));
    }
    for cycle in program.cycles_mut() {
        block(cycle, &is_number);
    }
}

fn block(statements: &mut Vec<Statement<'_>>, is_number: &[bool]) {
    let mut all = Vec::with_capacity(statements.len());
    for mut statement in statements.drain(..) {
        for inner in blocks_mut(&mut statement) {
            block(inner, is_number);
        }
        match statement {
            Statement::Match(place, arms, otherwise) if is_number[place.0] && otherwise.is_empty() => {
                let mut arms = merged(arms);
                let most = (0..arms.len()).max_by_key(|at| arms[*at].0.len());
                let otherwise = most.map_or_else(Vec::new, |most| arms.remove(most).1);
                if arms.is_empty() {
                    all.extend(otherwise);
                } else {
                    all.push(Statement::Match(place, arms, otherwise));
                }
            }
            other => all.push(other),
        }
    }
    *statements = all;
}
