//! Actions of places: what is true or has a value while something holds, and what is set and reset.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Association, Effect, Model, Place, Qualifier, TimeRef, VarId};

use super::Flags;
use crate::Refused;
use crate::st::action::{Role, Written, assigned, places, role};
use crate::st::expr::At;
use crate::st::frame;
use crate::st::syntax::{Statement, Variable};
use crate::st::text::{Text, all, any, not};
use crate::st::time::LONGEST;

/// What has no translation.
pub(super) fn refused(model: &Model, written: &BTreeMap<Place, Written>, refused: &mut Vec<Refused>) {
    for (place, how) in written {
        let by_control = how.continuous || !model.is_grafcet() && how.set_or_reset;
        let name = model.place_name(*place);
        if by_control && how.otherwise {
            refused.push(Refused::at(
                name.into(),
                format!("`{name}` is controlled and assigned, too: structured text of this form can do one of both"),
            ));
        }
        let all = controls(model, *place);
        let assigns = all.iter().filter(|association| matches!(association.effect, Effect::Assign(..))).count();
        if assigns > 0 && assigns < all.len() && how.continuous {
            refused.push(Refused::at(
                name.into(),
                format!("`{name}` is asserted and has values, too: structured text of this form can do one of both"),
            ));
        }
    }
}

/// The associations that control a place.
pub(super) fn controls(model: &Model, place: Place) -> Vec<&Association> {
    let is = |association: &&Association| matches!(role(model, association), Ok(Role::Continuous(at) | Role::Set(at) | Role::Reset(at)) if at == place);
    model.associations.values().filter(is).collect()
}

