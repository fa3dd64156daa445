//! Calls of one action by several associations of an `sfc`: one action control drives it, and of the associations that act the last in the source gives
//! the arguments.

use std::collections::BTreeMap;

use grafcet_compiler::model::{ActionId, Association, AssociationId, Effect, Qualifier};

use super::Flags;
use super::control::{Driven, Inputs};
use crate::Refused;
use crate::st::expr::{At, Kind, Moment, Scope, plain};
use crate::st::syntax::{Statement, Variable};
use crate::st::text::{Text, all, any, not, strength};

/// One of the associations.
struct Caller<'m> {
    association: &'m Association,
    /// What `…_by` says where it acts.
    number: usize,
    /// That its step and its condition ask for it, or its event.
    on: Text,
}

/// What is known of the action in a scan.
struct Called<'m> {
    action: ActionId,
    callers: Vec<Caller<'m>>,
    /// How its names begin.
    name: String,
    /// Which call it is.
    phase: String,
    /// Who acts, or has acted last.
    by: String,
    /// That something drives it, and that something did so in the scan before; none of an action that is called on events alone.
    runs: Option<[Text; 2]>,
    /// That the end of a step has ended it.
    by_leaving: Text,
}

impl<'m> Called<'m> {
    fn with(&self, wanted: Qualifier) -> impl DoubleEndedIterator<Item = &Caller<'m>> {
        self.callers.iter().filter(move |caller| caller.association.qualifier == wanted)
    }

    /// That one of these has its event.
    fn event(&self, qualifier: Qualifier) -> Text {
        any(self.with(qualifier).map(|caller| caller.on.clone()).collect())
    }

    fn driving(&self) -> impl DoubleEndedIterator<Item = &Caller<'m>> {
        self.callers.iter().filter(|caller| caller.association.qualifier.drives_q())
    }
}

impl<'m> Flags<'m> {
    /// The action that an association calls, and all that call it, where these are not calls of their own.
    pub(super) fn called_together(&self, association: &Association) -> Option<(ActionId, Vec<AssociationId>)> {
        let model = self.model;
        let Effect::Call(action, _) = association.effect else { return None };
        let calls = |one: &Association| matches!(one.effect, Effect::Call(called, _) if called == action);
        let all_of: Vec<AssociationId> =
            model.associations.iter().filter(|(_, one)| calls(one)).map(|(id, _)| id).collect();
        let known = |id: &AssociationId| &model.associations[*id];
        if all_of.len() == 1 {
            return (association.qualifier == Qualifier::R).then_some((action, all_of));
        }
        let kind = |id: &AssociationId| (known(id).step, known(id).qualifier);
        let is_own_moment = |(index, id): (usize, &AssociationId)| {
            matches!(known(id).qualifier, Qualifier::P1 | Qualifier::P0)
                && all_of[..index].iter().all(|other| kind(other) != kind(id))
        };
        (!self.single || !all_of.iter().enumerate().all(is_own_moment)).then_some((action, all_of))
    }

    /// What is asked before the first action runs, and the calls: with what ends, with what begins, and among the rest.
    pub(super) fn of_action(
        &mut self,
        action: ActionId,
        all_of: &[AssociationId],
        [left, entered, rest]: [&mut Vec<Statement>; 3],
    ) -> Result<(), Refused> {
        let called = self.known_callers(action, all_of)?;
        left.extend(self.leaving_calls(&called)?);
        entered.extend(self.entering_calls(&called)?);
        rest.extend(self.lasting_calls(&called)?);
        Ok(())
    }

