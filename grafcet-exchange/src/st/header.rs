//! What a program says of itself.

use grafcet_compiler::model::Model;

use super::Order;
use super::expr::{Scope, plain};
use super::memory::is_of_inputs;

pub(super) fn case(model: &Model, scope: &Scope<'_>, order: Order) -> Vec<String> {
    if order == Order::EvolveFirst {
        let mut lines = begin(model, "a CASE for the transitions and one for the actions of the active step");
        lines.push("Evolve, then act: in each scan the transitions of the active step come first, then the actions of the step that has been reached.".to_owned());
        evolved(model, scope, &mut lines);
        end(model, scope, &mut lines);
        return lines;
    }
    let mut lines = begin(model, "one CASE for the active step");
    lines.extend([
        "Act, then evolve: in each scan the active step acts first, its transitions come last. So what differs from the chart is:".to_owned(),
        "- what a step does shows one scan later; in the scan in which a step is left its continuous actions are off".to_owned(),
        "- actions read the inputs of that later scan".to_owned(),
    ]);
    if model.is_grafcet() {
        lines.push("- one transition a scan: a step that the chart only passes lasts for a scan, and its continuous actions show".to_owned());
    } else {
        lines.push("- the first scan looks at transitions already".to_owned());
    }
    end(model, scope, &mut lines);
    lines
}

pub(super) fn flags(model: &Model, scope: &Scope<'_>) -> Vec<String> {
    let mut lines = begin(model, "a flip-flop for each step");
    lines.push("Evolve, then act: the transitions are evaluated on the situation of the scan before, then the steps are set and reset, then the actions follow.".to_owned());
    if !model.forces.is_empty() || model.partials.values().any(|partial| partial.enclosed_by.is_some()) {
        lines.push("Partial grafcets stand from the top of the hierarchy to its bottom: an order, and an enclosing step that is entered or left, puts what is below it into its situation in the same scan, and nothing clears there.".to_owned());
    }
    evolved(model, scope, &mut lines);
    end(model, scope, &mut lines);
    lines
}

/// What differs where the evolution comes first.
fn evolved(model: &Model, scope: &Scope<'_>, lines: &mut Vec<String>) {
    if model.is_grafcet() {
        lines.push("What differs from the chart: one evolution a scan. A step that the chart only passes lasts for a scan, and its continuous actions show.".to_owned());
        lines.push("The first scan only enters the initial steps.".to_owned());
        if scope.delays.keys().any(|id| !is_of_inputs(model, *id)) {
            lines.push("A delay of what the chart itself changes is looked at in the scans that begin with what the scan before has left as it was: a step that the chart only passes does not interrupt it.".to_owned());
        }
    } else {
        lines.push("Each scan does what a cycle of the chart does.".to_owned());
    }
}

fn begin(model: &Model, form: &str) -> Vec<String> {
    let dialect = if model.is_grafcet() { "grafcet" } else { "sfc" };
    vec![format!(
        "The chart `{}` ({dialect}) as structured text (IEC 61131-3): {form}. Written by cargo grafcet.",
        plain(&model.name)
    )]
}

fn end(model: &Model, scope: &Scope<'_>, lines: &mut Vec<String>) {
    if !scope.timers.is_empty() || !scope.macro_timers.is_empty() {
        lines.push(
            "The timers of steps are called twice in a scan: to read them, and to begin with the step.".to_owned(),
        );
    }
    if scope.blinks {
        lines.push(
            "What blinks stands still where its step is active for more than 24 days: so far a TON counts.".to_owned(),
        );
    }
    if scope.tells_times {
        lines.push("The time of a step that is stored or told ends at 24 days: so far a TON counts.".to_owned());
    }
    if scope.adds_times {
        lines.push("Sums of times end at the longest time, which in the chart is a time of so many ticks and here of so many milliseconds.".to_owned());
    }
    own_names(scope, lines);
    if let Some(late) = supervised(model) {
        lines.push(left_out(&late));
    }
}

/// What has another name than in the chart, and what is to be written.
pub(crate) fn own_names(scope: &Scope<'_>, lines: &mut Vec<String>) {
    for (chart, name) in &scope.names.renamed {
        lines.push(format!("Renamed: `{chart}` of the chart is {name}."));
    }
    for stub in &scope.stubs {
        lines.push(format!("To be written by you: {}, in Rust `{}`.", stub.name, stub.rust));
    }
}

/// The steps with a `within`, if there are any: `Fill, Heat`.
pub(crate) fn supervised(model: &Model) -> Option<String> {
    let late: Vec<String> =
        model.steps.values().filter(|step| step.late.is_some()).map(|step| plain(&step.name)).collect();
    (!late.is_empty()).then(|| late.join(", "))
}

/// What is said of them.
pub(crate) fn left_out(late: &str) -> String {
    format!("Left out: `within` of {late}; where a condition asks whether one is late, it is there.")
}
