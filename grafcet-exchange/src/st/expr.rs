//! Expressions, in the words of structured text.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::diagnostic::Mark;
use grafcet_compiler::model::{
    ActionId, Binary, DelayId, EdgeId, Expr, Integer, MacroId, Model, Name, Place, Read, StepId, TimeRef, Tree, Ty,
    Unary,
};

use super::names::Names;
use super::since::may_read_times;
use super::syntax::{Stub, Variable};
use super::text::{Text, any, not, strength};
use super::{functions, real, time};
use crate::Refused;

/// What a value is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Bool,
    /// `UINT`
    Int(&'static str),
    /// `REAL`
    Real(&'static str),
    Time,
    /// Literals of integers, which fit to any.
    Number,
}

/// The type of structured text.
pub(crate) fn kind(ty: &Ty) -> Option<Kind> {
    Some(match ty {
        Ty::Bool(_) => Kind::Bool,
        Ty::Time(_) => Kind::Time,
        // `usize` is as wide as the controller's addresses, which no PLC knows.
        Ty::Int { signed, bits, rust } if !Integer::of(rust).is_some_and(|integer| integer.is_size) => {
            Kind::Int(match (signed, bits) {
                (true, 8) => "SINT",
                (false, 8) => "USINT",
                (true, 16) => "INT",
                (false, 16) => "UINT",
                (true, 32) => "DINT",
                (false, 32) => "UDINT",
                (true, 64) => "LINT",
                (false, 64) => "ULINT",
                _ => return None,
            })
        }
        Ty::Other(syn::Type::Path(path)) if ty.is_float() => {
            Kind::Real(if path.path.is_ident("f32") { "REAL" } else { "LREAL" })
        }
        _ => return None,
    })
}

/// The type of what is declared. A variant of a list is its place there, as in the expressions of the chart; that is what `INT` stands for.
pub(crate) fn kind_of(model: &Model, name: Name) -> Option<Kind> {
    if model.variants_of(name).is_some() { Some(Kind::Int("INT")) } else { kind(model.ty(name)) }
}

impl Kind {
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Bool => "BOOL",
            Self::Int(name) | Self::Real(name) => name,
            Self::Time => "TIME",
            Self::Number => "DINT",
        }
    }
}

/// What an expression sees at its moment.
pub(crate) struct At<'a> {
    /// Whether a step is active: `step = 20`; none where that cannot be said then.
    pub(crate) active: &'a dyn Fn(StepId) -> Option<Text>,
    /// Under which names it reads what the cycle changes.
    pub(crate) before: &'a BTreeMap<Place, String>,
    /// Times of steps can be read.
    pub(crate) times: bool,
    /// Where it stands.
    pub(crate) mark: Mark,
}

/// Of what edges and delays can be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Remembers {
    /// Of inputs and parameters.
    Inputs,
    /// Of steps, too.
    Steps,
    /// Of all.
    All,
}

/// What the timers of steps show.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Moment {
    /// They have been called on the situation that counts.
    Called,
    /// Steps but this one may have been left since then: these timers show the times that they had reached.
    Moved(Option<StepId>),
    /// The same, of what runs last of all steps that are left: of those that are entered anew it asks for the time that they had reached.
    Leaving,
    /// They have been called after the evolution, of an action of this step: those of what has been left have begun anew.
    Begun(StepId),
}

/// Names, and what expressions need beside them.
pub(crate) struct Scope<'m> {
    pub(crate) model: &'m Model,
    pub(crate) names: Names,
    values: BTreeMap<Name, String>,
    /// What several associations write.
    pub(crate) shared: BTreeSet<Place>,
    /// What blocks have copies of.
    pub(crate) copies: Vec<Variable>,
    /// Steps that can be left and entered at once, and the names of the times that they had reached.
    pub(crate) reentered: BTreeSet<StepId>,
    pub(crate) reached: BTreeMap<StepId, String>,
    /// The timers of steps.
    pub(crate) timers: BTreeMap<StepId, String>,
    pub(crate) macro_timers: BTreeMap<MacroId, String>,
    /// Of an edge the variables for rising, falling and the value before.
    pub(crate) edges: BTreeMap<EdgeId, [String; 3]>,
    /// The same of edges in the actions of an `sfc`, which compare what there is after the evolution.
    pub(crate) acting: BTreeMap<EdgeId, [String; 3]>,
    /// Of what edges and delays can be.
    pub(crate) remembers: Remembers,
    pub(crate) delays: BTreeMap<DelayId, String>,
    pub(crate) stubs: Vec<Stub>,
    /// The names of stubs, by what they stand for.
    pub(super) called: BTreeMap<String, String>,
    /// Of code actions the instance and its function block.
    pub(crate) instances: BTreeMap<ActionId, (String, String)>,
    /// In a chart of the language itself, which has steps.
    pub(crate) steps: Option<Steps>,
    /// Something blinks.
    pub(crate) blinks: bool,
    pub(crate) moment: Moment,
    /// The time of a step is stored.
    pub(crate) tells_times: bool,
    /// Times are added.
    pub(crate) adds_times: bool,
}

