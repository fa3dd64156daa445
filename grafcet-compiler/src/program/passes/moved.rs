//! Whether the cycle has moved is told by the state that it began with, and what all ways to another state do is done after them.
//!
//! ```text
//! match state                                   was = state
//!   Green:                                      before = state
//!     if 10s are over:                          match state
//!       state = Yellow                    ->      Green:
//!       since = now                                 if 10s are over: state = Yellow
//!       settled = false                           …
//!     else: settled = true                      if was != state: since = now
//! at reading if !settled                        at since if before != state
//! ```
//!
//! A time that is counted is set to zero there, and the reading of the clock is kept.
//!
//! So no way stores that nothing has happened, and no cycle the reading of its clock where the time is one. What is over while its step stays active is marked there, by a
//! value that no cycle begins with but the first.
//!
//! A way that stays may leave something else to the next cycle, as an edge in an action: where it does, it tells so by the value of a state that it did not begin with.
//!
//! Needs: the deadline asks whether the last cycle has moved, and nothing else asks that; each way that has moved begins the time anew, and no other.

use super::super::build::{all, compare, not, zero};
use super::super::{Comparison, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::dead::read_after;
use super::edits::replaced;
use super::engine::{End, Fact, Leaf, Tree};
use super::live::{Live, Places};
use super::uses::{Effects, is_read_in};
use crate::model::StepId;

/// What one cycle does from each state that it may begin with.
pub(super) struct Forest<'w, 'm> {
    pub(super) state: PlaceId,
    /// By point: the state before, the first cycle first.
    pub(super) points: &'w [Value],
    pub(super) fields: &'w [PlaceId],
    pub(super) trees: &'w mut [Option<Tree<'m>>],
}

/// The time of the active step.
#[derive(Clone, Copy)]
struct RegionTime {
    place: PlaceId,
    /// It is what has passed, not the reading at which it began.
    is_counted: bool,
}

impl RegionTime {
    fn of(program: &Program<'_>) -> Option<Self> {
        let of = |role, is_counted| program.place(role).map(|place| Self { place, is_counted });
        of(Role::Began(0), false).or_else(|| of(Role::Time(0), true))
    }

    fn begin<'m>(self) -> Statement<'m> {
        Statement::Set(self.place, if self.is_counted { zero() } else { Expr::Now })
    }

    /// Whether a way begins it, or it is known to have just begun, as in the first cycle.
    fn is_begun(self, leaf: &Leaf<'_>, fields: &[PlaceId]) -> bool {
        let at = fields.iter().position(|field| *field == self.place).filter(|_| self.is_counted);
        let is_new = at.is_some_and(|at| leaf.facts.get(at) == Some(&Fact::Is(Value::Ticks(0))));
        is_new || leaf.body.iter().any(|one| self.is_begin(one))
    }

    /// What is counted before it begins is nothing that anybody looks at.
    fn is_set(self, statement: &Statement<'_>) -> bool {
        matches!(statement, Statement::Set(place, _) if *place == self.place)
    }

    fn is_begin(self, statement: &Statement<'_>) -> bool {
        match statement {
            Statement::Set(place, Expr::Now) => *place == self.place && !self.is_counted,
            Statement::Set(place, Expr::Value(Value::Ticks(0))) => *place == self.place && self.is_counted,
            _ => false,
        }
    }
}

/// What is done in front of the ways, and after them.
pub(super) type Around<'m> = [Vec<Statement<'m>>; 2];

