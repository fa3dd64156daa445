//! An output that ends each cycle with what a field holds is set from it after the ways.
//!
//! ```text
//! match state                      match state
//!   A:                               A: memory = true
//!     memory = true                  B: memory = false
//!     lamp = true           ->     lamp = memory
//!   B: memory = false
//!   else: lamp = memory
//! ```
//!
//! So is an output that is more in some states: that part of it alone is set there.
//!
//! ```text
//! match state                          match state
//!   A: lamp = memory || 2s are over      A: lamp = 2s are over
//!   B:                                   B: memory = true
//!     memory = true               ->   if memory: lamp = true
//!     lamp = true
//!   else: lamp = memory
//! ```
//!
//! Needs: nothing asks for the output within the cycle; on each way it ends with the value of the field, or is
//! set at most once, to true, to more than the field, or to anything where the field is false.

use super::super::build::{any, yes};
use super::super::{Expr, PlaceId, Program, Role, Statement, Value};
use super::edits::{blocks_mut, unset};
use super::fold::initial;
use super::uses::{Effects, blocks, is_plain, mentions, sum, writes_to};
use crate::sorted::Set;

/// From so many places that set it on it pays.
const PLACES: usize = 3;

/// More ways than this are not told apart.
const MOST: usize = 64;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.forced.is_some() {
        return;
    }
    let mut pairs = Vec::new();
    find(program, &program.cycle, &mut pairs);
    for (output, field) in pairs {
        if count(&program.cycle, output) < PLACES {
            continue;
        }
        let mut shown = Shown { program, output, field, in_part: false };
        if shown.always() {
            unset(&mut program.cycle, output);
            program.cycle.push(Statement::Set(output, Expr::Place(field)));
            continue;
        }
        shown.in_part = true;
        if shown.always() {
            let before = count(&program.cycle, output);
            let mut cycle = program.cycle.clone();
            keep_more(&mut cycle, output, field);
            if count(&cycle, output) + PLACES <= before {
                cycle.push(Statement::If(Expr::Place(field), vec![Statement::Set(output, yes())], Vec::new()));
                program.cycle = cycle;
            }
        }
    }
}

/// What an output is without the field.
fn keep_more(statements: &mut Vec<Statement<'_>>, output: PlaceId, field: PlaceId) {
    let mut new = Vec::with_capacity(statements.len());
    for at in 0..statements.len() {
        if !is_told(&statements[..=at], output, field) {
            new.push(statements[at].clone());
        }
    }
    for statement in &mut new {
        if let Statement::Set(place, value) = statement {
            if let (true, Some(more)) = (*place == output, more_than(value, field)) {
                *value = more;
            }
        }
        for block in blocks_mut(statement) {
            keep_more(block, output, field);
        }
    }
    *statements = new;
}

/// Whether the last of these statements sets the output to what the field is known to hold.
fn is_told(statements: &[Statement<'_>], output: PlaceId, field: PlaceId) -> bool {
    let Some((Statement::Set(place, value), before)) = statements.split_last() else { return false };
    let sets_it = |one: &&Statement<'_>| writes_to(one, field);
    *place == output
        && match value {
            Expr::Place(from) => *from == field,
            Expr::Value(Value::Bool(true)) => {
                let last = before.iter().rev().find(sets_it);
                matches!(last, Some(Statement::Set(to, Expr::Value(Value::Bool(true)))) if *to == field)
            }
            _ => false,
        }
}

/// Of a field or something else, what else.
fn more_than<'m>(value: &Expr<'m>, field: PlaceId) -> Option<Expr<'m>> {
    let Expr::Any(parts) = value else { return None };
    let is_field = |part: &Expr<'m>| matches!(part, Expr::Place(place) if *place == field);
    let mut rest = parts.clone();
    rest.retain(|part| !is_field(part));
    (rest.len() < parts.len() && rest.iter().all(is_plain)).then(|| any(rest))
}