/// Steps as the language itself has them: with `Step.X` and `Step.T`.
pub(crate) struct Steps {
    /// By step.
    pub(crate) names: Vec<String>,
    /// Active wherever what is translated counts, so that their times are those of the chart. The time of another step is the one that it had
    /// reached when it was left.
    pub(crate) active: Vec<StepId>,
}

impl<'m> Scope<'m> {
    /// With names for all that is declared.
    pub(crate) fn new(model: &'m Model, names: Names) -> Self {
        let mut scope = Self {
            model,
            names,
            values: BTreeMap::new(),
            shared: BTreeSet::new(),
            copies: Vec::new(),
            reentered: BTreeSet::new(),
            reached: BTreeMap::new(),
            timers: BTreeMap::new(),
            macro_timers: BTreeMap::new(),
            edges: BTreeMap::new(),
            acting: BTreeMap::new(),
            remembers: Remembers::Inputs,
            delays: BTreeMap::new(),
            stubs: Vec::new(),
            called: BTreeMap::new(),
            instances: BTreeMap::new(),
            steps: None,
            blinks: false,
            moment: Moment::Called,
            tells_times: false,
            adds_times: false,
        };
        let mut all: Vec<Name> = model.inputs.ids().map(Name::Input).collect();
        all.extend(model.params.ids().map(Name::Param));
        all.extend(model.outputs.ids().map(Name::Output));
        all.extend(model.vars.ids().map(Name::Var));
        for name in all {
            let given = scope.names.of_chart(&plain(model.value_name(name)));
            scope.values.insert(name, given);
        }
        scope
    }

    pub(crate) fn name(&self, name: Name) -> &str {
        self.values.get(&name).map_or("", String::as_str)
    }

    pub(crate) fn place(&self, place: Place) -> &str {
        self.name(place.into())
    }

    /// The timer of a step.
    pub(crate) fn timer(&mut self, step: StepId) -> String {
        if !self.timers.contains_key(&step) {
            let name = self.names.own(&format!("T_{}", plain(&self.model.steps[step].name)));
            self.timers.insert(step, name);
        }
        self.timers[&step].clone()
    }

    /// An expression of this kind.
    pub(crate) fn expr(&mut self, expr: &Expr, wanted: &Kind, at: &At<'_>) -> Result<Text, Refused> {
        self.tree(&expr.tree, wanted, &At { mark: expr.mark, ..*at })
    }

    pub(crate) fn tree(&mut self, tree: &Tree, wanted: &Kind, at: &At<'_>) -> Result<Text, Refused> {
        match tree {
            Tree::Bool(value) => Ok(Text::word(if *value { "TRUE" } else { "FALSE" })),
            Tree::Int(value) => Ok(match value {
                0.. => Text::word(value.to_string()),
                _ => Text { text: value.to_string(), strength: strength::UNARY },
            }),
            Tree::Read(read) => self.read(*read, at),
            Tree::Elapsed(time, step) => self.elapsed(*time, *step, at),
            Tree::MacroElapsed(time, id) => self.macro_elapsed(*time, *id, at),
            _ if self.is_of_bits(tree, wanted) => self.of_bits(tree, wanted, at),
            Tree::Unary(Unary::Not, inner) => Ok(not(self.tree(inner, &Kind::Bool, at)?)),
            Tree::Unary(Unary::Neg, inner) => {
                let inner = self.tree(inner, wanted, at)?.within(strength::UNARY);
                Ok(Text { text: format!("-{inner}"), strength: strength::SUM })
            }
            Tree::Binary(operator, a, b) => self.binary(*operator, [a, b], wanted, at),
            Tree::Opaque { text, reads, of, .. } => match (real::literal(text), of) {
                (Some(number), _) => Ok(Text::word(number)),
                (None, Some(of)) if functions::is_one(of) => self.function(of, wanted, at),
                (None, _) => self.opaque(text, reads, wanted, at),
            },
        }
    }

