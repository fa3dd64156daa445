//! A chart that runs.

use std::cell::RefCell;
use std::fmt;

use grafcet_compiler::model::{Association, Effect, Id, Model, Name, StepId, Ty};

use crate::blocked::{self, Blocked};
use crate::chart::Chart;
use crate::coverage::Coverage;
use crate::cycle::{Call, Cycle, Evolution, Forced, Ran};
use crate::interp::{self, Interpreter};
use crate::names::{Names, plain as plain_name};
use crate::program::{Around, Program};
use crate::value::{Value, inside, outside, plain};

/// A chart that runs from its source.
///
/// ```
/// use grafcet_sim::{Chart, Simulation};
///
/// let chart = Chart::parse(
///     "sfc Door { input open: bool; output motor: bool;
///        initial step Shut; step Opening { N motor; } Shut -[open]-> Opening -[4s/Opening]-> Shut; }",
/// )?;
/// let mut door = Simulation::new(&chart)?;
/// door.cycle(0, &[])?;
/// door.cycle(10, &[("open", true.into())])?;
/// let cycle = door.cycle(1_510, &[("open", false.into())])?;
/// assert!(door.is_active("Opening"));
/// assert_eq!(cycle.blocked.to_string(), "`Opening → Shut` waits for 2.5 s of `4s/Opening` still to go");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Simulation<'c> {
    chart: &'c Chart,
    machine: Interpreter<'c>,
    program: Program<'c>,
    inputs: Vec<interp::Value>,
    coverage: RefCell<Coverage>,
}

