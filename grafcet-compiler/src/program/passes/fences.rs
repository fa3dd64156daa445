//! Fences where LLVM would make more of the code than it has to.
//!
//! ```text
//! match state.A1        match state.A1
//!   …             ->      …
//! match state.B1        fence
//!   …                   match state.B1
//! ```
//!
//! - Without one between two dispatches it keeps what the first has found out in registers, and jumps from there into the second: par8 takes
//!   764 bytes and 64.6 instructions so, and 740 and 57.2 with fences.
//! - In a search it would load all inputs beforehand, and copy what steps do into the ways to them. Of several regions the inputs are found once in front of it, and a
//!   fence stands after it: the packer takes 612 bytes so, and 688 without.
//! - Where an evolution of several regions keeps the situation before it to its end, each arm that moves nothing would copy that for the next one: a lift of three floors takes 778 bytes
//!   with a fence in front, and 1032 without.
//! - A cycle that begins with copies of states would have jump tables of words on ARMv6-M, as the copies are asked for at its end.
//! - Where a table tells which step is next, its number would stay in a register for the whole of an evolution: laundry as `grafcet` takes 634 bytes and 36.8
//!   instructions so, and 558 and 35.6 with a fence in front of that and one after the search.
//! - On ARMv6-M a jump table has a word for each step as long as anything after the jump asks for the step that it went by, else a byte: a fence in front of what asks has
//!   it read anew, and plating takes 533 bytes instead of 709. On other processors it saves less, and costs instructions.
//! - The same where a state is asked for once more within what has been found of it (`united`): the packer takes 564 bytes instead of 604.
//! - Where each way ends in a state of its own, LLVM leads it to what that state does: each comparison has two jumps more, and what steps have in common stands there for each of them. With a
//!   fence between a robot's cell of 40 steps takes 1118 bytes on a Cortex-M3 and 33.4 instructions, 1324 and 35.3 without; most others take some per cent less, and two or three
//!   instructions more.
//!   Beside a table of next steps it is so where many ways have none of theirs there, as those of watchdogs: a handling unit takes 493 bytes with a fence in front of it, and 567 without.
//! - After the condition of an emergency stop the inputs that it has looked at would stay in registers, of which ARMv6-M has too few: a kettle with a hopper takes 1020 bytes
//!   with a fence there, and 1148 without.
//! - Where the delays of conditions are followed in front of all else, what they say would stay in a register beside the field: a burner takes 824 bytes with a fence after them, and 886
//!   without, on ARMv6-M 848 and 920.
//! - Under `optimize size;` the fences of one region are there on all processors for few steps, too, and where a table tells which step is next, and one in front of the table of a
//!   sequence and after it: a robot with watchdogs takes 424 bytes instead of 522 on a Cortex-M3, and 27.2 instructions instead of 23.4.
//! - In a cycle of several regions that keeps the reading of the clock the argument would be in the last of four registers that LLVM uses before it saves one, and that short
//!   instructions name, and all that is done in others: the clock is asked of its field, behind a fence (two branches within one of two take 406 bytes on a Cortex-M3 so, and 504 without; on ARMv6-M it costs four).
//! - Four neighbours that are written together become a call of `memset` on a processor without unaligned stores.

use std::cell::Cell;

use super::super::{Expr, Fence, PlaceId, Program, Role, Statement, Type};
use super::edits::{rename, replaced, rewrite};
use super::tables::goes_by_table;
use super::uses::{Effects, blocks, each_read, is_written_in};

/// With fewer steps the code is smaller where the inputs are found once for all evolutions.
const FEW: usize = 3;

/// Up to so many steps LLVM copies what they do into the evolution in front of it.
const SHORT: usize = 24;

/// From so many steps on, each with ways of its own, it keeps too much in registers, and makes too many jumps.
const WIDE: usize = 12;

/// Of so many ways beside a table of next steps, each in a state of its own, LLVM leads too many to what that does.
const WAYS: usize = 8;

/// From so many steps on a jump table of words is worth a fence.
const LONG: usize = 10;

/// From so many arms on a match may become a jump table.
const TABLE: usize = 4;

/// Neighbours that LLVM writes one by one.
const NEIGHBOURS: usize = 3;

