//! `unused_input`, `undriven_output`, `unused_variable`, `unused_action`, `unused_param`, `unused_let`: what is declared and takes no
//! part in the chart. As in rustc, a name that begins with `_` says that this is meant.

use proc_macro2::Ident;

use crate::diagnostic::{Rule, Sink, rules};
use crate::list::List;
use crate::model::{Code, Effect, Expr, LevelAttr, Model, Name, Place, Read, Statement, TimeRef, Tree};
use crate::sorted::Set;

pub(super) fn check(model: &Model, sink: &mut Sink) {
    let usage = Usage::of(model);
    let mut report = |rule: &'static Rule, name: &Ident, levels: &[LevelAttr], message: String| {
        if !name.to_string().trim_start_matches("r#").starts_with('_') {
            sink.rule(rule, &[levels, &model.levels], vec![(name.into(), message)]);
        }
    };
    for (id, input) in model.inputs.iter().filter(|(id, _)| !usage.reads(Name::Input(*id))) {
        let name = &model.inputs[id].name;
        // Those of a plant may be written as its faults and choices.
        let what = if model.is_plant { "" } else { "input " };
        report(&rules::UNUSED_INPUT, name, &input.levels, format!("{what}`{name}` is never read; {}", mend(name)));
    }
    for (id, output) in model.outputs.iter().filter(|(id, _)| !usage.writes(Place::Output(*id))) {
        let name = &model.outputs[id].name;
        let message = format!(
            "no action of the chart gives output `{name}` a value; let a step do so, delete it, or call it `{}` if \
             that is meant",
            meant(name)
        );
        report(&rules::UNDRIVEN_OUTPUT, name, &output.levels, message);
    }
    for (id, var) in model.vars.iter() {
        let name = &var.name;
        let message = match (usage.reads(Name::Var(id)), usage.writes(Place::Var(id))) {
            (true, true) => continue,
            (true, false) => {
                format!(
                    "variable `{name}` is read and never written; make it a `param`, write it, or call it `{}`",
                    meant(name)
                )
            }
            // The program may.
            (false, true) => format!(
                "variable `{name}` is written and never read in the chart; read it, delete it, or call it `{}` if only the \
                 program reads it, by `vars()`",
                meant(name)
            ),
            (false, false) => format!("variable `{name}` is never used; {}", mend(name)),
        };
        report(&rules::UNUSED_VARIABLE, name, &var.levels, message);
    }
    for (id, action) in model.actions.iter() {
        if !model.effects().iter().any(|effect| matches!(effect, Effect::Call(called, _) if *called == id)) {
            let name = &action.name;
            let message = format!("action `{name}` is never called; {}", mend(name));
            report(&rules::UNUSED_ACTION, name, &action.levels, message);
        }
    }
    for (id, param) in model.params.iter().filter(|(id, _)| !usage.reads(Name::Param(*id))) {
        let name = &model.params[id].name;
        report(&rules::UNUSED_PARAM, name, &param.levels, format!("param `{name}` is never read; {}", mend(name)));
    }
    for named in model.lets.values().filter(|named| !named.used) {
        let name = &named.name;
        report(&rules::UNUSED_LET, name, &named.levels, format!("condition `{name}` is never used; {}", mend(name)));
    }
}

fn mend(name: &Ident) -> String {
    format!("use it, delete it, or call it `{}` if that is meant", meant(name))
}

/// The name of something that takes no part in the chart, and is meant to: `_mod` for `r#mod`.
fn meant(name: &Ident) -> String {
    format!("_{}", name.to_string().trim_start_matches("r#"))
}

/// What the chart reads and writes.
struct Usage {
    read: Set<Name>,
    written: Set<Place>,
}

impl Usage {
    fn of(model: &Model) -> Self {
        let mut usage =
            Self { read: Set::new(), written: model.effects().into_iter().flat(Effect::writes).copied().collect() };
        for transition in model.transitions.values() {
            usage.expr(&transition.condition);
        }
        for association in model.associations.values() {
            association.condition.iter().and(&association.event).for_each(|expr| usage.expr(expr));
            usage.times(association.time);
        }
        model.steps.values().for_each(|step| usage.times(step.within()));
        for delay in model.delays.values() {
            usage.expr(&delay.of);
            usage.times([delay.on, delay.off]);
        }
        model.edges.values().for_each(|edge| usage.expr(&edge.of));
        // As in rustc, what is only mentioned in what is unused itself is one warning, not two.
        model.lets.values().for_each(|named| usage.read.extend(&named.mentions));
        model.assumptions.iter().for_each(|assumption| usage.expr(&assumption.never));
        model.often.iter().for_each(|often| usage.expr(often));
        model.orders.iter().flat(|order| order.claim.expressions()).for_each(|expr| usage.expr(expr));
        model.properties.iter().flat(|property| property.claim.expressions()).for_each(|expr| usage.expr(expr));
        for effect in model.effects() {
            match effect {
                Effect::Control(_) => {}
                Effect::Assign(place, value) => usage.assigned(*place, &value.reads),
                Effect::Call(_, arguments) => arguments.iter().for_each(|argument| usage.expr(argument)),
                Effect::Block(code) => usage.block(code),
            }
        }
        usage
    }

    fn reads(&self, name: Name) -> bool {
        self.read.contains(&name)
    }

    fn writes(&self, place: Place) -> bool {
        self.written.contains(&place)
    }

    fn expr(&mut self, expr: &Expr) {
        self.all(&expr.reads);
    }

    fn all(&mut self, reads: &[Read]) {
        for read in reads {
            match read {
                Read::Name(name) => _ = self.read.insert(*name),
                Read::Elapsed(time, _) | Read::MacroElapsed(time, _) => self.times([*time]),
                _ => {}
            }
        }
    }

    fn times(&mut self, times: impl IntoIterator<Item = TimeRef>) {
        for time in times {
            match time {
                TimeRef::Ticks(_) => {}
                TimeRef::Param(id) => _ = self.read.insert(Name::Param(id)),
                TimeRef::Var(id) => _ = self.read.insert(Name::Var(id)),
            }
        }
    }

    /// `count = count + 1` alone makes no use of `count`.
    fn assigned(&mut self, place: Place, reads: &[Read]) {
        let known = self.read.contains(&Name::from(place));
        self.all(reads);
        if let (false, Place::Var(id)) = (known, place) {
            self.read.remove(&Name::Var(id));
        }
    }

    fn block(&mut self, code: &Code) {
        match &code.statements {
            Some(statements) => self.statements(statements),
            None => self.all(&code.reads),
        }
    }

    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Assign(place, value) => self.assigned(*place, &reads_of(value)),
                Statement::If(condition, then, otherwise) => {
                    self.all(&reads_of(condition));
                    self.statements(then);
                    self.statements(otherwise);
                }
            }
        }
    }
}

fn reads_of(tree: &Tree) -> Vec<Read> {
    let mut reads = Vec::new();
    tree.each_read(&mut |read| reads.push(read));
    reads
}
