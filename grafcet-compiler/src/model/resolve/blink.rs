//! `blink(500ms)`, `blink(700ms/300ms, Step)`.

use proc_macro2::Ident;
use syn::BinOp;

use super::expr::{Lower, literal, step_path};
use super::scope::Meaning;
use crate::diagnostic::{Mark, rules};
use crate::list::List;
use crate::model::{Blink, Blinker, Read, TimeRef, Tree};

/// To which step an expression belongs: since its activation a `blink` counts that names none.
#[derive(Clone)]
pub(super) enum Owner {
    /// The whole chart, as with a property.
    Chart,
    /// A transition without a step in front of it.
    Sourceless,
    /// A step's actions, or a transition that leaves it.
    One(Blinker),
    /// A transition that leaves whatever is active.
    Any,
    /// A transition that leaves several.
    Several(Ident),
}

impl Lower<'_, '_> {
    /// The call of `blink` that `expr` is.
    pub(super) fn blink(&mut self, expr: &mut syn::Expr) -> Tree {
        let syn::Expr::Call(call) = &*expr else { return self.opaque(expr) };
        let blink = match &*call.args.iter().list() {
            [parts] => self.parts(parts).zip(self.owner(parts, Mark::of(call))),
            [parts, step] => self.parts(parts).zip(self.blinker(step, parts)),
            _ => {
                let message = "`blink` takes one time or two, and the step if it is another one: `blink(500ms)`, \
                               `blink(700ms/300ms)`, `blink(500ms, Step)`";
                self.resolver.sink.notation(Mark::of(call), message);
                None
            }
        };
        match blink {
            Some(((on, off), of)) => self.replace(expr, Read::Blink(Blink { of, on, off })),
            None => Tree::Bool(true),
        }
    }

    /// How long it is true, and how long false.
    fn parts(&mut self, parts: &syn::Expr) -> Option<(u32, u32)> {
        match parts {
            syn::Expr::Group(group) => self.parts(&group.expr),
            syn::Expr::Paren(paren) => self.parts(&paren.expr),
            syn::Expr::Binary(both) if matches!(both.op, BinOp::Div(_)) => {
                if let Some(Meaning::Step(_) | Meaning::Macro(_)) = self.meaning(&both.right) {
                    let (time, step) = (super::text::of(&both.left), super::text::of(&both.right));
                    let message = format!("the step of a `blink` stands after a comma: `blink({time}, {step})`");
                    self.resolver.sink.notation(Mark::of(parts), message);
                    return None;
                }
                let (on, off) = (self.part(&both.left), self.part(&both.right));
                let (on, off) = (on?, off?);
                if on.checked_add(off).is_none() {
                    self.resolver.too_long(Mark::of(parts), u64::from(on) + u64::from(off), "period");
                    return None;
                }
                Some((on, off))
            }
            one => {
                let part = self.part(one)?;
                if part.checked_mul(2).is_none() {
                    self.resolver.too_long(Mark::of(parts), 2 * u64::from(part), "period, twice this time,");
                    return None;
                }
                Some((part, part))
            }
        }
    }

    /// One part of a period, in ticks.
    fn part(&mut self, part: &syn::Expr) -> Option<u32> {
        let before = self.resolver.sink.count();
        let message = match self.resolver.time_of(part) {
            _ if self.resolver.sink.count() > before => return None,
            Some(TimeRef::Ticks(0)) => {
                "a part of no time at all never shows; write how long it lasts, as in `blink(500ms)`".to_owned()
            }
            Some(TimeRef::Ticks(ticks)) => return Some(ticks),
            Some(TimeRef::Param(_) | TimeRef::Var(_)) => format!(
                "`{}` can be exchanged while something blinks, and the times of a `blink` are literals; for these times draw two \
                 steps, `On -[t_on/On]-> Off -[t_off/Off]-> On`",
                super::text::of(part)
            ),
            None => {
                if let syn::Expr::Lit(lit) = part {
                    if matches!(literal(&lit.lit), Some(Tree::Int(_))) {
                        self.resolver.no_unit(part);
                        return None;
                    }
                }
                "this is no time; a `blink` takes literals, as in `blink(500ms)` and `blink(700ms/300ms)`".to_owned()
            }
        };
        self.resolver.sink.rule(&rules::BAD_TIME, &[], vec![(Mark::of(part), message)]);
        None
    }

    /// The step that a `blink` names.
    fn blinker(&mut self, step: &syn::Expr, parts: &syn::Expr) -> Option<Blinker> {
        let message = match (step, step_path(step)) {
            (syn::Expr::Group(group), _) => return self.blinker(&group.expr, parts),
            (syn::Expr::Field(field), _) if step_path(&field.base).is_some() => {
                let (parts, step) = (super::text::of(parts), super::text::of(&field.base));
                format!("a `blink` names the step itself: `blink({parts}, {step})`")
            }
            (_, Some(path)) => match self.step(&path)? {
                Meaning::Step(step) => return Some(Blinker::Step(step)),
                Meaning::Macro(id) => return Some(Blinker::Macro(id)),
                other => {
                    let name = super::text::of(step);
                    format!("`{name}` is {}, not a step; a `blink` counts from the activation of a step", other.kind())
                }
            },
            _ if self.resolver.time_of(step).is_some() => {
                let (on, off) = (super::text::of(parts), super::text::of(step));
                format!("the two parts of a period stand with a `/` between them: `blink({on}/{off})`")
            }
            _ => "after the times of a `blink` stands a step: `blink(500ms, Step)`".to_owned(),
        };
        self.resolver.sink.notation(Mark::of(step), message);
        None
    }

    /// The step to which the expression belongs.
    fn owner(&mut self, parts: &syn::Expr, call: Mark) -> Option<Blinker> {
        let parts = super::text::of(parts);
        let message = match &self.resolver.owner {
            Owner::One(blinker) => return Some(*blinker),
            Owner::Chart => format!(
                "a `blink` counts from the activation of a step, and this belongs to none; name one: `blink({parts}, Step)`"
            ),
            Owner::Sourceless => format!(
                "a `blink` counts from the activation of a step, and none stands in front of this transition; name one: \
                 `blink({parts}, Step)`"
            ),
            Owner::Any => format!(
                "a `blink` counts from the activation of a step, and `any` stands for all of them; name one: `blink({parts}, Step)`"
            ),
            Owner::Several(first) => format!(
                "a `blink` counts from the activation of a step, and this transition leaves several; name one: \
                 `blink({parts}, {first})`"
            ),
        };
        self.resolver.sink.notation(call, message);
        None
    }

    fn meaning(&self, expr: &syn::Expr) -> Option<Meaning> {
        self.resolver.scope.get(&super::expr::single_name(expr)?)
    }
}
