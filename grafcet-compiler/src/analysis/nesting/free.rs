//! Whether each transition can clear by itself: whether there are inputs under which it does and the others that leave the
//! same steps do not, although these may have to be active for some time.

use crate::analysis::{Answer, Condition, Logic};
use crate::list::List;
use crate::model::{Binary, Id, Model, Name, Read, StepId, TimeRef, TransitionId, Tree, Unary};
use crate::sorted::{Map, Set, sort, sort_unstable};

/// Whether that holds for all transitions of a chart, whose conditions read inputs and how long their sources are active.
pub(super) fn is_free(model: &Model, never: &[&Tree]) -> bool {
    Groups::of(model, never).is_some_and(|groups| groups.all.iter().all(|group| groups.is_free(group)))
}

/// Whether the chart can wait in each of its steps as long as it likes, too. Where branches meet, one waits for another.
pub(super) fn can_wait(model: &Model, never: &[&Tree]) -> bool {
    let can_wait = |groups: &Groups<'_>, group: &Group| {
        group.sources.len() > 1 || groups.can_wait(group) && groups.is_settled(group)
    };
    Groups::of(model, never).is_some_and(|groups| groups.all.iter().all(|group| can_wait(&groups, group)))
}

/// Whether the chart can stop in a step: in a `grafcet` the inputs with which it is entered may lead on at once.
pub(super) fn comes_to_rest(model: &Model, step: StepId, never: &[&Tree]) -> bool {
    let Some(groups) = Groups::of(model, never) else { return false };
    let group = groups.all.iter().find(|group| group.sources == [step]);
    !model.is_grafcet() || group.is_some_and(|group| group.entering.iter().any(|entry| groups.rests(group, *entry)))
}

/// The transitions that leave the same steps.
struct Group {
    sources: Vec<StepId>,
    leaving: Vec<TransitionId>,
    /// The transitions that lead to one of the steps.
    entering: Vec<TransitionId>,
    /// The groups to whose steps those that leave lead.
    next: Vec<usize>,
    /// A condition does not only wait for times, so that one can come too late.
    hurries: bool,
}

impl Group {
    fn of(sources: &[StepId]) -> Self {
        Self { sources: sources.to_vec(), leaving: Vec::new(), entering: Vec::new(), next: Vec::new(), hurries: false }
    }
}

/// A condition as it stands, and what it is at some times.
struct Reading {
    whole: Condition,
    /// By [`Time`].
    at: [Option<Condition>; 4],
}

impl Reading {
    fn at(&self, time: Time) -> Option<&Condition> {
        self.at[time as usize].as_ref()
    }
}

struct Groups<'m> {
    model: &'m Model,
    logic: Logic<'m>,
    all: Vec<Group>,
    /// By transition.
    of: Vec<usize>,
    readings: Vec<Reading>,
    /// See [`Groups::resting`].
    resting: Vec<bool>,
}

/// How many transitions that lead on at once are looked at.
const CHAIN: usize = 3;

/// What shall hold, and what shall not.
type Goals<'g> = Vec<(&'g Condition, bool)>;

impl<'m> Groups<'m> {
    /// `None` where steps are left by transitions that do not leave the same ones, or conditions read something else.
    fn of(model: &'m Model, never: &[&Tree]) -> Option<Self> {
        let logic = Logic::assuming(model, never);
        let mut all: Vec<Group> = Vec::new();
        let mut known: Map<StepId, usize> = Map::new();
        let (mut of, mut readings) = (Vec::new(), Vec::new());
        for (id, transition) in model.transitions.iter() {
            let mut sources = transition.sources.clone();
            sort(&mut sources);
            let number = *known.get(sources.first()?).unwrap_or(&all.len());
            if number == all.len() {
                all.push(Group::of(&sources));
            }
            let strange = |source: &StepId| *known.or_insert_with(*source, || number) != number;
            let tree = &transition.condition.tree;
            if sources.iter().any(strange) || all[number].sources != sources || !is_plain(model, tree, &sources) {
                return None;
            }
            all[number].leaving.push(id);
            all[number].hurries |= hurries(tree, true);
            of.push(number);
            let at = |time| at(tree, time, true).map(|tree| logic.condition(&tree));
            let whole = logic.condition(tree);
            readings.push(Reading { whole, at: TIMES.map(at) });
        }
        for (id, transition) in model.transitions.iter() {
            let groups: Set<usize> =
                transition.targets.iter().filter_map(|target| known.get(target).copied()).collect();
            for group in groups {
                all[group].entering.push(id);
                all[of[id.index()]].next.push(group);
            }
        }
        let mut groups = Self { model, logic, all, of, readings, resting: Vec::new() };
        if model.is_grafcet() {
            groups.resting = groups.resting();
        }
        Some(groups)
    }

