//! While a search goes on, the state is a local.
//!
//! ```text
//! loop                          now.state = state
//!   match state                 loop
//!     Off:                        match now.state
//!       if on: state = On   ->      Off:
//!       else: leave                   if on: now.state = On
//! match state                         else: leave
//!   …                           state = now.state
//!                               match state
//!                                 …
//! ```
//!
//! LLVM does not keep a field in a register where a loop may be left before it is written. What tells that the search was stable is stored beside
//! the state, so that one byte holds both.
//!
//! Needs: one loop of several rounds that reads and writes the state of the only region.

use super::super::build::yes;
use super::super::{Comparison, Expr, PlaceId, PlaceInfo, Program, Role, Statement, Value};
use super::edits::{blocks_mut, remove, rename};
use super::tables::goes_by_table;
use super::uses::{blocks, is_written_in, same, same_statement, writes_to};

/// From so many states on one takes two bytes.
const BYTE: usize = 256;

pub(super) fn pass(program: &mut Program<'_>) {
    let is_search = |one: &Statement<'_>| matches!(one, Statement::Loop { rounds: 2.., .. });
    let Some(at) = program.cycle.iter().position(is_search) else { return };
    let Some(state) = program.place(Role::State(0)).filter(|_| program.regions.len() == 1) else { return };
    let [Statement::Loop { body, .. }, rest @ ..] = &program.cycle[at..] else { return };
    let Some(last) = body.iter().rposition(|one| writes_to(one, state)) else { return };
    if is_written_in(rest, state) {
        return;
    }
    // LLVM copies what the steps do into the ways to them, unless it has to read the state anew. A table leaves it nothing to copy into, but
    // with more states than a byte has its jump tables get larger.
    let as_local = goes_by_table(body) && program.regions[0].len() < BYTE && !program.model.optimize_size;
    let last_renamed = if as_local { program.cycle.len() - 1 } else { at };
    let now = local(program, state);
    rename(&mut program.cycle[at..=last_renamed], state, now);
    let mut stored = vec![Statement::Set(state, Expr::Place(now))];
    let Statement::Loop { body, .. } = &mut program.cycle[at] else { return };
    let mut front = vec![Statement::Set(now, Expr::Place(state))];
    if let Some(stable) = program.places.iter().position(|place| place.role == Role::Stable).map(PlaceId) {
        if falls_last(body, stable) {
            remove(body, &|one| matches!(one, Statement::Set(set, Expr::Value(Value::Bool(true))) if *set == stable));
            stored.push(Statement::Set(stable, yes()));
            front.extend(stored.iter().cloned());
        }
    }
    let after = body.split_off(last + 1);
    if !as_local {
        let counts = |place: PlaceId| program.places[place.0].role == Role::Evolutions;
        bound_after(body, now, &counts);
    }
    body.extend(stored);
    body.extend(after);
    store_where_it_ends(body, now, state);
    let search = program.cycle.split_off(at);
    program.cycle.extend(front);
    program.cycle.extend(search);
}

/// A local that begins as a field does.
fn local(program: &mut Program<'_>, of: PlaceId) -> PlaceId {
    let PlaceInfo { name, ty, initial, .. } = &program.places[of.0];
    let (name, ty, initial) = (format!("now.{name}"), *ty, *initial);
    program.places.push(PlaceInfo::local(name, ty, initial));
    PlaceId(program.places.len() - 1)
}

/// Where a search is stopped by its bound, nobody asks for the local any more: so ways that write nothing else need not look at the bound each for itself, if all ways do.
fn bound_after<'m>(body: &mut Vec<Statement<'m>>, now: PlaceId, counts: &dyn Fn(PlaceId) -> bool) {
    let is_bound = |condition: &Expr<'_>| matches!(condition, Expr::Compare(Comparison::Equal, count, _) if matches!(**count, Expr::Place(place) if counts(place)));
    let Some(Statement::Match(on, arms, otherwise)) = body.last_mut() else { return };
    if *on != now || !otherwise.is_empty() || !arms.iter().all(|(_, arm)| looks(arm, &is_bound)) {
        return;
    }
    let mut found: Vec<&mut Vec<Statement<'m>>> = Vec::new();
    for (_, arm) in arms {
        find_bare(arm, now, &is_bound, &mut found);
    }
    let Some(Statement::If(bound, stop, _)) = found.first().and_then(|block| block.last()) else { return };
    let stopped = Statement::If(bound.clone(), stop.clone(), Vec::new());
    let stops = |one: &Statement<'m>| matches!((one, &stopped), (Statement::If(a, then, _), Statement::If(b, stop, _)) if same(a, b) && then.len() == stop.len() && then.iter().zip(stop).all(|(a, b)| same_statement(a, b)));
    if found.len() < 2 || !found.iter().all(|block| block.last().is_some_and(stops)) {
        return;
    }
    for block in found {
        if let Some(Statement::If(_, _, goes_on)) = block.pop() {
            block.extend(goes_on);
        }
    }
    body.push(stopped);
}

/// Whether each way through statements leaves the loop or looks at the bound.
fn looks(statements: &[Statement<'_>], is_bound: &dyn Fn(&Expr<'_>) -> bool) -> bool {
    statements.iter().any(|statement| match statement {
        Statement::Break => true,
        Statement::If(condition, then, otherwise) => {
            is_bound(condition) && matches!(then.last(), Some(Statement::Break))
                || looks(then, is_bound) && looks(otherwise, is_bound)
        }
        _ => false,
    })
}

/// The blocks that end with a look at the bound after which nothing but the state is written.
fn find_bare<'b, 'm>(
    block: &'b mut Vec<Statement<'m>>,
    now: PlaceId,
    is_bound: &dyn Fn(&Expr<'_>) -> bool,
    found: &mut Vec<&'b mut Vec<Statement<'m>>>,
) {
    let is_bare = match block.last() {
        Some(Statement::If(condition, then, goes_on)) => {
            let only = matches!(&goes_on[..], [Statement::Set(place, _)] if *place == now);
            only && is_bound(condition) && matches!(then.last(), Some(Statement::Break))
        }
        _ => false,
    };
    if is_bare {
        return found.push(block);
    }
    for inner in block.iter_mut().flat_map(blocks_mut) {
        find_bare(inner, now, is_bound, found);
    }
}

/// A way that goes to a step and leaves the loop stores the state itself.
fn store_where_it_ends(statements: &mut Vec<Statement<'_>>, now: PlaceId, state: PlaceId) {
    for block in statements.iter_mut().flat_map(blocks_mut) {
        store_where_it_ends(block, now, state);
    }
    let is_set = |one: &Statement<'_>| matches!(one, Statement::Set(place, _) if *place == now);
    if matches!(statements.last(), Some(Statement::Break)) && statements.iter().any(is_set) {
        statements.insert(statements.len() - 1, Statement::Set(state, Expr::Place(now)));
    }
}

/// A truth that begins as true need not be set to true, if the loop is left where it falls.
fn falls_last(statements: &[Statement<'_>], place: PlaceId) -> bool {
    let mut falls = true;
    for (at, statement) in statements.iter().enumerate() {
        falls &= match statement {
            Statement::Set(set, value) if *set == place => {
                let rises = matches!(value, Expr::Value(Value::Bool(true)));
                rises || matches!(statements.get(at + 1), Some(Statement::Break))
            }
            other => blocks(other).into_iter().all(|block| falls_last(block, place)),
        };
    }
    falls
}
