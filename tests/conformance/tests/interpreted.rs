//! The conformance corpus against the interpreter.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::PathBuf;

use grafcet_compiler::check;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model, Ty};
use grafcet_compiler::parse;
use grafcet_conformance::fragments;
use grafcet_conformance::reader::{self, Expected, Kind, Line};
use grafcet_sim::interp::{Call, Interpreter, Nothing, Phase, Situation, Value};

/// Every file of the corpus, and all differences at once.
#[test]
fn every_chart_behaves_as_worked_out_by_hand() {
    let files = files();
    let mut failures = String::new();
    for path in &files {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = std::fs::read_to_string(path).expect("a corpus file can be read");
        if let Err(error) = run(&text) {
            let _ = writeln!(failures, "{name}: {error}");
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}

/// Each decision that a running chart can show has a file with its name, and so has each qualifier.
#[test]
fn every_decision_and_qualifier_has_a_file() {
    let names: Vec<String> =
        files().iter().map(|path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned()).collect();
    // A7, A8, A14, A16 are only ever seen as errors; they have compile-fail tests.
    let decisions = (1..=39).filter(|n| ![7, 8, 14, 16].contains(n)).map(|n| format!("a{n:02}"));
    let qualifiers = ["n", "s", "r", "l", "d", "p", "sd", "ds", "sl", "p1", "p0"].map(|q| format!("q_{q}_"));
    for prefix in decisions.chain(qualifiers) {
        assert!(names.iter().any(|name| name.starts_with(&prefix)), "no file for {prefix}");
    }
}

fn files() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(env!("CARGO_MANIFEST_DIR")).expect("the corpus is there");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("a folder entry").path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "chart"));
    files.sort();
    files
}

fn run(text: &str) -> Result<(), String> {
    let case = reader::read(text)?;
    let model = resolve(&case.chart)?;
    let mut machine = Interpreter::new(&model).map_err(|error| error.to_string())?;
    let names = model.params.values().map(|p| p.name.to_string());
    let mut params: BTreeMap<String, i128> = names.zip(machine.params().iter().copied().map(number)).collect();
    for Line { number, kind } in &case.lines {
        let found = match kind {
            Kind::Init => machine.init().map(|()| None),
            // How long one may sleep, and which situations a chart can be in, is no question for an interpreter.
            Kind::Wakes(_) | Kind::Refuses(_) => Ok(None),
            Kind::Params(changed) => {
                params.extend(changed.clone());
                let declared = model.params.values().map(|p| (p.name.to_string(), &p.ty));
                machine.set_params(&values(declared, &params)?).map(|()| None)
            }
            Kind::Shows(expected) => {
                Ok(Some((shown(&model, &machine, machine.situation(), machine.outputs()), expected)))
            }
            Kind::Cycle { inputs, now, expected } | Kind::Force { inputs, now, expected, .. } => {
                let declared = model.inputs.values().map(|i| (i.name.to_string(), &i.ty));
                let inputs = values(declared, inputs)?;
                let cycle = match kind {
                    Kind::Force { asked, .. } => {
                        let (steps, _) = asked.steps(&[]);
                        let asked = model.steps.iter().filter(|(_, step)| steps.contains(&step.name.to_string()));
                        machine.force_in(&Nothing, &asked.map(|(id, _)| id).collect(), &inputs, *now)
                    }
                    _ => machine.cycle(&inputs, *now),
                };
                cycle.map(|cycle| {
                    let mut found = shown(&model, &machine, &cycle.active, &cycle.outputs);
                    found.stable = cycle.stable;
                    found.calls = cycle.calls.iter().map(|call| written(&model, call)).collect();
                    Some((found, expected))
                })
            }
        };
        match found.map_err(|error| format!("line {number}: {error}"))? {
            Some((found, expected)) if found != normal(expected) => {
                return Err(format!("line {number}\n  expected {}\n  found    {found}", normal(expected)));
            }
            _ => {}
        }
    }
    Ok(())
}

fn resolve(chart: &str) -> Result<Model, String> {
    let tokens = fragments::plain(chart).parse().map_err(|error| format!("tokens: {error}"))?;
    let mut sink = Sink::new();
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink));
    if let Some(model) = &model {
        check::drawing(model, &mut sink);
    }
    let messages: Vec<String> = sink.finish().iter().flat_map(|d| &d.notes).map(|(_, text)| text.clone()).collect();
    if !messages.is_empty() {
        return Err(messages.join("\n  "));
    }
    model.ok_or_else(|| "no chart".to_owned())
}

/// One value for each declared name; those not given are false or zero.
fn values<'m>(
    declared: impl Iterator<Item = (String, &'m Ty)>,
    given: &BTreeMap<String, i128>,
) -> Result<Vec<Value>, String> {
    let declared: Vec<(String, &Ty)> = declared.collect();
    if let Some(name) = given.keys().find(|name| declared.iter().all(|(known, _)| known != *name)) {
        return Err(format!("`{name}` is not declared"));
    }
    let value = |(name, ty): &(String, &Ty)| {
        let number = given.get(name).copied().unwrap_or(0);
        match ty {
            Ty::Bool(_) => Value::Bool(number != 0),
            Ty::Time(_) => Value::Ticks(u32::try_from(number).unwrap_or(u32::MAX)),
            _ => Value::Int(number),
        }
    };
    Ok(declared.iter().map(value).collect())
}

fn shown(model: &Model, machine: &Interpreter<'_>, situation: &Situation, outputs: &[Value]) -> Expected {
    let late = machine.late_steps();
    let late = late.into_iter().map(|step| (format!("late({})", model.steps[step].name), 1));
    let outputs = model.outputs.values().zip(outputs).map(|(output, value)| (output.name.to_string(), number(*value)));
    Expected {
        steps: situation.iter().map(|step| model.steps[*step].name.to_string()).collect(),
        stable: true,
        outputs: outputs.filter(|(_, value)| *value != 0).chain(late).collect(),
        calls: Vec::new(),
    }
}

/// Without what is zero.
fn normal(expected: &Expected) -> Expected {
    let mut expected = expected.clone();
    expected.outputs.retain(|_, value| *value != 0);
    expected
}

fn number(value: Value) -> i128 {
    match value {
        Value::Bool(value) => i128::from(value),
        Value::Int(value) => value,
        Value::Ticks(value) => i128::from(value),
        other => unreachable!("no chart of the corpus has a {other:?}"),
    }
}

fn written(model: &Model, call: &Call) -> String {
    let phase = match call.phase {
        Phase::First => "first",
        Phase::Repeated => "repeated",
        Phase::Final => "final",
    };
    let args: Vec<String> = call.args.iter().map(|arg| number(*arg).to_string()).collect();
    format!("{phase} {}({})", model.actions[call.action].name, args.join(","))
}
