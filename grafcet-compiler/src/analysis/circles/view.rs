//! What the conditions are in the evolutions after the first one of a cycle.

use super::Circles;
use super::run::Node;
use crate::analysis::Condition;
use crate::analysis::logic::UNKNOWN;
use crate::list::List;
use crate::model::{
    Binary, Blink, Blinker, EdgeId, Effect, Id, MacroId, Model, Name, Place, Read, StepId, TimeRef, TransitionId, Tree,
};
use crate::sorted::Set;

/// The conditions as one evolution sees them.
pub(super) struct View<'v, 'm> {
    circles: &'v Circles<'m>,
    node: &'v Node,
}

impl<'v, 'm> View<'v, 'm> {
    pub(super) fn new(circles: &'v Circles<'m>, node: &'v Node) -> Self {
        Self { circles, node }
    }

    /// The condition of a transition.
    pub(super) fn condition(&self, id: TransitionId) -> Condition {
        self.circles.logic.condition(&self.tree(&self.circles.trees[id.index()]))
    }

    fn tree(&self, tree: &Tree) -> Tree {
        match tree {
            Tree::Bool(_) | Tree::Int(_) => tree.clone(),
            Tree::Read(read) => self.read(*read),
            Tree::Elapsed(time, step) => self.elapsed(self.active(*step), self.since(*step), *time),
            Tree::MacroElapsed(time, id) => self.elapsed(self.macro_active(*id), None, *time),
            Tree::Unary(operator, inner) => Tree::Unary(*operator, Box::new(self.tree(inner))),
            Tree::Binary(operator, a, b) => Tree::Binary(*operator, Box::new(self.tree(a)), Box::new(self.tree(b))),
            Tree::Opaque { reads, call, .. } => {
                if call.is_none() && reads.iter().all(|read| self.stands_still(*read)) {
                    tree.clone()
                } else {
                    self.unknown()
                }
            }
        }
    }

    fn read(&self, read: Read) -> Tree {
        let known = match read {
            Read::Active(step) => self.active(step).map(Tree::Bool),
            Read::MacroActive(id) => self.macro_active(id).map(Tree::Bool),
            Read::Since(step) => self.since(step),
            Read::Rising(id) => self.edge(id, true).map(Tree::Bool),
            Read::Falling(id) => self.edge(id, false).map(Tree::Bool),
            Read::Blink(blink) => self.blink(blink),
            read => self.stands_still(read).then_some(Tree::Read(read)),
        };
        known.unwrap_or_else(|| self.unknown())
    }

    /// `t/Step`
    fn elapsed(&self, active: Option<bool>, since: Option<Tree>, time: TimeRef) -> Tree {
        let time = match time {
            TimeRef::Ticks(ticks) => Tree::Read(Read::Ticks(ticks)),
            TimeRef::Param(id) => Tree::Read(Read::Name(Name::Param(id))),
            TimeRef::Var(_) => return self.unknown(),
        };
        match (active, since) {
            (Some(false), _) => Tree::Bool(false),
            (Some(true), Some(since)) => Tree::Binary(Binary::Ge, Box::new(since), Box::new(time)),
            _ => self.unknown(),
        }
    }

    /// Whether a step is active, where that is known: it is followed, or excluded by one that is.
    fn active(&self, step: StepId) -> Option<bool> {
        if self.node.active.contains(&step) {
            return Some(true);
        }
        self.is_excluded(step, &self.node.active).then_some(false)
    }

    fn is_excluded(&self, step: StepId, active: &Set<StepId>) -> bool {
        let concurrency = self.circles.concurrency;
        let excludes = |other: &StepId| {
            self.circles.model.steps[*other].partial == self.circles.model.steps[step].partial
                && concurrency.reachable(*other)
                && !concurrency.together(*other, step)
        };
        active.iter().any(excludes)
    }

    fn macro_active(&self, id: MacroId) -> Option<bool> {
        let mut steps = self.circles.model.macros[id].steps.iter().map(|step| self.active(*step));
        let mut all_known = true;
        let any = steps.any(|active| {
            all_known &= active.is_some();
            active == Some(true)
        });
        (any || all_known).then_some(any)
    }

    /// `T` of a step: zero where it was entered in this cycle or is not active; elsewhere it stands still.
    fn since(&self, step: StepId) -> Option<Tree> {
        let goes_on = self.active(step)? && !self.node.just_entered.contains(&step);
        Some(Tree::Read(if goes_on { Read::Since(step) } else { Read::Ticks(0) }))
    }

    /// It shines at the begin of a step's activity; elsewhere it stands still.
    fn blink(&self, blink: Blink) -> Option<Tree> {
        match blink.of {
            Blinker::Step(step) => Some(match self.active(step)? {
                true if self.node.just_entered.contains(&step) => Tree::Bool(true),
                true => Tree::Read(Read::Blink(blink)),
                false => Tree::Bool(false),
            }),
            Blinker::Macro(id) => self.macro_active(id).filter(|active| !active).map(Tree::Bool),
        }
    }

    /// Edges of inputs are gone (A2); those of a step variable are about this evolution (A36).
    fn edge(&self, id: EdgeId, rising: bool) -> Option<bool> {
        let of = &self.circles.model.edges[id].of;
        if of.reads.iter().all(|read| self.stands_still(*read)) {
            return Some(false);
        }
        let Tree::Read(Read::Active(step)) = of.tree else { return None };
        let now = self.active(step)?;
        let before = self.node.before.contains(&step);
        if !before && !self.is_excluded(step, &self.node.before) {
            return None;
        }
        Some(if rising { now && !before } else { before && !now })
    }

    /// Whether a value is the same in all evolutions of a cycle.
    fn stands_still(&self, read: Read) -> bool {
        match read {
            Read::Name(name) => !self.circles.written.contains(&name),
            Read::Ticks(_) | Read::Delay(_) => true,
            _ => false,
        }
    }

    /// A value that is asked for once.
    fn unknown(&self) -> Tree {
        let number = self.circles.unknown.get();
        self.circles.unknown.set(number + 1);
        Tree::Opaque {
            text: format!("{UNKNOWN}{number}"),
            reads: Vec::new(),
            call: None,
            whole: false,
            open: false,
            of: None,
        }
    }
}

/// What the actions of a chart may change.
pub(super) fn written(model: &Model) -> Set<Name> {
    let clearings = model.transitions.values().flat(|transition| &transition.clearing);
    let effects = model.associations.values().map(|association| &association.effect).and(clearings);
    let mut written = Set::new();
    for effect in effects {
        match effect {
            Effect::Control(place) | Effect::Assign(place, _) => _ = written.insert(Name::from(*place)),
            Effect::Block(code) => written.extend(code.writes.iter().map(|place: &Place| Name::from(*place))),
            Effect::Call(..) => {}
        }
    }
    written
}