impl Flags<'_> {
    /// The statements that give a place its value in this scan.
    pub(super) fn control(&mut self, place: Place) -> Result<Vec<Statement>, Refused> {
        let all = controls(self.model, place);
        if all.iter().any(|association| matches!(association.effect, Effect::Assign(..))) {
            return self.values(place, &all);
        }
        let asserts = |association: &&Association| matches!(role(self.model, association), Ok(Role::Continuous(_)));
        if self.model.is_grafcet() && all.iter().all(asserts) {
            self.asserted(place, &all)
        } else {
            let name = self.scope.place(place).to_owned();
            self.controlled(name, &all)
        }
    }

    /// `N speed = e`: the last one in the source counts.
    fn values(&mut self, place: Place, all_of: &[&Association]) -> Result<Vec<Statement>, Refused> {
        let (mut branches, nothing) = (Vec::new(), BTreeMap::new());
        for association in all_of.iter().rev() {
            let Effect::Assign(_, value) = &association.effect else { continue };
            let mut parts = vec![self.held(association)?];
            parts.extend(self.limit(association)?);
            let stable = self.model.is_grafcet();
            let value = self.after(association, |scope, at| {
                let before = if stable { &nothing } else { at.before };
                assigned(scope, place, value, &At { before, ..*at })
            })?;
            branches.push((all(parts).text, vec![Statement::assign(self.scope.place(place), value)]));
        }
        let initial = frame::initial(&mut self.scope, place.into())?;
        Ok(vec![Statement::If(branches, vec![Statement::assign(self.scope.place(place), initial)])])
    }

    /// In a `grafcet` L and D are conditions over the time of the step.
    fn limit(&mut self, association: &Association) -> Result<Option<Text>, Refused> {
        let Some(time) = association.time else { return Ok(None) };
        let limit = self.scope.time(time, association.mark)?;
        let timer = self.scope.timer(association.step);
        let sign = if association.qualifier.limits() { "<" } else { ">=" };
        Ok(Some(Text::order(format!("{timer}.ET {sign} {limit}"))))
    }

    /// `grafcet`: on the situation that has been reached.
    fn asserted(&mut self, place: Place, all_of: &[&Association]) -> Result<Vec<Statement>, Refused> {
        let mut parts = Vec::new();
        for association in all_of {
            let mut part = vec![self.input(association)?];
            part.extend(self.limit(association)?);
            parts.push(all(part));
        }
        Ok(vec![Statement::assign(self.scope.place(place), any(parts).text)])
    }

    /// `sfc`: the standard's `ACTION_CONTROL`, of which only what is needed is there.
    pub(super) fn controlled(&mut self, name: String, all_of: &[&Association]) -> Result<Vec<Statement>, Refused> {
        let mut inputs = self.inputs(all_of)?;
        let mut done = Vec::new();
        let reset = self.reset(&name, &mut inputs, &mut done);
        // Where nothing else drives it, the place is its flip-flop.
        if inputs.keys().all(|qualifier| *qualifier == Qualifier::S) {
            let set = inputs.remove(&Qualifier::S).map_or(Text::word("FALSE"), |inputs| one_of(&inputs));
            done.push(flip_flop(&name, set, reset.as_ref()));
            return Ok(done);
        }
        let mut value =
            vec![any(self.driven_by(&name, &inputs, reset.as_ref(), &mut done)?.terms.into_values().collect())];
        value.extend(reset.map(|reset| not(Text::word(reset))));
        done.push(Statement::assign(name, all(value).text));
        Ok(done)
    }

    /// That something resets it, for which several can ask.
    pub(super) fn reset(&mut self, name: &str, inputs: &mut Inputs<'_>, done: &mut Vec<Statement>) -> Option<String> {
        inputs.remove(&Qualifier::R).map(|reset| {
            let flag = self.local(&format!("{name}_R"));
            done.push(Statement::assign(&*flag, one_of(&reset).text));
            flag
        })
    }

    /// By what it is driven: for each qualifier, when that is so.
    pub(super) fn driven_by(
        &mut self,
        name: &str,
        inputs: &Inputs<'_>,
        reset: Option<&String>,
        done: &mut Vec<Statement>,
    ) -> Result<Driven, Refused> {
        use Qualifier::{D, Ds, L, N, On, P, P0, P1, R, S, Sd, Sl};
        let (mut terms, mut delayed) = (BTreeMap::new(), None);
        let mut inputs: Vec<_> = inputs.iter().collect();
        // DS stands last, as in text that has been exported before.
        inputs.sort_by_key(|(qualifier, _)| qualifier.stores_when_time_is_over());
        for (&qualifier, all_of) in inputs {
            let input = one_of(all_of);
            let term = match qualifier {
                S => {
                    let stored = self.stored(&format!("{name}_S"));
                    done.push(flip_flop(&stored, input, reset));
                    Text::word(stored)
                }
                L => {
                    let flag = self.local(&format!("{name}_L_on"));
                    done.push(Statement::assign(&*flag, input.text));
                    let over = self.timer((name, L), &Text::word(&*flag), all_of, done)?;
                    all(vec![Text::word(flag), not(over)])
                }
                D => self.timer((name, D), &input, all_of, done)?,
                Sd | Sl => {
                    let stored = self.stored(&format!("{name}_{}", qualifier.word()));
                    done.push(flip_flop(&stored, input, reset));
                    let over = self.timer((name, qualifier), &Text::word(&*stored), all_of, done)?;
                    if qualifier == Sd { over } else { all(vec![Text::word(stored), not(over)]) }
                }
                Ds => {
                    let over = self.timer((name, Ds), &input, all_of, done)?;
                    let stored = self.stored(&format!("{name}_DS"));
                    done.push(flip_flop(&stored, over.clone(), reset));
                    delayed = Some(over);
                    Text::word(stored)
                }
                N | P => input,
                // Nothing is driven by them.
                R | P1 | P0 | On => continue,
            };
            terms.insert(qualifier, term);
        }
        Ok(Driven { terms, delayed })
    }

    /// The inputs of an action control.
    pub(super) fn inputs<'a>(&mut self, all_of: &[&'a Association]) -> Result<Inputs<'a>, Refused> {
        let mut by = Inputs::new();
        for association in all_of {
            let mut input = vec![self.held(association)?];
            // A pulse is an event.
            if association.qualifier == Qualifier::P {
                input.push(self.activated(association.step));
            }
            by.entry(association.qualifier).or_default().push((association, all(input)));
        }
        Ok(by)
    }

    /// The flag of an association; a condition that reads what actions write is read before the first of them.
    pub(super) fn held(&mut self, association: &Association) -> Result<Text, Refused> {
        let input = self.input(association)?;
        let read = association.condition.iter().flat_map(|condition| places(&condition.tree));
        let changes = read.into_iter().any(|place| self.changed.contains(&place));
        Ok(if changes { self.hoisted(input, association) } else { input })
    }

    /// A flip-flop of its own.
    pub(super) fn stored(&mut self, wanted: &str) -> String {
        let name = self.scope.names.own(wanted);
        self.frame.remember(Variable::new(&*name, "BOOL").init("FALSE"));
        name
    }

    /// A value of this scan alone.
    pub(super) fn local(&mut self, wanted: &str) -> String {
        let name = self.scope.names.own(wanted);
        self.frame.variables.push(Variable::new(&*name, "BOOL"));
        name
    }

    /// TON of a qualifier; its steps start it anew where they are entered anew, but for what a flip-flop keeps.
    fn timer(
        &mut self,
        (name, qualifier): (&str, Qualifier),
        input: &Text,
        all_of: &[(&Association, Text)],
        done: &mut Vec<Statement>,
    ) -> Result<Text, Refused> {
        let timer = self.scope.names.own(&format!("{name}_{}_T", qualifier.word()));
        self.frame.timer(&timer, &format!("{} of {name}", qualifier.word()));
        if qualifier.restarts_with_step() {
            let mut again = Vec::new();
            for (association, own) in all_of {
                if self.may_reenter(association.step) {
                    let condition = association.condition.is_some().then(|| own.clone());
                    again.push(all([self.again(association.step)].into_iter().chain(condition).collect()));
                }
            }
            if !again.is_empty() {
                done.push(Statement::when(
                    any(again).text,
                    vec![Statement::Call(format!("{timer}(IN := FALSE, PT := {LONGEST})"))],
                ));
            }
        }
        done.push(Statement::Call(format!("{timer}(IN := {}, PT := {LONGEST})", input.text)));
        let limit = self.limit_of((name, qualifier), all_of, done)?;
        Ok(all(vec![input.clone(), Text::order(format!("{timer}.ET >= {limit}"))]))
    }

    /// The time of the association that was active last, the last in the source of several.
    fn limit_of(
        &mut self,
        (name, qualifier): (&str, Qualifier),
        all_of: &[(&Association, Text)],
        done: &mut Vec<Statement>,
    ) -> Result<String, Refused> {
        let mut limits = Vec::new();
        for (association, own) in all_of {
            let limit = match association.time {
                Some(TimeRef::Var(id)) if self.changed.contains(&Place::Var(id)) => self.kept(id),
                Some(time) => self.scope.time(time, association.mark)?,
                None => LONGEST.to_owned(),
            };
            limits.push((own.text.clone(), limit));
        }
        let same = limits.iter().all(|(_, limit)| *limit == limits[0].1);
        if same {
            return Ok(limits.swap_remove(0).1);
        }
        let chosen = self.scope.names.own(&format!("{name}_{}_PT", qualifier.word()));
        let note = "that of the step that asked last";
        // What a flip-flop keeps goes on with the time of who has set it, which may change meanwhile.
        let keeps = qualifier.times_its_flip_flop();
        let literal = all_of.iter().all(|(association, _)| matches!(association.time, Some(TimeRef::Ticks(_))));
        if keeps {
            let init = if literal { &limits[0].1 } else { LONGEST };
            self.frame.remember(Variable::new(&*chosen, "TIME").init(init).note(note));
        } else {
            self.frame.variables.push(Variable::new(&*chosen, "TIME").note(note));
        }
        if !keeps || literal {
            let choose = |(own, limit): (String, String)| (own, vec![Statement::assign(&*chosen, limit)]);
            done.push(Statement::If(limits.into_iter().rev().map(choose).collect(), Vec::new()));
            return Ok(chosen);
        }
        let by = self.scope.names.own(&format!("{name}_{}_by", qualifier.word()));
        self.frame.remember(Variable::new(&*by, "INT").init("0").note("who asked last"));
        let (mut who, mut which) = (Vec::new(), Vec::new());
        for (number, (own, limit)) in limits.into_iter().enumerate() {
            who.push((own, vec![Statement::assign(&*by, number.to_string())]));
            which.push((format!("{by} = {number}"), vec![Statement::assign(&*chosen, limit)]));
        }
        who.reverse();
        done.extend([Statement::If(who, Vec::new()), Statement::If(which, Vec::new())]);
        Ok(chosen)
    }

    /// A time as it was before the first action.
    fn kept(&mut self, id: VarId) -> String {
        let name = self.scope.names.own(&format!("{}_before", self.scope.place(Place::Var(id))));
        self.frame.variables.push(Variable::new(&*name, "TIME"));
        self.conditions.push(Statement::assign(&*name, self.scope.place(Place::Var(id))));
        name
    }
}

/// Of each qualifier the associations that have it, and when each of them asks.
pub(super) type Inputs<'a> = BTreeMap<Qualifier, Vec<(&'a Association, Text)>>;

/// What drives an action.
pub(super) struct Driven {
    /// By qualifier.
    pub(super) terms: BTreeMap<Qualifier, Text>,
    /// That the delay of DS is over, which sets its flip-flop.
    pub(super) delayed: Option<Text>,
}

fn one_of(inputs: &[(&Association, Text)]) -> Text {
    any(inputs.iter().map(|(_, input)| input.clone()).collect())
}

/// Reset dominates.
fn flip_flop(name: &str, set: Text, reset: Option<&String>) -> Statement {
    let mut value = vec![any(vec![Text::word(name), set])];
    value.extend(reset.map(|reset| not(Text::word(&**reset))));
    Statement::assign(name, all(value).text)
}