pub(super) fn pass<'m>(program: &mut Program<'m>, forest: &mut Forest<'_, 'm>) -> Around<'m> {
    let nothing = [Vec::new(), Vec::new()];
    let (Some(settled), Some(time)) = (program.place(Role::Settled), RegionTime::of(program)) else { return nothing };
    let passed = program.place(Role::Passed(0));
    let Some(at) = forest.fields.iter().position(|field| *field == settled) else { return nothing };
    let mut moved = Moved {
        state: forest.state,
        settled,
        time,
        passed,
        at,
        mark: forest.points[0],
        over: Vec::new(),
        is_first_other: false,
        is_unsure: false,
    };
    if !moved.is_told(forest) {
        return begun_after(program, forest, time);
    }
    moved.over = moved.outlasted(forest);
    let begun = moved.begins(program, forest);
    // A step that no cycle begins with and stays in: of the first cycle, and of a step that is left and entered at once.
    let [one, other, ..] = program.regions[0][..] else { return nothing };
    let other_than = |from: StepId| Value::Step(Some(if from == one { other } else { one }));
    let name = format!("before.{}", program.places[forest.state.0].name);
    let initial = Initial::Value(Value::Step(Some(one)));
    program.places.push(PlaceInfo { name, role: Role::Before, ty: Type::State(0), initial, is_field: true });
    let before = PlaceId(program.places.len() - 1);
    for (point, tree) in forest.trees.iter_mut().enumerate() {
        let from = forest.points[point];
        let Some(tree) = tree else { continue };
        tree.each_leaf_mut(&mut |leaf| {
            let step = if let Value::Step(Some(step)) = leaf.state { step } else { one };
            let is_over = moved.over.contains(&step);
            moved.is_first_other |= point == 0 && !is_over;
            let same = leaf.state == from || point == 0 && is_over;
            moved.tell(leaf, before, same.then(|| other_than(step)), begun && leaf.state != from);
        });
    }
    moved.ask(program, before, begun);
    let (mut front, mut after) = (vec![Statement::Set(before, Expr::Place(forest.state))], Vec::new());
    if begun {
        let [copy, begins] = where_it_differs(program, forest.state, time);
        front.insert(0, copy);
        after.push(begins);
    }
    [front, after]
}

/// The same of the time alone, in a `grafcet` of which each cycle ends settled.
fn begun_after<'m>(program: &mut Program<'m>, forest: &mut Forest<'_, 'm>, time: RegionTime) -> Around<'m> {
    let (mut begins, after) = (true, read_after(program));
    for (tree, from) in forest.trees.iter().zip(forest.points) {
        let Some(tree) = tree else { continue };
        tree.each_leaf(&mut |leaf| {
            begins &= time.is_begun(leaf, forest.fields) == (leaf.state != *from);
            begins &= leaf.state == *from || !asks(&after, leaf, time.place);
        });
    }
    if !begins {
        return Default::default();
    }
    for (tree, from) in forest.trees.iter_mut().zip(forest.points) {
        let Some(tree) = tree else { continue };
        tree.each_leaf_mut(&mut |leaf| leaf.body.retain(|one| leaf.state == *from || !time.is_set(one)));
    }
    let [copy, begins] = where_it_differs(program, forest.state, time);
    [vec![copy], vec![begins]]
}

/// Whether a way asks for a time, other than for what nobody looks at.
fn asks(after: &Places, leaf: &Leaf<'_>, since: PlaceId) -> bool {
    let mut body = leaf.body.clone();
    Live::after(after).sweep(&mut body);
    is_read_in(&body, since)
}

/// A copy of the state in front, and after the beginning of a time where it differs.
fn where_it_differs<'m>(program: &mut Program<'m>, state: PlaceId, time: RegionTime) -> [Statement<'m>; 2] {
    let PlaceInfo { name, initial, .. } = &program.places[state.0];
    let (name, initial) = (format!("was.{name}"), *initial);
    program.places.push(PlaceInfo::local(name, Type::State(0), initial));
    let was = PlaceId(program.places.len() - 1);
    let goes = compare(Comparison::Differs, Expr::Place(was), Expr::Place(state));
    [Statement::Set(was, Expr::Place(state)), Statement::If(goes, vec![time.begin()], Vec::new())]
}

