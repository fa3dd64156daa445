//! Of several regions, whether the cycle has moved is told by the states that it began with.
//!
//! ```text
//! reading = now                                   before.A = state.A, before.B = state.B, was.A = state.A
//! match state.A                                   match state.A
//!   A1:                                             A1:
//!     if x:                                           if x: state.A = A2
//!       state.A = A2                       ->       else: …
//!       since.A = now                             if was.A != state.A: since.A = now
//!       settled = false
//!     else: settled = true
//!   else: …
//! at reading if !settled                          at since.A if before.A != state.A; at since.B if before.B != state.B
//! ```
//!
//! As `moved` does for one region: no way stores whether something has happened, and no cycle its reading. That a time is over while its step stays active is marked
//! in the state before, by a step from which no transition leads there, or by none. A variable that changes may tell as well, where it does so on ways alone that move a region.
//!
//! Where something else is waited for, the reading is kept, and one comparison at the end of the cycle tells whether it has moved (`compared`).
//!
//! Needs: each region has a time, and nothing is waited for but these; each way tells whether it has moved (`entries`), and begins the time of each region where another
//! step becomes active.

mod compared;
mod entries;
mod gathered;

use entries::{Entries, Watched, WatchedRegion};

use super::super::build::{all, choose, compare, not};
use super::super::{Comparison, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::edits::{blocks_mut, remove, replaced};
use super::fold::initial;
use super::uses::{Effects, has, mentions, reads_from, same};
use crate::model::StepId;

pub(super) fn pass(program: &mut Program<'_>) {
    if !by_states(program) {
        compared::pass(program);
    }
}

/// Whether the states tell, and no cycle keeps its reading.
fn by_states(program: &mut Program<'_>) -> bool {
    let Some(mut before) = Before::of(program) else { return false };
    let Some(entries) = Entries::of(program, &before.watched()) else { return false };
    for region in &mut before.regions {
        if !region.outlasted.is_empty() && region.find_mark(&entries.found, &program.regions[region.number]).is_none() {
            return false;
        }
    }
    let head = before.head(program).filter(|region| entries.enters[*region]);
    before.remember(program);
    let mut cycle = std::mem::take(&mut program.cycle);
    before.tell(&mut cycle);
    if let Some(region) = head {
        before.begin_after(program, &mut cycle, region);
    }
    let copies = before.regions.iter().map(|region| Statement::Set(region.before, Expr::Place(region.state)));
    program.cycle = copies.chain(cycle).collect();
    before.ask(program);
    true
}

/// One region, and what is known of its states.
struct Region {
    number: usize,
    state: PlaceId,
    since: PlaceId,
    passed: Option<PlaceId>,
    /// The steps that stay active when a time is over.
    outlasted: Vec<StepId>,
    /// Holds the state that the cycle began with, as soon as there is one.
    before: PlaceId,
    /// What it holds where a time is over.
    mark: Value,
    /// It can be without an active step.
    can_be_empty: bool,
}

/// What the pass needs.
struct Before {
    settled: PlaceId,
    regions: Vec<Region>,
}

impl Before {
    fn of(program: &Program<'_>) -> Option<Self> {
        let settled = program.place(Role::Settled)?;
        let deadline = program.deadline.as_ref()?;
        let alone =
            matches!(&deadline.at_once, Expr::Not(inner) if matches!(**inner, Expr::Place(place) if place == settled));
        let reading = program.place(Role::Reading).or(program.place(Role::Recorded));
        let counts = deadline.waits.iter().any(|wait| Some(wait.from) == reading);
        if program.regions.len() < 2 || program.forced.is_some() || !alone || counts || !deadline.late.is_empty() {
            return None;
        }
        let mut regions = Vec::new();
        for number in 0..program.regions.len() {
            let (state, since) = (program.place(Role::State(number))?, program.place(Role::Began(number))?);
            let passed = program.place(Role::Passed(number));
            let outlasted = passed.map_or_else(Vec::new, |passed| outlasted(program, state, passed));
            let none = Value::Step(None);
            let empties = |one: &Statement<'_>| matches!(one, Statement::Set(place, Expr::Value(to)) if *place == state && *to == none);
            let can_be_empty = initial(&program.places[state.0]) == Some(none) || has(&program.cycle, &empties);
            regions.push(Region { number, state, since, passed, outlasted, before: state, mark: none, can_be_empty });
        }
        let reads = Effects::of_all(&program.cycle).reads;
        let read = |place: &PlaceId| reads.contains(place);
        let is_read = read(&settled) || regions.iter().filter_map(|region| region.passed.as_ref()).any(read);
        (!is_read).then_some(Self { settled, regions })
    }

    fn watched(&self) -> Watched {
        let region = |one: &Region| WatchedRegion { state: one.state, since: Some(one.since) };
        Watched { settled: self.settled, regions: self.regions.iter().map(region).collect() }
    }

    /// The match on the state of a region in which all is that writes it.
    fn head(&self, program: &Program<'_>) -> Option<usize> {
        let at = program.cycle.iter().position(|one| matches!(one, Statement::Match(..)))?;
        let Statement::Match(place, ..) = &program.cycle[at] else { return None };
        let number = self.regions.iter().position(|region| region.state == *place)?;
        let region = &self.regions[number];
        let outside = |statement: &Statement<'_>| {
            let effects = Effects::of(statement);
            effects.writes.contains(&region.state) || effects.writes.contains(&region.since)
        };
        let elsewhere = program.cycle.iter().enumerate().any(|(other, one)| other != at && outside(one));
        let mut begun = false;
        let asked = asks_after(&program.cycle[at..=at], region.since, &mut begun);
        (!elsewhere && !asked).then_some(number)
    }

    /// A field for each state before.
    fn remember(&mut self, program: &mut Program<'_>) {
        for region in &mut self.regions {
            let info = &program.places[region.state.0];
            let name = format!("before.{}", info.name);
            // Before the first cycle something has moved.
            let initial = match info.initial {
                Initial::Value(Value::Start(_)) => {
                    Initial::Value(Value::Step(program.regions[region.number].first().copied()))
                }
                other => other,
            };
            region.before = PlaceId(program.places.len());
            program.places.push(PlaceInfo { name, role: Role::Before, ty: info.ty, initial, is_field: true });
        }
    }

    /// No way says any more whether it has moved; those on which a time is over mark it.
    fn tell(&self, statements: &mut Vec<Statement<'_>>) {
        let mut all = Vec::with_capacity(statements.len());
        for mut statement in statements.drain(..) {
            for block in blocks_mut(&mut statement) {
                self.tell(block);
            }
            let Statement::Set(place, value) = statement else {
                if let (Some(Statement::If(one, marks, _)), Statement::If(other, then, _)) =
                    (all.last_mut(), &mut statement)
                {
                    let is_mark = |statement: &Statement<'_>| matches!(statement, Statement::Set(place, _) if self.regions.iter().any(|region| region.before == *place));
                    if same(one, other) && marks.len() == 1 && is_mark(&marks[0]) {
                        then.append(marks);
                        all.pop();
                    }
                }
                all.push(statement);
                continue;
            };
            if place == self.settled {
                continue;
            }
            let Some(region) = self.regions.iter().find(|region| region.passed == Some(place)) else {
                all.push(Statement::Set(place, value));
                continue;
            };
            let mark = Statement::Set(region.before, Expr::Value(region.mark));
            match value {
                Expr::Value(Value::Bool(false)) => {}
                Expr::Value(Value::Bool(true)) => all.push(mark),
                value => all.push(Statement::If(value, vec![mark], Vec::new())),
            }
        }
        *statements = all;
    }

    /// The time of a region begins after the match on its state, where that differs then.
    fn begin_after<'m>(&self, program: &mut Program<'m>, cycle: &mut Vec<Statement<'m>>, number: usize) {
        let region = &self.regions[number];
        let is_head = |one: &Statement<'_>| matches!(one, Statement::Match(place, ..) if *place == region.state);
        let Some(at) = cycle.iter().position(is_head) else { return };
        let PlaceInfo { name, initial, .. } = &program.places[region.state.0];
        let (name, initial) = (format!("was.{name}"), *initial);
        let ty = Type::State(region.number);
        program.places.push(PlaceInfo::local(name, ty, initial));
        let was = PlaceId(program.places.len() - 1);
        let is_begin = |one: &Statement<'_>| matches!(one, Statement::Set(place, Expr::Now) if *place == region.since);
        for block in blocks_mut(&mut cycle[at]) {
            remove(block, &is_begin);
        }
        let goes = compare(Comparison::Differs, Expr::Place(was), Expr::Place(region.state));
        let begins = Statement::If(goes, vec![Statement::Set(region.since, Expr::Now)], Vec::new());
        cycle.insert(at + 1, begins);
        cycle.insert(0, Statement::Set(was, Expr::Place(region.state)));
    }

    /// The deadline asks for the states that the cycle began with, and names the time that has begun.
    fn ask<'m>(&self, program: &mut Program<'m>) {
        let Some(deadline) = &mut program.deadline else { return };
        let mut any_moved = Vec::new();
        let mut reading = None;
        for region in self.regions.iter().rev() {
            let moved = region.has_moved();
            let mut entered = vec![moved.clone()];
            if region.can_be_empty {
                let none = Expr::Value(Value::Step(None));
                entered.push(compare(Comparison::Differs, Expr::Place(region.state), none));
            }
            let since = Expr::Place(region.since);
            reading = Some(match reading {
                None => since,
                Some(others) => choose(all(entered), since, others),
            });
            any_moved.insert(0, moved);
        }
        let Some(reading) = reading else { return };
        deadline.reading = reading;
        deadline.at_once = Expr::Any(any_moved);
        let leaf = |expr: &Expr<'m>| match expr {
            Expr::Place(place) => {
                self.regions.iter().find(|region| region.passed == Some(*place)).map(Region::is_marked)
            }
            _ => None,
        };
        for wait in &mut deadline.waits {
            wait.condition = replaced(&wait.condition, &leaf);
        }
    }
}

