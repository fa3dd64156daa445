//! Which steps force which partial grafcets.

use super::{Force, Model, PartialId, StepId};

impl Model {
    /// The orders that a step gives, in source order.
    pub(crate) fn orders_of(&self, step: StepId) -> impl Iterator<Item = &Force> {
        self.steps[step].forces.iter().map(|id| &self.forces[*id])
    }

    /// The orders on a partial grafcet, in source order.
    #[must_use]
    pub fn orders_on(&self, partial: PartialId) -> impl DoubleEndedIterator<Item = &Force> {
        self.partials[partial].forced_by.iter().map(|id| &self.forces[*id])
    }
}

#[cfg(test)]
mod tests {
    use crate::diagnostic::Sink;
    use crate::list::List;
    use crate::model::{self, Force};
    use crate::parse;

    #[test]
    fn orders_by_who_gives_them_and_by_whom_they_force() {
        let chart = "grafcet C {
            input a: bool;
            partial Over {
                initial step Run; step Stop { force Left {}; force Right {INIT}; } step Pause { force Left {*}; }
                Run -[a]-> Stop -[!a]-> Pause -[a]-> Run;
            }
            partial Left { initial step L1; step L2; L1 -[a]-> L2 -[a]-> L1; }
            partial Right { initial step R1; step R2; R1 -[a]-> R2 -[a]-> R1; }
        }";
        let mut sink = Sink::new();
        let chart = parse::chart(chart.parse().expect("tokens"), &mut sink).expect("a chart");
        let model = model::resolve(&chart, &mut sink);
        let target = |force: &Force| model.partials[force.target].name.as_ref().map(ToString::to_string);
        for (step, said) in model.steps.iter() {
            let all = model.orders_of(step).filter_map(target).collect::<Vec<_>>().join(" ");
            let expected = if said.name == "Stop" {
                "Left Right"
            } else if said.name == "Pause" {
                "Left"
            } else {
                ""
            };
            assert_eq!(all, expected, "{}", said.name);
        }
        for (partial, said) in model.partials.iter() {
            let all = model.orders_on(partial).map(|force| model.steps[force.step].name.to_string()).list().join(" ");
            let expected = match said.name.as_ref().map(ToString::to_string).as_deref() {
                Some("Left") => "Stop Pause",
                Some("Right") => "Stop",
                _ => "",
            };
            assert_eq!(all, expected, "{:?}", said.name);
        }
    }
}
