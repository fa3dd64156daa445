//! `ACTION_CONTROL` of IEC 61131-3 (point 4): for each target (A31) the function block of the standard, as far as the target's
//! qualifiers need it.
//!
//! ```text
//! S_FF  = RS(S, R)      L_TMR  = TON(L, t)       D_TMR = TON(D, t)          P_TRIG = P
//! SD_FF = RS(SD, R)     SD_TMR = TON(SD_FF, t)
//! DS_TMR = TON(DS, t)   DS_FF  = RS(DS_TMR, R)
//! SL_FF = RS(SL, R)     SL_TMR = TON(SL_FF, t)
//! Q = !R && (N || S_FF || (L && !L_TMR) || D_TMR || P_TRIG || SD_TMR || DS_FF || (SL_FF && !SL_TMR))
//! ```

use super::Lower;
use super::view::Moment;
use crate::list::{List, PushAll};
use crate::model::{ActionId, Association, AssociationId, Dialect, Effect, Id, Place, Qualifier, Trigger};
use crate::program::build::{all, any, compare, not, number, when, yes};
use crate::program::{Comparison, Expr, Initial, PlaceId, Role, Statement, Type, Value};
use crate::raw::plain;
use crate::sorted::sort_by_key;

/// A31: what associations are combined for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum What {
    /// A boolean is controlled, or an output assigned (A35), by its name.
    Place(Place),
    /// A declared action by its name, whatever its arguments.
    Action(ActionId),
    /// Every block and every assignment to a variable.
    Own,
}

/// A target with its associations.
pub(super) struct Target {
    pub(super) what: What,
    /// In source order.
    pub(super) associations: Vec<AssociationId>,
    pub(super) name: String,
    pub(super) q: PlaceId,
    /// Q of the cycle before, where something runs when it rises or falls.
    pub(super) was: Option<PlaceId>,
    /// The association that acted last, where several may.
    pub(super) acted: Option<PlaceId>,
    /// Q has fallen because a step with N, L or D was left.
    pub(super) by_leaving: Option<PlaceId>,
}

/// A term of Q.
struct Term<'m> {
    qualifier: Qualifier,
    holds: Expr<'m>,
    /// What sets its flip-flop, beside the flag of an association.
    sets: Expr<'m>,
}

impl<'m> Term<'m> {
    /// Whether an association with this flag, and a qualifier without a flip-flop, makes it hold.
    fn of(&self, flag: PlaceId) -> Expr<'m> {
        if self.qualifier.drives_q_at_once() {
            return Expr::Place(flag);
        }
        all(vec![Expr::Place(flag), self.holds.clone()])
    }
}