impl Region {
    /// A step from which no transition leads to one of those that stay active, or no step at all, where they are not entered so.
    fn find_mark(&mut self, entries: &[(Vec<Value>, Value)], steps: &[StepId]) -> Option<()> {
        let leads = |from: Value| {
            let mut found = false;
            for (sources, to) in entries {
                let Value::Step(Some(to)) = to else { continue };
                found |= self.outlasted.contains(to) && sources.contains(&from);
            }
            found
        };
        let free = |step: &&StepId| !self.outlasted.contains(step) && !leads(Value::Step(Some(**step)));
        let step = steps.iter().find(free).copied();
        let none = Value::Step(None);
        let is_none_free = self.can_be_empty && !leads(none);
        self.mark = step.map(|step| Value::Step(Some(step))).or_else(|| is_none_free.then_some(none))?;
        Some(())
    }

    fn is_marked<'m>(&self) -> Expr<'m> {
        compare(Comparison::Equal, Expr::Place(self.before), Expr::Value(self.mark))
    }

    /// Whether the last cycle has begun with another state.
    fn has_moved<'m>(&self) -> Expr<'m> {
        let differs = compare(Comparison::Differs, Expr::Place(self.before), Expr::Place(self.state));
        if self.outlasted.is_empty() {
            return differs;
        }
        let over = all(vec![Expr::Is(self.state, self.outlasted.clone()), self.is_marked()]);
        all(vec![differs, not(over)])
    }
}

