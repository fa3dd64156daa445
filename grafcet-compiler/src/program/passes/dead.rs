//! What nobody looks at: values that are overwritten or never read, and the places that are left without a use.
//!
//! ```text
//! was.state = state
//! state = none              ->      state = B
//! state = B
//! ```
//!
//! Seen from outside are the situation, outputs, variables, parameters, whether the search was stable, and what the deadline reads.
//! An expression that may answer differently each time is asked all the same.

use super::super::{Deadline, Expr, PlaceId, PlaceInfo, Program, Role, Statement};
use super::edits::{replaced, rewrite};
use super::live::{Live, Places};
use super::uses::{Effects, each_asked, each_read, each_written, is_pure};
use crate::model::Read;

pub(super) fn pass(program: &mut Program<'_>) {
    let base = read_after(program);
    let mut begins = Places::of(&[]);
    for cycle in program.cycles_mut() {
        let mut live = Live::after(&base);
        live.sweep(cycle);
        begins.join(&live.now);
    }
    for (index, place) in program.places.iter_mut().enumerate() {
        // Each cycle writes it before something reads it.
        let is_state =
            matches!(place.role, Role::State(_) | Role::Var(_) | Role::Param(_) | Role::Stable | Role::Recorded);
        if !is_state
            && base.contains(PlaceId(index))
            && !begins.contains(PlaceId(index))
            && !waits_for(program.deadline.as_ref(), PlaceId(index))
        {
            place.is_field = false;
        }
    }
    drop_places(program);
}

/// Whether somebody outside looks at a place.
pub(super) fn is_seen(place: &PlaceInfo<'_>) -> bool {
    use Role::{Output, Param, Recorded, Stable, State, Var};
    matches!(place.role, State(_) | Output(_) | Var(_) | Param(_) | Stable | Recorded)
}

fn waits_for(deadline: Option<&Deadline<'_>>, place: PlaceId) -> bool {
    let mut found = false;
    each_of_deadline(deadline, &mut |read| found |= read == place);
    found
}

fn each_of_deadline(deadline: Option<&Deadline<'_>>, each: &mut dyn FnMut(PlaceId)) {
    let Some(deadline) = deadline else { return };
    deadline.waits.iter().for_each(|wait| each(wait.from));
    deadline.asks().for_each(|expr| each_read(expr, each));
    for (_, over) in &deadline.late {
        each_read(over, each);
    }
}

/// What is read after the end of the cycle: in the next one or from outside.
pub(super) fn read_after(program: &Program<'_>) -> Places {
    let mut after = needed(program);
    for (needed, place) in after.iter_mut().zip(&program.places) {
        *needed &= place.is_field || is_seen(place);
    }
    Places::of(&after)
}

/// By place: what is seen, or is needed to find out what is seen.
fn needed(program: &Program<'_>) -> Vec<bool> {
    let mut uses = Uses { by_target: vec![Vec::new(); program.places.len()], open: Vec::new() };
    for cycle in program.cycles() {
        uses.block(cycle, &mut Vec::new());
    }
    each_of_deadline(program.deadline.as_ref(), &mut |place| uses.open.push(place));
    for (index, place) in program.places.iter().enumerate() {
        if is_seen(place) {
            uses.open.push(PlaceId(index));
        }
    }
    let mut needed = vec![false; program.places.len()];
    while let Some(place) = uses.open.pop() {
        if !std::mem::replace(&mut needed[place.0], true) {
            uses.open.append(&mut uses.by_target[place.0]);
        }
    }
    needed
}

/// What is read for the sake of what.
struct Uses {
    by_target: Vec<Vec<PlaceId>>,
    /// For the sake of what is seen.
    open: Vec<PlaceId>,
}

