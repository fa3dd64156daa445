//! An interpreter of the model: a second opinion on what a chart does.
//!
//! It is written from the page of decisions (A1-A38) alone and shares nothing with `program` and `codegen`; clarity counts, speed does
//! not. Situations are sets of steps, conditions are evaluated over the expression tree, and each function implements a
//! paragraph of that page.
//!
//! - [`Interpreter`]: the chart as a machine; [`ClosedLoop`]: the same with its plants
//! - `state`, `view`: what it remembers, and the snapshot that an expression sees
//! - `any`: the transitions from every step, in both dialects
//! - `sfc`, `control`: IEC 61131-3, one evolution and `ACTION_CONTROL`
//! - `grafcet`, `hierarchy`, `stored`, `continuous`: IEC 60848
//! - `rest`: whether the next cycle has something to do without an input and without time
//! - `recall`, `by_state`: a memory put together from a recorded state, and what follows from the active step alone
//! - `remembered`: edges and delays of properties
//! - `time`, `value`: delays and timers, values and their arithmetic
//! - `variant`: those of enums, listed or not

mod any;
mod by_state;
mod check;
mod closed;
mod computed;
mod continuous;
mod control;
mod grafcet;
mod hierarchy;
mod look;
mod modes;
mod real;
mod recall;
mod remembered;
mod rest;
mod sfc;
mod state;
mod stored;
mod time;
mod value;
mod variant;
mod view;
mod world;

use std::collections::BTreeSet;

pub use self::closed::{ClosedLoop, Round};
pub use self::continuous::is_combinational;
use self::grafcet::{Grafcet, Until};
pub use self::look::{Counted, Look};
pub use self::modes::Mode;
pub use self::real::{Real, Symbol};
pub use self::recall::{Recalled, is_part};
pub use self::remembered::Remembered;
pub use self::rest::Rest;
use self::sfc::Sfc;
use self::state::State;
pub(crate) use self::value::is_literal;
pub use self::value::{Error, Value};
pub use self::view::Situation;
use self::view::View;
use self::world::Given;
pub use self::world::{Nothing, World};
use grafcet_compiler::model::{
    ActionId, AssociationId, Blinker, Dialect, Expr, Model, Name, StepId, TransitionId, Tree, Ty,
};

/// Which call of a code action this is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Phase {
    /// The action has become active, or runs once.
    First,
    /// It is still active.
    Repeated,
    /// The final scan: it is no longer active.
    Final,
}

/// A call of a declared action.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Call {
    /// Which action.
    pub action: ActionId,
    /// What it is told.
    pub phase: Phase,
    /// In the order of the action's parameters.
    pub args: Vec<Value>,
}

/// What one cycle showed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cycle {
    /// In the order of declaration.
    pub outputs: Vec<Value>,
    /// The active steps at the end of the cycle.
    pub active: BTreeSet<StepId>,
    /// In the order in which they were made.
    pub calls: Vec<Call>,
    /// The associations that ran, in their order: calls, blocks, assignments, and in `grafcet` what is stored. Not what is continuous.
    pub ran: Vec<AssociationId>,
    /// `grafcet`: the search ended in a stable situation (A30). Always true in `sfc`.
    pub stable: bool,
    /// `grafcet`: the evolutions of the search that changed something; the activation of the initial situation is not
    /// counted. `sfc`: one where a transition was cleared.
    pub evolutions: u32,
    /// `sfc`: a block ran, or an assignment found another value than it wrote.
    pub stirred: bool,
    /// Every evolution that was looked at, in their order; [`Cycle::done`] has those that took place. The activation of the initial
    /// situation is none.
    pub seen: Vec<Evolution>,
}

impl Cycle {
    /// The evolutions that took place: all but the one at which the bound stopped a search (A30). That with which a search finds that it is
    /// stable changes nothing, but may clear what leads to the same situation.
    #[must_use]
    pub fn done(&self) -> &[Evolution] {
        match self.seen.split_last() {
            Some((_, done)) if !self.stable => done,
            _ => &self.seen,
        }
    }
}

/// What one evolution looked at and did.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Evolution {
    /// The situation before it.
    pub before: Situation,
    /// The transitions enabled in it (A17; frozen ones are not).
    pub enabled: BTreeSet<TransitionId>,
    /// Those of them whose condition held.
    pub fireable: BTreeSet<TransitionId>,
    /// Those of them that cleared: neither the priority of another branch (A28) nor the hierarchy (A11, A19) was against it.
    pub cleared: BTreeSet<TransitionId>,
    /// The situation after it.
    pub after: Situation,
}

/// A chart that is being executed.
#[derive(Clone)]
pub struct Interpreter<'m> {
    model: &'m Model,
    params: Vec<Value>,
    memory: Memory,
    max_evolutions: u32,
}

