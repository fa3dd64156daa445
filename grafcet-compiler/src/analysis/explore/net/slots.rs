//! Which boolean variables and outputs are followed from cycle to cycle: those that conditions read and whose writes are
//! all understood.

use crate::list::List;
use crate::model::{
    Arena, Association, AssociationId, Effect, Expr, Model, Name, Place, Qualifier, Read, TransitionId, Tree, Ty, ids,
};
use crate::sorted::{Map, Set};

ids! {
    /// A place that is followed from cycle to cycle, or a flip-flop of one.
    pub(crate) SlotId;
}

/// A value that is followed.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Bit {
    False,
    True,
    /// Either.
    Any,
}

impl From<bool> for Bit {
    fn from(value: bool) -> Self {
        if value { Self::True } else { Self::False }
    }
}

/// The places that are followed, numbered.
pub(crate) struct Slots {
    pub(crate) numbers: Map<Place, SlotId>,
    /// `sfc`: the flip-flops of the action control where they are not the place itself: of S, SD, DS and SL.
    pub(crate) flip_flops: Map<(Place, Qualifier), SlotId>,
    /// What each holds before the first cycle.
    pub(crate) initial: Arena<SlotId, Bit>,
    /// `sfc`: places that are computed anew in each cycle and that nothing in the chart reads.
    pub(crate) shown: Vec<SlotId>,
}

impl Slots {
    /// Of a chart of which only these transitions are looked at; what is `mixed` is not followed.
    pub(crate) fn of(
        model: &Model,
        mixed: &Set<Place>,
        watched: &[&Tree],
        kept: &dyn Fn(TransitionId) -> bool,
    ) -> Self {
        let mut slots =
            Self { numbers: Map::new(), flip_flops: Map::new(), initial: Arena::default(), shown: Vec::new() };
        let writers = Writers::of(model);
        for place in needed(model, &writers, watched, kept) {
            if mixed.contains(&place) || !writers.can_be_followed(model, place) {
                continue;
            }
            let slot = slots.initial.push(initial(model, place));
            slots.numbers.insert(place, slot);
            if model.is_grafcet() {
                continue;
            }
            for qualifier in writers.flip_flops(model, place) {
                let flip_flop = slots.initial.push(Bit::False);
                slots.flip_flops.insert((place, qualifier), flip_flop);
            }
            if writers.is_only_shown(model, place) {
                slots.shown.push(slot);
            }
        }
        slots
    }
}

fn initial(model: &Model, place: Place) -> Bit {
    match model.init_of(place).map(|init| &init.tree) {
        None => Bit::False,
        Some(Tree::Bool(value)) => Bit::from(*value),
        Some(_) => Bit::Any,
    }
}

/// The places that conditions read, directly or because a place that they read depends on them.
fn needed(model: &Model, writers: &Writers<'_>, watched: &[&Tree], kept: &dyn Fn(TransitionId) -> bool) -> Set<Place> {
    let mut needed = Set::new();
    let transitions = model.transitions.iter().filter(|(id, _)| kept(*id));
    let mut reads: Vec<Read> = transitions.flat(|(_, t)| t.condition.reads.iter().copied()).list();
    for tree in watched {
        reads_of(tree, &mut reads);
    }
    let mut edges = Set::new();
    while let Some(read) = reads.pop() {
        let place = match read {
            Read::Rising(id) | Read::Falling(id) => {
                if edges.insert(id) {
                    reads.extend(&model.edges[id].of.reads);
                }
                continue;
            }
            Read::Name(Name::Var(id)) => Place::Var(id),
            Read::Name(Name::Output(id)) => Place::Output(id),
            _ => continue,
        };
        if needed.insert(place) {
            for effect in writers.effects(place) {
                reads.extend(effect.reads().into_iter().flatten());
            }
            for association in writers.associations(model, place) {
                let conditions = association.condition.iter().and(&association.event);
                reads.extend(conditions.flat(|expr: &Expr| &expr.reads));
            }
        }
    }
    needed
}

