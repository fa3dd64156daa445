//! What the plant excludes, and what the checker shall prove.

use proc_macro2::{Ident, Span};

use super::expr::Seen;
use super::scope::Meaning;
use super::{Resolver, expr, remembered};
use crate::ast;
use crate::diagnostic::Mark;
use crate::model::{Assumption, Claim, Expr, LetId, Name, Order, Property, Read, StepId};

/// What a condition of an assumption is about.
#[derive(Clone, Copy)]
struct About {
    why: &'static str,
    /// It may read them.
    params: bool,
    /// What to do about a step.
    of_steps: &'static str,
}

const IN_ONE: About = About {
    why: "an assumption is about the inputs of one cycle",
    params: true,
    of_steps: "; what the chart shall never do is a property: `never …;` without `assume`",
};
const OFTEN: About = About { params: false, ..IN_ONE };
const AFTER: About = About {
    why: "what comes after is the machine's doing, a condition over inputs",
    params: false,
    of_steps: "; what the chart does after something else is a property, without `assume`",
};

impl Resolver<'_> {
    /// `assume never b1 && b3;` It is about one snapshot of the inputs and the recipe: nothing else can be excluded by the plant, and
    /// nothing else is there when the program asks whether the assumptions hold.
    pub(super) fn assumption(&mut self, keyword: Span, condition: &syn::Expr) {
        let never = self.assumed(condition, IN_ONE);
        let mark = Mark::from(keyword).to(never.mark);
        self.model.assumptions.push(Assumption { never, mark, of_range: None });
    }

    /// `assume valve leads_to full within 10s;` `assume lower before bottom;` What comes first may be the chart's doing, what comes after is the plant's.
    pub(super) fn order(&mut self, keyword: Span, order: &ast::Property) {
        let (claim, end) = match order {
            ast::Property::LeadsTo { from, to, within, .. } => {
                let (from, to) = (self.side(from), self.assumed(to, AFTER));
                let end = within.as_ref().map_or(to.mark, |within| within.span.into());
                if let Some(at_once) = within.as_ref().filter(|within| within.nanos == 0) {
                    let message = format!(
                        "nothing is answered in the cycle in which it is asked; what never comes together is \
                         `assume never {} && !({});`",
                        from.text, to.text
                    );
                    self.sink.notation(at_once.span, message);
                }
                let within = within.as_ref().map(|within| self.ticks(within));
                (Claim::LeadsTo { from, to, within }, end)
            }
            ast::Property::Before { first, then, .. } => {
                let (first, then) = (self.side(first), self.assumed(then, AFTER));
                let end = then.mark;
                (Claim::Before { first, then }, end)
            }
            _ => return,
        };
        self.model.orders.push(Order { claim, mark: Mark::from(keyword).to(end) });
    }

    /// `assume often door_closed;` It is about snapshots of the inputs, too.
    pub(super) fn recurrence(&mut self, condition: &syn::Expr) {
        let often = self.assumed(condition, OFTEN);
        self.model.often.push(often);
    }

    /// `assume cycle within 100ms;`
    pub(super) fn cycle_time(&mut self, keyword: Span, longest: &ast::Time) {
        if longest.nanos > 0 && self.is_first("assume cycle", Mark::from(keyword).to(longest.span)) {
            self.model.longest_cycle = Some(self.ticks(longest));
        }
    }

    fn assumed(&mut self, condition: &syn::Expr, about: About) -> Expr {
        let (condition, places) = expr::resolve_with_places(condition, self);
        let About { why, params, of_steps } = about;
        for Seen { read, mark, within } in places {
            let this = self.subject(within);
            let name = |resolver: &Self, name| {
                let by = within.map(|id| format!(", which `{}` stands for,", resolver.model.lets[id].name));
                format!("`{}`{}", resolver.model.value_name(name), by.unwrap_or_default())
            };
            let what = match read {
                Read::Name(Name::Input(_)) | Read::Ticks(_) => continue,
                Read::Name(Name::Param(_)) if params => continue,
                Read::Active(_) | Read::MacroActive(_) => {
                    self.sink.notation(mark, format!("{why}, and {this} a step{of_steps}"));
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
                | Read::Memory(_)
                | Read::Blink(_) => format!("{this} a time"),
            };
            self.sink.notation(mark, format!("{why}, and {what}"));
        }
        condition
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
            ast::Property::LeadsTo { attrs, from, to, within, .. } => {
                let (from, to) = (self.side(from), self.side(to));
                let begin = from.mark;
                let end = within.as_ref().map_or(to.mark, |within| within.span.into());
                let claim = self.leads_to(from, to, within.as_ref());
                return self.claims(attrs, claim, begin.to(end));
            }
            ast::Property::Before { attrs, first, then, .. } => {
                let (first, then) = (self.side(first), self.side(then));
                let mark = first.mark.to(then.mark);
                return self.claims(attrs, Claim::Before { first, then }, mark);
            }
        };
        self.claims(attrs, claim, Mark::from(*keyword).to(end));
    }

    fn claims(&mut self, attrs: &ast::Attrs, claim: Claim, mark: Mark) {
        self.model.properties.push(Property { claim, levels: attrs.levels.clone(), mark });
    }

    /// What has to come at once holds at the end of the same cycle.
    fn leads_to(&mut self, from: Expr, to: Expr, within: Option<&ast::Time>) -> Claim {
        match within.map(|time| if time.nanos == 0 { 0 } else { self.ticks(time) }) {
            Some(0) => Claim::Always { premise: Some(from), condition: to },
            within => Claim::LeadsTo { from, to, within },
        }
    }

    /// A side of `leads_to` or `before`: a step alone stands for its activity, as no value can be meant.
    fn side(&mut self, condition: &syn::Expr) -> Expr {
        let name = match condition {
            syn::Expr::Path(path) if path.qself.is_none() => path.path.get_ident(),
            _ => None,
        };
        let step = |meaning: Meaning| matches!(meaning, Meaning::Step(_) | Meaning::Macro(_));
        match name.filter(|name| self.scope.get(name).is_some_and(step)) {
            Some(name) => {
                let active = syn::ExprField {
                    attrs: Vec::new(),
                    base: Box::new(condition.clone()),
                    dot_token: syn::Token![.](name.span()),
                    member: Ident::new("X", name.span()).into(),
                };
                self.claimed(&syn::Expr::Field(active))
            }
            None => {
                if name.is_some_and(|name| self.scope.is_misspelt_step(name, self.sink)) {
                    self.lose();
                }
                self.claimed(condition)
            }
        }
    }

    /// A condition of a property: about the ends of cycles. Its edges and delays are none of the chart's, which would remember them.
    fn claimed(&mut self, condition: &syn::Expr) -> Expr {
        let of_chart = self.take_sampled();
        let condition = expr::resolve_condition(condition, self);
        let own = self.sampled_again(of_chart);
        remembered::Remembering { own: &own, model: &mut self.model }.expr(&condition)
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
