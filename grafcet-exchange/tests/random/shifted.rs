//! The CASE form acts on the situation before its transition. So after a scan its step is that of the cycle; where nothing has cleared, what is
//! continuous is what the cycle shows, and what is stored what the cycle before has shown; where something has cleared, what is continuous is off.
//!
//! What an action has read of inputs it reads one scan later here: such a value is not compared, nor what follows from it.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::model::{Association, Effect, Expr, Model, Name, Place, Qualifier, Read, Tree};
use grafcet_exchange::st::Form;
use grafcet_sim::interp;

use crate::play::{Pair, places};

/// What can be compared of a chart, and what the cycle before has shown.
pub(crate) struct Shifted {
    /// As the cycle shows it.
    same: BTreeSet<Name>,
    /// As the cycle before has shown it.
    before: BTreeSet<Name>,
    /// A transition reads what cannot be compared.
    astray: bool,
    shown: BTreeMap<Name, i128>,
}

impl Shifted {
    pub(crate) fn of(model: &Model) -> Self {
        let later = later(model);
        let (mut same, mut before, mut of_inputs) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        for name in places(model) {
            let writers: Vec<&Association> = model
                .associations
                .values()
                .filter(|one| one.effect.writes().iter().any(|at| Name::from(*at) == name))
                .collect();
            let continuous = writers.iter().any(|one| is_continuous(one));
            let reads_later = writers.iter().any(|one| names(one).iter().any(|read| later.contains(read)));
            let reads_inputs = writers.iter().any(|one| reads_inputs(one));
            // An edge of a step is that of the cycle before: the program asks where the step acts.
            let of_steps = writers.iter().any(|one| reads_edges_of_steps(model, one));
            let pulse = writers.iter().any(|one| one.qualifier == Qualifier::P);
            if continuous && reads_inputs {
                of_inputs.insert(name);
            }
            if reads_later || later.contains(&name) {
                continue;
            }
            if continuous && !pulse && !of_steps {
                same.insert(name);
            } else if !(pulse && reads_inputs || of_steps && continuous) {
                before.insert(name);
            }
        }
        let mut astray = false;
        for transition in model.transitions.values() {
            transition.condition.tree.each_read(&mut |read| {
                if let Read::Name(name) = read {
                    astray |= later.contains(&name) || of_inputs.contains(&name);
                }
            });
        }
        Self { same, before, astray, shown: BTreeMap::new() }
    }

    pub(crate) fn can_be_compared(&self) -> bool {
        !self.astray
    }
}

fn is_continuous(association: &Association) -> bool {
    let control = matches!(association.effect, Effect::Control(_))
        && !matches!(association.qualifier, Qualifier::S | Qualifier::R);
    control
        || matches!(association.effect, Effect::Assign(Place::Output(_), _)) && association.qualifier == Qualifier::N
}

fn expressions(association: &Association) -> Vec<&Expr> {
    association.condition.iter().chain(&association.event).chain(association.effect.expressions()).collect()
}

fn names(association: &Association) -> Vec<Name> {
    let all = association.reads().into_iter().flatten();
    all.filter_map(|read| if let Read::Name(name) = read { Some(*name) } else { None }).collect()
}

/// Whether what it does depends on the moment.
fn reads_inputs(association: &Association) -> bool {
    let moment = |read: &Read| {
        !matches!(read, Read::Name(Name::Output(_) | Name::Var(_) | Name::Param(_)) | Read::Ticks(_) | Read::Active(_))
    };
    let trees = expressions(association);
    association.reads().into_iter().flatten().any(moment)
        || trees.iter().any(|expr| matches!(expr.tree, Tree::Opaque { .. }))
}

/// Edges and delays of steps.
fn reads_edges_of_steps(model: &Model, association: &Association) -> bool {
    let of_step = |read: &Read| matches!(read, Read::Active(_) | Read::MacroActive(_));
    association.reads().into_iter().flatten().any(|read| match read {
        Read::Rising(id) | Read::Falling(id) => model.edges[*id].of.reads.iter().any(of_step),
        Read::Delay(id) => model.delays[*id].of.reads.iter().any(of_step),
        _ => false,
    })
}

/// What is stored of inputs, and of what is stored of them.
fn later(model: &Model) -> BTreeSet<Name> {
    let mut later = BTreeSet::new();
    loop {
        let known = later.len();
        for association in model.associations.values().filter(|one| !is_continuous(one)) {
            if reads_inputs(association)
                || names(association).iter().any(|read| later.contains(read) || of_moment(model, *read))
            {
                later.extend(association.effect.writes().iter().map(|place| Name::from(*place)));
            }
        }
        if later.len() == known {
            return later;
        }
    }
}

/// Continuous actions that look at inputs.
fn of_moment(model: &Model, name: Name) -> bool {
    let writes = |one: &&Association| one.effect.writes().iter().any(|place| Name::from(*place) == name);
    model.associations.values().filter(writes).any(|one| is_continuous(one) && reads_inputs(one))
}

impl Pair<'_> {
    /// One scan beside one cycle. The first cycle of an `sfc` only enters its step, which the program does not need a scan for: both have the inputs and
    /// the time of the next one.
    pub(crate) fn shifted(
        &mut self,
        inputs: &[interp::Value],
        now: u32,
        shifted: &mut Shifted,
    ) -> Result<bool, String> {
        if self.fresh {
            self.fresh = false;
            if self.oracle.cycle(inputs, now).is_err() {
                return Ok(false);
            }
            shifted.shown = places(self.model).into_iter().map(|name| (name, self.expected(name))).collect();
        }
        let Ok(cycle) = self.oracle.cycle(inputs, now) else { return Ok(false) };
        self.scan()?;
        self.steps(Form::Case)?;
        let cleared = cycle.seen.iter().any(|evolution| !evolution.cleared.is_empty());
        for name in places(self.model) {
            let expected = match (shifted.same.contains(&name), shifted.before.contains(&name)) {
                (true, _) if cleared => 0,
                (true, _) => self.expected(name),
                (_, true) if !cleared => shifted.shown[&name],
                _ => continue,
            };
            let found = self.shown(name)?;
            // Off is the initial value, which another one than zero is not compared with.
            if found != expected
                && !(cleared && expected == 0 && shifted.same.contains(&name) && has_init(self.model, name))
            {
                return Err(format!("{} = {found}, expected {expected}", self.model.value_name(name)));
            }
        }
        shifted.shown = places(self.model).into_iter().map(|name| (name, self.expected(name))).collect();
        Ok(true)
    }
}

fn has_init(model: &Model, name: Name) -> bool {
    match name {
        Name::Output(id) => model.outputs[id].init.is_some(),
        Name::Var(id) => model.vars[id].init.is_some(),
        Name::Input(_) | Name::Param(_) => false,
    }
}