/// What a tree reads.
fn reads_of(tree: &Tree, reads: &mut Vec<Read>) {
    match tree {
        Tree::Read(read) => reads.push(*read),
        Tree::Unary(_, inner) => reads_of(inner, reads),
        Tree::Binary(_, a, b) => {
            reads_of(a, reads);
            reads_of(b, reads);
        }
        Tree::Opaque { reads: inside, .. } => reads.extend(inside),
        Tree::Bool(_) | Tree::Int(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => {}
    }
}

/// Who writes each place.
struct Writers<'m> {
    associations: Map<Place, Vec<AssociationId>>,
    effects: Map<Place, Vec<&'m Effect>>,
}

impl<'m> Writers<'m> {
    fn of(model: &'m Model) -> Self {
        let mut writers = Self { associations: Map::new(), effects: Map::new() };
        for (id, association) in model.associations.iter() {
            for place in association.effect.writes() {
                writers.associations.or_default(*place).push(id);
                writers.effects.or_default(*place).push(&association.effect);
            }
        }
        for effect in model.transitions.values().flat(|t| &t.clearing) {
            for place in effect.writes() {
                writers.effects.or_default(*place).push(effect);
            }
        }
        writers
    }

    fn associations<'a>(&'a self, model: &'a Model, place: Place) -> impl Iterator<Item = &'a Association> {
        self.associations.get(&place).into_iter().flatten().map(|id| &model.associations[*id])
    }

    fn effects(&self, place: Place) -> impl Iterator<Item = &'m Effect> {
        self.effects.get(&place).into_iter().flatten().copied()
    }

    fn can_be_followed(&self, model: &Model, place: Place) -> bool {
        let understood = self.effects(place).all(|effect| match effect {
            Effect::Block(code) => code.statements.is_some(),
            _ => true,
        });
        let boolean = matches!(model.place_ty(place), Ty::Bool(_));
        let fits = |a: &Association| if model.is_grafcet() { fits_grafcet(a) } else { fits_sfc(a, place) };
        boolean && understood && self.associations(model, place).all(fits) && self.one_kind(model, place)
    }

    /// `sfc`: a place is controlled, assigned or written, not two of these.
    fn one_kind(&self, model: &Model, place: Place) -> bool {
        let kind = |a: &Association| match (&a.effect, a.qualifier) {
            (Effect::Control(_), _) => 0,
            (Effect::Assign(Place::Output(_), _), Qualifier::N) => 1,
            _ => 2,
        };
        let kinds: Set<i32> = self.associations(model, place).map(kind).collect();
        model.is_grafcet() || kinds.len() < 2
    }

    /// The qualifiers that need a flip-flop of their own.
    fn flip_flops(&self, model: &Model, place: Place) -> Vec<Qualifier> {
        let with = |wanted: Qualifier| self.associations(model, place).any(|a| a.qualifier == wanted);
        let stored = self.associations(model, place).all(|a| a.qualifier.sets_or_resets());
        let has = |qualifier: &Qualifier| qualifier.has_flip_flop() && !stored && with(*qualifier);
        Qualifier::ALL.into_iter().filter(has).list()
    }

    /// Whether an output has no memory, and nothing in the chart reads it.
    fn is_only_shown(&self, model: &Model, place: Place) -> bool {
        let Place::Output(id) = place else { return false };
        let read = model.expressions().iter().any(|reads| reads.contains(&Read::Name(Name::Output(id))));
        let control = |a: &Association| matches!(a.effect, Effect::Control(_));
        let stored = |a: &Association| a.qualifier.sets_or_resets();
        let all = || self.associations(model, place);
        let computed = all().all(control) && !all().all(stored) || all().all(|a| a.qualifier == Qualifier::N);
        !read && computed && all().next().is_some()
    }
}

fn fits_grafcet(association: &Association) -> bool {
    let is_control = matches!(association.effect, Effect::Control(_));
    association.qualifier.sets_or_resets() && is_control || association.qualifier.runs_once() && !is_control
}

fn fits_sfc(association: &Association, place: Place) -> bool {
    match (&association.effect, association.qualifier) {
        (Effect::Control(_), qualifier) => !qualifier.runs_once(),
        (_, Qualifier::P1 | Qualifier::P0) => true,
        (Effect::Assign(..), Qualifier::N) if matches!(place, Place::Output(_)) => true,
        // Whether it was active in the cycle before decides about its final scan.
        (_, Qualifier::N) => association.condition.is_none(),
        _ => false,
    }
}
