//! A chart of the corpus for a controller: a module without `std` and heap that plays the timeline with the expectations
//! compiled in.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use grafcet_compiler::model::{Model, Ty};

use crate::reader::{self, Expected, Kind, Line};
use crate::{Values, chart, fragments};

/// The items of a module: `play` answers with the first line that shows something else.
///
/// # Errors
/// What is wrong with the file.
pub fn module(text: &str) -> Result<String, String> {
    let case = reader::read(text)?;
    let model = chart::resolve(&case.chart)?;
    let name = &model.name;
    let mut body = String::new();
    for line in &case.lines {
        body.push_str(&play(&model, line)?);
    }
    let params =
        if model.params.is_empty() { String::new() } else { format!("let mut params = {name}Params::default();") };
    Ok(format!(
        "use crate::check::*;\n{}\n{}\npub(crate) fn play() -> Result<(), u32> {{\n\
         let mut chart = {name}::new();\nlet mut outputs = {name}Outputs::default();\n{params}\n{body}Ok(())\n}}\n",
        fragments::call(&case.chart, crate::emit::MACRO),
        actions(&model),
    ))
}

/// The trait of the code actions for the memory of calls.
fn actions(model: &Model) -> String {
    if model.actions.is_empty() {
        return String::new();
    }
    let mut methods = String::new();
    for action in model.actions.values() {
        let params = action.params.iter().map(|(name, ty)| format!(", {name}: {}", crate::emit::rust(ty)));
        let args = action.params.iter().map(|(name, ty)| match ty {
            Ty::Time(_) => format!("i64::from({name}.get()), "),
            _ => format!("i64::from({name}), "),
        });
        let (params, args, name) = (params.collect::<String>(), args.collect::<String>(), &action.name);
        _ = writeln!(
            methods,
            "fn {name}(&mut self, phase: Phase{params}) {{ self.note(phase, \"{name}\", &[{args}]); }}"
        );
    }
    format!("impl {}Actions for Calls {{\n{methods}}}", model.name)
}

fn play(model: &Model, line: &Line) -> Result<String, String> {
    let (name, number) = (&model.name, line.number);
    Ok(match &line.kind {
        Kind::Init => format!("chart.init();\noutputs = {name}Outputs::default();\n"),
        Kind::Params(changed) => {
            let params = model.params.values().map(|param| (param.name.to_string(), &param.ty));
            let set = params.filter_map(|(param, ty)| Some((value(*changed.get(&param)?, ty), param)));
            let set: String = set.map(|(value, param)| format!("params.{param} = {value};\n")).collect();
            format!(
                "{set}chart.set_params(params){};\n",
                crate::emit::taken(model, &format!(".map_err(|_| {number})?"))
            )
        }
        Kind::Wakes(deadline) => {
            format!("if chart.next_deadline().map(|time| time.get()) != {deadline:?} {{ return Err({number}); }}\n")
        }
        Kind::Shows(expected) => format!("if !({}) {{ return Err({number}); }}\n", shows(model, expected)),
        Kind::Refuses(asked) => format!(
            "if Forceable::force(&mut chart, &[{}], &{name}Inputs::default(), Ticks::new(0), {}).is_ok() {{ return Err({number}); }}\n",
            steps(model, &asked.steps(&[]).0),
            if model.actions.is_empty() { "&mut ()" } else { "&mut Calls::default()" },
        ),
        Kind::Cycle { inputs, now, expected } => cycle(model, line, None, (inputs, *now, expected))?,
        Kind::Force { asked, inputs, now, expected } => {
            cycle(model, line, Some(&asked.steps(&[]).0), (inputs, *now, expected))?
        }
    })
}

/// A cycle, in which the chart may be forced into a situation.
fn cycle(
    model: &Model,
    line: &Line,
    forced: Option<&BTreeSet<String>>,
    (inputs, now, expected): (&Values, u32, &Expected),
) -> Result<String, String> {
    let (name, number) = (&model.name, line.number);
    let declared = model.inputs.values().map(|input| (input.name.to_string(), &input.ty));
    let inputs = fields(declared, inputs)?;
    let calls: String = expected.calls.iter().map(|call| format!("{call}; ")).collect();
    let (memory, check) = if model.actions.is_empty() {
        ("()".to_owned(), String::new())
    } else {
        ("Calls::default()".to_owned(), format!(" && calls.are(\"{calls}\")"))
    };
    let given = format!("&{name}Inputs {{ {inputs} }}, Ticks::new({now}), &mut calls");
    let run = match forced {
        None => format!("outputs = Chart::scan(&mut chart, {given});"),
        Some(names) => format!(
            "let Ok(forced) = Forceable::force(&mut chart, &[{}], {given}) else {{ return Err({number}) }};\noutputs = forced;",
            steps(model, names)
        ),
    };
    Ok(format!(
        "let mut calls = {memory};\n{run}\n\
         if !({} && chart.is_stable() == {}{check}) {{ return Err({number}); }}\n",
        shows(model, expected),
        expected.stable,
    ))
}

/// `MotorStep::On, MotorStep::Off, `
fn steps(model: &Model, names: &BTreeSet<String>) -> String {
    names.iter().map(|step| format!("{}Step::{step}, ", model.name)).collect()
}

fn shows(model: &Model, expected: &Expected) -> String {
    let steps = steps(model, &expected.steps);
    let declared = model.outputs.values().map(|output| (output.name.to_string(), &output.ty));
    let outputs = declared.map(|(name, ty)| {
        let value = value(expected.outputs.get(&name).copied().unwrap_or_default(), ty);
        format!(" && outputs.{name} == {value}")
    });
    format!("steps_are(&chart, &[{steps}]){}", outputs.collect::<String>())
}

/// Every declared name with its value.
fn fields<'m>(declared: impl Iterator<Item = (String, &'m Ty)>, given: &Values) -> Result<String, String> {
    let declared: Vec<_> = declared.collect();
    if let Some(name) = given.keys().find(|name| declared.iter().all(|(known, _)| known != *name)) {
        return Err(format!("`{name}` is not declared"));
    }
    let field =
        |(name, ty): &(String, &Ty)| format!("{name}: {}, ", value(given.get(name).copied().unwrap_or_default(), ty));
    Ok(declared.iter().map(field).collect())
}

/// A value as Rust.
fn value(number: i128, ty: &Ty) -> String {
    match ty {
        Ty::Bool(_) => (number != 0).to_string(),
        Ty::Time(_) => format!("Ticks::new({number})"),
        _ => number.to_string(),
    }
}
