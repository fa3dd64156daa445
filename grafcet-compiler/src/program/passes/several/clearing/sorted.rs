//! The statements of a part: which transitions there are, what each of them changes, and what is left.

use super::super::super::engine::Fact;
use super::super::super::parts::gathers;
use super::super::super::uses::{Effects, each_read, leaves, writes_to};
use super::super::{Env, Several};
use super::guards::{Guard, Truths, one_of};
use super::told::Telling;
use super::{Asking, Clearing, Told, parts};
use crate::model::StepId;
use crate::program::{Comparison, Expr, PlaceId, Statement, Value};
use crate::sorted::{Map, Set, sort_by_key};

/// The statements of a part, sorted.
pub(super) struct Sorted<'m> {
    pub(super) before: Vec<Statement<'m>>,
    pub(super) clearings: Vec<Clearing<'m>>,
    pub(super) told: Vec<Told>,
    pub(super) after: Vec<Statement<'m>>,
}

/// What a statement has to do with the evolution.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// It writes states.
    Writes,
    /// It sets a truth that writes of states ask for, and nothing else.
    Asks,
    /// It tells that a region moves.
    Moves,
    Other,
}

/// A statement tells that a region moves.
struct Moved {
    truth: PlaceId,
    region: usize,
    /// The truth is false before.
    begins: bool,
}

/// The regions and states that a statement writes.
type Writes = Vec<(usize, Option<StepId>)>;