/// Why a chart cannot be run, or one cycle not.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Error {
    /// The chart has no input or parameter of that name.
    NoSuchName(String),
    /// The chart has no step of that name; a macro-step is none.
    NoSuchStep(String),
    /// The chart's own: a function that nobody supplied ([`Program`]), arithmetic that would panic, a value that does not fit its type.
    Chart(interp::Error),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchName(name) => write!(f, "the chart has no input or parameter `{name}`"),
            Self::NoSuchStep(name) => write!(f, "the chart has no step `{name}`"),
            Self::Chart(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Error {}

impl From<interp::Error> for Error {
    fn from(error: interp::Error) -> Self {
        Self::Chart(error)
    }
}

impl<'c> Simulation<'c> {
    /// The chart in its initial situation. All inputs are `false`, zero, or what the enum's first listed variant is.
    ///
    /// # Errors
    /// Something depends on itself, or an initial value is not understood.
    pub fn new(chart: &'c Chart) -> Result<Self, Error> {
        Self::beside(chart, Program::new())
    }

    /// The same with what the program around it contributes.
    ///
    /// # Errors
    /// As of [`Simulation::new`].
    pub fn beside(chart: &'c Chart, program: Program<'c>) -> Result<Self, Error> {
        let model = chart.model();
        Ok(Self {
            chart,
            machine: Interpreter::new(model)?,
            program,
            inputs: model.inputs.iter().map(|(id, input)| first_value(model, Name::Input(id), &input.ty)).collect(),
            coverage: RefCell::new(Coverage::of(chart)),
        })
    }

    /// The chart.
    #[must_use]
    pub fn chart(&self) -> &'c Chart {
        self.chart
    }

    /// Goes on from what was recorded.
    pub(crate) fn recall(&mut self, recalled: &interp::Recalled) -> Result<(), String> {
        self.machine.recall(recalled)
    }

    /// The chart's names.
    #[must_use]
    pub fn names(&self) -> &'c Names {
        self.chart.names()
    }

    /// Exchanges a parameter, from the next cycle on.
    ///
    /// # Errors
    /// There is none of that name, or the value does not fit.
    pub fn set_param(&mut self, name: &str, value: impl Into<Value>) -> Result<(), Error> {
        let model = self.chart.model();
        let found = model.params.iter().find(|(_, param)| param.name == name);
        let (id, param) = found.ok_or_else(|| Error::NoSuchName(name.to_owned()))?;
        let mut params = self.machine.params().to_vec();
        params[id.index()] = inside(&value.into(), &param.ty);
        Ok(self.machine.set_params(&params)?)
    }

    /// The classic *Init*: the next cycle starts like a first one. The parameters and inputs stay.
    ///
    /// # Errors
    /// As of [`Simulation::new`].
    pub fn init(&mut self) -> Result<(), Error> {
        Ok(self.machine.init()?)
    }

    /// One cycle at `now`, a wrapping count in the unit of the chart's clock. Inputs that are not named keep their values.
    ///
    /// # Errors
    /// There is no such input, a value does not fit, or the chart's own arithmetic fails; the simulation is then somewhere within the
    /// cycle and of no further use.
    pub fn cycle(&mut self, now: u32, inputs: &[(&str, Value)]) -> Result<Cycle, Error> {
        self.set(inputs)?;
        self.run(now, None)
    }

    /// One cycle that leads into the situation of these steps by hand (A38). Unlike the compiled chart, which needs `forceable;` for it, it takes any
    /// steps: nobody asks whether the chart can ever be in them. Of steps of one name each has its partial grafcet in front, as [`Names::steps`] has them.
    ///
    /// # Errors
    /// As of [`Simulation::cycle`], or there is no step of that name.
    pub fn force(&mut self, now: u32, steps: &[&str], inputs: &[(&str, Value)]) -> Result<Cycle, Error> {
        let step = |name: &&str| {
            let place = self.names().step_named(name);
            place
                .and_then(|place| self.chart.model().steps.ids().nth(place))
                .ok_or_else(|| Error::NoSuchStep((*name).to_owned()))
        };
        let situation = steps.iter().map(step).collect::<Result<interp::Situation, _>>()?;
        self.set(inputs)?;
        self.run(now, Some(&situation))
    }

    fn set(&mut self, inputs: &[(&str, Value)]) -> Result<(), Error> {
        for (name, value) in inputs {
            let found = self.chart.model().inputs.iter().find(|(_, input)| input.name == *name);
            let (id, input) = found.ok_or_else(|| Error::NoSuchName((*name).to_owned()))?;
            self.inputs[id.index()] = inside(value, &input.ty);
        }
        Ok(())
    }

    /// The same with a value for every input, in the order of declaration.
    ///
    /// # Errors
    /// As of [`Simulation::cycle`], or there are not as many values as inputs.
    pub fn cycle_with(&mut self, now: u32, inputs: &[Value]) -> Result<Cycle, Error> {
        self.take(inputs)?;
        self.run(now, None)
    }

    /// A value for every input.
    fn take(&mut self, inputs: &[Value]) -> Result<(), Error> {
        let declared = &self.chart.model().inputs;
        if inputs.len() != declared.len() {
            return Err(interp::Error::Count { expected: declared.len(), found: inputs.len() }.into());
        }
        self.inputs = declared.values().zip(inputs).map(|(input, value)| inside(value, &input.ty)).collect();
        Ok(())
    }

    fn run(&mut self, now: u32, by_hand: Option<&interp::Situation>) -> Result<Cycle, Error> {
        let model = self.chart.model();
        let world = Around { model, program: &self.program, coverage: Some(&self.coverage) };
        let done = match by_hand {
            Some(situation) => self.machine.force_in(&world, situation, &self.inputs, now)?,
            None => self.machine.cycle_in(&world, &self.inputs, now)?,
        };
        let evolutions =
            done.done().iter().filter(|one| did_something(one)).map(|one| evolution(one, model, self.names()));
        let evolutions: Vec<Evolution> = evolutions.collect();
        let ran = done.ran.iter().filter_map(|id| ran(&model.associations[*id], model)).collect();
        let cycle = Cycle {
            forced: forced(model, &done.active),
            calls: done.calls.iter().map(|call| called(call, model)).collect(),
            ran,
            is_stable: done.stable,
            evolutions,
            ..self.seen(now)
        };
        self.coverage.get_mut().ran(&cycle);
        Ok(cycle)
    }

    /// What the chart shows, with nothing that happens.
    fn seen(&self, now: u32) -> Cycle {
        Cycle {
            now,
            gap: None,
            skipped: 0,
            inputs: self.inputs(),
            steps: self.steps(),
            outputs: self.outputs(),
            variables: self.variables(),
            evolutions: Vec::new(),
            forced: forced(self.chart.model(), self.machine.situation()),
            calls: Vec::new(),
            ran: Vec::new(),
            is_stable: true,
            blocked: self.blocked(),
        }
    }

    /// What the chart shows after a cycle at `now` with these inputs, which was made elsewhere.
    pub(crate) fn stands(&mut self, now: u32, inputs: &[Value]) -> Result<Cycle, Error> {
        self.take(inputs)?;
        Ok(self.seen(now))
    }

    /// What the chart waits for at the end of the last cycle.
    #[must_use]
    pub fn blocked(&self) -> Blocked {
        let world = Around { model: self.chart.model(), program: &self.program, coverage: None };
        blocked::blocked(self.chart, &self.machine.look(&world, &self.inputs))
    }

    /// Whether the chart assumes (`assume never`) that these inputs do not come.
    #[must_use]
    pub fn is_excluded(&self, inputs: &[Value]) -> bool {
        let model = self.chart.model();
        let values: Vec<_> = model.inputs.values().zip(inputs).map(|(input, value)| inside(value, &input.ty)).collect();
        let world = Around { model, program: &self.program, coverage: None };
        let look = self.machine.look(&world, &values);
        model.assumptions.iter().any(|assumption| look.holds(&assumption.never.tree) == Ok(true))
    }

    /// What the cycles so far have covered.
    #[must_use]
    pub fn coverage(&self) -> Coverage {
        self.coverage.borrow().clone()
    }

    /// The inputs of the last cycle.
    #[must_use]
    pub fn inputs(&self) -> Vec<Value> {
        let named = self.chart.model().inputs.ids().zip(&self.inputs);
        named.map(|(id, value)| outside(*value, Name::Input(id), self.chart.model())).collect()
    }

    /// The active steps, by their places in [`Names::steps`].
    #[must_use]
    pub fn steps(&self) -> Vec<usize> {
        steps(self.machine.situation())
    }

    /// Whether the step of this name is active; `false` where there is none.
    #[must_use]
    pub fn is_active(&self, step: &str) -> bool {
        self.names().step_named(step).is_some_and(|step| self.steps().contains(&step))
    }

    /// The names of the steps that are late: active for longer than `within` lets them.
    #[must_use]
    pub fn late_steps(&self) -> Vec<&'c str> {
        let late = self.machine.late_steps();
        late.iter().map(|step| &*self.chart.names().steps[Names::step(*step)].name).collect()
    }

    /// The outputs of the last cycle.
    #[must_use]
    pub fn outputs(&self) -> Vec<Value> {
        let named = self.chart.model().outputs.ids().zip(self.machine.outputs());
        named.map(|(id, value)| outside(*value, Name::Output(id), self.chart.model())).collect()
    }

    /// The value of an output.
    #[must_use]
    pub fn output(&self, name: &str) -> Option<Value> {
        let place = self.names().outputs.iter().position(|output| output.name == name)?;
        self.outputs().into_iter().nth(place)
    }

    /// The variables that hold a value.
    #[must_use]
    pub fn variables(&self) -> Vec<Value> {
        let model = self.chart.model();
        let named = model.vars.ids().zip(self.machine.vars());
        let held = named.filter(|(id, _)| !interp::is_combinational(model, *id));
        held.map(|(id, value)| outside(*value, Name::Var(id), model)).collect()
    }

    /// The value of a variable.
    #[must_use]
    pub fn variable(&self, name: &str) -> Option<Value> {
        let place = self.names().variables.iter().position(|variable| variable.name == name)?;
        self.variables().into_iter().nth(place)
    }

    /// The parameters in force.
    #[must_use]
    pub fn params(&self) -> Vec<Value> {
        let named = self.chart.model().params.ids().zip(self.machine.params());
        named.map(|(id, value)| outside(*value, Name::Param(id), self.chart.model())).collect()
    }

    /// The machine after it, whose names are the compiler's ids.
    #[must_use]
    pub fn machine(&self) -> &Interpreter<'c> {
        &self.machine
    }
}

