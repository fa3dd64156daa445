//! What stands beside a chart in a proof: the plants of its call, and how they hang together.

use super::{InputId, MacroId, Model, Name, OutputId, StepId};
use crate::list::List;

/// The plants of a call; none for a chart alone.
#[derive(Default)]
pub struct Plants {
    /// In source order.
    pub list: Vec<Plant>,
    /// What of the chart's inputs a plant drives.
    pub driven: Vec<Driven>,
    /// What the chart's properties and assumptions ask of plants: inputs beside those that are declared, which hold what is
    /// asked for at the end of the cycle.
    pub watched: Vec<Watched>,
}

/// A chart that does what the machine does on the outputs of the controller.
pub struct Plant {
    pub model: Model,
    /// By input: where its value comes from.
    pub wires: Vec<Wire>,
}

/// Where an input of a plant comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Wire {
    /// The chart's output, of this cycle.
    Output(OutputId),
    /// What another plant showed at the end of the cycle before.
    Shown(usize, OutputId),
    /// An input of the chart that no plant drives: both see the same.
    Shared(InputId),
    /// Nobody drives it: a choice or a fault.
    Free,
}

/// An input of the chart that holds what a plant showed at the end of the cycle before.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Driven {
    pub input: InputId,
    pub plant: usize,
    pub output: OutputId,
}

/// `Cylinder::Out.X` in a property of the chart.
#[derive(Clone, Debug)]
pub struct Watched {
    /// The input that stands for it.
    pub input: InputId,
    pub plant: usize,
    pub what: Seen,
}

/// Something of a plant at the end of a cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Seen {
    Step(StepId),
    Macro(MacroId),
    Value(Name),
}

impl Plants {
    /// There are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Whether the chart's surroundings give it this input: no plant does, and it stands for nothing of one.
    #[must_use]
    pub fn leave_free(&self, input: InputId) -> bool {
        self.driven.iter().all(|driven| driven.input != input) && !self.is_watched(input)
    }

    /// It is none of the chart's own inputs.
    #[must_use]
    pub fn is_watched(&self, input: InputId) -> bool {
        self.watched.iter().any(|watched| watched.input == input)
    }

    /// The names of the plants, as a message says them: `` `Lift` and `Arm` ``.
    #[must_use]
    pub fn names(&self) -> String {
        let names: Vec<String> = self.list.iter().map(|plant| format!("`{}`", plant.model.name)).list();
        match names.split_last() {
            Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
            _ => names.concat(),
        }
    }
}
