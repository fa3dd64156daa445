//! What the plant excludes, and what the checker shall prove.

use proc_macro2::{Ident, Span};

use super::expr::Seen;
use super::scope::Meaning;
use super::{Resolver, expr};
use crate::ast;
use crate::diagnostic::Mark;
use crate::model::{Assumption, Claim, Expr, LetId, Name, Property, Read, StepId};

impl Resolver<'_> {
    /// `assume never b1 && b3;` It is about one snapshot of the inputs: nothing else can be excluded by the plant, and
    /// nothing else is there when the program asks whether the assumptions hold.
    pub(super) fn assumption(&mut self, keyword: Span, condition: &syn::Expr) {
        let (never, places) = expr::resolve_with_places(condition, self);
        let why = "an assumption is about the inputs of one cycle";
        for Seen { read, mark, within } in places {
            let this = self.subject(within);
            let name = |resolver: &Self, name| {
                let by = within.map(|id| format!(", which `{}` stands for,", resolver.model.lets[id].name));
                format!("`{}`{}", resolver.model.value_name(name), by.unwrap_or_default())
            };
            let what = match read {
                Read::Name(Name::Input(_)) | Read::Ticks(_) => continue,
                Read::Active(_) | Read::MacroActive(_) => {
                    let message = format!(
                        "{why}, and {this} a step; what the chart shall never do is a property: `never …;` without `assume`"
                    );
                    self.sink.notation(mark, message);
                    continue;
                }
                Read::Rising(_) | Read::Falling(_) => {
                    "an edge takes two; exclude the inputs together, without `rising` or `falling`".to_owned()
                }
                Read::Name(value @ Name::Output(_)) => format!("{} is an output", name(self, value)),
                Read::Name(value @ Name::Var(_)) => format!("{} is a variable", name(self, value)),
                Read::Name(value @ Name::Param(_)) => format!("{} is a param", name(self, value)),
                Read::Since(_)
                | Read::MacroSince(_)
                | Read::Delay(_)
                | Read::Elapsed(..)
                | Read::MacroElapsed(..)
                | Read::Blink(_) => format!("{this} a time"),
            };
            self.sink.notation(mark, format!("{why}, and {what}"));
        }
        let mark = Mark::from(keyword).to(never.mark);
        self.model.assumptions.push(Assumption { never, mark });
    }

    /// `never …;` `always …;` `home …;`
    pub(super) fn property(&mut self, property: &ast::Property) {
        let (attrs, keyword, claim, end) = match property {
            ast::Property::Never { attrs, keyword, condition } => {
                let condition = self.claimed(condition);
                let end = condition.mark;
                (attrs, keyword, Claim::Never(condition), end)
            }
            ast::Property::Always { attrs, keyword, premise, condition } => {
                let premise = premise.as_ref().map(|premise| self.claimed(premise));
                let condition = self.claimed(condition);
                let end = condition.mark;
                (attrs, keyword, Claim::Always { premise, condition }, end)
            }
            ast::Property::Home { attrs, keyword, steps } => {
                let Some((first, last)) = steps.first().zip(steps.last()) else { return };
                let mark = Mark::from(first).to(last);
                (attrs, keyword, Claim::Home(self.home(steps), mark), mark)
            }
        };
        let mark = Mark::from(*keyword).to(end);
        self.model.properties.push(Property { claim, levels: attrs.levels.clone(), mark });
    }

    /// A condition of a property: what can be seen at the end of a cycle.
    fn claimed(&mut self, condition: &syn::Expr) -> Expr {
        let (condition, places) = expr::resolve_with_places(condition, self);
        let why = "a property is about the end of a cycle";
        for Seen { read, mark, within } in places {
            let this = self.subject(within);
            let what = match read {
                Read::Rising(_) | Read::Falling(_) => "an edge takes two; name what holds at the end of one".to_owned(),
                Read::Delay(_) | Read::Blink(_) => {
                    format!(
                        "{this} a time with a memory of its own; name the step or output that matters, or a step's time"
                    )
                }
                Read::Name(_)
                | Read::Active(_)
                | Read::Since(_)
                | Read::Elapsed(..)
                | Read::MacroActive(_)
                | Read::MacroSince(_)
                | Read::MacroElapsed(..)
                | Read::Ticks(_) => continue,
            };
            self.sink.notation(mark, format!("{why}; {what}"));
        }
        condition
    }

    /// Who a sentence about something that is read speaks of.
    fn subject(&self, within: Option<LetId>) -> String {
        within.map_or_else(|| "this is".to_owned(), |id| format!("`{}` asks for", self.model.lets[id].name))
    }

    fn home(&mut self, names: &[Ident]) -> Vec<StepId> {
        let mut steps = Vec::new();
        for name in names {
            self.mention(name);
            match self.scope.step(name, self.sink) {
                Some(Meaning::Step(step)) => match names.iter().find(|first| *first == name) {
                    Some(first) if steps.contains(&step) => self.repeated_step(first, name),
                    _ => steps.push(step),
                },
                Some(_) => {
                    let message = format!("`{name}` is a macro-step; name the step of its expansion that is meant");
                    self.sink.notation(name, message);
                    self.lose();
                }
                None => self.lose(),
            }
        }
        steps
    }
}
