//! One match on the state, whose paths end in constant states, and one for what is done in the state after it.
//!
//! ```text
//! clears.Off→On = was.state is Off && on       match state
//! if clears.Off→On: state = none                 start: state = Off
//! if clears.Off→On: state = On           ->      Off:
//! …                                                if on: state = On
//! on.On.0 = state is On                        match state
//! …                                              On: lamp = true
//! ```
//!
//! The cycle is evaluated for each value that the state may have before it (`engine`), and the first cycle is one of them, which costs no
//! field. A condition forks the way where the next state depends on it. What ways to one state have in common at their ends is done
//! after them, by that state (`share`); what depends on how the state was entered stays on the way.
//!
//! With `known`, what fields hold in each state is followed over the cycles, until nothing changes.
//!
//! Needs: the situation is the state of one region; no loop; on each way the next state is known, and it is no first cycle any more.

use super::super::{Arm, Deadline, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::alike;
use super::dead::read_after;
use super::engine::{End, Engine, Excluding, Fact, Lost, Tree, beginning, meet};
use super::flat::{flat, samples_first};
use super::fold::initial;
use super::front;
use super::hoist;
use super::live::Live;
use super::moved;
use super::several::weight;
use super::share;
use super::sparse::{Index, States};
use super::starting;
use super::tail;
use super::told;
use super::uses::{Effects, each_asked, is_read_in, mentions, writes_to};
use crate::model::StepId;
use crate::sorted::Set;

/// More ways from one state than this are too many.
const WAYS: usize = 2_000;

/// With more states than this it is not tried out whether it is shorter that something stands outside: that would take the macro too long.
const TRIED: usize = 100;

pub(super) struct Options {
    /// What fields hold in each state is followed.
    pub(super) known: bool,
    /// What ways to one state have in common is done after them.
    pub(super) join: bool,
    /// An output that each state tells is no field.
    pub(super) told: bool,
    /// The state that the cycle began with tells whether it has moved.
    pub(super) moved: bool,
}

/// What the pass needs.
struct Split {
    state: PlaceId,
    first: PlaceId,
    /// By point: the state before; the first one stands for the first cycle, which begins in `begin`.
    points: States,
    begin: Option<StepId>,
    fields: Vec<PlaceId>,
}

/// What the ways are made of.
struct Source<'s, 'm> {
    list: &'s [Statement<'m>],
    index: &'s Index,
    /// What is false in front of it.
    assumed: &'s [bool],
    /// What comes in front of them, and after them, in any case.
    front: &'s [Statement<'m>],
    tail: &'s [Statement<'m>],
    /// Fields that nobody follows.
    unknown: &'s [PlaceId],
}

pub(super) fn pass(program: &mut Program<'_>, options: &Options) {
    let before = program.places.len();
    let Some((list, index, assumed)) = listed(program) else { return };
    let Some(split) = Split::of(program) else { return };
    let all = beside(program, &split, (&list, &index, &assumed), options, &|_| true);
    if let (Some(other), true) = (&all, split.points.all.len() > TRIED) {
        *program = other.clone();
        return;
    }
    let is_stored = |place: &PlaceInfo<'_>| matches!(place.role, Role::FlipFlop(..));
    let lowered = (all.is_some() || program.places.iter().any(is_stored)).then(|| program.clone());
    let source = Source { list: &list, index: &index, assumed: &assumed, front: &[], tail: &[], unknown: &[] };
    if by_ways(program, &source, options) {
        if let Some(shorter) = lowered.as_ref().and_then(|lowered| stored(lowered, program, &source, options)) {
            *program = shorter;
        }
    } else {
        program.places.truncate(before);
    }
    let (Some(lowered), Some(all)) = (lowered, all) else { return };
    let scattered = tail::scattered(&program.places, &program.cycle);
    let some = beside(&lowered, &split, (&list, &index, &assumed), options, &|place| scattered.contains(&place));
    // What only a few states do costs instructions in all others.
    let (mut weight, mut other) = (hoisted(&all), all);
    if let Some((its, some)) = some.map(|some| (hoisted(&some), some)) {
        if 10 * its <= 11 * weight {
            (weight, other) = (its, some);
        }
    }
    if 10 * weight < 9 * hoisted(program) {
        *program = other;
    }
}