impl Uses {
    fn block(&mut self, statements: &[Statement<'_>], asked: &mut Vec<PlaceId>) {
        let before = asked.len();
        for statement in statements {
            match statement {
                Statement::Part(_, body) | Statement::Loop { body, .. } => self.block(body, asked),
                Statement::Set(place, value) => {
                    let reads = &mut self.by_target[place.0];
                    reads.extend(asked.iter());
                    each_read(value, &mut |read| reads.push(read));
                    if !is_pure(value) {
                        self.open.extend(asked.iter());
                        each_read(value, &mut |read| self.open.push(read));
                    }
                }
                Statement::If(condition, then, otherwise) => {
                    each_read(condition, &mut |read| asked.push(read));
                    if !is_pure(condition) {
                        self.open.extend(asked.iter());
                    }
                    self.block(then, asked);
                    self.block(otherwise, asked);
                }
                Statement::Match(place, arms, otherwise) => {
                    asked.push(*place);
                    for (_, body) in arms {
                        self.block(body, asked);
                    }
                    self.block(otherwise, asked);
                }
                other => {
                    self.open.extend(asked.iter());
                    self.open.extend(Effects::of(other).reads.iter());
                }
            }
            asked.truncate(before);
        }
    }
}

/// Takes away the places that nothing mentions, and numbers the others anew.
pub(super) fn drop_places(program: &mut Program<'_>) {
    let mut used = vec![false; program.places.len()];
    for cycle in program.cycles() {
        each_asked(cycle, &mut |place| used[place.0] = true);
        each_written(cycle, &mut |place| used[place.0] = true);
    }
    each_of_deadline(program.deadline.as_ref(), &mut |place| used[place.0] = true);
    let (mut numbers, mut next) = (Vec::new(), 0);
    for (place, used) in program.places.iter().zip(&mut used) {
        *used |= is_seen(place);
        numbers.push(PlaceId(next));
        next += usize::from(*used);
    }
    let mut kept = used.iter();
    program.places.retain(|_| kept.next().copied().unwrap_or(true));
    let new = |place: PlaceId| numbers[place.0];
    for cycle in program.cycles_mut() {
        rewrite(cycle, &mut |expr| renumbered(expr, &new));
        renumber(cycle, &new);
    }
    if let Some(deadline) = &mut program.deadline {
        for wait in &mut deadline.waits {
            wait.from = new(wait.from);
        }
        for expr in deadline.asks_mut() {
            *expr = renumbered(expr, &new);
        }
        for (_, over) in &mut deadline.late {
            *over = renumbered(over, &new);
        }
    }
}

fn renumber(statements: &mut [Statement<'_>], new: &dyn Fn(PlaceId) -> PlaceId) {
    for statement in statements {
        match statement {
            Statement::Part(_, body) | Statement::Loop { body, .. } => renumber(body, new),
            Statement::Set(place, _) => *place = new(*place),
            Statement::If(_, then, otherwise) => {
                renumber(then, new);
                renumber(otherwise, new);
            }
            Statement::Match(place, arms, otherwise) => {
                *place = new(*place);
                for (_, body) in arms {
                    renumber(body, new);
                }
                renumber(otherwise, new);
            }
            Statement::Run(run) => {
                let run = &mut **run;
                for (read, value) in &mut run.binds {
                    if run.writes.iter().any(|write| Read::Name(write.name.into()) == *read) {
                        *value = renumbered(value, new);
                    }
                }
                for write in &mut run.writes {
                    write.to = new(write.to);
                    write.noted = write.noted.map(new);
                }
            }
            Statement::Break | Statement::Call(..) | Statement::Mark(_) | Statement::Fence(_) => {}
        }
    }
}

fn renumbered<'m>(expr: &Expr<'m>, new: &dyn Fn(PlaceId) -> PlaceId) -> Expr<'m> {
    replaced(expr, &|leaf| match leaf {
        Expr::Place(place) => Some(Expr::Place(new(*place))),
        Expr::Is(place, steps) => Some(Expr::Is(new(*place), steps.clone())),
        Expr::Next(place) => Some(Expr::Next(new(*place))),
        Expr::Table(place, values) => Some(Expr::Table(new(*place), values.clone())),
        Expr::Initial(place) => Some(Expr::Initial(new(*place))),
        _ => None,
    })
}
