//! A program executed on values: for tests and tools, without rustc.
//!
//! Of Rust that the model does not look into, whoever runs it is asked ([`Foreign`]).

mod eval;
mod value;

use std::fmt;

use super::{Expr, Initial, Mark, Phase, PlaceId, Program, Role, Run, Statement, Type, Value, Wait};
use crate::model::{ActionId, Expr as Written, Place, Read, Statement as Code, StepId, Ty};
pub use value::Error;
use value::Term;

/// Rust of the user that nothing is known about.
pub trait Foreign {
    /// The value of an expression, or of a part of one, by what it reads.
    ///
    /// # Errors
    /// It has none.
    fn value(&mut self, text: &str, reads: &[(Read, Value)]) -> Result<Value, Error>;

    /// What a block writes, by what it reads.
    ///
    /// # Errors
    /// It cannot be run.
    fn block(&mut self, text: &str, reads: &[(Read, Value)]) -> Result<Vec<(Place, Value)>, Error>;
}

/// There is no such Rust.
pub struct Nothing;

impl Foreign for Nothing {
    fn value(&mut self, text: &str, _: &[(Read, Value)]) -> Result<Value, Error> {
        Err(Error::NotUnderstood(text.to_owned()))
    }

    fn block(&mut self, text: &str, _: &[(Read, Value)]) -> Result<Vec<(Place, Value)>, Error> {
        Err(Error::NotUnderstood(text.to_owned()))
    }
}

/// A call of a declared action.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Call {
    pub action: ActionId,
    pub phase: Phase,
    pub args: Vec<Value>,
}

/// What one cycle showed.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Cycle {
    /// In the order in which they were made.
    pub calls: Vec<Call>,
    /// What observers were told, in its order.
    pub marks: Vec<Mark>,
}

/// A program that is being executed.
pub struct Machine<'p, 'm> {
    program: &'p Program<'m>,
    /// By place.
    values: Vec<Value>,
    initial: Vec<Value>,
}

impl<'p, 'm> Machine<'p, 'm> {
    /// In its initial state (A1), with the parameters of the source.
    ///
    /// # Errors
    /// An initial value is not understood.
    pub fn new(program: &'p Program<'m>, foreign: &mut dyn Foreign) -> Result<Self, Error> {
        let mut initial = Vec::new();
        for place in &program.places {
            let value = match place.initial {
                Initial::Value(value) => value,
                Initial::Constant(expr) => constant(program, expr, place.ty, foreign)?,
                Initial::Default => default(place.ty),
            };
            initial.push(value);
        }
        Ok(Self { program, values: initial.clone(), initial })
    }

    /// The classic *Init*: all fields begin anew, but for the parameters.
    pub fn init(&mut self) {
        for (index, place) in self.program.places.iter().enumerate() {
            if !matches!(place.role, Role::Param(_)) {
                self.values[index] = self.initial[index];
            }
        }
    }

    /// The value of a place.
    #[must_use]
    pub fn value(&self, place: PlaceId) -> Value {
        self.values[place.0]
    }

    /// The values of all places.
    #[must_use]
    pub fn values(&self) -> &[Value] {
        &self.values
    }

    /// Exchanges the value of a place, as of a parameter.
    pub fn set(&mut self, place: PlaceId, value: Value) {
        self.values[place.0] = value;
    }

    /// The active steps.
    #[must_use]
    pub fn active(&self) -> Vec<StepId> {
        self.program.active(&self.values)
    }

    /// One cycle with one value per input, in the order of declaration.
    ///
    /// # Errors
    /// Something is not understood, or would panic in Rust. The machine is then somewhere inside the cycle.
    pub fn cycle(&mut self, inputs: &[Value], now: u32, foreign: &mut dyn Foreign) -> Result<Cycle, Error> {
        for (index, place) in self.program.places.iter().enumerate() {
            if !place.is_field {
                self.values[index] = self.initial[index];
            }
        }
        let mut running = Running {
            program: self.program,
            values: &mut self.values,
            initial: &self.initial,
            inputs,
            now,
            foreign,
            done: Cycle::default(),
        };
        running.block(&self.program.cycle)?;
        Ok(running.done)
    }

