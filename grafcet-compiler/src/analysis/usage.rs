//! What takes part in a chart, and what of it outlives a cycle.

use crate::list::List;
use crate::model::{
    ActionId, Association, Code, Effect, Expr, Model, Name, OutputId, Place, Qualifier, Read, Statement, TimeRef, Tree,
};
use crate::sorted::Set;

/// What the chart reads and writes.
pub(crate) struct Usage {
    read: Set<Name>,
    written: Set<Place>,
    called: Set<ActionId>,
}

impl Usage {
    pub(crate) fn of(model: &Model) -> Self {
        let effects = model.effects();
        let written = effects.iter().flat(|effect| effect.writes()).copied().collect();
        let mut usage = Self { read: Set::new(), written, called: Set::new() };
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
        for effect in effects {
            match effect {
                Effect::Control(_) => {}
                Effect::Assign(place, value) => usage.assigned(*place, &value.reads),
                Effect::Call(action, arguments) => {
                    usage.called.insert(*action);
                    for argument in arguments {
                        usage.expr(argument);
                    }
                }
                Effect::Block(code) => usage.block(code),
            }
        }
        usage
    }

    pub(crate) fn reads(&self, name: Name) -> bool {
        self.read.contains(&name)
    }

    pub(crate) fn writes(&self, place: Place) -> bool {
        self.written.contains(&place)
    }

    pub(crate) fn calls(&self, action: ActionId) -> bool {
        self.called.contains(&action)
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

/// The outputs that keep their value from cycle to cycle: an action stores it, or, in an `sfc`, an expression reads what it was in the cycle before.
pub(crate) fn remembered(model: &Model) -> Set<OutputId> {
    let output = |place: &Place| if let Place::Output(id) = place { Some(*id) } else { None };
    let mut found = Set::new();
    let lasts = |association: &&Association| match association.effect {
        // What is controlled may be an alias of `bool`.
        Effect::Control(_) => association.qualifier == Qualifier::S,
        Effect::Assign(..) => association.qualifier != Qualifier::N,
        Effect::Call(..) | Effect::Block(_) => true,
    };
    for association in model.associations.values().filter(lasts) {
        found.extend(association.effect.writes().iter().filter_map(output));
    }
    for effect in model.transitions.values().flat(|transition| &transition.clearing) {
        found.extend(effect.writes().iter().filter_map(output));
    }
    // In a `grafcet` only stored outputs can be read (A22).
    for read in model.expressions().into_iter().flatten() {
        if let (Read::Name(Name::Output(id)), false) = (read, model.is_grafcet()) {
            found.insert(*id);
        }
    }
    found
}
