//! The statements of a part: which transitions there are, what each of them changes, and what is left.

use super::super::super::parts::gathers;
use super::super::super::uses::{Effects, each_read, is_pure, leaves, mentions, writes_to};
use super::super::{Env, Several};
use super::{Clearing, Moved, parts};
use crate::model::StepId;
use crate::program::{Comparison, Expr, PlaceId, Statement, Type, Value};
use crate::sorted::{Set, sort_by_key};

/// The statements of a part, sorted.
pub(super) struct Sorted<'m> {
    pub(super) before: Vec<Statement<'m>>,
    pub(super) clearings: Vec<Clearing<'m>>,
    pub(super) moves: Vec<Moved>,
    pub(super) after: Vec<Statement<'m>>,
}

/// What a statement has to do with the evolution.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// It writes states.
    Writes,
    /// It sets a truth that writes of states ask for, and nothing else.
    Asks,
    /// It tells that a region moves.
    Moves,
    Other,
}

/// A truth by which states are written: what it stands for.
struct Guard {
    truth: PlaceId,
    /// Where it is set.
    at: usize,
    /// Others of which one holds then, if it stands for no condition of its own.
    by: Option<Vec<PlaceId>>,
    /// Where a step is active that it makes active, it may hold or not.
    but: Option<StepId>,
}

/// The regions and states that a statement writes.
type Writes = Vec<(usize, Option<StepId>)>;