pub(super) fn pass(program: &mut Program<'_>) {
    delays(program);
    if program.regions.len() < 2 {
        match program.cycle.iter().position(is_search) {
            Some(at) => search(program, at),
            None => scan(program),
        }
        return;
    }
    let mut cycle = std::mem::take(&mut program.cycle);
    block(program, &mut cycle, None);
    let copies = cycle.iter().take_while(|one| copies_state(program, one)).count();
    if copies > 1 {
        cycle.insert(copies, Statement::Fence(Fence::Armv6m));
    }
    clock(program, &mut cycle);
    if let Some(Statement::Loop { body, .. }) = cycle.iter_mut().find(|one| is_search(one)) {
        evolution(program, body);
    }
    if let (Some(at), false) = (cycle.iter().position(is_search), program.model.inputs.is_empty()) {
        cycle.insert(at + 1, Statement::Fence(Fence::Memory));
        cycle.insert(at, Statement::Fence(Fence::Inputs));
    }
    program.cycle = cycle;
}

/// What the delays of conditions say is found anew after them, as they are followed in front of all else.
fn delays(program: &mut Program<'_>) {
    let is_own = |place: &PlaceId| matches!(program.places[place.0].role, Role::DelayStage(_) | Role::DelayBegan(_));
    let (mut front, mut passed) = (0, Effects::default());
    for at in 0..program.cycle.len() {
        let effects = Effects::of(&program.cycle[at]);
        let follows = !effects.writes.is_empty() && effects.writes.iter().all(is_own);
        if follows && effects.may_swap(&passed) {
            let delay = program.cycle.remove(at);
            program.cycle.insert(front, delay);
            front += 1;
        } else {
            passed.join(&effects);
        }
    }
    if front > 0 {
        program.cycle.insert(front, Statement::Fence(Fence::Memory));
    }
}

/// In one evolution the clock is asked of the field that has got its reading.
fn clock<'m>(program: &Program<'m>, cycle: &mut Vec<Statement<'m>>) {
    let Some(reading) = program.place(Role::Reading).filter(|place| program.places[place.0].is_field) else { return };
    let is_kept = |one: &Statement<'m>| matches!(one, Statement::Set(place, Expr::Now) if *place == reading);
    let Some(at) = cycle.iter().position(is_kept).filter(|_| !cycle.iter().any(is_search)) else { return };
    if is_written_in(&cycle[at + 1..], reading) {
        return;
    }
    let is_asked = Cell::new(false);
    let leaf = |leaf: &Expr<'m>| {
        let is_now = matches!(leaf, Expr::Now);
        is_asked.set(is_asked.get() || is_now);
        is_now.then_some(Expr::Place(reading))
    };
    rewrite(&mut cycle[at + 1..], &mut |expr| replaced(expr, &leaf));
    if is_asked.get() {
        cycle.insert(at + 1, Statement::Fence(Fence::BeyondArmv6m));
    }
}

fn is_search(statement: &Statement<'_>) -> bool {
    matches!(statement, Statement::Loop { rounds: 2.., .. })
}

/// The one evolution of an `sfc` of one region, by a table or with what each step does after it.
fn scan(program: &mut Program<'_>) {
    let Some(state) = program.place(Role::State(0)).filter(|_| program.regions.iter().flatten().count() >= LONG) else {
        return;
    };
    let is_small = program.model.optimize_size;
    if is_small {
        anew(program, state);
    }
    let is_by_state = |one: &Statement<'_>| matches!(one, Statement::Match(of, ..) if *of == state);
    let (first, last) = (program.cycle.iter().position(is_by_state), program.cycle.iter().rposition(is_by_state));
    let (Some(first), Some(last)) = (first, last) else { return };
    let table = program.cycle.iter().position(goes_on_by_table);
    let is_wide = match table {
        Some(at) => ends_in(&program.cycle[..at], state) >= WAYS,
        None => program.regions[0].len() >= WIDE,
    };
    let fence = Statement::Fence(if is_small || is_wide { Fence::Memory } else { Fence::Armv6m });
    match table {
        Some(at) => program.cycle.insert(at, fence),
        None if first < last => {
            // Tables of numbers ask for the state, too.
            let is_table = |one: &&Statement<'_>| matches!(one, Statement::Set(_, Expr::Table(..)));
            let tables = program.cycle[..last].iter().rev().take_while(is_table).count();
            program.cycle.insert(last - tables, fence);
        }
        None => {}
    }
}

/// How many ways end in a state of their own.
fn ends_in(statements: &[Statement<'_>], state: PlaceId) -> usize {
    let ways = |one: &Statement<'_>| match one {
        Statement::Set(place, Expr::Value(_)) => usize::from(*place == state),
        other => blocks(other).into_iter().map(|block| ends_in(block, state)).sum(),
    };
    statements.iter().map(ways).sum()
}