/// The steps of a region that are waited for only as long as a time is not over.
fn outlasted(program: &Program<'_>, state: PlaceId, passed: PlaceId) -> Vec<StepId> {
    let mut found = Vec::new();
    for wait in program.deadline.iter().flat_map(|deadline| &deadline.waits) {
        let Expr::All(parts) = &wait.condition else { continue };
        let asks = |part: &Expr<'_>| matches!(part, Expr::Not(inner) if matches!(**inner, Expr::Place(place) if place == passed));
        if parts.iter().any(asks) {
            for part in parts {
                match part {
                    Expr::Is(place, steps) if *place == state => found.extend(steps.iter().copied()),
                    _ => {}
                }
            }
        }
    }
    found
}

/// Whether some way asks for a time after its beginning.
fn asks_after(statements: &[Statement<'_>], since: PlaceId, begun: &mut bool) -> bool {
    let mut asks = false;
    for statement in statements {
        let mut own = |asks_itself: bool, blocks: &[&Vec<Statement<'_>>]| {
            asks |= asks_itself && *begun;
            let before = *begun;
            for block in blocks {
                let mut within = before;
                asks |= asks_after(block, since, &mut within);
                *begun |= within;
            }
        };
        match statement {
            Statement::Set(place, value) => {
                let reads = mentions(value, since);
                own(reads, &[]);
                *begun |= *place == since && matches!(value, Expr::Now);
            }
            Statement::If(condition, then, otherwise) => {
                own(mentions(condition, since), &[then, otherwise]);
            }
            Statement::Match(_, arms, otherwise) => {
                let mut blocks = vec![otherwise];
                for (_, body) in arms {
                    blocks.push(body);
                }
                own(false, &blocks);
            }
            other => own(reads_from(other, since), &[]),
        }
    }
    asks
}
