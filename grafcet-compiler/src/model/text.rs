//! What the model says in words: expressions, times, transitions as the user would write them.

use super::operands::{self, binds};
use super::{AnyId, Blink, Blinker, Model, Name, Read, Remembers, StepId, TimeRef, Transition, Tree};
use crate::list::List;

impl Model {
    /// An expression as the user would write it.
    #[must_use]
    pub fn tree_text(&self, tree: &Tree) -> String {
        operands::text(self, tree, binds::ALONE)
    }

    /// The same beside an operator.
    #[must_use]
    pub fn operand_text(&self, tree: &Tree) -> String {
        operands::text(self, tree, binds::UNARY)
    }

    /// What is read, as the user would write it.
    #[must_use]
    pub fn read_text(&self, read: Read) -> String {
        match read {
            Read::Name(name) => self.value_name(name).to_string(),
            Read::Active(step) => format!("{}.X", self.steps[step].name),
            Read::Since(step) => format!("{}.T", self.steps[step].name),
            Read::MacroActive(id) => format!("{}.X", self.macros[id].name),
            Read::MacroSince(id) => format!("{}.T", self.macros[id].name),
            Read::Rising(id) => format!("rising({})", self.edges[id].of.text),
            Read::Falling(id) => format!("falling({})", self.edges[id].of.text),
            Read::Delay(id) => {
                let delay = &self.delays[id];
                self.delay_text((delay.on, delay.off), &delay.of.text)
            }
            Read::Memory(id) => {
                let memory = &self.memories[id];
                match memory.kind {
                    Remembers::Rise => format!("rising({})", memory.of.text),
                    Remembers::Fall => format!("falling({})", memory.of.text),
                    Remembers::Delay(on, off) => self.delay_text((on, off), &memory.of.text),
                }
            }
            Read::Ticks(ticks) => self.time_text(i128::from(ticks)),
            Read::Elapsed(time, step) => format!("{}/{}", self.time_ref_text(time), self.steps[step].name),
            Read::MacroElapsed(time, id) => format!("{}/{}", self.time_ref_text(time), self.macros[id].name),
            Read::Blink(blink) => self.blink_text(blink),
        }
    }

    fn delay_text(&self, (on, off): (TimeRef, TimeRef), of: &str) -> String {
        let of = if of.contains(' ') { format!("({of})") } else { of.to_owned() };
        match off {
            TimeRef::Ticks(0) => format!("{}/{of}", self.time_ref_text(on)),
            off => format!("{}/{of}/{}", self.time_ref_text(on), self.time_ref_text(off)),
        }
    }

    /// `5s`, or the name of what holds the time.
    #[must_use]
    pub(crate) fn time_ref_text(&self, time: TimeRef) -> String {
        match time {
            TimeRef::Ticks(ticks) => self.time_text(i128::from(ticks)),
            TimeRef::Param(id) => self.value_name(Name::Param(id)).to_string(),
            TimeRef::Var(id) => self.value_name(Name::Var(id)).to_string(),
        }
    }

    /// A number of ticks as one writes a time: `5s`.
    #[must_use]
    pub fn time_text(&self, ticks: i128) -> String {
        const UNITS: [(&str, i128); 6] = [
            ("h", 3_600_000_000_000),
            ("m", 60_000_000_000),
            ("s", 1_000_000_000),
            ("ms", 1_000_000),
            ("us", 1_000),
            ("ns", 1),
        ];
        let nanos = ticks.saturating_mul(i128::from(self.clock_nanos));
        let unit = UNITS.iter().find(|(_, size)| nanos != 0 && nanos % size == 0);
        let (name, size) = unit.copied().unwrap_or(("s", 1_000_000_000));
        format!("{}{name}", nanos / size)
    }

    /// `blink(700ms/300ms, Step)`
    #[must_use]
    pub(crate) fn blink_text(&self, Blink { of, on, off }: Blink) -> String {
        let of = match of {
            Blinker::Step(step) => &self.steps[step].name,
            Blinker::Macro(id) => &self.macros[id].name,
        };
        let parts = if on == off {
            self.time_text(i128::from(on))
        } else {
            format!("{}/{}", self.time_text(i128::from(on)), self.time_text(i128::from(off)))
        };
        format!("blink({parts}, {of})")
    }

    /// `Mode::Auto`, where that is what a value is compared with.
    #[must_use]
    pub(crate) fn variant_text(&self, value: &Tree, other: &Tree) -> Option<String> {
        let (variants, Tree::Int(place)) = (self.variants_of_tree(value)?, other) else { return None };
        let ty = variants.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        Some(format!("{ty}::{}", variants.text(*place, *place)))
    }

    /// `any`, `any except (A, B)`
    #[must_use]
    pub fn any_text(&self, any: AnyId) -> String {
        match &self.anys[any].except[..] {
            [] => "any".to_owned(),
            [one] => format!("any except {one}"),
            several => {
                let names: Vec<_> = several.iter().map(ToString::to_string).list();
                format!("any except ({})", names.join(", "))
            }
        }
    }

    /// Several steps together: `A`, `(A, B)`, `()`.
    #[must_use]
    pub fn steps_text(&self, steps: &[StepId]) -> String {
        let names: Vec<String> = steps.iter().map(|step| self.steps[*step].name.to_string()).list();
        match &names[..] {
            [one] => one.clone(),
            _ => format!("({})", names.join(", ")),
        }
    }

    /// A transition in a sentence: `` `A → B` ``, or its name.
    #[must_use]
    pub fn transition_text(&self, transition: &Transition) -> String {
        let (from, to) = self.ends_text(transition);
        match &transition.name {
            Some(name) => format!("`{name}: {from} → {to}`"),
            None => format!("`{from} → {to}`"),
        }
    }

    /// From where it leads, and to where.
    pub(crate) fn ends_text(&self, transition: &Transition) -> (String, String) {
        let from = transition.any.map_or_else(|| self.steps_text(&transition.sources), |any| self.any_text(any));
        (from, self.steps_text(&transition.targets))
    }
}

#[cfg(test)]
mod tests {
    use crate::diagnostic::Sink;
    use crate::{model, parse};

    #[test]
    fn steps_and_ends_of_transitions() {
        let chart = "sfc C { input a: bool; initial step A; step B; step D; step E;
                     A -[a]-> (B, D); (B, D) -[!a]-> A; any except (A, E) -[a]-> E -[a]-> A; }";
        let mut sink = Sink::new();
        let chart = parse::chart(chart.parse().expect("tokens"), &mut sink).expect("a chart");
        let model = model::resolve(&chart, &mut sink);
        // What else is to be said of it is of no interest here.
        drop(sink.finish());
        let ends = |index: usize| model.ends_text(model.drawn_transitions().nth(index).expect("as many").1);
        let both = |from: &str, to: &str| (from.to_owned(), to.to_owned());
        assert_eq!(ends(0), both("any except (A, E)", "E"), "those of `any` come first");
        assert_eq!(ends(1), both("A", "(B, D)"));
        assert_eq!(ends(2), both("(B, D)", "A"));
        assert_eq!(model.steps_text(&[]), "()");
    }
}
