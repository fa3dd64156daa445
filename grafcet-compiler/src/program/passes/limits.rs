//! Whether a time has reached its limit is asked as "not less", if only one asks and acts so.
//!
//! ```text
//! match state                          match state
//!   Fill:                                Fill:
//!     if passed >= 1s: state = Heat  ->    if !(passed < 1s): state = Heat
//! ```
//!
//! LLVM makes more than 999 of at least 1000, which for a Cortex-M3 is no number that stands in a comparison, whereas 1000 is: an instruction less for most
//! limits. Where several ask for different limits and go on alike, LLVM lets them share all of it but the number, for which the usual form is shorter. On ARMv6-M neither
//! number stands in an instruction: there it is printed as it was (`grafcet_core::__has_reached`).

use super::super::build::not;
use super::super::{Comparison, Expr, Program, Statement, Value};
use super::edits::blocks_mut;
use super::many::{groups, sum_of_block};
use super::uses::same_block;

/// From so many on they share what they do.
const SHARED: usize = 3;

pub(super) fn pass(program: &mut Program<'_>) {
    for cycle in program.cycles_mut() {
        let mut asked = Vec::new();
        collect(cycle, &mut asked);
        let mut sums = Vec::with_capacity(asked.len());
        for (then, otherwise) in &asked {
            sums.push(sum_of_block(then).wrapping_mul(31).wrapping_add(sum_of_block(otherwise)));
        }
        let is_same = |one: usize, other: usize| {
            same_block(asked[one].0, asked[other].0) && same_block(asked[one].1, asked[other].1)
        };
        let groups = groups(&sums, &is_same);
        let mut members = vec![0; asked.len()];
        for ((_, otherwise), group) in asked.iter().zip(&groups) {
            // Where nothing is done otherwise, what is done next differs.
            members[*group] += usize::from(!otherwise.is_empty());
        }
        let mut is_alone = groups.iter().map(|group| members[*group] < SHARED);
        rewrite(cycle, &mut is_alone);
    }
}

type Ways<'s, 'm> = (&'s [Statement<'m>], &'s [Statement<'m>]);

/// What is done then and otherwise, of each that asks for a limit, from the outside inwards.
fn collect<'s, 'm>(statements: &'s [Statement<'m>], all: &mut Vec<Ways<'s, 'm>>) {
    for statement in statements {
        match statement {
            Statement::If(condition, then, otherwise) => {
                if asks(condition) {
                    all.push((then, otherwise));
                }
                collect(then, all);
                collect(otherwise, all);
            }
            Statement::Part(_, body) | Statement::Loop { body, .. } => collect(body, all),
            Statement::Match(_, arms, otherwise) => {
                for (_, body) in arms {
                    collect(body, all);
                }
                collect(otherwise, all);
            }
            _ => {}
        }
    }
}

/// In the same order.
fn rewrite(statements: &mut [Statement<'_>], is_alone: &mut dyn Iterator<Item = bool>) {
    for statement in statements {
        if let Statement::If(condition, ..) = statement {
            if asks(condition) && is_alone.next() == Some(true) {
                as_not_less(condition);
            }
        }
        for inner in blocks_mut(statement) {
            rewrite(inner, is_alone);
        }
    }
}

fn asks(condition: &Expr<'_>) -> bool {
    match condition {
        Expr::Compare(Comparison::AtLeast, _, limit) => matches!(**limit, Expr::Value(Value::Ticks(_))),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().any(asks),
        _ => false,
    }
}

fn as_not_less(condition: &mut Expr<'_>) {
    match condition {
        Expr::All(parts) | Expr::Any(parts) => parts.iter_mut().for_each(as_not_less),
        Expr::Compare(comparison @ Comparison::AtLeast, _, limit)
            if matches!(**limit, Expr::Value(Value::Ticks(_))) =>
        {
            *comparison = Comparison::Less;
            let less = std::mem::replace(condition, Expr::Now);
            *condition = not(less);
        }
        _ => {}
    }
}
