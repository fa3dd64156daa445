//! What the ways through a cycle of several regions do with their states and times, all that can be: whether each of them tells rightly whether it has moved.

use super::super::super::{Comparison, Expr, PlaceId, Program, Role, Statement, Value};
use super::super::fold::initial;
use super::super::uses::{Effects, sum};
use super::gathered::{find_copied, find_gathered};
use crate::list::List;
use crate::model::Id;
use crate::sorted::Set;

/// What has happened on a way: a bit for each thing.
type Done = u32;

const MOVED: Done = 1;
const SETTLED: Done = 2;

/// So many things can have happened.
const BITS: usize = 31;

/// More of what can have happened than this is not looked at.
const MOST: usize = 256;

/// What is looked at on the ways.
pub(super) struct Watched {
    /// Whether the next cycle would do the same.
    pub(super) settled: PlaceId,
    /// All of them.
    pub(super) regions: Vec<WatchedRegion>,
}

pub(super) struct WatchedRegion {
    pub(super) state: PlaceId,
    /// The time that each way to a step has to begin, if that matters.
    pub(super) since: Option<PlaceId>,
}

/// How the ways of a cycle enter states.
pub(super) struct Entries {
    /// From which states, to which one.
    pub(super) found: Vec<(Vec<Value>, Value)>,
    /// By region: each way that begins the time enters a step.
    pub(super) enters: Vec<bool>,
    /// So many statements tell whether a way has moved.
    pub(super) tells: usize,
}

/// What may have happened on one way, or on several that have met.
#[derive(Clone)]
struct Happened {
    done: Set<Done>,
    /// By region: with which of its states the cycle may have begun; none as soon as it has another one.
    possible: Vec<Option<Vec<bool>>>,
}

struct EntrySearch<'p, 'm> {
    program: &'p Program<'m>,
    watched: &'p Watched,
    /// By region: all its states.
    states: Vec<Vec<Value>>,
    /// Truths by which a way says whether it has settled.
    gathered: Vec<PlaceId>,
    /// Places of which the cycle makes a copy, and the copies.
    copied: Vec<(PlaceId, PlaceId)>,
    entries: Vec<(Vec<Value>, Value)>,
}

impl Entries {
    /// None where a way does not tell whether it has moved, or does not begin the times of what it enters.
    pub(super) fn of(program: &Program<'_>, watched: &Watched) -> Option<Self> {
        let mut gathered = Vec::new();
        let mut open = vec![watched.settled];
        while let Some(place) = open.pop() {
            if gathered.len() > BITS {
                return None;
            }
            find_gathered(program, &program.cycle, place, &mut |of| {
                if !gathered.contains(&of) {
                    gathered.push(of);
                    open.push(of);
                }
            });
        }
        let mut copied = Vec::new();
        find_copied(program, &program.cycle, &[&gathered[..], &[watched.settled]].concat(), &mut copied);
        let states = watched.regions.iter().enumerate().map(|(at, region)| states(program, at, region.state)).list();
        let mut search = EntrySearch { program, watched, states, gathered, copied, entries: Vec::new() };
        if 2 + 2 * watched.regions.len() + search.gathered.len() + search.copied.len() > BITS {
            return None;
        }
        let mut way = Happened { done: Set::new(), possible: Vec::new() };
        // Whatever the last cycle has told, and whatever the copies hold.
        let changed = (0..search.copied.len()).fold(0, |bits, at| bits | search.changed(at));
        way.done.extend([changed, changed | SETTLED]);
        way.possible = search.states.iter().map(|all| Some(vec![true; all.len()])).list();
        search.block(&program.cycle, &mut way)?;
        let told = way.done.iter().all(|done| search.is_told(*done));
        let mut enters = Vec::with_capacity(watched.regions.len());
        for region in 0..watched.regions.len() {
            let (entered, begun) = (EntrySearch::entered(region), EntrySearch::begun(region));
            enters.push(way.done.iter().all(|done| done & begun == 0 || done & entered != 0));
        }
        let is_told = |place: &PlaceId| *place == watched.settled || search.gathered.contains(place);
        let tells = sum(&program.cycle, &|one| {
            usize::from(matches!(one, Statement::Set(place, Expr::Value(_)) if is_told(place)))
        });
        told.then_some(Self { found: search.entries, enters, tells })
    }
}

