//! Times: literals counted in the chart's clock unit, names of type `time`.

use proc_macro2::Ident;
use syn::Lit;

use super::Resolver;
use super::expr::{single_name, time_name};
use super::scope::Meaning;
use crate::ast;
use crate::diagnostic::{Mark, rules};
use crate::model::{Name, Qualifier, TimeRef};
use crate::parse::time_literal;

/// The default unit of the time argument of `cycle`.
pub(super) const MILLISECOND: u64 = 1_000_000;

const HOUR: u64 = 3_600_000_000_000;

impl Resolver<'_> {
    /// The ticks of a literal with a unit of time; anything else is `None`. One that cannot be counted is reported.
    pub(super) fn literal_time(&mut self, lit: &Lit) -> Option<u32> {
        let time = match time_literal(lit)? {
            Ok(time) => time,
            Err(error) => {
                self.sink.rule(&rules::BAD_TIME, &[], vec![(lit.span().into(), error.clone())]);
                return Some(0);
            }
        };
        Some(self.ticks(&time))
    }

    /// A duration in ticks; one that the clock cannot count is reported.
    pub(super) fn ticks(&mut self, time: &ast::Time) -> u32 {
        let clock = self.model.clock_nanos.max(1);
        let message = match u32::try_from(time.nanos / clock) {
            _ if time.nanos % clock != 0 => {
                let finer = [1_000_000_000, MILLISECOND, 1_000].into_iter();
                let finer = finer.clone().find(|unit| clock % unit == 0 && time.nanos % unit == 0);
                let mend =
                    finer.map_or(String::new(), |finer| format!(", or state a finer one: `clock {};`", unit(finer)));
                format!("this time is finer than the chart's clock of {}; round it{mend}", unit(clock))
            }
            Ok(ticks) => return ticks,
            Err(_) => {
                self.longer_than_clock(time.span.into(), time.nanos, "time");
                return 0;
            }
        };
        self.sink.rule(&rules::BAD_TIME, &[], vec![(time.span.into(), message)]);
        0
    }

    /// A sum of times that the clock cannot count, in ticks; `what` is too long.
    pub(super) fn too_long(&mut self, mark: Mark, ticks: u64, what: &str) {
        let clock = self.model.clock_nanos.max(1);
        self.longer_than_clock(mark, ticks.saturating_mul(clock), what);
    }

    fn longer_than_clock(&mut self, mark: Mark, nanos: u64, what: &str) {
        let clock = self.model.clock_nanos.max(1);
        let longest = u64::from(u32::MAX).saturating_mul(clock) / HOUR;
        let mend = [10 * MILLISECOND, 100 * MILLISECOND, 1_000_000_000, 60_000_000_000, HOUR]
            .into_iter()
            .find(|unit| u32::try_from(nanos / unit).is_ok());
        let mend = mend.map_or(String::new(), |coarser| format!(": `clock {};`", unit(coarser)));
        let message = format!(
            "the chart's clock of {} counts up to {longest}h, this {what} is longer; state a coarser one{mend}",
            unit(clock)
        );
        self.sink.rule(&rules::BAD_TIME, &[], vec![(mark, message)]);
    }

    /// A bare number, or a text, where a time stands.
    pub(super) fn no_unit(&mut self, number: &syn::Expr) {
        let text = super::text::of(number);
        let message = if text.starts_with('"') {
            "a time is written without quotes, as in `5s`".to_owned()
        } else {
            format!("`{text}` has no unit of time; the units are h, m, s, ms and us, as in `{text}s`")
        };
        self.sink.rule(&rules::BAD_TIME, &[], vec![(Mark::of(number), message)]);
    }

    /// The time an expression is: a literal with a unit or a name of type `time`.
    pub(super) fn time_of(&mut self, expr: &syn::Expr) -> Option<TimeRef> {
        match expr {
            syn::Expr::Lit(lit) => self.literal_time(&lit.lit).map(TimeRef::Ticks),
            syn::Expr::Paren(paren) => self.time_of(&paren.expr),
            other => match self.scope.get(&single_name(other)?)? {
                Meaning::Value(value) => time_name(value, self),
                _ => None,
            },
        }
    }

    /// The time after a qualifier.
    pub(super) fn time_arg(&mut self, time: &ast::TimeArg, qualifier: Option<Qualifier>) -> TimeRef {
        match time {
            ast::TimeArg::Literal(time) if time.nanos == 0 && qualifier.is_some_and(Qualifier::limits) => {
                let message = "limited to no time at all, this action never shows; write the time it may last";
                self.sink.rule(&rules::BAD_TIME, &[], vec![(time.span.into(), message.to_owned())]);
                TimeRef::Ticks(0)
            }
            ast::TimeArg::Literal(time) => TimeRef::Ticks(self.ticks(time)),
            ast::TimeArg::Name(name) => {
                let found = match self.scope.get(name) {
                    Some(Meaning::Value(value)) => time_name(value, self),
                    Some(_) => None,
                    None => {
                        self.scope.unknown_name(name, &format!("param {name}: time = 5s;"), self.sink);
                        return TimeRef::Ticks(0);
                    }
                };
                found.unwrap_or_else(|| {
                    self.not_waited_for(name, None);
                    TimeRef::Ticks(0)
                })
            }
        }
    }

    /// Reports a name that a chart cannot wait for, in front of `/step` or after a qualifier.
    pub(super) fn not_waited_for(&mut self, name: &Ident, step: Option<&str>) {
        let message = match self.scope.get(name) {
            Some(meaning @ Meaning::Value(value @ (Name::Input(_) | Name::Output(_)))) if self.model.is_time(value) => {
                let mend = step.map_or_else(String::new, |step| format!("; write `{step}.T >= {name}`"));
                let kind = meaning.kind();
                format!(
                    "`{name}` is {kind}, and what is waited for is a literal, a `param` or a `var` of type `time`{mend}"
                )
            }
            _ => format!("`{name}` is not a time; declare it `param {name}: time = 5s;` or write a literal"),
        };
        self.sink.rule(&rules::BAD_TIME, &[], vec![(Mark::from(name), message)]);
    }
}

/// A clock unit as the user would write it.
fn unit(nanos: u64) -> String {
    let units =
        [("h", HOUR), ("m", 60_000_000_000), ("s", 1_000_000_000), ("ms", MILLISECOND), ("us", 1_000), ("ns", 1)];
    let (name, size) = units.into_iter().find(|(_, size)| nanos % size == 0).unwrap_or(("ns", 1));
    format!("{}{name}", nanos / size)
}