    /// Who calls, whether anything drives the action, and who acts.
    fn known_callers(&mut self, action: ActionId, all_of: &[AssociationId]) -> Result<Called<'m>, Refused> {
        let model = self.model;
        let name = plain(&model.actions[action].name);
        let mut callers = Vec::new();
        for (index, id) in all_of.iter().enumerate() {
            let association = &model.associations[*id];
            let on = self.scope.names.own(&format!("{name}_{}", index + 1));
            let step = plain(&model.steps[association.step].name);
            let note = format!("{} of {step}", association.qualifier.word());
            self.frame.variables.push(Variable::new(&*on, "BOOL").note(note));
            let value = self.asking(association)?;
            self.conditions.push(Statement::assign(&*on, value.text));
            callers.push(Caller { association, number: index + 1, on: Text::word(on) });
        }
        let phase = self.scope.names.own(&format!("{name}_phase"));
        self.frame.variables.push(Variable::new(&*phase, "INT").note("0 first, 1 repeated, 2 final"));
        let by = self.scope.names.own(&format!("{name}_by"));
        self.frame.remember(Variable::new(&*by, "INT").init("0").note("whose call it is"));
        let nothing = Text::word("FALSE");
        let mut called = Called { action, callers, name, phase, by, runs: None, by_leaving: nothing };
        if called.driving().next().is_some() {
            self.drive(&mut called)?;
        }
        Ok(called)
    }

    /// The flag or the event of an association, as it is before the first action runs.
    fn asking(&mut self, association: &Association) -> Result<Text, Refused> {
        use Qualifier::{D, Ds, L, N, On, P, P0, P1, R, S, Sd, Sl};
        let (moment, event) = match association.qualifier {
            P0 => (Moment::Leaving, self.deactivated(association.step)),
            P1 => (Moment::Moved(Some(association.step)), self.activated(association.step)),
            P => return Ok(all(vec![self.input(association)?, self.activated(association.step)])),
            N | S | R | L | D | Sd | Ds | Sl | On => return self.input(association),
        };
        let Some(condition) = &association.condition else { return Ok(event) };
        let text = self.instant(moment, association.mark, |scope, at| scope.expr(condition, &Kind::Bool, at))?;
        Ok(all(vec![event, text]))
    }

    /// The action control, and whose calls these are.
    fn drive(&mut self, called: &mut Called<'m>) -> Result<(), Refused> {
        let mut inputs = Inputs::new();
        for caller in &called.callers {
            let qualifier = caller.association.qualifier;
            if !qualifier.runs_once() {
                inputs.entry(qualifier).or_default().push((caller.association, caller.on.clone()));
            }
        }
        let mut done = Vec::new();
        let reset = self.reset(&called.name, &mut inputs, &mut done);
        let mut driven = self.driven_by(&called.name, &inputs, reset.as_ref(), &mut done)?;
        for (qualifier, term) in &mut driven.terms {
            // Asked more than once; where nothing resets it, steps are asked themselves.
            let once = reset.is_none() && qualifier.drives_q_at_once();
            if term.strength != strength::WORD && !once {
                let flag = self.local(&format!("{}_{}_runs", called.name, qualifier.word()));
                let asked = std::mem::replace(term, Text::word(&*flag));
                done.push(Statement::assign(flag, asked.text));
            }
        }
        let runs = self.local(&format!("{}_runs", called.name));
        let ran = self.stored(&format!("{}_ran", called.name));
        let mut value = vec![any(driven.terms.values().cloned().collect())];
        value.extend(reset.as_ref().map(|reset| not(Text::word(&**reset))));
        done.push(Statement::assign(&*runs, all(value).text));
        let acts = self.acts(called, &driven, &mut done);
        // Without a reset one acts whenever it runs.
        done.push(if reset.is_some() { Statement::when(&*runs, vec![acts]) } else { acts });
        called.by_leaving = self.by_leaving(called, &runs, reset.is_some(), &driven.terms, &mut done);
        called.runs = Some([Text::word(runs), Text::word(ran)]);
        self.conditions.extend(done);
        Ok(())
    }

    /// The last in the source of those that alone would drive it.
    fn acts(&mut self, called: &Called<'m>, driven: &Driven, done: &mut Vec<Statement>) -> Statement {
        let mut branches = Vec::new();
        let setters = self.setters(called, driven, done);
        for caller in called.driving() {
            let qualifier = caller.association.qualifier;
            let term = driven.terms[&qualifier].clone();
            let acts = match setters.get(&qualifier) {
                Some(Some(by)) => vec![term, Text::order(format!("{by} = {}", caller.number))],
                Some(None) => vec![term],
                None if qualifier.drives_q_at_once() => vec![caller.on.clone()],
                None => vec![caller.on.clone(), term],
            };
            branches.push((all(acts).text, vec![Statement::assign(&*called.by, caller.number.to_string())]));
        }
        branches.reverse();
        Statement::If(branches, Vec::new())
    }

    /// Of each flip-flop the variable with the number of who has set it last, where it can be one of several.
    fn setters(
        &mut self,
        called: &Called<'m>,
        driven: &Driven,
        done: &mut Vec<Statement>,
    ) -> BTreeMap<Qualifier, Option<String>> {
        let mut setters = BTreeMap::new();
        for qualifier in Qualifier::ALL.into_iter().filter(|qualifier| qualifier.has_flip_flop()) {
            let with: Vec<&Caller<'_>> = called.with(qualifier).collect();
            if with.len() < 2 {
                setters.extend(with.first().map(|_| (qualifier, None)));
                continue;
            }
            let by = self.scope.names.own(&format!("{}_{}_set_by", called.name, qualifier.word()));
            self.frame.remember(Variable::new(&*by, "INT").init("0").note("who has set it last"));
            let set = |caller: &&Caller<'_>| {
                (caller.on.text.clone(), vec![Statement::assign(&*by, caller.number.to_string())])
            };
            let chosen = Statement::If(with.iter().rev().map(set).collect(), Vec::new());
            // DS sets its flip-flop when its delay is over.
            done.push(match &driven.delayed {
                Some(over) if qualifier.stores_when_time_is_over() => Statement::when(&*over.text, vec![chosen]),
                _ => chosen,
            });
            setters.insert(qualifier, Some(by));
        }
        setters
    }

    /// That what has held it up ends with its step.
    fn by_leaving(
        &mut self,
        called: &Called<'m>,
        runs: &str,
        reset: bool,
        terms: &BTreeMap<Qualifier, Text>,
        done: &mut Vec<Statement>,
    ) -> Text {
        use Qualifier::{D, L, N};
        let steps_alone =
            |caller: &Caller<'_>| caller.association.qualifier == N && caller.association.condition.is_none();
        if !reset && called.driving().all(steps_alone) {
            return Text::word("TRUE");
        }
        let (mut ways, mut holding) = (Vec::new(), Vec::new());
        for caller in called.driving() {
            let qualifier = caller.association.qualifier;
            if !matches!(qualifier, N | L | D) {
                continue;
            }
            let step = caller.association.step;
            let held = self.stored(&format!("{}_{}_held", called.name, caller.number));
            let left = if qualifier == D { self.deactivated(step) } else { not(self.flag(step)) };
            let mut way = vec![Text::word(&*held), left];
            // Beside R another step may go on asking.
            way.extend(reset.then(|| not(terms[&qualifier].clone())));
            ways.push(all(way));
            let term = if qualifier == N { None } else { Some(terms[&qualifier].clone()) };
            let now = all([Text::word(runs), caller.on.clone()].into_iter().chain(term).collect());
            holding.push(Statement::assign(held, now.text));
        }
        if ways.is_empty() {
            return Text::word("FALSE");
        }
        let flag = self.local(&format!("{}_left", called.name));
        done.push(Statement::assign(&*flag, any(ways).text));
        done.extend(holding);
        Text::word(flag)
    }

    /// P0, and the end with a step: together they are one call.
    fn leaving_calls(&mut self, called: &Called<'m>) -> Result<Vec<Statement>, Refused> {
        let fell = called.runs.as_ref().map(|[runs, ran]| all(vec![ran.clone(), not(runs.clone())]));
        let mut branches = Vec::new();
        if called.with(Qualifier::P0).next().is_some() {
            let told = |number: &str| vec![Statement::assign(&*called.phase, number)];
            let mut event = match &fell {
                Some(fell) => vec![Statement::If(vec![(fell.text.clone(), told("2"))], told("0"))],
                None => told("0"),
            };
            let who = called.with(Qualifier::P0).rev().map(|caller| (caller.on.text.clone(), caller)).collect();
            event.extend(self.call_of(called, who, Moment::Leaving)?);
            branches.push((called.event(Qualifier::P0).text, event));
        }
        if let Some(fell) = fell.filter(|_| called.by_leaving.text != "FALSE") {
            let mut last = vec![Statement::assign(&*called.phase, "2")];
            last.extend(self.call_by(called, Moment::Leaving)?);
            branches.push((all(vec![fell, called.by_leaving.clone()]).text, last));
        }
        Ok(if branches.is_empty() { Vec::new() } else { vec![Statement::If(branches, Vec::new())] })
    }

    /// P1, and what acts beside it.
    fn entering_calls(&mut self, called: &Called<'m>) -> Result<Vec<Statement>, Refused> {
        if called.with(Qualifier::P1).next().is_none() {
            return Ok(Vec::new());
        }
        let mut who = Vec::new();
        for caller in called.callers.iter().rev() {
            match (caller.association.qualifier, &called.runs) {
                (Qualifier::P1, _) => {
                    who.push((caller.on.text.clone(), caller));
                    if called.with(Qualifier::P1).count() == 1 {
                        break;
                    }
                }
                (qualifier, Some([runs, _])) if qualifier.drives_q() => {
                    let acts = Text::order(format!("{} = {}", called.by, caller.number));
                    who.push((all(vec![runs.clone(), acts]).text, caller));
                }
                _ => {}
            }
        }
        let mut first = vec![Statement::assign(&*called.phase, "0")];
        first.extend(self.call_of(called, who, Moment::Moved(None))?);
        Ok(vec![Statement::when(called.event(Qualifier::P1).text, first)])
    }

    /// As long as something drives it, and its end that is none of a step.
    fn lasting_calls(&mut self, called: &Called<'m>) -> Result<Vec<Statement>, Refused> {
        let Some([runs, ran]) = called.runs.clone() else { return Ok(Vec::new()) };
        let besides =
            |qualifier: Qualifier| called.with(qualifier).next().is_some().then(|| not(called.event(qualifier)));
        let told = |number: &str| vec![Statement::assign(&*called.phase, number)];
        let mut lasts = vec![Statement::If(vec![(ran.text.clone(), told("1"))], told("0"))];
        lasts.extend(self.call_by(called, Moment::Moved(None))?);
        let on = all([runs.clone()].into_iter().chain(besides(Qualifier::P1)).collect());
        let mut branches = vec![(on.text, lasts)];
        if called.by_leaving.text != "TRUE" {
            let mut last = told("2");
            last.extend(self.call_by(called, Moment::Moved(None))?);
            let mut ends = vec![ran.clone(), not(runs.clone())];
            ends.extend((called.by_leaving.text != "FALSE").then(|| not(called.by_leaving.clone())));
            ends.extend(besides(Qualifier::P0));
            branches.push((all(ends).text, last));
        }
        Ok(vec![Statement::If(branches, Vec::new()), Statement::assign(ran.text, runs.text)])
    }

    /// The call of who acts, or has acted last.
    fn call_by(&mut self, called: &Called<'m>, moment: Moment) -> Result<Vec<Statement>, Refused> {
        let who = called.driving().map(|caller| (format!("{} = {}", called.by, caller.number), caller)).collect();
        self.call_of(called, who, moment)
    }

    /// The call of the first of these that it is; one call where they are the same.
    fn call_of(
        &mut self,
        called: &Called<'m>,
        who: Vec<(String, &Caller<'m>)>,
        moment: Moment,
    ) -> Result<Vec<Statement>, Refused> {
        let mut branches = Vec::new();
        for (condition, caller) in who {
            let Effect::Call(_, arguments) = &caller.association.effect else { continue };
            let told = Variable::new("phase", "INT").note("0 first, 1 repeated, 2 final");
            let told = (format!("phase := {}", called.phase), told);
            let see = |scope: &mut Scope<'m>, at: &At<'_>| scope.call(called.action, arguments, told, at);
            branches.push((condition, vec![self.instant(moment, caller.association.mark, see)?]));
        }
        if branches.iter().all(|(_, call)| *call == branches[0].1) {
            return Ok(branches.swap_remove(0).1);
        }
        Ok(vec![Statement::If(branches, Vec::new())])
    }
}
