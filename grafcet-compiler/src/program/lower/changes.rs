//! At which times of a step or macro-step something changes: what expressions and qualifiers compare with.

use super::control::{What, what};
use crate::list::List;
use crate::model::{
    Association, AssociationId, Binary, Blinker, Effect, Expr as Written, Id, Model, Name, Read, StepId, TimeRef,
    TransitionId, Tree,
};
use crate::program::{RegionId, Regions};
use crate::sorted::Set;

/// At which times of a step or macro-step something changes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Change {
    /// At the time itself.
    At(TimeRef),
    /// One tick after it.
    After(TimeRef),
    /// At the ends of both parts of a period.
    Blink(u32, u32),
    /// At every tick: the time is used in another way than in a comparison.
    Always,
}

pub(super) type Changes = Set<(Blinker, Change)>;

/// Every time that an expression or a qualifier looks at.
pub(super) fn changes(model: &Model, regions: &Regions) -> Changes {
    let mut found = Set::new();
    for transition in model.transitions.values() {
        of_tree(&transition.condition.tree, &mut found);
        transition.clearing.iter().for_each(|effect| of_effect(effect, &mut found));
    }
    for (id, association) in model.associations.iter() {
        association.condition.iter().and(&association.event).for_each(|one| of_tree(&one.tree, &mut found));
        of_effect(&association.effect, &mut found);
        if let Some(time) = association.time.filter(|_| is_time_of_step(model, regions, id)) {
            found.insert((Blinker::Step(association.step), Change::At(time)));
        }
    }
    model.steps.values().filter_map(|step| step.late).for_each(|late| of_read(late, &mut found));
    model.edges.values().for_each(|edge| of_tree(&edge.of.tree, &mut found));
    model.delays.values().for_each(|delay| of_tree(&delay.of.tree, &mut found));
    found
}

/// Whether what limits or delays an action is the time of its step: in a `grafcet` always (A32), in an `sfc` where its timer would say the
/// same.
pub(super) fn is_time_of_step(model: &Model, regions: &Regions, id: AssociationId) -> bool {
    if model.is_grafcet() {
        return model.associations[id].qualifier.has_time();
    }
    limits_by_step(model, regions, id)
}

/// Whether the timer of an association says what the time of its step says: its input is true whenever the step is active, and where it is that of other
/// steps, too, it falls between them.
pub(super) fn limits_by_step(model: &Model, regions: &Regions, id: AssociationId) -> bool {
    let association = &model.associations[id];
    if !association.qualifier.restarts_with_step() || association.condition.is_some() {
        return false;
    }
    let sharing = of_one_timer(model, id);
    let steps: Set<StepId> = sharing.iter().map(|one| one.step).collect();
    sharing.len() < 2
        || sharing.len() == steps.len()
            && sharing.iter().all(|one| one.condition.is_none())
            && are_apart(model, regions, &steps)
}

/// The associations that share a timer with this one, and itself.
pub(super) fn of_one_timer(model: &Model, id: AssociationId) -> Vec<&Association> {
    let association = &model.associations[id];
    let (qualifier, target) = (association.qualifier, what(association));
    let shares = |another: &&Association| another.qualifier == qualifier && what(another) == target;
    match target {
        What::Own => vec![association],
        What::Place(_) | What::Action(_) => model.associations.values().filter(shares).list(),
    }
}

/// Whether none of these steps is active beside another one or directly after it, as steps of one region of which each is entered from within it.
fn are_apart(model: &Model, regions: &Regions, steps: &Set<StepId>) -> bool {
    let mut own: Set<RegionId> = Set::new();
    own.extend(steps.iter().map(|step| regions.of_step(*step)));
    let is_own = |step: &StepId| own.contains(&regions.of_step(*step));
    let comes_between = |id: &TransitionId| {
        let transition = &model.transitions[*id];
        let leads = |from: &StepId| steps.contains(from) && !transition.targets.contains(from);
        transition.sources.iter().any(is_own) && !transition.sources.iter().any(leads)
    };
    own.len() == 1
        && !model.forceable
        && steps.iter().all(|step| model.entering[step.index()].iter().all(comes_between))
}

fn of_effect(effect: &Effect, found: &mut Changes) {
    let of_expr = |expr: &Written, found: &mut Changes| of_tree(&expr.tree, found);
    match effect {
        Effect::Control(_) => {}
        Effect::Assign(_, value) => of_expr(value, found),
        Effect::Call(_, args) => args.iter().for_each(|arg| of_expr(arg, found)),
        Effect::Block(code) => code.reads.iter().for_each(|read| of_read(*read, found)),
    }
}

fn of_tree(tree: &Tree, found: &mut Changes) {
    match tree {
        Tree::Binary(operator, a, b) => {
            if !comparison(*operator, a, b, found) && !comparison(operator.mirrored(), b, a, found) {
                of_tree(a, found);
                of_tree(b, found);
            }
        }
        Tree::Unary(_, inner) => of_tree(inner, found),
        other => other.each_read(&mut |read| of_read(read, found)),
    }
}

fn of_read(read: Read, found: &mut Changes) {
    let Some(of) = read.about() else { return };
    let change = match read {
        Read::Since(_) | Read::MacroSince(_) => Change::Always,
        Read::Elapsed(time, _) | Read::MacroElapsed(time, _) => Change::At(time),
        Read::Blink(blink) => Change::Blink(blink.on, blink.period()),
        _ => return,
    };
    found.insert((of, change));
}

/// `Step.T < 5s`: when its truth can change.
fn comparison(operator: Binary, a: &Tree, b: &Tree, found: &mut Changes) -> bool {
    let of = match a {
        Tree::Read(read @ (Read::Since(_) | Read::MacroSince(_))) => read.about(),
        _ => None,
    };
    let time = match b {
        Tree::Read(Read::Ticks(ticks)) => TimeRef::Ticks(*ticks),
        Tree::Read(Read::Name(Name::Param(id))) => TimeRef::Param(*id),
        Tree::Read(Read::Name(Name::Var(id))) => TimeRef::Var(*id),
        _ => return false,
    };
    let Some(of) = of else { return false };
    match operator {
        Binary::Lt | Binary::Ge => _ = found.insert((of, Change::At(time))),
        Binary::Gt | Binary::Le => _ = found.insert((of, Change::After(time))),
        Binary::Eq | Binary::Ne => {
            found.insert((of, Change::At(time)));
            found.insert((of, Change::After(time)));
        }
        _ => return false,
    }
    true
}