impl<'m> Several<'_, 'm> {
    pub(super) fn sorted(&self, list: &[Statement<'m>], env: &Env) -> Option<Sorted<'m>> {
        let mut kinds = vec![Kind::Other; list.len()];
        let (effects, set_by) = self.effects(list);
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
                    guards.push(self.guard(truth, list, &set_by)?);
                }
                let guard = guards.iter().find(|guard| guard.truth == truth)?;
                kinds[guard.at] = Kind::Asks;
                let is_entered = |step: StepId| writes.iter().all(|(_, written)| *written == Some(step));
                if guard.but.is_some_and(|step| !is_entered(step)) {
                    return None;
                }
                match &guard.by {
                    Some(by) => open.extend(by),
                    None => self.add(&mut clearings, (truth, guard.at), (at, &writes), list)?,
                }
            }
        }
        sort_by_key(&mut clearings, |clearing| clearing.at);
        if self.is_of_two_moments(&clearings) {
            return None;
        }
        let moves = self.moves(list, &mut kinds, &clearings);
        keep(list, &mut kinds, &mut clearings, |place| env.later.contains(&place) || self.read_after.contains(place));
        (clearings.len() > 1).then(|| placed(list, &effects, &kinds, clearings, moves)).flatten()
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
        let asks = |place: PlaceId| clearings.iter().flat_map(|one| &one.asks).any(|asked| mentions(asked, place));
        let both = |(was, state): (&Option<PlaceId>, &PlaceId)| was.is_some_and(asks) && asks(*state);
        self.was.iter().zip(&self.states).any(both)
    }

    /// What a transition writes.
    fn add(
        &self,
        clearings: &mut Vec<Clearing<'m>>,
        (truth, set): (PlaceId, usize),
        (at, writes): (usize, &Writes),
        list: &[Statement<'m>],
    ) -> Option<()> {
        let index = match clearings.iter().position(|clearing| clearing.truth == truth) {
            Some(index) => index,
            None => {
                let Statement::Set(_, value) = &list[set] else { return None };
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

    fn clearing(&self, (truth, at): (PlaceId, usize), value: &Expr<'m>) -> Clearing<'m> {
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
        Clearing { truth, at, asks, tests, writes: Vec::new(), is_kept: false }
    }

    /// By which truths a statement writes which states.
    fn writing(&self, statement: &Statement<'m>) -> Option<(Vec<PlaceId>, Writes)> {
        let Statement::If(condition, then, otherwise) = statement else { return None };
        let mut writes = Vec::new();
        for one in then {
            let Statement::Set(place, Expr::Value(Value::Step(step))) = one else { return None };
            writes.push((self.states.iter().position(|state| state == place)?, *step));
        }
        let truths = truths(condition)?;
        otherwise.is_empty().then_some((truths, writes))
    }

    /// What a truth stands for that is set once, of what is so before anything has cleared.
    fn guard(&self, truth: PlaceId, list: &[Statement<'m>], writers: &[Vec<usize>]) -> Option<Guard> {
        let info = &self.places[truth.0];
        // To what has been put into it in front of these statements others may have added what is not looked at here.
        let [at] = writers[truth.0][..] else { return None };
        let Statement::Set(_, value) = &list[at] else { return None };
        if mentions(value, truth) || info.is_field || !matches!(info.ty, Type::Bool) || !is_pure(value) {
            return None;
        }
        let is_written = |state: PlaceId| writers[state.0].first().is_some_and(|first| *first < at);
        if self.states.iter().any(|state| is_written(*state) && mentions(value, *state)) {
            return None;
        }
        let is_set = |truth: &PlaceId| self.is_set_in(*truth, list, writers);
        if let Some(by) = truths(value).filter(|by| by.iter().all(is_set)) {
            return Some(Guard { truth, at, by: Some(by), but: None });
        }
        // What enters a step may ask whether it stays active.
        let entering = match value {
            Expr::All(parts) => match &parts[..] {
                [first, Expr::Not(stays)] => truths(first).zip(self.stays(stays)),
                _ => None,
            },
            _ => None,
        };
        let entering = entering.filter(|(by, _)| by.iter().all(is_set));
        let (by, but) = entering.unzip();
        Some(Guard { truth, at, by, but })
    }

    fn is_set_in(&self, truth: PlaceId, list: &[Statement<'m>], writers: &[Vec<usize>]) -> bool {
        !self.places[truth.0].is_field && writers[truth.0].iter().any(|at| matches!(list[*at], Statement::Set(..)))
    }

    /// The step of which a condition says that it is active, and not left.
    fn stays(&self, condition: &Expr<'m>) -> Option<StepId> {
        let is = match condition {
            Expr::All(parts) => match &parts[..] {
                [is, Expr::Not(left)] => truths(left).and(Some(is)),
                _ => None,
            },
            one => Some(one),
        };
        match is {
            Some(Expr::Is(place, steps)) if steps.len() == 1 => self.region_of(*place).and(steps.first().copied()),
            _ => None,
        }
    }

    /// The truths that tell that regions move, if each transition moves one of those.
    fn moves(&self, list: &[Statement<'m>], kinds: &mut [Kind], clearings: &[Clearing<'m>]) -> Vec<Moved> {
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
                    if !surely[at] && regions().any(|region| one.moves(region, clearings, |other| surely[other])) {
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
        let mut moves = Vec::new();
        for (at, Moved { truth, region, begins }) in &all {
            if tells(*truth) && (!begins || is_first(*at, *truth)) {
                kinds[*at] = Kind::Moves;
                moves.push(Moved { truth: *truth, region: *region, begins: *begins });
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

/// The truths of which one holds where this holds, and the other way round.
fn truths(condition: &Expr<'_>) -> Option<Vec<PlaceId>> {
    let mut all = Vec::new();
    match condition {
        Expr::Place(place) => all.push(*place),
        Expr::Any(parts) => {
            for part in parts {
                let Expr::Place(place) = part else { return None };
                all.push(*place);
            }
        }
        _ => return None,
    }
    Some(all)
}

/// What others than the writes of states ask for is set for them, before anything clears.
fn keep(
    list: &[Statement<'_>],
    kinds: &mut [Kind],
    clearings: &mut [Clearing<'_>],
    is_read_behind: impl Fn(PlaceId) -> bool,
) {
    let mut wanted: Set<PlaceId> = Set::new();
    let of = |at: usize| Effects::of(&list[at]).reads;
    for at in (0..list.len()).filter(|at| kinds[*at] == Kind::Other) {
        wanted.extend(of(at).iter().copied());
    }
    for clearing in &*clearings {
        for asked in &clearing.asks {
            each_read(asked, &mut |place| _ = wanted.insert(place));
        }
    }
    // What is set for others may ask for what is set in front of it.
    for at in (0..list.len()).rev() {
        let Statement::Set(place, _) = &list[at] else { continue };
        if kinds[at] == Kind::Asks && (wanted.contains(place) || is_read_behind(*place)) {
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
    moves: Vec<Moved>,
) -> Option<Sorted<'m>> {
    let is_evolution = |at: usize| matches!(kinds[at], Kind::Writes | Kind::Asks);
    let swaps = swaps(effects, is_evolution);
    let mut kept: Set<PlaceId> = Set::new();
    for one in clearings.iter().filter(|one| one.is_kept) {
        kept.insert(one.truth);
    }
    let mut sorted = Sorted { before: Vec::new(), clearings, moves, after: Vec::new() };
    let (mut in_front, mut behind) = (Effects::default(), Effects::default());
    for (at, statement) in list.iter().enumerate() {
        if is_evolution(at) {
            in_front.add(statement);
            continue;
        }
        if kinds[at] == Kind::Moves {
            continue;
        }
        if swaps[at] && effects[at].writes.is_disjoint(&kept) {
            behind.add(statement);
            sorted.after.push(statement.clone());
        } else if effects[at].may_swap(&in_front) && effects[at].may_swap(&behind) {
            sorted.before.push(statement.clone());
        } else {
            return None;
        }
    }
    // What is left of them must not take back what the transitions tell.
    let adds = |one: &Statement<'m>, truth: PlaceId| !writes_to(one, truth) || gathers(one) == Some(truth);
    let is_told = |moved: &Moved| sorted.after.iter().all(|one| adds(one, moved.truth));
    let stays = !sorted.before.iter().chain(&sorted.after).any(leaves);
    (stays && sorted.moves.iter().all(is_told)).then_some(sorted)
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
