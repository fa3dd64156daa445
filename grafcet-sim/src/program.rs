//! What the program around a chart contributes to a simulation.

use std::collections::BTreeMap;
use std::rc::Rc;

use grafcet_compiler::model::{Model, Name, TransitionId, Tree};

use crate::coverage::Coverage;
use crate::interp::{self, Error, Real, Symbol, World};
use crate::value::{Value, outside};

/// The values of what a chart's source does not tell: functions and constants of the program, blocks of Rust.
///
/// A value stands under its own text, as it is written in the chart; blanks do not matter. Functions have to be pure: a simulation asks
/// as often as it likes.
#[derive(Clone, Default)]
pub struct Program<'p> {
    values: BTreeMap<String, Value>,
    functions: Vec<Rc<Function<'p>>>,
    blocks: Vec<Rc<Block<'p>>>,
}

type Function<'p> = dyn Fn(&Asked<'_>) -> Option<Value> + 'p;
type Block<'p> = dyn Fn(&Asked<'_>) -> Option<Vec<(String, Value)>> + 'p;

/// What is asked for.
pub struct Asked<'a> {
    /// As written in the chart, on one line: `near(x)`.
    pub text: &'a str,
    look: &'a dyn Fn(&str) -> Option<Value>,
}

impl Asked<'_> {
    /// The value of an input, output, variable or parameter at this moment of the cycle.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<Value> {
        (self.look)(name)
    }

    /// Whether it is written like this; blanks do not matter.
    #[must_use]
    pub fn is(&self, text: &str) -> bool {
        without_blanks(self.text) == without_blanks(text)
    }
}

impl<'p> Program<'p> {
    /// Nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A constant, or a call that always has the same value: `.constant("LIMIT", 80)`.
    #[must_use]
    pub fn constant(mut self, text: &str, value: impl Into<Value>) -> Self {
        self.values.insert(without_blanks(text), value.into());
        self
    }

    /// What has other values at other times; `None` where it is another function that is asked for.
    #[must_use]
    pub fn function(mut self, f: impl Fn(&Asked<'_>) -> Option<Value> + 'p) -> Self {
        self.functions.push(Rc::new(f));
        self
    }

    /// What a block of Rust writes that the simulation does not look into, by name.
    #[must_use]
    pub fn block(mut self, f: impl Fn(&Asked<'_>) -> Option<Vec<(String, Value)>> + 'p) -> Self {
        self.blocks.push(Rc::new(f));
        self
    }
}

fn without_blanks(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}

/// A program beside a chart, which a simulation asks.
pub(crate) struct Around<'a> {
    pub(crate) model: &'a Model,
    pub(crate) program: &'a Program<'a>,
    /// Where conditions are taken down, if they are.
    pub(crate) coverage: Option<&'a std::cell::RefCell<Coverage>>,
}

impl Around<'_> {
    fn ask<R>(&self, text: &str, look: &dyn Fn(Name) -> Option<interp::Value>, f: impl FnOnce(&Asked<'_>) -> R) -> R {
        let named = |name: &str| {
            let name = find(self.model, name)?;
            Some(outside(look(name)?, name, self.model))
        };
        f(&Asked { text, look: &named })
    }
}

impl World for Around<'_> {
    fn value(&self, text: &str, look: &dyn Fn(Name) -> Option<interp::Value>) -> Option<interp::Value> {
        let constant = self.program.values.get(&without_blanks(text)).cloned();
        let value = constant.or_else(|| {
            self.ask(text, look, |asked| self.program.functions.iter().find_map(|function| function(asked)))
        });
        value.map(|value| untyped(&value))
    }

    fn block(&self, text: &str, look: &dyn Fn(Name) -> Option<interp::Value>) -> Option<Vec<(String, interp::Value)>> {
        let written = self.ask(text, look, |asked| self.program.blocks.iter().find_map(|block| block(asked)))?;
        Some(written.into_iter().map(|(name, value)| (name, untyped(&value))).collect())
    }

    fn asked(&self, id: TransitionId, holds: &dyn Fn(&Tree) -> Result<bool, Error>) {
        if let Some(coverage) = self.coverage {
            coverage.borrow_mut().asked(id, self.model, holds);
        }
    }
}

fn untyped(value: &Value) -> interp::Value {
    match value {
        Value::Bool(value) => interp::Value::Bool(*value),
        Value::Int(value) => interp::Value::Int(*value),
        Value::Float(value) => interp::Value::Real(Real(*value)),
        Value::Ticks(value) => interp::Value::Ticks(*value),
        Value::Name(name) => interp::Value::Name(Symbol::of(name)),
        Value::Unknown => interp::Value::Unknown,
    }
}

/// What a name stands for.
fn find(model: &Model, name: &str) -> Option<Name> {
    let input = model.inputs.iter().find(|(_, one)| one.name == name).map(|(id, _)| Name::Input(id));
    let output = || model.outputs.iter().find(|(_, one)| one.name == name).map(|(id, _)| Name::Output(id));
    let var = || model.vars.iter().find(|(_, one)| one.name == name).map(|(id, _)| Name::Var(id));
    let param = || model.params.iter().find(|(_, one)| one.name == name).map(|(id, _)| Name::Param(id));
    input.or_else(output).or_else(var).or_else(param)
}
