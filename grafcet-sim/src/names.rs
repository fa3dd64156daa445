//! What everything in a chart is called.

use grafcet_compiler::model::{Dialect, Id, Integer, Model, Name, StepId, TransitionId, Ty};
use proc_macro2::Ident;

/// What everything in a chart is called, in the order of declaration. Everything else names it by its place here.
#[derive(Clone, PartialEq, Debug)]
pub struct Names {
    /// The chart's own.
    pub chart: String,
    /// Whether it is a `grafcet`; else it is an `sfc`.
    pub is_grafcet: bool,
    /// The unit of its clock.
    pub nanos_per_tick: u64,
    pub steps: Vec<Step>,
    /// As they stand in the source: an `any` is one.
    pub transitions: Vec<Transition>,
    pub inputs: Vec<Signal>,
    pub outputs: Vec<Signal>,
    /// Those that hold a value; combinational ones are conditions with a name.
    pub variables: Vec<Signal>,
    pub params: Vec<Signal>,
    /// Partial grafcets; what stands directly in the chart has the chart's name.
    pub partials: Vec<String>,
    /// For each transition of the model its place in `transitions`.
    pub(crate) drawn: Vec<usize>,
}

/// A step.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Step {
    /// With its partial grafcet where another step has the same name.
    pub name: String,
    pub is_initial: bool,
    /// The place of its partial grafcet.
    pub partial: usize,
    /// In the source, counted from one; zero where nobody knows.
    pub line: usize,
}

/// A transition.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Transition {
    /// `Off → On`, with its name in front if it has one.
    pub name: String,
    /// As written, on one line.
    pub condition: String,
    pub line: usize,
}

/// A name with a value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Signal {
    pub name: String,
    pub kind: Kind,
}

/// What values a name can have.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Kind {
    Bool,
    Int {
        signed: bool,
        bits: u32,
    },
    /// With its bits.
    Float(u32),
    /// Ticks of the chart's clock.
    Time,
    /// An enum whose variants the chart lists, and the type's name.
    Listed(String, Vec<String>),
    /// Another type of the program.
    Other(String),
}

impl Names {
    pub(crate) fn of(model: &Model) -> Self {
        let mut drawn = Vec::new();
        let mut transitions: Vec<Transition> = Vec::new();
        for (id, transition) in model.transitions.iter() {
            let first = transition.any.map_or(id, |any| model.anys[any].first);
            if first == id {
                transitions.push(Transition {
                    name: model.transition_text(transition).trim_matches('`').to_owned(),
                    condition: transition.condition.text.clone(),
                    line: transition.mark.start.start().line,
                });
                drawn.push(transitions.len() - 1);
            } else {
                drawn.push(drawn[first.index()]);
            }
        }
        let partial = |id| model.partials[id].name.as_ref().map_or_else(|| plain(&model.name), plain);
        let step = |step: &model_::Step| Step {
            name: match model.steps.values().filter(|other| other.name == step.name).count() {
                1 => plain(&step.name),
                _ => format!("{}::{}", partial(step.partial), step.name),
            },
            is_initial: step.initial,
            partial: step.partial.index(),
            line: step.name.span().start().line,
        };
        let signal = |ident: &Ident, name| Signal { name: plain(ident), kind: kind(model, name) };
        let held = |id: &_| !crate::interp::is_combinational(model, *id);
        Self {
            chart: plain(&model.name),
            is_grafcet: model.dialect == Dialect::Grafcet,
            nanos_per_tick: model.clock_nanos,
            steps: model.steps.values().map(step).collect(),
            transitions,
            inputs: model.inputs.iter().map(|(id, one)| signal(&one.name, Name::Input(id))).collect(),
            outputs: model.outputs.iter().map(|(id, one)| signal(&one.name, Name::Output(id))).collect(),
            variables: model.vars.ids().filter(held).map(|id| signal(&model.vars[id].name, Name::Var(id))).collect(),
            params: model.params.iter().map(|(id, one)| signal(&one.name, Name::Param(id))).collect(),
            partials: model.partials.ids().map(partial).collect(),
            drawn,
        }
    }

    /// The place of a transition of the model.
    pub(crate) fn transition(&self, id: TransitionId) -> usize {
        self.drawn[id.index()]
    }

    /// The place of a step of the model.
    pub(crate) fn step(id: StepId) -> usize {
        id.index()
    }

    /// The place of the step of this name.
    #[must_use]
    pub fn step_named(&self, name: &str) -> Option<usize> {
        self.steps.iter().position(|step| step.name == name)
    }

    /// Ticks as a person reads them, with three digits at most: `2.5 s`.
    #[must_use]
    pub fn time(&self, ticks: u64) -> String {
        const UNITS: [(&str, u128); 3] = [("s", 1_000_000_000), ("ms", 1_000_000), ("µs", 1_000)];
        let nanos = u128::from(ticks) * u128::from(self.nanos_per_tick);
        if nanos == 0 {
            return "0 s".to_owned();
        }
        let Some((unit, size)) = UNITS.into_iter().find(|(_, size)| nanos >= *size) else {
            return format!("{nanos} ns");
        };
        let rest = format!("{:03}", nanos % size * 1000 / size);
        let rest = rest.trim_end_matches('0');
        let point = if rest.is_empty() { "" } else { "." };
        format!("{}{point}{rest} {unit}", nanos / size)
    }
}

use grafcet_compiler::model as model_;

/// What values a declared name can have.
pub(crate) fn kind(model: &Model, name: Name) -> Kind {
    match (kind_of(model.ty(name)), model.variants_of(name)) {
        (Kind::Other(text), Some(listed)) => {
            Kind::Listed(text, listed.list.iter().map(|one| one.name.to_string()).collect())
        }
        (kind, _) => kind,
    }
}

/// What values a type has, as far as it tells alone.
pub(crate) fn kind_of(ty: &Ty) -> Kind {
    match ty {
        Ty::Bool(_) => Kind::Bool,
        // Of `usize` and `isize` the most that they have, as in a record.
        Ty::Int { signed, bits, rust } => {
            Kind::Int { signed: *signed, bits: Integer::of(rust).map_or(*bits, |integer| integer.bits) }
        }
        Ty::Time(_) => Kind::Time,
        Ty::Other(rust) => match quote::quote!(#rust).to_string().replace(' ', "") {
            text if ty.is_float() => Kind::Float(if text == "f32" { 32 } else { 64 }),
            text => Kind::Other(text),
        },
    }
}

/// Without the mark of a raw identifier.
pub(crate) fn plain(name: &Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}
