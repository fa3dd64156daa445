//! What is between the brackets of a transition: `go: x && y => n = 0`.

use proc_macro2::Ident;

use super::input::Turns;
use super::{Error, Input, Result, condition, target};
use crate::ast::{Clearing, Condition, Transition};
use crate::diagnostic::{Mark, Sink};

/// The inside of the brackets; `mark` covers the whole arrow once its end is known. What is refused hides nothing of the rest.
pub(super) fn parse(mut inside: Input, mark: Mark, sink: &mut Sink) -> Transition {
    if inside.is_empty() {
        sink.notation(mark, "a transition has a condition; for one that is always true write `-[true]->`");
        return Transition { mark, name: None, condition: Condition::Broken, clearing: Vec::new() };
    }
    let name = name(&mut inside);
    let condition = condition(&mut inside).unwrap_or_else(|error| {
        error.report(sink);
        Condition::Broken
    });
    // What follows a condition that is refused, in which other arrows may stand: `a ==> b`.
    let mut turns = Turns::default();
    while turns.more(&inside) && !inside.at("=>") {
        match ["==>", "<=>"].into_iter().find_map(|arrow| inside.after(arrow)) {
            Some(after) => inside = after,
            None => _ = inside.bump(),
        }
    }
    let mut clearing = Vec::new();
    if inside.eat("=>") {
        self::clearing(&mut inside, &mut clearing, sink);
    }
    Transition { mark, name, condition, clearing }
}

fn condition(inside: &mut Input) -> Result<Condition> {
    let condition = if inside.eat_word("else") {
        Condition::Else(inside.last())
    } else {
        Condition::Holds(condition::parse(inside, "a condition, such as `true`")?)
    };
    if inside.is_empty() || inside.at("=>") {
        return Ok(condition);
    }
    Err(match condition {
        Condition::Else(_) => {
            inside.error("`else` has no condition of its own; draw a branch with this condition in front of it")
        }
        _ => leftover(inside),
    })
}

/// `go:`, but not the beginning of a path.
fn name(inside: &mut Input) -> Option<Ident> {
    let next = inside.next();
    if inside.word().is_none() || !next.at(":") || next.at("::") || next.at(":=") {
        return None;
    }
    let name = inside.eat_ident();
    inside.eat(":");
    name
}

fn clearing(inside: &mut Input, actions: &mut Vec<Clearing>, sink: &mut Sink) {
    next_clearing(inside, actions, sink);
    while inside.eat(",") {
        next_clearing(inside, actions, sink);
    }
}

/// Up to the next comma: what is refused hides nothing of the others.
fn next_clearing(inside: &mut Input, actions: &mut Vec<Clearing>, sink: &mut Sink) {
    let error = match one_clearing(inside) {
        Ok(action) => {
            actions.push(action);
            (!inside.is_empty() && !inside.at(",")).then(|| leftover(inside))
        }
        Err(error) => Some(error),
    };
    if let Some(error) = error {
        error.report(sink);
        while !inside.at(",") && inside.bump() {}
    }
}

fn one_clearing(inside: &mut Input) -> Result<Clearing> {
    let start = *inside;
    // `level => 3`
    if inside.literal().is_some() {
        return Err(
            inside.error("after `=>` stands an action on clearing, such as `n = 0`; a comparison is written `>=`")
        );
    }
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
        format!("expected `]` after the condition, found {}", inside.found())
    })
}