/// A search looks at one evolution more, which finds that it is over; a cycle of an `sfc` may clear nothing.
fn did_something(done: &interp::Evolution) -> bool {
    !done.cleared.is_empty() || done.before != done.after
}

fn first_value(model: &Model, name: Name, ty: &Ty) -> interp::Value {
    match (ty, model.variants_of(name)) {
        (Ty::Bool(_), _) => interp::Value::Bool(false),
        (Ty::Time(_), _) => interp::Value::Ticks(0),
        (Ty::Int { .. }, _) | (_, Some(_)) => interp::Value::Int(0),
        _ if ty.is_float() => interp::Value::Real(interp::Real(0.0)),
        _ => interp::Value::Unknown,
    }
}

fn steps(situation: &interp::Situation) -> Vec<usize> {
    situation.iter().map(|step| Names::step(*step)).collect()
}

fn evolution(seen: &interp::Evolution, model: &Model, names: &Names) -> Evolution {
    // A step that is left and entered anew is in both.
    let again: interp::Situation = if names.is_grafcet {
        interp::Situation::new()
    } else {
        let cleared = || seen.cleared.iter().map(|id| &model.transitions[*id]);
        let entered: interp::Situation = cleared().flat_map(|transition| transition.targets.iter().copied()).collect();
        cleared()
            .flat_map(|transition| transition.sources.iter().copied())
            .filter(|step| entered.contains(step))
            .collect()
    };
    let and_again = |steps: interp::Situation| steps.union(&again).map(|step| Names::step(*step)).collect();
    let mut cleared: Vec<usize> = seen.cleared.iter().map(|id| names.transition(*id)).collect();
    cleared.dedup();
    Evolution {
        cleared,
        deactivated: and_again(seen.before.difference(&seen.after).copied().collect()),
        activated: and_again(seen.after.difference(&seen.before).copied().collect()),
        steps: steps(&seen.after),
    }
}