/// Everything that a running chart remembers between two cycles, its parameters excepted: with equal memories it
/// does the same for ever.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Memory {
    state: State,
    machine: Machine,
}

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Machine {
    Sfc(Sfc),
    Grafcet(Grafcet),
}

impl<'m> Interpreter<'m> {
    /// The chart in its initial situation (A1), with the parameters of the source.
    ///
    /// # Errors
    /// If a declared type or an initial value is not understood, if something depends on itself (A14, A22), or if a
    /// qualifier has a target that it cannot have in the dialect (A32).
    pub fn new(model: &'m Model) -> Result<Self, Error> {
        check::targets(model)?;
        check::combinational_circles(model)?;
        let memory = Memory::initial(model)?;
        // A30: twice the number of steps plus two.
        let default = u32::try_from(model.steps.len()).unwrap_or(u32::MAX).saturating_mul(2).saturating_add(2);
        Ok(Self {
            model,
            params: state::constants(model.params.iter().map(|(id, p)| (Name::Param(id), &p.init)), model)?,
            memory,
            max_evolutions: model.max_evolutions.unwrap_or(default),
        })
    }

    /// Exchanges the recipe: one value per `param`, in the order of declaration, from the next cycle on.
    ///
    /// # Errors
    /// If there are not as many values as parameters, or one does not fit its declared type or is not in its range.
    pub fn set_params(&mut self, params: &[Value]) -> Result<(), Error> {
        accept_all(params, self.model.params.values().map(|p| &p.ty))?;
        for (param, value) in self.model.params.values().zip(params) {
            let Some(range) = &param.range else { continue };
            let is_in = match value {
                Value::Int(value) => range.contains(*value),
                Value::Ticks(ticks) => range.contains(i128::from(*ticks)),
                _ => true,
            };
            if !is_in {
                let name = param.name.to_string();
                return Err(Error::OutOfRange(name.trim_start_matches("r#").to_owned(), range.text.clone()));
            }
        }
        self.params = params.to_vec();
        Ok(())
    }

    /// The parameters in force, in the order of declaration.
    #[must_use]
    pub fn params(&self) -> &[Value] {
        &self.params
    }

    /// The classic *Init*: the next cycle starts like a first one. Stored outputs and variables have their initial values
    /// at once, no deactivation action runs, the parameters stay.
    ///
    /// # Errors
    /// Those of [`Interpreter::new`] about initial values.
    pub fn init(&mut self) -> Result<(), Error> {
        self.memory = Memory::initial(self.model)?;
        Ok(())
    }

    /// One cycle with one value per `input`, in the order of declaration. `now` is a wrapping count in the unit of the
    /// chart's clock.
    ///
    /// # Errors
    /// If the inputs do not fit their declarations, or an expression is not understood or would panic in Rust; the
    /// interpreter is then somewhere inside the cycle and of no further use.
    pub fn cycle(&mut self, inputs: &[Value], now: u32) -> Result<Cycle, Error> {
        self.cycle_in(&Nothing, inputs, now)
    }

    /// The same with what the program around the chart contributes.
    ///
    /// # Errors
    /// As of [`Interpreter::cycle`].
    pub fn cycle_in(&mut self, world: &dyn World, inputs: &[Value], now: u32) -> Result<Cycle, Error> {
        self.run(world, inputs, now, None)
    }

    /// A38: one cycle that leads into a situation by hand. Whether the chart can ever be in it, nobody asks here.
    ///
    /// # Errors
    /// As of [`Interpreter::cycle`].
    pub fn force_in(
        &mut self,
        world: &dyn World,
        situation: &Situation,
        inputs: &[Value],
        now: u32,
    ) -> Result<Cycle, Error> {
        self.run(world, inputs, now, Some(situation))
    }

    fn run(
        &mut self,
        world: &dyn World,
        inputs: &[Value],
        now: u32,
        forced: Option<&Situation>,
    ) -> Result<Cycle, Error> {
        accept_all(inputs, self.model.inputs.values().map(|i| &i.ty))?;
        let Memory { state, machine } = &mut self.memory;
        let elapsed = state.advance(now);
        let given = Given { inputs, params: &self.params, world };
        let (calls, ran, stable, evolutions, stirred, seen) = match machine {
            Machine::Sfc(sfc) => {
                let scan = sfc.cycle(self.model, state, given, elapsed, forced)?;
                let evolved = scan.evolution.as_ref().is_some_and(|evolution| !evolution.cleared.is_empty());
                (scan.calls, scan.ran, true, u32::from(evolved), scan.stirred, scan.evolution.into_iter().collect())
            }
            Machine::Grafcet(grafcet) => {
                let search = match forced {
                    Some(situation) => grafcet.force(self.model, state, given, elapsed, situation)?,
                    None => grafcet.cycle(self.model, state, given, elapsed, Until::Bound(self.max_evolutions))?,
                };
                (search.calls, search.ran, search.stable, search.evolutions, false, search.seen)
            }
        };
        state.first = false;
        let (outputs, active) = (state.outputs.clone(), state.situation.clone());
        Ok(Cycle { outputs, active, calls, ran, stable, evolutions, stirred, seen })
    }