    /// The steps whose times were over at the end of the last cycle.
    ///
    /// # Errors
    /// As for [`Machine::cycle`].
    pub fn late_steps(&self, foreign: &mut dyn Foreign) -> Result<Vec<StepId>, Error> {
        let (mut values, active) = (self.values.clone(), self.program.active(&self.values));
        let mut running = Running {
            program: self.program,
            values: &mut values,
            initial: &self.initial,
            inputs: &[],
            now: 0,
            foreign,
            done: Cycle::default(),
        };
        let mut late = Vec::new();
        for (step, over) in self.program.deadline.iter().flat_map(|deadline| &deadline.late) {
            if active.contains(step) && running.holds(over)? {
                late.push(*step);
            }
        }
        Ok(late)
    }

    /// The reading of the clock before which nothing changes unless an input does; none where only an input can change anything.
    ///
    /// # Errors
    /// As for [`Machine::cycle`].
    pub fn next_deadline(&self, foreign: &mut dyn Foreign) -> Result<Option<u32>, Error> {
        let Some(deadline) = &self.program.deadline else { return Ok(None) };
        let reading = |place: PlaceId| match self.values[place.0] {
            Value::Ticks(now) => Ok(now),
            other => Err(Error::Type(format!("{other:?} for a time"))),
        };
        let mut values = self.values.clone();
        let mut running = Running {
            program: self.program,
            values: &mut values,
            initial: &self.initial,
            inputs: &[],
            now: 0,
            foreign,
            done: Cycle::default(),
        };
        if running.holds(&deadline.at_once)? {
            return Ok(Some(running.ticks(&deadline.reading)?));
        }
        let (mut soonest, is_one) = (None::<(u32, u32)>, deadline.has_one_clock());
        for Wait { condition, from, time } in &deadline.waits {
            if running.holds(condition)? {
                let time = running.ticks(time)?;
                let end = reading(*from)?.wrapping_add(time);
                // Times that count from different readings are all still to come, within half of the clock's range from the last cycle.
                let is_sooner = |(other, other_end): (u32, u32)| {
                    if is_one { time < other } else { end.wrapping_sub(other_end) > u32::MAX / 2 }
                };
                if soonest.is_none_or(is_sooner) {
                    soonest = Some((time, end));
                }
            }
        }
        Ok(soonest.map(|(_, end)| end))
    }
}

/// A cycle under way.
struct Running<'r, 'm> {
    program: &'r Program<'m>,
    values: &'r mut [Value],
    initial: &'r [Value],
    inputs: &'r [Value],
    now: u32,
    foreign: &'r mut dyn Foreign,
    done: Cycle,
}

/// How a statement ends.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    /// The next one follows.
    Goes,
    /// The loop is left.
    Breaks,
}