    fn is_free(&self, group: &Group) -> bool {
        let exclusive = |a: &TransitionId| {
            let others = group.leaving.iter().filter(|b| *b != a);
            others.into_iter().all(|b| self.logic.exclusive(&self.reading(*a).whole, &self.reading(*b).whole))
        };
        let can_clear = |id: &TransitionId| self.ways(*id).iter().any(|goals| self.can_be(goals));
        let alone = group.leaving.len() < 2 || !self.model.is_grafcet();
        let one_way = alone || group.leaving.iter().all(exclusive) && self.is_settled(group);
        one_way && group.leaving.iter().all(can_clear) && self.is_never_too_late(group)
    }

    /// Whether there is a way on for who has waited for as long as there are times.
    fn is_never_too_late(&self, group: &Group) -> bool {
        let late =
            |id: &TransitionId| self.reading(*id).at(Time::Late).is_some_and(|late| self.can_be(&vec![(late, true)]));
        group.leaving.is_empty() || !group.hurries || group.leaving.iter().any(late)
    }

    /// Whether inputs keep the chart in the steps of a group, however long they have been active.
    fn can_wait(&self, group: &Group) -> bool {
        let stays = group.leaving.iter().map(|id| Some((self.reading(*id).at(Time::Ever)?, false)));
        stays.collect::<Option<Goals<'_>>>().is_some_and(|stays| self.can_be(&stays))
    }

    /// Whether the steps of a group can be entered by each transition that leads to them without being left at once.
    fn is_settled(&self, group: &Group) -> bool {
        !self.model.is_grafcet() || group.entering.iter().all(|entry| self.rests(group, *entry))
    }

    /// Whether a transition can clear with inputs that do not lead on at once from the steps that it leads to.
    fn rests(&self, group: &Group, entry: TransitionId) -> bool {
        self.comes_to_rest(group, &[entry], &self.resting)
    }

    /// The groups in which the chart can come to rest whenever it enters them, on whichever way.
    fn resting(&self) -> Vec<bool> {
        let mut resting = vec![true; self.all.len()];
        let mut open: Vec<usize> = (0..self.all.len()).list();
        let mut is_open = resting.clone();
        while let Some(number) = open.pop() {
            is_open[number] = false;
            let group = &self.all[number];
            let rests = |entry: &TransitionId| self.comes_to_rest(group, &[*entry], &resting);
            if !resting[number] || group.entering.iter().all(rests) {
                continue;
            }
            resting[number] = false;
            // What is entered from there has to be looked at again.
            let mut next: Vec<usize> = vec![number];
            for _ in 1..CHAIN {
                next = next.iter().flat(|number| &self.all[*number].next).copied().list();
                sort_unstable(&mut next);
                next.dedup();
                open.extend(next.iter().filter(|number| !std::mem::replace(&mut is_open[**number], true)));
            }
        }
        resting
    }

    /// Whether a chain of transitions can clear with inputs that do not lead on from the group that it ends in: from where
    /// the chart can rest, or from wherever it comes.
    fn comes_to_rest(&self, group: &Group, chain: &[TransitionId], resting: &[bool]) -> bool {
        let before = self.of[chain[0].index()];
        let longer = |first: &TransitionId| self.comes_to_rest(group, &[&[*first], chain].concat(), resting);
        self.stops(group, chain)
            && (resting[before] || chain.len() < CHAIN && self.all[before].entering.iter().all(longer))
    }

    /// Whether transitions can clear with the same inputs, one of the ways of each, and none that leaves the group.
    fn stops(&self, group: &Group, entries: &[TransitionId]) -> bool {
        let next = group.leaving.iter().map(|id| Some((self.reading(*id).at(Time::Entered)?, false)));
        let Some(next) = next.collect::<Option<Goals<'_>>>() else { return false };
        let mut ways = vec![next];
        for entry in entries {
            let own = self.ways(*entry);
            ways = ways.iter().flat(|way| own.iter().map(|own| [&way[..], &own[..]].concat())).list();
        }
        ways.iter().any(|way| self.can_be(way))
    }

    /// What suffices for a transition to clear: that its condition holds and those of its group do not, from the beginning
    /// or until it has been waited long enough. One that is alone need not be waited for in any special way.
    fn ways(&self, id: TransitionId) -> Vec<Goals<'_>> {
        let group = &self.all[self.of[id.index()]];
        let own = self.reading(id);
        if group.leaving.len() == 1 {
            return vec![vec![(&own.whole, true)]];
        }
        let others = || group.leaving.iter().filter(|other| **other != id).map(|other| self.reading(*other));
        let with = |time: Time, others_time: Time| {
            let others = others().map(|other| Some((other.at(others_time)?, false)));
            others.and([own.at(time).map(|own| (own, true))]).collect::<Option<Goals<'_>>>()
        };
        with(Time::Soon, Time::Soon).into_iter().and(with(Time::Late, Time::Ever)).list()
    }

    fn reading(&self, id: TransitionId) -> &Reading {
        &self.readings[id.index()]
    }

    fn can_be(&self, goals: &Goals<'_>) -> bool {
        matches!(self.logic.certainly_together(goals, &[]), Answer::Witness(_))
    }
}