/// The cycle with what may stand outside of its ways, and of the times of actions only these.
fn beside<'m>(
    program: &Program<'m>,
    split: &Split,
    (list, index, assumed): (&[Statement<'m>], &Index, &[bool]),
    options: &Options,
    runs: &dyn Fn(PlaceId) -> bool,
) -> Option<Program<'m>> {
    let [front, ways, tail] = outside(program, split, (list, index), runs)?;
    let (mut other, mut assumed) = (program.clone(), assumed.to_vec());
    for place in &*Effects::of_all(&front).writes {
        assumed[place.0] = false;
    }
    let index = indexed(&other, &ways, &assumed)?;
    let source = Source { list: &ways, index: &index, assumed: &assumed, front: &front, tail: &tail, unknown: &[] };
    by_ways(&mut other, &source, options).then_some(other)
}

/// How much is left where what all arms do first is done once.
fn hoisted(program: &Program<'_>) -> usize {
    let mut program = program.clone();
    hoist::pass(&mut program);
    weight(&program.cycle)
}

/// What stands in front of the ways, the ways, and what stands after them, if there is anything beside the ways.
fn outside<'m>(
    program: &Program<'m>,
    split: &Split,
    (list, index): (&[Statement<'m>], &Index),
    runs: &dyn Fn(PlaceId) -> bool,
) -> Option<[Vec<Statement<'m>>; 3]> {
    let is_front = front::front(list, index, &[split.state, split.first]);
    let is_tail = tail::tail((&program.places, list), index, split.points.all.len(), runs);
    let mut parts = [Vec::new(), Vec::new(), Vec::new()];
    for (statement, (is_front, is_tail)) in list.iter().zip(is_front.iter().zip(&is_tail)) {
        parts[if *is_front { 0 } else { 1 + usize::from(*is_tail) }].push(statement.clone());
    }
    (parts[1].len() < list.len()).then_some(parts)
}

/// Stored outputs that not all states tell stay fields: what they hold is copied once in each cycle, and states that know it do not write it anew. Where that makes the cycle much longer, `known`
/// is better.
fn stored<'m>(
    lowered: &Program<'m>,
    known: &Program<'m>,
    source: &Source<'_, 'm>,
    options: &Options,
) -> Option<Program<'m>> {
    let (mut lowered, mut unknown) = (lowered.clone(), Vec::new());
    for (index, place) in lowered.places.iter().enumerate() {
        if matches!(place.role, Role::FlipFlop(..)) && is_read_in(&known.cycle, PlaceId(index)) {
            unknown.push(PlaceId(index));
        }
    }
    let is_better = !unknown.is_empty()
        && by_ways(&mut lowered, &Source { unknown: &unknown, ..*source }, options)
        && 10 * weight(&lowered.cycle) <= 11 * weight(&known.cycle);
    is_better.then_some(lowered)
}

/// The cycle as a list, where each statement matters, and what is false in front of it.
fn listed<'m>(program: &mut Program<'m>) -> Option<(Vec<Statement<'m>>, Index, Vec<bool>)> {
    let first = Split::of(program)?.first;
    let mut places = std::mem::take(&mut program.places);
    let before = places.len();
    let mut list = flat(&program.cycle, Some(first), false, &mut places);
    samples_first(&mut list, &places);
    let assumed: Vec<bool> = places.iter().map(|place| !place.is_field).collect();
    program.places = places;
    let index = indexed(program, &list, &assumed);
    if index.is_none() {
        program.places.truncate(before);
    }
    index.map(|index| (list, index, assumed))
}

fn indexed(program: &Program<'_>, list: &[Statement<'_>], assumed: &[bool]) -> Option<Index> {
    let split = Split::of(program)?;
    Index::of(&program.places, list, split.state, Some(split.first), assumed, &split.points)
}

