//! What an expression sees: one snapshot of situation, variables, inputs and time.

use std::collections::{BTreeMap, BTreeSet};

use super::computed::computed;
use super::continuous;
use super::remembered::Remembered;
use super::value::{Error, Term, Value, binary, unary};
use super::variant;
use super::world::Given;
use grafcet_compiler::model::{
    Binary, Blinker, Code, Computed, DelayId, EdgeId, How, Id, MacroId, Model, Name, OutputId, Place, Read, Statement,
    StepId, TimeRef, Tree, VarId,
};

/// A set of active steps.
pub type Situation = BTreeSet<StepId>;

/// How long the active steps and macro-steps have been active; the others are missing and count as zero.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Times {
    pub(super) steps: BTreeMap<StepId, u64>,
    pub(super) macros: BTreeMap<MacroId, u64>,
}

/// The edges of one snapshot.
#[derive(Clone, Copy)]
pub(super) struct Edges<'a> {
    /// The expressions' values in the snapshot before; a missing one has no edge.
    pub(super) before: &'a BTreeMap<EdgeId, bool>,
    /// Their values in this snapshot where they have been sampled; otherwise they are evaluated.
    pub(super) now: Option<&'a BTreeMap<EdgeId, bool>>,
}

/// One snapshot.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub(super) model: &'a Model,
    pub(super) given: Given<'a>,
    pub(super) vars: &'a [Value],
    pub(super) outputs: &'a [Value],
    pub(super) situation: &'a Situation,
    pub(super) times: &'a Times,
    pub(super) edges: Edges<'a>,
    /// `t1/e/t2`, sampled once per cycle.
    pub(super) delays: &'a BTreeMap<DelayId, bool>,
    /// What a property remembers, where one is looked at.
    pub(super) remembered: Option<&'a Remembered>,
    /// What the running block has written so far.
    pub(super) own: Option<&'a BTreeMap<Place, Value>>,
}

