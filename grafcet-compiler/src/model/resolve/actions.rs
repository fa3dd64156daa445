//! Associations of steps with actions, and what stands after their qualifiers.

use proc_macro2::Ident;

use super::scope::Meaning;
use super::{Resolver, code, expr};
use crate::ast::{self, Target};
use crate::diagnostic::{Mark, rules};
use crate::list::List;
use crate::model::{Association, Effect, Mention, Name, Place, Qualifier, StepId};

/// The name of a target, or its whole block.
pub(super) fn mark_of(target: &Target) -> Mark {
    match target {
        Target::Name(name) | Target::Assign { name, .. } | Target::Call { name, .. } => name.into(),
        Target::Block(block) => Mark::of(block),
    }
}

impl Resolver<'_> {
    /// One line of a step's body.
    pub(super) fn association(&mut self, step: StepId, association: &ast::Association) {
        let qualifier = association.qualifier.map(|(qualifier, _)| qualifier);
        let time = association.time.as_ref().map(|time| self.time_arg(time, qualifier));
        let event = association.event.as_ref().map(|event| expr::resolve_condition(event, self));
        let condition = association.condition.as_ref().map(|condition| expr::resolve_condition(condition, self));
        if self.is_time_alone(association) {
            return self.lose();
        }
        let Some(effect) = self.effect(&association.target) else { return self.lose() };
        let id = self.model.associations.push(Association {
            step,
            qualifier: qualifier.unwrap_or(Qualifier::N),
            time,
            event,
            condition,
            effect,
            mark: association.mark,
            qualifier_mark: association.qualifier.map(|(_, span)| span.into()),
            target_mark: mark_of(&association.target),
        });
        self.model.steps[step].associations.push(id);
    }

    /// `L soak;`: that a time is missing in front of its target has been said, and what is there is the time.
    fn is_time_alone(&self, association: &ast::Association) -> bool {
        let Target::Name(name) = &association.target else { return false };
        let Some(Meaning::Value(Name::Param(id))) = self.scope.get(name) else { return false };
        let timed = association.qualifier.is_some_and(|(qualifier, _)| qualifier.has_time());
        timed && association.time.is_none() && self.model.is_time(Name::Param(id))
    }

    /// What an action does; a target that cannot be one is reported.
    pub(super) fn effect(&mut self, target: &Target) -> Option<Effect> {
        match target {
            Target::Name(name) => self.place(name, "output", "bool").map(Effect::Control),
            Target::Assign { name, value } => {
                if self.scope.get(name).is_none() {
                    self.refuse_target(name);
                }
                let value = expr::resolve(value, self);
                self.place(name, "var", "u16 = 0").map(|place| Effect::Assign(place, value))
            }
            Target::Call { name, args } => self.call(name, args),
            Target::Block(block) => Some(Effect::Block(code::resolve(block, self))),
        }
    }

    /// The output or variable `name`.
    fn place(&mut self, name: &Ident, wanted: &str, ty: &str) -> Option<Place> {
        let places = self.scope.all(name).filter_map(|meaning| match meaning {
            Meaning::Value(Name::Output(id)) => Some(Place::Output(id)),
            Meaning::Value(Name::Var(id)) => Some(Place::Var(id)),
            _ => None,
        });
        if let Some(place) = { places }.next() {
            let mention = match place {
                Place::Output(id) => Mention::Output(id),
                Place::Var(id) => Mention::Var(id),
            };
            self.model.mentions.push((mention, name.span()));
            return Some(place);
        }
        let message = match self.scope.get(name) {
            Some(Meaning::Value(Name::Output(_) | Name::Var(_))) => return None,
            Some(Meaning::Value(Name::Input(_) | Name::Param(_)) | Meaning::Let(_)) => {
                self.refuse_target(name);
                return None;
            }
            Some(Meaning::Action(id)) => {
                let params = self.model.actions[id].params.iter().map(|(p, _)| p.to_string()).list();
                format!("`{name}` is an action, which is called: `{name}({})`", params.join(", "))
            }
            Some(Meaning::Step(_) | Meaning::Macro(_)) => {
                format!("`{name}` is a step; an action writes an `output` or a `var`")
            }
            None => {
                let wanted = format!("{wanted} {name}: {ty};");
                self.scope.wish(name, &wanted);
                self.scope.unknown_name(name, &wanted, self.sink);
                return None;
            }
        };
        self.sink.rule(&rules::WRONG_TARGET, &[], vec![(name.into(), message)]);
        None
    }

    /// Reports that an action writes what is no output and no variable. Of a name that is not declared it takes note: who
    /// reports it asks for a variable.
    pub(super) fn refuse_target(&mut self, name: &Ident) {
        let what = match self.scope.get(name) {
            Some(Meaning::Value(Name::Input(_))) => "an input, which the plant writes",
            Some(Meaning::Value(Name::Param(_))) => "a param, which the recipe sets",
            Some(Meaning::Let(_)) => "a named condition, which nothing writes",
            None => return self.scope.wish(name, &format!("var {name}: u16 = 0;")),
            _ => return,
        };
        let message = format!("`{name}` is {what}; an action writes an `output` or a `var`");
        self.sink.rule(&rules::WRONG_TARGET, &[], vec![(name.into(), message)]);
    }

    fn call(&mut self, name: &Ident, args: &[syn::Expr]) -> Option<Effect> {
        let written = args;
        let qualified =
            matches!(self.scope.get(name), Some(Meaning::Value(_))) && called_with_qualifier(args).is_some();
        let args = if qualified { &[] } else { args };
        let args: Vec<_> = args.iter().map(|arg| (Mark::of(arg), expr::resolve(arg, self))).list();
        let action = match self.scope.get(name) {
            Some(Meaning::Action(action)) => {
                self.model.mentions.push((Mention::Action(action), name.span()));
                action
            }
            Some(Meaning::Value(Name::Output(_))) if qualified => {
                let word = called_with_qualifier(written).unwrap_or_default();
                let message = format!("a qualifier stands in front of what it acts on: `{word} {name};`");
                self.sink.rule(&rules::WRONG_TARGET, &[], vec![(name.into(), message)]);
                return None;
            }
            Some(other) => {
                let message = format!(
                    "`{name}` is {}, which cannot be called; declare an `action` under another name",
                    other.kind()
                );
                self.sink.rule(&rules::WRONG_TARGET, &[], vec![(name.into(), message)]);
                return None;
            }
            None if crate::parse::is_qualifier(&name.to_string()) => {
                let target = written.first().map_or_else(|| "q".to_owned(), super::text::of);
                let message = format!("a qualifier stands in front of what it acts on: `{name} {target};`");
                self.sink.rule(&rules::WRONG_TARGET, &[], vec![(name.into(), message)]);
                return None;
            }
            None => {
                self.scope.unknown_name(name, &format!("action {name}();"), self.sink);
                return None;
            }
        };
        let wanted = self.model.actions[action].params.len();
        if args.len() != wanted {
            let message = format!(
                "action `{name}` takes {wanted} argument{}, {} given",
                if wanted == 1 { "" } else { "s" },
                if args.len() == 1 { "1 is".to_owned() } else { format!("{} are", args.len()) },
            );
            let mark = args.iter().fold(Mark::from(name), |mark, (arg, _)| mark.to(*arg));
            self.sink.notation(mark, message);
            return None;
        }
        Some(Effect::Call(action, args.into_iter().map(|(_, arg)| arg).list()))
    }
}

/// `lamp(N)`, as IEC 61131-3 writes an association.
fn called_with_qualifier(args: &[syn::Expr]) -> Option<String> {
    let first = expr::single_name(args.first()?)?.to_string();
    crate::parse::is_qualifier(&first).then_some(first)
}