/// What the steps of a sequence do asks after its table for the state as it is stored, and so does the table. Where LLVM computes what is next it would else go from each step
/// to what the next one does.
fn anew(program: &mut Program<'_>, state: PlaceId) {
    let is_state = |place: &PlaceId| matches!(program.places[place.0].ty, Type::State(_));
    let mut found = None;
    for (at, statement) in program.cycle.iter().enumerate() {
        let Statement::Loop { rounds: 1, body } = statement else { continue };
        for one in body {
            if let Statement::Set(after, Expr::Table(..)) = one {
                found = found.or(Some((at, *after)).filter(|_| is_state(after)));
            }
        }
    }
    let Some((at, after)) = found else { return };
    let acts = |one: &Statement<'_>| matches!(one, Statement::Match(of, ..) if *of == after);
    if !program.cycle[at..].iter().any(acts) || is_written_in(&program.cycle[at + 1..], after) {
        return;
    }
    rename(&mut program.cycle, after, state);
    let itself = |one: &Statement<'_>| matches!(one, Statement::Set(to, Expr::Place(from)) if to == from);
    if let Statement::Loop { body, .. } = &mut program.cycle[at] {
        body.retain(|one| !itself(one));
        before_table(body, state, state);
    }
    program.cycle.insert(at + 1, Statement::Fence(Fence::Memory));
    program.cycle.retain(|one| !itself(one));
}

/// In front of what is next after each step, where the steps are told apart by a match on their place and not by kind: what is stored is asked anew.
fn before_table(body: &mut Vec<Statement<'_>>, asked: PlaceId, state: PlaceId) {
    let mut by_state = false;
    for (at, one) in body.iter_mut().enumerate() {
        match one {
            Statement::Match(of, ..) => by_state |= *of == asked,
            Statement::Set(to, Expr::Table(of, _)) if by_state && *to == asked => {
                *of = state;
                body.insert(at, Statement::Fence(Fence::Memory));
                return;
            }
            _ => {}
        }
    }
}

/// Whether a table tells which step is next, where the evolution goes on.
fn goes_on_by_table(statement: &Statement<'_>) -> bool {
    matches!(statement, Statement::If(_, then, _) if goes_by_table(then))
}

/// The search over the steps of one region.
fn search(program: &mut Program<'_>, at: usize) {
    let steps = program.regions.iter().flatten().count();
    let (Some(state), false) = (program.place(Role::State(0)), program.model.inputs.is_empty()) else { return };
    let is_small = program.model.optimize_size;
    // Tests that a table finds keep their one register.
    let is_by_kind = program.places.iter().any(|place| matches!(place.ty, Type::Kind { .. }));
    let Statement::Loop { body, .. } = &mut program.cycle[at] else { return };
    let table = body.iter().position(goes_on_by_table);
    if let Some(table) = table {
        from_field(&mut body[table], state);
        body.insert(table, Statement::Fence(Fence::Memory));
    }
    let asked = body.iter().find_map(|one| if let Statement::Match(of, ..) = one { Some(*of) } else { None });
    if let (Some(asked), true) = (asked, is_small) {
        before_table(body, asked, state);
    }
    let is_inside = steps >= FEW && (!goes_by_table(body) || is_by_kind);
    if is_inside {
        if !is_by_kind {
            let is_wide = table.is_none() && (steps >= WIDE || is_small && steps >= LONG);
            body.insert(0, Statement::Fence(if is_wide { Fence::Memory } else { Fence::Armv6m }));
        }
        body.insert(0, Statement::Fence(Fence::Inputs));
    }
    if steps <= SHORT || table.is_some() {
        program.cycle.insert(at + 1, Statement::Fence(Fence::Memory));
    }
    if !is_inside {
        program.cycle.insert(at, Statement::Fence(Fence::Inputs));
    }
}

/// What is next is looked up by the step as it is stored.
fn from_field(statement: &mut Statement<'_>, state: PlaceId) {
    let Statement::If(_, then, _) = statement else { return };
    for one in then {
        if let Statement::Set(_, Expr::Table(of, _)) = one {
            *of = state;
        }
    }
}

/// In an evolution of several regions whatever is kept to its end, as the situation before it, is in a register beside the new state, and each arm that moves nothing
/// would copy the one to the other for the next evolution: that finds the state anew.
fn evolution<'m>(program: &Program<'m>, body: &mut Vec<Statement<'m>>) {
    let sets = body.iter().take_while(|one| matches!(one, Statement::Set(..))).count();
    // One local says whether something moves.
    if sets < 2 {
        return;
    }
    let is_long = first_dispatch(program, &body[sets..]).is_some_and(|steps| steps >= LONG);
    let fence = match (body[..sets].iter().any(|one| copies_state(program, one)), is_long) {
        (true, true) => Fence::Memory,
        (true, false) => Fence::Armv6m,
        (false, true) => Fence::BeyondArmv6m,
        (false, false) => return,
    };
    body.insert(0, Statement::Fence(fence));
}