impl View<'_> {
    /// The value of an expression.
    pub(super) fn eval(&self, tree: &Tree) -> Result<Term, Error> {
        match tree {
            Tree::Bool(value) => Ok(Term::Bool(*value)),
            Tree::Int(value) => Ok(Term::Int(*value, None)),
            Tree::Read(read) => self.read(*read),
            Tree::Elapsed(time, step) => self.read(Read::Elapsed(*time, *step)),
            Tree::MacroElapsed(time, id) => self.read(Read::MacroElapsed(*time, *id)),
            Tree::Unary(operator, operand) => unary(*operator, self.eval(operand)?),
            Tree::Binary(Binary::And, a, b) => Ok(Term::Bool(self.holds(a)? && self.holds(b)?)),
            Tree::Binary(Binary::Or, a, b) => Ok(Term::Bool(self.holds(a)? || self.holds(b)?)),
            Tree::Binary(operator, a, b) => binary(*operator, self.eval(a)?, self.eval(b)?),
            Tree::Opaque { text, of, .. } => self.opaque(text, of.as_deref()),
        }
    }

    /// Rust that has no node of its own: arithmetic written as methods, a literal, what the program tells.
    fn opaque(&self, text: &str, of: Option<&Computed>) -> Result<Term, Error> {
        if let Some(Computed { how: How::If, operands }) = of {
            // Only one of the two is evaluated.
            let [condition, then, otherwise] = &operands[..] else { return Err(Error::NotUnderstood(text.to_owned())) };
            return if self.holds(condition)? { self.eval(then) } else { self.eval(otherwise) };
        }
        if let Some(of) = of {
            let operands: Result<Vec<Term>, Error> = of.operands.iter().map(|operand| self.eval(operand)).collect();
            match operands {
                Ok(operands) => {
                    if let Some(result) = computed(of.how, &operands, text) {
                        return result;
                    }
                }
                Err(Error::NotUnderstood(_)) => {}
                Err(error) => return Err(error),
            }
        }
        if let Some(value) = self.given.world.value(text, &|name| self.told(name)) {
            return Term::from_outside(value, text);
        }
        Term::literal(text).ok_or_else(|| Error::NotUnderstood(text.to_owned()))
    }

    /// The value of a name as the program around sees it.
    fn told(&self, name: Name) -> Option<Value> {
        self.value_of(name).ok()
    }

    /// What a block writes, which sees its own writes (A33).
    pub(super) fn code(&self, code: &Code) -> Result<BTreeMap<Place, Value>, Error> {
        if let Some(statements) = &code.statements {
            return self.run(statements);
        }
        let unknown = || Error::NotUnderstood(code.text.clone());
        let told = self.given.world.block(&code.text, &|name| self.told(name)).ok_or_else(unknown)?;
        let place = |name: &str| code.writes.iter().find(|place| self.model.place_name(**place) == name);
        let mut written = BTreeMap::new();
        for (name, value) in told {
            let place = *place(&name).ok_or_else(unknown)?;
            written.insert(place, variant::told(value, place.into(), self.model)?);
        }
        Ok(written)
    }

    /// Whether a condition holds.
    pub(super) fn holds(&self, tree: &Tree) -> Result<bool, Error> {
        self.eval(tree)?.bool()
    }

    fn read(&self, read: Read) -> Result<Term, Error> {
        Ok(match read {
            Read::Name(name) => self.name(name)?,
            Read::Active(step) => Term::Bool(self.situation.contains(&step)),
            Read::Since(step) => Term::Ticks(self.time_of(step)),
            Read::MacroActive(id) => Term::Bool(self.macro_active(id)),
            Read::MacroSince(id) => Term::Ticks(self.time_of_macro(id)),
            Read::Rising(edge) => {
                let (before, now) = self.edge(edge)?;
                Term::Bool(!before && now)
            }
            Read::Falling(edge) => {
                let (before, now) = self.edge(edge)?;
                Term::Bool(before && !now)
            }
            Read::Delay(delay) => Term::Bool(self.delays.get(&delay).copied().unwrap_or(false)),
            Read::Memory(id) => {
                let known = self.remembered.and_then(|remembered| remembered.value(id));
                let unknown = || Error::NotUnderstood(format!("{} without its memory", self.model.read_text(read)));
                Term::Bool(known.ok_or_else(unknown)?)
            }
            Read::Ticks(ticks) => Term::Ticks(ticks),
            Read::Elapsed(time, step) => Term::Bool(self.elapsed(time, step)?),
            Read::MacroElapsed(time, id) => {
                let since = saturated(self.times.macros.get(&id));
                Term::Bool(self.macro_active(id) && since >= self.ticks(time)?)
            }
            Read::Blink(blink) => {
                let (active, since) = match blink.of {
                    Blinker::Step(step) => (self.situation.contains(&step), self.times.steps.get(&step)),
                    Blinker::Macro(id) => (self.macro_active(id), self.times.macros.get(&id)),
                };
                // What has only just become active, as a P0 or a final call of the step before it sees it, has no time yet.
                let phase = since.copied().unwrap_or(0) % u64::from(blink.period());
                Term::Bool(active && phase < u64::from(blink.on))
            }
        })
    }

    /// `Step.T`: zero for a step that is not active, unless A34 lets the actions see the time it had reached.
    pub(super) fn time_of(&self, step: StepId) -> u32 {
        saturated(self.times.steps.get(&step))
    }

    /// The same of a macro-step.
    pub(super) fn time_of_macro(&self, id: MacroId) -> u32 {
        saturated(self.times.macros.get(&id))
    }

    /// The value of a name, of its type.
    pub(super) fn value_of(&self, name: Name) -> Result<Value, Error> {
        variant::value(self.name(name)?, name, self.model)
    }

    /// `t/Step` is `Step.X && Step.T >= t`; `0s/Step` is `Step.X` (A23).
    pub(super) fn elapsed(&self, time: TimeRef, step: StepId) -> Result<bool, Error> {
        Ok(self.situation.contains(&step) && self.time_of(step) >= self.ticks(time)?)
    }

    /// A20: `M.X` is true while any step of the expansion is active.
    fn macro_active(&self, id: MacroId) -> bool {
        self.model.macros[id].steps.iter().any(|step| self.situation.contains(step))
    }

    /// The value of an edge's expression in the snapshot before and in this one.
    fn edge(&self, edge: EdgeId) -> Result<(bool, bool), Error> {
        let now = match self.edges.now {
            Some(now) => now.get(&edge).copied().unwrap_or(false),
            None => self.holds(&self.model.edges[edge].of.tree)?,
        };
        Ok((self.edges.before.get(&edge).copied().unwrap_or(now), now))
    }

    /// The values of all edges' expressions in this snapshot.
    pub(super) fn sample_edges(&self) -> Result<BTreeMap<EdgeId, bool>, Error> {
        let edges = self.model.edges.iter();
        edges.map(|(id, edge)| Ok((id, self.holds(&edge.of.tree)?))).collect()
    }

    fn name(&self, name: Name) -> Result<Term, Error> {
        variant::term(self.stored(name)?, name, self.model)
    }

    fn stored(&self, name: Name) -> Result<Term, Error> {
        match name {
            Name::Input(id) => Term::of(self.given.inputs[id.index()], &self.model.inputs[id].ty),
            Name::Param(id) => Term::of(self.given.params[id.index()], &self.model.params[id].ty),
            Name::Output(id) => self.output(id),
            Name::Var(id) => self.var(id),
        }
    }

    fn output(&self, id: OutputId) -> Result<Term, Error> {
        let own = self.own.and_then(|own| own.get(&Place::Output(id)));
        Term::of(*own.unwrap_or(&self.outputs[id.index()]), &self.model.outputs[id].ty)
    }

    /// A variable; a combinational one (A22) is computed from what the others are.
    fn var(&self, id: VarId) -> Result<Term, Error> {
        if let Some(own) = self.own.and_then(|own| own.get(&Place::Var(id))) {
            return Term::of(*own, &self.model.vars[id].ty);
        }
        if continuous::is_combinational(self.model, id) {
            return continuous::combinational(id, &View { own: None, ..*self }).map(Term::Bool);
        }
        Term::of(self.vars[id.index()], &self.model.vars[id].ty)
    }

    /// A time in ticks.
    pub(super) fn ticks(&self, time: TimeRef) -> Result<u32, Error> {
        let term = match time {
            TimeRef::Ticks(ticks) => return Ok(ticks),
            TimeRef::Param(id) => self.name(Name::Param(id))?,
            TimeRef::Var(id) => self.name(Name::Var(id))?,
        };
        match term {
            Term::Ticks(ticks) => Ok(ticks),
            other => Err(Error::Type(format!("{other:?} where a time is expected"))),
        }
    }

    /// The value that `place` takes from an expression.
    pub(super) fn value_for(&self, place: Place, tree: &Tree) -> Result<Value, Error> {
        variant::value(self.eval(tree)?, place.into(), self.model)
    }

    /// Runs the statements of a block, which sees its own writes (A33), and returns what it wrote.
    fn run(&self, statements: &[Statement]) -> Result<BTreeMap<Place, Value>, Error> {
        let mut own = BTreeMap::new();
        self.statements(statements, &mut own)?;
        Ok(own)
    }

    fn statements(&self, statements: &[Statement], own: &mut BTreeMap<Place, Value>) -> Result<(), Error> {
        for statement in statements {
            let view = View { own: Some(own), ..*self };
            match statement {
                Statement::Assign(place, tree) => {
                    let value = view.value_for(*place, tree)?;
                    own.insert(*place, value);
                }
                Statement::If(condition, then, otherwise) => {
                    let branch = if view.holds(condition)? { then } else { otherwise };
                    self.statements(branch, own)?;
                }
            }
        }
        Ok(())
    }
}

/// A time as `T` counts it.
fn saturated(time: Option<&u64>) -> u32 {
    time.map_or(0, |time| u32::try_from(*time).unwrap_or(u32::MAX))
}