/// Outputs, and the fields that they are set from.
fn find(program: &Program<'_>, statements: &[Statement<'_>], pairs: &mut Vec<(PlaceId, PlaceId)>) {
    for statement in statements {
        if let Statement::Set(output, Expr::Place(field)) = statement {
            let (local, from) = (&program.places[output.0], &program.places[field.0]);
            let fits = !local.is_field && matches!(local.role, Role::Output(_)) && from.is_field;
            if fits && !pairs.contains(&(*output, *field)) {
                pairs.push((*output, *field));
            }
        }
        for block in blocks(statement) {
            find(program, block, pairs);
        }
    }
}

fn count(statements: &[Statement<'_>], output: PlaceId) -> usize {
    sum(statements, &|statement| usize::from(matches!(statement, Statement::Set(place, _) if *place == output)))
}

/// What one of them holds.
#[derive(Clone, Copy, PartialEq)]
enum Holds {
    Is(Value),
    /// The output: what the field holds, or more. The field: what it held when the cycle began.
    Same,
    Something,
    /// What the field held once, or more.
    Stale,
}

/// What they hold up to here on a way: the output, and the field.
type HeldPair = (Holds, Holds);

/// States that cannot be there, as another arm is for them.
type Out = Vec<(PlaceId, Value)>;

struct Shown<'p, 'm> {
    program: &'p Program<'m>,
    output: PlaceId,
    field: PlaceId,
    /// It may be more than the field.
    in_part: bool,
}

impl<'m> Shown<'_, 'm> {
    /// Whether each way ends with the value of the field, or with what is set on it beside that.
    fn always(&self) -> bool {
        let Some(begins) = initial(&self.program.places[self.output.0]) else { return false };
        let Some(ways) = self.block(&self.program.cycle, vec![(Holds::Is(begins), Holds::Same)], &Vec::new()) else {
            return false;
        };
        let is_off = Holds::Is(Value::Bool(false));
        if self.in_part && begins != Value::Bool(false) {
            return false;
        }
        ways.iter().all(|(output, field)| match output {
            Holds::Is(Value::Bool(true)) if self.in_part => true,
            Holds::Is(_) => output == field,
            Holds::Same => true,
            Holds::Something => self.in_part && *field == is_off,
            Holds::Stale => false,
        })
    }

    /// None where something asks for the output, or too much can be. `out` are states that cannot be there.
    fn block(&self, statements: &[Statement<'m>], mut ways: Vec<HeldPair>, out: &Out) -> Option<Vec<HeldPair>> {
        let mut out = out.clone();
        for (at, statement) in statements.iter().enumerate() {
            if self.in_part && is_told(&statements[..=at], self.output, self.field) {
                ways = each(ways, &|way| self.shows(way, Holds::Same));
                continue;
            }
            ways = self.after(statement, ways, &out)?;
            out.retain(|(place, value)| !may_put(statement, *place, *value));
            if ways.len() > MOST {
                return None;
            }
        }
        Some(ways)
    }

    fn after(&self, statement: &Statement<'m>, ways: Vec<HeldPair>, out: &Out) -> Option<Vec<HeldPair>> {
        let asks = |expr: &Expr<'m>| mentions(expr, self.output);
        Some(match statement {
            Statement::Part(_, body) => self.block(body, ways, out)?,
            Statement::Set(_, value) if asks(value) => return None,
            Statement::Set(place, value) => each(ways, &|way| self.set(*place, value, way)),
            Statement::If(condition, ..) if asks(condition) => return None,
            Statement::If(_, then, otherwise) => {
                let met = self.block(then, ways.clone(), out)?;
                both(met, self.block(otherwise, ways, out)?)
            }
            Statement::Match(place, arms, otherwise) => {
                let mut met = Vec::new();
                let mut rest = out.clone();
                for (values, _) in arms {
                    rest.extend(values.iter().map(|value| (*place, *value)));
                }
                if !is_nothing_left(self.program, *place, &rest) {
                    met = self.block(otherwise, ways.clone(), &rest)?;
                }
                for (values, body) in arms {
                    let starts = values.iter().all(|value| matches!(value, Value::Start(_)));
                    let begin = if starts { self.in_first(&ways) } else { ways.clone() };
                    met = both(met, self.block(body, begin, out)?);
                }
                met
            }
            Statement::Break => return None,
            other => {
                let effects = Effects::of(other);
                let is_within = matches!(other, Statement::Loop { .. }) && effects.writes.contains(&self.output);
                if effects.reads.contains(&self.output) || is_within {
                    return None;
                }
                let changed = effects.writes.contains(&self.field);
                each(ways, &|way| if changed { written(way, Holds::Something) } else { way })
            }
        })
    }

    fn set(&self, place: PlaceId, value: &Expr<'m>, (output, field): HeldPair) -> HeldPair {
        if place == self.field {
            let holds = if let Expr::Value(value) = value { Holds::Is(*value) } else { Holds::Something };
            return written((output, field), holds);
        }
        if place != self.output {
            return (output, field);
        }
        let holds = match value {
            Expr::Value(value) => Holds::Is(*value),
            _ if self.in_part && more_than(value, self.field).is_some() => Holds::Same,
            Expr::Place(from) if *from == self.field => {
                if let Holds::Is(_) = field {
                    field
                } else {
                    Holds::Same
                }
            }
            _ => Holds::Something,
        };
        self.shows((output, field), holds)
    }

    /// The output is set. What stays of it where that is more than the field is set once.
    fn shows(&self, (output, field): HeldPair, holds: Holds) -> HeldPair {
        let is_set = self.in_part && output != Holds::Is(Value::Bool(false));
        (if is_set { Holds::Stale } else { holds }, field)
    }

    /// The first cycle begins with the field's initial value.
    fn in_first(&self, ways: &[HeldPair]) -> Vec<HeldPair> {
        let Some(begins) = initial(&self.program.places[self.field.0]) else { return ways.to_vec() };
        let one = |(output, field): HeldPair| (output, if field == Holds::Same { Holds::Is(begins) } else { field });
        each(ways.to_vec(), &one)
    }
}

/// Whether there is no state left that a region could have.
fn is_nothing_left(program: &Program<'_>, place: PlaceId, out: &Out) -> bool {
    let Role::State(region) = program.places[place.0].role else { return false };
    let mut gone = Set::new();
    gone.extend(out.iter().filter(|(of, _)| *of == place).map(|(_, value)| *value));
    let is_out = |value: Value| gone.contains(&value);
    let is_none_out = program.full[region] || is_out(Value::Step(None));
    is_none_out && program.regions[region].iter().all(|step| is_out(Value::Step(Some(*step))))
}

/// Whether a statement may put a value into a place.
fn may_put(statement: &Statement<'_>, place: PlaceId, value: Value) -> bool {
    match statement {
        Statement::Set(to, Expr::Value(put)) => *to == place && *put == value,
        Statement::Set(to, _) => *to == place,
        Statement::Run(_) => writes_to(statement, place),
        other => blocks(other).into_iter().flatten().any(|one| may_put(one, place, value)),
    }
}

/// The field has been written.
fn written((output, _): HeldPair, field: Holds) -> HeldPair {
    (if output == Holds::Same { Holds::Stale } else { output }, field)
}

fn each(ways: Vec<HeldPair>, new: &dyn Fn(HeldPair) -> HeldPair) -> Vec<HeldPair> {
    let mut all = Vec::with_capacity(ways.len());
    for way in ways {
        let way = new(way);
        if !all.contains(&way) {
            all.push(way);
        }
    }
    all
}

fn both(mut one: Vec<HeldPair>, other: Vec<HeldPair>) -> Vec<HeldPair> {
    for way in other {
        if !one.contains(&way) {
            one.push(way);
        }
    }
    one
}
