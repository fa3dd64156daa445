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

use super::super::build::not;
use super::super::{Deadline, Expr, PlaceId, PlaceInfo, Program, Role, Statement, Write};
use super::uses::{Effects, each_read, is_pure, replaced, rewrite};
use crate::model::Read;
use crate::sorted::Set;

pub(super) fn pass(program: &mut Program<'_>) {
    let mut base = needed(program);
    for (needed, place) in base.iter_mut().zip(&program.places) {
        *needed &= place.is_field || is_seen(place);
    }
    let mut live = Live { base: &base, flips: Set::new(), left: Set::new() };
    live.sweep(&mut program.cycle);
    let flips = live.flips;
    for (index, place) in program.places.iter_mut().enumerate() {
        // Each cycle writes it before something reads it.
        let is_state = matches!(
            place.role,
            Role::State(_) | Role::Bit(_) | Role::Var(_) | Role::Param(_) | Role::Stable | Role::Recorded
        );
        if !is_state
            && base[index]
            && flips.contains(&PlaceId(index))
            && !waits_for(program.deadline.as_ref(), PlaceId(index))
        {
            place.is_field = false;
        }
    }
    drop_places(program);
}

/// Whether somebody outside looks at a place.
pub(super) fn is_seen(place: &PlaceInfo<'_>) -> bool {
    use Role::{Bit, Output, Param, Recorded, Stable, State, Var};
    matches!(place.role, State(_) | Bit(_) | Output(_) | Var(_) | Param(_) | Stable | Recorded)
}

fn waits_for(deadline: Option<&Deadline<'_>>, place: PlaceId) -> bool {
    let mut found = false;
    each_of_deadline(deadline, &mut |read| found |= read == place);
    found
}

fn each_of_deadline(deadline: Option<&Deadline<'_>>, each: &mut dyn FnMut(PlaceId)) {
    let Some(deadline) = deadline else { return };
    each_read(&deadline.at_once, each);
    each(deadline.reading);
    each(deadline.from);
    for (condition, time) in &deadline.waits {
        each_read(condition, each);
        each_read(time, each);
    }
    for (_, over) in &deadline.late {
        each_read(over, each);
    }
}

/// By place: what is seen, or is needed to find out what is seen.
pub(super) fn needed(program: &Program<'_>) -> Vec<bool> {
    let mut uses = Uses { by_target: vec![Vec::new(); program.places.len()], open: Vec::new() };
    uses.block(&program.cycle, &mut Vec::new());
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

/// What is read later on: the places that differ from what is so at the end.
pub(super) struct Live<'l> {
    /// By place: whether it is read after the end, in the next cycle or from outside.
    pub(super) base: &'l [bool],
    pub(super) flips: Set<PlaceId>,
    /// The same where a loop is left.
    pub(super) left: Set<PlaceId>,
}

