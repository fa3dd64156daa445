//! Charts in the words of IEC 61131-3: steps, transitions and actions, as text.
//!
//! - here: what such a chart consists of
//! - `build`: from the model to it; `actions`: what steps do; `order`: what depends on an order of actions that the standard leaves open; `fits`:
//!   what the language cannot say
//! - `text`: the textual form; the form of PLCopen is a room of its own ([`crate::plcopen`])

mod actions;
mod build;
mod fits;
mod order;
mod text;

use grafcet_compiler::model::Model;

use crate::Refused;
use crate::st::syntax::{Statement, Stub, Variable};

pub(crate) use build::build;
pub(crate) use text::classic;

/// A chart in another notation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Exported {
    /// A whole file.
    pub text: String,
    /// What is declared and has to be written by a person: its name and the Rust it stands for.
    pub to_write: Vec<(String, String)>,
    /// What has another name than in the chart: both names.
    pub renamed: Vec<(String, String)>,
}

/// A chart as a program of IEC 61131-3 in the textual form of SFC.
///
/// # Errors
/// All that the language cannot say, each with its place: a `grafcet`, orders and enclosing steps, and actions whose result depends on an order that the
/// standard leaves open.
pub fn textual(model: &Model) -> Result<Exported, Vec<Refused>> {
    let chart = build(model)?;
    let text = text::write(&chart);
    Ok(chart.exported(text))
}

/// A chart as the standard has it.
#[derive(Clone, Debug)]
pub(crate) struct Chart {
    /// What is said in front of it.
    pub(crate) header: Vec<String>,
    pub(crate) name: String,
    pub(crate) functions: Vec<Stub>,
    pub(crate) inputs: Vec<Variable>,
    pub(crate) outputs: Vec<Variable>,
    pub(crate) variables: Vec<Variable>,
    /// As in the model.
    pub(crate) steps: Vec<Step>,
    /// As in the model.
    pub(crate) transitions: Vec<Transition>,
    pub(crate) actions: Vec<Action>,
    renamed: Vec<(String, String)>,
    /// The action that runs in each scan, and a name for a step that could have it.
    each_scan: Option<(String, String)>,
}

#[derive(Clone, Debug)]
pub(crate) struct Step {
    pub(crate) name: String,
    pub(crate) initial: bool,
    /// What is said of it, on one line.
    pub(crate) note: String,
    pub(crate) blocks: Vec<Block>,
}

/// An action, or a boolean variable, that belongs to a step.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Block {
    pub(crate) qualifier: &'static str,
    pub(crate) time: Option<String>,
    pub(crate) action: String,
}

#[derive(Clone, Debug)]
pub(crate) struct Transition {
    /// From 1, where others leave the same steps.
    pub(crate) priority: Option<usize>,
    /// By number.
    pub(crate) from: Vec<usize>,
    pub(crate) to: Vec<usize>,
    /// An expression of structured text.
    pub(crate) condition: String,
}

#[derive(Clone, Debug)]
pub(crate) struct Action {
    pub(crate) name: String,
    pub(crate) body: Vec<Statement>,
}

impl Chart {
    /// Gives what is done in each scan to a step of its own, which is always active, instead of the initial one.
    pub(crate) fn with_scan_step(&mut self) {
        let Some((action, name)) = self.each_scan.take() else { return };
        for step in &mut self.steps {
            step.blocks.retain(|block| block.action != action);
        }
        let blocks = vec![Block { qualifier: "N", time: None, action }];
        self.steps.push(Step { name, initial: true, note: String::new(), blocks });
    }

    pub(crate) fn exported(&self, text: String) -> Exported {
        let to_write = self.functions.iter().map(|stub| (stub.name.clone(), stub.rust.clone())).collect();
        Exported { text, to_write, renamed: self.renamed.clone() }
    }
}
