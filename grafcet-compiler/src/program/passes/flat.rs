//! A cycle as one list: paragraphs opened, what asks whether this is the first cycle asked by each statement of its own, long lists of
//! `||` spread over statements, so that each of them stands for the states in which it matters. Of a sequence, what is sampled of inputs alone comes first.
//!
//! ```text
//! -- evolution                          if first: entered.A = true
//! if first: entered.A = true            if !first: clears.A→B = …
//! else: clears.A→B = …          ->      …
//! if clears.A→B || …: evolved           any.0 = any.0 || clears.A→B
//!                                       …
//!                                       if any.0: evolved
//! ```

use super::super::build::{no, not};
use super::super::{Expr, PlaceId, PlaceInfo, Statement};
use super::uses::{Effects, is_plain, is_pure};

/// Lists of `||` that are longer are spread.
const LONG: usize = 6;

/// The list, and places for what is spread in it.
pub(super) fn flat<'m>(
    statements: &[Statement<'m>],
    first: Option<PlaceId>,
    in_loop: bool,
    places: &mut Vec<PlaceInfo<'m>>,
) -> Vec<Statement<'m>> {
    let mut flat = Flat { first, in_loop, places, list: Vec::new() };
    flat.add(statements, None);
    flat.list
}

/// What is sampled of inputs alone is the same in the whole cycle: it is done first, in all states alike.
pub(super) fn samples_first(list: &mut [Statement<'_>], places: &[PlaceInfo<'_>]) {
    let mut written = vec![0_u32; places.len()];
    for place in list.iter().flat_map(|one| Effects::of(one).writes) {
        written[place.0] += 1;
    }
    let mut read = vec![false; places.len()];
    let mut first = 0;
    for at in 0..list.len() {
        let effects = Effects::of(&list[at]);
        let is_sample = matches!(&list[at], Statement::Set(place, value)
            if written[place.0] == 1 && !read[place.0] && !places[place.0].is_field && is_pure(value));
        if is_sample && effects.reads.is_empty() {
            list[first..=at].rotate_right(1);
            first += 1;
        }
        for place in &*effects.reads {
            read[place.0] = true;
        }
    }
}

struct Flat<'f, 'm> {
    first: Option<PlaceId>,
    /// It is done several times in a cycle.
    in_loop: bool,
    places: &'f mut Vec<PlaceInfo<'m>>,
    list: Vec<Statement<'m>>,
}

impl<'m> Flat<'_, 'm> {
    fn add(&mut self, statements: &[Statement<'m>], guard: Option<&Expr<'m>>) {
        for statement in statements {
            match statement {
                Statement::Part(_, body) => self.add(body, guard),
                Statement::If(Expr::Place(place), then, otherwise)
                    if guard.is_none() && Some(*place) == self.first && !writes(*place, then, otherwise) =>
                {
                    let condition = Expr::Place(*place);
                    self.add(then, Some(&condition));
                    self.add(otherwise, Some(&not(condition)));
                }
                Statement::Set(place, value) => {
                    let value = self.spread(value, guard);
                    self.push(Statement::Set(*place, value), guard);
                }
                Statement::If(condition, then, otherwise) => {
                    let condition = self.spread(condition, guard);
                    self.push(Statement::If(condition, then.clone(), otherwise.clone()), guard);
                }
                other => self.push(other.clone(), guard),
            }
        }
    }

    fn push(&mut self, statement: Statement<'m>, guard: Option<&Expr<'m>>) {
        self.list.push(match guard {
            Some(guard) => Statement::If(guard.clone(), vec![statement], Vec::new()),
            None => statement,
        });
    }

    fn spread(&mut self, expr: &Expr<'m>, guard: Option<&Expr<'m>>) -> Expr<'m> {
        match expr {
            Expr::Not(inner) => not(self.spread(inner, guard)),
            Expr::All(parts) => {
                let mut all = Vec::with_capacity(parts.len());
                for part in parts {
                    all.push(self.spread(part, guard));
                }
                Expr::All(all)
            }
            Expr::Choose(parts) => {
                let [condition, then, otherwise] = &**parts;
                let condition = self.spread(condition, guard);
                Expr::Choose(Box::new([condition, self.spread(then, guard), self.spread(otherwise, guard)]))
            }
            Expr::Any(parts) if parts.len() > LONG => {
                let place = PlaceId(self.places.len());
                self.places.push(PlaceInfo::truth(format!("any.{}", place.0)));
                if self.in_loop {
                    self.push(Statement::Set(place, no()), guard);
                }
                let (mut rest, mut any) = (vec![Expr::Place(place)], false);
                for part in parts {
                    // What the user wrote stays where it is asked.
                    if is_plain(part) {
                        let or = Expr::Any(vec![Expr::Place(place), part.clone()]);
                        self.push(Statement::Set(place, or), guard);
                        any = true;
                    } else {
                        rest.push(part.clone());
                    }
                }
                if any { Expr::Any(rest) } else { expr.clone() }
            }
            other => other.clone(),
        }
    }
}

fn writes(place: PlaceId, then: &[Statement<'_>], otherwise: &[Statement<'_>]) -> bool {
    let mut effects = Effects::of_all(then);
    effects.add_all(otherwise);
    effects.writes.contains(&place)
}