/// The cycle by its ways. Whether that is possible.
fn by_ways<'m>(program: &mut Program<'m>, source: &Source<'_, 'm>, options: &Options) -> bool {
    let Some(mut split) = Split::of(program) else { return false };
    let mut written = Effects::of_all(source.tail).writes;
    written.extend(Effects::of_all(source.front).writes.iter().copied());
    split.fields.retain(|field| !written.contains(field) && !source.unknown.contains(field));
    match split.trees(program, source, options) {
        Ok(trees) => {
            split.put_together(program, trees, source, options);
            true
        }
        Err(Lost) => false,
    }
}

impl Split {
    fn of(program: &Program<'_>) -> Option<Self> {
        let is_situation = |role| matches!(role, Role::State(_));
        if program.places.iter().filter(|place| is_situation(place.role)).count() != 1 {
            return None;
        }
        let (state, first) = (program.place(Role::State(0))?, program.place(Role::First)?);
        let Initial::Value(Value::Step(begin)) = program.places[state.0].initial else { return None };
        let points = States::of(begin, program.regions.first()?);
        let asks = |deadline: &Deadline<'_>| deadline.asks().any(|expr| mentions(expr, first));
        let asked = program.deadline.as_ref().is_some_and(asks);
        let mut fields = Vec::new();
        for (index, place) in program.places.iter().enumerate() {
            if place.is_field && ![state.0, first.0].contains(&index) {
                fields.push(PlaceId(index));
            }
        }
        (!asked).then_some(Self { state, first, points, begin, fields })
    }

    /// What is done from each point that can be reached.
    fn trees<'m>(
        &self,
        program: &Program<'m>,
        source: &Source<'_, 'm>,
        options: &Options,
    ) -> Result<Vec<Option<Tree<'m>>>, Lost> {
        let places = &program.places;
        let with_first = [&self.fields[..], &[self.first]].concat();
        let env = beginning(places, source.assumed, false);
        let mut engine = Engine::new(places, (source.list, source.index), self.state, &self.points, &with_first, env);
        engine.excluding = Excluding::of(&program.search.excluding, places.len());
        let mut known: Vec<Option<Vec<Fact>>> = vec![None; self.points.all.len()];
        known[0] = Some(self.fields.iter().map(|place| at_start(program, *place, options)).collect());
        let mut trees: Vec<Option<Tree<'m>>> = Vec::new();
        trees.resize_with(self.points.all.len(), || None);
        let mut open = Set::new();
        open.insert(0);
        if program.forced.is_some() {
            open.extend(program.regions[0].iter().filter_map(|step| self.points.of_step(*step)));
        }
        while let Some(point) = open.first().copied() {
            open.remove(&point);
            // What leads there by hand, nobody follows.
            let facts = known[point].clone().unwrap_or_else(|| vec![Fact::Nothing; self.fields.len()]);
            let mut given = vec![(self.first, Fact::Is(Value::Bool(point == 0))), (self.state, self.state_at(point))];
            given.extend(self.fields.iter().copied().zip(facts));
            let tree = engine.from(point, &given, WAYS)?;
            let mut leaves = Vec::new();
            tree.each_leaf(&mut |leaf| leaves.push((leaf.state, leaf.facts.clone())));
            for (state, mut facts) in leaves {
                // The next cycle must not be a first one.
                if facts.pop() != Some(Fact::Is(Value::Bool(false))) {
                    return Err(Lost);
                }
                let to = self.points.point(state).ok_or(Lost)?;
                if !options.known {
                    facts.fill(Fact::Nothing);
                }
                if meet(&mut known[to], facts) {
                    open.insert(to);
                }
            }
            trees[point] = Some(tree);
        }
        Ok(trees)
    }

    fn state_at(&self, point: usize) -> Fact {
        Fact::Is(if point == 0 { Value::Step(self.begin) } else { self.points.all[point] })
    }
}

/// What is known of a field in the first cycle.
fn at_start(program: &Program<'_>, place: PlaceId, options: &Options) -> Fact {
    let info = &program.places[place.0];
    match initial(info) {
        _ if !options.known || matches!(info.role, Role::Param(_)) => Fact::Nothing,
        Some(value) if !matches!(info.ty, Type::User(_)) => Fact::Is(value),
        _ => Fact::Initial,
    }
}