    /// The evolutions of one turn of the search of a cycle that would go on for ever, if they show within so many; the interpreter
    /// is then in the middle of it. Empty where the search ends.
    ///
    /// # Errors
    /// As of [`Interpreter::cycle`].
    pub fn turn(&mut self, inputs: &[Value], now: u32, most: u32) -> Result<Option<Vec<Evolution>>, Error> {
        let Memory { state, machine } = &mut self.memory;
        let Machine::Grafcet(grafcet) = machine else { return Ok(Some(Vec::new())) };
        let elapsed = state.advance(now);
        let given = Given { inputs, params: &self.params, world: &Nothing };
        let mut search = grafcet.cycle(self.model, state, given, elapsed, Until::Turned(most))?;
        Ok(match search.turn {
            Some(turn) => Some(search.seen.split_off(search.seen.len() - turn)),
            None => search.stable.then(Vec::new),
        })
    }

    /// Whether an expression over inputs, outputs and steps holds at the end of the last cycle, whose inputs are given.
    ///
    /// # Errors
    /// The expression is not understood, or would panic in Rust.
    pub fn holds(&self, tree: &Tree, inputs: &[Value]) -> Result<bool, Error> {
        self.look(&Nothing, inputs).holds(tree)
    }

    /// What expressions are at the end of the last cycle, whose inputs are given: what the next one would find with the same inputs and
    /// without any time in between.
    #[must_use]
    pub fn look<'a>(&'a self, world: &'a dyn World, inputs: &'a [Value]) -> Look<'a> {
        let state = &self.memory.state;
        let delays = state.delays.iter().map(|(id, delayed)| (*id, delayed.output)).collect();
        Look {
            model: self.model,
            state,
            given: Given { inputs, params: &self.params, world },
            delays,
            remembered: None,
        }
    }

    /// The steps that have a time (`within`) which is over, as the last cycle has seen it.
    #[must_use]
    pub fn late_steps(&self) -> Vec<StepId> {
        let look = self.look(&Nothing, &[]);
        let is_late = |id: &StepId| {
            let over = |time| look.ticks(time).is_ok_and(|time| look.since(Blinker::Step(*id)) >= time);
            self.model.steps[*id].within().is_some_and(over)
        };
        self.situation().iter().copied().filter(is_late).collect()
    }

    /// What the chart remembers now.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Goes on from what the same chart remembered once.
    pub fn resume(&mut self, memory: Memory) {
        self.memory = memory;
    }

    /// The active steps; before the first cycle and after `init` the initial ones (A1).
    #[must_use]
    pub fn situation(&self) -> &Situation {
        &self.memory.state.situation
    }

    /// The variables, in the order of declaration. Combinational ones (A22) hold no value.
    #[must_use]
    pub fn vars(&self) -> &[Value] {
        &self.memory.state.vars
    }

    /// The outputs of the last cycle; before the first one and after `init` the initial values.
    #[must_use]
    pub fn outputs(&self) -> &[Value] {
        &self.memory.state.outputs
    }
}

impl Memory {
    /// A1: the initial situation with the initial values.
    fn initial(model: &Model) -> Result<Self, Error> {
        let state = State::initial(model)?;
        Ok(Self { machine: Machine::new(model, &state), state })
    }
}

impl Machine {
    fn new(model: &Model, state: &State) -> Self {
        match model.dialect {
            Dialect::Sfc => Self::Sfc(Sfc::new(model, state)),
            Dialect::Grafcet => Self::Grafcet(Grafcet::default()),
        }
    }
}

/// One value for each declared type, and each fits.
fn accept_all<'t>(values: &[Value], types: impl ExactSizeIterator<Item = &'t Ty>) -> Result<(), Error> {
    if values.len() != types.len() {
        return Err(Error::Count { expected: types.len(), found: values.len() });
    }
    values.iter().zip(types).try_for_each(|(value, ty)| value::accept(*value, ty).map(drop))
}

/// The arguments of a call, evaluated at the call (A31).
fn arguments(action: ActionId, args: &[Expr], view: &View<'_>) -> Result<Vec<Value>, Error> {
    let params = &view.model.actions[action].params;
    if args.len() != params.len() {
        return Err(Error::Count { expected: params.len(), found: args.len() });
    }
    args.iter().zip(params).map(|(arg, (_, ty))| view.eval(&arg.tree)?.into_value(ty)).collect()
}