/// How many steps the region has on which the first match is.
fn first_dispatch(program: &Program<'_>, statements: &[Statement<'_>]) -> Option<usize> {
    statements.iter().find_map(|statement| match statement {
        Statement::Match(place, ..) => match program.places[place.0].role {
            Role::State(region) => Some(program.regions[region].len()),
            _ => None,
        },
        Statement::If(_, then, otherwise) => {
            first_dispatch(program, otherwise).or_else(|| first_dispatch(program, then))
        }
        _ => None,
    })
}

/// Whether the state of several regions, which has been asked for, is asked for once more by what may become a jump table.
fn asks_again(program: &Program<'_>, around: &[PlaceId], statement: &Statement<'_>) -> bool {
    let Statement::Match(place, arms, _) = statement else { return false };
    let is_united = program.united.iter().any(|one| program.place(Role::State(one.regions[0])) == Some(*place));
    is_united && arms.len() >= TABLE && around.contains(place)
}

/// Inputs alone decide that a state is entered, as where an `any` leaves parallel branches.
fn is_stop(program: &Program<'_>, condition: &Expr<'_>, then: &[Statement<'_>]) -> bool {
    let mut asks = false;
    each_read(condition, &mut |_| asks = true);
    let moves = |one: &Statement<'_>| matches!(one, Statement::Set(place, _) if is_state(program, *place));
    !asks && then.iter().any(moves)
}

fn dispatches(program: &Program<'_>, statements: &[Statement<'_>]) -> bool {
    let by_state = |one: &Statement<'_>| matches!(one, Statement::Match(place, ..) if is_state(program, *place));
    statements.iter().any(by_state)
}

fn copies_state(program: &Program<'_>, statement: &Statement<'_>) -> bool {
    matches!(statement, Statement::Set(to, Expr::Place(of)) if is_state(program, *of) && !program.places[to.0].is_field)
}

fn is_state(program: &Program<'_>, place: PlaceId) -> bool {
    matches!(program.places[place.0].role, Role::State(_))
}

/// In a search, within matches on some places.
fn block<'m>(program: &Program<'m>, statements: &mut Vec<Statement<'m>>, within: Option<&[PlaceId]>) {
    let mut all: Vec<Statement<'m>> = Vec::with_capacity(statements.len());
    let mut neighbours = 0;
    for mut statement in statements.drain(..) {
        match &mut statement {
            Statement::Part(_, body) => block(program, body, within),
            Statement::Loop { body, .. } => block(program, body, within.or(Some(&[]))),
            Statement::If(condition, then, otherwise) => {
                block(program, then, within);
                block(program, otherwise, within);
                if within.is_none() && is_stop(program, condition, then) && dispatches(program, otherwise) {
                    otherwise.insert(0, Statement::Fence(Fence::Armv6m));
                }
            }
            Statement::Match(place, arms, otherwise) => {
                let within = within.map(|around| [around, &[*place]].concat());
                for (_, body) in arms {
                    block(program, body, within.as_deref());
                }
                block(program, otherwise, within.as_deref());
            }
            _ => {}
        }
        let is_state = |statement: &Statement<'m>| match statement {
            Statement::Set(place, _) => matches!(program.places[place.0].role, Role::State(_)),
            _ => false,
        };
        neighbours = if is_state(&statement) { neighbours + 1 } else { 0 };
        // Their time, known in front of the second one, is found between them, and so is whether a step rises for which it waits.
        let is_found =
            |one: &Statement<'m>| matches!(one, Statement::Set(_, Expr::Since(..) | Expr::Is(..) | Expr::Place(_)));
        let front = all.len() - all.iter().rev().take_while(|one| is_found(one)).count();
        let dispatches = matches!((all[..front].last(), &statement), (Some(Statement::Match(one, ..)), Statement::Match(other, ..)) if one != other);
        if dispatches {
            all.insert(front, Statement::Fence(Fence::Memory));
        } else if neighbours > NEIGHBOURS {
            all.push(Statement::Fence(Fence::Memory));
            neighbours = 1;
        } else if within.is_some_and(|around| asks_again(program, around, &statement)) {
            all.push(Statement::Fence(Fence::Armv6m));
        }
        all.push(statement);
    }
    *statements = all;
}