impl<'m> Running<'_, 'm> {
    fn block(&mut self, statements: &[Statement<'m>]) -> Result<End, Error> {
        for statement in statements {
            if self.statement(statement)? == End::Breaks {
                return Ok(End::Breaks);
            }
        }
        Ok(End::Goes)
    }

    fn statement(&mut self, statement: &Statement<'m>) -> Result<End, Error> {
        match statement {
            Statement::Part(_, body) => return self.block(body),
            Statement::Set(place, value) => {
                let value = self.eval(value)?;
                self.write(*place, value)?;
            }
            Statement::If(condition, then, otherwise) => {
                let branch = if self.holds(condition)? { then } else { otherwise };
                return self.block(branch);
            }
            Statement::Match(place, arms, otherwise) => {
                let value = self.values[place.0];
                let arm = arms.iter().find(|(of, _)| of.contains(&value));
                return self.block(arm.map_or(otherwise, |(_, body)| body));
            }
            Statement::Loop { rounds, body } => {
                for _ in 0..*rounds {
                    if self.block(body)? == End::Breaks {
                        return Ok(End::Goes);
                    }
                }
                return Err(Error::Bound(*rounds));
            }
            Statement::Break => return Ok(End::Breaks),
            Statement::Run(run) => self.run(run)?,
            Statement::Call(action, phase, args) => {
                let params = &self.program.model.actions[*action].params;
                let phase = match self.eval(phase)? {
                    Term::Value(Value::Phase(phase)) => phase,
                    other => return Err(Error::Type(format!("{other:?} for a phase"))),
                };
                let mut given = Vec::new();
                for (arg, (_, ty)) in args.iter().zip(params) {
                    given.push(self.eval(arg)?.into_declared(ty)?);
                }
                self.done.calls.push(Call { action: *action, phase, args: given });
            }
            Statement::Mark(mark) => self.done.marks.push(*mark),
            Statement::Fence(_) => {}
        }
        Ok(End::Goes)
    }

    fn write(&mut self, place: PlaceId, value: Term) -> Result<(), Error> {
        self.values[place.0] = value.into_value(self.program.places[place.0].ty)?;
        Ok(())
    }

    /// A block of the user.
    fn run(&mut self, run: &Run<'m>) -> Result<(), Error> {
        if let Some(statements) = &run.code.statements {
            return self.code(statements, run);
        }
        let reads = self.read_all(&run.binds, None)?;
        for (place, value) in self.foreign.block(&run.code.text, &reads)? {
            self.assign(place, Term::of(value, None), run)?;
        }
        Ok(())
    }

    fn code(&mut self, statements: &[Code], run: &Run<'m>) -> Result<(), Error> {
        for statement in statements {
            match statement {
                Code::Assign(place, tree) => {
                    let value = self.tree(tree, &run.binds)?;
                    self.assign(*place, value, run)?;
                }
                Code::If(condition, then, otherwise) => {
                    let branch = if self.tree(condition, &run.binds)?.bool()? { then } else { otherwise };
                    self.code(branch, run)?;
                }
            }
        }
        Ok(())
    }

    fn assign(&mut self, place: Place, value: Term, run: &Run<'m>) -> Result<(), Error> {
        let Some(write) = run.writes.iter().find(|write| write.name == place) else {
            return Err(Error::NotUnderstood(run.code.text.clone()));
        };
        self.write(write.to, value)?;
        if let Some(noted) = write.noted {
            self.values[noted.0] = Value::Bool(true);
        }
        Ok(())
    }
}

/// What stands after `=` in a declaration.
fn constant<'m>(
    program: &Program<'m>,
    expr: &Written,
    ty: Type<'m>,
    foreign: &mut dyn Foreign,
) -> Result<Value, Error> {
    let mut binds = Vec::new();
    for read in &expr.reads {
        if let Read::Ticks(ticks) = read {
            binds.push((*read, Expr::Value(Value::Ticks(*ticks))));
        }
    }
    let mut running =
        Running { program, values: &mut [], initial: &[], inputs: &[], now: 0, foreign, done: Cycle::default() };
    running.tree(&expr.tree, &binds)?.into_value(ty)
}

fn default(ty: Type<'_>) -> Value {
    match ty {
        Type::Bool => Value::Bool(false),
        Type::Ticks => Value::Ticks(0),
        Type::State(_) => Value::Step(None),
        Type::Number | Type::Kind { .. } | Type::User(Ty::Int { .. }) => Value::Int(0),
        // Of enums whose variants are listed the first one; of others only the caller knows.
        Type::User(_) => Value::Other(0),
    }
}

impl fmt::Debug for Machine<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut map = f.debug_map();
        for (place, value) in self.program.places.iter().zip(&self.values).filter(|(place, _)| place.is_field) {
            map.entry(&place.name, value);
        }
        map.finish()
    }
}
