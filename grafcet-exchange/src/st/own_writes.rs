//! Blocks: each sees what it has written itself, and otherwise what was there before.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Code, Place, Statement as Rust, Tree};

use super::action::{places, valued};
use super::expr::{At, Kind, Scope, kind_of};
use super::syntax::{Statement, Variable};
use crate::Refused;

/// What a block reads, and writes, under which names.
struct Names {
    /// What it reads as it was before.
    before: BTreeMap<Place, String>,
    /// What it has a copy of, which it writes, too.
    copies: BTreeMap<Place, String>,
}

/// The statements of a block.
pub(super) fn block(
    scope: &mut Scope<'_>,
    code: &Code,
    statements: &[Rust],
    at: &At<'_>,
) -> Result<Vec<Statement>, Refused> {
    let mut names = Names { before: at.before.clone(), copies: BTreeMap::new() };
    let mut done = Vec::new();
    for place in &code.writes {
        let Some(before) = at.before.get(place) else { continue };
        if !scope.shared.contains(place) {
            // Nobody else changes it.
            names.before.remove(place);
        } else if is_open(statements, *place, &mut State::Before) {
            let name = scope.names.own(&format!("{}_own", scope.place(*place)));
            let ty = kind_of(scope.model, (*place).into()).map_or("DINT", |kind| kind.name());
            scope.copies.push(Variable::new(&*name, ty));
            done.push(Statement::assign(&*name, &**before));
            names.copies.insert(*place, name);
        }
    }
    for (place, name) in &names.copies {
        names.before.insert(*place, name.clone());
    }
    done.extend(run(scope, statements, &mut names, at)?);
    Ok(done)
}

fn run(scope: &mut Scope<'_>, statements: &[Rust], names: &mut Names, at: &At<'_>) -> Result<Vec<Statement>, Refused> {
    let mut done = Vec::new();
    for statement in statements {
        match statement {
            Rust::Assign(place, value) => {
                let value = valued(scope, *place, value, &At { before: &names.before, ..*at })?;
                let target = scope.place(*place).to_owned();
                if let Some(copy) = names.copies.get(place) {
                    done.push(Statement::assign(&**copy, value));
                    done.push(Statement::assign(target, &**copy));
                } else {
                    done.push(Statement::assign(target, value));
                    names.before.remove(place);
                }
            }
            Rust::If(condition, then, otherwise) => {
                let condition = scope.tree(condition, &Kind::Bool, &At { before: &names.before, ..*at })?.text;
                let before = names.before.clone();
                let then = run(scope, then, names, at)?;
                let after = std::mem::replace(&mut names.before, before);
                let otherwise = run(scope, otherwise, names, at)?;
                // What both have written, or nobody asks for any more.
                names.before.retain(|place, _| after.contains_key(place));
                done.push(Statement::If(vec![(condition, then)], otherwise));
            }
        }
    }
    Ok(done)
}

/// What a block has done to a place so far.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Before,
    Written,
    Either,
}

/// Whether it reads the place where it may have written it or not.
fn is_open(statements: &[Rust], place: Place, state: &mut State) -> bool {
    let reads = |tree: &Tree, state: State| state == State::Either && places(tree).contains(&place);
    statements.iter().any(|statement| match statement {
        Rust::Assign(at, value) => {
            let open = reads(value, *state);
            if *at == place {
                *state = State::Written;
            }
            open
        }
        Rust::If(condition, then, otherwise) => {
            if reads(condition, *state) {
                return true;
            }
            let [mut one, mut other] = [*state; 2];
            let open = is_open(then, place, &mut one) || is_open(otherwise, place, &mut other);
            *state = if one == other { one } else { State::Either };
            open
        }
    })
}
