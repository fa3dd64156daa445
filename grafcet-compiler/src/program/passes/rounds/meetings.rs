//! Which states of two regions meet: where one is forced or enclosed by the other, and no other way leads there. Found by going through the round with the
//! states of both, from those in which the chart begins, until no others come.

use super::super::several::Several;
use crate::model::StepId;
use crate::program::{Expr, Meeting, PlaceId, Statement, Value};
use crate::sorted::Set;

/// Of more steps nothing is said: each two regions are followed through the cycle, which takes longer than a build should.
const MOST: usize = 100;

/// Of each two regions, if not all their states meet.
pub(super) fn meetings(several: &Several<'_, '_>, round: &[Statement<'_>], begin: &[Option<StepId>]) -> Vec<Meeting> {
    let mut found = Vec::new();
    let states = (0..several.states.len()).map(|region| several.possible(region).len());
    if states.sum::<usize>() > MOST {
        return found;
    }
    for second in 0..several.states.len() {
        for first in 0..second {
            let regions = [first, second];
            let two = Two {
                places: regions.map(|region| several.states[region]),
                possible: regions.map(|region| several.possible(region)),
            };
            let states = two.reached(regions.map(|region| begin[region]), round);
            if states.len() < two.possible[0].len() * two.possible[1].len() {
                found.push(Meeting { regions, states });
            }
        }
    }
    found
}

impl Several<'_, '_> {
    /// Whether some state of one of two regions tells that the other one has a step, which it does not always have.
    pub(super) fn keeps_a_step(&self, meeting: &Meeting) -> bool {
        (0..2).any(|side| {
            let [region, other] = [meeting.regions[side], meeting.regions[1 - side]];
            let without = meeting.states.iter().filter(|states| states[side].is_none()).count();
            !self.full[region] && without < self.possible(other).len()
        })
    }
}

/// The states of both regions.
type Pair = [Option<StepId>; 2];

struct Two {
    places: [PlaceId; 2],
    possible: [Vec<Option<StepId>>; 2],
}

/// What of a round moves one of the two.
enum Move<'s, 'm> {
    To(usize, Option<StepId>),
    Anywhere,
    If(&'s Expr<'m>, Vec<Self>, Vec<Self>),
    /// By the state of one of them, or of something else.
    Match(Option<usize>, Vec<(&'s [Value], Vec<Self>)>, Vec<Self>),
}

impl Two {
    /// What comes in any number of rounds.
    fn reached(&self, begin: Pair, round: &[Statement<'_>]) -> Set<Pair> {
        let moves = self.moves(round);
        let (mut all, mut new) = (Set::from([begin]), Set::from([begin]));
        while !new.is_empty() {
            new = self.after(&moves, new);
            new.retain(|pair| all.insert(*pair));
        }
        all
    }

    /// Which of the two has its state there.
    fn side(&self, place: PlaceId) -> Option<usize> {
        self.places.iter().position(|one| *one == place)
    }

    fn moves<'s, 'm>(&self, statements: &'s [Statement<'m>]) -> Vec<Move<'s, 'm>> {
        let mut moves = Vec::new();
        for statement in statements {
            match statement {
                Statement::Part(_, body) => moves.append(&mut self.moves(body)),
                Statement::Set(place, value) => match (self.side(*place), value) {
                    (None, _) => {}
                    (Some(side), Expr::Value(Value::Step(step))) => moves.push(Move::To(side, *step)),
                    (Some(_), _) => moves.push(Move::Anywhere),
                },
                Statement::If(condition, then, otherwise) => {
                    let (then, otherwise) = (self.moves(then), self.moves(otherwise));
                    if !then.is_empty() || !otherwise.is_empty() {
                        moves.push(Move::If(condition, then, otherwise));
                    }
                }
                Statement::Match(place, arms, otherwise) => {
                    let otherwise = self.moves(otherwise);
                    let mut ways = Vec::with_capacity(arms.len());
                    for (values, body) in arms {
                        ways.push((&values[..], self.moves(body)));
                    }
                    if !otherwise.is_empty() || ways.iter().any(|(_, body)| !body.is_empty()) {
                        moves.push(Move::Match(self.side(*place), ways, otherwise));
                    }
                }
                Statement::Loop { .. } => moves.push(Move::Anywhere),
                _ => {}
            }
        }
        moves
    }

    fn after(&self, moves: &[Move<'_, '_>], mut pairs: Set<Pair>) -> Set<Pair> {
        for one in moves {
            if pairs.is_empty() {
                break;
            }
            pairs = match one {
                Move::To(side, step) => to(*side, *step, pairs),
                Move::Anywhere => self.anything(),
                Move::If(condition, then, otherwise) => {
                    let where_it = |holds: bool| only(&pairs, &|pair| self.may(condition, holds, pair));
                    let mut met = self.after(then, where_it(true));
                    met.extend(self.after(otherwise, where_it(false)).iter().copied());
                    met
                }
                Move::Match(side, ways, otherwise) => self.matched(*side, ways, otherwise, &pairs),
            };
        }
        pairs
    }

    fn anything(&self) -> Set<Pair> {
        let mut all = Set::new();
        for one in &self.possible[0] {
            all.extend(self.possible[1].iter().map(|other| [*one, *other]));
        }
        all
    }

    fn matched(
        &self,
        side: Option<usize>,
        ways: &[(&[Value], Vec<Move<'_, '_>>)],
        otherwise: &[Move<'_, '_>],
        pairs: &Set<Pair>,
    ) -> Set<Pair> {
        let names = |values: &[Value], pair: &Pair| side.is_none_or(|side| values.contains(&Value::Step(pair[side])));
        let mut met = Set::new();
        for (values, body) in ways {
            met.extend(self.after(body, only(pairs, &|pair| names(values, pair))).iter().copied());
        }
        let others = |pair: &Pair| side.is_none() || !ways.iter().any(|(values, _)| names(values, pair));
        met.extend(self.after(otherwise, only(pairs, &others)).iter().copied());
        met
    }

    /// Whether a condition may be so.
    fn may(&self, condition: &Expr<'_>, holds: bool, pair: &Pair) -> bool {
        match condition {
            Expr::Value(Value::Bool(value)) => *value == holds,
            Expr::Is(place, steps) => {
                self.side(*place).is_none_or(|side| pair[side].is_some_and(|step| steps.contains(&step)) == holds)
            }
            Expr::Not(inner) => self.may(inner, !holds, pair),
            Expr::All(parts) if holds => parts.iter().all(|part| self.may(part, true, pair)),
            Expr::All(parts) => parts.iter().any(|part| self.may(part, false, pair)),
            Expr::Any(parts) if holds => parts.iter().any(|part| self.may(part, true, pair)),
            Expr::Any(parts) => parts.iter().all(|part| self.may(part, false, pair)),
            _ => true,
        }
    }
}

fn to(side: usize, step: Option<StepId>, pairs: Set<Pair>) -> Set<Pair> {
    let mut met = Set::new();
    for mut pair in pairs {
        pair[side] = step;
        met.insert(pair);
    }
    met
}

fn only(pairs: &Set<Pair>, which: &dyn Fn(&Pair) -> bool) -> Set<Pair> {
    let mut left = Set::new();
    left.extend(pairs.iter().filter(|pair| which(pair)).copied());
    left
}
