//! A plan as scripts, as a Rust test, and as a page for whoever stands beside the machine.

use std::fmt::Write as _;

use grafcet_compiler::model::{Model, Name, Ty};
use grafcet_sim::{Beside, Cycle, Kind, Names, Signal, Value, happened, script_line};

use super::plan::Plan;
use super::program;
use super::search::Node;

/// What a suite is worth before somebody has read it.
const MARK: &str = "from the chart, to be confirmed by a person";

/// One script for each sequence: before each cycle a comment with what is expected of it.
pub(crate) fn scripts(plan: &Plan<'_>, beside: &Beside<'_>) -> Vec<String> {
    let names = beside.chart().names();
    let all = plan.sequences.len();
    let script = |(number, sequence): (usize, &Vec<Node<'_>>)| {
        let mut text = format!(
            "# {}, sequence {} of {all}. What is expected stands in front of each cycle: {MARK}.\n",
            names.chart,
            number + 1
        );
        let mut clock = 0;
        for (node, cycle) in cycles(sequence) {
            _ = writeln!(text, "# {}", expected(names, cycle).join(" | "));
            if node.now != clock {
                _ = write!(text, "@{} ", node.now);
                clock = node.now;
            }
            text += &script_line(beside.signals(), &node.values);
            text.push('\n');
        }
        text
    };
    plan.sequences.iter().enumerate().map(script).collect()
}

/// Steps, outputs, and what happened.
fn expected(names: &Names, cycle: &Cycle) -> [String; 3] {
    let steps: Vec<&str> = cycle.steps.iter().map(|step| names.steps[*step].name.as_str()).collect();
    let outputs = script_line(&names.outputs, &cycle.outputs);
    let or_none = |text: String| if text.is_empty() { "-".to_owned() } else { text };
    [or_none(steps.join(" ")), outputs, or_none(happened(names, cycle).join(", "))]
}

fn cycles<'n, 'c>(sequence: &'n [Node<'c>]) -> impl Iterator<Item = (&'n Node<'c>, &'n Cycle)> {
    sequence.iter().filter_map(|node| Some((node, node.cycle.as_ref()?)))
}

/// A page to tick off.
pub(crate) fn protocol(plan: &Plan<'_>, beside: &Beside<'_>) -> String {
    let names = beside.chart().names();
    let cell = |text: &str| text.replace('|', "\\|");
    let mut page = format!("# Protocol: {}\n\nWhat is expected is {MARK}.\n\n", names.chart);
    page += "| machine | version of the program | date | name | signature |\n| --- | --- | --- | --- | --- |\n| | | | | |\n";
    for (number, sequence) in plan.sequences.iter().enumerate() {
        _ = writeln!(page, "\n## Sequence {}\n\nSwitch on, or initialise.\n", number + 1);
        page += "| | cycle | time | set | active steps | outputs | what happens | remarks |\n";
        page += "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
        for (number, (node, cycle)) in cycles(sequence).enumerate() {
            let [steps, outputs, happens] = expected(names, cycle).map(|text| cell(&text));
            let (time, set) = (names.time(node.now.into()), cell(&script_line(beside.signals(), &node.values)));
            _ = writeln!(page, "| ☐ | {} | {time} | {set} | {steps} | {outputs} | {happens} | |", number + 1);
        }
    }
    if !plan.open.is_empty() {
        page += "\n## Not shown\n\n";
        for (goal, why) in &plan.open {
            _ = writeln!(page, "- {}: {why}", goal.text(names));
        }
    }
    if !plan.never.is_empty() {
        page += "\n## Cannot be, as is proved\n\n";
        for goal in &plan.never {
            _ = writeln!(page, "- {}", goal.text(names));
        }
    }
    page
}

/// A file with a test for each sequence, which finds the chart's types under a path.
///
/// # Errors
/// What of the chart has no place in such a test.
pub(crate) fn rust(plan: &Plan<'_>, beside: &Beside<'_>, path: &str) -> Result<String, String> {
    let (chart, model) = (beside.chart(), beside.chart().model());
    let names = chart.names();
    if let Some(block) = chart.blocks().first() {
        return Err(format!("what `{block}` writes is not known"));
    }
    if let Some(step) = names.steps.iter().find(|step| step.name.contains("::")) {
        return Err(format!("several steps are called `{}`", step.name.rsplit("::").next().unwrap_or_default()));
    }
    let name = &model.name;
    let mut types = vec![format!("{name}"), format!("{name}Inputs"), format!("{name}Step")];
    let mut calls = String::new();
    if !model.actions.is_empty() {
        types.push(format!("{name}Actions"));
        calls = actions(model);
    }
    let mut text = format!("//! Written by `cargo grafcet tests`: {MARK}.\n\n");
    text += "#![allow(clippy::pedantic, reason = \"written by a program\")]\n\n";
    types.sort();
    let phase = if calls.is_empty() { "" } else { ", Phase" };
    _ = writeln!(text, "use grafcet::{{Chart as _{phase}, Ticks}};\n\nuse {path}::{{{}}};", types.join(", "));
    text += &calls;
    text += &program::stub(&model.name.to_string(), &beside.signals()[beside.inputs()..]);
    for (number, sequence) in plan.sequences.iter().enumerate() {
        _ = write!(text, "\n#[test]\nfn sequence_{}() {{\n    let mut chart = {name}::new();\n", number + 1);
        for (cycle, (node, shown)) in cycles(sequence).enumerate() {
            text += &checked(beside, (cycle, node, shown))?;
        }
        text += "}\n";
    }
    Ok(text)
}