/// Whether a condition reads inputs, edges of boolean ones, and whether the sources of its transition have been active for some
/// time.
fn is_plain(model: &Model, tree: &Tree, sources: &[StepId]) -> bool {
    let is_own = |step: &StepId| sources.contains(step);
    match tree {
        Tree::Bool(_) | Tree::Int(_) | Tree::Read(Read::Name(Name::Input(_) | Name::Param(_))) => true,
        Tree::Elapsed(TimeRef::Ticks(_) | TimeRef::Param(_), step) => is_own(step),
        Tree::Read(Read::Rising(edge) | Read::Falling(edge)) => {
            matches!(model.edges[*edge].of.tree, Tree::Read(Read::Name(Name::Input(_))))
        }
        Tree::Unary(Unary::Not, inner) => is_plain(model, inner, sources),
        Tree::Binary(Binary::And | Binary::Or | Binary::BitAnd | Binary::BitOr, a, b) => {
            is_plain(model, a, sources) && is_plain(model, b, sources)
        }
        // Of what is compared it is not known when it holds the rather.
        Tree::Unary(_, inner) => is_plain(model, inner, &[]),
        Tree::Binary(operator, a, b) => match since(*operator, a, b) {
            Some((step, time, _)) => {
                is_own(&step) && matches!(time, Tree::Read(Read::Ticks(_) | Read::Name(Name::Param(_))))
            }
            None => is_plain(model, a, &[]) && is_plain(model, b, &[]),
        },
        _ => false,
    }
}

/// A comparison of the time of a step with something else: which step, with what, and whether it holds once the time has
/// passed.
fn since<'t>(operator: Binary, a: &'t Tree, b: &'t Tree) -> Option<(StepId, &'t Tree, bool)> {
    let is_late = match operator {
        Binary::Ge | Binary::Gt => true,
        Binary::Le | Binary::Lt => false,
        _ => return None,
    };
    match (a, b) {
        (Tree::Read(Read::Since(_)), Tree::Read(Read::Since(_))) => None,
        (Tree::Read(Read::Since(step)), time) => Some((*step, time, is_late)),
        (time, Tree::Read(Read::Since(step))) => Some((*step, time, !is_late)),
        _ => None,
    }
}

/// Whether a plain condition holds the rather as long as a time has not passed, or the less; `positive` as in [`at`].
fn hurries(tree: &Tree, positive: bool) -> bool {
    match tree {
        Tree::Elapsed(..) => !positive,
        Tree::Unary(_, inner) => hurries(inner, !positive),
        Tree::Binary(operator, a, b) => match since(*operator, a, b) {
            Some((.., is_late)) => is_late != positive,
            None => hurries(a, positive) || hurries(b, positive),
        },
        _ => false,
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Time {
    /// In the evolution that follows the one that activates the sources.
    Entered,
    /// In the next cycle.
    Soon,
    /// When all times have passed.
    Late,
    /// At any time, wherever it can hold.
    Ever,
}

const TIMES: [Time; 4] = [Time::Entered, Time::Soon, Time::Late, Time::Ever];

/// A plain condition at some time; `None` where it looks at times in another way than whether they have passed, or at edges
/// that have to be waited for. `positive` tells whether it holds the rather, the rather this part of it does.
fn at(tree: &Tree, time: Time, positive: bool) -> Option<Tree> {
    let passed = match time {
        Time::Entered | Time::Soon => false,
        Time::Late => true,
        Time::Ever => positive,
    };
    if let Tree::Binary(operator, a, b) = tree {
        if let Some((_, Tree::Read(Read::Ticks(1..)), is_late)) = since(*operator, a, b) {
            return Some(Tree::Bool(if time == Time::Ever { positive } else { passed == is_late }));
        }
    }
    match tree {
        Tree::Elapsed(TimeRef::Ticks(1..), _) => Some(Tree::Bool(passed)),
        Tree::Unary(Unary::Not, inner) => Some(Tree::Unary(Unary::Not, Box::new(at(inner, time, !positive)?))),
        Tree::Binary(operator @ (Binary::And | Binary::Or | Binary::BitAnd | Binary::BitOr), a, b) => {
            Some(Tree::Binary(*operator, Box::new(at(a, time, positive)?), Box::new(at(b, time, positive)?)))
        }
        Tree::Unary(..) | Tree::Binary(..) => is_timeless(tree).then(|| tree.clone()),
        Tree::Elapsed(..) | Tree::Read(Read::Since(_)) => None,
        Tree::Read(Read::Rising(_) | Read::Falling(_)) if matches!(time, Time::Soon | Time::Late) => None,
        other => Some(other.clone()),
    }
}

/// Whether a plain condition reads inputs alone.
fn is_timeless(tree: &Tree) -> bool {
    match tree {
        Tree::Elapsed(..) | Tree::Read(Read::Since(_) | Read::Rising(_) | Read::Falling(_)) => false,
        Tree::Unary(_, inner) => is_timeless(inner),
        Tree::Binary(_, a, b) => is_timeless(a) && is_timeless(b),
        _ => true,
    }
}