    pub(super) fn read(&mut self, read: Read, at: &At<'_>) -> Result<Text, Refused> {
        let place = |place: Place, name: &str| at.before.get(&place).map_or(name, String::as_str).to_owned();
        let active = |step| {
            (at.active)(step).ok_or_else(|| {
                Refused::at(at.mark, "which step is active cannot be asked here in the CASE form of structured text: read a variable that the step sets, or use the form of flip-flops")
            })
        };
        match read {
            Read::Name(name) => Ok(Text::word(match name {
                Name::Output(id) => place(Place::Output(id), self.name(name)),
                Name::Var(id) => place(Place::Var(id), self.name(name)),
                _ => self.name(name).to_owned(),
            })),
            Read::Active(step) => active(step),
            Read::MacroActive(id) => {
                let steps = self.model.macros[id].steps.clone();
                Ok(any(steps.into_iter().map(active).collect::<Result<_, _>>()?))
            }
            Read::Since(step) => {
                may_read_times(at)?;
                if matches!(self.moment, Moment::Begun(own) if own != step) {
                    let what = "the time that another step had reached when it was left";
                    return Err(refuse(at, what, "compare it as in `5s/Step`, or use the form of flip-flops"));
                }
                if self.steps.as_ref().is_some_and(|steps| !steps.active.contains(&step)) {
                    let what = "the time of a step that may not be active";
                    return Err(refuse(at, what, "compare it as in `5s/Step`, or ask for it where the step is active"));
                }
                Ok(Text::word(self.since(step)))
            }
            Read::Rising(edge) => self.edge_of(edge, 0, at),
            Read::Falling(edge) => self.edge_of(edge, 1, at),
            Read::Delay(delay) => self.delay(delay, at),
            Read::Ticks(ticks) => time::literal(self.model, ticks, at.mark).map(Text::word),
            Read::Elapsed(time, step) => self.elapsed(time, step, at),
            Read::MacroSince(id) => self.macro_since(id, at).map(Text::word),
            Read::MacroElapsed(time, id) => self.macro_elapsed(time, id, at),
            Read::Blink(blink) => self.blink(blink, at),
            Read::Memory(_) => Err(refuse(at, "an edge or a delay of a property", "leave it out")),
        }
    }

    /// A time as a literal or a name.
    pub(crate) fn time(&self, time: TimeRef, mark: Mark) -> Result<String, Refused> {
        match time {
            TimeRef::Ticks(ticks) => time::literal(self.model, ticks, mark),
            TimeRef::Param(id) => Ok(self.name(Name::Param(id)).to_owned()),
            TimeRef::Var(id) => Ok(self.name(Name::Var(id)).to_owned()),
        }
    }

    /// What an expression is, where that can be told.
    pub(crate) fn kind(&self, tree: &Tree) -> Option<Kind> {
        match tree {
            Tree::Int(_) => Some(Kind::Number),
            Tree::Read(Read::Name(name)) => kind_of(self.model, *name),
            Tree::Read(Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)) => Some(Kind::Time),
            Tree::Bool(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) | Tree::Read(_) => Some(Kind::Bool),
            Tree::Unary(_, inner) => self.kind(inner),
            Tree::Binary(operator, a, b) => match operator {
                Binary::And
                | Binary::Or
                | Binary::Eq
                | Binary::Ne
                | Binary::Lt
                | Binary::Le
                | Binary::Gt
                | Binary::Ge => Some(Kind::Bool),
                // The number of places tells nothing.
                Binary::Shl | Binary::Shr => self.kind(a),
                _ => match (self.kind(a), self.kind(b)) {
                    (Some(Kind::Number) | None, other) => other,
                    (one, _) => one,
                },
            },
            Tree::Opaque { of: Some(of), .. } if functions::is_one(of) => {
                let kinds = functions::values(of).iter().map(|value| self.kind(value));
                kinds.reduce(|one, other| if matches!(one, None | Some(Kind::Number)) { other } else { one }).flatten()
            }
            Tree::Opaque { .. } => None,
        }
    }
}

/// Inputs and parameters, which no action writes.
pub(crate) fn reads_inputs_alone(tree: &Tree) -> bool {
    let mut alone = !real::is_rust(tree);
    tree.each_read(&mut |read| alone &= matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_)));
    alone
}

/// A name without the mark of a raw identifier.
pub(crate) fn plain(name: &proc_macro2::Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

pub(super) fn refuse(at: &At<'_>, what: &str, mend: &str) -> Refused {
    Refused::at(at.mark, format!("{what} has no translation into structured text; {mend}"))
}