/// What the deadline remembers of the cycle.
struct Moved {
    state: PlaceId,
    settled: PlaceId,
    time: RegionTime,
    passed: Option<PlaceId>,
    /// Where the ways know whether they have settled.
    at: usize,
    /// What stands for a time that is over.
    mark: Value,
    /// The steps that stay active then.
    over: Vec<StepId>,
    /// The first cycle has the same mark, and ends in another step.
    is_first_other: bool,
    /// A way that stays may leave something to the next cycle, or not.
    is_unsure: bool,
}

impl Moved {
    /// Whether each way to another state leaves something to the next cycle, and each other one tells whether it does; what is over is so
    /// only where nothing has moved.
    fn is_told(&mut self, forest: &Forest<'_, '_>) -> bool {
        let passed = self.passed.and_then(|passed| forest.fields.iter().position(|field| *field == passed));
        let (mut told, mut is_unsure) = (true, false);
        for (tree, from) in forest.trees.iter().zip(forest.points) {
            let Some(tree) = tree else { continue };
            told &= !self.is_written(tree);
            tree.each_leaf(&mut |leaf| {
                let (stays, goes) = (self.has(leaf, true), self.has(leaf, false));
                let is_over = passed.is_some_and(|at| leaf.facts.get(at) != Some(&Fact::Is(Value::Bool(false))));
                let tells = leaf.state == *from && !stays && !goes && leaf.body.iter().any(|one| self.tells(one));
                is_unsure |= tells;
                told &= tells || leaf.state == *from && stays || goes && !is_over;
                let inner = leaf.body.iter().filter(|one| !self.is_own(one));
                told &= inner.clone().all(|one| !self.writes(one));
            });
        }
        self.is_unsure = is_unsure;
        told
    }

    /// Whether it tells whether something is left to the next cycle.
    fn tells(&self, statement: &Statement<'_>) -> bool {
        matches!(statement, Statement::Set(place, _) if *place == self.settled)
    }

    /// The steps in which a time can be over.
    fn outlasted(&self, forest: &mut Forest<'_, '_>) -> Vec<StepId> {
        let mut steps = Vec::new();
        for tree in forest.trees.iter_mut().flatten() {
            tree.each_leaf_mut(&mut |leaf| {
                let is_over = leaf.body.iter().any(|one| self.is_over(one));
                if let (Value::Step(Some(step)), true) = (leaf.state, is_over) {
                    if !steps.contains(&step) {
                        steps.push(step);
                    }
                }
            });
        }
        steps
    }

    fn is_over(&self, statement: &Statement<'_>) -> bool {
        matches!(statement, Statement::Set(place, value)
            if Some(*place) == self.passed && !matches!(value, Expr::Value(Value::Bool(false))))
    }

    /// Whether something of it is written before the end of the ways.
    fn is_written(&self, tree: &Tree<'_>) -> bool {
        tree.body.iter().any(|one| self.writes(one))
            || match &tree.end {
                End::Leaf(_) => false,
                End::Fork(_, ways) => ways.iter().any(|way| self.is_written(way)),
            }
    }

    fn writes(&self, statement: &Statement<'_>) -> bool {
        let writes = Effects::of(statement).writes;
        writes.contains(&self.settled) || self.passed.is_some_and(|passed| writes.contains(&passed))
    }

    fn is_own(&self, statement: &Statement<'_>) -> bool {
        matches!(statement, Statement::Set(place, _) if *place == self.settled || Some(*place) == self.passed)
    }

    /// Whether each way to another state begins the time, and no way that stays does. Nothing on the former asks for it: what does so in front of the beginning means how long
    /// the step was active that is left, and `join` can put it after.
    fn begins(&self, program: &Program<'_>, forest: &Forest<'_, '_>) -> bool {
        let (mut begins, after) = (true, read_after(program));
        for (tree, from) in forest.trees.iter().zip(forest.points) {
            let Some(tree) = tree else { continue };
            tree.each_leaf(&mut |leaf| {
                let goes = leaf.state != *from || self.has(leaf, false);
                begins &= self.time.is_begun(leaf, forest.fields) == goes;
                begins &= !goes || !asks(&after, leaf, self.time.place);
            });
        }
        begins
    }

