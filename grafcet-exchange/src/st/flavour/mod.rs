//! The language as single tools have it. A program is made once, in the words of the standard; what a tool writes otherwise is changed in its text.
//!
//! - `words`: the words of expressions
//! - `codesys`, `tia`: the tools

mod codesys;
mod tia;
mod words;

use super::Flavour;
use super::syntax::{Program, Statement};

/// The program as a tool takes it.
pub(super) fn text(program: Program, flavour: Flavour) -> String {
    match flavour {
        Flavour::Iec => program.text(),
        Flavour::Codesys => codesys::text(program),
        Flavour::Tia => tia::text(program),
    }
}

/// The first line of the header says in which language it is.
fn named(header: &mut [String], language: &str) {
    if let Some(first) = header.first_mut() {
        *first = first.replacen("(IEC 61131-3)", language, 1);
    }
}

/// The parts of a body: the heading of each, and what it does.
fn parts(body: &[Statement]) -> Vec<(Option<&str>, &[Statement])> {
    let (mut parts, mut rest) = (Vec::new(), body);
    while let [first, after @ ..] = rest {
        let (heading, part) = match first {
            Statement::Comment(heading) => (Some(heading.as_str()), after),
            Statement::Gap => {
                rest = after;
                continue;
            }
            _ => (None, rest),
        };
        let end = part.iter().position(|one| *one == Statement::Gap).unwrap_or(part.len());
        parts.push((heading, &part[..end]));
        rest = &part[end..];
    }
    parts
}

/// All texts of the statements, each by what it is: the target of an assignment or none, and the text of its value.
fn change(statements: &mut [Statement], change: &dyn Fn(Option<&mut String>, &mut String)) {
    for statement in statements {
        match statement {
            Statement::Assign(target, value) => change(Some(target), value),
            Statement::Call(call) => change(None, call),
            Statement::If(branches, otherwise) => {
                for (condition, then) in branches {
                    change(None, condition);
                    self::change(then, change);
                }
                self::change(otherwise, change);
            }
            Statement::Case(on, arms) => {
                change(None, on);
                for arm in arms {
                    self::change(&mut arm.body, change);
                }
            }
            Statement::Comment(_) | Statement::Gap => {}
        }
    }
}