impl<'m> EntrySearch<'_, 'm> {
    fn entered(region: usize) -> Done {
        1 << (2 + 2 * region)
    }

    fn begun(region: usize) -> Done {
        Self::entered(region) << 1
    }

    fn gathers(&self, place: PlaceId) -> Option<Done> {
        let at = self.gathered.iter().position(|other| *other == place)?;
        Some(1 << (2 + 2 * self.watched.regions.len() + at))
    }

    /// A place may differ from its copy.
    fn changed(&self, at: usize) -> Done {
        1 << (2 + 2 * self.watched.regions.len() + self.gathered.len() + at)
    }

    /// What is written may differ from its copy from here on.
    fn differ(&self, writes: impl Fn(PlaceId) -> bool, way: &mut Happened) {
        for (at, (place, copy)) in self.copied.iter().enumerate() {
            if writes(*place) || writes(*copy) {
                way.each(&|done| vec![done | self.changed(at)]);
            }
        }
    }

    /// Whether a way has told what has happened, and has begun what it has entered.
    fn is_told(&self, done: Done) -> bool {
        let (mut begins, mut some) = (true, false);
        for (at, region) in self.watched.regions.iter().enumerate() {
            let entered = done & Self::entered(at) != 0;
            begins &= !entered || done & Self::begun(at) != 0 || region.since.is_none();
            some |= entered || region.since.is_none();
        }
        let moved = done & MOVED != 0;
        moved != (done & SETTLED != 0) && begins && (some || !moved)
    }

    fn block(&mut self, statements: &[Statement<'m>], way: &mut Happened) -> Option<()> {
        for statement in statements {
            match statement {
                Statement::Part(_, body) => self.block(body, way)?,
                Statement::Set(place, value) => self.set(*place, value, way)?,
                Statement::If(condition, then, otherwise) => {
                    let (mut one, mut other) = (way.clone(), way.clone());
                    self.narrow(condition, true, &mut one);
                    self.narrow(condition, false, &mut other);
                    self.block(then, &mut one)?;
                    self.block(otherwise, &mut other)?;
                    *way = one.met(other);
                }
                Statement::Match(place, arms, otherwise) => {
                    let (mut rest, mut met) = (way.clone(), None::<Happened>);
                    for (values, body) in arms {
                        let mut arm = way.clone();
                        self.keep(*place, &mut arm, &|value| values.contains(&value));
                        // What is told begins as "not settled".
                        if values.iter().all(|value| matches!(value, Value::Start(_))) {
                            arm.done.retain(|done| done & SETTLED == 0);
                        }
                        self.block(body, &mut arm)?;
                        met = Some(met.map_or(arm.clone(), |met| met.met(arm)));
                    }
                    if !arms.is_empty() {
                        self.keep(*place, &mut rest, &|value| !arms.iter().any(|(values, _)| values.contains(&value)));
                    }
                    let has_rest =
                        |at: usize| rest.possible[at].as_ref().is_none_or(|possible| possible.contains(&true));
                    if self.region(*place).is_none_or(has_rest) {
                        self.block(otherwise, &mut rest)?;
                        met = Some(met.map_or(rest.clone(), |met| met.met(rest)));
                    }
                    *way = met?;
                }
                Statement::Loop { .. } | Statement::Break => return None,
                Statement::Run(_) | Statement::Call(..) | Statement::Mark(_) | Statement::Fence(_) => {
                    let writes = Effects::of(statement).writes;
                    let own = |place: &PlaceId| {
                        !matches!(self.program.places[place.0].role, Role::State(_) | Role::Began(_) | Role::Settled)
                    };
                    writes.iter().all(own).then_some(())?;
                    self.differ(|place| writes.contains(&place), way);
                }
            }
            if way.done.len() > MOST {
                return None;
            }
        }
        Some(())
    }

    fn region(&self, state: PlaceId) -> Option<usize> {
        self.watched.regions.iter().position(|region| region.state == state)
    }

    fn keep(&self, place: PlaceId, way: &mut Happened, is_kept: &dyn Fn(Value) -> bool) {
        let Some(at) = self.region(place) else { return };
        let Some(possible) = &mut way.possible[at] else { return };
        let mut left = Vec::new();
        for (possible, value) in possible.iter_mut().zip(&self.states[at]) {
            *possible &= is_kept(*value);
            left.extend(possible.then_some(*value));
        }
        for (other, region) in self.watched.regions.iter().enumerate().filter(|(other, _)| *other != at) {
            if let Some(possible) = &mut way.possible[other] {
                let begins = initial(&self.program.places[region.state.0]);
                for (possible, value) in possible.iter_mut().zip(&self.states[other]).filter(|(possible, _)| **possible)
                {
                    *possible = left.iter().any(|one| self.is_beside(*one, *value, begins));
                }
            }
        }
    }

    /// Whether one region can have this state while another one has that, which begins with the last.
    fn is_beside(&self, one: Value, other: Value, begins: Option<Value>) -> bool {
        match (one, other) {
            (Value::Step(Some(one)), Value::Step(Some(other))) => {
                self.program.beside.contains(one.index(), other.index())
            }
            (Value::Start(_), other) => begins == Some(other),
            (_, Value::Start(_)) => false,
            _ => true,
        }
    }

    /// What a condition says of states that no way has written yet, and of what is gathered.
    fn narrow(&self, condition: &Expr<'m>, holds: bool, way: &mut Happened) {
        match condition {
            Expr::Is(place, steps) => self
                .keep(*place, way, &|value| matches!(value, Value::Step(Some(step)) if steps.contains(&step)) == holds),
            Expr::Place(place) => {
                if let Some(bit) = self.gathers(*place) {
                    way.done.retain(|done| (done & bit != 0) == holds);
                }
            }
            Expr::Not(inner) => self.narrow(inner, !holds, way),
            Expr::All(parts) if holds => parts.iter().for_each(|part| self.narrow(part, true, way)),
            Expr::Any(parts) if !holds => parts.iter().for_each(|part| self.narrow(part, false, way)),
            _ => {}
        }
    }

    fn set(&mut self, place: PlaceId, value: &Expr<'m>, way: &mut Happened) -> Option<()> {
        if place == self.watched.settled {
            return self.tell(value, way);
        }
        let is_copied =
            |(of, copy): &(PlaceId, PlaceId)| *copy == place && matches!(value, Expr::Place(from) if from == of);
        self.differ(|written| written == place, way);
        if let Some(at) = self.copied.iter().position(is_copied) {
            way.each(&|done| vec![done & !self.changed(at)]);
            return Some(());
        }
        if let Some(bit) = self.gathers(place) {
            way.each(&|done| match self.truth(value, done) {
                Some(truth) => vec![with(done, bit, truth)],
                None => vec![done & !bit, done | bit],
            });
            return Some(());
        }
        if let Some(at) = self.region(place) {
            let Expr::Value(to @ Value::Step(step)) = value else { return None };
            let possible = way.possible[at].take()?;
            let from =
                self.states[at].iter().zip(possible).filter(|(_, possible)| *possible).map(|(value, _)| *value).list();
            let entered = if step.is_some() { Self::entered(at) } else { 0 };
            let moves = MOVED | entered;
            // Where it may be there already, another region has to tell.
            let may_rest = from.contains(to);
            way.each(&|done| if may_rest { vec![done, done | moves] } else { vec![done | moves] });
            self.entries.push((from, *to));
            return Some(());
        }
        let since = self.watched.regions.iter().position(|region| region.since == Some(place));
        if let (Some(at), Expr::Now) = (since, value) {
            way.each(&|done| vec![done | Self::begun(at)]);
        }
        Some(())
    }

    /// A way says whether it has settled.
    fn tell(&self, value: &Expr<'m>, way: &mut Happened) -> Option<()> {
        way.done.iter().all(|done| self.truth(value, *done).is_some()).then_some(())?;
        way.each(&|done| vec![with(done, SETTLED, self.truth(value, done) == Some(true))]);
        Some(())
    }

    /// What an expression over gathered truths and copied values comes to.
    fn truth(&self, expr: &Expr<'m>, done: Done) -> Option<bool> {
        Some(match expr {
            Expr::Value(Value::Bool(truth)) => *truth,
            Expr::Place(place) => done & self.gathers(*place)? != 0,
            Expr::Not(inner) => !self.truth(inner, done)?,
            Expr::All(parts) | Expr::Any(parts) => {
                // One that decides is enough.
                let decides = matches!(expr, Expr::Any(_));
                // Each part is looked at once: in a condition of many levels twice would be far too often.
                let mut all = Some(!decides);
                for part in parts {
                    match self.truth(part, done) {
                        Some(truth) if truth == decides => return Some(decides),
                        Some(_) => {}
                        None => all = None,
                    }
                }
                all?
            }
            Expr::Compare(how @ (Comparison::Equal | Comparison::Differs), a, b) => {
                let (Expr::Place(a), Expr::Place(b)) = (&**a, &**b) else { return None };
                let at = self.copied.iter().position(|(of, copy)| [(*of, *copy), (*copy, *of)].contains(&(*a, *b)))?;
                (done & self.changed(at) == 0).then_some(*how == Comparison::Equal)?
            }
            _ => return None,
        })
    }
}

impl Happened {
    fn each(&mut self, new: &dyn Fn(Done) -> Vec<Done>) {
        let mut all = Set::new();
        for done in &*self.done {
            all.extend(new(*done));
        }
        self.done = all;
    }

    fn met(mut self, other: Self) -> Self {
        self.done.extend(other.done.iter().copied());
        for (one, other) in self.possible.iter_mut().zip(other.possible) {
            match (&mut *one, other) {
                (Some(all), Some(more)) => all.iter_mut().zip(more).for_each(|(one, other)| *one |= other),
                _ => *one = None,
            }
        }
        self
    }
}

/// All states of a region; before the first cycle it has one of its own, if any tells that.
fn states(program: &Program<'_>, region: usize, state: PlaceId) -> Vec<Value> {
    let start = initial(&program.places[state.0]);
    let mut all = start.into_iter().filter(|value| matches!(value, Value::Start(_))).list();
    all.extend((!program.full[region]).then_some(Value::Step(None)));
    all.extend(program.regions[region].iter().map(|step| Value::Step(Some(*step))));
    all
}

fn with(done: Done, bit: Done, truth: bool) -> Done {
    if truth { done | bit } else { done & !bit }
}