    /// Whether a way is known to end settled, or not.
    fn has(&self, leaf: &Leaf<'_>, settled: bool) -> bool {
        leaf.facts.get(self.at) == Some(&Fact::Is(Value::Bool(settled)))
    }

    /// At the end of a way: what stands for "the cycle has moved" where the state does not tell, and for a time that is over.
    fn tell(&self, leaf: &mut Leaf<'_>, before: PlaceId, moved: Option<Value>, begun: bool) {
        let goes = self.has(leaf, false);
        let mut body = Vec::with_capacity(leaf.body.len());
        for statement in leaf.body.drain(..) {
            match statement {
                Statement::Set(place, value) if place == self.settled => {
                    if let (Some(moved), false) = (moved, goes || matches!(value, Expr::Value(_))) {
                        let mark = Statement::Set(before, Expr::Value(moved));
                        body.push(Statement::If(not(value), vec![mark], Vec::new()));
                    }
                }
                Statement::Set(place, value) if Some(place) == self.passed => {
                    if !matches!(value, Expr::Value(Value::Bool(false))) {
                        let mark = Statement::Set(before, Expr::Value(self.mark));
                        body.push(Statement::If(value, vec![mark], Vec::new()));
                    }
                }
                statement if begun && self.time.is_set(&statement) => {}
                statement => body.push(statement),
            }
        }
        if let (Some(moved), true) = (moved, goes) {
            body.push(Statement::Set(before, Expr::Value(moved)));
        }
        leaf.body = body;
    }

    /// The deadline asks for the state that the cycle began with.
    fn ask<'m>(&self, program: &mut Program<'m>, before: PlaceId, begun: bool) {
        let Some(deadline) = &mut program.deadline else { return };
        let is_marked = |comparison| compare(comparison, Expr::Place(before), Expr::Value(self.mark));
        let among = Expr::Is(self.state, self.over.clone());
        let is_over = is_marked(Comparison::Equal);
        let is_over = if self.is_first_other { all(vec![is_over, among]) } else { is_over };
        let moved = compare(Comparison::Differs, Expr::Place(before), Expr::Place(self.state));
        let moved = if self.passed.is_some() { all(vec![moved, not(is_over.clone())]) } else { moved };
        let leaf = |expr: &Expr<'m>| match expr {
            Expr::Not(inner) if matches!(**inner, Expr::Place(place) if place == self.settled) => Some(moved.clone()),
            Expr::Place(place) if Some(*place) == self.passed => Some(is_over.clone()),
            _ => None,
        };
        // Where such a state is asked for first, all of them need not stand there once more.
        let known = |expr: &Expr<'m>| match expr {
            Expr::Not(inner) if matches!(**inner, Expr::Place(place) if Some(place) == self.passed) => {
                Some(is_marked(Comparison::Differs))
            }
            Expr::Place(place) if Some(*place) == self.passed => Some(is_marked(Comparison::Equal)),
            _ => None,
        };
        // Where nothing else is due at once, the last cycle has begun the time.
        if begun
            && !self.time.is_counted
            && !self.is_unsure
            && matches!(&deadline.at_once, Expr::Not(inner) if matches!(**inner, Expr::Place(place) if place == self.settled))
        {
            deadline.reading = Expr::Place(self.time.place);
        }
        deadline.at_once = replaced(&deadline.at_once, &leaf);
        for wait in &mut deadline.waits {
            if self.names_over(&wait.condition) {
                wait.condition = replaced(&wait.condition, &known);
            }
            wait.condition = replaced(&wait.condition, &leaf);
        }
    }

    /// Whether a condition asks for states in which a time can be over, and for no others.
    fn names_over(&self, condition: &Expr<'_>) -> bool {
        let Expr::All(parts) = condition else { return false };
        parts.iter().any(|part| {
            matches!(part, Expr::Is(place, steps) if *place == self.state && steps.iter().all(|step| self.over.contains(step)))
        })
    }
}