impl<'m> Several<'_, 'm> {
    pub(super) fn sorted(&self, list: &[Statement<'m>], env: &Env, asking: Asking) -> Option<Sorted<'m>> {
        let mut kinds = vec![Kind::Other; list.len()];
        let (effects, set_by) = self.effects(list);
        let truths =
            Truths { list, set_by: &set_by, is_off: &|place| env.facts[place.0] == Fact::Is(Value::Bool(false)) };
        let (mut guards, mut clearings): (Vec<Guard>, Vec<Clearing<'m>>) = (Vec::new(), Vec::new());
        for (at, statement) in list.iter().enumerate().filter(|(_, one)| self.decides(std::slice::from_ref(one))) {
            kinds[at] = Kind::Writes;
            let (asked, writes) = self.writing(statement)?;
            let mut open = asked;
            let mut seen: Set<PlaceId> = Set::new();
            while let Some(truth) = open.pop() {
                if !seen.insert(truth) {
                    continue;
                }
                if !guards.iter().any(|guard| guard.truth == truth) {
                    guards.push(self.guard(truth, &truths)?);
                }
                let guard = guards.iter().find(|guard| guard.truth == truth)?;
                for set in &guard.at {
                    kinds[*set] = Kind::Asks;
                }
                let is_entered = |step: StepId| writes.iter().all(|(_, written)| *written == Some(step));
                if guard.but.is_some_and(|step| !is_entered(step)) {
                    return None;
                }
                match &guard.by {
                    Some(by) => open.extend(by),
                    None => self.add(&mut clearings, (truth, guard.at.first().copied()), (at, &writes), list)?,
                }
            }
        }
        sort_by_key(&mut clearings, |clearing| clearing.at);
        if self.is_of_two_moments(&clearings) {
            return None;
        }
        if clearings.len() < 2 {
            return None;
        }
        let mut told = self.moves(list, &mut kinds, &clearings);
        let is_read_after = |place: PlaceId| env.later.contains(&place) || self.read_after.contains(place);
        if asking == Asking::Beforehand {
            keep(list, &mut kinds, &mut clearings, (&[], asking), &is_read_after);
            return placed(list, &effects, &kinds, clearings, told);
        }
        let mut telling = Telling {
            several: self,
            clearings: &clearings,
            truths: &truths,
            is_read_after: &is_read_after,
            asked_before: asked_before(list, &clearings, asking),
            by: Map::new(),
        };
        told.append(&mut telling.told(&mut kinds));
        keep(list, &mut kinds, &mut clearings, (&told, asking), &is_read_after);
        placed(list, &effects, &kinds, clearings, told)
    }

    /// What each statement does, and by place which of them write it.
    fn effects(&self, list: &[Statement<'m>]) -> (Vec<Effects>, Vec<Vec<usize>>) {
        let (mut all, mut writers) = (Vec::with_capacity(list.len()), vec![Vec::new(); self.places.len()]);
        for (at, statement) in list.iter().enumerate() {
            let effects = Effects::of(statement);
            for place in &effects.writes {
                writers[place.0].push(at);
            }
            all.push(effects);
        }
        (all, writers)
    }

    /// Whether some ask for a state as it was, and others for what has become of it since.
    fn is_of_two_moments(&self, clearings: &[Clearing<'m>]) -> bool {
        let mut asked: Set<PlaceId> = Set::new();
        for asks in clearings.iter().flat_map(|one| &one.asks) {
            each_read(asks, &mut |place| _ = asked.insert(place));
        }
        let asks = |place: PlaceId| asked.contains(&place);
        let both = |(was, state): (&Option<PlaceId>, &PlaceId)| was.is_some_and(asks) && asks(*state);
        self.was.iter().zip(&self.states).any(both)
    }

    /// What a transition writes.
    fn add(
        &self,
        clearings: &mut Vec<Clearing<'m>>,
        (truth, set): (PlaceId, Option<usize>),
        (at, writes): (usize, &Writes),
        list: &[Statement<'m>],
    ) -> Option<()> {
        let index = match clearings.iter().position(|clearing| clearing.truth == truth) {
            Some(index) => index,
            None => {
                let asked_before = Expr::Place(truth);
                let value = match set.map(|set| &list[set]) {
                    Some(Statement::Set(_, value)) => value,
                    Some(_) => return None,
                    None => &asked_before,
                };
                clearings.push(self.clearing((truth, set), value));
                clearings.len() - 1
            }
        };
        let own = &mut clearings[index].writes;
        for (region, step) in writes {
            own.retain(|(other, ..)| other != region);
            own.push((*region, at, *step));
        }
        Some(())
    }

    fn clearing(&self, (truth, set): (PlaceId, Option<usize>), value: &Expr<'m>) -> Clearing<'m> {
        let asks = parts(value).to_vec();
        let mut tests: Vec<(usize, Vec<StepId>)> = Vec::new();
        for part in &asks {
            let Expr::Is(place, steps) = part else { continue };
            let Some(region) = self.region_of(*place) else { continue };
            match tests.iter_mut().find(|(other, _)| *other == region) {
                Some((_, both)) => both.retain(|step| steps.contains(step)),
                None => tests.push((region, steps.clone())),
            }
        }
        Clearing { truth, at: set.unwrap_or(0), asks, tests, writes: Vec::new(), is_kept: set.is_none() }
    }

    /// By which truths a statement writes which states.
    fn writing(&self, statement: &Statement<'m>) -> Option<(Vec<PlaceId>, Writes)> {
        let Statement::If(condition, then, otherwise) = statement else { return None };
        let mut writes = Vec::new();
        for one in then {
            let Statement::Set(place, Expr::Value(Value::Step(step))) = one else { return None };
            writes.push((self.states.iter().position(|state| state == place)?, *step));
        }
        let truths = one_of(condition)?;
        otherwise.is_empty().then_some((truths, writes))
    }

    /// The truths that tell that regions move, if each transition moves one of those.
    fn moves(&self, list: &[Statement<'m>], kinds: &mut [Kind], clearings: &[Clearing<'m>]) -> Vec<Told> {
        let mut all: Vec<(usize, Moved)> = Vec::new();
        for (at, statement) in list.iter().enumerate() {
            let moved = self.tells_move(statement);
            let is_written = |moved: &Moved| clearings.iter().any(|one| one.write(moved.region).is_some());
            all.extend(moved.filter(is_written).map(|moved| (at, moved)));
        }
        let tells = |truth: PlaceId| {
            let regions = || all.iter().filter(move |(_, moved)| moved.truth == truth).map(|(_, moved)| moved.region);
            // Whoever leads back moves another region.
            let mut surely = vec![false; clearings.len()];
            let mut is_changed = true;
            while is_changed {
                is_changed = false;
                for (at, one) in clearings.iter().enumerate() {
                    if !surely[at]
                        && regions().any(|region| one.moves(region, (clearings, self), |other| surely[other]))
                    {
                        surely[at] = true;
                        is_changed = true;
                    }
                }
            }
            surely.iter().all(|is| *is)
        };
        // A truth that begins with one of them begins with all.
        let is_first = |at: usize, truth: PlaceId| {
            list.iter().position(|one| writes_to(one, truth)).is_none_or(|first| first >= at)
        };
        let (mut moves, mut told) = (Vec::new(), Map::new());
        for (at, Moved { truth, begins, .. }) in &all {
            // As a rule one truth tells it of all regions.
            if *told.or_insert_with(*truth, || tells(*truth)) && (!begins || is_first(*at, *truth)) {
                kinds[*at] = Kind::Moves;
                moves.push(Told { truth: *truth, by: None, begins: *begins });
            }
        }
        moves
    }

    /// Whether a statement tells that a region has moved.
    fn tells_move(&self, statement: &Statement<'m>) -> Option<Moved> {
        let Statement::Set(truth, value) = statement else { return None };
        let differs = match value {
            Expr::Any(parts) => match &parts[..] {
                [Expr::Place(own), differs] if own == truth => differs,
                _ => return None,
            },
            differs => differs,
        };
        let Expr::Compare(Comparison::Differs, a, b) = differs else { return None };
        let (Expr::Place(a), Expr::Place(b)) = (&**a, &**b) else { return None };
        let region = self.region_of(*a).filter(|region| a != b && self.region_of(*b) == Some(*region))?;
        Some(Moved { truth: *truth, region, begins: !matches!(value, Expr::Any(_)) })
    }
}

/// What the conditions of transitions ask for as it was before anything has cleared, also by way of truths that are set for them.
fn asked_before(list: &[Statement<'_>], clearings: &[Clearing<'_>], asking: Asking) -> Set<PlaceId> {
    let mut wanted: Set<PlaceId> = Set::new();
    for clearing in clearings {
        for asked in clearing.asks.iter().filter(|asked| denied(asked, clearings, asking).is_none()) {
            each_read(asked, &mut |place| _ = wanted.insert(place));
        }
    }
    for statement in list.iter().rev() {
        let Statement::Set(place, value) = statement else { continue };
        if wanted.contains(place) {
            each_read(value, &mut |read| _ = wanted.insert(read));
        }
    }
    wanted
}

/// The transition of which a condition says that it does not clear, where that is asked after its own.
pub(super) fn denied(condition: &Expr<'_>, clearings: &[Clearing<'_>], asking: Asking) -> Option<usize> {
    let Expr::Not(inner) = condition else { return None };
    let Expr::Place(truth) = **inner else { return None };
    clearings.iter().position(|one| one.truth == truth && !one.is_kept).filter(|_| asking == Asking::Denying)
}

/// What others than the writes of states ask for is set for them before anything clears, unless transitions tell it.
fn keep(
    list: &[Statement<'_>],
    kinds: &mut [Kind],
    clearings: &mut [Clearing<'_>],
    (told, asking): (&[Told], Asking),
    is_read_after: &dyn Fn(PlaceId) -> bool,
) {
    let mut wanted: Set<PlaceId> = Set::new();
    let of = |at: usize| Effects::of(&list[at]).reads;
    for at in (0..list.len()).filter(|at| kinds[*at] == Kind::Other) {
        wanted.extend(of(at).iter().copied());
    }
    wanted.extend(asked_before(list, clearings, asking));
    let is_told = |place: PlaceId| told.iter().any(|one| one.truth == place);
    // What is set for others may ask for what is set in front of it.
    for at in (0..list.len()).rev() {
        let Statement::Set(place, _) = &list[at] else { continue };
        if kinds[at] == Kind::Asks && !is_told(*place) && (wanted.contains(place) || is_read_after(*place)) {
            kinds[at] = Kind::Other;
            wanted.extend(of(at).iter().copied());
            for clearing in clearings.iter_mut().filter(|clearing| clearing.truth == *place) {
                clearing.is_kept = true;
            }
        }
    }
}

/// What has nothing to do with the evolution is done before it or after it.
fn placed<'m>(
    list: &[Statement<'m>],
    effects: &[Effects],
    kinds: &[Kind],
    clearings: Vec<Clearing<'m>>,
    told: Vec<Told>,
) -> Option<Sorted<'m>> {
    let is_evolution = |at: usize| matches!(kinds[at], Kind::Writes | Kind::Asks);
    let swaps = swaps(effects, is_evolution);
    let mut kept: Set<PlaceId> = Set::new();
    for one in clearings.iter().filter(|one| one.is_kept) {
        kept.insert(one.truth);
    }
    let mut sorted = Sorted { before: Vec::new(), clearings, told, after: Vec::new() };
    let (mut in_front, mut after) = (Effects::default(), Effects::default());
    for (at, statement) in list.iter().enumerate() {
        if is_evolution(at) {
            in_front.add(statement);
            continue;
        }
        if kinds[at] == Kind::Moves {
            continue;
        }
        if swaps[at] && effects[at].writes.is_disjoint(&kept) {
            after.add(statement);
            sorted.after.push(statement.clone());
        } else if effects[at].may_swap(&in_front) && effects[at].may_swap(&after) {
            sorted.before.push(statement.clone());
        } else {
            return None;
        }
    }
    // What is left of them must not take back what the transitions tell.
    let adds = |one: &Statement<'m>, truth: PlaceId| !writes_to(one, truth) || gathers(one) == Some(truth);
    let is_left = |told: &Told| sorted.after.iter().all(|one| adds(one, told.truth));
    let stays = !sorted.before.iter().chain(&sorted.after).any(leaves);
    (stays && sorted.told.iter().all(is_left)).then_some(sorted)
}

/// Which statements may change places with all of the evolution that stands after them.
fn swaps(effects: &[Effects], is_evolution: impl Fn(usize) -> bool) -> Vec<bool> {
    let (mut may, mut evolution) = (vec![false; effects.len()], Effects::default());
    for (at, one) in effects.iter().enumerate().rev() {
        may[at] = one.may_swap(&evolution);
        if is_evolution(at) {
            evolution.join(one);
        }
    }
    may
}