impl Split {
    fn put_together<'m>(
        &self,
        program: &mut Program<'m>,
        mut trees: Vec<Option<Tree<'m>>>,
        source: &Source<'_, 'm>,
        options: &Options,
    ) {
        if let Some(Some(tree)) = trees.first_mut() {
            let begin = Expr::Value(Value::Step(self.begin));
            tree.body.insert(0, Statement::Set(self.state, begin));
        }
        starting::as_state(program, self.state, self.first, self.begin);
        if options.told {
            told::pass(program, &self.fields, &mut trees, [source.front, source.tail]);
        }
        let [mut front, after] = if options.moved {
            let (points, fields) = (&*self.points.all, &*self.fields);
            moved::pass(program, &mut moved::Forest { state: self.state, points, fields, trees: &mut trees })
        } else {
            Default::default()
        };
        front.splice(0..0, source.front.iter().cloned());
        program.cycle = front.clone();
        program.cycle.push(self.evolution(trees.iter().map(|tree| tree.as_ref().map(Tree::copy)).collect()));
        program.cycle.extend(after.iter().cloned());
        program.cycle.extend(source.tail.iter().cloned());
        if !options.join {
            return;
        }
        sweep(program, source.tail, &mut trees);
        alike::pass(program, &self.points, &self.fields, &mut trees);
        let (mut acts, rest) = self.join(&mut trees);
        let mut cycle = front;
        cycle.push(self.evolution(trees));
        cycle.extend(after);
        acts.retain(|(_, body)| !body.is_empty());
        if !acts.is_empty() {
            cycle.push(Statement::Match(self.state, share::merged(acts), Vec::new()));
        }
        cycle.extend(rest);
        cycle.extend(source.tail.iter().cloned());
        program.cycle = cycle;
    }

    fn evolution<'m>(&self, trees: Vec<Option<Tree<'m>>>) -> Statement<'m> {
        let mut arms = Vec::new();
        for (point, tree) in self.points.all.iter().zip(trees) {
            if let Some(tree) = tree {
                arms.push((vec![*point], tree.statements()));
            }
        }
        Statement::Match(self.state, arms, Vec::new())
    }

    /// What is done after the ways, by the state that they lead to, and what is done in each.
    fn join<'m>(&self, trees: &mut [Option<Tree<'m>>]) -> (Vec<Arm<'m>>, Vec<Statement<'m>>) {
        let mut leaves: Vec<Vec<&mut Vec<Statement<'m>>>> = Vec::new();
        leaves.resize_with(self.points.all.len(), Vec::new);
        for tree in trees.iter_mut().flatten() {
            collect(tree, &self.points, &mut leaves);
        }
        let may = |statement: &Statement<'m>| {
            let marks = matches!(statement, Statement::Mark(_));
            !marks && !writes_to(statement, self.state)
        };
        let mut acts: Vec<Arm<'m>> = Vec::new();
        for (point, mut ends) in self.points.all.iter().zip(leaves) {
            if !ends.is_empty() {
                acts.push((vec![*point], share::ends(&mut ends, &may)));
            }
        }
        let mut bodies = Vec::with_capacity(acts.len());
        for (_, body) in &mut acts {
            bodies.push(body);
        }
        let rest = share::ends(&mut bodies, &may);
        (acts, rest)
    }
}

/// What is of no use at the ends of the ways would keep them from being alike.
fn sweep<'m>(program: &Program<'m>, tail: &[Statement<'m>], trees: &mut [Option<Tree<'m>>]) {
    let mut after = read_after(program);
    each_asked(tail, &mut |place| after.put(place, true));
    for tree in trees.iter_mut().flatten() {
        tree.each_leaf_mut(&mut |leaf| Live::after(&after).sweep(&mut leaf.body));
    }
}

pub(super) fn collect<'t, 'm>(tree: &'t mut Tree<'m>, points: &States, leaves: &mut [Vec<&'t mut Vec<Statement<'m>>>]) {
    match &mut tree.end {
        End::Leaf(leaf) => {
            if let Some(point) = points.point(leaf.state) {
                leaves[point].push(&mut leaf.body);
            }
        }
        End::Fork(_, ways) => ways.iter_mut().for_each(|way| collect(way, points, leaves)),
    }
}