fn forced(model: &Model, active: &interp::Situation) -> Vec<Forced> {
    let given = model.forces.values().filter(|force| active.contains(&force.step));
    given
        .map(|force| Forced {
            partial: force.target.index(),
            by: Names::step(force.step),
            order: order(model, &force.order),
        })
        .collect()
}

fn order(model: &Model, order: &grafcet_compiler::model::ForceOrder) -> String {
    use grafcet_compiler::model::ForceOrder;
    let step = |step: &StepId| plain_name(&model.steps[*step].name);
    match order {
        ForceOrder::Steps(steps) => format!("{{{}}}", steps.iter().map(step).collect::<Vec<_>>().join(", ")),
        ForceOrder::Hold => "{*}".to_owned(),
        ForceOrder::Init => "{INIT}".to_owned(),
    }
}

fn called(call: &interp::Call, model: &Model) -> Call {
    Call {
        action: plain_name(&model.actions[call.action].name),
        phase: call.phase,
        args: call.args.iter().map(|value| plain(*value)).collect(),
    }
}

/// What ran beside calls.
fn ran(association: &Association, model: &Model) -> Option<Ran> {
    let place = |place| plain_name(model.place_name(place));
    let text = match &association.effect {
        Effect::Call(..) => return None,
        Effect::Control(at) => format!("{} {}", association.qualifier.word(), place(*at)),
        Effect::Assign(at, value) => format!("{} = {}", place(*at), value.text),
        Effect::Block(code) => code.text.clone(),
    };
    Some(Ran { step: Names::step(association.step), text })
}
