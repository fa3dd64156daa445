//! What lies outside of a chart: functions, constants and blocks of the program around it.

use super::value::{Error, Value};
use grafcet_compiler::model::{Name, TransitionId, Tree};

/// What the program around a chart contributes, and who looks on.
pub trait World {
    /// The value of Rust that the interpreter does not look into, by its own text: `near(x)`. `look` tells the values of names. Where
    /// there is none, the cycle ends with [`Error::NotUnderstood`].
    fn value(&self, text: &str, look: &dyn Fn(Name) -> Option<Value>) -> Option<Value> {
        _ = (text, look);
        None
    }

    /// What a block that the interpreter does not look into writes, by its own text. It may write nothing.
    fn block(&self, text: &str, look: &dyn Fn(Name) -> Option<Value>) -> Option<Vec<(String, Value)>> {
        _ = (text, look);
        None
    }

    /// A condition is asked; `holds` tells whether parts of it hold at this moment.
    fn asked(&self, id: TransitionId, holds: &dyn Fn(&Tree) -> Result<bool, Error>) {
        _ = (id, holds);
    }
}

/// There is nothing around the chart.
#[derive(Clone, Copy, Default, Debug)]
pub struct Nothing;

impl World for Nothing {}

/// What a cycle is given from outside.
#[derive(Clone, Copy)]
pub(super) struct Given<'a> {
    /// In the order of declaration.
    pub(super) inputs: &'a [Value],
    /// In the order of declaration.
    pub(super) params: &'a [Value],
    pub(super) world: &'a dyn World,
}