impl Live<'_> {
    fn is_live(&self, place: PlaceId) -> bool {
        self.base[place.0] != self.flips.contains(&place)
    }

    fn put(&mut self, place: PlaceId, live: bool) {
        if self.base[place.0] == live {
            self.flips.remove(&place);
        } else {
            self.flips.insert(place);
        }
    }

    fn read(&mut self, expr: &Expr<'_>) {
        each_read(expr, &mut |place| self.put(place, true));
    }

    /// Live on one of two ways.
    pub(super) fn or(&mut self, other: &Set<PlaceId>) {
        if self.flips == *other {
            return;
        }
        // Both are in order, and long where a search asks for a thousand transitions.
        let (mut both, mut one, mut two) = (Set::new(), self.flips.iter().peekable(), other.iter().peekable());
        while let Some(place) = one.peek().into_iter().chain(two.peek()).min().map(|place| **place) {
            let in_one = one.next_if(|next| **next == place).is_some();
            let in_two = two.next_if(|next| **next == place).is_some();
            if !self.base[place.0] || in_one && in_two {
                both.insert(place);
            }
        }
        self.flips = both;
    }

    /// From the end to the beginning.
    pub(super) fn sweep(&mut self, statements: &mut Vec<Statement<'_>>) {
        let mut kept = Vec::with_capacity(statements.len());
        while let Some(mut statement) = statements.pop() {
            if self.keep(&mut statement) {
                kept.push(statement);
            }
        }
        kept.reverse();
        *statements = kept;
    }

    /// A round of a loop reads what the one before has written; after the loop is where it is left.
    pub(super) fn rounds(&mut self, body: &mut Vec<Statement<'_>>) {
        let behind = self.flips.clone();
        let outside = std::mem::replace(&mut self.left, behind);
        loop {
            // Of fields it is enough that they may be live.
            self.flips.retain(|place| !self.base[place.0]);
            let at_end = self.flips.clone();
            self.sweep(&mut body.clone());
            self.flips.retain(|place| !self.base[place.0]);
            self.flips.extend(at_end.iter().copied());
            if self.flips == at_end {
                break;
            }
        }
        let at_end = self.flips.clone();
        self.sweep(body);
        self.flips = at_end;
        self.left = outside;
    }

    fn keep(&mut self, statement: &mut Statement<'_>) -> bool {
        match statement {
            Statement::Part(_, body) => {
                self.sweep(body);
                !body.is_empty()
            }
            Statement::Set(place, value) => {
                if matches!(value, Expr::Place(other) if other == place) || !self.is_live(*place) && is_pure(value) {
                    return false;
                }
                self.put(*place, false);
                self.read(value);
                true
            }
            Statement::If(condition, then, otherwise) => {
                let behind = self.flips.clone();
                self.sweep(then);
                let first = std::mem::replace(&mut self.flips, behind);
                self.sweep(otherwise);
                self.or(&first);
                if then.is_empty() && otherwise.is_empty() && is_pure(condition) {
                    return false;
                }
                if then.is_empty() {
                    std::mem::swap(then, otherwise);
                    *condition = not(condition.clone());
                }
                self.read(condition);
                true
            }
            Statement::Match(place, arms, otherwise) => {
                let behind = self.flips.clone();
                self.sweep(otherwise);
                for (_, body) in arms.iter_mut() {
                    let so_far = std::mem::replace(&mut self.flips, behind.clone());
                    self.sweep(body);
                    self.or(&so_far);
                }
                if otherwise.is_empty() {
                    arms.retain(|(_, body)| !body.is_empty());
                }
                self.put(*place, true);
                !(arms.is_empty() && otherwise.is_empty())
            }
            Statement::Run(run) => {
                let idle = run.code.statements.is_some() && run.binds.iter().all(|(_, value)| is_pure(value));
                let wanted =
                    |write: &Write| self.is_live(write.to) || write.noted.is_some_and(|noted| self.is_live(noted));
                if idle && !run.writes.iter().any(wanted) {
                    return false;
                }
                for place in &*Effects::of(statement).reads {
                    self.put(*place, true);
                }
                true
            }
            Statement::Break => {
                self.flips.clone_from(&self.left);
                true
            }
            Statement::Loop { body, .. } => {
                self.rounds(body);
                true
            }
            other => {
                for place in &*Effects::of(other).reads {
                    self.put(*place, true);
                }
                true
            }
        }
    }
}

/// Takes away the places that nothing mentions, and numbers the others anew.
fn drop_places(program: &mut Program<'_>) {
    let mut used = vec![false; program.places.len()];
    let effects = Effects::of_all(&program.cycle);
    for place in effects.reads.iter().chain(effects.writes.iter()) {
        used[place.0] = true;
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
    rewrite(&mut program.cycle, &mut |expr| renumbered(expr, &new));
    renumber(&mut program.cycle, &new);
    if let Some(deadline) = &mut program.deadline {
        deadline.at_once = renumbered(&deadline.at_once, &new);
        deadline.reading = new(deadline.reading);
        deadline.from = new(deadline.from);
        for (condition, time) in &mut deadline.waits {
            *condition = renumbered(condition, &new);
            *time = renumbered(time, &new);
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
        Expr::Initial(place) => Some(Expr::Initial(new(*place))),
        _ => None,
    })
}
