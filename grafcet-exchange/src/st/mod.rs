//! IEC 61131-3 structured text.
//!
//! - `syntax`, `names`, `time`, `text`, `expr`, `stubs`: programs, names, times and expressions of structured text, and functions to be written
//! - `operators`, `bits`: operators between two values; those on the bits of integers
//! - `variants`: lists of variants as numbers
//! - `frame`: what both forms have in common: declarations, initial values, timers
//! - `memory`: edges and delays; `since`: times of steps and macro-steps
//! - `fits`: what neither form can say
//! - `action`, `own_writes`: what an association is, and what an effect does; what a block does
//! - `case`, `flags`: the two forms
//! - `header`: what the program says of itself
//! - `flavour`: the program as CODESYS and TIA Portal take it

pub(crate) mod action;
mod bits;
mod case;
pub(crate) mod expr;
pub(crate) mod fits;
mod flags;
mod flavour;
pub(crate) mod frame;
mod functions;
pub(crate) mod header;
mod memory;
pub(crate) mod names;
mod operators;
mod own_writes;
mod real;
mod since;
mod stubs;
pub(crate) mod syntax;
pub(crate) mod text;
pub(crate) mod time;
mod variants;

use grafcet_compiler::model::Model;

use crate::Refused;

/// What kind of program is wanted.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Options {
    /// One of the two forms.
    pub form: Form,
    /// What comes first in a scan; none for what the form does by itself. Flip-flops evolve first.
    pub order: Option<Order>,
    /// For which tool.
    pub flavour: Flavour,
    /// [`Form::Case`]: the number of the first step, and how far the next one is from it.
    pub numbers: (u32, u32),
    /// [`Form::Case`]: the variable with the number of the active step.
    pub step: String,
    /// The input that puts the chart back into its initial situation.
    pub init: String,
}

impl Default for Options {
    /// [`Form::Case`], the language of the standard, steps in tens, `StepNo` and `Init`.
    fn default() -> Self {
        Self {
            form: Form::Case,
            order: None,
            flavour: Flavour::Iec,
            numbers: (10, 10),
            step: "StepNo".to_owned(),
            init: "Init".to_owned(),
        }
    }
}

/// How the program is built.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// `CASE step OF …`: in each step first its actions, then its transitions; what a continuous action has switched on the transition
    /// switches off. For charts of which one step is active at a time.
    Case,
    /// A flip-flop for each step, set by its predecessor and the condition, reset by the transition that leaves it; then the actions. Parallel
    /// branches are possible.
    FlipFlops,
}

/// What comes first in a scan.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Order {
    /// The actions of the active step, then its transitions: what a step does shows one scan after it is entered.
    ActFirst,
    /// The transitions, then the actions of the step that has been reached, as in a cycle of the chart.
    EvolveFirst,
}

/// For which tool the program is.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Flavour {
    /// As the standard has it, with nothing else.
    #[default]
    Iec,
    /// CODESYS 3.5: `{region}`, `{warning}` at what is to be written, `TO_INT(…)` where a number gets narrower.
    Codesys,
    /// TIA Portal, an external source of SCL: `#` in front of what belongs to the block, `"…"` around what does not, `REGION`, `TON_TIME`.
    Tia,
}

/// A translated chart.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct StructuredText {
    /// A function block, after the functions it needs.
    pub text: String,
    /// What is declared and has to be written by a person: its name and the Rust it stands for.
    pub to_write: Vec<(String, String)>,
    /// What has another name than in the chart, as structured text knows no capitals and has words of its own: both names.
    pub renamed: Vec<(String, String)>,
}

/// A chart as a function block of structured text.
///
/// The chart is one that the compiler accepts. The program's header says in which points it differs from the chart.
///
/// # Errors
/// All that has no translation, each with its place: there is never a program that does something else.
pub fn structured_text(model: &Model, options: &Options) -> Result<StructuredText, Vec<Refused>> {
    if (options.form, options.order) == (Form::FlipFlops, Some(Order::ActFirst)) {
        let why = "flip-flops evolve first: their actions ask what the transitions of the same scan have set and reset; the CASE form has both orders";
        return Err(vec![Refused::whole(why)]);
    }
    let refused = fits::refused(model, options.form);
    if !refused.is_empty() {
        return Err(refused);
    }
    let program = match options.form {
        Form::Case => case::program(model, options),
        Form::FlipFlops => flags::program(model, options),
    }?;
    let to_write = program.stubs.iter().map(|stub| (stub.name.clone(), stub.rust.clone())).collect();
    let renamed = program.renamed.clone();
    Ok(StructuredText { text: flavour::text(program, options.flavour), to_write, renamed })
}