/// One cycle in a test.
fn checked(beside: &Beside<'_>, (number, node, shown): (usize, &Node<'_>, &Cycle)) -> Result<String, String> {
    let (model, names) = (beside.chart().model(), beside.chart().names());
    let name = &model.name;
    let mut inputs = Vec::new();
    for (id, (signal, value)) in model.inputs.ids().zip(names.inputs.iter().zip(&node.values)) {
        inputs.push(format!("{}: {}", model.inputs[id].name, literal(model, Name::Input(id), signal, value)?));
    }
    let steps = shown.steps.iter().map(|step| format!("{name}Step::{}", model.steps.values().as_slice()[*step].name));
    let steps: Vec<String> = steps.collect();
    let inputs = if inputs.is_empty() { String::new() } else { format!(" {} ", inputs.join(", ")) };
    let calls = if model.actions.is_empty() { "()" } else { "calls" };
    let mut text = format!("\n    // Cycle {number}: {}\n", expected(names, shown)[2]);
    _ = writeln!(text, "    let inputs = {name}Inputs {{{inputs}}};");
    let outputs = if names.outputs.is_empty() { "_" } else { "outputs" };
    text += &program::told(&beside.signals()[beside.inputs()..], &node.values[beside.inputs()..]);
    if !model.actions.is_empty() {
        text += "    let mut calls = Calls::default();\n";
    }
    _ = writeln!(text, "    let {outputs} = chart.scan(&inputs, Ticks::new({}), &mut {calls});", node.now);
    _ = writeln!(
        text,
        "    assert!(chart.is_exactly(&[{}]), \"cycle {number}: {{:?}}\", chart.situation());",
        steps.join(", ")
    );
    for (id, (signal, value)) in model.outputs.ids().zip(names.outputs.iter().zip(&shown.outputs)) {
        let output = &model.outputs[id].name;
        _ = match value {
            Value::Bool(true) => writeln!(text, "    assert!(outputs.{output}, \"cycle {number}: {output}\");"),
            Value::Bool(false) => writeln!(text, "    assert!(!outputs.{output}, \"cycle {number}: {output}\");"),
            value => {
                let value = literal(model, Name::Output(id), signal, value)?;
                writeln!(text, "    assert_eq!(outputs.{output}, {value}, \"cycle {number}: {output}\");")
            }
        };
    }
    if !model.actions.is_empty() {
        let called = called(model, shown);
        _ = writeln!(text, "    assert_eq!(calls.0.join(\"; \"), \"{called}\", \"cycle {number}\");");
    }
    Ok(text)
}

/// A value in Rust.
fn literal(model: &Model, name: Name, signal: &Signal, value: &Value) -> Result<String, String> {
    let unknown = || format!("`{}` has no value that Rust can be told here", signal.name);
    match (&signal.kind, value) {
        (Kind::Bool | Kind::Int { .. }, value) => Ok(value.to_string()),
        (Kind::Float(_), Value::Float(value)) => Ok(format!("{value:?}")),
        (Kind::Time, Value::Ticks(ticks)) => Ok(format!("Ticks::new({ticks})")),
        (Kind::Listed(..), Value::Name(variant)) => {
            let listed = model.variants_of(name).ok_or_else(unknown)?;
            let path = &listed.path;
            Ok(format!("{}::{variant}", quote::quote!(#path).to_string().replace(' ', "")))
        }
        _ => Err(unknown()),
    }
}

/// Code actions that write down their calls.
fn actions(model: &Model) -> String {
    let mut text = "\n#[derive(Default)]\nstruct Calls(Vec<String>);\n".to_owned();
    _ = writeln!(text, "\nimpl {}Actions for Calls {{", model.name);
    for action in model.actions.values() {
        let shown = action.params.iter().map(|(name, ty)| match ty {
            Ty::Time(_) => (format!(", {name}: Ticks"), format!("{name}.get()")),
            Ty::Bool(rust) | Ty::Int { rust, .. } => (format!(", {name}: {}", quote::quote!(#rust)), name.to_string()),
            // What it can be shown as, nobody knows here.
            Ty::Other(rust) => (format!(", _: {}", quote::quote!(#rust)), "\"_\"".to_owned()),
        });
        let (params, shown): (Vec<String>, Vec<String>) = shown.unzip();
        let (name, params) = (&action.name, params.concat());
        let call = format!("{{phase:?}} {name}({})", vec!["{}"; shown.len()].join(", "));
        let args: Vec<String> = [format!("{call:?}")].into_iter().chain(shown).collect();
        _ = writeln!(text, "    fn {name}(&mut self, phase: Phase{params}) {{");
        _ = writeln!(
            text,
            "        self.0.push(format!({}));
    }}",
            args.join(", ")
        );
    }
    text + "}\n"
}

/// What they have written down after a cycle.
fn called(model: &Model, cycle: &Cycle) -> String {
    let call = |call: &grafcet_sim::Call| {
        let action =
            model.actions.values().find(|action| action.name.to_string().trim_start_matches("r#") == call.action);
        let types = action.iter().flat_map(|action| &action.params).map(|(_, ty)| ty);
        let args = types.zip(&call.args).map(|(ty, value)| match ty {
            Ty::Other(_) => "_".to_owned(),
            _ => value.to_string(),
        });
        format!("{:?} {}({})", call.phase, call.action, args.collect::<Vec<_>>().join(", "))
    };
    cycle.calls.iter().map(call).collect::<Vec<_>>().join("; ")
}