impl<'m> Lower<'_, 'm> {
    /// All targets, in the order in which they first stand in the source.
    pub(super) fn targets(&mut self) -> Vec<Target> {
        let mut grouped: Vec<(What, Vec<AssociationId>)> = Vec::new();
        for (id, association) in self.model.associations.iter() {
            let what = what(association);
            match grouped.iter_mut().find(|(other, _)| *other == what && what != What::Own) {
                Some((_, associations)) => associations.push(id),
                None => grouped.push((what, vec![id])),
            }
        }
        grouped.into_iter().map(|(what, associations)| self.target(what, associations)).list()
    }

    fn target(&mut self, what: What, associations: Vec<AssociationId>) -> Target {
        let model = self.model;
        let first = associations[0];
        let name = match what {
            What::Place(place) => plain(model.place_name(place)),
            What::Action(id) => plain(&model.actions[id].name),
            What::Own => format!("{}.{}", self.step_name(model.associations[first].step), first.index()),
        };
        let q = self.truth(format!("q.{name}"));
        let driving = associations.iter().filter(|id| model.associations[**id].qualifier.drives_q()).count();
        let runs = driving > 0 && !matches!(what, What::Place(_));
        let bool_field = Initial::Value(Value::Bool(false));
        let was = runs.then(|| self.field(format!("was.q.{name}"), Role::Active(first), Type::Bool, bool_field));
        let acted = (runs && driving > 1).then(|| {
            let begin = Initial::Value(Value::Int(0));
            self.field(format!("acted.{name}"), Role::Acted(first), Type::Number, begin)
        });
        let held = associations.iter().any(|id| model.associations[*id].qualifier.is_continuous());
        let by_leaving = (runs && held).then(|| self.truth(format!("by_leaving.{name}")));
        Target { what, associations, name, q, was, acted, by_leaving }
    }

    /// The flags of all associations: "the OR of the step flags of the associations that carry the qualifier (`N q if c`: flag and
    /// condition); P, P1 and P0 are events". All are read before the first action runs (point 5).
    pub(super) fn flags(&mut self) -> (Vec<PlaceId>, Vec<Statement<'m>>) {
        let model = self.model;
        let (mut flags, mut body) = (Vec::new(), Vec::new());
        for (id, association) in model.associations.iter() {
            let name = format!("on.{}.{}", self.step_name(association.step), id.index());
            let flag = self.truth(name);
            let step = association.step.index();
            let (is_on, moment) = match association.qualifier.trigger(Dialect::Sfc) {
                Trigger::Activation => (Expr::Place(self.entered[step]), Moment::After),
                Trigger::Deactivation => (Expr::Place(self.left[step]), Moment::Leaving),
                Trigger::Active | Trigger::Event => (self.is(association.step), Moment::After),
            };
            let condition = self.condition(association.condition.as_ref(), moment);
            body.push(Statement::Set(flag, all(vec![is_on, condition])));
            flags.push(flag);
        }
        (flags, body)
    }

    /// The function block of one target.
    pub(super) fn control(&mut self, target: &Target, flags: &[PlaceId]) -> Vec<Statement<'m>> {
        use Qualifier::{D, Ds, L, N, On, P, P0, P1, R, S, Sd, Sl};
        let mut body = Vec::new();
        let input = |lower: &Self, qualifier| lower.input(target, flags, qualifier);
        let reset = input(self, R);
        let mut terms = Vec::new();
        for qualifier in Qualifier::ALL {
            if !(self.has(target, qualifier) || qualifier == S && self.only_stored(target)) {
                continue;
            }
            let set = input(self, qualifier);
            let mut sets = yes();
            let holds = match qualifier {
                S => self.flip_flop(target, S, set, &reset, &mut body),
                L => {
                    let done = self.timer(target, flags, L, set.clone(), &mut body);
                    all(vec![set, not(done)])
                }
                D => self.timer(target, flags, D, set, &mut body),
                Sd => {
                    let stored = self.flip_flop(target, Sd, set, &reset, &mut body);
                    self.timer(target, flags, Sd, stored, &mut body)
                }
                Ds => {
                    sets = self.timer(target, flags, Ds, set, &mut body);
                    self.flip_flop(target, Ds, sets.clone(), &reset, &mut body)
                }
                Sl => {
                    let stored = self.flip_flop(target, Sl, set, &reset, &mut body);
                    let done = self.timer(target, flags, Sl, stored.clone(), &mut body);
                    all(vec![stored, not(done)])
                }
                N | P => set,
                // They have no part in Q, and R ends it.
                R | P1 | P0 | On => continue,
            };
            terms.push(Term { qualifier, holds, sets });
        }
        let holds = any(terms.iter().map(|term| term.holds.clone()).list());
        body.push(Statement::Set(target.q, all(vec![not(reset), holds])));
        self.who_acts(target, flags, &terms, &mut body);
        self.how_it_ends(target, flags, &terms, &mut body);
        body
    }

    fn has(&self, target: &Target, qualifier: Qualifier) -> bool {
        target.associations.iter().any(|id| self.model.associations[*id].qualifier == qualifier)
    }

    /// The associations of a target under a qualifier.
    pub(super) fn under(&self, target: &Target, qualifier: Qualifier) -> Vec<AssociationId> {
        let mut all = target.associations.clone();
        all.retain(|id| self.model.associations[*id].qualifier == qualifier);
        all
    }

    fn input(&self, target: &Target, flags: &[PlaceId], qualifier: Qualifier) -> Expr<'m> {
        any(self.under(target, qualifier).iter().map(|id| Expr::Place(flags[id.index()])).list())
    }

    /// A boolean that only S and R control starts with its initial value.
    fn only_stored(&self, target: &Target) -> bool {
        let stored = |id: &AssociationId| self.model.associations[*id].qualifier.sets_or_resets();
        matches!(target.what, What::Place(_)) && target.associations.iter().all(stored)
    }

    /// `RS`: reset-dominant.
    fn flip_flop(
        &mut self,
        target: &Target,
        qualifier: Qualifier,
        set: Expr<'m>,
        reset: &Expr<'m>,
        body: &mut Vec<Statement<'m>>,
    ) -> Expr<'m> {
        let initial = match target.what {
            What::Place(Place::Output(id)) if self.only_stored(target) => {
                self.places[self.outputs[id.index()].0].initial
            }
            What::Place(Place::Var(id)) if self.only_stored(target) => self.places[self.vars[id.index()].0].initial,
            _ => Initial::Value(Value::Bool(false)),
        };
        let role = Role::FlipFlop(target.associations[0], qualifier);
        let stored = self.field(format!("{qualifier:?}_FF.{}", target.name), role, Type::Bool, initial);
        let value = all(vec![not(reset.clone()), any(vec![set, Expr::Place(stored)])]);
        body.push(Statement::Set(stored, value));
        Expr::Place(stored)
    }

    /// Point 7: "An association acts in a cycle in which it alone would make Q true. Of several that act, the last in the source."
    fn who_acts(&mut self, target: &Target, flags: &[PlaceId], terms: &[Term<'m>], body: &mut Vec<Statement<'m>>) {
        let Some(acted) = target.acted else { return };
        let mut acting: Vec<(AssociationId, Expr<'m>)> = Vec::new();
        for term in terms {
            let under = self.under(target, term.qualifier);
            let by_flip_flop = term.qualifier.has_flip_flop();
            let setter = by_flip_flop.then(|| self.who_set(target, flags, term, &under, body));
            for id in under {
                let acts = if by_flip_flop {
                    let by = setter.flatten().map(|by| compare(Comparison::Equal, Expr::Place(by), number(id.index())));
                    all(by.into_iter().and([term.holds.clone()]).list())
                } else {
                    term.of(flags[id.index()])
                };
                acting.push((id, acts));
            }
        }
        sort_by_key(&mut acting, |(id, _)| *id);
        let mut notes = Vec::new();
        for (id, acts) in acting {
            when(&mut notes, acts, vec![Statement::Set(acted, number(id.index()))]);
        }
        when(body, Expr::Place(target.q), notes);
    }

    /// "A flip-flop is that of the association that set it last; DS is that of the one whose delay ran out."
    fn who_set(
        &mut self,
        target: &Target,
        flags: &[PlaceId],
        term: &Term<'m>,
        under: &[AssociationId],
        body: &mut Vec<Statement<'m>>,
    ) -> Option<PlaceId> {
        if under.len() < 2 {
            return None;
        }
        let role = Role::SetBy(target.associations[0], term.qualifier);
        let begin = Initial::Value(Value::Int(0));
        let name = format!("{:?}_FF.{}.by", term.qualifier, target.name);
        let by = self.field(name, role, Type::Number, begin);
        let mut notes = Vec::new();
        for id in under {
            when(&mut notes, Expr::Place(flags[id.index()]), vec![Statement::Set(by, number(id.index()))]);
        }
        when(body, term.sets.clone(), notes);
        Some(by)
    }

    /// Point 5: "final calls belong to the steps left if the end of N, L or D by leaving a step caused them".
    fn how_it_ends(&mut self, target: &Target, flags: &[PlaceId], terms: &[Term<'m>], body: &mut Vec<Statement<'m>>) {
        let (Some(was), Some(by_leaving)) = (target.was, target.by_leaving) else { return };
        let (mut causes, mut notes) = (Vec::new(), Vec::new());
        for term in terms {
            for id in self.under(target, term.qualifier) {
                let association = &self.model.associations[id];
                // What N, L and D hold up, they hold up as long as their step is active.
                if !association.qualifier.is_continuous() {
                    continue;
                }
                let name = format!("held.{}.{}", self.step_name(association.step), id.index());
                let off = Initial::Value(Value::Bool(false));
                let held = self.field(name, Role::Held(id), Type::Bool, off);
                // What D held up ends by leaving also where the step is entered again: its delay starts anew.
                let left = match term.qualifier {
                    Qualifier::D => Expr::Place(self.left[association.step.index()]),
                    _ => not(self.is(association.step)),
                };
                // What another step's association of the same qualifier holds up does not end by leaving, but by R.
                causes.push(all(vec![Expr::Place(held), left, not(term.holds.clone())]));
                let now = all(vec![Expr::Place(target.q), term.of(flags[id.index()])]);
                notes.push(Statement::Set(held, now));
            }
        }
        let fell = all(vec![Expr::Place(was), not(Expr::Place(target.q))]);
        body.push(Statement::Set(by_leaving, all(vec![fell, any(causes)])));
        body.push_all(notes);
    }
}

/// An output assigned after another qualifier than N is written, not assigned in the sense of A35.
pub(super) fn what(association: &Association) -> What {
    match &association.effect {
        Effect::Control(place) => What::Place(*place),
        Effect::Assign(place @ Place::Output(_), _) if association.qualifier == Qualifier::N => What::Place(*place),
        Effect::Call(action, _) => What::Action(*action),
        Effect::Assign(..) | Effect::Block(_) => What::Own,
    }
}
