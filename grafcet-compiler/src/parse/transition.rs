//! What is between the brackets of a transition: `go: x && y => n = 0`.

use proc_macro2::Ident;

use super::{Error, Input, Result, condition, target};
use crate::ast::{Clearing, Condition, Transition};
use crate::diagnostic::Mark;

/// The inside of the brackets; `mark` covers the whole arrow once its end is known.
pub(super) fn parse(mut inside: Input, mark: Mark) -> Result<Transition> {
    if inside.is_empty() {
        return Err(Error::new(mark, "a transition has a condition; for one that is always true write `-[true]->`"));
    }
    let name = name(&mut inside);
    let condition = if inside.eat_word("else") {
        Condition::Else(inside.last())
    } else {
        Condition::Holds(condition::parse(&mut inside, "a condition, such as `true`")?)
    };
    let mut clearing = Vec::new();
    if inside.eat("=>") {
        clearing = self::clearing(&mut inside)?;
    }
    if !inside.is_empty() {
        return Err(match condition {
            Condition::Else(_) => {
                inside.error("`else` has no condition of its own; draw a branch with this condition in front of it")
            }
            Condition::Holds(_) => leftover(&inside),
        });
    }
    Ok(Transition { mark, name, condition, clearing })
}

/// `go:`, but not the beginning of a path.
fn name(inside: &mut Input) -> Option<Ident> {
    let behind = inside.next();
    if inside.word().is_none() || !behind.at(":") || behind.at("::") || behind.at(":=") {
        return None;
    }
    let name = inside.eat_ident();
    inside.eat(":");
    name
}

fn clearing(inside: &mut Input) -> Result<Vec<Clearing>> {
    let mut actions = vec![one_clearing(inside)?];
    while inside.eat(",") {
        actions.push(one_clearing(inside)?);
    }
    Ok(actions)
}

fn one_clearing(inside: &mut Input) -> Result<Clearing> {
    let start = *inside;
    let target = target::parse(inside)?;
    Ok(Clearing { mark: inside.since(&start), target })
}

fn leftover(inside: &Input) -> Error {
    inside.error(if inside.at(",") {
        "conditions are combined with `&&` or `||`, not `,`".to_owned()
    } else if inside.at(":=") {
        "`:=` assigns; a condition compares with `==`".to_owned()
    } else if inside.at(";") {
        "a condition ends with its bracket, without `;`".to_owned()
    } else {
        format!("expected `]` behind the condition, found {}", inside.found())
    })
}
